/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/helpinghand.h"

#include "base/error.h"
#include "geometry/resample.h"
#include "geometry/statistics.h"
#include "library/library_private.h"

#include <math.h>

/* The total turning of a sampled line, radians. */
static double turning_of(const double *x, const double *y, size_t count)
{
    double sum = 0;
    for (size_t i = 2; i < count; i++) {
        double ux = x[i - 1] - x[i - 2], uy = y[i - 1] - y[i - 2], vx = x[i] - x[i - 1], vy = y[i] - y[i - 1];
        sum += fabs(atan2(ux * vy - uy * vx, ux * vx + uy * vy));
    }
    return sum;
}

/* Arc length for each radian of turning: how large the curves are, whether letters are joined or not. */
static double library_curves(const duct_library *library)
{
    double length = 0, turning = 0;
    for (size_t s = 0; s < library->stroke_count; s++) {
        size_t start = library->starts[s], count = library->starts[s + 1] - start;
        length += (double)(count - 1);
        turning += turning_of(library->channels[DUCT_X] + start, library->channels[DUCT_Y] + start, count);
    }
    return turning > 0 ? length / turning : INFINITY;
}

/* The same for a drawing, in drawing pixels, as it shows when sampled with a unit. */
static duct_status drawing_curves(const duct_allocator *allocator, const duct_drawing *drawing, double unit,
                                  double *curves, duct_error *error)
{
    double length = 0, turning = 0;
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        duct_samples samples;
        /* What is longer than this cannot be matched at this scale anyway. */
        if (!(duct_stroke_length(stroke) < 1e5 * unit)) {
            continue;
        }
        duct_status status = duct_samples_make(allocator, stroke, unit, &samples, error);
        if (status != DUCT_OK) {
            return status;
        }
        if (samples.count > 0) {
            length += samples.step * (double)(samples.count - 1);
            turning += turning_of(samples.channels[DUCT_X], samples.channels[DUCT_Y], samples.count);
        }
        duct_samples_free(allocator, &samples);
    }
    *curves = turning > 0 ? length / turning : INFINITY;
    return DUCT_OK;
}

duct_status duct_helpinghand_auto_unit(const duct_allocator *allocator, const duct_library *library,
                                       const duct_drawing *drawing, double *unit, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing), used = 0;
    double *lengths = duct_alloc(allocator, count, sizeof *lengths);
    if (lengths == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        double length = duct_stroke_length(duct_drawing_stroke(drawing, i));
        if (length > 0 && isfinite(length)) {
            lengths[used++] = length;
        }
    }
    double made = duct_median(lengths, used) / library->median_size;
    duct_release(allocator, lengths);
    if (!(made > 0)) {
        *unit = library->unit;
        return DUCT_OK;
    }
    /* Finer sampling shows more turns, so the two are brought together step by step. */
    const int most = 6;
    double target = library_curves(library);
    for (int i = 0; i < most; i++) {
        double curves;
        duct_status status = drawing_curves(allocator, drawing, made, &curves, error);
        if (status != DUCT_OK) {
            return status;
        }
        double wanted = curves / target;
        /* Hands differ in how much they turn, and noise turns too: only a clear difference says that strokes
         * are not what they are in the library. */
        if (!(wanted < (i == 0 ? 0.5 : 0.95) * made)) {
            break;
        }
        made = wanted > 0.25 * made ? wanted : 0.25 * made;
    }
    *unit = made;
    return DUCT_OK;
}

static double scaled(const duct_library *library, duct_channel channel, size_t sample)
{
    double deviation = library->deviation[channel];
    return library->channels[channel] != NULL && deviation > 0
               ? library->channels[channel][sample] / deviation
               : 0;
}

static void fill_vectors(duct_helpinghand *hand)
{
    const duct_library *library = hand->library;
    const double *x = library->channels[DUCT_X], *y = library->channels[DUCT_Y];
    for (size_t s = 0; s < library->stroke_count; s++) {
        for (size_t i = library->starts[s]; i < library->starts[s + 1]; i++) {
            duct_jump_vector *pose = &hand->poses[i], *direction = &hand->directions[i];
            pose->linear[0] = scaled(library, DUCT_PRESSURE, i);
            pose->linear[1] = scaled(library, DUCT_TILT_X, i);
            pose->linear[2] = scaled(library, DUCT_TILT_Y, i);
            pose->twist = library->channels[DUCT_TWIST] != NULL
                              ? remainder(library->channels[DUCT_TWIST][i], 2 * M_PI)
                              : 0;
            size_t to = i > library->starts[s] ? i : i + 1;
            double vx = x[to] - x[to - 1], vy = y[to] - y[to - 1], speed = hypot(vx, vy);
            direction->linear[0] = speed > 0 ? vx / speed : 0;
            direction->linear[1] = speed > 0 ? vy / speed : 0;
        }
    }
}

duct_status duct_helpinghand_init(const duct_allocator *allocator, const duct_library *library,
                                  const duct_helpinghand_options *options, double unit, bool refine,
                                  duct_helpinghand *hand, duct_error *error)
{
    bool any = library->channels[DUCT_PRESSURE] != NULL || library->channels[DUCT_TILT_X] != NULL ||
               library->channels[DUCT_TILT_Y] != NULL || library->channels[DUCT_TWIST] != NULL;
    if (!any && options->mode != DUCT_STYLIZE_TRAJECTORY) {
        return duct_fail(
            error, DUCT_UNSUPPORTED,
            "the hand '%s' has no pressure channel, nor tilt or twist, so it cannot give pose; use mode "
            "trajectory or another hand",
            library->name);
    }
    duct_helpinghand made = {
        .allocator = *allocator, .library = library, .options = *options, .unit = unit, .refine = refine};
    duct_status status =
        duct_library_features(library, &options->features, options->search, &made.index, error);
    if (status != DUCT_OK) {
        return status;
    }
    made.poses = duct_alloc(allocator, library->sample_count, sizeof *made.poses);
    made.directions = duct_alloc(allocator, library->sample_count, sizeof *made.directions);
    if (made.poses == NULL || made.directions == NULL) {
        duct_helpinghand_done(&made);
        return duct_fail_memory(error);
    }
    fill_vectors(&made);
    *hand = made;
    return DUCT_OK;
}

void duct_helpinghand_done(duct_helpinghand *hand)
{
    duct_release(&hand->allocator, hand->poses);
    duct_release(&hand->allocator, hand->directions);
    hand->poses = NULL;
    hand->directions = NULL;
}
