/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/search.h"

#include "analogy/basis.h"
#include "base/error.h"

#include <math.h>
#include <string.h>

/* The fast search evaluates no more positions than this: what lies behind them in the order of the estimates
 * is seldom better, and never by much. */
enum { FEWEST_EVALUATED = 24, MOST_EVALUATED = 192 };

static size_t most_evaluated(const duct_example_set *set)
{
    size_t most = FEWEST_EVALUATED + set->count / 12;
    return most < MOST_EVALUATED ? most : MOST_EVALUATED;
}

duct_status duct_search_room_make(const duct_allocator *allocator, const duct_example_set *largest,
                                  duct_search_room *room, duct_error *error)
{
    memset(room, 0, sizeof *room);
    room->costs = duct_alloc(allocator, largest->count, sizeof *room->costs);
    room->bounds = duct_alloc(allocator, 2 * largest->count, sizeof *room->bounds);
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

/* Positions in the order of their estimates, without those whose bounds tell that they are not within reach
 * of the best. */
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
    float *estimates = room->bounds + set->count;
    duct_basis_bounds(set, query, room->scratch, room->bounds, estimates);
    for (size_t j = 0; j < set->count; j++) {
        if (room->bounds[j] <= least * slack) {
            bool coherent = query->chord < 0 || duct_cost_coherent(set, query, j, query->chord);
            room->bounds[j] *= coherent ? 1 : (float)set->penalty;
            estimates[j] *= coherent ? 1 : (float)set->penalty;
            if (room->bounds[j] <= least * slack) {
                room->list[listed++] = j;
            }
        }
    }
    for (size_t most = most_evaluated(set); count < most && listed > 0;) {
        size_t first = 0;
        for (size_t i = 1; i < listed; i++) {
            first = estimates[room->list[i]] < estimates[room->list[first]] ? i : first;
        }
        size_t j = room->list[first];
        room->list[first] = room->list[--listed];
        if (room->bounds[j] > least * slack) {
            continue;
        }
        least = evaluate(set, query, j, room, evaluated, &count, least);
    }
    sort(evaluated, count);
    duct_cost_of(set, query, choose(set, room, evaluated, count, chance), best);
}

/* A query that lacks samples has no bounds: every few positions are evaluated, and then those beside the best
 * of them. */
static void search_sparsely(const duct_example_set *set, const duct_query *query, double chance, size_t hint,
                            duct_search_room *room, duct_candidate *best)
{
    const size_t stride = 4;
    size_t count = 0, near[3], found = 0;
    for (size_t j = 0; j < set->count; j++) {
        bool due = set->place[j] % stride == 0 || set->place[j] + 1 == set->sizes[set->piece[j]];
        due = due || j == hint || (query->previous != DUCT_NOWHERE && j == query->previous + 1);
        room->costs[j] = INFINITY;
        if (due) {
            duct_cost_of(set, query, j, best);
            room->costs[j] = best->cost;
            room->list[count++] = j;
            size_t at = found < 3 ? found++ : 3;
            for (; at > 0 && room->costs[near[at - 1]] > best->cost; at--) {
                if (at < 3) {
                    near[at] = near[at - 1];
                }
            }
            if (at < 3) {
                near[at] = j;
            }
        }
    }
    for (size_t n = 0; n < found; n++) {
        size_t first = near[n] >= stride ? near[n] - stride + 1 : 0;
        for (size_t j = first; j < near[n] + stride && j < set->count; j++) {
            if (isinf(room->costs[j])) {
                duct_cost_of(set, query, j, best);
                room->costs[j] = best->cost;
                room->list[count++] = j;
            }
        }
    }
    sort(room->list, count);
    duct_cost_of(set, query, choose(set, room, room->list, count, chance), best);
}

void duct_search_best(const duct_example_set *set, duct_query *query, double chance, size_t hint,
                      duct_search_room *room, duct_candidate *best)
{
    const size_t few = 48;
    bool fast = set->basis != NULL && !query->causal && set->count > few, full = fast;
    for (size_t s = 0; s < set->slots && full; s++) {
        full = duct_neighbourhood_full(&query->around[s], set->reach);
    }
    query->full = full;
    for (size_t s = 0; s < set->slots && full; s++) {
        duct_align_prepare(&query->around[s], set->reach, s == 0 ? set->own_weights : set->weights,
                           set->options->tangent_weight, &query->sums[s], query->weighted[s]);
    }
    if (full) {
        search_fast(set, query, chance, hint, room, best);
    } else if (fast) {
        search_sparsely(set, query, chance, hint, room, best);
    } else {
        duct_search_exact(set, query, chance, room, best);
    }
}
