/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_FIT_PRIVATE_H
#define DUCTUS_GEOMETRY_FIT_PRIVATE_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>

/* The parts of curve fitting: points that are ready to be fitted, corners, and one cubic at a time. */

/* Points without coinciding neighbours, with the arc length up to each. A closed curve's first point is
 * repeated at its end, so that every piece of it is a range of indices. */
typedef struct duct_fit_points {
    double *x, *y; /* count */
    double *s;     /* count: arc length of the polyline up to the point */
    double
        *sag; /* count: how far a curve may leave the straight line to the next point, beyond the tolerance */
    size_t count;
    bool closed;
    double tolerance;
} duct_fit_points;

typedef struct duct_vector {
    double x, y;
} duct_vector;

/* Faster than hypot() and the same on every machine; the points are small enough for squares. */
static inline double duct_length(double x, double y)
{
    return sqrt(x * x + y * y);
}

typedef struct duct_cubic {
    duct_vector p[4];
} duct_cubic;

/* How a piece's curve begins or ends: along `direction`, a unit vector that points into the piece. */
typedef struct duct_fit_end {
    duct_vector direction;
    bool free; /* the direction is an estimate only, as at corners: the fit may choose a better one */
} duct_fit_end;

/* Lists the corners among the points, rising, without the ends of an open curve: `corners` has room for all
 * points. Where there are none, `*sharpest` is the point of the greatest turn. */
size_t duct_fit_corners(const duct_fit_points *points, size_t *corners, size_t *sharpest);

/* The curve's direction at a point, as a unit vector along the curve: from both sides (side 0), or from what
 * follows (+1) or precedes (-1) it only. */
duct_vector duct_fit_tangent(const duct_fit_points *points, size_t index, int side);

/* Fits one cubic to the points first..last; false where none was found within the tolerance. `u` is scratch
 * memory for as many numbers as there are points. */
bool duct_fit_cubic(const duct_fit_points *points, size_t first, size_t last, duct_fit_end start,
                    duct_fit_end end, double *u, duct_cubic *cubic);

/* The straight line between two points, as a cubic. */
duct_cubic duct_fit_straight(const duct_fit_points *points, size_t first, size_t last);

#endif
