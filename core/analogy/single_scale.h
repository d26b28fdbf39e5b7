/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_SINGLE_SCALE_H
#define DUCTUS_ANALOGY_SINGLE_SCALE_H

#include "analogy/search.h"

/* The single-scale algorithms of "Curve analogies" section 3.1 to 3.3. */

/* One curve being made at one level. */
typedef struct duct_making {
    const duct_allocator *allocator;
    const duct_example_set *set;
    const duct_curve *others[DUCT_SLOTS]; /* B's curves for slots 1 and on */
    duct_pin *pins;                       /* by index of their control points */
    size_t pin_count;
    uint64_t id;      /* of the stroke, for what is random */
    uint64_t purpose; /* tells this pass from others */
    size_t *sources;  /* S: by control point; not read where the pass is the first */
    bool settled;     /* the best candidate is taken, none at random */
    double energy;    /* mean d of the pass */
} duct_making;

/* SYNTHESIZECURVE: makes `curve` (with room for `most` control points, of which 3 or more are filled) up to
 * `length` in arc length. Its parameters are the arc length over the whole. */
duct_status duct_synthesize_curve(duct_making *making, double length, size_t most, duct_curve *curve,
                                  duct_error *error);

/* SYNTHESIZEANALOGY: a causal pass over the control points of B, whose parameters `curve` has. */
duct_status duct_synthesize_analogy(duct_making *making, duct_curve *curve, duct_error *error);

/* REFINEANALOGY: a pass over all control points with full neighbourhoods, in place. `hinted`: the sources are
 * those of a pass before. */
duct_status duct_refine_analogy(duct_making *making, bool hinted, duct_curve *curve, duct_error *error);

#endif
