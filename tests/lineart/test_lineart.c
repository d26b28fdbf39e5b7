/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strokes of drawn shapes: how many, where, how wide, in which order. */
#include "lineart/pictures.h"

static const duct_stroke *only_stroke(const duct_drawing *drawing)
{
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    return duct_drawing_stroke(drawing, 0);
}

static double first_x(const duct_stroke *stroke)
{
    return duct_stroke_values(stroke, DUCT_X)[0];
}

static double first_y(const duct_stroke *stroke)
{
    return duct_stroke_values(stroke, DUCT_Y)[0];
}

static double last_x(const duct_stroke *stroke)
{
    return duct_stroke_values(stroke, DUCT_X)[duct_stroke_size(stroke) - 1];
}

static double last_y(const duct_stroke *stroke)
{
    return duct_stroke_values(stroke, DUCT_Y)[duct_stroke_size(stroke) - 1];
}

/* The largest distance of a stroke's samples from a segment. */
static double farthest(const duct_stroke *stroke, double ax, double ay, double bx, double by)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    double most = 0;
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        most = fmax(most, to_segment(x[i], y[i], ax, ay, bx, by));
    }
    return most;
}

static void line_is_found_where_it_is(void **state)
{
    (void)state;
    static const double ends[][4] = {
        {20, 30, 180, 30}, {40, 10, 40, 120}, {20, 20, 150, 110}, {150, 20, 30, 120}, {20, 60, 180, 75}};
    static const double widths[] = {1, 2, 3, 6, 11, 20};
    for (size_t i = 0; i < sizeof ends / sizeof ends[0]; i++) {
        for (size_t w = 0; w < sizeof widths / sizeof widths[0]; w++) {
            const double *e = ends[i];
            picture page = new_picture(200, 140, 255);
            draw_line(&page, e[0], e[1], e[2], e[3], widths[w], 0);
            duct_drawing *drawing = trace(&page, NULL);
            const duct_stroke *stroke = only_stroke(drawing);
            assert_true(farthest(stroke, e[0], e[1], e[2], e[3]) < 1.2);
            assert_float_equal(duct_stroke_get_style(stroke).width, widths[w], 1.3);
            /* Begins at the left or upper end, and reaches both. */
            bool across = fabs(e[2] - e[0]) > fabs(e[3] - e[1]);
            assert_true(across ? first_x(stroke) < last_x(stroke) : first_y(stroke) < last_y(stroke));
            double length = hypot(e[2] - e[0], e[3] - e[1]);
            double reached = hypot(last_x(stroke) - first_x(stroke), last_y(stroke) - first_y(stroke));
            assert_float_equal(reached, length, widths[w] + 3);
            duct_drawing_free(drawing);
            free(page.grey);
        }
    }
}

static void ring_is_one_closed_stroke(void **state)
{
    (void)state;
    picture page = new_picture(160, 160, 255);
    draw_ring(&page, 80, 80, 55, 7, 0);
    duct_drawing *drawing = trace(&page, NULL);
    const duct_stroke *stroke = only_stroke(drawing);
    assert_true(duct_stroke_closed(stroke));
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        assert_float_equal(hypot(x[i] - 80, y[i] - 80), 55, 1.2);
    }
    /* From the top, to the left first. */
    assert_float_equal(y[0], 25, 2);
    assert_true(x[duct_stroke_size(stroke) / 4] < 40);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void strokes_go_straight_on_through_crossings(void **state)
{
    (void)state;
    static const double angles[] = {90, 60, 35};
    static const double widths[] = {1, 5, 12};
    for (size_t a = 0; a < 3; a++) {
        for (size_t w = 0; w < 3; w++) {
            double angle = angles[a] * 3.14159265358979 / 180, dx = 90 * cos(angle), dy = 90 * sin(angle);
            picture page = new_picture(240, 220, 255);
            draw_line(&page, 20, 110, 220, 110, widths[w], 0);
            draw_line(&page, 120 - dx, 110 - dy, 120 + dx, 110 + dy, widths[w], 0);
            duct_drawing *drawing = trace(&page, NULL);
            if (duct_drawing_stroke_count(drawing) != 2) {
                print_message("at %g degrees, %g wide: %zu strokes\n", angles[a], widths[w],
                              duct_drawing_stroke_count(drawing));
            }
            assert_int_equal(duct_drawing_stroke_count(drawing), 2);
            /* The longer one comes first. */
            const duct_stroke *first = duct_drawing_stroke(drawing, 0),
                              *second = duct_drawing_stroke(drawing, 1);
            double off = fmax(farthest(first, 20, 110, 220, 110),
                              farthest(second, 120 - dx, 110 - dy, 120 + dx, 110 + dy));
            if (off >= 2) {
                print_message("at %g degrees, %g wide: off by %.1f\n", angles[a], widths[w], off);
            }
            assert_true(off < 2);
            assert_true(last_x(first) - first_x(first) > 180);
            duct_drawing_free(drawing);
            free(page.grey);
        }
    }
}

static void branch_ends_at_the_line_that_runs_through(void **state)
{
    (void)state;
    picture page = new_picture(240, 160, 255);
    draw_line(&page, 20, 50, 220, 50, 6, 0);
    draw_line(&page, 120, 50, 120, 140, 6, 0);
    duct_drawing *drawing = trace(&page, NULL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_true(farthest(duct_drawing_stroke(drawing, 0), 20, 50, 220, 50) < 1.5);
    const duct_stroke *branch = duct_drawing_stroke(drawing, 1);
    assert_float_equal(first_y(branch), 50, 2);
    assert_float_equal(last_y(branch), 140, 5);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void corner_stays_a_corner_of_one_stroke(void **state)
{
    (void)state;
    picture page = new_picture(200, 200, 255);
    draw_line(&page, 30, 30, 150, 30, 4, 0);
    draw_line(&page, 150, 30, 150, 160, 4, 0);
    duct_drawing *drawing = trace(&page, NULL);
    const duct_stroke *stroke = only_stroke(drawing);
    assert_false(duct_stroke_closed(stroke));
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    double nearest = INFINITY;
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        nearest = fmin(nearest, hypot(x[i] - 150, y[i] - 30));
    }
    assert_true(nearest < 3);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void parts_come_in_reading_order(void **state)
{
    (void)state;
    picture page = new_picture(300, 200, 255);
    /* Drawn in disorder: two lines of three letters each. */
    static const double places[6][2] = {{200, 120}, {40, 40}, {120, 122}, {200, 44}, {40, 118}, {120, 42}};
    for (size_t i = 0; i < 6; i++) {
        draw_ring(&page, places[i][0], places[i][1], 18, 3, 0);
    }
    duct_drawing *drawing = trace(&page, NULL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 6);
    for (size_t i = 0; i < 6; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        assert_float_equal(first_x(stroke), 40 + 80 * (float)(i % 3), 8);
        assert_float_equal(first_y(stroke), i < 3 ? 24 : 102, 8);
    }
    duct_drawing_free(drawing);
    free(page.grey);
}

static void uneven_light_makes_no_difference(void **state)
{
    (void)state;
    picture page = new_picture(400, 300, 255);
    for (int y = 0; y < 300; y++) {
        for (int x = 0; x < 400; x++) {
            /* From bright to dusky; the darkest paper is darker than the lightest ink. */
            page.grey[y * 400 + x] = (uint8_t)(235 - 0.38 * x + ((x * 7919 + y * 104729) % 11 - 5));
        }
    }
    for (int line = 0; line < 5; line++) {
        for (int y = 40 + 50 * line; y < 44 + 50 * line; y++) {
            for (int x = 20; x < 380; x++) {
                page.grey[y * 400 + x] = (uint8_t)(page.grey[y * 400 + x] * 0.45);
            }
        }
    }
    duct_drawing *drawing = trace(&page, NULL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 5);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void light_ink_on_dark_ground_is_found_too(void **state)
{
    (void)state;
    picture page = new_picture(200, 140, 30);
    draw_line(&page, 20, 20, 180, 120, 5, 240);
    duct_drawing *drawing = trace(&page, NULL);
    assert_true(farthest(only_stroke(drawing), 20, 20, 180, 120) < 1.2);
    duct_drawing_free(drawing);
    /* Where dark ink was asked for, the ground is ink: an area. */
    duct_lineart_options options = duct_lineart_options_default();
    options.ink = DUCT_INK_DARK;
    options.widest = 20;
    drawing = trace(&page, &options);
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        assert_true(farthest(duct_drawing_stroke(drawing, i), 20, 20, 180, 120) > 3);
    }
    duct_drawing_free(drawing);
    free(page.grey);
}

static void areas_and_specks_are_left_out(void **state)
{
    (void)state;
    picture page = new_picture(300, 200, 255);
    draw_line(&page, 20, 20, 280, 20, 5, 0);
    draw_line(&page, 150, 120, 151, 120, 120, 0); /* a disc */
    draw_line(&page, 20, 60, 20, 60, 2, 0);       /* a speck */
    draw_line(&page, 40, 60, 40, 60, 9, 0);       /* a dot */
    duct_lineart_options options = duct_lineart_options_default();
    options.widest = 60;
    duct_drawing *drawing = trace(&page, &options);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    const duct_stroke *dot = duct_drawing_stroke(drawing, 1);
    assert_true(duct_stroke_size(dot) <= 3);
    assert_float_equal(first_x(dot), 40, 2);
    assert_float_equal(duct_stroke_get_style(dot).width, 9, 1.5);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void threshold_can_be_given(void **state)
{
    (void)state;
    picture page = new_picture(200, 100, 255);
    draw_line(&page, 20, 30, 180, 30, 5, 170); /* pale */
    draw_line(&page, 20, 70, 180, 70, 5, 0);
    duct_lineart_options options = duct_lineart_options_default();
    options.threshold = 0.2;
    duct_drawing *drawing = trace(&page, &options);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    duct_drawing_free(drawing);
    options.threshold = 0.7;
    drawing = trace(&page, &options);
    assert_float_equal(first_y(only_stroke(drawing)), 70, 1);
    duct_drawing_free(drawing);
    free(page.grey);
}

/* So that a variation by id stays the same for the rest of a drawing. */
static void ids_follow_from_the_place(void **state)
{
    (void)state;
    picture page = new_picture(300, 200, 255);
    draw_line(&page, 40, 150, 250, 130, 5, 0);
    duct_drawing *one = trace(&page, NULL);
    draw_line(&page, 20, 20, 100, 60, 5, 0);
    duct_drawing *both = trace(&page, NULL);
    assert_int_equal(duct_drawing_stroke_count(both), 2);
    assert_string_equal(duct_stroke_id(only_stroke(one)), duct_stroke_id(duct_drawing_stroke(both, 1)));
    assert_string_not_equal(duct_stroke_id(duct_drawing_stroke(both, 0)),
                            duct_stroke_id(duct_drawing_stroke(both, 1)));
    duct_drawing_free(one);
    duct_drawing_free(both);
    free(page.grey);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(line_is_found_where_it_is),
        cmocka_unit_test(ring_is_one_closed_stroke),
        cmocka_unit_test(strokes_go_straight_on_through_crossings),
        cmocka_unit_test(branch_ends_at_the_line_that_runs_through),
        cmocka_unit_test(corner_stays_a_corner_of_one_stroke),
        cmocka_unit_test(parts_come_in_reading_order),
        cmocka_unit_test(uneven_light_makes_no_difference),
        cmocka_unit_test(light_ink_on_dark_ground_is_found_too),
        cmocka_unit_test(areas_and_specks_are_left_out),
        cmocka_unit_test(threshold_can_be_given),
        cmocka_unit_test(ids_follow_from_the_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
