/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_SHAPE_H
#define DUCTUS_HELPINGHAND_SHAPE_H

#include "helpinghand/gesture.h"

/* Shape optimization: "HelpingHand" section 4.3.2. All lengths in sampling units. */
typedef enum duct_anchors {
    DUCT_ANCHORS_OFF,   /* the synthesized velocities are summed up from the first point: drifts */
    DUCT_ANCHORS_PAPER, /* exactly the paper's: ends are held by anchors a few samples inside */
    DUCT_ANCHORS_ON     /* the same; the ends stay within a unit of the query's, corners stay corners, and the
                           line stays     within the leeway */
} duct_anchors;

typedef struct duct_shape_options {
    duct_anchors anchors;
    double corner;           /* turning angle above which a local maximum is an angle point, radians */
    double vertex_cost;      /* squared misfit that another polyline vertex must save, square units */
    size_t longest;          /* most samples between two anchors */
    double leeway;           /* how far the line may stray from the query; only with DUCT_ANCHORS_ON */
    double anchor_weight;    /* C_a */
    double curvature_weight; /* C_k */
    size_t curvature_reach;  /* epsilon */
} duct_shape_options;

/* Marks the anchors of a query of `count` samples: points a few samples inside its ends, angle points, and
 * the vertices of the polylines between these; and in `corners`, which may be NULL, the angle points alone.
 * Both have room for `count`. Errors: DUCT_NO_MEMORY. */
duct_status duct_anchors_find(const duct_allocator *allocator, const duct_shape_options *options,
                              const double *x, const double *y, size_t count, bool *marks, bool *corners,
                              duct_error *error);

/* Finds the positions (out_x, out_y) that have the gestures' velocities and curvatures and meet the anchors,
 * equations (2) to (4), by one banded solve. `closed`: the query ends where it began and so does the result.
 * Errors: DUCT_NO_MEMORY. */
duct_status duct_shape_solve(const duct_allocator *allocator, const duct_shape_options *options,
                             const double *x, const double *y, const duct_gesture *gestures, size_t count,
                             bool closed, double *out_x, double *out_y, duct_error *error);

#endif
