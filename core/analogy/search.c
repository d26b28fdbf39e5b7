/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/search.h"

#include "analogy/basis.h"
#include "base/error.h"

#include <math.h>
#include <string.h>

/* The fast search evaluates no more positions than this by their bounds: what lies behind them in that order
 * is seldom better, and never by much. */
enum { MOST_EVALUATED = 24 };

duct_status duct_search_room_make(const duct_allocator *allocator, const duct_example_set *largest,
                                  duct_search_room *room, duct_error *error)
{
    memset(room, 0, sizeof *room);
    room->costs = duct_alloc(allocator, largest->count, sizeof *room->costs);
    room->bounds = duct_alloc(allocator, largest->count, sizeof *room->bounds);
    room->list = duct_alloc(allocator, largest->count, sizeof *room->list);
    room->scratch = duct_alloc(allocator, duct_basis_scratch(largest), sizeof *room->scratch);
    if (room->costs == NULL || room->bounds == NULL || room->list == NULL || room->scratch == NULL) {
        duct_search_room_done(allocator, room);
        return duct_fail_memory(error);
    }
    return DUCT_OK;
}

void duct_search_room_done(const duct_allocator *allocator, duct_search_room *room)
{
    duct_release(allocator, room->costs);
    duct_release(allocator, room->bounds);
    duct_release(allocator, room->list);
    duct_release(allocator, room->scratch);
    memset(room, 0, sizeof *room);
}

/* Among `count` positions of room->list (NULL: all, in order), whose costs are in room->costs. */
static size_t choose(const duct_example_set *set, const duct_search_room *room, const size_t *list,
                     size_t count, double chance)
{
    double least = INFINITY;
    size_t best = 0;
    for (size_t i = 0; i < count; i++) {
        size_t j = list != NULL ? list[i] : i;
        if (room->costs[j] < least) {
            least = room->costs[j];
            best = j;
        }
    }
    double limit = least * (1 + set->options->randomness);
    if (!(set->options->randomness > 0) || chance < 0) {
        return best;
    }
    size_t within = 0;
    for (size_t i = 0; i < count; i++) {
        within += room->costs[list != NULL ? list[i] : i] <= limit;
    }
    size_t chosen = (size_t)(chance * (double)within);
    for (size_t i = 0; i < count; i++) {
        size_t j = list != NULL ? list[i] : i;
        if (room->costs[j] <= limit && chosen-- == 0) {
            return j;
        }
    }
    return best;
}

void duct_search_exact(const duct_example_set *set, const duct_query *query, double chance,
                       duct_search_room *room, duct_candidate *best)
{
    for (size_t j = 0; j < set->count; j++) {
        duct_cost_of(set, query, j, best);
        room->costs[j] = best->cost;
    }
    duct_cost_of(set, query, choose(set, room, NULL, set->count, chance), best);
}

static bool is_listed(const size_t *list, size_t count, size_t j)
{
    for (size_t i = 0; i < count; i++) {
        if (list[i] == j) {
            return true;
        }
    }
    return false;
}

static double evaluate(const duct_example_set *set, const duct_query *query, size_t j, duct_search_room *room,
                       size_t *evaluated, size_t *count, double least)
{
    if (j >= set->count || is_listed(evaluated, *count, j)) {
        return least;
    }
    duct_candidate candidate;
    duct_cost_of(set, query, j, &candidate);
    room->costs[j] = candidate.cost;
    evaluated[(*count)++] = j;
    return candidate.cost < least ? candidate.cost : least;
}

static void sort(size_t *list, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        size_t value = list[i], at = i;
        for (; at > 0 && list[at - 1] > value; at--) {
            list[at] = list[at - 1];
        }
        list[at] = value;
    }
}

/* Positions in the order of lower bounds, until none that is left can be within reach of the best. */
static void search_fast(const duct_example_set *set, const duct_query *query, double chance, size_t hint,
                        duct_search_room *room, duct_candidate *best)
{
    size_t evaluated[MOST_EVALUATED + 4], count = 0, listed = 0;
    double least = INFINITY, slack = chance < 0 ? 1 : 1 + set->options->randomness;
    if (query->previous != DUCT_NOWHERE) {
        size_t next = query->previous + 1;
        if (next >= set->count || set->piece[next] != set->piece[query->previous]) {
            next = next - set->sizes[set->piece[query->previous]];
        }
        least = evaluate(set, query, next, room, evaluated, &count, least);
    }
    if (hint != DUCT_NOWHERE) {
        least = evaluate(set, query, hint, room, evaluated, &count, least);
    }
    duct_basis_bounds(set, query, room->scratch, room->bounds);
    for (size_t j = 0; j < set->count; j++) {
        if (room->bounds[j] <= least * slack) {
            bool coherent = query->chord < 0 || duct_cost_coherent(set, query, j, query->chord);
            room->bounds[j] = coherent ? room->bounds[j] : room->bounds[j] * (float)set->penalty;
            if (room->bounds[j] <= least * slack) {
                room->list[listed++] = j;
            }
        }
    }
    for (size_t n = 0; n < MOST_EVALUATED && listed > 0; n++) {
        size_t first = 0;
        for (size_t i = 1; i < listed; i++) {
            first = room->bounds[room->list[i]] < room->bounds[room->list[first]] ? i : first;
        }
        size_t j = room->list[first];
        if (room->bounds[j] > least * slack) {
            break;
        }
        room->list[first] = room->list[--listed];
        least = evaluate(set, query, j, room, evaluated, &count, least);
    }
    sort(evaluated, count);
    duct_cost_of(set, query, choose(set, room, evaluated, count, chance), best);
}

void duct_search_best(const duct_example_set *set, const duct_query *query, double chance, size_t hint,
                      duct_search_room *room, duct_candidate *best)
{
    bool full = set->basis != NULL && !query->causal;
    for (size_t s = 0; s < set->slots && full; s++) {
        full = duct_neighbourhood_full(&query->around[s], set->reach);
    }
    if (full) {
        search_fast(set, query, chance, hint, room, best);
    } else {
        duct_search_exact(set, query, chance, room, best);
    }
}
