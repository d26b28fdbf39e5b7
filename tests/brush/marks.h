/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_MARKS_H
#define DUCTUS_TESTS_MARKS_H

/* Strokes to paint and canvases to compare. */

#include "testing.h"

#include <ductus/drawing.h>
#include <ductus/render.h>

#include <math.h>

/* cmocka's own compares floats only. */
#define assert_near(value, expected, tolerance)                                             \
    do {                                                                                    \
        double near_value = (value), near_expected = (expected);                            \
        if (!(fabs(near_value - near_expected) <= (tolerance))) {                           \
            fail_msg("%s is %g and should be about %g", #value, near_value, near_expected); \
        }                                                                                   \
    } while (0)

enum { MARK_SIDE = 256, MARK_SAMPLES = 60 };

/* The brushes that Ductus ships. */
static const char *const own_brushes[] = {"bristle", "charcoal", "flat-bristle", "flat-nib", "ink", "pencil"};
enum { OWN_BRUSHES = sizeof own_brushes / sizeof own_brushes[0] };

/* True for brushes whose marks hold the paper's grain, which does not turn or move with the stroke. */
static inline bool is_grainy(const char *name)
{
    return strcmp(name, "charcoal") == 0 || strcmp(name, "pencil") == 0;
}

/* A pose that may change along the mark: start + along * u, u in 0..1. */
typedef struct mark {
    double pressure, tilt_x, tilt_y, twist;
    double pressure_along;
    double turn; /* of the whole mark about the canvas's middle, in quarter turns */
    const char *id;
} mark;

static const mark neutral_mark = {0.5, 0, 0, 0, 0, 0, "mark"};

/* Appends an S-curve through the middle of a MARK_SIDE square. */
static inline duct_stroke *add_mark(duct_drawing *drawing, const mark *m)
{
    duct_stroke *stroke = NULL;
    assert_int_equal(duct_drawing_add_stroke(drawing, m->id, MARK_SAMPLES, &stroke, NULL), DUCT_OK);
    const double half_pi = 1.5707963267948966, cosine = cos(m->turn * half_pi), sine = sin(m->turn * half_pi);
    for (int i = 0; i < MARK_SAMPLES; i++) {
        double u = (double)i / (MARK_SAMPLES - 1);
        double x = (u - 0.5) * 150, y = 30 * sin(6 * u);
        duct_stroke_edit(stroke, DUCT_X)[i] = MARK_SIDE / 2.0 + x * cosine - y * sine;
        duct_stroke_edit(stroke, DUCT_Y)[i] = MARK_SIDE / 2.0 + x * sine + y * cosine;
        duct_stroke_edit(stroke, DUCT_T)[i] = u;
        duct_stroke_edit(stroke, DUCT_PRESSURE)[i] = m->pressure + m->pressure_along * u;
        duct_stroke_edit(stroke, DUCT_TILT_X)[i] = m->tilt_x * cosine - m->tilt_y * sine;
        duct_stroke_edit(stroke, DUCT_TILT_Y)[i] = m->tilt_x * sine + m->tilt_y * cosine;
        duct_stroke_edit(stroke, DUCT_TWIST)[i] = m->twist + m->turn * half_pi;
    }
    duct_stroke_set_style(stroke, (duct_stroke_style){0.1f, 0.1f, 0.3f, 1, 14});
    return stroke;
}

static inline duct_drawing *new_drawing(void)
{
    duct_drawing *drawing = NULL;
    assert_int_equal(duct_drawing_new(NULL, &drawing, NULL), DUCT_OK);
    duct_drawing_set_page(drawing, MARK_SIDE, MARK_SIDE);
    return drawing;
}

static inline duct_canvas *new_canvas(int width, int height)
{
    duct_canvas *canvas = NULL;
    assert_int_equal(duct_canvas_new(NULL, width, height, &canvas, NULL), DUCT_OK);
    return canvas;
}

static inline duct_brush *load_brush(const char *name)
{
    duct_brush *brush = NULL;
    duct_error error = {DUCT_OK, ""};
    if (duct_brush_load(NULL, name, &brush, &error) != DUCT_OK) {
        fail_msg("%s", error.message);
    }
    return brush;
}

/* A canvas with one mark painted by a brush. */
static inline duct_canvas *paint_mark(const duct_brush *brush, const mark *m,
                                      const duct_paint_options *options)
{
    duct_drawing *drawing = new_drawing();
    duct_canvas *canvas = new_canvas(MARK_SIDE, MARK_SIDE);
    duct_error error;
    assert_ok(duct_canvas_paint(canvas, brush, add_mark(drawing, m), options, &error));
    duct_drawing_free(drawing);
    return canvas;
}

static inline unsigned pixel_value(const duct_canvas *canvas, int x, int y, int k)
{
    const uint16_t *tile = duct_canvas_tile(canvas, x / DUCT_TILE_SIZE, y / DUCT_TILE_SIZE);
    return tile != NULL ? tile[((y % DUCT_TILE_SIZE) * DUCT_TILE_SIZE + x % DUCT_TILE_SIZE) * 4 + k] : 0;
}

/* The largest value of channel k around a place: grain leaves single pixels empty. */
static inline unsigned value_around(const duct_canvas *canvas, int x, int y, int k)
{
    unsigned most = 0;
    for (int dy = -4; dy <= 4; dy++) {
        for (int dx = -4; dx <= 4; dx++) {
            unsigned value = pixel_value(canvas, x + dx, y + dy, k);
            most = value > most ? value : most;
        }
    }
    return most;
}

/* The alpha of a whole canvas, in pixels. */
static inline double painted_area(const duct_canvas *canvas)
{
    double sum = 0;
    for (int y = 0; y < duct_canvas_height(canvas); y++) {
        for (int x = 0; x < duct_canvas_width(canvas); x++) {
            sum += pixel_value(canvas, x, y, 3) / 32768.0;
        }
    }
    return sum;
}

/* The pixels' summed difference in alpha over the mean painted area: 0 for equal pictures, 2 for disjoint
 * ones. `turned`: b is looked at turned by a quarter. */
static inline double difference(const duct_canvas *a, const duct_canvas *b, bool turned)
{
    double sum = 0;
    int side = duct_canvas_width(a);
    for (int y = 0; y < duct_canvas_height(a); y++) {
        for (int x = 0; x < side; x++) {
            double other = turned ? pixel_value(b, side - 1 - y, x, 3) : pixel_value(b, x, y, 3);
            sum += fabs(pixel_value(a, x, y, 3) - other) / 32768.0;
        }
    }
    return sum / ((painted_area(a) + painted_area(b)) / 2);
}

static inline bool same_pixels(const duct_canvas *a, const duct_canvas *b)
{
    for (int y = 0; y < duct_canvas_height(a); y++) {
        for (int x = 0; x < duct_canvas_width(a); x++) {
            for (int k = 0; k < 4; k++) {
                if (pixel_value(a, x, y, k) != pixel_value(b, x, y, k)) {
                    return false;
                }
            }
        }
    }
    return true;
}

#endif
