/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/leaves.h"

#include "base/wide.h"

#include <math.h>
#include <string.h>

enum { ABREAST = 4 };
typedef double quads __attribute__((vector_size(ABREAST * sizeof(double)), aligned(sizeof(double))));
typedef int64_t masks __attribute__((vector_size(ABREAST * sizeof(int64_t))));

double duct_jump_distance(const duct_jump_space *space, uint32_t from, uint32_t to)
{
    const duct_jump_vector *a = &space->vectors[from], *b = &space->vectors[to];
    if (space->direction) {
        return 1 - (a->linear[0] * b->linear[0] + a->linear[1] * b->linear[1]);
    }
    double square = 0;
    for (int i = 0; i < DUCT_JUMP_LINEAR; i++) {
        double difference = a->linear[i] - b->linear[i];
        square += difference * difference;
    }
    if (space->twist_deviation > 0) {
        double turn = fabs(a->twist - b->twist);
        turn = turn > M_PI ? fabs(remainder(turn, 2 * M_PI)) : turn;
        turn /= space->twist_deviation;
        square += turn * turn;
    }
    return sqrt(square);
}

bool duct_leaves_make(duct_leaves *leaves, const duct_allocator *allocator, size_t most)
{
    /* Whole vectors are read. */
    size_t room = most + ABREAST, numbers = 2 + DUCT_JUMP_LINEAR;
    memset(leaves, 0, sizeof *leaves);
    leaves->costs = duct_alloc(allocator, numbers * room, sizeof *leaves->costs);
    leaves->states = duct_alloc(allocator, most, sizeof *leaves->states);
    if (leaves->costs == NULL || leaves->states == NULL) {
        return false;
    }
    for (size_t i = 0; i < DUCT_JUMP_LINEAR; i++) {
        leaves->linear[i] = leaves->costs + (1 + i) * room;
    }
    leaves->twist = leaves->costs + (1 + DUCT_JUMP_LINEAR) * room;
    return true;
}

void duct_leaves_free(duct_leaves *leaves, const duct_allocator *allocator)
{
    duct_release(allocator, leaves->costs);
    duct_release(allocator, leaves->states);
}

void duct_leaves_clear(duct_leaves *leaves)
{
    leaves->count = 0;
    leaves->cheapest = INFINITY;
    leaves->first = 0;
}

void duct_leaves_add(duct_leaves *leaves, const duct_jump_space *space, uint32_t sample, double cost,
                     unsigned state)
{
    const duct_jump_vector *vector = &space->vectors[sample];
    size_t at = leaves->count++;
    leaves->costs[at] = cost;
    leaves->states[at] = state;
    for (size_t i = 0; i < DUCT_JUMP_LINEAR; i++) {
        leaves->linear[i][at] = vector->linear[i];
    }
    leaves->twist[at] = vector->twist;
    if (cost < leaves->cheapest) {
        leaves->cheapest = cost;
        leaves->first = at;
    }
}

void duct_leaves_finish(duct_leaves *leaves, const duct_sequence_costs *costs)
{
    for (size_t i = 0; i < leaves->count; i++) {
        leaves->costs[i] += costs->jump;
    }
    for (size_t i = leaves->count; i < leaves->count + ABREAST; i++) {
        leaves->costs[i] = INFINITY;
    }
}

/* The squared pose distances of ABREAST candidates from `at` on, each formed as duct_jump_distance() does it,
 * so that the bits are the same. */
WIDE_PART void squares_abreast(const duct_leaves *leaves, const duct_jump_space *space, size_t at,
                               const duct_jump_vector *to, quads *squares)
{
    const quads a = *(const quads *)(leaves->linear[0] + at), b = *(const quads *)(leaves->linear[1] + at);
    const quads c = *(const quads *)(leaves->linear[2] + at), turn = *(const quads *)(leaves->twist + at);
    quads da = a - to->linear[0], db = b - to->linear[1], dc = c - to->linear[2];
    quads square = da * da + db * db + dc * dc;
    if (space->twist_deviation > 0) {
        /* Twists are within -pi..pi, so a difference above pi lies one turn, whose subtraction is exact, from
         * the remainder. */
        quads off = (quads)((masks)(turn - to->twist) & INT64_MAX);
        quads around = (quads)((masks)(off - 2 * M_PI) & INT64_MAX);
        masks far = off > M_PI;
        off = (quads)(((masks)off & ~far) | ((masks)around & far));
        off /= space->twist_deviation;
        square += off * off;
    }
    *squares = square;
}

static bool is_jump(const duct_candidate *from, const duct_candidate *to)
{
    return from->stroke != to->stroke || to->sample - from->sample > 2;
}

/* A bound that does not exclude what the cheapest leave comes to: with it, most others need no distance. */
static double bound_by_cheapest(const duct_leaves *leaves, const duct_jump_space *space,
                                const duct_sequence_costs *costs, const duct_candidate *before,
                                const duct_candidate *here, double limit)
{
    size_t cheapest = leaves->first;
    if (!is_jump(&before[cheapest], here)) {
        return limit;
    }
    double total = leaves->costs[cheapest] +
                   costs->distance * duct_jump_distance(space, before[cheapest].sample, here->sample);
    total = nextafter(total, INFINITY);
    return total < limit ? total : limit;
}

WIDE_PART bool any(const masks *bits)
{
    return (((*bits)[0] | (*bits)[1]) | ((*bits)[2] | (*bits)[3])) != 0;
}

WIDE static size_t leaves_best(const duct_leaves *leaves, const duct_jump_space *space,
                               const duct_sequence_costs *costs, const duct_candidate *before,
                               const duct_candidate *here, double *best)
{
    /* Beyond rounding. */
    const double slack = 1e-9, factor = costs->distance * costs->distance;
    const duct_jump_vector *to = &space->vectors[here->sample];
    size_t chosen = leaves->count;
    double least = bound_by_cheapest(leaves, space, costs, before, here, *best);
    for (size_t at = 0; at < leaves->count; at += ABREAST) {
        /* What is left for the distance; distances are not negative. */
        quads room = least - *(const quads *)(leaves->costs + at) + slack, measure;
        masks near = room > 0;
        if (!any(&near)) {
            continue;
        }
        if (space->direction) {
            measure = 1 - (*(const quads *)(leaves->linear[0] + at) * to->linear[0] +
                           *(const quads *)(leaves->linear[1] + at) * to->linear[1]);
            near &= measure * costs->distance < room;
        } else {
            squares_abreast(leaves, space, at, to, &measure);
            near &= measure * factor < room * room * (1 + slack);
        }
        if (!any(&near)) {
            continue;
        }
        for (size_t lane = 0; lane < ABREAST && at + lane < leaves->count; lane++) {
            if (!near[lane]) {
                continue;
            }
            double distance = space->direction ? measure[lane] : sqrt(measure[lane]);
            double total = leaves->costs[at + lane] + costs->distance * distance;
            if (total < least && is_jump(&before[at + lane], here)) {
                least = total;
                chosen = at + lane;
            }
        }
    }
    if (chosen < leaves->count) {
        *best = least;
    }
    return chosen;
}

size_t duct_leaves_best(const duct_leaves *leaves, const duct_jump_space *space,
                        const duct_sequence_costs *costs, const duct_candidate *before,
                        const duct_candidate *here, double *best)
{
    return leaves_best(leaves, space, costs, before, here, best);
}
