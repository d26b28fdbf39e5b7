/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_AFFINE_H
#define DUCTUS_GEOMETRY_AFFINE_H

#include <stdbool.h>

/* An affine map of the plane with the letters of SVG's matrix(a b c d e f): x' = a x + c y + e,
 * y' = b x + d y + f. */
typedef struct duct_affine {
    double a, b, c, d, e, f;
} duct_affine;

duct_affine duct_affine_identity(void);

/* The map that does `inner` first and `outer` after it. */
duct_affine duct_affine_multiply(duct_affine outer, duct_affine inner);

/* The inverse map. False, with `*inverse` untouched, where the map is singular to working accuracy or has
 * entries that are not finite. */
bool duct_affine_invert(duct_affine map, duct_affine *inverse);

/* Maps the point in place. */
void duct_affine_apply(duct_affine map, double *x, double *y);

/* The factor by which lengths grow on average: the square root of the area's factor. */
double duct_affine_scale(duct_affine map);

/* The largest factor by which a length may grow: the larger singular value of the linear part. */
double duct_affine_stretch(duct_affine map);

#endif
