/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curve analogies as a whole: what has to hold whatever the style. */
#include "curves.h"

#include <float.h>

static duct_analogy_options plain_options(void)
{
    duct_analogy_options options = duct_analogy_options_default();
    options.randomness = 0;
    return options;
}

static duct_curve apply(const duct_analogy *model, const duct_curve *b,
                        const duct_curve_constraint *constraints, size_t count)
{
    duct_error error;
    duct_curve result;
    assert_ok(duct_analogy_apply(model, b, 7, constraints, count, &result, NULL, &error));
    return result;
}

static void turn(duct_curve *curve, double angle, double dx, double dy)
{
    double c = cos(angle), s = sin(angle);
    for (size_t i = 0; i < curve->count; i++) {
        double x = curve->x[i], y = curve->y[i];
        curve->x[i] = c * x - s * y + dx;
        curve->y[i] = s * x + c * y + dy;
    }
}

/* The largest distance of two curves at the same share of their lengths. */
static double apart(const duct_curve *a, const duct_curve *b)
{
    double most = 0;
    size_t count = 400, hint_a = 0, hint_b = 0;
    for (size_t i = 0; i <= count; i++) {
        double t = (double)i / (double)count, ax, ay, bx, by;
        duct_curve_point(a, duct_curve_find(a, t, &hint_a), &ax, &ay);
        duct_curve_point(b, duct_curve_find(b, t, &hint_b), &bx, &by);
        most = fmax(most, hypot(ax - bx, ay - by));
    }
    return most;
}

static void moving_and_turning_the_inputs_moves_and_turns_the_output(void **state)
{
    (void)state;
    duct_analogy_options options = plain_options();
    options.shape_weight = 2; /* with 0, equal places of a straight A decide by rounding */
    const double moves[][3] = {{0, 300, -200}, {M_PI / 2, 0, 0}, {1.1, -50, 80}};
    duct_curve_pair pair = make_waves(220, false);
    duct_analogy *model = make_model(&pair, &options);
    duct_curve course = make_course(200, 180, 0.5), first = apply(model, &course, NULL, 0);
    for (size_t m = 0; m < 3; m++) {
        duct_curve moved = make_course(200, 180, 0.5);
        turn(&moved, moves[m][0], moves[m][1], moves[m][2]);
        duct_curve result = apply(model, &moved, NULL, 0), expected = apply(model, &course, NULL, 0);
        turn(&expected, moves[m][0], moves[m][1], moves[m][2]);
        assert_true(apart(&result, &expected) < 1e-3);
        free_curve(&moved);
        free_curve(&result);
        free_curve(&expected);
    }
    free_curve(&first);
    free_curve(&course);
    duct_analogy_free(model);
    free_pair(&pair);
}

static void hard_constraints_are_met_and_soft_ones_pull(void **state)
{
    (void)state;
    duct_analogy_options options = plain_options();
    duct_curve_pair pair = make_waves(220, false);
    duct_analogy *model = make_model(&pair, &options);
    duct_curve course = make_course(200, 200, 0.4);
    double mid_x = course.x[100] + 6, mid_y = course.y[100] - 9;
    const duct_curve_constraint hard[] = {{0, course.x[0], course.y[0] + 4, INFINITY},
                                          {course.t[100], mid_x, mid_y, INFINITY},
                                          {1, course.x[199] - 3, course.y[199], INFINITY}};
    duct_curve met = apply(model, &course, hard, 3);
    for (size_t c = 0; c < 3; c++) {
        double x, y;
        size_t hint = 0;
        duct_curve_point(&met, duct_curve_find(&met, hard[c].t, &hint), &x, &y);
        assert_true(hypot(x - hard[c].x, y - hard[c].y) < 1e-6);
    }
    /* No spike: steps stay of the size of the spacing. */
    double longest = 0;
    for (size_t i = 1; i < met.count; i++) {
        longest = fmax(longest, hypot(met.x[i] - met.x[i - 1], met.y[i] - met.y[i - 1]));
    }
    print_message("longest step with hard constraints: %.3g\n", longest);
    assert_true(longest < 6 * options.spacing);
    duct_curve_constraint soft = {course.t[100], mid_x, mid_y, 0};
    double last = INFINITY;
    const double weights[] = {1e-6, 1, 100};
    for (size_t w = 0; w < 3; w++) {
        soft.weight = weights[w];
        double x, y;
        size_t hint = 0;
        duct_curve pulled = apply(model, &course, &soft, 1);
        duct_curve_point(&pulled, duct_curve_find(&pulled, soft.t, &hint), &x, &y);
        assert_true(hypot(x - mid_x, y - mid_y) < last);
        last = hypot(x - mid_x, y - mid_y);
        free_curve(&pulled);
    }
    assert_true(last < 0.5);
    free_curve(&met);
    free_curve(&course);
    duct_analogy_free(model);
    free_pair(&pair);
}

static void contradictory_constraints_are_refused_in_one_sentence(void **state)
{
    (void)state;
    duct_error error;
    duct_analogy_options options = plain_options();
    duct_curve_pair pair = make_waves(220, false);
    duct_analogy *model = make_model(&pair, &options);
    duct_curve course = make_course(200, 200, 0.4), result;
    const duct_curve_constraint both[] = {{0.5, 1, 2, INFINITY}, {0.5, 3, 4, INFINITY}};
    assert_int_equal(duct_analogy_apply(model, &course, 0, both, 2, &result, NULL, &error), DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "contradict"));
    free_curve(&course);
    duct_analogy_free(model);
    free_pair(&pair);
}

static void closed_curves_stay_closed_without_a_seam(void **state)
{
    (void)state;
    duct_analogy_options options = plain_options();
    duct_curve_pair pair = make_waves(260, false);
    duct_analogy *model = make_model(&pair, &options);
    duct_curve ring = make_curve(120, true, false);
    for (size_t i = 0; i < ring.count; i++) {
        double angle = 2 * M_PI * (double)i / 120;
        ring.x[i] = 60 * cos(angle);
        ring.y[i] = 45 * sin(angle);
    }
    duct_curve_use_arc_length(&ring);
    duct_curve result = apply(model, &ring, NULL, 0);
    assert_true(result.closed);
    double longest = 0,
           join = hypot(result.x[0] - result.x[result.count - 1], result.y[0] - result.y[result.count - 1]);
    for (size_t i = 1; i < result.count; i++) {
        longest = fmax(longest, hypot(result.x[i] - result.x[i - 1], result.y[i] - result.y[i - 1]));
    }
    assert_true(join <= longest);
    /* The wave goes all around: the radius swings. */
    assert_true(duct_curve_length(&result) > 1.3 * duct_curve_length(&ring));
    free_curve(&result);
    free_curve(&ring);
    duct_analogy_free(model);
    free_pair(&pair);
}

/* The neighbourhoods of B' look like those of the example: as much as those of a half of the example look
 * like the other half, within a factor, and far more than those of a line of no such style. */
static void results_look_like_the_example(void **state)
{
    (void)state;
    duct_error error;
    duct_analogy_options options = plain_options();
    duct_curve_pair pair = make_waves(400, false);
    duct_analogy *model = make_model(&pair, &options);
    duct_curve course = make_course(300, 260, 0.3);
    duct_analogy_figures figures;
    duct_curve result;
    assert_ok(duct_analogy_apply(model, &course, 7, NULL, 0, &result, &figures, &error));
    duct_curve_pair half = make_waves(400, false), rest = make_waves(400, false);
    half.a.count = half.b.count = 200;
    for (size_t i = 200; i <= 400; i++) {
        rest.b.x[i - 200] = rest.b.x[i];
        rest.b.y[i - 200] = rest.b.y[i];
    }
    rest.b.count = 201;
    /* Compared at a scale at which the waves show. */
    duct_analogy_options coarse = options;
    coarse.spacing = 3;
    duct_analogy *of_half = make_model(&half, &coarse), *of_all = make_model(&pair, &coarse);
    /* A line of no such style: as long, but jagged. */
    duct_curve other = make_course(90, 260, 0.3);
    for (size_t i = 0; i < other.count; i++) {
        other.y[i] += i % 2 == 0 ? 3 : -3;
    }
    double made, held_out, jagged;
    assert_ok(duct_analogy_likeness(of_all, &result, &made, &error));
    assert_ok(duct_analogy_likeness(of_half, &rest.b, &held_out, &error));
    assert_ok(duct_analogy_likeness(of_all, &other, &jagged, &error));
    print_message("likeness: made %.3g, held out %.3g, jagged %.3g; runs of %.3g points\n", made, held_out,
                  jagged, figures.copied);
    assert_true(made < jagged / 4);
    assert_true(made < 12 * held_out);
    assert_true(figures.copied > 6);
    duct_analogy_free(of_half);
    duct_analogy_free(of_all);
    free_curve(&other);
    free_pair(&half);
    free_pair(&rest);
    free_curve(&result);
    free_curve(&course);
    duct_analogy_free(model);
    free_pair(&pair);
}

static void new_curves_have_their_length_and_differ_by_seed(void **state)
{
    (void)state;
    duct_error error;
    duct_curve_pair pair = make_waves(250, true);
    duct_curve alone[2];
    free_curve(&pair.a);
    pair.a.count = 0;
    duct_curve_use_arc_length(&pair.b);
    for (uint64_t seed = 0; seed < 2; seed++) {
        duct_analogy_options options = duct_analogy_options_default();
        options.seed = seed;
        duct_analogy *model = make_model(&pair, &options);
        assert_ok(duct_analogy_synthesize(model, 900, 1, &alone[seed], NULL, &error));
        double length = duct_curve_length(&alone[seed]), like;
        assert_true(length > 600 && length < 1300);
        assert_non_null(alone[seed].extra);
        assert_ok(duct_analogy_likeness(model, &alone[seed], &like, &error));
        print_message("new curve: length %.4g of 900, likeness %.3g\n", length, like);
        duct_curve b;
        assert_int_equal(duct_analogy_apply(model, &alone[seed], 0, NULL, 0, &b, NULL, &error),
                         DUCT_UNSUPPORTED);
        duct_analogy_free(model);
    }
    assert_true(apart(&alone[0], &alone[1]) > 1);
    free_curve(&alone[0]);
    free_curve(&alone[1]);
    free_curve(&pair.b);
}

static void pressure_is_carried_along(void **state)
{
    (void)state;
    duct_analogy_options options = plain_options();
    duct_curve_pair pair = make_waves(250, true);
    duct_analogy *model = make_model(&pair, &options);
    duct_curve course = make_course(200, 200, 0.3), result = apply(model, &course, NULL, 0);
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < result.count; i++) {
        low = fmin(low, result.extra[i]);
        high = fmax(high, result.extra[i]);
    }
    assert_true(low > 0.09 && low < 0.2 && high < 0.91 && high > 0.8);
    free_curve(&result);
    free_curve(&course);
    duct_analogy_free(model);
    free_pair(&pair);
}

static void examples_without_length_are_refused(void **state)
{
    (void)state;
    duct_error error;
    duct_analogy_options options = plain_options();
    duct_analogy *model;
    duct_curve_pair pair = make_waves(100, false);
    assert_int_equal(duct_analogy_new(duct_allocator_of(NULL), &pair, 0, &options, &model, &error),
                     DUCT_UNSUPPORTED);
    pair.b.count = 1;
    assert_int_equal(duct_analogy_new(duct_allocator_of(NULL), &pair, 1, &options, &model, &error),
                     DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "length"));
    free_pair(&pair);
}

/* Curves and examples of a few pixels, and settings at their limits. */
static void extremes_are_survived(void **state)
{
    (void)state;
    duct_error error;
    duct_curve_pair pair = make_waves(12, false);
    for (int kind = 0; kind < 4; kind++) {
        duct_analogy_options options = duct_analogy_options_default();
        options.neighbourhood = kind == 0 ? 5 : kind == 1 ? 401 : 81;
        options.levels = kind == 2 ? 32 : kind == 3 ? 1 : 0;
        duct_analogy *model = make_model(&pair, &options);
        const double lengths[] = {1e-6, 0.3, 3, 40};
        for (size_t l = 0; l < 4; l++) {
            duct_curve course = make_course(20, lengths[l], 0.4), result;
            assert_ok(duct_analogy_apply(model, &course, 0, NULL, 0, &result, NULL, &error));
            for (size_t i = 0; i < result.count; i++) {
                assert_true(isfinite(result.x[i]) && isfinite(result.y[i]));
                assert_true(fabs(result.x[i]) < 200 && fabs(result.y[i]) < 200);
            }
            free_curve(&result);
            free_curve(&course);
        }
        duct_analogy_free(model);
    }
    free_pair(&pair);
}

static void the_nth_allocation_failing_is_survived(void **state)
{
    (void)state;
    duct_curve_pair pair = make_waves(40, true);
    duct_curve course = make_course(40, 30, 0.4);
    const duct_curve_constraint hard = {0, 1, 2, INFINITY};
    duct_analogy_options options = duct_analogy_options_default();
    options.levels = 3;
    long calls = 1;
    for (long n = 0; n <= calls; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_error error = {DUCT_OK, ""};
        duct_analogy *model = NULL;
        duct_curve result = {0};
        duct_status status = duct_analogy_new(&failing.allocator, &pair, 1, &options, &model, &error);
        if (status == DUCT_OK) {
            status = duct_analogy_apply(model, &course, 1, &hard, 1, &result, NULL, &error);
        }
        assert_int_equal(status, n == 0 ? DUCT_OK : DUCT_NO_MEMORY);
        duct_curve_done(&failing.allocator, &result);
        duct_analogy_free(model);
        assert_int_equal(failing.held, 0);
        calls = n == 0 ? failing.calls : calls;
    }
    assert_true(calls > 20);
    free_curve(&course);
    free_pair(&pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(moving_and_turning_the_inputs_moves_and_turns_the_output),
        cmocka_unit_test(hard_constraints_are_met_and_soft_ones_pull),
        cmocka_unit_test(contradictory_constraints_are_refused_in_one_sentence),
        cmocka_unit_test(closed_curves_stay_closed_without_a_seam),
        cmocka_unit_test(results_look_like_the_example),
        cmocka_unit_test(new_curves_have_their_length_and_differ_by_seed),
        cmocka_unit_test(pressure_is_carried_along),
        cmocka_unit_test(examples_without_length_are_refused),
        cmocka_unit_test(extremes_are_survived),
        cmocka_unit_test(the_nth_allocation_failing_is_survived),
    };
    return cmocka_run_group_tests_name("analogy", tests, NULL, NULL);
}
