/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

#include "brush/grain.h"

static duct_error error;

static const char *const grainy_brushes[] = {"charcoal", "pencil"};
enum { GRAINY = 2 };

static void heights_are_smooth_with_mean_0_and_variance_1(void **state)
{
    (void)state;
    enum { side = 500 };
    double sum = 0, squares = 0, step = 0;
    for (int j = 0; j < side; j++) {
        for (int i = 0; i < side; i++) {
            double missing;
            const double height = duct_grain_height(i * 0.173, j * 0.169 - 31, 1e-9, &missing);
            assert_near(missing, 0, 1e-12);
            sum += height;
            squares += height * height;
            step = fmax(step,
                        fabs(duct_grain_height(i * 0.173 + 0.001, j * 0.169 - 31, 1e-9, &missing) - height));
        }
    }
    const double count = (double)side * side;
    assert_near(sum / count, 0, 0.03);
    assert_near(squares / count, 1, 0.05);
    assert_true(step < 0.05);
}

static void pixels_that_are_too_coarse_see_no_grain(void **state)
{
    (void)state;
    double variance[4] = {0}, missing[4];
    static const double pixels[] = {0.01, 0.3, 0.8, 5};
    for (int p = 0; p < 4; p++) {
        for (int k = 0; k < 4000; k++) {
            const double height = duct_grain_height(k * 0.71, k * 1.37, pixels[p], &missing[p]);
            variance[p] += height * height / 4000;
        }
        assert_near(variance[p] + missing[p], 1, 0.1);
    }
    assert_true(variance[0] > variance[1] && variance[1] > variance[2] && variance[2] > variance[3]);
    assert_true(variance[3] == 0);
}

static void hostile_places_have_finite_heights(void **state)
{
    (void)state;
    static const double values[] = {0, -0.0, 1e15, -1e15, 1e300, -1e300, 1e-300, 12345.678};
    for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
        for (size_t j = 0; j < sizeof values / sizeof values[0]; j++) {
            for (double pixel = 1e-300; pixel < 1e300; pixel *= 1e50) {
                double missing;
                assert_true(isfinite(duct_grain_height(values[i], values[j], pixel, &missing)));
                assert_true(missing >= 0 && missing <= 1 + 1e-12);
            }
        }
    }
}

/* A square of one tone. */
static duct_canvas *toned(double tone)
{
    duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
    for (int ty = 0; ty < MARK_SIDE / DUCT_TILE_SIZE; ty++) {
        for (int tx = 0; tx < MARK_SIDE / DUCT_TILE_SIZE; tx++) {
            uint16_t *tile = duct_canvas_touch(canvas, tx, ty);
            assert_non_null(tile);
            for (int k = 0; k < DUCT_TILE_PIXELS; k++) {
                tile[k * 4] = tile[k * 4 + 3] = (uint16_t)lround(tone * DUCT_FIX_ONE);
            }
        }
    }
    return canvas;
}

static void tones_are_kept_in_the_mean_at_every_depth_and_resolution(void **state)
{
    (void)state;
    for (double depth = 0; depth <= 4; depth += 1) {
        for (double tone = 0.1; tone < 1; tone += 0.2) {
            for (double scale = 0.25; scale <= 2; scale *= 2) {
                const duct_grain grain = {depth, 2, 1};
                duct_paint_options options = duct_paint_options_default();
                options.scale = scale;
                duct_canvas *canvas = toned(tone);
                duct_grain_apply(canvas, &grain, &options);
                assert_near(painted_area(canvas) / (MARK_SIDE * MARK_SIDE), tone, 0.035);
                for (int x = 0; x < MARK_SIDE; x++) { /* premultiplied colours follow the alpha */
                    assert_near(pixel_value(canvas, x, 99, 0), pixel_value(canvas, x, 99, 3), 1);
                }
                duct_canvas_free(canvas);
            }
        }
    }
}

static void more_pressing_never_gives_less_and_all_of_it_covers(void **state)
{
    (void)state;
    const duct_grain grain = {2, 3, 0.9};
    const duct_paint_options options = duct_paint_options_default();
    duct_canvas *before = toned(0.05);
    duct_grain_apply(before, &grain, &options);
    for (double tone = 0.15; tone < 1.2; tone += 0.17) {
        duct_canvas *canvas = toned(fmin(tone, 1));
        duct_grain_apply(canvas, &grain, &options);
        for (int i = 0; i < MARK_SIDE; i++) {
            assert_true(pixel_value(canvas, i, 77, 3) >= pixel_value(before, i, 77, 3));
            if (tone > 1) {
                assert_near(pixel_value(canvas, i, 77, 3) / 32768.0, 0.9, 0.001);
            }
        }
        duct_canvas_free(before);
        before = canvas;
    }
    duct_canvas_free(before);
}

static duct_canvas *paint_moved(const duct_brush *brush, const char *id, double offset_x, double shift_x)
{
    duct_drawing *drawing = new_drawing();
    mark m = neutral_mark;
    m.id = id;
    duct_stroke *stroke = add_mark(drawing, &m);
    for (int i = 0; i < MARK_SAMPLES; i++) {
        duct_stroke_edit(stroke, DUCT_X)[i] += shift_x;
    }
    duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
    duct_paint_options options = duct_paint_options_default();
    options.offset_x = offset_x;
    options.seed = strlen(id);
    assert_ok(duct_canvas_paint(canvas, brush, stroke, &options, &error));
    duct_drawing_free(drawing);
    return canvas;
}

static void grain_belongs_to_the_page(void **state)
{
    (void)state;
    for (int b = 0; b < GRAINY; b++) {
        duct_brush *brush = load_brush(grainy_brushes[b]);
        duct_canvas *plain = paint_moved(brush, "a", 0, 0), *named = paint_moved(brush, "another", 0, 0);
        duct_canvas *panned = paint_moved(brush, "a", 16, 0), *moved = paint_moved(brush, "a", 0, 16);
        assert_true(same_pixels(plain, named)); /* whatever the stroke is called, whatever the seed */
        double other_place = 0, other_paper = 0;
        for (int y = 0; y < MARK_SIDE; y++) {
            for (int x = 16; x < MARK_SIDE; x++) {
                const double here = pixel_value(plain, x - 16, y, 3) / 32768.0;
                other_place += fabs(pixel_value(panned, x, y, 3) / 32768.0 - here);
                other_paper += fabs(pixel_value(moved, x, y, 3) / 32768.0 - here);
            }
        }
        assert_true(other_place < 0.01 * painted_area(plain)); /* the paper moves with the drawing's place */
        assert_true(other_paper > 0.1 * painted_area(plain));  /* but not with the stroke */
        duct_canvas_free(plain);
        duct_canvas_free(named);
        duct_canvas_free(panned);
        duct_canvas_free(moved);
        duct_brush_free(brush);
    }
}

static void strokes_build_up_on_the_same_peaks(void **state)
{
    (void)state;
    for (int b = 0; b < GRAINY; b++) {
        duct_brush *brush = load_brush(grainy_brushes[b]);
        duct_drawing *drawing = new_drawing();
        mark light = neutral_mark;
        light.pressure = 0.3;
        const duct_stroke *stroke = add_mark(drawing, &light);
        duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
        double area[5] = {0};
        for (int i = 1; i < 5; i++) {
            assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
            area[i] = painted_area(canvas);
            assert_true(area[i] > 1.02 * area[i - 1]);
        }
        /* Were each stroke's grain its own, the valleys would fill faster: 1 - (1 - p)^2. */
        assert_true(area[2] < 1.7 * area[1]);
        duct_canvas_free(canvas);
        duct_drawing_free(drawing);
        duct_brush_free(brush);
    }
}

/* Along a straight line of even pose no place repeats another: what differs between columns is the grain,
 * and it differs as much at any distance, that of the dabs included. */
static void marks_show_no_dabs(void **state)
{
    (void)state;
    for (int b = 0; b < GRAINY; b++) {
        duct_brush *brush = load_brush(grainy_brushes[b]);
        duct_drawing *drawing = new_drawing();
        duct_stroke *stroke = NULL;
        assert_ok(duct_drawing_add_stroke(drawing, "", 2, &stroke, &error));
        duct_stroke_edit(stroke, DUCT_X)[0] = 20;
        duct_stroke_edit(stroke, DUCT_X)[1] = 490;
        duct_stroke_edit(stroke, DUCT_Y)[0] = duct_stroke_edit(stroke, DUCT_Y)[1] = 64;
        duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, 1, 40});
        duct_canvas *canvas = new_canvas(512, 128);
        assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
        double column[512] = {0}, mean = 0, variance = 0;
        for (int x = 60; x < 440; x++) {
            for (int y = 0; y < 128; y++) {
                column[x] += pixel_value(canvas, x, y, 3) / 32768.0;
            }
            mean += column[x] / 380;
        }
        for (int x = 60; x < 440; x++) {
            variance += (column[x] - mean) * (column[x] - mean) / 380;
        }
        assert_true(sqrt(variance) < 0.25 * mean);
        for (int lag = 12; lag < 60; lag++) {
            double product = 0;
            for (int x = 60; x < 440 - lag; x++) {
                product += (column[x] - mean) * (column[x + lag] - mean) / (380 - lag);
            }
            assert_true(product < 0.4 * variance);
        }
        duct_canvas_free(canvas);
        duct_drawing_free(drawing);
        duct_brush_free(brush);
    }
}

static double area_of(const duct_brush *brush, double pressure, double tilt, double *most)
{
    mark m = neutral_mark;
    m.pressure = pressure;
    m.tilt_y = tilt;
    duct_canvas *canvas = paint_mark(brush, &m, NULL);
    const double area = painted_area(canvas);
    int touched = 0;
    for (int y = 0; y < MARK_SIDE; y++) {
        for (int x = 0; x < MARK_SIDE; x++) {
            touched += pixel_value(canvas, x, y, 3) > 1000;
        }
    }
    *most = touched;
    duct_canvas_free(canvas);
    return area;
}

static void leaning_widens_and_lightens(void **state)
{
    (void)state;
    for (int b = 0; b < GRAINY; b++) {
        duct_brush *brush = load_brush(grainy_brushes[b]);
        double upright, leant, light;
        const double tone_upright = area_of(brush, 0.5, 0, &upright) / upright;
        const double tone_leant = area_of(brush, 0.5, 0.9, &leant) / leant;
        const double tone_light = area_of(brush, 0.15, 0, &light) / light;
        assert_true(leant > 1.4 * upright);
        assert_true(tone_leant < 0.9 * tone_upright);
        assert_true(light < 0.8 * upright && tone_light < tone_upright);
        duct_brush_free(brush);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(heights_are_smooth_with_mean_0_and_variance_1),
        cmocka_unit_test(pixels_that_are_too_coarse_see_no_grain),
        cmocka_unit_test(hostile_places_have_finite_heights),
        cmocka_unit_test(tones_are_kept_in_the_mean_at_every_depth_and_resolution),
        cmocka_unit_test(more_pressing_never_gives_less_and_all_of_it_covers),
        cmocka_unit_test(grain_belongs_to_the_page),
        cmocka_unit_test(strokes_build_up_on_the_same_peaks),
        cmocka_unit_test(marks_show_no_dabs),
        cmocka_unit_test(leaning_widens_and_lightens),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
