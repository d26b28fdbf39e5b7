/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures that nobody drew, and what can go wrong. */
#include "lineart/pictures.h"

static size_t count_of(picture *page)
{
    duct_drawing *drawing = trace(page, NULL);
    size_t count = duct_drawing_stroke_count(drawing);
    duct_drawing_free(drawing);
    free(page->grey);
    return count;
}

static void even_pictures_have_no_lines(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {1, 300}, {300, 1}, {63, 65}, {500, 400}};
    static const uint8_t levels[] = {0, 1, 128, 254, 255};
    for (size_t i = 0; i < 5; i++) {
        for (size_t k = 0; k < 5; k++) {
            picture page = new_picture(sizes[i][0], sizes[i][1], levels[k]);
            assert_int_equal(count_of(&page), 0);
        }
    }
}

static void one_pixel_is_a_dot_where_specks_are_kept(void **state)
{
    (void)state;
    picture page = new_picture(40, 30, 255);
    page.grey[12 * 40 + 17] = 0;
    duct_lineart_options options = duct_lineart_options_default();
    duct_drawing *drawing = trace(&page, &options);
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing_free(drawing);
    options.shortest = 0;
    drawing = trace(&page, &options);
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    const duct_stroke *dot = duct_drawing_stroke(drawing, 0);
    assert_int_equal(duct_stroke_size(dot), 1);
    assert_float_equal(duct_stroke_values(dot, DUCT_X)[0], 17.5, 1e-9);
    assert_float_equal(duct_stroke_values(dot, DUCT_Y)[0], 12.5, 1e-9);
    duct_drawing_free(drawing);
    free(page.grey);
}

/* Every place must be finite and inside, whatever the picture. */
static void check_sane(const duct_drawing *drawing, const picture *page)
{
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        assert_true(duct_stroke_size(stroke) > 0);
        assert_true(duct_stroke_get_style(stroke).width > 0);
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            assert_true(x[k] >= 0 && x[k] <= page->width && y[k] >= 0 && y[k] <= page->height);
        }
    }
}

static void noise_and_patterns_end_in_sane_strokes(void **state)
{
    (void)state;
    uint32_t random = 12345;
    for (int kind = 0; kind < 6; kind++) {
        picture page = new_picture(193, 131, 255);
        for (int i = 0; i < 193 * 131; i++) {
            random = random * 1664525 + 1013904223;
            int x = i % 193, y = i / 193;
            const int values[] = {(int)(random >> 24), random >> 31 ? 255 : 0,    (x + y) % 2 * 255,
                                  x % 2 * 255,         (x / 3 + y / 3) % 2 * 255, (x % 7 && y % 7) ? 255 : 0};
            page.grey[i] = (uint8_t)values[kind];
        }
        duct_lineart_options options = duct_lineart_options_default();
        options.shortest = 0;
        duct_drawing *drawing = trace(&page, &options);
        duct_drawing *again = trace(&page, &options);
        check_sane(drawing, &page);
        /* The same picture gives the same strokes. */
        assert_int_equal(duct_drawing_stroke_count(drawing), duct_drawing_stroke_count(again));
        for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
            const duct_stroke *a = duct_drawing_stroke(drawing, i), *b = duct_drawing_stroke(again, i);
            assert_int_equal(duct_stroke_size(a), duct_stroke_size(b));
            assert_memory_equal(duct_stroke_values(a, DUCT_X), duct_stroke_values(b, DUCT_X),
                                duct_stroke_size(a) * sizeof(double));
        }
        duct_drawing_free(drawing);
        duct_drawing_free(again);
        free(page.grey);
    }
}

static void lines_touch_the_edges(void **state)
{
    (void)state;
    picture page = new_picture(130, 100, 255);
    draw_line(&page, -10, 50, 140, 50, 5, 0);
    draw_line(&page, 0, 0, 130, 0, 4, 0);
    draw_line(&page, 129, 0, 129, 100, 2, 0);
    duct_drawing *drawing = trace(&page, NULL);
    assert_true(duct_drawing_stroke_count(drawing) >= 2);
    check_sane(drawing, &page);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void sizes_and_options_out_of_range_are_refused(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    picture page = new_picture(10, 10, 255);
    static const int sizes[][2] = {{0, 10}, {10, 0}, {-1, 10}, {70000, 10}, {10, 70000}, {65536, 65536}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        assert_int_equal(
            duct_lineart_trace(NULL, sizes[i][0], sizes[i][1], picture_rows, &page, NULL, drawing, &error),
            DUCT_LIMIT);
    }
    const duct_lineart_options bad[] = {{DUCT_INK_AUTO, 1, 100, 4},   {DUCT_INK_AUTO, -0.1, 100, 4},
                                        {DUCT_INK_AUTO, 0, 0, 4},     {DUCT_INK_AUTO, 0, 100, -1},
                                        {DUCT_INK_AUTO, NAN, 100, 4}, {DUCT_INK_AUTO, 0, INFINITY, 4}};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        assert_int_equal(duct_lineart_trace(NULL, 10, 10, picture_rows, &page, &bad[i], drawing, &error),
                         DUCT_BAD_ARGUMENT);
    }
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing_free(drawing);
    free(page.grey);
}

static bool unreadable(void *user, int y, int count, uint8_t *grey)
{
    const picture *page = user;
    memset(grey, 255, (size_t)count * (size_t)page->width);
    return y < 64;
}

static bool stop_at(void *user, double fraction)
{
    double *limit = user;
    return fraction < *limit;
}

static void unreadable_and_cancelled_pictures_end_cleanly(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = NULL;
    failing_allocator counting;
    failing_init(&counting, 0);
    duct_context context = duct_context_default();
    context.allocator = &counting.allocator;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    picture page = new_picture(200, 200, 255);
    draw_line(&page, 20, 20, 180, 150, 5, 0);
    draw_ring(&page, 100, 100, 60, 5, 0);
    assert_int_equal(duct_lineart_trace(&context, 200, 200, unreadable, &page, NULL, drawing, &error),
                     DUCT_IO);
    assert_int_equal(counting.held, 0);
    for (double limit = 0; limit < 0.9; limit += 0.05) {
        context.progress = stop_at;
        context.progress_user = &limit;
        assert_int_equal(duct_lineart_trace(&context, 200, 200, picture_rows, &page, NULL, drawing, &error),
                         DUCT_CANCELLED);
        assert_int_equal(counting.held, 0);
    }
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing_free(drawing);
    free(page.grey);
}

static void failed_allocations_leave_nothing_behind(void **state)
{
    (void)state;
    picture page = new_picture(120, 90, 255);
    draw_line(&page, 10, 10, 110, 80, 5, 0);
    draw_line(&page, 10, 80, 110, 10, 5, 0);
    draw_ring(&page, 60, 45, 30, 3, 0);
    draw_line(&page, 60, 5, 60, 5, 6, 0);
    bool done = false;
    for (long n = 1; !done; n++) {
        duct_error error;
        duct_drawing *drawing = NULL;
        assert_ok(duct_drawing_new(NULL, &drawing, &error));
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_status status =
            duct_lineart_trace(&context, page.width, page.height, picture_rows, &page, NULL, drawing, &error);
        done = failing.calls < n;
        assert_int_equal(status, done ? DUCT_OK : DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        duct_drawing_free(drawing);
    }
    free(page.grey);
}

/* A huge picture that is never in memory as a whole. */
static bool huge_rows(void *user, int y, int count, uint8_t *grey)
{
    const int width = *(const int *)user;
    memset(grey, 255, (size_t)count * (size_t)width);
    for (int row = 0; row < count; row++) {
        /* A line of five pixels every two hundred rows, and one downwards. */
        if ((y + row) % 200 < 5 && y + row > 100) {
            memset(grey + (size_t)row * (size_t)width + 50, 0, (size_t)width - 100);
        }
    }
    return true;
}

typedef struct meter {
    duct_allocator allocator;
    size_t held, most;
} meter;

static void *metered_allocate(void *user, size_t size)
{
    meter *self = user;
    size_t *memory = malloc(size + 16);
    *memory = size;
    self->held += size;
    self->most = self->held > self->most ? self->held : self->most;
    return (char *)memory + 16;
}

static void metered_release(void *user, void *memory)
{
    meter *self = user;
    if (memory != NULL) {
        size_t *start = (size_t *)(void *)((char *)memory - 16);
        self->held -= *start;
        free(start);
    }
}

static void *metered_reallocate(void *user, void *memory, size_t size)
{
    void *made = metered_allocate(user, size);
    if (memory != NULL) {
        size_t old = *(size_t *)(void *)((char *)memory - 16);
        memcpy(made, memory, old < size ? old : size);
        metered_release(user, memory);
    }
    return made;
}

static void huge_pictures_take_a_few_bits_a_pixel(void **state)
{
    (void)state;
    int width = 12000, height = 8000;
    meter used = {{metered_allocate, metered_reallocate, metered_release, &used}, 0, 0};
    duct_context context = duct_context_default();
    context.allocator = &used.allocator;
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    assert_ok(duct_lineart_trace(&context, width, height, huge_rows, &width, NULL, drawing, &error));
    assert_int_equal(duct_drawing_stroke_count(drawing), 39);
    print_message("most memory: %.1f MiB for %d x %d pixels\n", (double)used.most / 1048576, width, height);
    assert_true(used.most < (size_t)width * (size_t)height); /* less than a byte a pixel */
    assert_int_equal(used.held, 0);
    duct_drawing_free(drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(even_pictures_have_no_lines),
        cmocka_unit_test(one_pixel_is_a_dot_where_specks_are_kept),
        cmocka_unit_test(noise_and_patterns_end_in_sane_strokes),
        cmocka_unit_test(lines_touch_the_edges),
        cmocka_unit_test(sizes_and_options_out_of_range_are_refused),
        cmocka_unit_test(unreadable_and_cancelled_pictures_end_cleanly),
        cmocka_unit_test(failed_allocations_leave_nothing_behind),
        cmocka_unit_test(huge_pictures_take_a_few_bits_a_pixel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
