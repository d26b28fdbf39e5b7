/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/pyramid.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

enum { FARTHEST = 8 };

double duct_pyramid_spacing(double finest, size_t level)
{
    return finest * pow(1.2, (double)level);
}

/* The value `offset` control points from i, with the curve continued beyond its ends. `odd`: by point
 * reflection, for positions; else mirrored. */
static double beyond(const duct_curve *curve, const double *values, size_t i, long offset, bool odd)
{
    long count = (long)curve->count, at = (long)i + offset;
    if (curve->closed) {
        return values[((at % count) + count) % count];
    }
    if (at >= 0 && at < count) {
        return values[at];
    }
    long end = at < 0 ? 0 : count - 1, mirrored = 2 * end - at;
    mirrored = mirrored < 0 ? 0 : mirrored >= count ? count - 1 : mirrored;
    return odd ? 2 * values[end] - values[mirrored] : values[mirrored];
}

duct_status duct_curve_blur(const duct_allocator *allocator, const duct_curve *curve, double deviation,
                            duct_curve *blurred, duct_error *error)
{
    double weights[FARTHEST + 1], sum = 0;
    long reach = (long)ceil(4 * deviation);
    reach = reach > FARTHEST ? FARTHEST : reach;
    for (long k = 0; k <= reach; k++) {
        weights[k] = k == 0 ? 1 : exp(-0.5 * (double)(k * k) / (deviation * deviation));
        sum += k == 0 ? weights[k] : 2 * weights[k];
    }
    duct_status status =
        duct_curve_init(allocator, curve->count, curve->closed, curve->extra != NULL, blurred, error);
    if (status != DUCT_OK) {
        return status;
    }
    memcpy(blurred->t, curve->t, curve->count * sizeof *curve->t);
    for (size_t i = 0; i < curve->count; i++) {
        double x = weights[0] * curve->x[i], y = weights[0] * curve->y[i];
        double extra = curve->extra != NULL ? weights[0] * curve->extra[i] : 0;
        for (long k = 1; k <= reach; k++) {
            x += weights[k] * (beyond(curve, curve->x, i, -k, true) + beyond(curve, curve->x, i, k, true));
            y += weights[k] * (beyond(curve, curve->y, i, -k, true) + beyond(curve, curve->y, i, k, true));
            if (curve->extra != NULL) {
                extra += weights[k] * (beyond(curve, curve->extra, i, -k, false) +
                                       beyond(curve, curve->extra, i, k, false));
            }
        }
        blurred->x[i] = x / sum;
        blurred->y[i] = y / sum;
        if (curve->extra != NULL) {
            blurred->extra[i] = extra / sum;
        }
    }
    return DUCT_OK;
}

duct_status duct_pyramid_make(const duct_allocator *allocator, const duct_curve *curve, double finest,
                              size_t levels, duct_pyramid *pyramid, duct_error *error)
{
    /* Blurring by this much at every level adds up to a deviation of one spacing of the level. */
    const double deviation = sqrt(1.2 * 1.2 - 1);
    duct_pyramid made = {0, duct_alloc(allocator, levels, sizeof *made.levels)};
    if (made.levels == NULL) {
        return duct_fail_memory(error);
    }
    duct_status status = duct_curve_resample(allocator, curve, finest, 2, &made.levels[0], error);
    made.count = status == DUCT_OK ? 1 : 0;
    while (status == DUCT_OK && made.count < levels) {
        duct_curve blurred;
        status = duct_curve_blur(allocator, &made.levels[made.count - 1], deviation, &blurred, error);
        if (status == DUCT_OK) {
            status = duct_curve_resample(allocator, &blurred, duct_pyramid_spacing(finest, made.count), 2,
                                         &made.levels[made.count], error);
            duct_curve_done(allocator, &blurred);
        }
        made.count += status == DUCT_OK;
    }
    if (status != DUCT_OK) {
        duct_pyramid_done(allocator, &made);
        return status;
    }
    *pyramid = made;
    return DUCT_OK;
}

void duct_pyramid_done(const duct_allocator *allocator, duct_pyramid *pyramid)
{
    for (size_t i = 0; i < pyramid->count; i++) {
        duct_curve_done(allocator, &pyramid->levels[i]);
    }
    duct_release(allocator, pyramid->levels);
    *pyramid = (duct_pyramid){0, NULL};
}
