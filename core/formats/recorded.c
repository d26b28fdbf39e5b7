/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/recorded.h"

#include "base/error.h"
#include "base/number.h"
#include "formats/recording.h"

#include <math.h>

/* Below this a tilt is the rounding of an upright pen's angles. */
#define SILENCE 1e-9

void duct_recorded_init(duct_recorded *samples, const duct_allocator *allocator)
{
    *samples = (duct_recorded){.allocator = allocator};
}

void duct_recorded_free(duct_recorded *samples)
{
    duct_release(samples->allocator, samples->items);
}

duct_status duct_recorded_add(duct_recorded *samples, size_t stroke, duct_recorded_sample **sample,
                              duct_error *error)
{
    if (samples->count >= DUCT_MAX_SAMPLES || stroke >= DUCT_MAX_STROKES) {
        return duct_fail(error, DUCT_LIMIT, "there are more than %d samples or %d strokes", DUCT_MAX_SAMPLES,
                         DUCT_MAX_STROKES);
    }
    void *items = samples->items;
    if (!duct_reserve(samples->allocator, &items, &samples->capacity, samples->count + 1,
                      sizeof *samples->items)) {
        return duct_fail_memory(error);
    }
    samples->items = items;
    duct_recorded_sample *added = &samples->items[samples->count++];
    added->stroke = stroke;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        added->values[c] = NAN;
    }
    samples->stroke_count = stroke >= samples->stroke_count ? stroke + 1 : samples->stroke_count;
    *sample = added;
    return DUCT_OK;
}

static bool is_silent(const duct_recorded *samples, duct_channel channel)
{
    for (size_t i = 0; i < samples->count; i++) {
        if (fabs(samples->items[i].values[channel]) > SILENCE) {
            return false;
        }
    }
    return true;
}

static void forget(duct_recorded *samples, duct_channel channel)
{
    for (size_t i = 0; i < samples->count; i++) {
        samples->items[i].values[channel] = NAN;
    }
}

void duct_recorded_drop_silent(duct_recorded *samples)
{
    if (is_silent(samples, DUCT_PRESSURE)) {
        forget(samples, DUCT_PRESSURE);
    }
    if (is_silent(samples, DUCT_TWIST)) {
        forget(samples, DUCT_TWIST);
    }
    if (is_silent(samples, DUCT_TILT_X) && is_silent(samples, DUCT_TILT_Y)) {
        forget(samples, DUCT_TILT_X);
        forget(samples, DUCT_TILT_Y);
    }
}

void duct_recorded_start_time(duct_recorded *samples, double unit)
{
    double start = NAN;
    for (size_t i = 0; i < samples->count; i++) {
        double *time = &samples->items[i].values[DUCT_T];
        start = isnan(start) ? *time : start;
        *time = (*time - start) * unit;
    }
}

static duct_status add_strokes(duct_drawing *drawing, const size_t *sizes, size_t count,
                               const bool used[DUCT_CHANNEL_COUNT], duct_error *error)
{
    for (size_t i = 0; i < count; i++) {
        duct_stroke *stroke;
        duct_status status = duct_recording_add_stroke(drawing, sizes[i], &stroke, error);
        if (status != DUCT_OK) {
            return status;
        }
        for (int c = DUCT_T; c < DUCT_CHANNEL_COUNT; c++) {
            if (used[c] && duct_stroke_edit(stroke, (duct_channel)c) == NULL) {
                return duct_fail_memory(error);
            }
        }
    }
    return DUCT_OK;
}

/* Puts the samples into the strokes; `filled` counts how many each has. */
static duct_status fill_strokes(const duct_recorded *samples, duct_drawing *drawing, size_t first,
                                size_t *filled, const bool used[DUCT_CHANNEL_COUNT], duct_error *error)
{
    for (size_t i = 0; i < samples->count; i++) {
        const duct_recorded_sample *sample = &samples->items[i];
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, first + sample->stroke);
        size_t k = filled[sample->stroke]++;
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            double value = sample->values[c];
            if (isinf(value) || (c <= DUCT_Y && isnan(value))) {
                return duct_fail(error, DUCT_BAD_FORMAT, "%s of sample %zu of stroke %zu is out of range",
                                 duct_channel_name((duct_channel)c), k, sample->stroke);
            }
            if (used[c]) {
                duct_stroke_edit(stroke, (duct_channel)c)[k] = value;
            }
        }
    }
    return DUCT_OK;
}

static void finish_stroke(duct_stroke *stroke)
{
    for (int c = DUCT_T; c < DUCT_CHANNEL_COUNT; c++) {
        duct_channel channel = (duct_channel)c;
        if (duct_stroke_values(stroke, channel) != NULL &&
            !duct_recording_fill_gaps(duct_stroke_edit(stroke, channel), duct_stroke_size(stroke))) {
            duct_stroke_drop(stroke, channel);
        }
    }
    duct_recording_tidy(stroke);
}

duct_status duct_recorded_make_strokes(const duct_recorded *samples, duct_drawing *drawing, duct_error *error)
{
    bool used[DUCT_CHANNEL_COUNT] = {true, true};
    size_t count = samples->stroke_count, first = duct_drawing_stroke_count(drawing);
    size_t *sizes = duct_alloc(samples->allocator, count, sizeof *sizes);
    if (sizes == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < samples->count; i++) {
        sizes[samples->items[i].stroke]++;
        for (int c = DUCT_T; c < DUCT_CHANNEL_COUNT; c++) {
            used[c] = used[c] || !isnan(samples->items[i].values[c]);
        }
    }
    duct_status status = add_strokes(drawing, sizes, count, used, error);
    for (size_t i = 0; i < count; i++) {
        sizes[i] = 0;
    }
    if (status == DUCT_OK) {
        status = fill_strokes(samples, drawing, first, sizes, used, error);
    }
    for (size_t i = 0; status == DUCT_OK && i < count; i++) {
        finish_stroke(duct_drawing_edit_stroke(drawing, first + i));
    }
    duct_release(samples->allocator, sizes);
    return status;
}

int duct_line_numbers(const char *line, size_t size, double *values, int most)
{
    const char *at = line, *end = line + size;
    int count = 0;
    while (at < end) {
        if (count == most || !duct_number_scan(at, &at, &values[count]) || !isfinite(values[count]) ||
            at > end || (at < end && *at != ' ' && *at != '\t')) {
            return -1;
        }
        count++;
        while (at < end && (*at == ' ' || *at == '\t')) {
            at++;
        }
    }
    return count;
}
