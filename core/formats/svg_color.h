/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_COLOR_H
#define DUCTUS_FORMATS_SVG_COLOR_H

#include "formats/svg_scan.h"

/* An sRGB-encoded colour with its alpha, each 0..1. */
typedef struct duct_svg_color {
    double red, green, blue, alpha;
} duct_svg_color;

/* A CSS colour: the 148 names, transparent, currentColor (`current`), #rgb, #rgba, #rrggbb, #rrggbbaa, rgb(),
 * rgba(), hsl(), hsla() with commas or spaces. False where the value is none of these. */
bool duct_svg_color_parse(duct_slice value, duct_svg_color current, duct_svg_color *color);

#endif
