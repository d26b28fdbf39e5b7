/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/single_scale.h"

#include "base/error.h"
#include "base/pool.h"

#include <ductus/random.h>

#include <math.h>
#include <string.h>

/* Memory of one pass. */
typedef struct {
    duct_search_room search;
    double *samples; /* of the query's neighbourhoods, and their features weighted */
    size_t hints[DUCT_SLOTS];
    size_t next_pin;
} work;

static duct_status begin(const duct_making *making, work *self, duct_query *query, duct_error *error)
{
    const duct_example_set *set = making->set;
    size_t room = DUCT_NEIGHBOURHOOD_ROOM(set->reach);
    memset(self, 0, sizeof *self);
    memset(query, 0, sizeof *query);
    size_t weighted = DUCT_WEIGHTED_ROOM(set->reach);
    self->samples = duct_alloc(making->allocator, (room + weighted) * set->slots, sizeof *self->samples);
    if (self->samples == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t s = 0; s < set->slots; s++) {
        duct_neighbourhood_lay(&query->around[s], self->samples + s * room, set->reach, set->extra);
        query->weighted[s] = self->samples + set->slots * room + s * weighted;
    }
    duct_status status = duct_search_room_make(making->allocator, set, &self->search, error);
    if (status != DUCT_OK) {
        duct_release(making->allocator, self->samples);
    }
    return status;
}

static void end(const duct_making *making, work *self)
{
    duct_search_room_done(making->allocator, &self->search);
    duct_release(making->allocator, self->samples);
}

static double chance_of(const duct_making *making, size_t i)
{
    return duct_random_uniform(making->set->options->seed, making->id, i, making->purpose);
}

/* The neighbourhoods of B's curves at the parameter of control point i, and the constraints there. */
static void look_around(const duct_making *making, const duct_curve *curve, size_t i, work *self,
                        duct_query *query)
{
    const duct_example_set *set = making->set;
    for (size_t s = 1; s < set->slots; s++) {
        duct_place place = duct_curve_find(making->others[s], curve->t[i], &self->hints[s]);
        duct_neighbourhood_around(making->others[s], place, set->spacing, set->reach, &query->around[s]);
    }
    while (self->next_pin < making->pin_count && making->pins[self->next_pin].at < i) {
        self->next_pin++;
    }
    query->pins = making->pins + self->next_pin;
    query->pin_count = 0;
    while (self->next_pin + query->pin_count < making->pin_count && query->pins[query->pin_count].at == i) {
        query->pin_count++;
    }
}

/* Puts control point i where the candidate has it, and notes S(i). */
static void insert(duct_making *making, const duct_candidate *best, size_t i, duct_curve *curve,
                   duct_query *query)
{
    const duct_example_set *set = making->set;
    curve->x[i] = best->x;
    curve->y[i] = best->y;
    for (size_t p = 0; p < query->pin_count; p++) {
        duct_pin *pin = &query->pins[p];
        if (isinf(pin->pull.weight)) {
            pin->free[0] = best->x;
            pin->free[1] = best->y;
            curve->x[i] = pin->pull.x;
            curve->y[i] = pin->pull.y;
        }
    }
    if (curve->extra != NULL && set->extra) {
        curve->extra[i] = set->around[best->index * set->slots].extra[set->reach];
    }
    making->sources[i] = best->index;
    making->energy += best->cost;
    query->previous = best->index;
    query->at[0] = curve->x[i];
    query->at[1] = curve->y[i];
}

/* Three control points in a row, copied from the example. */
static void copy_three(duct_making *making, duct_curve *curve, duct_query *query)
{
    const duct_example_set *set = making->set;
    size_t first = (size_t)(chance_of(making, 0) * (double)set->count);
    while (first > 0 && (first + 2 >= set->count || set->piece[first + 2] != set->piece[first])) {
        first--;
    }
    const double *origin = set->around[first * set->slots].centre;
    for (size_t i = 0; i < 3; i++) {
        size_t j = first + i < set->count ? first + i : set->count - 1;
        const double *from = set->around[j * set->slots].centre;
        duct_candidate copied = {j, 0, from[0] - origin[0], from[1] - origin[1]};
        insert(making, &copied, i, curve, query);
    }
}

duct_status duct_synthesize_curve(duct_making *making, double length, size_t most, duct_curve *curve,
                                  duct_error *error)
{
    work self;
    duct_query query;
    duct_status status = begin(making, &self, &query, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_example_set *set = making->set;
    making->energy = 0;
    query.causal = true;
    query.chord = -1;
    query.extra = curve->extra != NULL && set->extra;
    copy_three(making, curve, &query);
    double made =
        hypot(curve->x[1], curve->y[1]) + hypot(curve->x[2] - curve->x[1], curve->y[2] - curve->y[1]);
    size_t i = 3;
    for (; i < most && made < length && status == DUCT_OK; i++) {
        duct_candidate best;
        duct_neighbourhood_before(curve, i, set->gap, set->spacing, set->reach, &query.around[0]);
        query.before = query.after = 0.5;
        duct_search_exact(set, &query, chance_of(making, i), &self.search, &best);
        insert(making, &best, i, curve, &query);
        made += hypot(curve->x[i] - curve->x[i - 1], curve->y[i] - curve->y[i - 1]);
        status = i % 64 == 0 ? duct_pool_check(error) : DUCT_OK;
    }
    end(making, &self);
    making->energy /= (double)i;
    curve->count = i;
    duct_curve_use_arc_length(curve);
    return status;
}

duct_status duct_synthesize_analogy(duct_making *making, duct_curve *curve, duct_error *error)
{
    work self;
    duct_query query;
    duct_status status = begin(making, &self, &query, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_example_set *set = making->set;
    making->energy = 0;
    query.causal = true;
    query.chord = -1;
    query.extra = curve->extra != NULL && set->extra;
    query.previous = DUCT_NOWHERE;
    for (size_t i = 0; i < curve->count && status == DUCT_OK; i++) {
        duct_candidate best;
        duct_neighbourhood_before(curve, i, set->gap, set->spacing, set->reach, &query.around[0]);
        look_around(making, curve, i, &self, &query);
        duct_neighbourhood_coverage(&query.around[1], set, &query.before, &query.after);
        duct_search_exact(set, &query, chance_of(making, i), &self.search, &best);
        insert(making, &best, i, curve, &query);
        status = i % 64 == 0 ? duct_pool_check(error) : DUCT_OK;
    }
    end(making, &self);
    making->energy /= (double)curve->count;
    return status;
}

duct_status duct_refine_analogy(duct_making *making, bool hinted, duct_curve *curve, duct_error *error)
{
    work self;
    duct_query query;
    duct_status status = begin(making, &self, &query, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_example_set *set = making->set;
    making->energy = 0;
    query.extra = curve->extra != NULL && set->extra;
    query.previous = DUCT_NOWHERE;
    for (size_t i = 0; i < curve->count && status == DUCT_OK; i++) {
        duct_candidate best;
        duct_neighbourhood_around(curve, (duct_place){i, 0}, set->spacing, set->reach, &query.around[0]);
        duct_neighbourhood_coverage(&query.around[0], set, &query.before, &query.after);
        look_around(making, curve, i, &self, &query);
        query.chord = i > 0 ? hypot(curve->x[i] - query.at[0], curve->y[i] - query.at[1]) : -1;
        duct_search_best(set, &query, making->settled ? -1 : chance_of(making, i),
                         hinted ? making->sources[i] : DUCT_NOWHERE, &self.search, &best);
        insert(making, &best, i, curve, &query);
        status = i % 64 == 0 ? duct_pool_check(error) : DUCT_OK;
    }
    end(making, &self);
    making->energy /= (double)curve->count;
    return status;
}
