/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/helpinghand.h"

#include "base/error.h"
#include "geometry/resample.h"
#include "geometry/statistics.h"
#include "library/library_private.h"

#include <math.h>

duct_status duct_helpinghand_auto_unit(const duct_allocator *allocator, const duct_library *library,
                                       const duct_drawing *drawing, double *unit, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing), used = 0;
    double *lengths = duct_alloc(allocator, count, sizeof *lengths);
    if (lengths == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        double length = duct_stroke_length(stroke);
        if (length > 0 && isfinite(length)) {
            lengths[used++] = length;
        }
    }
    double median = duct_median(lengths, used);
    duct_release(allocator, lengths);
    double made = median / library->median_size;
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
