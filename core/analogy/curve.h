/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_CURVE_H
#define DUCTUS_ANALOGY_CURVE_H

#include "base/memory.h"

#include <ductus/status.h>

/* A curve as a parametric polyline ("Curve analogies" section 3, Figure 1): control points (t, p), linear in
 * between. Curves that belong together (A and A', B and B') share their parameter.
 *
 * t increases along the curve: 0 at its beginning and 1 at its end. A closed curve's last control point is
 * joined to its first, which is not repeated and has t = 0; all t are below 1. */
typedef struct duct_curve {
    size_t count;
    bool closed;
    double *t, *x, *y;
    double *extra; /* one more feature (pressure), or NULL */
    double *block; /* what the arrays lie in */
} duct_curve;

/* Makes room for `count` control points, all zero. Errors: DUCT_NO_MEMORY. */
duct_status duct_curve_init(const duct_allocator *allocator, size_t count, bool closed, bool extra,
                            duct_curve *curve, duct_error *error);
void duct_curve_done(const duct_allocator *allocator, duct_curve *curve);

/* The segments between neighbouring control points, the closing one included. */
size_t duct_curve_segments(const duct_curve *curve);

double duct_curve_length(const duct_curve *curve);

/* Gives every control point its normalised arc length as parameter. */
void duct_curve_use_arc_length(duct_curve *curve);

/* A place on a curve: `share` of the way from control point `at` to the next. */
typedef struct duct_place {
    size_t at;
    double share;
} duct_place;

/* The place of parameter t, found from `*hint` on (0 at first): for increasing t O(1) each. */
duct_place duct_curve_find(const duct_curve *curve, double t, size_t *hint);
void duct_curve_point(const duct_curve *curve, duct_place place, double *x, double *y);
double duct_curve_extra(const duct_curve *curve, duct_place place);

/* RESAMPLE: control points `spacing` apart in arc length, nearly, so that a whole number fits (but at least
 * `fewest` segments, and 3 of a closed curve). Parameters and extra features are interpolated. Errors:
 * DUCT_NO_MEMORY, DUCT_LIMIT. */
duct_status duct_curve_resample(const duct_allocator *allocator, const duct_curve *curve, double spacing,
                                size_t fewest, duct_curve *resampled, duct_error *error);

/* Moves the control point nearest to parameter t (an end for an end) onto the curve's place of exactly that
 * parameter, and returns its index. */
size_t duct_curve_pin(duct_curve *curve, double t);

#endif
