/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arc length, uniform sampling, polylines and statistics. */
#include "testing.h"

#include "geometry/polyline.h"
#include "geometry/resample.h"
#include "geometry/statistics.h"

#include <ductus/drawing.h>

#include <math.h>

static duct_drawing *drawing;

static int make_drawing(void **state)
{
    (void)state;
    return duct_drawing_new(NULL, &drawing, NULL);
}

static int free_drawing(void **state)
{
    (void)state;
    duct_drawing_free(drawing);
    return 0;
}

static duct_stroke *make_stroke(size_t count, const double *x, const double *y)
{
    duct_error error;
    duct_stroke *stroke;
    assert_ok(duct_drawing_add_stroke(drawing, "s", count, &stroke, &error));
    memcpy(duct_stroke_edit(stroke, DUCT_X), x, count * sizeof *x);
    memcpy(duct_stroke_edit(stroke, DUCT_Y), y, count * sizeof *y);
    return stroke;
}

static void samples_are_evenly_spaced_and_keep_the_ends(void **state)
{
    (void)state;
    duct_error error;
    static const double x[] = {0, 3, 3, 10}, y[] = {0, 4, 4, 4}; /* 5 + 0 + 7 long, with a point twice */
    duct_stroke *stroke = make_stroke(4, x, y);
    duct_samples samples;
    assert_true(duct_stroke_length(stroke) == 12);
    assert_ok(duct_samples_make(duct_allocator_of(NULL), stroke, 0.97, &samples, &error));
    assert_int_equal(samples.count, 13);
    assert_true(fabs(samples.step - 1) < 1e-12);
    assert_true(fabs(samples.channels[DUCT_X][5] - 3) < 1e-12 &&
                fabs(samples.channels[DUCT_Y][5] - 4) < 1e-12);
    assert_true(samples.channels[DUCT_X][12] == 10 && samples.channels[DUCT_X][0] == 0);
    assert_null(samples.channels[DUCT_PRESSURE]);
    duct_samples_free(duct_allocator_of(NULL), &samples);
}

static void recorded_strokes_are_rounded_and_vector_ones_keep_corners(void **state)
{
    (void)state;
    duct_error error;
    double x[9], y[9];
    for (size_t i = 0; i < 9; i++) { /* a quarter circle of radius 100, in steps far above the unit */
        x[i] = 100 * cos(M_PI / 16 * (double)i);
        y[i] = 100 * sin(M_PI / 16 * (double)i);
    }
    duct_stroke *stroke = make_stroke(9, x, y);
    for (int recorded = 0; recorded < 2; recorded++) {
        if (recorded) {
            double *t = duct_stroke_edit(stroke, DUCT_T);
            for (size_t i = 0; i < 9; i++) {
                t[i] = 0.1 * (double)i;
            }
        }
        duct_samples samples;
        assert_ok(duct_samples_make(duct_allocator_of(NULL), stroke, 1, &samples, &error));
        double worst = 0;
        for (size_t i = samples.count / 4; i < 3 * samples.count / 4; i++) {
            double off = 100 - hypot(samples.channels[DUCT_X][i], samples.channels[DUCT_Y][i]);
            worst = fmax(worst, fabs(off));
        }
        assert_true(recorded ? worst < 0.02 : worst > 0.4);
        duct_samples_free(duct_allocator_of(NULL), &samples);
    }
}

static void closed_strokes_end_where_they_began(void **state)
{
    (void)state;
    duct_error error;
    static const double x[] = {0, 10, 10, 0}, y[] = {0, 0, 10, 10};
    duct_stroke *stroke = make_stroke(4, x, y);
    duct_stroke_set_closed(stroke, true);
    duct_stroke_edit(stroke, DUCT_PRESSURE)[3] = 1;
    duct_samples samples;
    assert_true(duct_stroke_length(stroke) == 40);
    assert_ok(duct_samples_make(duct_allocator_of(NULL), stroke, 1, &samples, &error));
    assert_int_equal(samples.count, 41);
    assert_true(samples.channels[DUCT_X][40] == 0 && samples.channels[DUCT_Y][40] == 0);
    /* The pose holds over the closing side: it does not run back to the start. */
    assert_true(samples.channels[DUCT_PRESSURE][35] == 1);
    duct_samples_free(duct_allocator_of(NULL), &samples);
}

static void strokes_without_length_have_no_samples(void **state)
{
    (void)state;
    duct_error error;
    static const double x[] = {5, 5, 5}, y[] = {1, 1, 1};
    duct_samples samples;
    for (size_t count = 0; count <= 3; count++) {
        assert_ok(duct_samples_make(duct_allocator_of(NULL), make_stroke(count, x, y), 1, &samples, &error));
        assert_int_equal(samples.count, 0);
    }
}

static void too_many_samples_are_a_limit(void **state)
{
    (void)state;
    duct_error error;
    static const double x[] = {0, 1e15}, y[] = {0, 0};
    duct_samples samples;
    assert_int_equal(duct_samples_make(duct_allocator_of(NULL), make_stroke(2, x, y), 1, &samples, &error),
                     DUCT_LIMIT);
    assert_int_equal(samples.count, 0);
}

static void sampling_survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    static const double x[] = {0, 30, 50}, y[] = {0, 0, 20};
    duct_stroke *stroke = make_stroke(3, x, y);
    duct_stroke_edit(stroke, DUCT_T);
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_samples samples;
        status = duct_samples_make(&failing.allocator, stroke, 1, &samples, &error);
        duct_samples_free(&failing.allocator, &samples);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 100);
    }
}

/* The sum of squared distances and vertex costs of a polyline, by definition. */
static double cost_of(const double *x, const double *y, size_t count, const bool *marks, double cost)
{
    double total = 0;
    size_t from = 0;
    for (size_t j = 1; j < count; j++) {
        if (j + 1 < count && !marks[j]) {
            continue;
        }
        double dx = x[j] - x[from], dy = y[j] - y[from], length = hypot(dx, dy);
        for (size_t i = from; i <= j; i++) {
            double off = (dx * (y[i] - y[from]) - dy * (x[i] - x[from])) / length;
            total += off * off;
        }
        total += cost;
        from = j;
    }
    return total;
}

static void the_polyline_is_the_cheapest(void **state)
{
    (void)state;
    duct_error error;
    enum { COUNT = 12 };
    double x[COUNT], y[COUNT];
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = (double)i;
        y[i] = 3 * sin(0.8 * (double)i) + (i > 6 ? 2 : 0);
    }
    for (double cost = 0.1; cost < 20; cost *= 2) {
        bool marks[COUNT] = {false}, tried[COUNT];
        assert_ok(
            duct_polyline_vertices(duct_allocator_of(NULL), x, y, 0, COUNT - 1, cost, 100, marks, &error));
        double found = cost_of(x, y, COUNT, marks, cost), best = INFINITY;
        for (unsigned set = 0; set < 1u << (COUNT - 2); set++) {
            for (size_t i = 0; i < COUNT; i++) {
                tried[i] = i > 0 && i + 1 < COUNT && (set >> (i - 1) & 1);
            }
            best = fmin(best, cost_of(x, y, COUNT, tried, cost));
        }
        assert_true(fabs(found - best) < 1e-9);
    }
}

static void medians_and_quantiles(void **state)
{
    (void)state;
    double odd[] = {5, 1, 3}, even[] = {4, 1, 3, 2}, one[] = {7};
    assert_true(duct_median(odd, 3) == 3);
    assert_true(duct_median(even, 4) == 2.5);
    assert_true(duct_median(one, 1) == 7);
    assert_true(duct_median(one, 0) == 0);
    double many[101];
    for (size_t i = 0; i < 101; i++) {
        many[i] = (double)(100 - i);
    }
    assert_true(duct_quantile(many, 101, 0.9) == 90);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(samples_are_evenly_spaced_and_keep_the_ends),
        cmocka_unit_test(recorded_strokes_are_rounded_and_vector_ones_keep_corners),
        cmocka_unit_test(closed_strokes_end_where_they_began),
        cmocka_unit_test(strokes_without_length_have_no_samples),
        cmocka_unit_test(too_many_samples_are_a_limit),
        cmocka_unit_test(sampling_survives_failing_allocations),
        cmocka_unit_test(the_polyline_is_the_cheapest),
        cmocka_unit_test(medians_and_quantiles),
    };
    return cmocka_run_group_tests(tests, make_drawing, free_drawing);
}
