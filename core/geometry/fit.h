/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_FIT_H
#define DUCTUS_GEOMETRY_FIT_H

#include "geometry/path.h"

/* Appends one subpath of cubic Bezier curves that follows `count` points (x and y arrays) within `tolerance`,
 * with few nodes: least-squares fitting with reparameterisation (after Schneider, "An algorithm for
 * automatically fitting digitized curves", Graphics Gems 1990) between corners, which are detected and kept.
 * Straight runs become lines. A closed curve's last point is joined to its first, which is not repeated, and
 * is smooth there unless that is a corner. Coinciding points are allowed. The result is a function of the
 * points alone. Memory: O(count). Failure to allocate sets path->failed. */
void duct_fit_curve(const double *x, const double *y, size_t count, bool closed, double tolerance,
                    duct_path *path);

#endif
