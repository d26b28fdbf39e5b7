/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_COST_H
#define DUCTUS_ANALOGY_COST_H

#include "analogy/constraints.h"
#include "analogy/example.h"

/* One control point of B' that is to be placed: what is known around it. */
typedef struct duct_query {
    duct_neighbourhood around[DUCT_SLOTS];
    bool causal;          /* around[0] holds what is before the point, relative to the last one made */
    double before, after; /* the share of the mass that the curve has on either side, as it will be */
    duct_pin *pins;       /* constraints at this point */
    size_t pin_count;
    size_t previous; /* S(i - 1), or DUCT_NOWHERE */
    double at[2];    /* where the point before it is */
    double chord;    /* how far it is from that one now; negative: where the candidate puts it */
    bool extra;      /* match the extra feature */
    /* For the fast search, where no slot lacks a sample (`full`): */
    bool full;
    duct_full_sums sums[DUCT_SLOTS];
    double *weighted[DUCT_SLOTS];
} duct_query;

#define DUCT_NOWHERE ((size_t)-1)

/* What an example position j has to offer: d_j and p_j. */
typedef struct duct_candidate {
    size_t index;
    double cost, x, y; /* a hard constraint is not yet obeyed */
} duct_candidate;

/* Whether position j goes on from S(i - 1): the same example curve, farther along, and by no more than one
 * and a half times the distance `chord` (section 3.1). */
bool duct_cost_coherent(const duct_example_set *set, const duct_query *query, size_t j, double chord);

/* d_j and p_j of equation (6): both shapes under one rotation and translations of their own, the offset
 * terms as virtual constraints, the real constraints, and the penalty for incoherence. */
void duct_cost_of(const duct_example_set *set, const duct_query *query, size_t j, duct_candidate *candidate);

#endif
