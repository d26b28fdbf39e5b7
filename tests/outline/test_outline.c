/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "shapes.h"

#include <pthread.h>

static sheet line(size_t count, double length)
{
    sheet s = sheet_new(count);
    for (size_t i = 0; i < count; i++) {
        s.x[i] = length * (double)i / (double)(count - 1);
        s.y[i] = 50;
    }
    return s;
}

/* The width and height of what a path fills. */
static void extent(const duct_path *path, double size[2])
{
    GEOSContextHandle_t geos = GEOS_init_r();
    size_t crossing = 0;
    GEOSGeometry *shape = shape_of_path(geos, path, &crossing);
    double x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    GEOSGeom_getXMin_r(geos, shape, &x0);
    GEOSGeom_getYMin_r(geos, shape, &y0);
    GEOSGeom_getXMax_r(geos, shape, &x1);
    GEOSGeom_getYMax_r(geos, shape, &y1);
    size[0] = x1 - x0;
    size[1] = y1 - y0;
    GEOSGeom_destroy_r(geos, shape);
    GEOS_finish_r(geos);
}

/* The sum of the rings' areas with their signs: that of the filled area where holes run against the outside.
 */
static double signed_area(const duct_path *path)
{
    double area = 0;
    const double *p = path->points, *start = p, *from = p;
    for (size_t i = 0; i < path->verb_count; i++) {
        const double *to = path->verbs[i] == DUCT_PATH_CUBIC ? p + 4 : p;
        if (path->verbs[i] == DUCT_PATH_MOVE) {
            start = p;
        } else if (path->verbs[i] == DUCT_PATH_CLOSE) {
            area += 0.5 * (from[0] * start[1] - from[1] * start[0]);
            continue;
        } else if (path->verbs[i] == DUCT_PATH_LINE) {
            area += 0.5 * (from[0] * to[1] - from[1] * to[0]);
        } else {
            double xy[2 * STEPS];
            flatten_step(from, p, xy);
            const double *a = from;
            for (int k = 0; k < STEPS; a = xy + 2 * k++) {
                area += 0.5 * (a[0] * xy[2 * k + 1] - a[1] * xy[2 * k]);
            }
        }
        from = to;
        p = to + 2;
    }
    return fabs(area);
}

static void assert_finite(const duct_path *path)
{
    for (size_t i = 0; i < 2 * path->point_count; i++) {
        assert_true(isfinite(path->points[i]));
    }
}

static void empty_stroke_adds_nothing(void **state)
{
    (void)state;
    sheet s = sheet_new(0);
    duct_path path = outline_of(s.stroke, NULL);
    assert_int_equal(path.verb_count, 0);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void one_sample_gives_a_dot(void **state)
{
    (void)state;
    sheet s = sheet_new(1);
    duct_nib_options options = round_nib(10);
    duct_path path = outline_of(s.stroke, &options);
    assert_int_equal(ring_count(&path), 1);
    assert_true(duct_path_nodes(&path) <= 4);
    assert_int_equal(path.verbs[path.verb_count - 1], DUCT_PATH_CLOSE);
    assert_near(path_area(&path), 25 * pi, 0.1 * 10 * pi);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void samples_in_one_place_give_a_dot_of_the_largest(void **state)
{
    (void)state;
    sheet s = sheet_new(500);
    double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.1);
    pressure[137] = 0.5;
    duct_nib_options options = round_nib(10);
    duct_path path = outline_of(s.stroke, &options);
    assert_int_equal(ring_count(&path), 1);
    assert_near(path_area(&path), 25 * pi, 0.1 * 10 * pi);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void straight_line_is_a_bar_with_round_ends_of_few_nodes(void **state)
{
    (void)state;
    sheet s = line(300, 100);
    duct_nib_options options = round_nib(10);
    duct_path path = outline_of(s.stroke, &options);
    double size[2];
    extent(&path, size);
    assert_near(size[0], 110, 0.3);
    assert_near(size[1], 10, 0.3);
    assert_near(path_area(&path), 1000 + 25 * pi, 0.1 * 231);
    assert_true(duct_path_nodes(&path) <= 10);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void width_comes_from_the_stroke_where_none_is_given(void **state)
{
    (void)state;
    sheet s = line(30, 100);
    duct_stroke_style style = duct_stroke_get_style(s.stroke);
    style.width = 6;
    duct_stroke_set_style(s.stroke, style);
    duct_nib_options options = round_nib(0);
    duct_path path = outline_of(s.stroke, &options);
    double size[2];
    extent(&path, size);
    assert_near(size[1], 6, 0.3);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void width_follows_pressure(void **state)
{
    (void)state;
    static const double pressures[] = {0, 0.25, 0.5, 0.75, 1}, widths[] = {3, 6.5, 10, 15, 20};
    for (size_t k = 0; k < 5; k++) {
        sheet s = line(30, 100);
        sheet_channel(&s, DUCT_PRESSURE, pressures[k]);
        duct_nib_options options = round_nib(10);
        options.thinnest = 0.3;
        options.thickest = 2;
        duct_path path = outline_of(s.stroke, &options);
        double size[2];
        extent(&path, size);
        assert_near(size[1], widths[k], 0.3);
        duct_path_done(&path);
        duct_drawing_free(s.drawing);
    }
}

/* The height of a horizontal line's outline. */
static double height(double tilt_x, double tilt_y, bool tilted, double twist, bool twisted, double aspect)
{
    sheet s = line(30, 100);
    if (tilted) {
        sheet_channel(&s, DUCT_TILT_X, tilt_x);
        sheet_channel(&s, DUCT_TILT_Y, tilt_y);
    }
    if (twisted) {
        sheet_channel(&s, DUCT_TWIST, twist);
    }
    duct_nib_options options = round_nib(10);
    options.aspect = aspect;
    duct_path path = outline_of(s.stroke, &options);
    double size[2];
    extent(&path, size);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
    return size[1];
}

static void nib_turns_with_twist(void **state)
{
    (void)state;
    assert_near(height(0, 0, false, 0, true, 4), 5, 0.3);
    assert_near(height(0, 0, false, pi / 2, true, 4), 20, 0.3);
    assert_near(height(0.5, 0, true, pi / 2, true, 1), 10 / sqrt(cos(0.5)), 0.3);
}

static void nib_leans_with_tilt(void **state)
{
    (void)state;
    double lean = 0.8, root = sqrt(1 / cos(lean));
    assert_near(height(lean, 0, true, 0, false, 1), 10 / root, 0.3);
    assert_near(height(0, lean, true, 0, false, 1), 10 * root, 0.3);
    /* Without twist an upright pen has no direction. */
    assert_near(height(0, 0, true, 0, false, 4), 10, 0.3);
    assert_near(height(0, 0, false, 0, false, 4), 10, 0.3);
}

static void loops_have_holes(void **state)
{
    (void)state;
    sheet s = sheet_new(200);
    for (size_t i = 0; i < s.count; i++) {
        double a = 2 * pi * (double)i / (double)(s.count - 1);
        s.x[i] = 40 * sin(a);
        s.y[i] = 25 * sin(2 * a);
    }
    duct_nib_options options = round_nib(4);
    duct_path path = outline_of(s.stroke, &options);
    assert_int_equal(ring_count(&path), 3);
    assert_true(duct_path_nodes(&path) <= 40);
    assert_near(signed_area(&path), path_area(&path), 1);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void closed_stroke_is_a_ring_without_a_seam(void **state)
{
    (void)state;
    sheet s = sheet_new(100);
    for (size_t i = 0; i < s.count; i++) {
        double a = 2 * pi * (double)i / (double)s.count;
        s.x[i] = 50 * cos(a);
        s.y[i] = 50 * sin(a);
    }
    duct_stroke_set_closed(s.stroke, true);
    sheet_channel(&s, DUCT_T, 0);
    duct_nib_options options = round_nib(6);
    duct_path path = outline_of(s.stroke, &options);
    assert_int_equal(ring_count(&path), 2);
    assert_near(path_area(&path), pi * (53 * 53 - 47 * 47), 0.1 * 628);
    assert_true(duct_path_nodes(&path) <= 16);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void sparse_pen_samples_are_joined_smoothly(void **state)
{
    (void)state;
    sheet s = sheet_new(16);
    double *t = sheet_channel(&s, DUCT_T, 0);
    for (size_t i = 0; i < s.count; i++) {
        double a = 2 * pi * (double)i / (double)s.count;
        s.x[i] = 50 * cos(a);
        s.y[i] = 50 * sin(a);
        t[i] = 0.01 * (double)i;
    }
    duct_stroke_set_closed(s.stroke, true);
    duct_nib_options options = round_nib(6);
    duct_path path = outline_of(s.stroke, &options);
    /* The 16-gon's band would be 596. */
    assert_near(path_area(&path), 600 * pi, 10);
    duct_path_done(&path);
    duct_stroke_drop(s.stroke, DUCT_T);
    path = outline_of(s.stroke, &options);
    assert_true(path_area(&path) < 600 * pi - 8);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void path_is_appended_to(void **state)
{
    (void)state;
    duct_error error;
    sheet s = line(10, 20);
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    duct_path_move(&path, 1, 2);
    duct_path_line(&path, 3, 4);
    assert_ok(duct_path_outline(&path, s.stroke, NULL, &error));
    assert_int_equal(path.verbs[0], DUCT_PATH_MOVE);
    assert_int_equal(path.verbs[1], DUCT_PATH_LINE);
    assert_int_equal(path.verbs[2], DUCT_PATH_MOVE);
    assert_true(path.points[3] >= 4 && path.points[3] <= 4);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void hostile_values_do_no_harm(void **state)
{
    (void)state;
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 0, -1, 1e-300};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        for (int which = 0; which < 10; which++) {
            sheet s = line(20, 30);
            sheet_channel(&s, DUCT_PRESSURE, which == 0 ? bad[k] : 0.5)[7] = which == 1 ? bad[k] : 0.5;
            sheet_channel(&s, DUCT_TILT_X, 0)[3] = which == 2 ? bad[k] : 0.5;
            sheet_channel(&s, DUCT_TWIST, 0)[9] = which == 3 ? bad[k] : 0.5;
            s.x[5] = which == 4 ? bad[k] : s.x[5];
            duct_nib_options options = duct_nib_options_default();
            options.width = which == 5 ? bad[k] : 3;
            options.aspect = which == 6 ? bad[k] : 2;
            options.fit_tolerance = which == 7 ? bad[k] : 0.1;
            options.thinnest = which == 8 ? bad[k] : 0.2;
            options.thickest = which == 9 ? bad[k] : 2;
            duct_path path = outline_of(s.stroke, &options);
            assert_finite(&path);
            duct_path_done(&path);
            duct_drawing_free(s.drawing);
        }
    }
}

static void a_million_samples_take_no_quadratic_time(void **state)
{
    (void)state;
    sheet s = sheet_new(1000000);
    double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.5);
    for (size_t i = 0; i < s.count; i++) {
        double t = (double)i / (double)s.count;
        s.x[i] = 300 * t * cos(60 * t);
        s.y[i] = 300 * t * sin(60 * t);
        pressure[i] = 0.5 + 0.4 * sin(100 * t);
    }
    duct_nib_options options = round_nib(4);
    duct_path path = outline_of(s.stroke, &options);
    assert_true(duct_path_nodes(&path) < 400);
    duct_path_done(&path);
    /* A pen that rests for two hours, pressing now more, now less. */
    for (size_t i = 0; i < s.count; i++) {
        s.x[i] = s.y[i] = 0;
        pressure[i] = 0.5 + 0.4 * sin((double)(i * 7919 % 1000));
    }
    path = outline_of(s.stroke, &options);
    assert_int_equal(ring_count(&path), 1);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static sheet knot(double phase)
{
    sheet s = sheet_new(80);
    double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.5), *twist = sheet_channel(&s, DUCT_TWIST, 0);
    for (size_t i = 0; i < s.count; i++) {
        double t = (double)i / (double)s.count;
        s.x[i] = 40 * sin(9 * t + phase) + 30 * t;
        s.y[i] = 40 * sin(11 * t);
        pressure[i] = 0.5 + 0.5 * sin(20 * t);
        twist[i] = 3 * t;
    }
    return s;
}

static void failed_allocations_leave_the_path_as_it_was(void **state)
{
    (void)state;
    sheet s = knot(0);
    bool done = false;
    for (long n = 1; !done; n++) {
        failing_allocator failing;
        failing_init(&failing, 0);
        duct_path path;
        duct_path_init(&path, &failing.allocator);
        duct_path_move(&path, 1, 2);
        failing.calls = 0;
        failing.fails_at = n;
        duct_error error = {DUCT_OK, ""};
        duct_status status = duct_path_outline(&path, s.stroke, NULL, &error);
        done = status == DUCT_OK;
        if (!done) {
            assert_int_equal(status, DUCT_NO_MEMORY);
            assert_int_equal(path.verb_count, 1);
            assert_int_equal(path.point_count, 1);
            assert_false(path.failed);
        }
        duct_path_done(&path);
        assert_int_equal(failing.held, 0);
    }
    duct_drawing_free(s.drawing);
}

enum { THREADS = 4, STROKES = 24 };

typedef struct {
    const sheet *sheets;
    duct_path paths[STROKES];
    duct_status status;
} job;

static void *outline_all(void *arg)
{
    job *j = arg;
    for (size_t i = 0; i < STROKES; i++) {
        duct_path_init(&j->paths[i], duct_allocator_of(NULL));
        duct_status status = duct_path_outline(&j->paths[i], j->sheets[i].stroke, NULL, NULL);
        j->status = status != DUCT_OK ? status : j->status;
    }
    return NULL;
}

static void threads_get_the_same_bytes(void **state)
{
    (void)state;
    sheet sheets[STROKES];
    for (size_t i = 0; i < STROKES; i++) {
        sheets[i] = knot(0.3 * (double)i);
    }
    static job jobs[THREADS + 1];
    pthread_t threads[THREADS];
    for (size_t k = 0; k <= THREADS; k++) {
        jobs[k] = (job){.sheets = sheets, .status = DUCT_OK};
    }
    for (size_t k = 0; k < THREADS; k++) {
        assert_int_equal(pthread_create(&threads[k], NULL, outline_all, &jobs[k]), 0);
    }
    for (size_t k = 0; k < THREADS; k++) {
        pthread_join(threads[k], NULL);
    }
    outline_all(&jobs[THREADS]);
    for (size_t k = 0; k <= THREADS; k++) {
        assert_int_equal(jobs[k].status, DUCT_OK);
        for (size_t i = 0; i < STROKES; i++) {
            const duct_path *one = &jobs[k].paths[i], *alone = &jobs[THREADS].paths[i];
            assert_int_equal(one->point_count, alone->point_count);
            assert_memory_equal(one->points, alone->points, 2 * one->point_count * sizeof(double));
            assert_memory_equal(one->verbs, alone->verbs, one->verb_count);
        }
    }
    for (size_t i = 0; i < STROKES; i++) {
        for (size_t k = 0; k <= THREADS; k++) {
            duct_path_done(&jobs[k].paths[i]);
        }
        duct_drawing_free(sheets[i].drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_stroke_adds_nothing),
        cmocka_unit_test(one_sample_gives_a_dot),
        cmocka_unit_test(samples_in_one_place_give_a_dot_of_the_largest),
        cmocka_unit_test(straight_line_is_a_bar_with_round_ends_of_few_nodes),
        cmocka_unit_test(width_comes_from_the_stroke_where_none_is_given),
        cmocka_unit_test(width_follows_pressure),
        cmocka_unit_test(nib_turns_with_twist),
        cmocka_unit_test(nib_leans_with_tilt),
        cmocka_unit_test(loops_have_holes),
        cmocka_unit_test(closed_stroke_is_a_ring_without_a_seam),
        cmocka_unit_test(sparse_pen_samples_are_joined_smoothly),
        cmocka_unit_test(path_is_appended_to),
        cmocka_unit_test(hostile_values_do_no_harm),
        cmocka_unit_test(a_million_samples_take_no_quadratic_time),
        cmocka_unit_test(failed_allocations_leave_the_path_as_it_was),
        cmocka_unit_test(threads_get_the_same_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
