/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "report/correlation.h"

#include <math.h>

static void proportional_runs_correlate_fully(void **state)
{
    (void)state;
    double a[25], b[25], c[25], r;
    for (size_t i = 0; i < 25; i++) {
        a[i] = sin(0.3 * (double)i);
        b[i] = 0.2 + 0.01 * a[i];
        c[i] = 5 - 3 * a[i];
    }
    assert_true(duct_correlate(a, b, 25, false, &r));
    assert_true(fabs(r - 1) < 1e-9);
    assert_true(duct_correlate(a, c, 25, false, &r));
    assert_true(fabs(r + 1) < 1e-9);
}

static void coefficient_is_that_of_the_textbook(void **state)
{
    (void)state;
    /* Sums by hand: means 3 and 4, xx 10, yy 10, xy 6. */
    double x[] = {1, 2, 3, 4, 5}, y[] = {2, 4, 5, 4, 5}, r;
    assert_true(duct_correlate(x, y, 5, false, &r));
    assert_true(fabs(r - 6 / sqrt(10.0 * 6.0)) < 1e-12);
}

static void constant_runs_have_no_coefficient(void **state)
{
    (void)state;
    double flat[25], wave[25], faint[25], r = 7;
    for (size_t i = 0; i < 25; i++) {
        flat[i] = 0.1;
        wave[i] = sin((double)i);
        faint[i] = 1e6 + 1e-9 * (double)(i % 2);
    }
    assert_false(duct_correlate(flat, wave, 25, false, &r));
    assert_false(duct_correlate(wave, flat, 25, false, &r));
    assert_false(duct_correlate(faint, wave, 25, false, &r));
    assert_false(duct_correlate(wave, wave, 0, false, &r));
    assert_false(duct_correlate(wave, wave, 1, false, &r));
    assert_true(r == 7);
}

static void last_digits_of_a_tablet_have_no_coefficient(void **state)
{
    (void)state;
    double step[25], small[25], r = 7;
    for (size_t i = 0; i < 25; i++) {
        step[i] = 0.4 + (i > 12 ? 1.0 / 1024 : 0);
        small[i] = 0.4 + (i > 12 ? 3.0 / 1024 : 0);
    }
    assert_false(duct_correlate(step, small, 25, false, &r));
    assert_false(duct_correlate(small, step, 25, false, &r));
    assert_true(duct_correlate(small, small, 25, false, &r));
    assert_false(duct_correlate(small, small, 25, true, &r)); /* as an angle, a twelfth of a degree about */
}

static void not_a_number_has_no_coefficient(void **state)
{
    (void)state;
    double bad[] = {1, NAN, 3, 4}, good[] = {1, 2, 4, 3}, r = 7;
    assert_false(duct_correlate(bad, good, 4, false, &r));
    assert_false(duct_correlate(good, bad, 4, true, &r));
}

static void angles_are_unwrapped(void **state)
{
    (void)state;
    double a[25], b[25], r;
    for (size_t i = 0; i < 25; i++) {
        double turn = 3.0 + 0.3 * sin(0.3 * (double)i);
        a[i] = turn;
        b[i] = remainder(turn, 2 * M_PI);
    }
    assert_true(duct_correlate(a, b, 25, true, &r));
    assert_true(fabs(r - 1) < 1e-9);
    assert_true(duct_correlate(a, b, 25, false, &r));
    assert_true(r < 0.9);
}

static void averages_are_those_of_z(void **state)
{
    (void)state;
    duct_fisher fisher = {0, 0}, other = {0, 0};
    assert_true(isnan(duct_fisher_mean(&fisher)));
    duct_fisher_add(&fisher, 0.9);
    duct_fisher_add(&fisher, 0.1);
    double expected = tanh((atanh(0.9) + atanh(0.1)) / 2);
    assert_true(fabs(duct_fisher_mean(&fisher) - expected) < 1e-12);
    duct_fisher_add(&other, -0.4);
    duct_fisher_add(&other, 0.6);
    duct_fisher_add_mean(&fisher, &other);
    double mean = (atanh(-0.4) + atanh(0.6)) / 2;
    assert_true(fabs(duct_fisher_mean(&fisher) - tanh((atanh(0.9) + atanh(0.1) + mean) / 3)) < 1e-12);
    duct_fisher_add_mean(&fisher, &(duct_fisher){0, 0});
    assert_int_equal(fisher.count, 3);
}

static void full_correlation_stays_finite(void **state)
{
    (void)state;
    duct_fisher fisher = {0, 0};
    duct_fisher_add(&fisher, 1);
    assert_true(duct_fisher_mean(&fisher) < 1 && duct_fisher_mean(&fisher) > 0.99);
    duct_fisher_add(&fisher, -1);
    assert_true(fabs(duct_fisher_mean(&fisher)) < 1e-12);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(proportional_runs_correlate_fully),
        cmocka_unit_test(coefficient_is_that_of_the_textbook),
        cmocka_unit_test(constant_runs_have_no_coefficient),
        cmocka_unit_test(last_digits_of_a_tablet_have_no_coefficient),
        cmocka_unit_test(not_a_number_has_no_coefficient),
        cmocka_unit_test(angles_are_unwrapped),
        cmocka_unit_test(averages_are_those_of_z),
        cmocka_unit_test(full_correlation_stays_finite),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
