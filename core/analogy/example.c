/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/example.h"

#include "analogy/basis.h"
#include "base/error.h"

#include <math.h>
#include <string.h>

/* Samples whose weight is below this are left out, unless the exact reference is asked for. */
static const double negligible = 1e-5;

/* A gigabyte or so. */
static const double most_values = 1.5e8;

bool duct_neighbourhood_full(const duct_neighbourhood *samples, int reach)
{
    return samples->low == -reach && samples->high == reach;
}

void duct_neighbourhood_coverage(const duct_neighbourhood *samples, const duct_example_set *set,
                                 double *before, double *after)
{
    *before = *after = 0;
    for (int k = samples->low; k < 0; k++) {
        *before += set->weights[k + set->reach];
    }
    for (int k = 1; k <= samples->high; k++) {
        *after += set->weights[k + set->reach];
    }
    *before /= set->mass;
    *after /= set->mass;
}

static double mass_of(const duct_neighbourhood *samples, const duct_example_set *set, const double *weights)
{
    double mass = 0;
    for (int k = samples->low; k <= samples->high; k++) {
        mass += weights[k + set->reach];
    }
    return mass;
}

bool duct_neighbourhood_overlap(const duct_neighbourhood *a, const duct_neighbourhood *b,
                                const duct_example_set *set, const double *weights, double common)
{
    const double enough = 0.45;
    if (common >= enough * set->mass) {
        return true;
    }
    double one = mass_of(a, set, weights), other = mass_of(b, set, weights);
    return common >= enough * (one < other ? one : other);
}

static int reach_of(const duct_analogy_options *options)
{
    int reach = options->neighbourhood / 2;
    double weights[2 * 512 + 1];
    duct_neighbourhood_weights(options->neighbourhood, reach, weights);
    while (!options->exact && reach > 1 && weights[options->neighbourhood / 2 + reach] < negligible) {
        reach--;
    }
    return reach;
}

static duct_status allocate(const duct_allocator *allocator, size_t pair_count, duct_example_set *set,
                            duct_error *error)
{
    size_t room = DUCT_NEIGHBOURHOOD_ROOM(set->reach), all = set->count * set->slots;
    if ((double)room * (double)all > most_values) {
        return duct_fail(error, DUCT_LIMIT,
                         "the example curves are too long: %zu neighbourhoods; give shorter ones or a larger "
                         "spacing",
                         set->count);
    }
    set->weights = duct_alloc(allocator, 2 * (2 * (size_t)set->reach + 1), sizeof *set->weights);
    set->around = duct_alloc(allocator, all, sizeof *set->around);
    set->before = duct_alloc(allocator, 2 * set->count, sizeof *set->before);
    set->piece = duct_alloc(allocator, 2 * set->count, sizeof *set->piece);
    set->sizes = duct_alloc(allocator, pair_count, sizeof *set->sizes);
    set->wraps = duct_alloc(allocator, pair_count, sizeof *set->wraps);
    set->full = duct_alloc(allocator, set->count, sizeof *set->full);
    set->sums = set->options->exact ? NULL : duct_alloc(allocator, all, sizeof *set->sums);
    set->samples = duct_alloc(allocator, room * all, sizeof *set->samples);
    if (set->weights == NULL || set->around == NULL || set->before == NULL || set->piece == NULL ||
        set->sizes == NULL || set->wraps == NULL || set->full == NULL ||
        (!set->options->exact && set->sums == NULL) || set->samples == NULL) {
        return duct_fail_memory(error);
    }
    set->own_weights = set->weights + 2 * (size_t)set->reach + 1;
    set->after = set->before + set->count;
    set->place = set->piece + set->count;
    for (size_t i = 0; i < all; i++) {
        duct_neighbourhood_lay(&set->around[i], set->samples + i * room, set->reach, set->extra);
    }
    return DUCT_OK;
}

static void fill(const duct_level_curves *pairs, size_t pair_count, size_t at, duct_example_set *set)
{
    size_t j = 0, steps = 0;
    double walked = 0;
    for (size_t p = 0; p < pair_count; p++) {
        const duct_curve *positions = pairs[p].slots[at];
        size_t hints[DUCT_SLOTS] = {0};
        set->sizes[p] = positions->count;
        set->wraps[p] = pairs[p].slots[0]->closed;
        for (size_t i = 0; i < positions->count; i++, j++) {
            for (size_t s = 0; s < set->slots; s++) {
                const duct_curve *curve = pairs[p].slots[s];
                duct_place place =
                    s == at ? (duct_place){i, 0} : duct_curve_find(curve, positions->t[i], &hints[s]);
                duct_neighbourhood_around(curve, place, set->spacing, set->reach,
                                          &set->around[j * set->slots + s]);
            }
            const duct_neighbourhood *own = &set->around[j * set->slots];
            set->full[j] = true;
            for (size_t s = 0; s < set->slots; s++) {
                set->full[j] = set->full[j] && duct_neighbourhood_full(&own[s], set->reach);
            }
            for (size_t s = 0; s < set->slots && set->full[j] && set->sums != NULL; s++) {
                duct_align_prepare(&own[s], set->reach, s == 0 ? set->own_weights : set->weights,
                                   set->options->tangent_weight, &set->sums[j * set->slots + s], NULL);
            }
            duct_neighbourhood_coverage(own, set, &set->before[j], &set->after[j]);
            set->piece[j] = p;
            set->place[j] = i;
            if (i > 0) {
                const duct_neighbourhood *last = own - set->slots;
                walked += hypot(own->centre[0] - last->centre[0], own->centre[1] - last->centre[1]);
                steps++;
            }
        }
    }
    set->gap = steps > 0 && walked > 0 ? walked / (double)steps : set->step;
}

duct_status duct_example_set_make(const duct_allocator *allocator, const duct_level_curves *pairs,
                                  size_t pair_count, size_t slots, size_t at,
                                  const duct_slot_weights weights[DUCT_SLOTS], double step,
                                  const duct_analogy_options *options, duct_example_set *set,
                                  duct_error *error)
{
    duct_example_set made = {.slots = slots,
                             .reach = reach_of(options),
                             .step = step,
                             .spacing = step / 4,
                             .penalty = 1 + options->coherence * step / (options->spacing * options->spacing),
                             .options = options,
                             .extra = true};
    for (size_t p = 0; p < pair_count; p++) {
        made.count += pairs[p].slots[at]->count;
        made.extra = made.extra && pairs[p].slots[0]->extra != NULL;
    }
    memcpy(made.slot, weights, sizeof made.slot);
    duct_status status = allocate(allocator, pair_count, &made, error);
    if (status == DUCT_OK) {
        duct_neighbourhood_weights(options->neighbourhood, made.reach, made.weights);
        for (int k = 0; k < 2 * made.reach + 1; k++) {
            made.mass += made.weights[k];
            made.own_weights[k] = made.weights[k] * (k > made.reach ? options->foresight : 1);
            made.own_mass += made.own_weights[k];
        }
        fill(pairs, pair_count, at, &made);
        if (!options->exact) {
            status = duct_basis_new(allocator, &made, &made.basis, error);
        }
    }
    if (status != DUCT_OK) {
        duct_example_set_done(allocator, &made);
        return status;
    }
    *set = made;
    return DUCT_OK;
}

void duct_example_set_done(const duct_allocator *allocator, duct_example_set *set)
{
    duct_release(allocator, set->weights);
    duct_release(allocator, set->around);
    duct_release(allocator, set->before);
    duct_release(allocator, set->piece);
    duct_release(allocator, set->sizes);
    duct_release(allocator, set->wraps);
    duct_release(allocator, set->samples);
    duct_release(allocator, set->sums);
    duct_release(allocator, set->full);
    duct_basis_free(allocator, set->basis);
    memset(set, 0, sizeof *set);
}
