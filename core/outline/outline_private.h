/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OUTLINE_PRIVATE_H
#define DUCTUS_OUTLINE_PRIVATE_H

#include "base/memory.h"
#include "outline/nib.h"

/* The stages of duct_path_outline(): the nibs of the samples, fewer and smoother ones that sweep the same
 * area, simple polygons that cover what they sweep, and the polygons' union. How the tolerance is divided
 * among them: */
#define DUCT_SHARE_SWEEP 0.1 /* leaving nibs out */
#define DUCT_SHARE_ARC 0.1   /* polygons for ellipses */
#define DUCT_SHARE_FIT 0.7   /* curves for polygons */

typedef struct duct_nib_list {
    duct_nib *items;
    size_t count, capacity;
} duct_nib_list;

/* Polygons one behind the other; a polygon's last point is not its first one again. */
typedef struct duct_polygons {
    double *xy;
    size_t point_count, point_capacity;
    size_t *ends; /* of each polygon: the number of points up to its end */
    size_t count, capacity;
} duct_polygons;

void duct_polygons_free(const duct_allocator *allocator, duct_polygons *polygons);
bool duct_polygons_add(const duct_allocator *allocator, duct_polygons *polygons, double x, double y);
/* Ends a polygon at the points added so far; one of less than three points is taken away. */
bool duct_polygons_end(const duct_allocator *allocator, duct_polygons *polygons);

/* The nibs that matter: those of the samples, with others between them where the samples are sparse and the
 * curve through them is not straight, without those that their neighbours make up for. A closed stroke's
 * first nib is repeated at its end. False when there is no memory. */
bool duct_sweep_nibs(const duct_allocator *allocator, const duct_stroke *stroke,
                     const duct_nib_options *options, duct_nib_list *nibs);

/* Simple polygons (counterclockwise where y is up) whose union is that of the convex hulls of consecutive
 * nibs, with arcs true to `sagitta`. With `split` each hull gives a polygon of its own: the plain way, for
 * reference. */
bool duct_envelope(const duct_allocator *allocator, const duct_nib_list *nibs, double sagitta, bool split,
                   duct_polygons *polygons);

/* The union of polygons as rings that do not cross, outer ones and holes. Leaves out those of an area below
 * `speck`. Errors: DUCT_NO_MEMORY, DUCT_UNSUPPORTED. */
duct_status duct_polygons_union(const duct_allocator *allocator, const duct_polygons *polygons, double speck,
                                duct_polygons *rings, duct_error *error);

#endif
