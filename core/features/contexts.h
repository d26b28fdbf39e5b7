/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FEATURES_CONTEXTS_H
#define DUCTUS_FEATURES_CONTEXTS_H

#include <stddef.h>

/* Shape contexts, "HelpingHand" section 4.1.1: two log-polar histograms of where the samples up to `reach`
 * before and after a sample lie, seen from it. What the paper leaves open is decided so:
 *
 * - Rings: each is twice as wide as the one inside it, and the outermost ends at `reach`, the farthest a
 * sample of the window can lie. On a straight line that is Belongie's own choice, 1/8 to 2 of the mean
 * distance. Distances are not divided by their mean: query and library are sampled at one unit, and size
 * counts.
 * - Sectors: 60 degrees each, the first centred on the direction to the right. Directions are those of the
 *   page, not of the stroke: turned shapes are other shapes ("gravity", section 3.3).
 * - A sample is shared out linearly among the two sectors and the two rings (by the logarithm of the
 * distance) whose centres it lies between, so that a histogram changes steadily along a stroke. What lies
 * within one unit has little direction, and what coincides with the sample has none: it is shared among all
 * sectors of the innermost ring.
 * - A histogram is divided by how many samples of its window are inside the stroke, so that short strokes
 * count as much as long ones; where none is, it is 0. Filtered velocities do the same.
 * - The histograms are taken times DUCT_CONTEXT_SCALE, which brings the distances of the nearest neighbours
 * to those of filtered velocities at the same weight W, since the costs of section 4.2.3 are tuned to these.
 *   Measured between the recordings of different pages and writers. */
enum {
    DUCT_CONTEXT_SECTORS = 6,
    DUCT_CONTEXT_RINGS = 5,
    DUCT_CONTEXT_BINS = DUCT_CONTEXT_SECTORS * DUCT_CONTEXT_RINGS,
    DUCT_CONTEXT_DIMENSIONS = 2 * DUCT_CONTEXT_BINS
};

#define DUCT_CONTEXT_SCALE 5.5

/* The history's histogram of sample `i`, ring by ring from the inside, times `weight`, then the future's.
 * reach >= 1. Time: O(reach). */
void duct_context_histograms(const double *x, const double *y, size_t count, size_t i, double reach,
                             double weight, float bins[DUCT_CONTEXT_DIMENSIONS]);

#endif
