/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "features/features.h"

#include "base/error.h"
#include "features/velocities.h"
#include "geometry/resample.h"

#include <math.h>

size_t duct_feature_dimensions(const duct_feature_options *options)
{
    (void)options;
    return 2 + DUCT_VELOCITY_DIMENSIONS;
}

/* x- or x+ of section 4.1: 0 at the stroke's end, 1 from the window's size on. */
static float closeness(double distance, double window)
{
    double share = distance / window;
    return share < 1 ? (float)sqrt(share > 0 ? share : 0) : 1.0f;
}

duct_status duct_features_compute(const duct_allocator *allocator, const duct_feature_options *options,
                                  const double *x, const double *y, size_t count, float *rows,
                                  duct_error *error)
{
    if (count == 0) {
        return DUCT_OK;
    }
    double *at = duct_alloc(allocator, count, sizeof *at);
    if (at == NULL) {
        return duct_fail_memory(error);
    }
    size_t dimensions = duct_feature_dimensions(options);
    double length = duct_arc_lengths(x, y, count, at);
    duct_velocity_filter filter;
    duct_velocity_filter_init(&filter, options->reach);
    for (size_t i = 0; i < count; i++) {
        float *row = rows + i * dimensions;
        row[0] = closeness(at[i], options->reach);
        row[1] = closeness(length - at[i], options->reach);
        duct_velocity_taps(&filter, x, y, count, i, options->weight, row + 2);
    }
    duct_release(allocator, at);
    return DUCT_OK;
}
