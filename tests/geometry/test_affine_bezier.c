/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "geometry/bezier.h"

#include <math.h>

#define assert_near(value, expected, distance) assert_true(fabs((value) - (expected)) <= (distance))

static const duct_allocator *plain(void)
{
    static failing_allocator allocator;
    failing_init(&allocator, 0);
    return &allocator.allocator;
}

static void multiply_does_the_inner_map_first(void **state)
{
    (void)state;
    duct_affine shift = {1, 0, 0, 1, 10, 20}, grow = {2, 0, 0, 3, 0, 0};
    double x = 1, y = 1;
    duct_affine_apply(duct_affine_multiply(shift, grow), &x, &y);
    assert_near(x, 12, 1e-12);
    assert_near(y, 23, 1e-12);
    x = y = 1;
    duct_affine_apply(duct_affine_multiply(grow, shift), &x, &y);
    assert_near(x, 22, 1e-12);
    assert_near(y, 63, 1e-12);
}

static void invert_undoes_maps_of_all_sizes(void **state)
{
    (void)state;
    double sizes[] = {1e-100, 1e-6, 1, 1e6, 1e100};
    for (size_t i = 0; i < 5; i++) {
        double s = sizes[i];
        duct_affine map = {2 * s, s, -s, 3 * s, 5 * s, -7 * s}, inverse;
        assert_true(duct_affine_invert(map, &inverse));
        duct_affine both = duct_affine_multiply(map, inverse);
        assert_near(both.a, 1, 1e-12);
        assert_near(both.d, 1, 1e-12);
        assert_near(both.b + both.c, 0, 1e-12);
        assert_near((both.e + both.f) / s, 0, 1e-9);
    }
}

static void invert_refuses_singular_and_infinite_maps(void **state)
{
    (void)state;
    duct_affine maps[] = {{0, 0, 0, 0, 0, 0},   {1, 2, 2, 4, 0, 0},        {1, 0, 0, 0, 3, 4},
                          {NAN, 0, 0, 1, 0, 0}, {INFINITY, 0, 0, 1, 0, 0}, {1, 0, 0, 1, INFINITY, 0}};
    for (size_t i = 0; i < sizeof maps / sizeof *maps; i++) {
        duct_affine kept = {9, 9, 9, 9, 9, 9};
        assert_false(duct_affine_invert(maps[i], &kept));
        assert_near(kept.a, 9, 0);
    }
}

static void scale_and_stretch_measure_factors(void **state)
{
    (void)state;
    duct_affine map = {0, 8, -2, 0, 5, 5};
    assert_near(duct_affine_scale(map), 4, 1e-12);
    assert_near(duct_affine_stretch(map), 8, 1e-12);
}

/* Flattens a path of one subpath. */
static void flatten(duct_points *points, const duct_path *path, double tolerance)
{
    duct_subpath subpath = {0};
    assert_true(duct_path_next(path, &subpath));
    duct_flatten_subpath(points, path, &subpath, tolerance);
}

static void arcs_stay_on_their_circle(void **state)
{
    (void)state;
    duct_path path;
    duct_points points;
    duct_path_init(&path, plain());
    duct_points_init(&points, plain(), 100000);
    duct_path_move(&path, 100, 0);
    duct_path_arc(&path, 100, 0, 100, 100, 30, true, true, 0, -100);
    flatten(&points, &path, 0.01);
    assert_true(points.count > 30);
    for (size_t i = 0; i < points.count; i++) {
        assert_near(hypot(points.x[i], points.y[i]), 100, 1e-4);
    }
    /* The large arc with the sweep flag goes clockwise, through (0, 100) first. */
    assert_true(points.y[1] > 0);
    assert_near(points.x[points.count - 1], 0, 0);
    assert_near(points.y[points.count - 1], -100, 0);
    duct_points_free(&points);
    duct_path_done(&path);
}

static void arcs_follow_all_four_flags(void **state)
{
    (void)state;
    /* Between (0, 0) and (10, 0) with radius 10: the height of the arc's middle tells which one it is. */
    double low = 10 - sqrt(75), high = 10 + sqrt(75);
    double expected[2][2] = {{low, -low}, {high, -high}};
    for (int large = 0; large < 2; large++) {
        for (int sweep = 0; sweep < 2; sweep++) {
            duct_path path;
            duct_points points;
            duct_path_init(&path, plain());
            duct_points_init(&points, plain(), 100000);
            duct_path_move(&path, 0, 0);
            duct_path_arc(&path, 0, 0, 10, 10, 0, large != 0, sweep != 0, 10, 0);
            flatten(&points, &path, 1e-4);
            double most = 0;
            for (size_t i = 0; i < points.count; i++) {
                most = fabs(points.y[i]) > fabs(most) ? points.y[i] : most;
            }
            assert_near(most, expected[large][sweep], 1e-3);
            duct_points_free(&points);
            duct_path_done(&path);
        }
    }
}

static void arcs_degenerate_as_the_specification_says(void **state)
{
    (void)state;
    duct_path path;
    duct_path_init(&path, plain());
    duct_path_move(&path, 0, 0);
    duct_path_arc(&path, 0, 0, 5, 5, 0, true, true, 0, 0); /* equal ends: nothing */
    assert_int_equal(path.verb_count, 1);
    duct_path_arc(&path, 0, 0, 0, 5, 0, true, true, 9, 0); /* no radius: a line */
    assert_int_equal(path.verbs[1], DUCT_PATH_LINE);
    duct_path_arc(&path, 9, 0, 1, 1, 0, false, true, 19, 0); /* radii grow to 5: a half circle */
    double top = 0;
    for (size_t i = 0; i < path.point_count; i++) {
        top = fmin(top, path.points[2 * i + 1]);
    }
    assert_near(top, -5, 1e-6);
    duct_path_arc(&path, 19, 0, 1e300, 1e-300, 45, false, true, 0, 1e300); /* anything finite */
    for (size_t i = 0; i < 2 * path.point_count; i++) {
        assert_true(path.points[i] == path.points[i]);
    }
    duct_path_done(&path);
}

static double distance_to(const duct_points *points, double x, double y)
{
    double least = INFINITY;
    for (size_t i = 0; i + 1 < points->count; i++) {
        double dx = points->x[i + 1] - points->x[i], dy = points->y[i + 1] - points->y[i];
        double t = ((x - points->x[i]) * dx + (y - points->y[i]) * dy) / (dx * dx + dy * dy);
        t = fmin(fmax(t, 0), 1);
        least = fmin(least, hypot(points->x[i] + t * dx - x, points->y[i] + t * dy - y));
    }
    return least;
}

static void flattened_cubics_keep_the_tolerance_with_few_points(void **state)
{
    (void)state;
    const double c[8] = {0, 0, 100, 200, -50, 200, 60, -30};
    double tolerances[] = {1, 0.1, 0.01};
    for (size_t k = 0; k < 3; k++) {
        duct_points points;
        duct_points_init(&points, plain(), 100000);
        duct_points_add(&points, c[0], c[1]);
        duct_flatten_cubic(&points, c, tolerances[k]);
        double most = 0;
        for (int i = 0; i <= 1000; i++) {
            double t = i / 1000.0, s = 1 - t;
            double b[4] = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
            double x = 0, y = 0;
            for (size_t p = 0; p < 4; p++) {
                x += b[p] * c[2 * p];
                y += b[p] * c[2 * p + 1];
            }
            most = fmax(most, distance_to(&points, x, y));
        }
        assert_true(most <= tolerances[k]);
        assert_true((double)points.count < 40 / sqrt(tolerances[k]));
        duct_points_free(&points);
    }
}

static void quadratics_become_equal_cubics(void **state)
{
    (void)state;
    duct_path path;
    duct_points points;
    duct_path_init(&path, plain());
    duct_points_init(&points, plain(), 1000);
    duct_path_move(&path, 0, 0);
    duct_path_quadratic(&path, 0, 0, 10, 20, 20, 0);
    flatten(&points, &path, 1e-3);
    for (size_t i = 0; i < points.count; i++) {
        double t = points.x[i] / 20;
        assert_near(points.y[i], 40 * t * (1 - t), 1e-9);
    }
    duct_points_free(&points);
    duct_path_done(&path);
}

static void flattening_drops_points_that_coincide(void **state)
{
    (void)state;
    duct_path path;
    duct_points points;
    duct_path_init(&path, plain());
    duct_points_init(&points, plain(), 1000);
    duct_path_move(&path, 1, 1);
    duct_path_line(&path, 1, 1);
    duct_path_line(&path, 5, 1);
    duct_path_cubic(&path, 5, 1, 5, 1, 5, 1);
    duct_path_line(&path, 1, 1);
    duct_path_close(&path);
    flatten(&points, &path, 0.05);
    assert_int_equal(points.count, 2);
    duct_path_done(&path);
    duct_path_move(&path, 3, 3);
    duct_path_close(&path);
    flatten(&points, &path, 0.05);
    assert_int_equal(points.count, 1);
    duct_points_free(&points);
    duct_path_done(&path);
}

static void huge_curves_end_at_the_limit(void **state)
{
    (void)state;
    const double c[8] = {0, 0, 1e200, 1e300, -1e300, 1e300, 0, -1e300};
    duct_points points;
    duct_points_init(&points, plain(), 1000);
    duct_flatten_cubic(&points, c, 0.05);
    assert_true(points.full);
    assert_int_equal(points.count, 1000);
    duct_points_free(&points);
}

static void subpaths_are_walked_and_copied(void **state)
{
    (void)state;
    duct_path path, copy;
    duct_path_init(&path, plain());
    duct_path_init(&copy, plain());
    duct_path_move(&path, 0, 0);
    duct_path_line(&path, 1, 0);
    duct_path_move(&path, 5, 5);
    duct_path_cubic(&path, 6, 5, 7, 6, 7, 7);
    duct_path_close(&path);
    duct_subpath subpath = {0};
    assert_true(duct_path_next(&path, &subpath));
    assert_false(subpath.closed);
    assert_int_equal(subpath.point_end, 2);
    assert_true(duct_path_next(&path, &subpath));
    assert_true(subpath.closed);
    duct_path_append(&copy, &path, &subpath);
    assert_int_equal(copy.verb_count, 3);
    assert_near(copy.points[7], 7, 0);
    assert_false(duct_path_next(&path, &subpath));
    duct_path_done(&path);
    duct_path_done(&copy);
}

static void failed_allocations_leak_nothing(void **state)
{
    (void)state;
    const double c[8] = {0, 0, 100, 200, -50, 200, 60, -30};
    for (long n = 1;; n++) {
        failing_allocator allocator;
        failing_init(&allocator, n);
        duct_points points;
        duct_points_init(&points, &allocator.allocator, 100000);
        duct_flatten_cubic(&points, c, 0.001);
        bool failed = points.failed;
        duct_points_free(&points);
        assert_int_equal(allocator.held, 0);
        if (!failed) {
            assert_true(n > 2);
            break;
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(multiply_does_the_inner_map_first),
        cmocka_unit_test(invert_undoes_maps_of_all_sizes),
        cmocka_unit_test(invert_refuses_singular_and_infinite_maps),
        cmocka_unit_test(scale_and_stretch_measure_factors),
        cmocka_unit_test(arcs_stay_on_their_circle),
        cmocka_unit_test(arcs_follow_all_four_flags),
        cmocka_unit_test(arcs_degenerate_as_the_specification_says),
        cmocka_unit_test(flattened_cubics_keep_the_tolerance_with_few_points),
        cmocka_unit_test(quadratics_become_equal_cubics),
        cmocka_unit_test(flattening_drops_points_that_coincide),
        cmocka_unit_test(huge_curves_end_at_the_limit),
        cmocka_unit_test(subpaths_are_walked_and_copied),
        cmocka_unit_test(failed_allocations_leak_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
