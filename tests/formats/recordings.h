/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_RECORDINGS_H
#define DUCTUS_TESTS_RECORDINGS_H

/* What the tests of formats that are only read have in common. Contents may hold any bytes. */

#include "drawings.h"

static inline void assert_finite(const duct_drawing *drawing)
{
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            const double *values = duct_stroke_values(stroke, (duct_channel)c);
            for (size_t k = 0; values != NULL && k < duct_stroke_size(stroke); k++) {
                assert_true(isfinite(values[k]));
            }
        }
    }
}

/* Reads whatever it is: it becomes a drawing of finite values, or a sentence. True where it is a drawing. */
static inline bool read_anything(const char *data, size_t size, const char *format)
{
    duct_error error = {DUCT_OK, ""};
    duct_drawing *drawing = NULL;
    duct_status status = duct_drawing_read_memory(NULL, data, size, "test", format, NULL, &drawing, &error);
    assert_int_equal(status == DUCT_OK, drawing != NULL);
    assert_true(status == DUCT_OK || strlen(error.message) > 6);
    if (drawing != NULL) {
        assert_finite(drawing);
    }
    duct_drawing_free(drawing);
    return status == DUCT_OK;
}

/* Every beginning of the data; returns how many were refused. Each lies in memory of exactly its size. */
static inline size_t read_all_beginnings(const char *data, size_t size, const char *format)
{
    size_t refused = 0;
    for (size_t length = 0; length < size; length++) {
        char *part = malloc(length > 0 ? length : 1);
        assert_non_null(part);
        memcpy(part, data, length);
        refused += !read_anything(part, length, format);
        free(part);
    }
    return refused;
}

/* The data with bytes changed at random. */
static inline void read_all_mutations(const char *data, size_t size, const char *format, size_t rounds)
{
    char *copy = malloc(size);
    assert_non_null(copy);
    for (size_t round = 0; round < rounds; round++) {
        memcpy(copy, data, size);
        for (uint64_t k = 0; k < 1 + round % 8; k++) {
            copy[duct_random_bits(7, round, k, 0) % size] = (char)duct_random_bits(7, round, k, 1);
        }
        read_anything(copy, size, format);
    }
    free(copy);
}

/* The n-th allocation fails, for all n: reading ends in DUCT_NO_MEMORY and holds nothing. */
static inline void fail_read_allocations(const char *data, size_t size, const char *format)
{
    bool done = false;
    for (long n = 1; !done; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_error error = {DUCT_OK, ""};
        duct_drawing *drawing = NULL;
        duct_status status =
            duct_drawing_read_memory(&context, data, size, "test", format, NULL, &drawing, &error);
        done = failing.calls < n;
        assert_int_equal(status, done ? DUCT_OK : DUCT_NO_MEMORY);
        assert_int_equal(drawing != NULL, done);
        duct_drawing_free(drawing);
        assert_int_equal(failing.held, 0);
        assert_true(n < 100000);
    }
}

/* Reads a file of ../shared/data, or gives NULL where that folder is absent. The caller frees it. */
static inline duct_drawing *read_shared(const char *name)
{
    const char *folder = shared_data();
    if (folder == NULL) {
        return NULL;
    }
    char path[5000];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_read(NULL, path, NULL, &drawing, &error));
    assert_finite(drawing);
    return drawing;
}

static inline size_t sample_count(const duct_drawing *drawing)
{
    size_t count = 0;
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        count += duct_stroke_size(duct_drawing_stroke(drawing, i));
    }
    return count;
}

static inline double mean_of(const duct_drawing *drawing, duct_channel channel)
{
    double sum = 0;
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        for (size_t k = 0; k < duct_stroke_size(duct_drawing_stroke(drawing, i)); k++) {
            sum += value_of(drawing, i, channel, k);
        }
    }
    return sum / (double)sample_count(drawing);
}

#endif
