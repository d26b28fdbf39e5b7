/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_CONSTRAINTS_H
#define DUCTUS_ANALOGY_CONSTRAINTS_H

#include "analogy/analogy.h"

/* Constraints on positions ("Curve analogies" section 3.2). All terms that pull at a new control point, real
 * or not, become constraints <q, w>; the point is put where sum w |p - q|^2 is least. */
typedef struct duct_pull {
    double x, y, weight;
} duct_pull;

/* p = sum w q / sum w (equation 5); returns sum w |p - q|^2. With an infinite weight among them, p is that
 * one's place. The sum of the weights must be above 0. */
double duct_pulls_solve(const duct_pull *pulls, size_t count, double *x, double *y);

/* The weight of a constraint `level` levels above the finest: as a Gaussian whose variance has grown by
 * `level`. (The paper prints its inverse, by which hard constraints would vanish at the finest level.) */
double duct_constraint_soften(double weight, size_t level);

/* A constraint at a curve's control point. */
typedef struct duct_pin {
    size_t at;
    duct_pull pull;
    double free[2]; /* where a pass would have put the point without the pin */
} duct_pin;

/* Moves control points of the curve to the constraints' parameters and gives them as pins, by index and
 * softened for the level. `pins` has room for `count`. */
void duct_constraints_pin(duct_curve *curve, const duct_curve_constraint *constraints, size_t count,
                          size_t level, duct_pin *pins);

/* Moves a curve towards its pins as a whole, so that none of them is met by a spike: each pin's share of what
 * is missing (all of it where it is hard), falling off evenly to the next pin, or over `reach` of arc length.
 */
void duct_constraints_spread(duct_curve *curve, const duct_pin *pins, size_t count, double reach);

/* Puts hard pins' points back to where the last pass had them without the pin, and spreads what is missing.
 */
void duct_constraints_settle(duct_curve *curve, const duct_pin *pins, size_t count, double reach);

/* Errors: DUCT_UNSUPPORTED where two hard constraints want different places of one parameter. */
duct_status duct_constraints_check(const duct_curve_constraint *constraints, size_t count, duct_error *error);

#endif
