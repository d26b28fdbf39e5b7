/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Examples made ready: their pyramids, and the neighbourhoods at every level. */
#include "analogy/analogy.h"

#include "analogy/multiresolution.h"
#include "base/error.h"

#include <math.h>
#include <string.h>

enum { MOST_LEVELS = 32 };

/* At the coarsest level the shortest example still has about this many control points. */
static const double coarsest_points = 20;

duct_analogy_options duct_analogy_options_default(void)
{
    return (duct_analogy_options){.rotation = true,
                                  .shape_weight = 0,
                                  .coarse_weight = 2,
                                  .offset_weight = 3.8,
                                  .tangent_weight = 100,
                                  .end_weight = 100,
                                  .extra_weight = 100,
                                  .foresight = 0.1,
                                  .neighbourhood = 81,
                                  .spacing = 1,
                                  .levels = 0,
                                  .passes = 1,
                                  .coherence = 1,
                                  .randomness = 0.1,
                                  .exact = false,
                                  .seed = 0};
}

static size_t levels_for(const duct_curve_pair *pairs, size_t count, const duct_analogy_options *options)
{
    double shortest = INFINITY;
    for (size_t p = 0; p < count; p++) {
        double length = duct_curve_length(pairs[p].a.count > 0 ? &pairs[p].a : &pairs[p].b);
        shortest = length < shortest ? length : shortest;
    }
    size_t levels = 1;
    while (levels < MOST_LEVELS &&
           duct_pyramid_spacing(options->spacing, levels) * coarsest_points <= shortest) {
        levels++;
    }
    return options->levels > 0 ? options->levels : levels;
}

static duct_status make_pyramids(duct_analogy *analogy, const duct_curve_pair *pairs, duct_error *error)
{
    duct_status status = DUCT_OK;
    double spacing = analogy->options.spacing;
    for (size_t p = 0; p < analogy->pair_count && status == DUCT_OK; p++) {
        status = duct_pyramid_make(&analogy->allocator, &pairs[p].b, spacing, analogy->levels, &analogy->b[p],
                                   error);
        if (status == DUCT_OK && analogy->has_a) {
            status = duct_pyramid_make(&analogy->allocator, &pairs[p].a, spacing, analogy->levels,
                                       &analogy->a[p], error);
        }
    }
    return status;
}

static duct_status check(const duct_curve_pair *pairs, size_t count, duct_error *error)
{
    if (count == 0) {
        return duct_fail(error, DUCT_UNSUPPORTED, "there is no example curve to take the style from");
    }
    for (size_t p = 0; p < count; p++) {
        bool good = pairs[p].b.count > 1 && duct_curve_length(&pairs[p].b) > 0;
        good =
            good && (pairs[p].a.count == 0 || (pairs[p].a.count > 1 && duct_curve_length(&pairs[p].a) > 0));
        if (!good) {
            return duct_fail(error, DUCT_UNSUPPORTED,
                             "example curve %zu has no length; give a line, not a dot", p + 1);
        }
        if ((pairs[p].a.count > 0) != (pairs[0].a.count > 0)) {
            return duct_fail(error, DUCT_UNSUPPORTED,
                             "some of the example curves have a plain curve and "
                             "some have none; give all of them one, or none");
        }
    }
    return DUCT_OK;
}

duct_status duct_analogy_new(const duct_allocator *allocator, const duct_curve_pair *pairs, size_t count,
                             const duct_analogy_options *options, duct_analogy **analogy, duct_error *error)
{
    duct_status status = check(pairs, count, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_analogy *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->options = *options;
    made->pair_count = count;
    made->has_a = pairs[0].a.count > 0;
    made->extra = true;
    for (size_t p = 0; p < count; p++) {
        made->extra = made->extra && pairs[p].b.extra != NULL;
    }
    made->levels = levels_for(pairs, count, options);
    made->a = duct_alloc(allocator, 2 * count, sizeof *made->a);
    made->refine = duct_alloc(allocator, made->levels, sizeof *made->refine);
    if (made->a == NULL || made->refine == NULL) {
        status = duct_fail_memory(error);
    } else {
        made->b = made->a + count;
        status = make_pyramids(made, pairs, error);
    }
    while (status == DUCT_OK && made->refine_count + 1 < made->levels) {
        status = duct_multiresolution_refine_set(made, made->refine_count, &made->refine[made->refine_count],
                                                 error);
        made->refine_count += status == DUCT_OK;
    }
    if (status != DUCT_OK) {
        duct_analogy_free(made);
        return status;
    }
    *analogy = made;
    return DUCT_OK;
}

void duct_analogy_free(duct_analogy *analogy)
{
    if (analogy == NULL) {
        return;
    }
    const duct_allocator allocator = analogy->allocator;
    for (size_t p = 0; analogy->a != NULL && p < 2 * analogy->pair_count; p++) {
        duct_pyramid_done(&allocator, &analogy->a[p]);
    }
    for (size_t i = 0; i < analogy->refine_count; i++) {
        duct_example_set_done(&allocator, &analogy->refine[i]);
    }
    duct_release(&allocator, analogy->a);
    duct_release(&allocator, analogy->refine);
    duct_release(&allocator, analogy);
}

duct_status duct_analogy_likeness(const duct_analogy *analogy, const duct_curve *curve, double *mean,
                                  duct_error *error)
{
    const duct_allocator *allocator = &analogy->allocator;
    duct_analogy shape = *analogy;
    shape.has_a = false;
    shape.options.exact = true;
    shape.options.foresight = 1;
    shape.options.end_weight = shape.options.extra_weight = shape.options.coherence = 0;
    shape.options.randomness = 0;
    duct_example_set set;
    duct_curve even;
    duct_status status = duct_multiresolution_first_set(&shape, 0, false, &set, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = duct_curve_resample(allocator, curve, shape.options.spacing, 2, &even, error);
    if (status != DUCT_OK) {
        duct_example_set_done(allocator, &set);
        return status;
    }
    double *samples = duct_alloc(allocator, DUCT_NEIGHBOURHOOD_ROOM(set.reach), sizeof *samples);
    if (samples == NULL) {
        status = duct_fail_memory(error);
    } else {
        duct_query query = {.previous = DUCT_NOWHERE};
        double sum = 0;
        duct_neighbourhood_lay(&query.around[0], samples, set.reach, false);
        for (size_t i = 0; i < even.count; i++) {
            double least = INFINITY;
            duct_neighbourhood_around(&even, (duct_place){i, 0}, set.spacing, set.reach, &query.around[0]);
            for (size_t j = 0; j < set.count; j++) {
                duct_candidate candidate;
                duct_cost_of(&set, &query, j, &candidate);
                least = candidate.cost < least ? candidate.cost : least;
            }
            sum += least;
        }
        *mean = sum / (double)even.count;
    }
    duct_release(allocator, samples);
    duct_curve_done(allocator, &even);
    duct_example_set_done(allocator, &set);
    return status;
}
