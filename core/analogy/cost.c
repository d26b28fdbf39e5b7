/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/cost.h"

#include <math.h>

enum { MOST_PULLS = 16 };

/* Added where two neighbourhoods have hardly a sample in common, as those of a beginning and of an end. */
static const double incomparable = 1e30;

bool duct_cost_coherent(const duct_example_set *set, const duct_query *query, size_t j, double chord)
{
    size_t last = query->previous, piece = set->piece[j];
    if (last == DUCT_NOWHERE) {
        return true;
    }
    if (piece != set->piece[last]) {
        return false;
    }
    size_t size = set->sizes[piece], from = set->place[last], to = set->place[j];
    bool ahead = set->wraps[piece] ? to != from && (to + size - from) % size <= size / 2 : to > from;
    if (!ahead) {
        return false;
    }
    const double *a = set->around[last * set->slots].centre, *b = set->around[j * set->slots].centre;
    /* A curve that is about to grow has shorter steps than the examples: the next position is coherent. */
    return hypot(b[0] - a[0], b[1] - a[1]) < 1.5 * (chord > set->gap ? chord : set->gap);
}

typedef struct {
    double re, im;
} rotation;

static rotation rotation_of(bool free, double re, double im)
{
    double size = sqrt(re * re + im * im);
    return free && size > 0 ? (rotation){re / size, im / size} : (rotation){1, 0};
}

/* The offset term of a slot as a virtual constraint: B' has to lie to B as A' lies to A, by their centres of
 * mass, of which the new point is the share m (section 3.3). */
static duct_pull offset_pull(const duct_example_set *set, const duct_query *query, size_t j, size_t s,
                             const duct_alignment *own, const duct_alignment *other, rotation r)
{
    const duct_neighbourhood *a = &set->around[j * set->slots];
    const duct_neighbourhood *b = &query->around[0];
    /* In a causal pass the new point is not among the samples; its mass of 1 comes on top. */
    double total = query->causal ? own->mass + 1 : own->mass, m = 1 / total;
    double share = query->causal ? 1 - m : 1;
    double ax = a[0].centre[0] + share * own->a[0] - a[s].centre[0] - other->a[0];
    double ay = a[0].centre[1] + share * own->a[1] - a[s].centre[1] - other->a[1];
    double rest_x = (1 - m) * b[0].centre[0] + share * own->b[0];
    double rest_y = (1 - m) * b[0].centre[1] + share * own->b[1];
    double wanted_x = b[s].centre[0] + other->b[0] + r.re * ax - r.im * ay;
    double wanted_y = b[s].centre[1] + other->b[1] + r.im * ax + r.re * ay;
    return (duct_pull){(wanted_x - rest_x) / m, (wanted_y - rest_y) / m, set->slot[s].offset * m * m};
}

static double square(double value)
{
    return value * value;
}

void duct_cost_of(const duct_example_set *set, const duct_query *query, size_t j, duct_candidate *candidate)
{
    const duct_analogy_options *options = set->options;
    const duct_neighbourhood *a = &set->around[j * set->slots];
    duct_alignment sums[DUCT_SLOTS];
    double squares = 0, re = 0, im = 0, turn_re = 0, turn_im = 0;
    bool comparable = true;
    for (size_t s = 0; s < set->slots; s++) {
        const double *weights = s == 0 ? set->own_weights : set->weights;
        if (query->full && set->full[j]) {
            duct_align_full(&a[s], &set->sums[j * set->slots + s], query->weighted[s], &query->sums[s],
                            set->reach, s == 0 ? set->own_mass : set->mass, &sums[s]);
        } else {
            duct_align(&a[s], &query->around[s], set->reach, weights, options->tangent_weight, &sums[s]);
        }
        comparable =
            comparable && duct_neighbourhood_overlap(&a[s], &query->around[s], set, weights, sums[s].mass);
        if (!(sums[s].mass > 0)) {
            continue;
        }
        /* Samples that one of the two lacks are left out; what is there stands for all. */
        double scale = (s == 0 ? set->own_mass : set->mass) / sums[s].mass;
        squares += set->slot[s].cost * scale * sums[s].squares;
        re += set->slot[s].cost * scale * sums[s].product[0];
        im += set->slot[s].cost * scale * sums[s].product[1];
        turn_re += set->slot[s].align * scale * sums[s].product[0];
        turn_im += set->slot[s].align * scale * sums[s].product[1];
    }
    rotation r = rotation_of(options->rotation, turn_re, turn_im);
    double cost = squares - 2 * (r.re * re + r.im * im);
    cost = cost > 0 ? cost : 0;
    if (query->extra && query->full && set->full[j]) {
        sums[0].extra = duct_align_extra(&a[0], &query->around[0], set->reach, set->own_weights);
    }
    if (query->extra && sums[0].mass > 0) {
        cost += options->extra_weight * set->own_mass / sums[0].mass * sums[0].extra;
    }
    cost += options->end_weight * set->mass *
            (square(set->before[j] - query->before) + square(set->after[j] - query->after));

    duct_pull pulls[MOST_PULLS];
    size_t count = 0;
    if (sums[0].mass > 0) {
        const duct_neighbourhood *b = &query->around[0];
        pulls[count++] =
            (duct_pull){b->centre[0] + sums[0].b[0] - r.re * sums[0].a[0] + r.im * sums[0].a[1],
                        b->centre[1] + sums[0].b[1] - r.im * sums[0].a[0] - r.re * sums[0].a[1], 1};
    }
    for (size_t s = 1; s < set->slots; s++) {
        if (set->slot[s].offset > 0 && sums[s].mass > 0) {
            pulls[count++] = offset_pull(set, query, j, s, &sums[0], &sums[s], r);
        }
    }
    if (count == 0) {
        pulls[count++] = (duct_pull){query->around[0].centre[0], query->around[0].centre[1], 1};
    }
    for (size_t i = 0; i < query->pin_count && count < MOST_PULLS; i++) {
        if (!isinf(query->pins[i].pull.weight)) {
            pulls[count++] = query->pins[i].pull;
        }
    }
    cost += duct_pulls_solve(pulls, count, &candidate->x, &candidate->y);
    double chord =
        query->chord >= 0 ? query->chord : hypot(candidate->x - query->at[0], candidate->y - query->at[1]);
    if (!duct_cost_coherent(set, query, j, chord)) {
        cost *= set->penalty;
    }
    candidate->cost = comparable ? cost : cost + incomparable;
    candidate->index = j;
}
