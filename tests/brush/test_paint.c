/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

#include "brush/dab.h"

#include <dirent.h>
#include <malloc.h>
#include <pthread.h>
#include <time.h>

static duct_error error;

static const char *const own_brushes[] = {"bristle", "flat-bristle", "flat-nib", "ink"};
enum { OWN_BRUSHES = 4 };

static double seconds_since(clock_t begin)
{
    return (double)(clock() - begin) / CLOCKS_PER_SEC;
}

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
        if (strcmp(own_brushes[b], "ink") != 0) { /* a round pen does not mind its barrel */
            assert_true(changed(brush, &turned) > (strcmp(own_brushes[b], "bristle") == 0 ? 0.04 : 0.2));
        }
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
        assert_true(difference(one, two, true) < 0.03);
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
        double alpha = pixel_value(canvas, 120, 128, 3) / 32768.0;
        assert_true(alpha > 0.4 && alpha < 0.51);
        assert_near(pixel_value(canvas, 120, 128, 0) / 32768.0 / alpha, 1, 0.25);
        assert_near(pixel_value(canvas, 120, 128, 1) / 32768.0 / alpha, 0.5, 0.25);
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
                assert_true(pixel_value(canvas, 100, 90, 3) > 10000);
            }
            duct_canvas_free(canvas);
            duct_drawing_free(drawing);
        }
        duct_brush_free(brush);
    }
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
        cmocka_unit_test(same_stroke_same_pixels_on_a_dirty_heap),
        cmocka_unit_test(order_of_separate_strokes_does_not_matter),
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
        cmocka_unit_test(hostile_strokes_end_quickly_and_safely),
        cmocka_unit_test(million_samples_are_painted),
        cmocka_unit_test(only_painted_tiles_exist),
        cmocka_unit_test(thin_dabs_keep_their_area),
        cmocka_unit_test(stock_brushes_paint_alike_twice),
        cmocka_unit_test(canvases_may_be_painted_in_threads),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
