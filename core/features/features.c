/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "features/features.h"

#include "base/error.h"
#include "features/contexts.h"
#include "features/velocities.h"
#include "geometry/resample.h"

#include <math.h>

enum { ENDS = 2 }; /* x- and x+ */

size_t duct_feature_dimensions(const duct_feature_options *options)
{
    return ENDS +
           (options->kind == DUCT_FEATURE_CONTEXTS ? DUCT_CONTEXT_DIMENSIONS : DUCT_VELOCITY_DIMENSIONS);
}

size_t duct_feature_past_dimensions(const duct_feature_options *options)
{
    /* The velocity at the sample itself belongs to what came before. */
    return ENDS + (options->kind == DUCT_FEATURE_CONTEXTS ? DUCT_CONTEXT_BINS : 2 * (DUCT_VELOCITY_TAPS + 1));
}

/* x- or x+ of section 4.1: 0 at the stroke's end, 1 from the window's size on. */
static float closeness(double distance, double window)
{
    double share = distance / window;
    return share < 1 ? (float)sqrt(share > 0 ? share : 0) : 1.0f;
}

void duct_feature_maker_init(duct_feature_maker *maker, const duct_feature_options *options)
{
    maker->options = *options;
    duct_velocity_filter_init(&maker->filter, options->reach);
}

size_t duct_feature_span(const duct_feature_maker *maker)
{
    /* The last tap reaches to its outer foot, and a velocity to the sample before. */
    return maker->options.kind == DUCT_FEATURE_CONTEXTS
               ? (size_t)maker->options.reach
               : (size_t)maker->filter.centres[DUCT_VELOCITY_TAPS + 1];
}

void duct_feature_row(const duct_feature_maker *maker, const double *x, const double *y, size_t count,
                      size_t i, double before, double after, float *row)
{
    const duct_feature_options *options = &maker->options;
    row[0] = closeness(before, options->reach);
    row[1] = closeness(after, options->reach);
    if (options->kind == DUCT_FEATURE_CONTEXTS) {
        duct_context_histograms(x, y, count, i, options->reach, options->weight, row + ENDS);
    } else {
        duct_velocity_taps(&maker->filter, x, y, count, i, options->weight, row + ENDS);
    }
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
    duct_feature_maker maker;
    duct_feature_maker_init(&maker, options);
    duct_status status = DUCT_OK;
    if (options->kind == DUCT_FEATURE_CONTEXTS) {
        for (size_t i = 0; i < count; i++) {
            duct_feature_row(&maker, x, y, count, i, at[i], length - at[i], rows + i * dimensions);
        }
    } else {
        for (size_t i = 0; i < count; i++) {
            rows[i * dimensions] = closeness(at[i], options->reach);
            rows[i * dimensions + 1] = closeness(length - at[i], options->reach);
        }
        status = duct_velocity_taps_of_all(allocator, &maker.filter, x, y, count, options->weight,
                                           rows + ENDS, dimensions, error);
    }
    duct_release(allocator, at);
    return status;
}
