/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FEATURES_H
#define DUCTUS_FEATURES_H

#include "base/memory.h"

#include <ductus/status.h>

/* Feature vectors of the samples of a stroke: the local shape around a sample and its closeness to the
 * stroke's ends, "HelpingHand" section 4.1, equation (1): F = (x-, x+, W f). */

typedef enum duct_feature_kind {
    DUCT_FEATURE_VELOCITIES /* filtered velocities, section 4.1.2: 7 history and 7 future taps; 32 dimensions
                             */
} duct_feature_kind;

typedef struct duct_feature_options {
    duct_feature_kind kind;
    double reach;  /* the size d_h of the history and future windows, in samples */
    double weight; /* W */
} duct_feature_options;

/* The length of a feature vector. */
size_t duct_feature_dimensions(const duct_feature_options *options);

/* The largest dimension count of any kind. */
enum { DUCT_FEATURE_MOST_DIMENSIONS = 64 };

/* Computes the features of a stroke's `count` samples (x, y in sampling units, about one unit apart) into
 * `rows`, row by row. Time: O(count * reach). Errors: DUCT_NO_MEMORY. */
duct_status duct_features_compute(const duct_allocator *allocator, const duct_feature_options *options,
                                  const double *x, const double *y, size_t count, float *rows,
                                  duct_error *error);

#endif
