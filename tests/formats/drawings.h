/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_DRAWINGS_H
#define DUCTUS_TESTS_DRAWINGS_H

/* Drawings for the tests of formats: random ones, comparison, and short ways to read and write. */

#include "testing.h"

#include <ductus/ductus.h>

#include <math.h>

/* A drawing of random strokes on a page of 2000 x 2000: every set of channels, sizes from 0 up, unless
 * `plain`, which is what all formats can hold: no empty strokes, all channels. */
static inline duct_drawing *random_drawing(uint64_t seed, size_t strokes, bool plain)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    duct_drawing_set_page(drawing, 2000, 2000);
    for (size_t i = 0; i < strokes; i++) {
        char id[40];
        snprintf(id, sizeof id, "%zu", i);
        size_t size = duct_random_bits(seed, i, 0, 0) % 12 + (plain ? 1 : 0);
        duct_stroke *stroke;
        assert_ok(duct_drawing_add_stroke(drawing, id, size, &stroke, &error));
        unsigned set = plain ? ~0u : (unsigned)(duct_random_bits(seed, i, 0, 1) | 3);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            if (!(set & 1u << c)) {
                continue;
            }
            double *values = duct_stroke_edit(stroke, (duct_channel)c);
            for (size_t k = 0; k < size; k++) {
                double u = duct_random_uniform(seed, i, k, 10 + (uint64_t)c);
                double before = k > 0 ? values[k - 1] : 0;
                values[k] = c <= DUCT_Y          ? 2000 * u
                            : c == DUCT_T        ? before + u / 100
                            : c == DUCT_PRESSURE ? u
                            : c == DUCT_TWIST    ? before + 6 * (u - 0.5)
                                                 : 2 * (u - 0.5);
            }
        }
    }
    return drawing;
}

static inline void assert_near(double a, double b, double tolerance)
{
    if (!(fabs(a - b) <= tolerance)) {
        fail_msg("%.17g is not %.17g within %g", a, b, tolerance);
    }
}

static inline void assert_same_values(const duct_stroke *a, const duct_stroke *b, double tolerance)
{
    assert_int_equal(duct_stroke_size(a), duct_stroke_size(b));
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        const double *left = duct_stroke_values(a, (duct_channel)c),
                     *right = duct_stroke_values(b, (duct_channel)c);
        if (duct_stroke_size(a) == 0) {
            continue; /* a channel without values leaves no trace in a file */
        }
        if ((left == NULL) != (right == NULL)) {
            fail_msg("%s is present in one only", duct_channel_name((duct_channel)c));
        }
        for (size_t k = 0; left != NULL && k < duct_stroke_size(a); k++) {
            assert_near(left[k], right[k], tolerance);
        }
    }
}

static inline duct_drawing *read_text_as(const char *text, size_t size, const char *format)
{
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_read_memory(NULL, text, size, "test", format, NULL, &drawing, &error));
    return drawing;
}

static inline duct_drawing *read_text(const char *text)
{
    return read_text_as(text, strlen(text), NULL);
}

/* Checks that reading fails with that status and a sentence that holds `part`, and makes no drawing. */
static inline void assert_refused(const char *text, const char *format, duct_status expected,
                                  const char *part)
{
    duct_error error = {DUCT_OK, ""};
    duct_drawing *drawing = NULL;
    duct_status status =
        duct_drawing_read_memory(NULL, text, strlen(text), "test", format, NULL, &drawing, &error);
    if (status != expected || strstr(error.message, part) == NULL) {
        fail_msg("status %d, \"%s\" instead of %d, \"...%s...\"", (int)status, error.message, (int)expected,
                 part);
    }
    assert_null(drawing);
    assert_int_equal(strncmp(error.message, "test: ", 6), 0);
}

static inline duct_drawing *write_and_read(const duct_drawing *drawing, const char *format)
{
    duct_error error;
    char *data;
    size_t size;
    assert_ok(duct_drawing_write_memory(NULL, drawing, format, NULL, &data, &size, &error));
    assert_int_equal(strlen(data), size);
    duct_drawing *back = read_text_as(data, size, NULL);
    duct_memory_free(NULL, data);
    return back;
}

static inline double value_of(const duct_drawing *drawing, size_t stroke, duct_channel channel, size_t sample)
{
    const duct_stroke *s = duct_drawing_stroke(drawing, stroke);
    assert_non_null(s);
    assert_true(sample < duct_stroke_size(s));
    const double *values = duct_stroke_values(s, channel);
    assert_non_null(values);
    return values[sample];
}

/* Reads every beginning of a text: each is read or refused with a sentence; nothing crashes or leaks. Returns
 * how many were refused. */
static inline size_t read_truncated(const char *text, const char *format)
{
    size_t refused = 0;
    for (size_t size = 0; size < strlen(text); size++) {
        duct_error error = {DUCT_OK, ""};
        duct_drawing *drawing = NULL;
        duct_status status =
            duct_drawing_read_memory(NULL, text, size, "test", format, NULL, &drawing, &error);
        assert_int_equal(status == DUCT_OK, drawing != NULL);
        assert_true(status == DUCT_OK || strlen(error.message) > 6);
        refused += status != DUCT_OK;
        duct_drawing_free(drawing);
    }
    return refused;
}

/* Reads a text with bytes changed at random: whatever comes of it, the values are finite. */
static inline void read_mutated(const char *text, const char *format, size_t rounds)
{
    size_t size = strlen(text);
    char *copy = malloc(size);
    assert_non_null(copy);
    for (size_t round = 0; round < rounds; round++) {
        memcpy(copy, text, size);
        for (uint64_t k = 0; k < 1 + round % 8; k++) {
            copy[duct_random_bits(7, round, k, 0) % size] = (char)duct_random_bits(7, round, k, 1);
        }
        duct_drawing *drawing = NULL;
        if (duct_drawing_read_memory(NULL, copy, size, "test", format, NULL, &drawing, NULL) != DUCT_OK) {
            continue;
        }
        for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
            const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
            for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
                const double *values = duct_stroke_values(stroke, (duct_channel)c);
                for (size_t k = 0; values != NULL && k < duct_stroke_size(stroke); k++) {
                    assert_true(isfinite(values[k]));
                }
            }
        }
        duct_drawing_free(drawing);
    }
    free(copy);
}

/* The n-th allocation fails, for all n: reading and writing end in DUCT_NO_MEMORY and hold nothing. */
static inline void fail_allocations(const char *text, const char *format)
{
    bool done = false;
    for (long n = 1; !done; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_error error = {DUCT_OK, ""};
        duct_drawing *drawing = NULL;
        char *data = NULL;
        size_t size = 0;
        duct_status status =
            duct_drawing_read_memory(&context, text, strlen(text), "test", format, NULL, &drawing, &error);
        if (status == DUCT_OK) {
            status = duct_drawing_write_memory(&context, drawing, format, NULL, &data, &size, &error);
            assert_int_equal(status == DUCT_OK, data != NULL);
        } else {
            assert_null(drawing);
        }
        done = failing.calls < n;
        assert_int_equal(status, done ? DUCT_OK : DUCT_NO_MEMORY);
        duct_memory_free(&context, data);
        duct_drawing_free(drawing);
        assert_int_equal(failing.held, 0);
        assert_true(n < 100000);
    }
}

#endif
