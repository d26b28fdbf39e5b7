/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BENCH_HELPINGHAND_H
#define DUCTUS_BENCH_HELPINGHAND_H

#include <ductus/ductus.h>

#include <stddef.h>
#include <stdint.h>

/* What the parts of bench-helpinghand share. A benchmark ends the process on any error. */
void bench_check(duct_status status, const duct_error *error);
void *bench_alloc(size_t count, size_t size);

/* Seconds of processor time of the calling thread: what other programs do to the machine hardly shows. */
double bench_cpu(void);
double bench_wall(void);

/* Sorts the values. */
double bench_median(double *values, size_t count);
double bench_quantile(double *values, size_t count, double share);

/* A recording of $DUCTUS_DATA (else ../shared/data) by its path there. */
duct_drawing *bench_recording(const char *path);

/* A library of recordings' first strokes, `samples` samples in all (the last stroke that does not fit is left
 * out), at the unit at which the first recording's median stroke has 60. */
duct_library *bench_library(const char *const *paths, size_t count, size_t samples);

/* A drawing that has the strokes of another which are long enough to be cut to `length` sampling units, cut
 * so, at most `most` of them: positions and time only. */
duct_drawing *bench_cut(const duct_drawing *drawing, double unit, double length, size_t most);

/* Runs `restyle` with settings as NAME, VALUE, ..., NULL. */
duct_drawing *bench_restyle(const duct_library *hand, const duct_drawing *drawing, int threads,
                            const char *const *settings, double *seconds);

/* The parts. Each prints a table and writes OUT/NAME.csv. */
void bench_search_speed(const char *out);
void bench_stroke_speed(const char *out);
void bench_live(const char *out);

#endif
