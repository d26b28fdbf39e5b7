/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

#include <dirent.h>
#include <malloc.h>
#include <pthread.h>

static duct_error error;

/* Leaves freed memory full of `byte`, so that whoever reads memory that it did not set reads something else
 * each time. */
static void dirty_heap(int byte)
{
    mallopt(M_PERTURB, byte);
    enum { blocks = 200 };
    void *block[blocks];
    for (int i = 0; i < blocks; i++) {
        size_t size = (size_t)64 << (i % 9);
        block[i] = malloc(size);
        assert_non_null(block[i]);
        memset(block[i], byte, size);
    }
    for (int i = 0; i < blocks; i++) {
        free(block[i]);
    }
}

static void same_stroke_same_pixels_on_a_dirty_heap(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *first = NULL;
        for (int i = 0; i < 5; i++) {
            static const int bytes[] = {0, 0x55, 0x7f, 0xc0, 0xff};
            dirty_heap(bytes[i]);
            srand((unsigned)i);
            duct_canvas *canvas = paint_mark(brush, &neutral_mark, NULL);
            if (first == NULL) {
                first = canvas;
                assert_true(painted_area(first) > 500);
            } else {
                assert_true(same_pixels(first, canvas));
                duct_canvas_free(canvas);
            }
        }
        duct_canvas_free(first);
        duct_brush_free(brush);
    }
    dirty_heap(0);
}

/* Paints two marks that do not touch, in either order, on one canvas. */
static duct_canvas *paint_pair(const duct_brush *brush, bool reversed)
{
    duct_canvas *canvas = new_canvas(600, MARK_SIDE);
    duct_drawing *drawing = new_drawing();
    mark other = neutral_mark;
    other.id = "other";
    other.pressure = 0.8;
    const duct_stroke *strokes[2] = {add_mark(drawing, &neutral_mark), add_mark(drawing, &other)};
    for (int i = 0; i < 2; i++) {
        int which = reversed ? 1 - i : i;
        duct_paint_options options = duct_paint_options_default();
        options.offset_x = which * 300;
        assert_ok(duct_canvas_paint(canvas, brush, strokes[which], &options, &error));
    }
    duct_drawing_free(drawing);
    return canvas;
}

static void order_of_separate_strokes_does_not_matter(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        duct_canvas *one = paint_pair(brush, false), *two = paint_pair(brush, true);
        assert_true(same_pixels(one, two));
        duct_canvas_free(one);
        duct_canvas_free(two);
        duct_brush_free(brush);
    }
}

/* A thick mark, something to smudge and to erase; and over it, crossing it, a stock brush's, if there is one.
 */
static duct_canvas *stock_mark(const duct_brush *ink, const duct_brush *brush, int byte)
{
    dirty_heap(byte);
    srand((unsigned)byte);
    duct_drawing *drawing = new_drawing();
    duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
    mark leant = neutral_mark;
    leant.pressure_along = 0.4;
    leant.tilt_x = 0.3;
    duct_stroke *below = add_mark(drawing, &leant);
    duct_stroke_set_style(below, (duct_stroke_style){0.9f, 0.4f, 0.1f, 1, 30});
    assert_ok(duct_canvas_paint(canvas, ink, below, NULL, &error));
    if (brush != NULL) {
        duct_paint_options options = duct_paint_options_default();
        options.brush_size = 10;
        options.offset_y = 10;
        assert_ok(duct_canvas_paint(canvas, brush, add_mark(drawing, &leant), &options, &error));
    }
    duct_drawing_free(drawing);
    return canvas;
}

typedef struct tally {
    const duct_brush *ink;
    const duct_canvas *below;
    int painted, idle, differing;
} tally;

/* Paints twice with every .myb below the folder. */
static void try_stock_brushes(const char *folder, int depth, tally *count)
{
    DIR *open_folder = opendir(folder);
    struct dirent *entry;
    while (open_folder != NULL && (entry = readdir(open_folder)) != NULL) {
        char path[1024];
        if (snprintf(path, sizeof path, "%s/%s", folder, entry->d_name) >= (int)sizeof path) {
            continue;
        }
        size_t length = strlen(entry->d_name);
        if (entry->d_name[0] != '.' && depth > 0 && entry->d_type == DT_DIR) {
            try_stock_brushes(path, depth - 1, count);
        } else if (length > 4 && strcmp(entry->d_name + length - 4, ".myb") == 0) {
            duct_brush *brush = load_brush(path);
            duct_canvas *one = stock_mark(count->ink, brush, 0x37),
                        *two = stock_mark(count->ink, brush, 0xee);
            if (!same_pixels(one, two)) {
                print_message("differs: %s\n", path);
                count->differing++;
            }
            count->painted++;
            count->idle += same_pixels(one, count->below);
            duct_canvas_free(one);
            duct_canvas_free(two);
            duct_brush_free(brush);
        }
    }
    if (open_folder != NULL) {
        closedir(open_folder);
    }
}

static void stock_brushes_paint_alike_twice(void **state)
{
    (void)state;
    duct_brush *ink = load_brush("ink");
    duct_canvas *below = stock_mark(ink, NULL, 0);
    tally count = {ink, below, 0, 0, 0};
    try_stock_brushes("/usr/share/mypaint-data", 4, &count);
    duct_canvas_free(below);
    duct_brush_free(ink);
    dirty_heap(0);
    if (count.painted == 0) {
        print_message("skipped: no stock brushes here (package mypaint-brushes)\n");
        skip();
    }
    assert_int_equal(count.differing, 0);
    assert_true(count.idle < count.painted / 20);
}

typedef struct job {
    const duct_brush *brush;
    duct_canvas *canvas;
} job;

static void *paint_in_thread(void *arg)
{
    job *self = arg;
    duct_drawing *drawing = NULL;
    if (duct_drawing_new(NULL, &drawing, NULL) == DUCT_OK) {
        const duct_stroke *stroke = add_mark(drawing, &neutral_mark);
        for (int i = 0; i < 5; i++) {
            duct_canvas_paint(self->canvas, self->brush, stroke, NULL, NULL);
        }
    }
    duct_drawing_free(drawing);
    return NULL;
}

static void canvases_may_be_painted_in_threads(void **state)
{
    (void)state;
    for (int b = 0; b < OWN_BRUSHES; b++) {
        duct_brush *brush = load_brush(own_brushes[b]);
        enum { threads = 4 };
        job jobs[threads];
        pthread_t thread[threads];
        for (int i = 0; i < threads; i++) {
            jobs[i] = (job){brush, new_canvas(MARK_SIDE, MARK_SIDE)};
            assert_int_equal(pthread_create(&thread[i], NULL, paint_in_thread, &jobs[i]), 0);
        }
        for (int i = 0; i < threads; i++) {
            pthread_join(thread[i], NULL);
        }
        for (int i = 0; i < threads; i++) {
            assert_true(same_pixels(jobs[0].canvas, jobs[i].canvas));
        }
        for (int i = 0; i < threads; i++) {
            duct_canvas_free(jobs[i].canvas);
        }
        duct_brush_free(brush);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(same_stroke_same_pixels_on_a_dirty_heap),
        cmocka_unit_test(order_of_separate_strokes_does_not_matter),
        cmocka_unit_test(stock_brushes_paint_alike_twice),
        cmocka_unit_test(canvases_may_be_painted_in_threads),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
