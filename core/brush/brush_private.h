/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_PRIVATE_H
#define DUCTUS_BRUSH_PRIVATE_H

#include "base/memory.h"
#include "brush/canvas.h"
#include "brush/grain.h"

#include <mypaint-brush.h>

enum {
    DUCT_CURVE_POINTS = 64, /* libmypaint's limit */
    DUCT_MAX_BRISTLES = 400
};

/* How one input of libmypaint adds to one of its settings: piecewise linear. */
typedef struct duct_curve {
    MyPaintBrushSetting setting;
    MyPaintBrushInput input;
    int count; /* 2..DUCT_CURVE_POINTS */
    float x[DUCT_CURVE_POINTS], y[DUCT_CURVE_POINTS];
} duct_curve;

/* The "ductus" section of a brush file: a tuft of bristles; docs/brushes.md says what each number does. */
typedef struct duct_tuft {
    int bristles; /* 0: no tuft, libmypaint paints */
    double ratio; /* the tuft's width to its thickness; 1: round */
    double angle; /* of its width at twist 0, degrees clockwise from the x axis */
    double spread, tilt, stiffness, thickness, dryness, ink, colour;
} duct_tuft;

struct duct_brush {
    const duct_allocator *allocator;
    char *name;
    float base[MYPAINT_BRUSH_SETTINGS_COUNT];
    duct_curve *curves;
    size_t curve_count, curve_capacity;
    duct_tuft tuft;
    bool wash;        /* from the "ductus" section, as all below: dabs of one stroke do not build up */
    bool tip;         /* a drawing tip, which takes ratio, angle and tilt from `tuft` */
    double side;      /* how much longer a tip's mark gets as it leans, in widths */
    duct_grain grain; /* depth 0 and cover 1: none */
};

/* Fills a brush from the content of a .myb file. Sentences say what is wrong, not in which file. */
duct_status duct_brush_parse(duct_brush *brush, const char *data, duct_error *error);

/* Half the width of the mark, in canvas pixels, at which the brush's settings are at their base values. */
double duct_brush_radius(const duct_brush *brush, const duct_stroke *stroke,
                         const duct_paint_options *options);

/* Paints with libmypaint, opaque, on `target`. */
duct_status duct_engine_paint(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                              const duct_paint_options *options, duct_error *error);

/* Paints with a drawing tip, opaque, on `target`. */
duct_status duct_tip_paint(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                           const duct_paint_options *options, duct_error *error);

/* Paints with a tuft, opaque, on `target`. */
duct_status duct_bristle_paint(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                               const duct_paint_options *options, duct_error *error);

#endif
