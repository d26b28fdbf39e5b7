/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_EXAMPLE_H
#define DUCTUS_ANALOGY_EXAMPLE_H

#include "analogy/analogy.h"
#include "analogy/neighbourhood.h"

/* The curves of one example pair at one level: the filtered one, and those that stand in A's place for it:
 * A of the same level, A' of the coarser one ("Curve analogies" section 3.5), or none. */
enum { DUCT_SLOTS = 3 /* 0 is the filtered curve itself */ };

typedef struct duct_level_curves {
    const duct_curve *slots[DUCT_SLOTS];
} duct_level_curves;

/* What a slot counts for. Slot 0 has an offset of 0. */
typedef struct duct_slot_weights {
    double cost;   /* in the matching term */
    double align;  /* in the rotation; as the cost, but for w_B = 0, where B's orientation still counts */
    double offset; /* of the offset term between the filtered curve and this one */
} duct_slot_weights;

struct duct_basis;

/* All neighbourhoods of the examples at one level, precomputed. */
typedef struct duct_example_set {
    size_t count, slots;
    int reach;
    double step;     /* D: between control points */
    double gap;      /* mean distance of neighbouring positions on the filtered curve */
    double spacing;  /* D / 4: between the samples of a neighbourhood */
    double mass;     /* of all weights */
    double own_mass; /* and of those of slot 0 */
    double penalty;  /* for a position that does not go on where the last one was */
    double *weights;
    double *own_weights; /* of slot 0: what lies ahead, and is still to be made, counts for less */
    duct_slot_weights slot[DUCT_SLOTS];
    const duct_analogy_options *options;
    bool extra;                 /* the filtered curves have the extra feature */
    duct_neighbourhood *around; /* [position * slots + slot] */
    double *before, *after;     /* share of the mass that lies before and behind a position */
    size_t *piece, *place;      /* by position: its pair, and its number there */
    size_t *sizes;              /* by pair: its number of positions */
    bool *wraps;                /* by pair: closed */
    double *samples;
    duct_full_sums *sums;     /* [position * slots + slot], for the fast search: NULL without */
    bool *full;               /* by position: no slot lacks a sample */
    struct duct_basis *basis; /* for the fast search; NULL without */
} duct_example_set;

/* Positions are the control points of `slots[at]` of each pair. Errors: DUCT_NO_MEMORY, DUCT_LIMIT. */
duct_status duct_example_set_make(const duct_allocator *allocator, const duct_level_curves *pairs,
                                  size_t pair_count, size_t slots, size_t at,
                                  const duct_slot_weights weights[DUCT_SLOTS], double step,
                                  const duct_analogy_options *options, duct_example_set *set,
                                  duct_error *error);
void duct_example_set_done(const duct_allocator *allocator, duct_example_set *set);

/* Whether a neighbourhood lacks no sample. */
bool duct_neighbourhood_full(const duct_neighbourhood *samples, int reach);

/* The share of the mass that a neighbourhood has on either side of its centre. */
void duct_neighbourhood_coverage(const duct_neighbourhood *samples, const duct_example_set *set,
                                 double *before, double *after);

/* Whether two neighbourhoods that have samples of mass `common` in common can be compared by them: not where
 * both lack most of what the other has. */
bool duct_neighbourhood_overlap(const duct_neighbourhood *a, const duct_neighbourhood *b,
                                const duct_example_set *set, const double *weights, double common);

#endif
