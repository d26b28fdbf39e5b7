/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FEATURES_VELOCITIES_H
#define DUCTUS_FEATURES_VELOCITIES_H

#include "base/memory.h"

#include <ductus/status.h>

#include <stddef.h>

/* Filtered velocities, "HelpingHand" section 4.1.2: M = N = 7 triangle filters before and after a sample and
 * one at it, whose centres grow geometrically and whose feet are their neighbours' centres, so that the
 * weights that any velocity within reach gets from all filters together sum to one. A tap is the mean, by
 * those weights, of the velocities inside the stroke; 0 where none is inside. Taking the mean and not the sum
 * is what makes the samples far away count less each, as the paper says they do, and keeps a tap's length at
 * 1 or less. */
enum { DUCT_VELOCITY_TAPS = 7, DUCT_VELOCITY_DIMENSIONS = 2 * (2 * DUCT_VELOCITY_TAPS + 1) };

typedef struct duct_velocity_filter {
    long centres[DUCT_VELOCITY_TAPS +
                 2]; /* of the taps 0, 1, ... 7 in samples, and the outer foot of the last one */
} duct_velocity_filter;

/* The filters whose seventh centre lies `reach` >= 7 samples away. */
void duct_velocity_filter_init(duct_velocity_filter *filter, double reach);

/* The taps of sample `i`, times `weight`, as x and y of tap -7, -6, ... 7. */
void duct_velocity_taps(const duct_velocity_filter *filter, const double *x, const double *y, size_t count,
                        size_t i, double weight, float taps[DUCT_VELOCITY_DIMENSIONS]);

/* The same of all `count` samples, to the same bits and much faster: sample i's begin at taps + i *
 * dimensions. Errors: DUCT_NO_MEMORY. */
duct_status duct_velocity_taps_of_all(const duct_allocator *allocator, const duct_velocity_filter *filter,
                                      const double *x, const double *y, size_t count, double weight,
                                      float *taps, size_t dimensions, duct_error *error);

#endif
