/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/result.h"

#include "base/error.h"
#include "drawing/drawing_private.h"
#include "geometry/resample.h"

#include <ductus/drawing.h>

#include <math.h>

duct_gesture duct_gesture_between(const duct_gesture *a, const duct_gesture *b, double share)
{
    double rest = 1 - share;
    return (duct_gesture){rest * a->pressure + share * b->pressure,
                          rest * a->tilt_x + share * b->tilt_x,
                          rest * a->tilt_y + share * b->tilt_y,
                          rest * a->twist_cos + share * b->twist_cos,
                          rest * a->twist_sin + share * b->twist_sin,
                          rest * a->vx + share * b->vx,
                          rest * a->vy + share * b->vy};
}

/* An output sample: between input samples `from` and its next, `share` of the way; at `place` among the
 * query's uniform samples. */
typedef struct {
    size_t from;
    double share;
    double place;
} emission;

/* How many pieces the span behind input sample i is cut into. */
static size_t pieces_of(double gap, double finest)
{
    double pieces = floor(gap / finest + 0.5);
    return pieces < 1 ? 1 : (size_t)pieces;
}

/* Lists the output samples. */
static duct_status list_emissions(const duct_helpinghand *hand, const duct_result *result,
                                  const duct_stroke *stroke, emission **list, size_t *count,
                                  duct_error *error)
{
    size_t size = duct_stroke_size(stroke);
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    bool moves = hand->options.mode != DUCT_STYLIZE_POSE;
    bool recorded = duct_stroke_values(stroke, DUCT_T) != NULL;
    double finest = moves ? result->unit / 2 : recorded ? INFINITY : result->unit;
    size_t spans = duct_stroke_closed(stroke) && size > 2 ? size : size - 1, total = size;
    for (size_t i = 0; i < spans; i++) {
        size_t next = (i + 1) % size;
        total += pieces_of(hypot(x[next] - x[i], y[next] - y[i]), finest) - 1;
    }
    if (total > DUCT_MAX_SAMPLES) {
        return duct_fail(error, DUCT_LIMIT, "stroke '%.60s' is too long for its scale",
                         duct_stroke_id(stroke));
    }
    emission *made = duct_alloc(&hand->allocator, total, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    double last = (double)(result->count - 1);
    size_t k = 0;
    for (size_t i = 0; i < size; i++) {
        size_t next = (i + 1) % size;
        size_t pieces = i < spans ? pieces_of(hypot(x[next] - x[i], y[next] - y[i]), finest) : 1;
        double begin = result->at[i] / result->step,
               end = i + 1 < size ? result->at[next] / result->step : last;
        for (size_t p = 0; p < pieces; p++) {
            double share = (double)p / (double)pieces;
            made[k++] = (emission){i, share, fmin(begin + share * (end - begin), last)};
        }
    }
    *list = made;
    *count = total;
    return DUCT_OK;
}

/* The input's value at an output sample. Time and pose hold their last value over a closing span. */
static double input_value(const duct_stroke *stroke, duct_channel channel, const emission *sample)
{
    const double *values = duct_stroke_values(stroke, channel);
    size_t next = sample->from + 1;
    if (next >= duct_stroke_size(stroke)) {
        next = channel == DUCT_X || channel == DUCT_Y ? 0 : sample->from;
    }
    return sample->share > 0 ? values[sample->from] + sample->share * (values[next] - values[sample->from])
                             : values[sample->from];
}

/* The result's position at a place between uniform samples: Catmull-Rom, so that coarse units show no
 * corners. */
static double position(const duct_result *result, const double *values, double place)
{
    size_t i = (size_t)place, count = result->count;
    if (i + 1 >= count) {
        return values[count - 1];
    }
    bool around = result->closed && count > 3;
    double u = place - (double)i, u2 = u * u, u3 = u2 * u;
    double b = values[i], c = values[i + 1];
    double a = i > 0 ? values[i - 1] : around ? values[count - 2] : 2 * b - c;
    double d = i + 2 < count ? values[i + 2] : around ? values[1] : 2 * c - b;
    return 0.5 * (2 * b + (c - a) * u + (2 * a - 5 * b + 4 * c - d) * u2 + (3 * b - a - 3 * c + d) * u3);
}

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

static double pose_value(const duct_gesture *gesture, duct_channel channel)
{
    switch (channel) {
    case DUCT_PRESSURE:
        return gesture->pressure;
    case DUCT_TILT_X:
        return gesture->tilt_x;
    case DUCT_TILT_Y:
        return gesture->tilt_y;
    default:
        return atan2(gesture->twist_sin, gesture->twist_cos);
    }
}

/* Mixes an old and a new pose value; a stroke without the channel comes from the library's mean. */
static double mix_pose(const duct_helpinghand *hand, duct_channel channel, bool had, double old, double made)
{
    double from = had ? old : hand->library->mean[channel], amount = hand->options.amount;
    if (channel == DUCT_TWIST) {
        return from + amount * remainder(made - from, 2 * M_PI);
    }
    double mixed = from + amount * (made - from);
    return channel == DUCT_PRESSURE ? clamp(mixed, 0, 1) : clamp(mixed, -M_PI / 2, M_PI / 2);
}

/* True where the channel of this stroke is to be synthesized. */
static bool gives_pose(const duct_helpinghand *hand, const duct_stroke *stroke, duct_channel channel)
{
    return channel >= DUCT_PRESSURE && hand->options.mode != DUCT_STYLIZE_TRAJECTORY &&
           hand->library->channels[channel] != NULL &&
           !(hand->options.keep && duct_stroke_values(stroke, channel) != NULL);
}

bool duct_result_wanted(const duct_helpinghand *hand, const duct_stroke *stroke)
{
    bool wanted = hand->options.mode != DUCT_STYLIZE_POSE;
    for (int c = DUCT_PRESSURE; c < DUCT_CHANNEL_COUNT; c++) {
        wanted = wanted || gives_pose(hand, stroke, (duct_channel)c);
    }
    return wanted;
}

static double output_value(const duct_helpinghand *hand, const duct_result *result, const duct_stroke *stroke,
                           duct_channel channel, const emission *sample)
{
    bool had = duct_stroke_values(stroke, channel) != NULL;
    double old = had ? input_value(stroke, channel, sample) : 0;
    if (channel == DUCT_X || channel == DUCT_Y) {
        if (hand->options.mode == DUCT_STYLIZE_POSE) {
            return old;
        }
        const double *values = channel == DUCT_X ? result->x : result->y;
        double made = position(result, values, sample->place) * result->unit;
        return hand->options.amount < 1 ? old + hand->options.amount * (made - old) : made;
    }
    if (!gives_pose(hand, stroke, channel)) {
        return old;
    }
    size_t i = (size_t)sample->place;
    i = i + 1 < result->count ? i : result->count - 2;
    duct_gesture gesture =
        duct_gesture_between(&result->gestures[i], &result->gestures[i + 1], sample->place - (double)i);
    return mix_pose(hand, channel, had, old, pose_value(&gesture, channel));
}

static void unwrap(double *twist, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        twist[i] = twist[i - 1] + remainder(twist[i] - twist[i - 1], 2 * M_PI);
    }
}

duct_status duct_result_apply(const duct_helpinghand *hand, const duct_result *result, duct_stroke *stroke,
                              duct_error *error)
{
    const duct_allocator *allocator = &hand->allocator;
    emission *list = NULL;
    size_t count = 0;
    duct_status status = list_emissions(hand, result, stroke, &list, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    double *made[DUCT_CHANNEL_COUNT] = {NULL};
    for (int c = 0; status == DUCT_OK && c < DUCT_CHANNEL_COUNT; c++) {
        duct_channel channel = (duct_channel)c;
        bool had = duct_stroke_values(stroke, channel) != NULL;
        if (!had && !gives_pose(hand, stroke, channel)) {
            continue;
        }
        made[c] = duct_alloc(allocator, count, sizeof(double));
        if (made[c] == NULL) {
            status = duct_fail_memory(error);
            break;
        }
        for (size_t k = 0; k < count; k++) {
            made[c][k] = output_value(hand, result, stroke, channel, &list[k]);
        }
        if (channel == DUCT_TWIST) {
            unwrap(made[c], count);
        }
    }
    if (status == DUCT_OK) {
        status = duct_stroke_replace(stroke, count, made, error);
    }
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(allocator, made[c]);
    }
    duct_release(allocator, list);
    return status;
}

duct_status duct_result_apply_dot(const duct_helpinghand *hand, duct_stroke *stroke, duct_error *error)
{
    const duct_allocator *allocator = &hand->allocator;
    size_t count = duct_stroke_size(stroke);
    double *made[DUCT_CHANNEL_COUNT] = {NULL};
    duct_status status = DUCT_OK;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_channel channel = (duct_channel)c;
        const double *old = duct_stroke_values(stroke, channel);
        bool pose = gives_pose(hand, stroke, channel);
        if (old == NULL && !pose) {
            continue;
        }
        made[c] = duct_alloc(allocator, count, sizeof(double));
        if (made[c] == NULL) {
            status = duct_fail_memory(error);
            break;
        }
        for (size_t k = 0; k < count; k++) {
            double value = old != NULL ? old[k] : 0;
            made[c][k] = pose ? mix_pose(hand, channel, old != NULL, value, hand->library->mean[c]) : value;
        }
    }
    if (status == DUCT_OK) {
        status = duct_stroke_replace(stroke, count, made, error);
    }
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(allocator, made[c]);
    }
    return status;
}
