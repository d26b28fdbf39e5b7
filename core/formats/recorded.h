/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_RECORDED_H
#define DUCTUS_FORMATS_RECORDED_H

/* Samples on their way from a recording, which is one sequence of samples in time order, to the strokes of a
 * drawing. */

#include "base/memory.h"

#include <ductus/drawing.h>

typedef struct duct_recorded_sample {
    size_t stroke; /* the stroke it belongs to, from 0 in the order in which strokes begin */
    double values[DUCT_CHANNEL_COUNT]; /* NAN where the recording does not say */
} duct_recorded_sample;

typedef struct duct_recorded {
    const duct_allocator *allocator;
    duct_recorded_sample *items;
    size_t count, capacity, stroke_count;
} duct_recorded;

void duct_recorded_init(duct_recorded *samples, const duct_allocator *allocator);
void duct_recorded_free(duct_recorded *samples);

/* Appends a sample without any value to stroke `stroke`, at most `stroke_count`, which then begins.
 * Errors: DUCT_NO_MEMORY, DUCT_LIMIT. */
duct_status duct_recorded_add(duct_recorded *samples, size_t stroke, duct_recorded_sample **sample,
                              duct_error *error);

/* Takes a channel out where it is 0 (within rounding) in all samples, that is where no device recorded it;
 * the two tilts go together. */
void duct_recorded_drop_silent(duct_recorded *samples);

/* Makes time count from the first sample, in units of `unit` seconds. */
void duct_recorded_start_time(duct_recorded *samples, double unit);

/* Appends the strokes to the drawing: gaps are filled, values brought into range, channels without any value
 * absent. Errors: DUCT_NO_MEMORY, DUCT_LIMIT, DUCT_BAD_FORMAT (a value or position is not finite). */
duct_status duct_recorded_make_strokes(const duct_recorded *samples, duct_drawing *drawing,
                                       duct_error *error);

/* The numbers of a line, separated by spaces or tabs: how many there are. -1 where there are more than `most`
 * or anything is no finite number. */
int duct_line_numbers(const char *line, size_t size, double *values, int most);

#endif
