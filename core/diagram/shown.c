/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "diagram/shown.h"

#include "base/error.h"
#include "geometry/statistics.h"

#include <math.h>
#include <string.h>

/* Samples of one drawing, about; a picture cannot show more. */
enum { MOST_SAMPLES = 1 << 21 };

static const double DEGREES = 180 / M_PI;

/* Distance over time between the samples around each one, which smooths the steps of a clock. False where no
 * time passes. */
static bool speeds_of(const duct_samples *samples, double *values)
{
    const double *t = samples->channels[DUCT_T];
    size_t reach = 2, last = samples->count - 1, known = 0;
    double before = 0;
    for (size_t i = 0; i <= last; i++) {
        size_t from = i > reach ? i - reach : 0, to = i + reach < last ? i + reach : last;
        double time = t[to] - t[from];
        if (time > 0) {
            before = samples->step * (double)(to - from) / time;
            for (size_t j = known == 0 ? 0 : i; j < i; j++) {
                values[j] = before;
            }
            known++;
        }
        values[i] = before;
    }
    return known > 0;
}

/* Fills in the values; false where the stroke lacks the channel. */
static bool fill_values(const duct_samples *samples, duct_diagram_by by, double *values)
{
    static const duct_channel channels[] = {
        [DUCT_BY_PRESSURE] = DUCT_PRESSURE, [DUCT_BY_TILT] = DUCT_TILT_X, [DUCT_BY_TILT_X] = DUCT_TILT_X,
        [DUCT_BY_TILT_Y] = DUCT_TILT_Y,     [DUCT_BY_TWIST] = DUCT_TWIST, [DUCT_BY_SPEED] = DUCT_T,
    };
    if (by == DUCT_BY_NOTHING || by == DUCT_BY_SEGMENTS || samples->count == 0) {
        return false;
    }
    const double *channel = samples->channels[channels[by]], *other = samples->channels[DUCT_TILT_Y];
    if (channel == NULL || (by == DUCT_BY_TILT && other == NULL)) {
        return false;
    }
    if (by == DUCT_BY_SPEED) {
        return speeds_of(samples, values);
    }
    for (size_t i = 0; i < samples->count; i++) {
        /* The barrel's direction is (tan tilt_x, tan tilt_y, 1). */
        values[i] = by == DUCT_BY_PRESSURE ? channel[i]
                    : by == DUCT_BY_TILT   ? DEGREES * atan(hypot(tan(channel[i]), tan(other[i])))
                                           : DEGREES * channel[i];
    }
    return true;
}

/* A stroke without length is its first sample. */
static duct_status make_dot(const duct_allocator *allocator, const duct_stroke *stroke, duct_samples *samples,
                            duct_error *error)
{
    memset(samples, 0, sizeof *samples);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        const double *from = duct_stroke_values(stroke, (duct_channel)c);
        if (from == NULL) {
            continue;
        }
        samples->channels[c] = duct_alloc(allocator, 1, sizeof(double));
        if (samples->channels[c] == NULL) {
            duct_samples_free(allocator, samples);
            memset(samples, 0, sizeof *samples);
            return duct_fail_memory(error);
        }
        samples->channels[c][0] = from[0];
    }
    samples->count = 1;
    return DUCT_OK;
}

static duct_status make_stroke(const duct_allocator *allocator, const duct_stroke *stroke, duct_diagram_by by,
                               double step, duct_shown_stroke *shown, duct_error *error)
{
    shown->stroke = stroke;
    if (duct_stroke_size(stroke) == 0) {
        return DUCT_OK;
    }
    duct_status status = duct_samples_make(allocator, stroke, step, &shown->samples, error);
    if (status == DUCT_OK && shown->samples.count == 0) {
        duct_samples_free(allocator, &shown->samples);
        status = make_dot(allocator, stroke, &shown->samples, error);
    }
    if (status != DUCT_OK) {
        memset(&shown->samples, 0, sizeof shown->samples);
        return status;
    }
    shown->values = duct_alloc(allocator, shown->samples.count, sizeof *shown->values);
    if (shown->values == NULL) {
        return duct_fail_memory(error);
    }
    if (!fill_values(&shown->samples, by, shown->values)) {
        duct_release(allocator, shown->values);
        shown->values = NULL;
    }
    return DUCT_OK;
}

duct_status duct_shown_make(const duct_allocator *allocator, const duct_drawing *drawing, duct_diagram_by by,
                            double step, duct_shown *shown, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing);
    double length = 0;
    duct_shown made = {duct_alloc(allocator, count, sizeof *made.strokes), count, {0, 0, 0, 0}};
    if (made.strokes == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        length += duct_stroke_length(duct_drawing_stroke(drawing, i));
    }
    duct_status status = DUCT_OK;
    if (!isfinite(length)) {
        status = duct_fail(error, DUCT_LIMIT, "the drawing's strokes are too long to be shown");
    }
    step = fmax(step, length / MOST_SAMPLES);
    for (size_t i = 0; i < count && status == DUCT_OK; i++) {
        status = make_stroke(allocator, duct_drawing_stroke(drawing, i), by, step, &made.strokes[i], error);
    }
    if (status != DUCT_OK) {
        duct_shown_free(allocator, &made);
        return status;
    }
    duct_drawing_bounds(drawing, made.box);
    *shown = made;
    return DUCT_OK;
}

void duct_shown_free(const duct_allocator *allocator, duct_shown *shown)
{
    for (size_t i = 0; shown->strokes != NULL && i < shown->count; i++) {
        duct_samples_free(allocator, &shown->strokes[i].samples);
        duct_release(allocator, shown->strokes[i].values);
    }
    duct_release(allocator, shown->strokes);
    *shown = (duct_shown){NULL, 0, {0, 0, 0, 0}};
}

/* Calls `visit` for each value there is. */
static void visit_values(duct_shown *shown, size_t count, void (*visit)(void *user, double *value),
                         void *user)
{
    for (size_t d = 0; d < count; d++) {
        for (size_t s = 0; s < shown[d].count; s++) {
            duct_shown_stroke *stroke = &shown[d].strokes[s];
            for (size_t i = 0; stroke->values != NULL && i < stroke->samples.count; i++) {
                visit(user, &stroke->values[i]);
            }
        }
    }
}

typedef struct {
    double sine, cosine, mean;
    size_t count;
    double *copies;
} gathering;

static void gather_angle(void *user, double *value)
{
    gathering *all = user;
    all->sine += sin(*value / DEGREES);
    all->cosine += cos(*value / DEGREES);
}

static void turn_angle(void *user, double *value)
{
    const gathering *all = user;
    *value = all->mean + remainder(*value - all->mean, 360);
}

static void count_value(void *user, double *value)
{
    (void)value;
    ((gathering *)user)->count++;
}

static void copy_value(void *user, double *value)
{
    gathering *all = user;
    all->copies[all->count++] = *value;
}

bool duct_shown_range(const duct_allocator *allocator, duct_shown *shown, size_t count, duct_diagram_by by,
                      double *low, double *high, duct_status *status, duct_error *error)
{
    gathering all = {0, 0, 0, 0, NULL};
    *status = DUCT_OK;
    visit_values(shown, count, count_value, &all);
    if (all.count == 0) {
        return false;
    }
    if (by == DUCT_BY_TWIST) {
        visit_values(shown, count, gather_angle, &all);
        all.mean = DEGREES * atan2(all.sine, all.cosine);
        visit_values(shown, count, turn_angle, &all);
    }
    all.copies = duct_alloc(allocator, all.count, sizeof *all.copies);
    if (all.copies == NULL) {
        *status = duct_fail_memory(error);
        return false;
    }
    all.count = 0;
    visit_values(shown, count, copy_value, &all);
    *low = duct_quantile(all.copies, all.count, 0.01);
    *high = duct_quantile(all.copies, all.count, 0.99);
    duct_release(allocator, all.copies);
    return true;
}
