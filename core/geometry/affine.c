/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/affine.h"

#include <math.h>

duct_affine duct_affine_identity(void)
{
    return (duct_affine){1, 0, 0, 1, 0, 0};
}

duct_affine duct_affine_multiply(duct_affine outer, duct_affine inner)
{
    return (duct_affine){
        outer.a * inner.a + outer.c * inner.b,           outer.b * inner.a + outer.d * inner.b,
        outer.a * inner.c + outer.c * inner.d,           outer.b * inner.c + outer.d * inner.d,
        outer.a * inner.e + outer.c * inner.f + outer.e, outer.b * inner.e + outer.d * inner.f + outer.f};
}

bool duct_affine_invert(duct_affine map, duct_affine *inverse)
{
    /* Divided by its largest entry the determinant can neither overflow nor underflow, and tells singular
     * maps from merely small ones. */
    double largest = fmax(fmax(fabs(map.a), fabs(map.b)), fmax(fabs(map.c), fabs(map.d)));
    if (!(largest > 0) || !isfinite(largest) || !isfinite(map.e) || !isfinite(map.f)) {
        return false;
    }
    double a = map.a / largest, b = map.b / largest, c = map.c / largest, d = map.d / largest;
    double determinant = a * d - b * c;
    if (!(fabs(determinant) > 1e-12)) {
        return false;
    }
    double factor = 1 / (determinant * largest);
    duct_affine made = {d * factor, -b * factor, -c * factor, a * factor, 0, 0};
    made.e = -(made.a * map.e + made.c * map.f);
    made.f = -(made.b * map.e + made.d * map.f);
    if (!isfinite(made.a) || !isfinite(made.b) || !isfinite(made.c) || !isfinite(made.d) ||
        !isfinite(made.e) || !isfinite(made.f)) {
        return false;
    }
    *inverse = made;
    return true;
}

void duct_affine_apply(duct_affine map, double *x, double *y)
{
    double px = *x, py = *y;
    *x = map.a * px + map.c * py + map.e;
    *y = map.b * px + map.d * py + map.f;
}

double duct_affine_scale(duct_affine map)
{
    return sqrt(fabs(map.a * map.d - map.b * map.c));
}

double duct_affine_stretch(duct_affine map)
{
    return (hypot(map.a + map.d, map.b - map.c) + hypot(map.a - map.d, map.b + map.c)) / 2;
}
