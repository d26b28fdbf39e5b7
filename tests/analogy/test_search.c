/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fast search beside the exact one. */
#include "curves.h"

#include "analogy/basis.h"
#include "analogy/multiresolution.h"

/* A query of the model's refinement at a level, around a place of a curve. */
static void make_query(const duct_example_set *set, const duct_curve *const curves[DUCT_SLOTS], double t,
                       double *samples, duct_query *query)
{
    size_t room = DUCT_NEIGHBOURHOOD_ROOM(set->reach);
    memset(query, 0, sizeof *query);
    query->previous = DUCT_NOWHERE;
    for (size_t s = 0; s < set->slots; s++) {
        size_t hint = 0;
        duct_neighbourhood_lay(&query->around[s], samples + s * room, set->reach, false);
        duct_neighbourhood_around(curves[s], duct_curve_find(curves[s], t, &hint), set->spacing, set->reach,
                                  &query->around[s]);
    }
}

/* The matching term alone, from the alignments. */
static double matching(const duct_example_set *set, const duct_query *query, size_t j)
{
    double squares = 0, re = 0, im = 0;
    for (size_t s = 0; s < set->slots; s++) {
        duct_alignment sums;
        duct_align(&set->around[j * set->slots + s], &query->around[s], set->reach,
                   s == 0 ? set->own_weights : set->weights, set->options->tangent_weight, &sums);
        squares += set->slot[s].cost * sums.squares;
        re += set->slot[s].cost * sums.product[0];
        im += set->slot[s].cost * sums.product[1];
    }
    return squares - 2 * (set->options->rotation ? hypot(re, im) : re);
}

static void bounds_are_never_above_the_matching_term(void **state)
{
    (void)state;
    for (int kind = 0; kind < 3; kind++) {
        duct_curve_pair pair = make_waves(400, false);
        duct_analogy_options options = duct_analogy_options_default();
        options.rotation = kind != 1;
        options.shape_weight = kind == 2 ? 2 : 0;
        duct_analogy *model = make_model(&pair, &options);
        const size_t level = 2;
        const duct_example_set *set = &model->refine[level];
        duct_curve course = make_course(300, 300, 0.8);
        const duct_curve *const curves[] = {&course, &course, &course};
        double *samples = malloc(3 * DUCT_NEIGHBOURHOOD_ROOM(set->reach) * sizeof *samples);
        double *scratch = malloc(duct_basis_scratch(set) * sizeof *scratch), tight = 0, all = 0;
        float *bounds = malloc(2 * set->count * sizeof *bounds);
        for (double t = 0.2; t < 0.8; t += 0.05) {
            duct_query query;
            make_query(set, curves, t, samples, &query);
            duct_basis_bounds(set, &query, scratch, bounds, bounds + set->count);
            for (size_t j = 0; j < set->count; j++) {
                bool full = true;
                for (size_t s = 0; s < set->slots; s++) {
                    full = full && duct_neighbourhood_full(&set->around[j * set->slots + s], set->reach);
                }
                if (full) {
                    double truth = matching(set, &query, j);
                    assert_true((double)bounds[j] <= truth + 1e-9 * (1 + truth));
                    tight += (double)bounds[j];
                    all += truth;
                }
            }
        }
        /* And they are worth something. */
        assert_true(tight > 0.5 * all);
        free(samples);
        free(scratch);
        free(bounds);
        free_curve(&course);
        duct_analogy_free(model);
        free_pair(&pair);
    }
}

/* The cost of what the fast search finds, beside what the exact search finds, over places of a curve that was
 * made in the style: the sum within 1 percent. */
static void fast_results_cost_what_exact_ones_do(void **state)
{
    (void)state;
    duct_error error;
    double exact = 0, fast = 0;
    size_t same = 0, all = 0;
    duct_curve_pair pair = make_waves(400, false);
    for (unsigned run = 0; run < 4; run++) {
        duct_analogy_options options = duct_analogy_options_default();
        options.shape_weight = run % 2 == 0 ? 0 : 2;
        options.rotation = run < 3;
        options.randomness = 0;
        duct_analogy *model = make_model(&pair, &options);
        duct_curve course = make_course(200, 260 + 20 * run, 0.3 + 0.1 * run), made;
        assert_ok(duct_analogy_apply(model, &course, 1, NULL, 0, &made, NULL, &error));
        duct_pyramid coarse, plain;
        assert_ok(duct_pyramid_make(duct_allocator_of(NULL), &made, options.spacing, 7, &coarse, &error));
        assert_ok(duct_pyramid_make(duct_allocator_of(NULL), &course, options.spacing, 7, &plain, &error));
        for (size_t level = 0; level < 6; level++) {
            const duct_example_set *set = &model->refine[level];
            const duct_curve *const curves[] = {&coarse.levels[level], &plain.levels[level],
                                                &coarse.levels[level + 1]};
            double *samples = malloc(3 * DUCT_NEIGHBOURHOOD_ROOM(set->reach) * sizeof *samples);
            double *weighted = malloc(3 * DUCT_WEIGHTED_ROOM(set->reach) * sizeof *weighted);
            duct_search_room room;
            assert_ok(duct_search_room_make(duct_allocator_of(NULL), set, &room, &error));
            for (double t = 0; t < 1; t += 0.013) {
                duct_query query;
                duct_candidate found, best;
                make_query(set, curves, t, samples, &query);
                duct_neighbourhood_coverage(&query.around[0], set, &query.before, &query.after);
                for (size_t s = 0; s < 3; s++) {
                    query.weighted[s] = weighted + s * DUCT_WEIGHTED_ROOM(set->reach);
                }
                query.previous = (size_t)(t * 0.9 * (double)set->count);
                query.chord = set->gap;
                duct_search_best(set, &query, -1, DUCT_NOWHERE, &room, &found);
                query.full = false;
                duct_search_exact(set, &query, -1, &room, &best);
                assert_true(found.cost >= best.cost * (1 - 1e-9));
                fast += found.cost;
                exact += best.cost;
                same += found.index == best.index;
                all++;
            }
            duct_search_room_done(duct_allocator_of(NULL), &room);
            free(samples);
            free(weighted);
        }
        duct_pyramid_done(duct_allocator_of(NULL), &coarse);
        duct_pyramid_done(duct_allocator_of(NULL), &plain);
        free_curve(&course);
        free_curve(&made);
        duct_analogy_free(model);
    }
    print_message("cost of the fast search %.5f times the exact one's; the same place %zu of %zu times\n",
                  fast / exact, same, all);
    assert_true(fast < 1.01 * exact);
    free_pair(&pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bounds_are_never_above_the_matching_term),
        cmocka_unit_test(fast_results_cost_what_exact_ones_do),
    };
    return cmocka_run_group_tests_name("analogy_search", tests, NULL, NULL);
}
