/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

static duct_error error;

static void page_and_resolution_give_the_size(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("ink");
    duct_drawing *drawing = new_drawing();
    duct_drawing_set_page(drawing, 200, 96.0000001);
    add_mark(drawing, &neutral_mark);
    duct_render_options options = duct_render_options_default();
    duct_canvas *canvas = NULL;
    assert_ok(duct_render(NULL, drawing, brush, NULL, &canvas, &error));
    assert_int_equal(duct_canvas_width(canvas), 200);
    assert_int_equal(duct_canvas_height(canvas), 96);
    double area = painted_area(canvas);
    duct_canvas_free(canvas);
    options.resolution = 300;
    assert_ok(duct_render(NULL, drawing, brush, &options, &canvas, &error));
    assert_int_equal(duct_canvas_width(canvas), 625);
    assert_int_equal(duct_canvas_height(canvas), 300);
    assert_near(painted_area(canvas) / area / (300.0 / 96 * 300 / 96), 1, 0.05);
    duct_canvas_free(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

static void no_page_means_the_strokes_and_a_margin(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("bristle");
    duct_drawing *drawing = new_drawing();
    mark m = neutral_mark;
    m.pressure = 1;
    add_mark(drawing, &m);
    duct_canvas *paged = NULL, *free_size = NULL;
    assert_ok(duct_render(NULL, drawing, brush, NULL, &paged, &error));
    duct_drawing_set_page(drawing, 0, 0);
    assert_ok(duct_render(NULL, drawing, brush, NULL, &free_size, &error));
    assert_near(painted_area(free_size) / painted_area(paged), 1, 0.02);
    assert_true(duct_canvas_width(free_size) < 230 && duct_canvas_height(free_size) < 140);
    duct_canvas_free(paged);
    duct_canvas_free(free_size);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

static void empty_drawing_gives_an_empty_canvas(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("ink");
    duct_drawing *drawing = new_drawing();
    duct_canvas *canvas = NULL;
    assert_ok(duct_render(NULL, drawing, brush, NULL, &canvas, &error));
    assert_true(painted_area(canvas) == 0);
    duct_canvas_free(canvas);
    duct_drawing_set_page(drawing, 0, 0);
    assert_ok(duct_render(NULL, drawing, brush, NULL, &canvas, &error));
    duct_canvas_free(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

static void too_large_images_are_refused(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("ink");
    duct_drawing *drawing = new_drawing();
    duct_render_options options = duct_render_options_default();
    duct_canvas *canvas = NULL;
    options.resolution = 1e9;
    assert_int_equal(duct_render(NULL, drawing, brush, &options, &canvas, &error), DUCT_LIMIT);
    assert_non_null(strstr(error.message, "resolution"));
    duct_drawing_set_page(drawing, 1e300, 10);
    assert_int_equal(duct_render(NULL, drawing, brush, NULL, &canvas, &error), DUCT_LIMIT);
    duct_drawing_set_page(drawing, 0, 0);
    duct_stroke *stroke = add_mark(drawing, &neutral_mark);
    duct_stroke_edit(stroke, DUCT_X)[3] = 1e12;
    assert_int_equal(duct_render(NULL, drawing, brush, NULL, &canvas, &error), DUCT_LIMIT);
    assert_null(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

typedef struct listener {
    int calls, cancel_at;
    double last;
} listener;

static bool hear(void *user, double fraction)
{
    listener *self = user;
    assert_true(fraction >= self->last && fraction <= 1);
    self->last = fraction;
    return ++self->calls != self->cancel_at;
}

static void progress_and_cancel(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("ink");
    duct_drawing *drawing = new_drawing();
    for (int i = 0; i < 10; i++) {
        add_mark(drawing, &neutral_mark);
    }
    listener ear = {0, 0, 0};
    duct_context context = duct_context_default();
    context.progress = hear;
    context.progress_user = &ear;
    duct_canvas *canvas = NULL;
    assert_ok(duct_render(&context, drawing, brush, NULL, &canvas, &error));
    assert_true(ear.calls >= 10);
    assert_true(ear.last == 1);
    duct_canvas_free(canvas);
    canvas = NULL;
    ear = (listener){0, 4, 0};
    assert_int_equal(duct_render(&context, drawing, brush, NULL, &canvas, &error), DUCT_CANCELLED);
    assert_int_equal(ear.calls, 4);
    assert_null(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    duct_brush *brush = load_brush("ink");
    duct_drawing *drawing = new_drawing();
    add_mark(drawing, &neutral_mark);
    for (long n = 1;; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_canvas *canvas = NULL;
        duct_status status = duct_render(&context, drawing, brush, NULL, &canvas, &error);
        duct_canvas_free(canvas);
        assert_int_equal(failing.held, 0);
        if (failing.calls < n) {
            assert_int_equal(status, DUCT_OK);
            break;
        }
        assert_int_equal(status, DUCT_NO_MEMORY);
        assert_null(canvas);
    }
    duct_drawing_free(drawing);
    duct_brush_free(brush);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(page_and_resolution_give_the_size),
        cmocka_unit_test(no_page_means_the_strokes_and_a_margin),
        cmocka_unit_test(empty_drawing_gives_an_empty_canvas),
        cmocka_unit_test(too_large_images_are_refused),
        cmocka_unit_test(progress_and_cancel),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
