/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The picture module: draws the shapes with cairo. */
#include "picture/module.h"

#include <ductus/export.h>

#include <cairo.h>
#include <math.h>

static void trace_points(cairo_t *cairo, const duct_picture *picture, const duct_shape *shape)
{
    const duct_picture_point *points = picture->points + shape->start;
    cairo_move_to(cairo, points[0].x, points[0].y);
    for (size_t i = 1; i < shape->count; i++) {
        cairo_line_to(cairo, points[i].x, points[i].y);
    }
}

static void draw_text(cairo_t *cairo, const duct_picture *picture, const duct_shape *shape)
{
    const char *text = picture->texts + shape->text;
    cairo_text_extents_t extents;
    cairo_set_font_size(cairo, shape->size);
    cairo_text_extents(cairo, text, &extents);
    double share = shape->anchor == DUCT_TEXT_START ? 0 : shape->anchor == DUCT_TEXT_MIDDLE ? 0.5 : 1;
    cairo_save(cairo);
    cairo_translate(cairo, picture->points[shape->start].x, picture->points[shape->start].y);
    cairo_rotate(cairo, shape->angle);
    cairo_move_to(cairo, -share * extents.x_advance, 0);
    cairo_show_text(cairo, text);
    cairo_restore(cairo);
}

static void draw(cairo_t *cairo, const duct_picture *picture, const duct_shape *shape)
{
    const duct_picture_point *first = picture->points + shape->start;
    const duct_ink *ink = &shape->ink;
    cairo_set_source_rgba(cairo, (double)ink->red, (double)ink->green, (double)ink->blue,
                          (double)ink->opacity);
    cairo_new_path(cairo);
    switch (shape->kind) {
    case DUCT_SHAPE_LINE:
        trace_points(cairo, picture, shape);
        if (shape->count == 1) {
            cairo_line_to(cairo, first->x, first->y);
        }
        cairo_set_line_width(cairo, shape->size);
        cairo_stroke(cairo);
        break;
    case DUCT_SHAPE_POLYGON:
        trace_points(cairo, picture, shape);
        cairo_fill(cairo);
        break;
    case DUCT_SHAPE_CIRCLE:
        cairo_arc(cairo, first->x, first->y, shape->size, 0, 2 * acos(-1));
        cairo_fill(cairo);
        break;
    case DUCT_SHAPE_TEXT:
        draw_text(cairo, picture, shape);
        break;
    }
}

static const char *write_png(const duct_picture *picture, double scale, const char *path)
{
    cairo_surface_t *surface = cairo_image_surface_create(
        CAIRO_FORMAT_ARGB32, (int)ceil(picture->width * scale), (int)ceil(picture->height * scale));
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, scale, scale);
    cairo_set_line_cap(cairo, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
    cairo_select_font_face(cairo, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    for (size_t i = 0; i < picture->shape_count; i++) {
        draw(cairo, picture, &picture->shapes[i]);
    }
    cairo_status_t status = cairo_status(cairo);
    cairo_destroy(cairo);
    if (status == CAIRO_STATUS_SUCCESS) {
        status = cairo_surface_write_to_png(surface, path);
    }
    cairo_surface_destroy(surface);
    return status == CAIRO_STATUS_SUCCESS ? NULL : cairo_status_to_string(status);
}

static const duct_picture_module functions = {DUCT_PICTURE_MODULE_VERSION, write_png};

DUCT_API const duct_picture_module *duct_picture_module_get(void);

const duct_picture_module *duct_picture_module_get(void)
{
    return &functions;
}
