/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

#include "brush/dab.h"

static duct_error error;

static double changed(const duct_brush *brush, const mark *m)
{
    duct_canvas *plain = paint_mark(brush, &neutral_mark, NULL), *other = paint_mark(brush, m, NULL);
    double amount = difference(plain, other, false);
    duct_canvas_free(plain);
    duct_canvas_free(other);
    return amount;
}

static void marks_depend_on_pressure_tilt_and_twist(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        mark pressed = neutral_mark, leant_right = neutral_mark, leant_down = neutral_mark,
             turned = neutral_mark;
        pressed.pressure = 0.9;
        leant_right.tilt_x = 0.9;
        leant_down.tilt_y = 0.9;
        turned.twist = 0.8;
        assert_true(changed(brush, &pressed) > 0.2);
        assert_true(changed(brush, &leant_right) > 0.08);
        assert_true(changed(brush, &leant_down) > 0.08);
        bool round = strcmp(own_brushes[b], "bristle") == 0 || strcmp(own_brushes[b], "ink") == 0 ||
                     strcmp(own_brushes[b], "pencil") == 0;
        assert_true(changed(brush, &turned) > (round ? 0.04 : 0.15));
        duct_brush_free(brush);
    }
}

static void pressure_widens(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        double before = 0;
        for (int i = 0; i <= 4; i++) {
            mark m = neutral_mark;
            m.pressure = i / 4.0;
            duct_canvas *canvas = paint_mark(brush, &m, NULL);
            double area = painted_area(canvas);
            assert_true(i == 0 ? area < 1 : area > 1.1 * before);
            before = area;
            duct_canvas_free(canvas);
        }
        duct_brush_free(brush);
    }
}

static void upright_pen_has_no_direction(void **state)
{
    (void)state;
    mark hair = neutral_mark;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        for (int i = 0; i < 4; i++) {
            hair.tilt_x = 1e-5 * cos(i * 1.6);
            hair.tilt_y = 1e-5 * sin(i * 1.6);
            assert_true(changed(brush, &hair) < 0.01);
        }
        duct_brush_free(brush);
    }
}

static void turning_stroke_and_pose_turns_the_mark(void **state)
{
    (void)state;
    mark leant = neutral_mark, turned;
    leant.tilt_x = 0.6;
    leant.tilt_y = -0.3;
    leant.twist = 0.4;
    turned = leant;
    turned.turn = 1;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        if (strcmp(own_brushes[b], "flat-nib") == 0) {
            continue; /* its answer to the tilt's direction is tied to the page, as a wrist's is */
        }
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *one = paint_mark(brush, &leant, NULL), *two = paint_mark(brush, &turned, NULL);
        if (is_grainy(own_brushes[b])) { /* the paper stays where it is */
            assert_near(painted_area(two) / painted_area(one), 1, 0.06);
        } else {
            assert_true(difference(one, two, true) < 0.03);
        }
        assert_true(difference(one, two, false) > 0.5);
        duct_canvas_free(one);
        duct_canvas_free(two);
        duct_brush_free(brush);
    }
    leant.tilt_x = leant.tilt_y = turned.tilt_x = turned.tilt_y = 0;
    duct_brush *brush = load_brush("flat-nib");
    duct_canvas *one = paint_mark(brush, &leant, NULL), *two = paint_mark(brush, &turned, NULL);
    assert_true(difference(one, two, true) < 0.03);
    duct_canvas_free(one);
    duct_canvas_free(two);
    duct_brush_free(brush);
}

/* Twist is clockwise as seen: a nib that lies along the x axis and turns by a quarter of a half turn is a
 * falling diagonal. */
static void twist_is_clockwise(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("flat-nib");
    duct_drawing *drawing = new_drawing();
    duct_stroke *stroke = NULL;
    assert_ok(duct_drawing_add_stroke(drawing, "", 1, &stroke, &error));
    duct_stroke_edit(stroke, DUCT_X)[0] = duct_stroke_edit(stroke, DUCT_Y)[0] = 64;
    duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, 1, 60});
    /* The nib's edge is at 135 degrees, so an eighth of a turn back lays it along the y axis. */
    duct_stroke_edit(stroke, DUCT_TWIST)[0] = -0.7853981633974483 + 0.3;
    duct_canvas *canvas = new_canvas(128, 128);
    assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
    /* 0.3 radians clockwise from the vertical: right of the middle below... is left: (-sin, cos). */
    assert_true(pixel_value(canvas, 64 - 6, 64 + 20, 3) > 20000);
    assert_int_equal(pixel_value(canvas, 64 + 6, 64 + 20, 3), 0);
    assert_true(pixel_value(canvas, 64 + 6, 64 - 20, 3) > 20000);
    duct_canvas_free(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

static void seed_and_id_vary_random_brushes_only(void **state)
{
    (void)state;
    duct_paint_options seeded = duct_paint_options_default();
    seeded.seed = 7;
    mark renamed = neutral_mark;
    renamed.id = "another";
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *plain = paint_mark(brush, &neutral_mark, NULL);
        duct_canvas *other = paint_mark(brush, &neutral_mark, &seeded),
                    *named = paint_mark(brush, &renamed, NULL);
        bool random = strstr(own_brushes[b], "bristle") != NULL;
        assert_int_equal(same_pixels(plain, other), !random);
        assert_int_equal(same_pixels(plain, named), !random);
        duct_canvas_free(plain);
        duct_canvas_free(other);
        duct_canvas_free(named);
        duct_brush_free(brush);
    }
}

static void marks_keep_their_shape_at_any_scale(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *plain = paint_mark(brush, &neutral_mark, NULL);
        duct_drawing *drawing = new_drawing();
        const duct_stroke *stroke = add_mark(drawing, &neutral_mark);
        double area = painted_area(plain);
        for (double scale = 0.25; scale <= 8; scale *= 2) {
            duct_paint_options options = duct_paint_options_default();
            options.scale = scale;
            duct_canvas *scaled = new_canvas((int)(MARK_SIDE * scale), (int)(MARK_SIDE * scale));
            assert_ok(duct_canvas_paint(scaled, brush, stroke, &options, &error));
            assert_near(painted_area(scaled) / (scale * scale) / area, 1, scale < 1 ? 0.2 : 0.07);
            duct_canvas_free(scaled);
        }
        duct_canvas_free(plain);
        duct_drawing_free(drawing);
        duct_brush_free(brush);
    }
}

static void lines_are_smooth_and_as_wide_as_asked(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("ink");
    duct_drawing *drawing = new_drawing();
    for (double width = 0.5; width < 40; width *= 1.7) {
        duct_stroke *stroke = NULL;
        assert_ok(duct_drawing_add_stroke(drawing, "", 2, &stroke, &error));
        duct_stroke_edit(stroke, DUCT_X)[0] = -50;
        duct_stroke_edit(stroke, DUCT_X)[1] = 300;
        duct_stroke_edit(stroke, DUCT_Y)[0] = 20;
        duct_stroke_edit(stroke, DUCT_Y)[1] = 70;
        duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, 1, width});
        duct_canvas *canvas = new_canvas(256, 128);
        assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
        double least = 1e9, most = 0;
        for (int x = 20; x < 236; x++) {
            double column = 0;
            for (int y = 0; y < 128; y++) {
                column += pixel_value(canvas, x, y, 3) / 32768.0;
            }
            least = fmin(least, column);
            most = fmax(most, column);
        }
        assert_true(most - least < 0.015 * most + 0.005); /* no beads */
        assert_near((least + most) / 2 / (width * 1.0102), 1, 0.04);
        duct_canvas_free(canvas);
    }
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

static void colour_and_opacity_come_from_the_style(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_drawing *drawing = new_drawing();
        duct_stroke *stroke = NULL;
        const double x[] = {40, 200, 40}, y[] = {128, 128, 128.5};
        assert_ok(duct_drawing_add_stroke(drawing, "", 3, &stroke, &error));
        for (int i = 0; i < 3; i++) {
            duct_stroke_edit(stroke, DUCT_X)[i] = x[i];
            duct_stroke_edit(stroke, DUCT_Y)[i] = y[i];
        }
        double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE);
        pressure[0] = pressure[1] = pressure[2] = 0.7;
        duct_stroke_set_style(stroke, (duct_stroke_style){1, 0.5f, 0, 0.5f, 40});
        duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
        assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
        /* Painted over itself, and still half transparent. */
        double alpha = value_around(canvas, 120, 128, 3) / 32768.0;
        assert_true(alpha > 0.4 && alpha < 0.51);
        assert_near(value_around(canvas, 120, 128, 0) / 32768.0 / alpha, 1, 0.25);
        assert_near(value_around(canvas, 120, 128, 1) / 32768.0 / alpha, 0.5, 0.25);
        duct_canvas_free(canvas);
        duct_drawing_free(drawing);
        duct_brush_free(brush);
    }
}

static void one_sample_gives_a_dot(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        for (size_t size = 0; size < 4; size++) {
            duct_drawing *drawing = new_drawing();
            duct_stroke *stroke = NULL;
            assert_ok(duct_drawing_add_stroke(drawing, "", size, &stroke, &error));
            for (size_t i = 0; i < size; i++) {
                duct_stroke_edit(stroke, DUCT_X)[i] = 100;
                duct_stroke_edit(stroke, DUCT_Y)[i] = 90;
            }
            duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, 1, 20});
            duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
            assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
            double area = painted_area(canvas);
            if (size == 0) {
                assert_true(area == 0);
            } else {
                assert_true(area > 20 && area < 420);
                assert_true(value_around(canvas, 100, 90, 3) > 10000);
            }
            duct_canvas_free(canvas);
            duct_drawing_free(drawing);
        }
        duct_brush_free(brush);
    }
}

static void thin_dabs_keep_their_area(void **state)
{
    (void)state;
    for (double radius = 0.3; radius < 30; radius *= 1.6) {
        for (double ratio = 1; ratio < 20; ratio *= 2) {
            duct_canvas *canvas = new_canvas(128, 128);
            const duct_dab dab = {64.3, 63.8, radius, ratio, 0.4, 1, 1, 0, 0, 0, 1, false};
            duct_dab_paint(canvas, &dab);
            double area = 3.14159265 * radius * radius / ratio;
            assert_near(painted_area(canvas) / area, 1, radius / ratio < 1 ? 0.45 : 0.06);
            duct_canvas_free(canvas);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(marks_depend_on_pressure_tilt_and_twist),
        cmocka_unit_test(pressure_widens),
        cmocka_unit_test(upright_pen_has_no_direction),
        cmocka_unit_test(turning_stroke_and_pose_turns_the_mark),
        cmocka_unit_test(twist_is_clockwise),
        cmocka_unit_test(seed_and_id_vary_random_brushes_only),
        cmocka_unit_test(marks_keep_their_shape_at_any_scale),
        cmocka_unit_test(lines_are_smooth_and_as_wide_as_asked),
        cmocka_unit_test(colour_and_opacity_come_from_the_style),
        cmocka_unit_test(one_sample_gives_a_dot),
        cmocka_unit_test(thin_dabs_keep_their_area),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
