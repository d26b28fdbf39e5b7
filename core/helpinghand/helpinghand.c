/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/helpinghand.h"

#include "base/error.h"
#include "geometry/resample.h"
#include "library/annotations.h"
#include "library/library_private.h"

#include <math.h>

/* A stroke's total turning, radians, over polyline corners. */
static double total_turning(const duct_stroke *stroke)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    double turning = 0, px = 0, py = 0;
    for (size_t i = 1; i < duct_stroke_size(stroke); i++) {
        double dx = x[i] - x[i - 1], dy = y[i] - y[i - 1];
        if (dx == 0 && dy == 0) {
            continue;
        }
        if (px != 0 || py != 0) {
            turning += fabs(atan2(px * dy - py * dx, px * dx + py * dy));
        }
        px = dx;
        py = dy;
    }
    return turning;
}

/* A vector path may be very long and yet be one stroke: sampled by the median alone it would lose its shape.
 * So no unit is coarser than a turn of a right angle, on average, in this many samples. */
static const double turn_samples = 6;

duct_status duct_helpinghand_auto_unit(const duct_allocator *allocator, const duct_library *library,
                                       const duct_drawing *drawing, double *unit, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing), used = 0;
    double *lengths = duct_alloc(allocator, count, sizeof *lengths);
    if (lengths == NULL) {
        return duct_fail_memory(error);
    }
    double length_sum = 0, turning_sum = 0;
    for (size_t i = 0; i < count; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        double length = duct_stroke_length(stroke);
        if (length > 0 && isfinite(length)) {
            lengths[used++] = length;
            length_sum += length;
            turning_sum += total_turning(stroke);
        }
    }
    double median = duct_median(lengths, used);
    duct_release(allocator, lengths);
    double made = median / library->median_size;
    double finest = turning_sum > 0 ? length_sum / turning_sum * (M_PI / 2) / turn_samples : made;
    made = finest < made ? finest : made;
    *unit = made > 0 ? made : library->unit;
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
                                  const duct_helpinghand_options *options, double unit,
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
    duct_helpinghand made = {.allocator = *allocator, .library = library, .options = *options, .unit = unit};
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
