/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "pictures.h"

#include "brushes.h"

#include <ductus/format.h>

#include <cairo.h>
#include <math.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 32, MARGIN = 3 };

static const double pi = 3.14159265358979323846;

static GdkPixbuf *new_white(int width, int height)
{
    GdkPixbuf *picture = gdk_pixbuf_new(GDK_COLORSPACE_RGB, FALSE, 8, width, height);
    gdk_pixbuf_fill(picture, 0xffffffff);
    return picture;
}

GdkPixbuf *plug_picture_blank(void)
{
    return new_white(WIDTH, HEIGHT);
}

/* The box around strokes that follow one another on a line: as many as make it three times as wide as high.
 */
static size_t first_line(const duct_drawing *drawing, double box[4])
{
    size_t count = duct_drawing_stroke_count(drawing), taken = 0;
    box[0] = box[1] = INFINITY;
    box[2] = box[3] = -INFINITY;
    for (size_t i = 0; i < count; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            box[0] = fmin(box[0], x[k]);
            box[1] = fmin(box[1], y[k]);
            box[2] = fmax(box[2], x[k]);
            box[3] = fmax(box[3], y[k]);
        }
        taken = i + 1;
        if (box[2] - box[0] > 3 * (box[3] - box[1]) && i >= 2) {
            break;
        }
    }
    return taken;
}

static void draw_stroke(cairo_t *cairo, const duct_stroke *stroke, const double box[4], double scale)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    const double *pressure = duct_stroke_values(stroke, DUCT_PRESSURE);
    for (size_t i = 1; i < duct_stroke_size(stroke); i++) {
        cairo_move_to(cairo, (x[i - 1] - box[0]) * scale, (y[i - 1] - box[1]) * scale);
        cairo_line_to(cairo, (x[i] - box[0]) * scale, (y[i] - box[1]) * scale);
        cairo_set_line_width(cairo, 0.4 + 2.6 * (pressure != NULL ? pressure[i] : 0.5));
        cairo_stroke(cairo);
    }
}

/* A picture of an image surface, which is freed. */
static GdkPixbuf *taken_from(cairo_surface_t *surface)
{
    cairo_surface_flush(surface);
    const unsigned char *from = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    GdkPixbuf *picture = new_white(WIDTH, HEIGHT);
    unsigned char *to = gdk_pixbuf_get_pixels(picture);
    for (int y = 0; y < HEIGHT; y++) {
        const uint32_t *row = (const uint32_t *)(const void *)(from + (size_t)y * (size_t)stride);
        unsigned char *pixel = to + (size_t)y * (size_t)gdk_pixbuf_get_rowstride(picture);
        for (int x = 0; x < WIDTH; x++, pixel += 3) {
            pixel[0] = (unsigned char)(row[x] >> 16);
            pixel[1] = (unsigned char)(row[x] >> 8);
            pixel[2] = (unsigned char)row[x];
        }
    }
    cairo_surface_destroy(surface);
    return picture;
}

GdkPixbuf *plug_picture_of_hand(const char *file, const char *name)
{
    duct_drawing *drawing = NULL;
    duct_error error;
    (void)name;
    if (file == NULL || g_file_test(file, G_FILE_TEST_IS_DIR) ||
        duct_drawing_read(NULL, file, NULL, &drawing, &error) != DUCT_OK) {
        return NULL;
    }
    double box[4];
    size_t count = first_line(drawing, box);
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, WIDTH, HEIGHT);
    cairo_t *cairo = cairo_create(surface);
    cairo_set_source_rgb(cairo, 1, 1, 1);
    cairo_paint(cairo);
    cairo_set_source_rgb(cairo, 0, 0, 0);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_translate(cairo, MARGIN, MARGIN);
    double scale = fmin((WIDTH - 2 * MARGIN) / fmax(box[2] - box[0], 1e-9),
                        (HEIGHT - 2 * MARGIN) / fmax(box[3] - box[1], 1e-9));
    for (size_t i = 0; i < count && isfinite(scale); i++) {
        draw_stroke(cairo, duct_drawing_stroke(drawing, i), box, scale);
    }
    cairo_destroy(cairo);
    duct_drawing_free(drawing);
    return taken_from(surface);
}

/* A wave that is pressed harder and harder. */
static duct_status make_mark(duct_drawing **drawing, duct_error *error)
{
    enum { samples = 40 };
    duct_stroke *stroke = NULL;
    duct_status status = duct_drawing_new(NULL, drawing, error);
    if (status == DUCT_OK) {
        status = duct_drawing_add_stroke(*drawing, "mark", samples, &stroke, error);
    }
    double *x = status == DUCT_OK ? duct_stroke_edit(stroke, DUCT_X) : NULL;
    double *y = status == DUCT_OK ? duct_stroke_edit(stroke, DUCT_Y) : NULL;
    double *pressure = status == DUCT_OK ? duct_stroke_edit(stroke, DUCT_PRESSURE) : NULL;
    for (int i = 0; i < samples && x != NULL && y != NULL && pressure != NULL; i++) {
        double t = (double)i / (samples - 1);
        x[i] = 10 + t * (WIDTH - 20);
        y[i] = HEIGHT / 2.0 - 7 * sin(2 * pi * t);
        pressure[i] = 0.15 + 0.75 * t;
    }
    return status;
}

static void lay_over_white(const duct_canvas *canvas, GdkPixbuf *picture)
{
    unsigned char *to = gdk_pixbuf_get_pixels(picture);
    for (int y = 0; y < HEIGHT; y++) {
        for (int x = 0; x < WIDTH; x++) {
            const uint16_t *tile = duct_canvas_tile(canvas, x / DUCT_TILE_SIZE, y / DUCT_TILE_SIZE);
            if (tile == NULL) {
                continue;
            }
            const uint16_t *pixel =
                tile + 4 * ((size_t)(y % DUCT_TILE_SIZE) * DUCT_TILE_SIZE + (size_t)(x % DUCT_TILE_SIZE));
            unsigned char *here = to + (size_t)y * (size_t)gdk_pixbuf_get_rowstride(picture) + 3 * (size_t)x;
            for (size_t k = 0; k < 3; k++) {
                unsigned value = pixel[k] + (32768U - pixel[3]);
                here[k] = (unsigned char)(MIN(value, 32768U) * 255U / 32768U);
            }
        }
    }
}

static GdkPixbuf *picture_of_mark(const char *name)
{
    duct_brush *brush = NULL;
    duct_drawing *drawing = NULL;
    duct_canvas *canvas = NULL;
    GdkPixbuf *picture = NULL;
    duct_error error;
    duct_paint_options options = duct_paint_options_default();
    options.brush_size = 12;
    if (plug_brush_load(name, &brush, &error) == DUCT_OK && make_mark(&drawing, &error) == DUCT_OK &&
        duct_canvas_new(NULL, WIDTH, HEIGHT, &canvas, &error) == DUCT_OK &&
        duct_canvas_paint(canvas, brush, duct_drawing_stroke(drawing, 0), &options, &error) == DUCT_OK) {
        picture = new_white(WIDTH, HEIGHT);
        lay_over_white(canvas, picture);
    }
    duct_canvas_free(canvas);
    duct_drawing_free(drawing);
    duct_brush_free(brush);
    return picture;
}

GdkPixbuf *plug_picture_of_brush(const char *file, const char *name)
{
    GdkPixbuf *whole = NULL;
    if (file != NULL && !g_str_has_suffix(file, ".myb")) {
        whole = gdk_pixbuf_new_from_file_at_scale(file, HEIGHT, HEIGHT, TRUE, NULL);
    }
    if (whole == NULL) {
        return picture_of_mark(name);
    }
    GdkPixbuf *picture = new_white(WIDTH, HEIGHT);
    gdk_pixbuf_composite(whole, picture, 0, 0, gdk_pixbuf_get_width(whole), gdk_pixbuf_get_height(whole), 0,
                         0, 1, 1, GDK_INTERP_NEAREST, 255);
    g_object_unref(whole);
    return picture;
}
