/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_H
#define DUCTUS_ANALOGY_H

#include "analogy/curve.h"

#include <stdint.h>

/* "Curve analogies" (Hertzmann, Oliver, Curless, Seitz, Eurographics Workshop on Rendering 2002): curves in
 * the style of example curves, A : A' :: B : B'. Curves go in and come out; all lengths are in the examples'
 * own pixels. */

typedef struct duct_analogy_options {
    bool rotation;         /* neighbourhoods are compared up to a rotation, not only a translation */
    double shape_weight;   /* w_B: how much the shapes of A and B count; 0: only B's sweep */
    double coarse_weight;  /* w_B'(l-1): how much the coarser level counts */
    double offset_weight;  /* w_OFFSET */
    double tangent_weight; /* w_delta */
    double end_weight; /* not in the paper: how much it counts that ends are made like ends; 0: not at all */
    double extra_weight; /* how much the extra feature counts in matching */
    double foresight;  /* not in the paper: what lies ahead on B' counts this much of what lies behind; 1: as
                          much. It is the coarser level still, and smoother than the examples. */
    int neighbourhood; /* K, odd */
    double spacing;    /* D of the finest level */
    size_t levels;     /* of the pyramids, at most; 0: as many as suit the examples */
    size_t passes;     /* of refinement at each level, at least 1 */
    double coherence;  /* kappa */
    double randomness; /* epsilon */
    bool exact;        /* search all example neighbourhoods, all of their samples: the reference */
    uint64_t seed;
} duct_analogy_options;

/* The values of section 3.6, w_B = 0. */
duct_analogy_options duct_analogy_options_default(void);

/* One example. A and A' share their parameter; without A (count 0) it is good for synthesis only. */
typedef struct duct_curve_pair {
    duct_curve a, b;
} duct_curve_pair;

/* The curve has to pass through (x, y) at parameter t: exactly where `weight` is infinite, else as a spring
 * of that weight (section 3.2). */
typedef struct duct_curve_constraint {
    double t, x, y, weight;
} duct_curve_constraint;

/* Examples made ready. Read-only once made; used from several threads at once. */
typedef struct duct_analogy duct_analogy;

/* The examples are copied. All pairs have an A, or none has. Errors: DUCT_UNSUPPORTED (no example with a
 * length), DUCT_LIMIT, DUCT_NO_MEMORY. */
duct_status duct_analogy_new(const duct_allocator *allocator, const duct_curve_pair *pairs, size_t count,
                             const duct_analogy_options *options, duct_analogy **analogy, duct_error *error);
void duct_analogy_free(duct_analogy *analogy);

/* What a result is like. */
typedef struct duct_analogy_figures {
    double energy; /* mean cost of a control point at the finest level (equation 6 over the points) */
    double copied; /* mean length of runs that were copied from one piece of an example, control points */
    size_t levels; /* that were used */
    size_t points; /* control points at the finest level */
} duct_analogy_figures;

/* SYNTHESIZEANALOGYMULTIRES: B' for a curve with a length. `id` and the seed decide what is random. The
 * caller frees the result, which has B's parameter. `figures` may be NULL. Errors: DUCT_UNSUPPORTED (hard
 * constraints that contradict each other), DUCT_LIMIT, DUCT_NO_MEMORY, DUCT_CANCELLED. */
duct_status duct_analogy_apply(const duct_analogy *analogy, const duct_curve *b, uint64_t id,
                               const duct_curve_constraint *constraints, size_t count, duct_curve *result,
                               duct_analogy_figures *figures, duct_error *error);

/* SYNTHESIZECURVEMULTIRES: a curve of about `length`, from (0, 0) on. */
duct_status duct_analogy_synthesize(const duct_analogy *analogy, double length, uint64_t id,
                                    duct_curve *result, duct_analogy_figures *figures, duct_error *error);

/* The same through constraints: `guide` is a curve that meets them and has their parameters, and from which
 * the coarsest level starts. */
duct_status duct_analogy_synthesize_through(const duct_analogy *analogy, const duct_curve *guide, uint64_t id,
                                            const duct_curve_constraint *constraints, size_t count,
                                            duct_curve *result, duct_analogy_figures *figures,
                                            duct_error *error);

/* The mean of min_j d(B', t_i, A', s_j) over a curve resampled at the finest spacing, found by the exact
 * search: how much its neighbourhoods look like the examples' (equation 2). Errors: DUCT_NO_MEMORY. */
duct_status duct_analogy_likeness(const duct_analogy *analogy, const duct_curve *curve, double *mean,
                                  duct_error *error);

#endif
