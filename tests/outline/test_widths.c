/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "shapes.h"

/* The widths along a fitted line. */

/* A line that crosses itself. */
static sheet spiral_knot(void)
{
    sheet s = sheet_new(80);
    for (size_t i = 0; i < s.count; i++) {
        double t = (double)i / (double)s.count;
        s.x[i] = 40 * sin(9 * t) + 30 * t;
        s.y[i] = 40 * sin(11 * t);
    }
    return s;
}

static duct_path fit_of(const duct_stroke *stroke, double tolerance)
{
    duct_error error;
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    assert_ok(duct_path_fit(&path, stroke, tolerance, &error));
    return path;
}

/* The width that straight courses between the places give at a place. */
static double width_at(const duct_width *widths, size_t count, double at)
{
    size_t i = 1;
    while (i + 1 < count && widths[i].at < at) {
        i++;
    }
    double t = (at - widths[i - 1].at) / (widths[i].at - widths[i - 1].at);
    return widths[i - 1].width + t * (widths[i].width - widths[i - 1].width);
}

static void pressure_along_a_straight_line_is_followed(void **state)
{
    (void)state;
    duct_error error;
    sheet s = sheet_new(401);
    double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.5);
    for (size_t i = 0; i < s.count; i++) {
        s.x[i] = (double)i;
        pressure[i] = 0.5 + 0.4 * sin((double)i / 40);
    }
    duct_path path = fit_of(s.stroke, 0.1);
    duct_nib_options nib = round_nib(10);
    duct_width *widths;
    size_t count;
    assert_ok(duct_path_widths(NULL, &path, 0, s.stroke, &nib, 0.1, &widths, &count, &error));
    assert_true(count > 4 && count < 80);
    assert_near(widths[0].at, 0, 0);
    assert_near(widths[count - 1].at, 1, 1e-9);
    for (size_t i = 0; i < s.count; i++) {
        /* thinnest 0.3, thickest 1.7: the width is linear in pressure. */
        double expected = 10 * (0.3 + 1.4 * pressure[i]);
        assert_near(width_at(widths, count, (double)i / 400), expected, 0.11);
    }
    duct_memory_free(NULL, widths);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void constant_width_needs_two_places(void **state)
{
    (void)state;
    duct_error error;
    sheet s = spiral_knot();
    duct_path path = fit_of(s.stroke, 0.1);
    duct_nib_options nib = round_nib(4);
    duct_width *widths;
    size_t count;
    assert_ok(duct_path_widths(NULL, &path, 0, s.stroke, &nib, 0.05, &widths, &count, &error));
    assert_int_equal(count, 2);
    assert_near(widths[0].width, 4, 1e-6);
    assert_near(widths[1].width, 4, 1e-6);
    assert_near(widths[1].at, (double)duct_path_nodes(&path) - 1, 1e-9);
    duct_memory_free(NULL, widths);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

/* A line that crosses itself is not taken for itself: pressure that rises along it gives widths that rise. */
static void line_that_crosses_itself_keeps_its_order(void **state)
{
    (void)state;
    duct_error error;
    sheet s = spiral_knot();
    double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0);
    for (size_t i = 0; i < s.count; i++) {
        pressure[i] = (double)i / (double)(s.count - 1);
    }
    duct_path path = fit_of(s.stroke, 0.2);
    duct_nib_options nib = round_nib(10);
    duct_width *widths;
    size_t count;
    assert_ok(duct_path_widths(NULL, &path, 0, s.stroke, &nib, 0.1, &widths, &count, &error));
    for (size_t i = 1; i < count; i++) {
        assert_true(widths[i].at > widths[i - 1].at);
        assert_true(widths[i].width >= widths[i - 1].width);
    }
    assert_near(widths[0].width, 3, 0.11);
    assert_near(widths[count - 1].width, 17, 0.11);
    duct_memory_free(NULL, widths);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

/* A closed fit may begin elsewhere than the stroke does. */
static void closed_line_finds_its_widest_place(void **state)
{
    (void)state;
    duct_error error;
    sheet s = sheet_new(200);
    double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0);
    duct_stroke_set_closed(s.stroke, true);
    for (size_t i = 0; i < s.count; i++) {
        double angle = 2 * pi * (double)i / (double)s.count;
        s.x[i] = 80 * cos(angle);
        s.y[i] = 40 * sin(angle);
        pressure[i] = 0.5 - 0.5 * cos(angle); /* the most at (-80, 0) */
    }
    duct_path path = fit_of(s.stroke, 0.1);
    duct_nib_options nib = round_nib(10);
    duct_width *widths;
    size_t count;
    assert_ok(duct_path_widths(NULL, &path, 0, s.stroke, &nib, 0.1, &widths, &count, &error));
    size_t widest = 0;
    for (size_t i = 0; i < count; i++) {
        widest = widths[i].width > widths[widest].width ? i : widest;
    }
    assert_near(widths[widest].width, 17, 0.2);
    assert_near(widths[0].width, widths[count - 1].width, 1e-9);
    /* The place is near (-80, 0). */
    size_t node = (size_t)widths[widest].at;
    double t = widths[widest].at - (double)node, u = 1 - t;
    const double *c = path.points + 6 * node;
    double x = u * u * u * c[0] + 3 * u * u * t * c[2] + 3 * u * t * t * c[4] + t * t * t * c[6];
    assert_near(x, -80, 1);
    duct_memory_free(NULL, widths);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void missing_subpath_is_told(void **state)
{
    (void)state;
    sheet s = spiral_knot();
    duct_path path = fit_of(s.stroke, 0.1);
    duct_width *widths = NULL;
    size_t count = 7;
    assert_int_equal(duct_path_widths(NULL, &path, 1, s.stroke, NULL, 0.1, &widths, &count, NULL),
                     DUCT_BAD_ARGUMENT);
    assert_int_equal(duct_path_widths(NULL, &path, 0, s.stroke, NULL, 0, &widths, &count, NULL),
                     DUCT_BAD_ARGUMENT);
    assert_null(widths);
    assert_int_equal(count, 7);
    duct_path_done(&path);
    duct_drawing_free(s.drawing);
}

static void failed_allocations_leave_nothing(void **state)
{
    (void)state;
    sheet s = spiral_knot();
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, 0);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_path path;
        duct_path_init(&path, &failing.allocator);
        duct_error error;
        assert_ok(duct_path_fit(&path, s.stroke, 0.1, &error));
        failing.calls = 0;
        failing.fails_at = n;
        duct_width *widths = NULL;
        size_t count;
        status = duct_path_widths(&context, &path, 0, s.stroke, NULL, 0.1, &widths, &count, &error);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        duct_memory_free(&context, widths);
        duct_path_done(&path);
        assert_int_equal(failing.held, 0);
        assert_true(status != DUCT_OK || n > 5);
    }
    duct_drawing_free(s.drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pressure_along_a_straight_line_is_followed),
        cmocka_unit_test(constant_width_needs_two_places),
        cmocka_unit_test(line_that_crosses_itself_keeps_its_order),
        cmocka_unit_test(closed_line_finds_its_widest_place),
        cmocka_unit_test(missing_subpath_is_told),
        cmocka_unit_test(failed_allocations_leave_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
