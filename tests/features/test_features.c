/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"
#include "features/features.h"
#include "features/velocities.h"

#include <math.h>

enum { COUNT = 200, DIMENSIONS = 32 };

static const duct_feature_options options = {DUCT_FEATURE_VELOCITIES, 40, 0.3};

static void make_curve(double *x, double *y, size_t count, double shift)
{
    double at_x = shift, at_y = -shift;
    for (size_t i = 0; i < count; i++) {
        double angle = 3 * sin(0.05 * (double)i);
        at_x += i > 0 ? cos(angle) : 0;
        at_y += i > 0 ? sin(angle) : 0;
        x[i] = at_x;
        y[i] = at_y;
    }
}

static void centres_grow_geometrically_to_the_reach(void **state)
{
    (void)state;
    static const double reaches[] = {7, 12, 25, 40, 100};
    for (size_t r = 0; r < 5; r++) {
        duct_velocity_filter filter;
        duct_velocity_filter_init(&filter, reaches[r]);
        assert_int_equal(filter.centres[0], 0);
        assert_int_equal(filter.centres[DUCT_VELOCITY_TAPS], (long)reaches[r]);
        for (int i = 1; i < DUCT_VELOCITY_TAPS + 1; i++) {
            /* Each step is at least the one before, up to rounding. */
            assert_true(filter.centres[i + 1] - filter.centres[i] >=
                        filter.centres[i] - filter.centres[i - 1] - 1);
            assert_true(filter.centres[i] > filter.centres[i - 1]);
        }
    }
}

/* "all the weights applied to a single velocity sum to one": an impulse in the velocity, seen from every
 * sample around it, adds up over a tap's samples to the tap's share; here the shares of all taps at one
 * sample are summed instead, by giving each of the other samples in turn the impulse. */
static void weights_of_a_velocity_sum_to_one(void **state)
{
    (void)state;
    duct_velocity_filter filter;
    duct_velocity_filter_init(&filter, 40);
    for (long offset = -40; offset <= 40; offset++) {
        double x[COUNT], y[COUNT], sum = 0;
        memset(x, 0, sizeof x);
        memset(y, 0, sizeof y);
        for (size_t i = (size_t)(100 + offset); i < COUNT; i++) {
            x[i] = 1; /* velocity 1 at sample 100 + offset only */
        }
        float taps[DUCT_VELOCITY_DIMENSIONS];
        duct_velocity_taps(&filter, x, y, COUNT, 100, 1, taps);
        for (int tap = -DUCT_VELOCITY_TAPS; tap <= DUCT_VELOCITY_TAPS; tap++) {
            /* A tap is a mean: times the sum of its triangle it is the weighted sum. */
            int side = abs(tap);
            long inner = side > 0 ? filter.centres[side] - filter.centres[side - 1] : 1;
            long outer = side > 0 ? filter.centres[side + 1] - filter.centres[side] : 1;
            double area = 0.5 * (double)(inner + outer);
            sum += (double)taps[2 * (tap + DUCT_VELOCITY_TAPS)] * area;
        }
        assert_true(fabs(sum - 1) < 1e-6);
    }
}

static void a_straight_line_has_unit_taps_inside(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = 0.6 * (double)i;
        y[i] = 0.8 * (double)i;
    }
    duct_velocity_filter filter;
    duct_velocity_filter_init(&filter, 40);
    float taps[DUCT_VELOCITY_DIMENSIONS];
    duct_velocity_taps(&filter, x, y, COUNT, 100, 0.3, taps);
    for (size_t i = 0; i < DUCT_VELOCITY_DIMENSIONS; i += 2) {
        assert_true(fabs((double)taps[i] - 0.18) < 1e-6 && fabs((double)taps[i + 1] - 0.24) < 1e-6);
    }
    /* At the first sample all history taps but the sample itself lie outside: 0. */
    duct_velocity_taps(&filter, x, y, COUNT, 0, 0.3, taps);
    for (size_t i = 0; i < 2 * DUCT_VELOCITY_TAPS; i++) {
        assert_true(taps[i] == 0);
    }
    /* The last future tap, partly outside near the end, is still the mean of what is inside. */
    duct_velocity_taps(&filter, x, y, COUNT, COUNT - 20, 0.3, taps);
    assert_true(fabs((double)taps[2 * (DUCT_VELOCITY_TAPS + 5)] - 0.18) < 1e-6);
}

static void ends_are_told_from_the_middle(void **state)
{
    (void)state;
    duct_error error;
    double x[COUNT], y[COUNT];
    static float rows[COUNT * DIMENSIONS];
    make_curve(x, y, COUNT, 0);
    assert_int_equal(duct_feature_dimensions(&options), DIMENSIONS);
    assert_ok(duct_features_compute(duct_allocator_of(NULL), &options, x, y, COUNT, rows, &error));
    assert_true(rows[0] == 0 && rows[1] == 1);
    assert_true(rows[(COUNT - 1) * DIMENSIONS + 1] == 0 && rows[(COUNT - 1) * DIMENSIONS] == 1);
    assert_true(fabs((double)rows[10 * DIMENSIONS] - sqrt(10.0 / 40)) < 1e-3);
    assert_true(rows[100 * DIMENSIONS] == 1 && rows[100 * DIMENSIONS + 1] == 1);
}

static void features_do_not_depend_on_the_place(void **state)
{
    (void)state;
    duct_error error;
    double x[COUNT], y[COUNT];
    static float here[COUNT * DIMENSIONS], there[COUNT * DIMENSIONS];
    make_curve(x, y, COUNT, 0);
    assert_ok(duct_features_compute(duct_allocator_of(NULL), &options, x, y, COUNT, here, &error));
    make_curve(x, y, COUNT, 12345);
    assert_ok(duct_features_compute(duct_allocator_of(NULL), &options, x, y, COUNT, there, &error));
    for (size_t i = 0; i < COUNT * DIMENSIONS; i++) {
        assert_true(fabs((double)here[i] - (double)there[i]) < 1e-5);
    }
}

static void direction_matters(void **state)
{
    (void)state;
    duct_error error;
    double x[COUNT], y[COUNT];
    static float there[COUNT * DIMENSIONS], back[COUNT * DIMENSIONS];
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = (double)i;
        y[i] = 0;
    }
    assert_ok(duct_features_compute(duct_allocator_of(NULL), &options, x, y, COUNT, there, &error));
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = -(double)i;
    }
    assert_ok(duct_features_compute(duct_allocator_of(NULL), &options, x, y, COUNT, back, &error));
    assert_true(there[100 * DIMENSIONS + 16] == -back[100 * DIMENSIONS + 16]);
    assert_true(there[100 * DIMENSIONS + 16] > 0.29f);
}

/* All samples at once are what one after the other is, to the bit. */
static void a_whole_stroke_is_its_samples(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 2, 3, 4, 5, 9, 61, COUNT};
    static const double reaches[] = {7, 12, 40, 200};
    duct_error error;
    double x[COUNT], y[COUNT];
    float all[COUNT * DIMENSIONS], one[DIMENSIONS - 2];
    make_curve(x, y, COUNT, 0.3);
    for (size_t r = 0; r < 4; r++) {
        const duct_feature_options wanted = {DUCT_FEATURE_VELOCITIES, reaches[r], 0.3};
        duct_velocity_filter filter;
        duct_velocity_filter_init(&filter, reaches[r]);
        for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
            assert_ok(duct_features_compute(duct_allocator_of(NULL), &wanted, x, y, counts[c], all, &error));
            for (size_t i = 0; i < counts[c]; i++) {
                duct_velocity_taps(&filter, x, y, counts[c], i, 0.3, one);
                assert_memory_equal(all + i * DIMENSIONS + 2, one, sizeof one);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(centres_grow_geometrically_to_the_reach),
        cmocka_unit_test(weights_of_a_velocity_sum_to_one),
        cmocka_unit_test(a_straight_line_has_unit_taps_inside),
        cmocka_unit_test(ends_are_told_from_the_middle),
        cmocka_unit_test(features_do_not_depend_on_the_place),
        cmocka_unit_test(direction_matters),
        cmocka_unit_test(a_whole_stroke_is_its_samples),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
