/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/brush_private.h"

#include "base/error.h"

#include <math.h>

duct_paint_options duct_paint_options_default(void)
{
    return (duct_paint_options){.scale = 1};
}

double duct_brush_radius(const duct_brush *brush, const duct_stroke *stroke,
                         const duct_paint_options *options)
{
    double width = options->brush_size > 0 ? options->brush_size : duct_stroke_get_style(stroke).width;
    double radius = width > 0 && isfinite(width)
                        ? width / 2
                        : exp((double)brush->base[MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC]);
    return fmin(fmax(radius * options->scale, 0.1), 1000); /* libmypaint paints no larger dabs */
}

/* True where what the brush paints depends on what is below, so that it has to be painted there. */
static bool depends_on_canvas(const duct_brush *brush)
{
    static const MyPaintBrushSetting settings[] = {
        MYPAINT_BRUSH_SETTING_SMUDGE, MYPAINT_BRUSH_SETTING_ERASER, MYPAINT_BRUSH_SETTING_LOCK_ALPHA,
        MYPAINT_BRUSH_SETTING_COLORIZE, MYPAINT_BRUSH_SETTING_POSTERIZE};
    for (size_t i = 0; i < sizeof settings / sizeof settings[0]; i++) {
        if (brush->base[settings[i]] > 0) {
            return true;
        }
        for (size_t c = 0; c < brush->curve_count; c++) {
            if (brush->curves[c].setting == settings[i]) {
                return true;
            }
        }
    }
    return false;
}

static duct_status paint_on(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                            const duct_paint_options *options, duct_error *error)
{
    duct_status (*paint)(duct_canvas *, const duct_brush *, const duct_stroke *, const duct_paint_options *,
                         duct_error *) = brush->tip                 ? duct_tip_paint
                                         : brush->tuft.bristles > 0 ? duct_bristle_paint
                                                                    : duct_engine_paint;
    duct_status status = paint(target, brush, stroke, options, error);
    if (status == DUCT_OK && target->failed) {
        status = duct_fail_memory(error);
    }
    return status;
}

duct_status duct_canvas_paint(duct_canvas *canvas, const duct_brush *brush, const duct_stroke *stroke,
                              const duct_paint_options *options, duct_error *error)
{
    duct_paint_options used = options != NULL ? *options : duct_paint_options_default();
    if (!(used.scale > 0) || !isfinite(used.scale) || !isfinite(used.offset_x) || !isfinite(used.offset_y)) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "the scale and place to paint at are not usable numbers");
    }
    double opacity = (double)duct_stroke_get_style(stroke).opacity;
    if (duct_stroke_size(stroke) == 0 || !(opacity > 0)) {
        return DUCT_OK;
    }
    canvas->failed = false;
    /* A translucent stroke does not show where it crosses itself, and paper takes a stroke as a whole: it is
     * painted apart and laid over. */
    const bool grainy = brush->grain.depth > 0 || (brush->grain.size > 0 && brush->grain.cover < 1);
    if (depends_on_canvas(brush) || (opacity >= 1 && !brush->wash && !grainy)) {
        return paint_on(canvas, brush, stroke, &used, error);
    }
    duct_canvas *layer = duct_canvas_layer(canvas);
    if (layer == NULL) {
        return duct_fail_memory(error);
    }
    layer->failed = false;
    duct_status status = paint_on(layer, brush, stroke, &used, error);
    if (grainy) {
        duct_grain_apply(layer, &brush->grain, &used);
    }
    duct_canvas_merge(canvas, layer, fmin(opacity, 1));
    return status == DUCT_OK && canvas->failed ? duct_fail_memory(error) : status;
}
