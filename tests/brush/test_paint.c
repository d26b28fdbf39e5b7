/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

#include <time.h>

static duct_error error;

static double seconds_since(clock_t begin)
{
    return (double)(clock() - begin) / CLOCKS_PER_SEC;
}

static void hostile_strokes_end_quickly_and_safely(void **state)
{
    (void)state;
    static const double values[] = {NAN,    INFINITY, -INFINITY, 1e12, -1e12, 1e300,
                                    -1e300, 0,        50,        1e9,  65536, -0.0};
    enum { count = sizeof values / sizeof values[0], size = 60 };
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *canvas = new_canvas(100, 100);
        duct_drawing *drawing = new_drawing();
        duct_stroke *stroke = NULL;
        assert_ok(duct_drawing_add_stroke(drawing, "", size, &stroke, &error));
        unsigned mix = 1;
        for (int channel = 0; channel < DUCT_CHANNEL_COUNT; channel++) {
            double *numbers = duct_stroke_edit(stroke, (duct_channel)channel);
            for (int i = 0; i < size; i++) {
                mix = mix * 1103515245u + 12345u;
                numbers[i] = values[(mix >> 16) % count];
            }
        }
        duct_stroke_set_closed(stroke, true);
        clock_t begin = clock();
        for (double width = 1e-9; width < 1e12; width *= 1e3) {
            duct_stroke_set_style(stroke, (duct_stroke_style){NAN, -1, 2, 1, width});
            assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
        }
        duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, NAN, NAN});
        assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
        assert_true(seconds_since(begin) < 20);
        duct_paint_options options = duct_paint_options_default();
        options.scale = NAN;
        assert_int_equal(duct_canvas_paint(canvas, brush, stroke, &options, &error), DUCT_BAD_ARGUMENT);
        options.scale = 0;
        assert_int_equal(duct_canvas_paint(canvas, brush, stroke, &options, &error), DUCT_BAD_ARGUMENT);
        duct_canvas_free(canvas);
        duct_drawing_free(drawing);
        duct_brush_free(brush);
    }
}

static void million_samples_are_painted(void **state)
{
    (void)state;
    enum { million = 1000000 };
    duct_drawing *drawing = new_drawing();
    duct_stroke *stroke = NULL;
    assert_ok(duct_drawing_add_stroke(drawing, "", million, &stroke, &error));
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    for (int i = 0; i < million; i++) {
        x[i] = 128 + 100 * cos(i * 1e-5);
        y[i] = 128 + 100 * sin(i * 1e-5);
    }
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
        assert_ok(duct_canvas_paint(canvas, brush, stroke, NULL, &error));
        assert_true(painted_area(canvas) > 300);
        duct_canvas_free(canvas);
        duct_brush_free(brush);
    }
    duct_drawing_free(drawing);
}

static void only_painted_tiles_exist(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("bristle");
    duct_canvas *canvas = new_canvas(65536, 65536);
    duct_drawing *drawing = new_drawing();
    duct_paint_options options = duct_paint_options_default();
    options.offset_x = 60000;
    options.offset_y = 50000;
    assert_ok(duct_canvas_paint(canvas, brush, add_mark(drawing, &neutral_mark), &options, &error));
    int tiles = 0;
    for (int ty = 0; ty < 1024; ty++) {
        for (int tx = 0; tx < 1024; tx++) {
            tiles += duct_canvas_tile(canvas, tx, ty) != NULL;
        }
    }
    assert_true(tiles >= 3 && tiles <= 20);
    assert_null(duct_canvas_tile(canvas, -1, 0));
    assert_null(duct_canvas_tile(canvas, 0, 1024));
    duct_canvas_free(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
    assert_int_equal(duct_canvas_new(NULL, 65537, 1, &canvas, &error), DUCT_LIMIT);
    assert_int_equal(duct_canvas_new(NULL, 1, 0, &canvas, &error), DUCT_LIMIT);
    assert_int_equal(duct_canvas_new(NULL, -5, 7, &canvas, &error), DUCT_LIMIT);
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_drawing *drawing = new_drawing();
        duct_stroke *stroke = add_mark(drawing, &neutral_mark);
        duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, 0.5f, 6}); /* takes a layer too */
        for (long n = 1;; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            duct_context context = duct_context_default();
            context.allocator = &failing.allocator;
            duct_canvas *canvas = NULL;
            duct_status status = duct_canvas_new(&context, MARK_SIDE, MARK_SIDE, &canvas, &error);
            if (status == DUCT_OK) {
                status = duct_canvas_paint(canvas, brush, stroke, NULL, &error);
            }
            duct_canvas_free(canvas);
            assert_int_equal(failing.held, 0);
            if (failing.calls < n) {
                assert_int_equal(status, DUCT_OK);
                break;
            }
            assert_int_equal(status, DUCT_NO_MEMORY);
        }
        duct_drawing_free(drawing);
        duct_brush_free(brush);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(hostile_strokes_end_quickly_and_safely),
        cmocka_unit_test(million_samples_are_painted),
        cmocka_unit_test(only_painted_tiles_exist),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
