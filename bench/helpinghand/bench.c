/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

void bench_check(duct_status status, const duct_error *error)
{
    if (status != DUCT_OK) {
        fprintf(stderr, "bench-helpinghand: %s\n", error->message);
        exit(1);
    }
}

void *bench_alloc(size_t count, size_t size)
{
    void *memory = calloc(count > 0 ? count : 1, size);
    if (memory == NULL) {
        fprintf(stderr, "bench-helpinghand: no memory for %zu times %zu bytes\n", count, size);
        exit(1);
    }
    return memory;
}

static double clock_of(clockid_t id)
{
    struct timespec time;
    clock_gettime(id, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

double bench_cpu(void)
{
    return clock_of(CLOCK_THREAD_CPUTIME_ID);
}

double bench_wall(void)
{
    return clock_of(CLOCK_MONOTONIC);
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double bench_quantile(double *values, size_t count, double share)
{
    qsort(values, count, sizeof *values, by_value);
    size_t at = (size_t)(share * (double)count);
    return values[at < count ? at : count - 1];
}

double bench_median(double *values, size_t count)
{
    return bench_quantile(values, count, 0.5);
}

duct_drawing *bench_recording(const char *path)
{
    const char *data = getenv("DUCTUS_DATA");
    char full[4096];
    duct_error error;
    duct_drawing *drawing;
    snprintf(full, sizeof full, "%s/%s", data != NULL ? data : "../shared/data", path);
    bench_check(duct_drawing_read(NULL, full, NULL, &drawing, &error), &error);
    return drawing;
}

/* The sampling unit at which a drawing's median stroke has 60 samples. */
static double unit_of(const duct_drawing *drawing)
{
    duct_error error;
    duct_library *library;
    bench_check(duct_library_build(NULL, &drawing, 1, NULL, &library, &error), &error);
    double unit = duct_library_unit(library);
    duct_library_free(library);
    return unit;
}

duct_library *bench_library(const char *const *paths, size_t count, size_t samples)
{
    duct_error error;
    duct_drawing *all;
    duct_library *library;
    duct_library_options options = {0};
    size_t held = 0;
    bench_check(duct_drawing_new(NULL, &all, &error), &error);
    for (size_t i = 0; i < count && held < samples; i++) {
        duct_drawing *one = bench_recording(paths[i]);
        options.unit = options.unit > 0 ? options.unit : unit_of(one);
        for (size_t s = 0; s < duct_drawing_stroke_count(one); s++) {
            duct_drawing *single;
            duct_library *measured;
            bench_check(duct_drawing_new(NULL, &single, &error), &error);
            bench_check(duct_drawing_add_copy(single, duct_drawing_stroke(one, s), NULL, &error), &error);
            const duct_drawing *list[] = {single};
            if (duct_library_build(NULL, list, 1, &options, &measured, &error) == DUCT_OK) {
                size_t more = duct_library_sample_count(measured);
                duct_library_free(measured);
                if (held + more <= samples) {
                    held += more;
                    bench_check(duct_drawing_add_copy(all, duct_drawing_stroke(one, s), NULL, &error),
                                &error);
                }
            }
            duct_drawing_free(single);
        }
        duct_drawing_free(one);
    }
    const duct_drawing *list[] = {all};
    bench_check(duct_library_build(NULL, list, 1, &options, &library, &error), &error);
    duct_drawing_free(all);
    return library;
}

duct_drawing *bench_cut(const duct_drawing *drawing, double unit, double length, size_t most)
{
    duct_error error;
    duct_drawing *cut;
    bench_check(duct_drawing_new(NULL, &cut, &error), &error);
    for (size_t s = 0; s < duct_drawing_stroke_count(drawing) && duct_drawing_stroke_count(cut) < most; s++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, s);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        const double *t = duct_stroke_values(stroke, DUCT_T);
        double made = 0;
        size_t end = 1;
        for (; end < duct_stroke_size(stroke) && made < length * unit; end++) {
            made += __builtin_hypot(x[end] - x[end - 1], y[end] - y[end - 1]);
        }
        if (made < length * unit || t == NULL) {
            continue;
        }
        duct_stroke *piece;
        char id[32];
        snprintf(id, sizeof id, "s%zu", s);
        bench_check(duct_drawing_add_stroke(cut, id, end, &piece, &error), &error);
        memcpy(duct_stroke_edit(piece, DUCT_X), x, end * sizeof *x);
        memcpy(duct_stroke_edit(piece, DUCT_Y), y, end * sizeof *y);
        memcpy(duct_stroke_edit(piece, DUCT_T), t, end * sizeof *t);
    }
    return cut;
}

duct_drawing *bench_restyle(const duct_library *hand, const duct_drawing *drawing, int threads,
                            const char *const *words, double *seconds)
{
    duct_error error;
    const duct_operation *operation;
    duct_settings *settings;
    duct_drawing *output;
    duct_context context = duct_context_default();
    context.threads = threads;
    bench_check(duct_operation_find("restyle", &operation, &error), &error);
    bench_check(duct_settings_new(NULL, operation, &settings, &error), &error);
    bench_check(duct_settings_library(settings, "hand", hand, &error), &error);
    for (size_t i = 0; words != NULL && words[i] != NULL; i += 2) {
        bench_check(duct_settings_set(settings, words[i], words[i + 1], &error), &error);
    }
    double begin = threads == 1 ? bench_cpu() : bench_wall();
    bench_check(duct_operation_run(&context, settings, drawing, NULL, &output, &error), &error);
    double time = (threads == 1 ? bench_cpu() : bench_wall()) - begin;
    if (seconds != NULL) {
        *seconds = time;
    }
    duct_settings_free(settings);
    return output;
}
