/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_SEARCH_H
#define DUCTUS_ANALOGY_SEARCH_H

#include "analogy/cost.h"

/* Choosing j* among all example positions: uniformly among those whose cost is within (1 + epsilon) of the
 * least. (The paper's pseudocode has the inequality turned round.) */

/* Scratch memory for searching; made for the largest set it is used with. */
typedef struct duct_search_room {
    double *costs;   /* by position */
    float *bounds;   /* by position, and behind them the estimates */
    size_t *list;    /* by position */
    double *scratch; /* duct_basis_scratch() */
} duct_search_room;

duct_status duct_search_room_make(const duct_allocator *allocator, const duct_example_set *largest,
                                  duct_search_room *room, duct_error *error);
void duct_search_room_done(const duct_allocator *allocator, duct_search_room *room);

/* `chance` in 0..1 decides among the candidates, below 0 takes the best of them; `hint` is a position that
 * was good before, or DUCT_NOWHERE. Takes the exact search where the set has no basis or the query lacks
 * samples. */
void duct_search_best(const duct_example_set *set, duct_query *query, double chance, size_t hint,
                      duct_search_room *room, duct_candidate *best);

/* Evaluates every position: the reference. */
void duct_search_exact(const duct_example_set *set, const duct_query *query, double chance,
                       duct_search_room *room, duct_candidate *best);

#endif
