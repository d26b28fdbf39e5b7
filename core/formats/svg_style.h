/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_STYLE_H
#define DUCTUS_FORMATS_SVG_STYLE_H

#include "formats/svg_color.h"
#include "formats/svg_css.h"
#include "formats/svg_units.h"

#include <ductus/stroke.h>

typedef struct duct_svg_document duct_svg_document;

typedef enum duct_svg_paint_kind {
    DUCT_SVG_PAINT_NONE,
    DUCT_SVG_PAINT_COLOR,
    DUCT_SVG_PAINT_SERVER
} duct_svg_paint_kind;

typedef struct duct_svg_paint {
    duct_svg_paint_kind kind;
    duct_svg_color color; /* of a gradient: its first stop's */
    duct_slice server;    /* the value with url(...), as it was written */
} duct_svg_paint;

/* The computed style of an element. */
typedef struct duct_svg_style {
    duct_svg_paint fill, stroke;
    duct_svg_color color; /* currentColor */
    double fill_opacity, stroke_opacity;
    double opacity;      /* of the element and all groups around it, multiplied */
    double stroke_width; /* in user units */
    double font_size;
    bool displayed, visible;
    bool non_scaling; /* the width is in pixels of the page */
} duct_svg_style;

/* SVG's initial values. */
duct_svg_style duct_svg_style_initial(void);

/* The style of an element with these declared values inside of one with the style `parent`. */
duct_svg_style duct_svg_style_compute(const duct_svg_document *document, const duct_svg_style *parent,
                                      const duct_css_values *values, const duct_svg_viewport *viewport);

/* True where a stroke (a fill) of the element leaves a mark. */
bool duct_svg_style_strokes(const duct_svg_style *style);
bool duct_svg_style_fills(const duct_svg_style *style);

/* The style of the element's strokes in drawing pixels; `scale` is the matrix's average factor. */
duct_stroke_style duct_svg_stroke_style(const duct_svg_style *style, double scale);
/* The same for an element whose outline is taken because nothing in the drawing is stroked: width 0. */
duct_stroke_style duct_svg_fill_style(const duct_svg_style *style);

#endif
