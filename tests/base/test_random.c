/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include <ductus/random.h>

#include <math.h>

/* Chi-square of 64 cells; mean 63, standard deviation 11.2. */
static double chi_square(const size_t cells[64], size_t count)
{
    double sum = 0, expected = (double)count / 64;
    for (int i = 0; i < 64; i++) {
        sum += ((double)cells[i] - expected) * ((double)cells[i] - expected) / expected;
    }
    return sum;
}

static void uniform_numbers_are_equidistributed_along_each_argument(void **state)
{
    (void)state;
    enum { COUNT = 64000 };
    for (int argument = 0; argument < 4; argument++) {
        size_t cells[64] = {0};
        double sum = 0;
        for (uint64_t i = 0; i < COUNT; i++) {
            double u = duct_random_uniform(argument == 0 ? i : 7, argument == 1 ? i : 7,
                                           argument == 2 ? i : 7, argument == 3 ? i : 7);
            assert_true(u >= 0 && u < 1);
            cells[(size_t)(u * 64)]++;
            sum += u;
        }
        double chi = chi_square(cells, COUNT);
        assert_true(chi > 25 && chi < 120);
        assert_true(fabs(sum / COUNT - 0.5) < 0.005);
    }
}

static void neighbouring_addresses_are_independent(void **state)
{
    (void)state;
    size_t cells[64] = {0};
    enum { COUNT = 64000 };
    for (uint64_t i = 0; i < COUNT; i++) {
        double a = duct_random_uniform(1, 2, i, 3), b = duct_random_uniform(1, 2, i + 1, 3);
        cells[(size_t)(a * 8) * 8 + (size_t)(b * 8)]++;
    }
    double chi = chi_square(cells, COUNT);
    assert_true(chi > 20 && chi < 130);
    /* Arguments are not interchangeable. */
    assert_true(duct_random_bits(1, 2, 3, 4) != duct_random_bits(2, 1, 3, 4));
    assert_true(duct_random_bits(1, 2, 3, 4) != duct_random_bits(1, 3, 2, 4));
    assert_true(duct_random_bits(1, 2, 3, 4) != duct_random_bits(1, 2, 4, 3));
}

static void the_order_of_calls_does_not_matter(void **state)
{
    (void)state;
    uint64_t forwards[100];
    for (uint64_t i = 0; i < 100; i++) {
        forwards[i] = duct_random_bits(5, 6, i, 7);
    }
    for (uint64_t i = 100; i-- > 0;) {
        assert_true(duct_random_bits(5, 6, i, 7) == forwards[i]);
    }
}

static void numbers_are_the_same_on_every_machine(void **state)
{
    (void)state;
    /* FNV-1a's published values. */
    assert_true(duct_random_id(NULL) == 0xcbf29ce484222325u);
    assert_true(duct_random_id("") == 0xcbf29ce484222325u);
    assert_true(duct_random_id("a") == 0xaf63dc4c8601ec8cu);
    assert_true(duct_random_id("foobar") == 0x85944171f73967e8u);
    assert_true(duct_random_bits(0, 0, 0, 0) == duct_random_bits(0, 0, 0, 0));
}

static void normal_numbers_have_mean_0_and_deviation_1(void **state)
{
    (void)state;
    enum { COUNT = 100000 };
    double sum = 0, squares = 0, fourth = 0;
    size_t beyond = 0;
    for (uint64_t i = 0; i < COUNT; i++) {
        double n = duct_random_normal(3, 4, i, 5);
        assert_true(isfinite(n));
        sum += n;
        squares += n * n;
        fourth += n * n * n * n;
        beyond += fabs(n) > 1.959964;
    }
    assert_true(fabs(sum / COUNT) < 0.015);
    assert_true(fabs(squares / COUNT - 1) < 0.02);
    assert_true(fabs(fourth / COUNT - 3) < 0.15);
    assert_true(beyond > COUNT * 0.046 && beyond < COUNT * 0.054);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(uniform_numbers_are_equidistributed_along_each_argument),
        cmocka_unit_test(neighbouring_addresses_are_independent),
        cmocka_unit_test(the_order_of_calls_does_not_matter),
        cmocka_unit_test(numbers_are_the_same_on_every_machine),
        cmocka_unit_test(normal_numbers_have_mean_0_and_deviation_1),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
