/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_PYRAMID_H
#define DUCTUS_ANALOGY_PYRAMID_H

#include "analogy/curve.h"

/* The Gaussian pyramid of a curve ("Curve analogies" section 3.4). Level 0 is the finest here, so that curves
 * whose pyramids differ in height share their levels; the paper counts from the coarsest. Level f has its
 * control points duct_pyramid_spacing() apart. */
typedef struct duct_pyramid {
    size_t count;
    duct_curve *levels;
} duct_pyramid;

/* D = finest (1.2)^f. The paper prints the exponent l - L, which would make coarse levels finer. */
double duct_pyramid_spacing(double finest, size_t level);

/* A blurred copy: a Gaussian of `deviation` control points along the curve. Closed curves wrap, open ones are
 * continued by their point reflection at the ends, which therefore stay where they are. Parameters stay.
 * Errors: DUCT_NO_MEMORY. */
duct_status duct_curve_blur(const duct_allocator *allocator, const duct_curve *curve, double deviation,
                            duct_curve *blurred, duct_error *error);

/* Errors: DUCT_NO_MEMORY, DUCT_LIMIT. The caller frees the pyramid with duct_pyramid_done(). */
duct_status duct_pyramid_make(const duct_allocator *allocator, const duct_curve *curve, double finest,
                              size_t levels, duct_pyramid *pyramid, duct_error *error);
void duct_pyramid_done(const duct_allocator *allocator, duct_pyramid *pyramid);

#endif
