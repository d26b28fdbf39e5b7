/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_UNITS_H
#define DUCTUS_FORMATS_SVG_UNITS_H

#include "formats/svg_scan.h"

/* What relative lengths refer to. */
typedef struct duct_svg_viewport {
    double width, height; /* of the nearest viewport, in user units */
    double font_size;     /* in user units */
} duct_svg_viewport;

typedef enum duct_svg_axis {
    DUCT_SVG_HORIZONTAL,
    DUCT_SVG_VERTICAL,
    DUCT_SVG_DIAGONAL, /* percentages refer to sqrt((width^2 + height^2) / 2) */
    DUCT_SVG_FONT      /* percentages refer to the font size */
} duct_svg_axis;

/* A length in user units (px), from a number with an optional unit: px mm cm in pt pc Q em ex rem ch vw vh %.
 * False where the value is none, not finite, or of an unknown unit. */
bool duct_svg_length(duct_slice value, duct_svg_axis axis, const duct_svg_viewport *viewport, double *length);

/* An opacity: a number or a percentage, brought into 0..1. */
bool duct_svg_opacity(duct_slice value, double *opacity);

#endif
