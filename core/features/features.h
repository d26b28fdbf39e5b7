/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FEATURES_H
#define DUCTUS_FEATURES_H

#include "base/memory.h"
#include "features/velocities.h"

#include <ductus/status.h>

/* Feature vectors of the samples of a stroke: the local shape around a sample and its closeness to the
 * stroke's ends, "HelpingHand" section 4.1, equation (1): F = (x-, x+, W f). */

typedef enum duct_feature_kind {
    DUCT_FEATURE_VELOCITIES, /* filtered velocities, section 4.1.2: 7 history and 7 future taps; 32 dimensions
                              */
    DUCT_FEATURE_CONTEXTS    /* shape contexts, section 4.1.1: two histograms of 30 bins; 62 dimensions */
} duct_feature_kind;

typedef struct duct_feature_options {
    duct_feature_kind kind;
    double reach;  /* the size d_h of the history and future windows, in samples; at least 7 */
    double weight; /* W */
} duct_feature_options;

/* The length of a feature vector. */
size_t duct_feature_dimensions(const duct_feature_options *options);

/* How many values at the beginning of a feature vector follow from the sample and what came before it alone,
 * if the end of the stroke is taken to be far away (x+ = 1): the history's half. */
size_t duct_feature_past_dimensions(const duct_feature_options *options);

/* The largest dimension count of any kind. */
enum { DUCT_FEATURE_MOST_DIMENSIONS = 64 };

/* Options made ready for one sample after the other. */
typedef struct duct_feature_maker {
    duct_feature_options options;
    duct_velocity_filter filter; /* of filtered velocities */
} duct_feature_maker;

void duct_feature_maker_init(duct_feature_maker *maker, const duct_feature_options *options);

/* How many samples before (and after) a sample its features look at. */
size_t duct_feature_span(const duct_feature_maker *maker);

/* The features of sample `i` of `count` (x, y in sampling units, about one unit apart), `before` and `after`
 * units of arc length away from the stroke's ends. Time: O(reach). */
void duct_feature_row(const duct_feature_maker *maker, const double *x, const double *y, size_t count,
                      size_t i, double before, double after, float *row);

/* Computes the features of a stroke's `count` samples into `rows`, row by row. Time: O(count * reach).
 * Errors: DUCT_NO_MEMORY. */
duct_status duct_features_compute(const duct_allocator *allocator, const duct_feature_options *options,
                                  const double *x, const double *y, size_t count, float *rows,
                                  duct_error *error);

#endif
