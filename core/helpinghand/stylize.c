/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One stroke from end to end: sampled to the library's unit, passes, and the result back in the stroke's own
 * samples. */
#include "helpinghand/helpinghand.h"

#include "base/error.h"
#include "geometry/resample.h"
#include "geometry/statistics.h"
#include "helpinghand/pass.h"
#include "helpinghand/result.h"

#include <math.h>
#include <string.h>

/* Samples by which a closed line's query runs over its join, at each end. */
static const size_t overlap = 24;

static void positions_of(const duct_samples *query, duct_result *result)
{
    for (size_t i = 0; i < query->count; i++) {
        result->x[i] = query->channels[DUCT_X][i] / result->unit;
        result->y[i] = query->channels[DUCT_Y][i] / result->unit;
    }
}

/* One pass over a closed line, which has neither beginning nor end: the query is wrapped around itself by up
 * to `overlap` samples at both ends, where the pen comes down and goes up out of sight, and what follows the
 * join is faded over from what came before it. x[count - 1] is x[0] again, and so it is with y. */
static duct_status closed_pass(const duct_helpinghand *hand, bool direction, const char *id, const double *x,
                               const double *y, size_t count, duct_gesture *gestures, duct_json *trace,
                               duct_error *error)
{
    const duct_allocator *allocator = &hand->allocator;
    size_t around = count - 1, wrap = around < overlap ? around : overlap, total = count + 2 * wrap;
    double *positions = duct_alloc_raw(allocator, 2 * total, sizeof *positions);
    duct_gesture *wrapped = duct_alloc_raw(allocator, total, sizeof *wrapped);
    duct_status status;
    if (positions == NULL || wrapped == NULL) {
        status = duct_fail_memory(error);
    } else {
        for (size_t i = 0; i < total; i++) {
            size_t from = (i + around - wrap) % around;
            positions[i] = x[from];
            positions[total + i] = y[from];
        }
        status =
            duct_pass_run(hand, direction, id, positions, positions + total, total, wrapped, trace, error);
    }
    if (status == DUCT_OK) {
        for (size_t i = 0; i < count; i++) {
            gestures[i] = wrapped[wrap + i];
        }
        for (size_t i = 0; i < wrap && i < around; i++) {
            double share = (double)(i + 1) / (double)(wrap + 1);
            gestures[i] = duct_gesture_between(&wrapped[wrap + around + i], &wrapped[wrap + i], share);
        }
        /* The last sample is the first one; its velocity still leads up to it. */
        duct_gesture last = gestures[0];
        last.vx = gestures[around].vx;
        last.vy = gestures[around].vy;
        gestures[around] = last;
    }
    duct_release(allocator, positions);
    duct_release(allocator, wrapped);
    return status;
}

static duct_status run_pass(const duct_helpinghand *hand, bool direction, const duct_stroke *stroke,
                            const double *x, const double *y, size_t count, duct_gesture *gestures,
                            duct_json *trace, duct_error *error)
{
    bool closed = duct_stroke_closed(stroke) && count > 3;
    return (closed ? closed_pass : duct_pass_run)(hand, direction, duct_stroke_id(stroke), x, y, count,
                                                  gestures, trace, error);
}

/* Replaces the positions by those that the gestures' velocities make. */
static duct_status shape(const duct_helpinghand *hand, const duct_samples *query, bool closed,
                         duct_gesture *gestures, duct_result *result, duct_error *error)
{
    size_t count = query->count;
    double *made = duct_alloc(&hand->allocator, 2 * count, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    /* The query's steps are not exactly a unit, so that a whole number of them fits its length. */
    double step = query->step / result->unit;
    for (size_t i = 0; i < count; i++) {
        gestures[i].vx *= step;
        gestures[i].vy *= step;
    }
    duct_status status = duct_shape_solve(&hand->allocator, &hand->options.shape, result->x, result->y,
                                          gestures, count, closed, made, made + count, error);
    if (status == DUCT_OK) {
        memcpy(result->x, made, count * sizeof *made);
        memcpy(result->y, made + count, count * sizeof *made);
    }
    duct_release(&hand->allocator, made);
    return status;
}

/* Pose for the new trajectory: it is sampled uniformly again, and the gestures are read off at its samples'
 * arc lengths. */
static duct_status second_pass(const duct_helpinghand *hand, const duct_stroke *stroke, size_t count,
                               duct_result *result, duct_json *trace, duct_error *error)
{
    const duct_allocator *allocator = &hand->allocator;
    double *at = duct_alloc(allocator, count, sizeof *at);
    if (at == NULL) {
        return duct_fail_memory(error);
    }
    double length = duct_arc_lengths(result->x, result->y, count, at);
    if (!(length > 0) || !(length < DUCT_MAX_SAMPLES)) {
        duct_release(allocator, at);
        return run_pass(hand, false, stroke, result->x, result->y, count, result->gestures, trace, error);
    }
    size_t steps = (size_t)floor(length + 0.5);
    size_t fresh = (steps < 1 ? 1 : steps) + 1;
    double *x = duct_alloc(allocator, 2 * fresh, sizeof *x), *y = x != NULL ? x + fresh : NULL;
    duct_gesture *gestures = duct_alloc(allocator, fresh, sizeof *gestures);
    duct_status status = DUCT_OK;
    if (x == NULL || gestures == NULL) {
        status = duct_fail_memory(error);
    } else {
        size_t hint_x = 0, hint_y = 0;
        for (size_t i = 0; i < fresh; i++) {
            double where = length * (double)i / (double)(fresh - 1);
            x[i] = duct_interpolate(at, result->x, count, where, &hint_x);
            y[i] = duct_interpolate(at, result->y, count, where, &hint_y);
        }
        status = run_pass(hand, false, stroke, x, y, fresh, gestures, trace, error);
    }
    for (size_t i = 0; status == DUCT_OK && i < count; i++) {
        double place = at[i] / length * (double)(fresh - 1);
        size_t k = (size_t)place;
        k = k + 1 < fresh ? k : fresh - 2;
        result->gestures[i] = duct_gesture_between(&gestures[k], &gestures[k + 1], place - (double)k);
    }
    duct_release(allocator, at);
    duct_release(allocator, x);
    duct_release(allocator, gestures);
    return status;
}

static duct_status run_passes(const duct_helpinghand *hand, const duct_stroke *stroke,
                              const duct_samples *query, duct_result *result, duct_json *trace,
                              duct_error *error)
{
    duct_stylization mode = hand->options.mode;
    size_t count = query->count;
    positions_of(query, result);
    bool direction = mode == DUCT_STYLIZE_TRAJECTORY || mode == DUCT_STYLIZE_TWO_PASS;
    duct_status status =
        run_pass(hand, direction, stroke, result->x, result->y, count, result->gestures, trace, error);
    if (status == DUCT_OK && mode != DUCT_STYLIZE_POSE) {
        status = shape(hand, query, duct_stroke_closed(stroke), result->gestures, result, error);
    }
    if (status == DUCT_OK && mode == DUCT_STYLIZE_TWO_PASS) {
        status = second_pass(hand, stroke, count, result, trace, error);
    }
    return status;
}

/* The most samples that a stroke is compared at: each costs a kilobyte or two and some 50 microseconds. Where
 * the scale is the program's choice, longer strokes get a coarser one. */
#define MOST_REFINED 32768.0
#define MOST_SAMPLES 1048576.0

/* How sharply a sampled line turns from sample to sample, radians: on average, and what a tenth of them
 * exceed. */
typedef struct {
    double mean, high;
} turning;

static duct_status measure_turning(const duct_allocator *allocator, const duct_samples *samples,
                                   turning *measured, duct_error *error)
{
    measured->mean = measured->high = 0;
    if (samples->count < 3) {
        return DUCT_OK;
    }
    const double *x = samples->channels[DUCT_X], *y = samples->channels[DUCT_Y];
    size_t inner = samples->count - 2;
    double *angles = duct_alloc(allocator, inner, sizeof *angles), sum = 0;
    if (angles == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < inner; i++) {
        double ux = x[i + 1] - x[i], uy = y[i + 1] - y[i], vx = x[i + 2] - x[i + 1], vy = y[i + 2] - y[i + 1];
        angles[i] = fabs(atan2(ux * vy - uy * vx, ux * vx + uy * vy));
        sum += angles[i];
    }
    measured->mean = sum / (double)inner;
    measured->high = duct_quantile(angles, inner, 0.9);
    duct_release(allocator, angles);
    return DUCT_OK;
}

/* Samples a query at the hand's unit. A vector path may be long and intricate, or tiny, and yet be one
 * stroke: with the drawing's one unit it would lose its shape. So the unit of a vector stroke shrinks until
 * its line turns gently from sample to sample; unless that makes it turn more, which is noise and not shape.
 */
static duct_status sample_query(const duct_helpinghand *hand, const duct_stroke *stroke, duct_samples *query,
                                double *unit, duct_error *error)
{
    const double gentle = 12 * M_PI / 180, sharp = 35 * M_PI / 180, shrink = 0.7;
    const int most = 8;
    double length = duct_stroke_length(stroke);
    if (hand->refine && length / *unit > MOST_REFINED && isfinite(length)) {
        *unit = length / MOST_REFINED;
    } else if (length / *unit > MOST_SAMPLES) {
        return duct_fail(error, DUCT_LIMIT,
                         "stroke '%.60s' is too long for its scale: %.3g samples; give a larger scale",
                         duct_stroke_id(stroke), length / *unit);
    }
    duct_status status = duct_samples_make(&hand->allocator, stroke, *unit, query, error);
    bool recorded = duct_stroke_values(stroke, DUCT_T) != NULL;
    if (status != DUCT_OK || recorded || !hand->refine || query->count == 0) {
        return status;
    }
    turning now;
    status = measure_turning(&hand->allocator, query, &now, error);
    for (int i = 0; status == DUCT_OK && i < most && (double)query->count < MOST_REFINED / 2 &&
                    (query->count < 8 || now.mean > gentle || now.high > sharp);
         i++) {
        duct_samples finer;
        turning then;
        status = duct_samples_make(&hand->allocator, stroke, *unit * shrink, &finer, error);
        if (status != DUCT_OK) {
            break;
        }
        status = measure_turning(&hand->allocator, &finer, &then, error);
        if (status != DUCT_OK || (query->count >= 8 && then.mean >= now.mean)) {
            duct_samples_free(&hand->allocator, &finer);
            break;
        }
        duct_samples_free(&hand->allocator, query);
        *query = finer;
        now = then;
        *unit *= shrink;
    }
    return status;
}

static duct_status stylize_line(const duct_helpinghand *hand, duct_stroke *stroke, const duct_samples *query,
                                double unit, duct_json *trace, duct_error *error)
{
    duct_result result = {.count = query->count,
                          .unit = unit,
                          .step = query->step,
                          .at = query->at,
                          .closed = duct_stroke_closed(stroke)};
    result.x = duct_alloc(&hand->allocator, 2 * query->count, sizeof *result.x);
    result.gestures = duct_alloc(&hand->allocator, query->count, sizeof *result.gestures);
    duct_status status;
    if (result.x == NULL || result.gestures == NULL) {
        status = duct_fail_memory(error);
    } else {
        result.y = result.x + query->count;
        status = run_passes(hand, stroke, query, &result, trace, error);
    }
    if (status == DUCT_OK) {
        status = duct_result_apply(hand, &result, stroke, error);
    }
    duct_release(&hand->allocator, result.x);
    duct_release(&hand->allocator, result.gestures);
    return status;
}

duct_status duct_helpinghand_stylize(const duct_helpinghand *hand, duct_stroke *stroke, duct_text *trace,
                                     duct_error *error)
{
    duct_json json;
    if (trace != NULL) {
        duct_json_init(&json, trace);
        duct_json_object(&json, NULL);
        duct_json_string(&json, "id", duct_stroke_id(stroke));
        duct_json_array(&json, "passes");
    }
    duct_status status = DUCT_OK;
    if (hand->options.amount > 0 && duct_stroke_size(stroke) > 0 && duct_result_wanted(hand, stroke)) {
        duct_samples query = {.count = 0};
        double unit = hand->unit;
        status = sample_query(hand, stroke, &query, &unit, error);
        if (status == DUCT_OK && query.count == 0) {
            status = duct_result_apply_dot(hand, stroke, error);
        } else if (status == DUCT_OK) {
            status = stylize_line(hand, stroke, &query, unit, trace != NULL ? &json : NULL, error);
        }
        if (status != DUCT_OK) {
            duct_samples_free(&hand->allocator, &query);
            return status;
        }
        duct_samples_free(&hand->allocator, &query);
    }
    if (trace != NULL) {
        duct_json_close(&json, ']');
        duct_json_close(&json, '}');
    }
    return status;
}
