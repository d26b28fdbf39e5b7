/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/brush_private.h"

#include "base/error.h"
#include "base/pool.h"

#include <math.h>

duct_render_options duct_render_options_default(void)
{
    return (duct_render_options){.paint = duct_paint_options_default(), .background = {1, 1, 1, 1}};
}

/* Drawing pixels that the widest stroke may reach over its samples. */
static double margin(const duct_drawing *drawing, const duct_brush *brush, const duct_paint_options *options)
{
    duct_paint_options unscaled = *options;
    unscaled.scale = 1;
    double most = 0;
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        most = fmax(most, duct_brush_radius(brush, duct_drawing_stroke(drawing, i), &unscaled));
    }
    return 2 * most + 8;
}

/* The part of the drawing to paint, in drawing pixels. */
static void picture_box(const duct_drawing *drawing, const duct_brush *brush,
                        const duct_paint_options *options, double box[4])
{
    double width = duct_drawing_width(drawing), height = duct_drawing_height(drawing);
    if (width > 0 && height > 0) {
        box[0] = box[1] = 0;
        box[2] = width;
        box[3] = height;
        return;
    }
    duct_drawing_bounds(drawing, box);
    double around = margin(drawing, brush, options);
    box[0] -= around;
    box[1] -= around;
    box[2] += around;
    box[3] += around;
}

/* Whole pixels that hold `length`; a hundredth of a pixel more is rounding and needs no further one. */
static double whole_pixels(double length)
{
    return fmax(1, ceil(length - 0.01));
}

static duct_status paint_all(const duct_context *context, duct_canvas *canvas, const duct_drawing *drawing,
                             const duct_brush *brush, const duct_paint_options *options, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing);
    for (size_t i = 0; i < count; i++) {
        duct_status status = duct_progress_report(context, (double)i / (double)count, error);
        if (status == DUCT_OK) {
            status = duct_canvas_paint(canvas, brush, duct_drawing_stroke(drawing, i), options, error);
        }
        if (status != DUCT_OK) {
            return status;
        }
    }
    return duct_progress_report(context, 1, error);
}

duct_status duct_render(const duct_context *context, const duct_drawing *drawing, const duct_brush *brush,
                        const duct_render_options *options, duct_canvas **canvas, duct_error *error)
{
    duct_render_options used = options != NULL ? *options : duct_render_options_default();
    double own = duct_drawing_resolution(drawing);
    own = own > 0 && isfinite(own) ? own : 96;
    double scale = used.resolution > 0 ? used.resolution / own : 1;
    double box[4];
    picture_box(drawing, brush, &used.paint, box);
    double width = whole_pixels((box[2] - box[0]) * scale), height = whole_pixels((box[3] - box[1]) * scale);
    if (!(width <= DUCT_MAX_CANVAS) || !(height <= DUCT_MAX_CANVAS)) {
        return duct_fail(
            error, DUCT_LIMIT,
            "the image would have %.0f x %.0f pixels and may have %d a side; ask for a lower resolution",
            width, height, DUCT_MAX_CANVAS);
    }
    used.paint.scale = scale;
    used.paint.offset_x = -box[0] * scale;
    used.paint.offset_y = -box[1] * scale;
    duct_canvas *made = NULL;
    duct_status status = duct_canvas_new(context, (int)width, (int)height, &made, error);
    if (status == DUCT_OK) {
        status = paint_all(context, made, drawing, brush, &used.paint, error);
    }
    if (status != DUCT_OK) {
        duct_canvas_free(made);
        return status;
    }
    *canvas = made;
    return DUCT_OK;
}
