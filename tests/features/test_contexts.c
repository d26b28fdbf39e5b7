/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"
#include "features/contexts.h"
#include "features/features.h"

#include <math.h>

enum { COUNT = 200, MIDDLE = 100, REACH = 40 };

static const duct_feature_options options = {DUCT_FEATURE_CONTEXTS, REACH, 0.3};
static const duct_feature_options velocities = {DUCT_FEATURE_VELOCITIES, REACH, 0.3};

static void make_curve(double *x, double *y, size_t count, double turn)
{
    double at_x = 3, at_y = 4;
    for (size_t i = 0; i < count; i++) {
        double angle = 2 * sin(0.07 * (double)i) + turn;
        at_x += i > 0 ? cos(angle) : 0;
        at_y += i > 0 ? sin(angle) : 0;
        x[i] = at_x;
        y[i] = at_y;
    }
}

static void make_line(double *x, double *y, size_t count, double angle)
{
    for (size_t i = 0; i < count; i++) {
        x[i] = cos(angle) * (double)i;
        y[i] = sin(angle) * (double)i;
    }
}

/* The two histograms of a sample, with counts divided by the window's samples. */
static void histograms(const double *x, const double *y, size_t i, float bins[DUCT_CONTEXT_DIMENSIONS])
{
    duct_context_histograms(x, y, COUNT, i, REACH, 1 / DUCT_CONTEXT_SCALE, bins);
}

static double sum_of(const float *bins, size_t count)
{
    double sum = 0;
    for (size_t b = 0; b < count; b++) {
        sum += (double)bins[b];
    }
    return sum;
}

static double sector_of(const float *bins, size_t sector)
{
    double sum = 0;
    for (size_t ring = 0; ring < DUCT_CONTEXT_RINGS; ring++) {
        sum += (double)bins[ring * DUCT_CONTEXT_SECTORS + sector];
    }
    return sum;
}

static bool near(double a, double b)
{
    return fabs(a - b) < 1e-5;
}

static void vectors_have_62_dimensions(void **state)
{
    (void)state;
    assert_int_equal(duct_feature_dimensions(&options), 62);
    assert_int_equal(duct_feature_past_dimensions(&options), 32);
    assert_int_equal(duct_feature_dimensions(&velocities), 32);
    assert_int_equal(duct_feature_past_dimensions(&velocities), 18);
}

/* Also where the window is cut off by an end: a short stroke counts as much as a long one. */
static void each_histogram_counts_its_samples_once(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    float bins[DUCT_CONTEXT_DIMENSIONS];
    make_curve(x, y, COUNT, 0);
    for (size_t i = 0; i < COUNT; i++) {
        histograms(x, y, i, bins);
        assert_true(near(sum_of(bins, DUCT_CONTEXT_BINS), i > 0 ? 1 : 0));
        assert_true(near(sum_of(bins + DUCT_CONTEXT_BINS, DUCT_CONTEXT_BINS), i + 1 < COUNT ? 1 : 0));
        for (size_t b = 0; b < DUCT_CONTEXT_DIMENSIONS; b++) {
            assert_true(bins[b] >= 0);
        }
    }
}

static void history_and_future_lie_on_their_own_sides(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    float bins[DUCT_CONTEXT_DIMENSIONS];
    make_line(x, y, COUNT, 0);
    histograms(x, y, MIDDLE, bins);
    /* To the right: what came before lies to the left, in the sector across. */
    assert_true(near(sector_of(bins, 3), 1));
    assert_true(near(sector_of(bins + DUCT_CONTEXT_BINS, 0), 1));
    make_line(x, y, COUNT, M_PI);
    histograms(x, y, MIDDLE, bins);
    assert_true(near(sector_of(bins, 0), 1));
    assert_true(near(sector_of(bins + DUCT_CONTEXT_BINS, 3), 1));
}

/* Section 3.3: directions are the page's. */
static void turned_shapes_are_other_shapes(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    float straight[DUCT_CONTEXT_DIMENSIONS], turned[DUCT_CONTEXT_DIMENSIONS];
    make_curve(x, y, COUNT, 0.2);
    histograms(x, y, MIDDLE, straight);
    make_curve(x, y, COUNT, 0.2 + M_PI / 3);
    histograms(x, y, MIDDLE, turned);
    double difference = 0;
    for (size_t b = 0; b < DUCT_CONTEXT_DIMENSIONS; b++) {
        /* By one sector exactly. */
        size_t moved = b / DUCT_CONTEXT_SECTORS * DUCT_CONTEXT_SECTORS + (b + 1) % DUCT_CONTEXT_SECTORS;
        assert_true(near((double)straight[b], (double)turned[moved]));
        difference += fabs((double)straight[b] - (double)turned[b]);
    }
    assert_true(difference > 0.5);
}

static void rings_double_in_width(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    float bins[DUCT_CONTEXT_DIMENSIONS];
    make_line(x, y, COUNT, 0);
    histograms(x, y, MIDDLE, bins);
    const float *ring = bins + DUCT_CONTEXT_BINS;
    for (size_t r = 2; r < DUCT_CONTEXT_RINGS; r++) {
        /* A line has twice as many samples in a ring that is twice as wide; sharing blurs this a little. */
        double ratio = (double)ring[r * DUCT_CONTEXT_SECTORS] / (double)ring[(r - 1) * DUCT_CONTEXT_SECTORS];
        assert_true(ratio > 1.4 && ratio < 3);
    }
}

/* A sample that crosses from bin to bin changes the vector steadily. */
static void vectors_change_steadily(void **state)
{
    (void)state;
    double x[2] = {0, 0}, y[2] = {0, 0}, most = 0;
    float before[DUCT_CONTEXT_DIMENSIONS], now[DUCT_CONTEXT_DIMENSIONS];
    for (int step = 0; step < 4000; step++) {
        double angle = 0.01 * step, distance = 0.01 * step;
        x[1] = distance * cos(angle);
        y[1] = distance * sin(angle);
        duct_context_histograms(x, y, 2, 0, REACH, 1 / DUCT_CONTEXT_SCALE, now);
        for (size_t b = 0; step > 0 && b < DUCT_CONTEXT_DIMENSIONS; b++) {
            most = fmax(most, fabs((double)now[b] - (double)before[b]));
        }
        memcpy(before, now, sizeof now);
    }
    assert_true(most < 0.03);
}

static void samples_in_one_place_have_no_direction(void **state)
{
    (void)state;
    double x[COUNT], y[COUNT];
    float bins[DUCT_CONTEXT_DIMENSIONS];
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = y[i] = 7;
    }
    histograms(x, y, MIDDLE, bins);
    for (size_t s = 0; s < DUCT_CONTEXT_SECTORS; s++) {
        assert_true(near((double)bins[s], 1.0 / DUCT_CONTEXT_SECTORS));
    }
    assert_true(near(sum_of(bins, DUCT_CONTEXT_BINS), 1));
}

static void survives_far_places_and_numbers_that_are_none(void **state)
{
    (void)state;
    static const double places[] = {1e308, -1e308, INFINITY, NAN, 5e-324};
    for (size_t p = 0; p < 5; p++) {
        double x[3] = {0, places[p], 1}, y[3] = {0, -places[p], 2};
        float bins[DUCT_CONTEXT_DIMENSIONS];
        for (size_t i = 0; i < 3; i++) {
            duct_context_histograms(x, y, 3, i, 7, 0.3, bins);
        }
    }
    double x[2] = {-1e308, 1e308}, y[2] = {0, 0};
    float bins[DUCT_CONTEXT_DIMENSIONS];
    duct_context_histograms(x, y, 2, 0, 7, 0.3, bins);
    for (size_t b = 0; b < DUCT_CONTEXT_DIMENSIONS; b++) {
        assert_true(isfinite(bins[b]));
    }
}

/* What a stream relies on: the vector's beginning is known when the sample is drawn. */
static void the_beginning_needs_no_future(const duct_feature_options *kind)
{
    duct_error error;
    double x[COUNT], y[COUNT];
    make_curve(x, y, COUNT, 0);
    size_t dimensions = duct_feature_dimensions(kind), past = duct_feature_past_dimensions(kind);
    float *rows = calloc(COUNT * dimensions, sizeof *rows), row[DUCT_FEATURE_MOST_DIMENSIONS];
    assert_ok(duct_features_compute(duct_allocator_of(NULL), kind, x, y, COUNT, rows, &error));
    duct_feature_maker maker;
    duct_feature_maker_init(&maker, kind);
    size_t span = duct_feature_span(&maker);
    for (size_t i = 0; i + REACH + 5 < COUNT; i++) {
        size_t first = i > span ? i - span : 0;
        duct_feature_row(&maker, x + first, y + first, i - first + 1, i - first, (double)i, INFINITY, row);
        for (size_t d = 0; d < dimensions; d++) {
            assert_true(d < past ? near((double)row[d], (double)rows[i * dimensions + d]) : row[d] == 0);
        }
    }
    free(rows);
}

static void the_beginning_of_every_kind_needs_no_future(void **state)
{
    (void)state;
    the_beginning_needs_no_future(&options);
    the_beginning_needs_no_future(&velocities);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    double x[COUNT], y[COUNT];
    static float rows[COUNT * 62];
    make_curve(x, y, COUNT, 0);
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        status = duct_features_compute(&failing.allocator, &options, x, y, COUNT, rows, &error);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 20);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(vectors_have_62_dimensions),
        cmocka_unit_test(each_histogram_counts_its_samples_once),
        cmocka_unit_test(history_and_future_lie_on_their_own_sides),
        cmocka_unit_test(turned_shapes_are_other_shapes),
        cmocka_unit_test(rings_double_in_width),
        cmocka_unit_test(vectors_change_steadily),
        cmocka_unit_test(samples_in_one_place_have_no_direction),
        cmocka_unit_test(survives_far_places_and_numbers_that_are_none),
        cmocka_unit_test(the_beginning_of_every_kind_needs_no_future),
        cmocka_unit_test(survives_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
