/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_BEZIER_H
#define DUCTUS_GEOMETRY_BEZIER_H

#include "geometry/affine.h"
#include "geometry/path.h"

/* Adds a quadratic Bezier curve from (x0, y0), where the path is now, as the cubic one that it equals. */
void duct_path_quadratic(duct_path *path, double x0, double y0, double x1, double y1, double x, double y);

/* Adds an elliptical arc from (x0, y0), where the path is now, to (x, y) as cubic curves that differ from it
 * by less than 1e-7 of its radii. The arguments are those of SVG's arc command, `rotation` in degrees, and
 * are corrected as its specification says: radii that are too small grow, a radius of 0 gives a line, equal
 * ends give nothing. (SVG 1.1, appendix F.6) */
void duct_path_arc(duct_path *path, double x0, double y0, double rx, double ry, double rotation, bool large,
                   bool sweep, double x, double y);

/* Maps all points of the path in place. */
void duct_path_transform(duct_path *path, duct_affine map);

/* One subpath of a path: its verbs [verb, verb_end) and its points [point, point_end). */
typedef struct duct_subpath {
    size_t verb, verb_end;
    size_t point, point_end;
    bool closed;
} duct_subpath;

/* Walks the subpaths: begin with a zeroed `subpath`; false when there is none any more. */
bool duct_path_next(const duct_path *path, duct_subpath *subpath);

/* Appends a copy of a subpath of another path. */
void duct_path_append(duct_path *path, const duct_path *other, const duct_subpath *subpath);

/* A growing list of points. A failed allocation sets `failed`, more than `limit` points set `full`; both make
 * all further calls do nothing. */
typedef struct duct_points {
    const duct_allocator *allocator;
    double *x, *y;
    size_t count, x_capacity, y_capacity;
    size_t limit;
    bool failed, full;
} duct_points;

void duct_points_init(duct_points *points, const duct_allocator *allocator, size_t limit);
void duct_points_free(duct_points *points);

/* Adds a point, unless it lies within 1e-9 of the last one. */
void duct_points_add(duct_points *points, double x, double y);

/* Adds points on the cubic curve c[0..7] (x, y of start, two controls, end), without its start, so that the
 * polyline through them stays within `tolerance` of it. At most 65536 points a curve. */
void duct_flatten_cubic(duct_points *points, const double c[8], double tolerance);

/* Puts the flattened subpath in place of the list's points. Neighbours that coincide are dropped, and of a
 * closed subpath the last point where it repeats the first; one point at least remains. */
void duct_flatten_subpath(duct_points *points, const duct_path *path, const duct_subpath *subpath,
                          double tolerance);

#endif
