/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"

#include <ductus/path.h>

#include <math.h>
#include <string.h>

/* <ductus/path.h> as a host uses it: curves in, strokes, curves out. */

typedef struct {
    duct_path *path;
    duct_drawing *drawing;
} scene;

static scene scene_new(const char *d)
{
    scene s;
    duct_error error;
    assert_ok(duct_path_new(NULL, &s.path, &error));
    assert_ok(duct_drawing_new(NULL, &s.drawing, &error));
    assert_ok(duct_path_add_svg(s.path, d, &error));
    return s;
}

static void scene_free(scene s)
{
    duct_path_free(s.path);
    duct_drawing_free(s.drawing);
}

static void flattened_circle_stays_within_the_tolerance(void **state)
{
    (void)state;
    duct_error error;
    scene s = scene_new("M 110,100 A 10 10 0 0 1 90 100 A 10 10 0 0 1 110 100 Z");
    assert_ok(duct_path_flatten(s.path, "circle", 0.01, s.drawing, &error));
    assert_int_equal(duct_drawing_stroke_count(s.drawing), 1);
    const duct_stroke *stroke = duct_drawing_stroke(s.drawing, 0);
    assert_true(duct_stroke_closed(stroke));
    size_t size = duct_stroke_size(stroke);
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    for (size_t i = 0; i < size; i++) {
        size_t j = (i + 1) % size;
        assert_true(fabs(hypot(x[i] - 100, y[i] - 100) - 10) < 0.01);
        assert_true(fabs(hypot((x[i] + x[j]) / 2 - 100, (y[i] + y[j]) / 2 - 100) - 10) < 0.011);
    }
    scene_free(s);
}

static void subpaths_are_numbered_and_lonely_moves_left_out(void **state)
{
    (void)state;
    duct_error error;
    scene s = scene_new("");
    duct_path_move(s.path, 0, 0);
    duct_path_line(s.path, 1, 0);
    duct_path_move(s.path, 5, 5);
    duct_path_move(s.path, 2, 0);
    duct_path_line(s.path, 3, 0);
    assert_ok(duct_path_flatten(s.path, "p", 0.1, s.drawing, &error));
    assert_int_equal(duct_drawing_stroke_count(s.drawing), 2);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(s.drawing, 0)), "p");
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(s.drawing, 1)), "p/3");
    scene_free(s);
}

static void drawing_without_a_move_begins_where_svg_begins(void **state)
{
    (void)state;
    duct_error error;
    scene s = scene_new("");
    duct_path_cubic(s.path, 1, 2, 3, 4, 5, 6);
    duct_path_close(s.path);
    duct_path_close(s.path);
    duct_path_line(s.path, 9, 9);
    char *text;
    assert_ok(duct_path_svg(NULL, s.path, 3, &text, &error));
    assert_string_equal(text, "M 1,2 C 1,2 3,4 5,6 Z M 1,2 L 9,9");
    duct_memory_free(NULL, text);
    assert_ok(duct_path_flatten(s.path, "p", 0.1, s.drawing, &error));
    assert_int_equal(duct_drawing_stroke_count(s.drawing), 2);
    scene_free(s);
}

static void bad_points_and_tolerances_end_in_a_sentence(void **state)
{
    (void)state;
    duct_error error;
    scene s = scene_new("M 0,0 L 1,1");
    assert_int_equal(duct_path_flatten(s.path, "p", 0, s.drawing, &error), DUCT_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "tolerance"));
    assert_int_equal(duct_path_flatten(s.path, "p", (double)NAN, s.drawing, &error), DUCT_BAD_ARGUMENT);
    duct_path_line(s.path, (double)NAN, 0);
    assert_int_equal(duct_path_flatten(s.path, "p", 1, s.drawing, &error), DUCT_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "point 3"));
    duct_path_clear(s.path);
    duct_path_move(s.path, 0, 0);
    duct_path_line(s.path, 1e12, 0);
    assert_int_equal(duct_path_flatten(s.path, "p", 1, s.drawing, &error), DUCT_LIMIT);
    assert_int_equal(duct_drawing_stroke_count(s.drawing), 0);
    scene_free(s);
}

static void fit_of_a_flattened_path_needs_about_as_many_nodes(void **state)
{
    (void)state;
    duct_error error;
    scene s = scene_new("M 0,0 C 40,-60 80,60 120,0 L 160,40 L 200,0");
    assert_ok(duct_path_flatten(s.path, "p", 0.02, s.drawing, &error));
    size_t nodes = duct_path_nodes(s.path);
    duct_path *fitted;
    assert_ok(duct_path_new(NULL, &fitted, &error));
    assert_ok(duct_path_fit(fitted, duct_drawing_stroke(s.drawing, 0), 0.2, &error));
    assert_in_range(duct_path_nodes(fitted), nodes, nodes + 3);
    size_t count;
    const double *points = duct_path_points(fitted, &count);
    assert_true(hypot(points[2 * count - 2] - 200, points[2 * count - 1]) < 1e-9);
    duct_path_free(fitted);
    scene_free(s);
}

static void map_is_svgs_matrix(void **state)
{
    (void)state;
    duct_error error;
    scene s = scene_new("M 1,2 L 3,4");
    duct_path_map(s.path, (double[]){0, 1, -1, 0, 10, 0});
    char *text;
    assert_ok(duct_path_svg(NULL, s.path, 3, &text, &error));
    assert_string_equal(text, "M 8,1 L 6,3");
    duct_memory_free(NULL, text);
    scene_free(s);
}

static duct_status flatten_and_fit(const duct_context *context)
{
    duct_path *path = NULL, *fitted = NULL;
    duct_drawing *drawing = NULL;
    char *text = NULL;
    duct_status status = duct_path_new(context, &path, NULL);
    if (status == DUCT_OK) {
        status = duct_path_add_svg(path, "M 0,0 C 40,-60 80,60 120,0 Z M 5,5 L 9,9", NULL);
    }
    if (status == DUCT_OK) {
        status = duct_drawing_new(context, &drawing, NULL);
    }
    if (status == DUCT_OK) {
        status = duct_path_flatten(path, "p", 0.1, drawing, NULL);
    }
    if (status == DUCT_OK) {
        status = duct_path_new(context, &fitted, NULL);
    }
    if (status == DUCT_OK) {
        status = duct_path_fit(fitted, duct_drawing_stroke(drawing, 0), 0.1, NULL);
    }
    if (status == DUCT_OK) {
        status = duct_path_svg(context, fitted, 3, &text, NULL);
    }
    duct_memory_free(context, text);
    duct_path_free(fitted);
    duct_drawing_free(drawing);
    duct_path_free(path);
    return status;
}

static void every_failed_allocation_is_told(void **state)
{
    (void)state;
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        status = flatten_and_fit(&context);
        assert_int_equal(failing.held, 0);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_true(status != DUCT_OK || n > 10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(flattened_circle_stays_within_the_tolerance),
        cmocka_unit_test(subpaths_are_numbered_and_lonely_moves_left_out),
        cmocka_unit_test(drawing_without_a_move_begins_where_svg_begins),
        cmocka_unit_test(bad_points_and_tolerances_end_in_a_sentence),
        cmocka_unit_test(fit_of_a_flattened_path_needs_about_as_many_nodes),
        cmocka_unit_test(map_is_svgs_matrix),
        cmocka_unit_test(every_failed_allocation_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
