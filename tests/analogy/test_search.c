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
        float *bounds = malloc(set->count * sizeof *bounds);
        for (double t = 0.2; t < 0.8; t += 0.05) {
            duct_query query;
            make_query(set, curves, t, samples, &query);
            duct_basis_bounds(set, &query, scratch, bounds);
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

/* Issue's measure: the mean energy within 1 percent of the reference's, over several courses. */
static void fast_results_cost_what_exact_ones_do(void **state)
{
    (void)state;
    duct_error error;
    double exact = 0, fast = 0;
    duct_curve_pair pair = make_waves(250, false);
    for (unsigned run = 0; run < 6; run++) {
        duct_analogy_options options = duct_analogy_options_default();
        options.seed = run;
        options.shape_weight = run % 2 == 0 ? 0 : 2;
        duct_curve course = make_course(200, 160 + 20 * run, 0.3 + 0.1 * run);
        for (int kind = 0; kind < 2; kind++) {
            duct_curve result;
            duct_analogy_figures figures;
            options.exact = kind == 1;
            duct_analogy *model = make_model(&pair, &options);
            assert_ok(duct_analogy_apply(model, &course, 1, NULL, 0, &result, &figures, &error));
            *(kind == 1 ? &exact : &fast) += figures.energy;
            free_curve(&result);
            duct_analogy_free(model);
        }
        free_curve(&course);
    }
    print_message("energy: fast %.4g, exact %.4g\n", fast / 6, exact / 6);
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
