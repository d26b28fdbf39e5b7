/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_TRANSFORM_H
#define DUCTUS_FORMATS_SVG_TRANSFORM_H

#include "formats/svg_scan.h"
#include "geometry/affine.h"

/* The map of a `transform` attribute: a list of matrix, translate, scale, rotate, skewX and skewY, CSS's
 * spelling (px, deg, translateX, scaleY ...) included. False where the list is malformed: SVG 1.1,
 * section 7.6, and browsers then take it as absent. */
bool duct_svg_transform(duct_slice value, duct_affine *map);

/* The four numbers of a `viewBox`; false where it is malformed or its size is not positive. */
bool duct_svg_viewbox(const char *value, double box[4]);

/* The map from a view box to a viewport of that size with its corner at (0, 0), after a `preserveAspectRatio`
 * value, which may be NULL (SVG 1.1, section 7.8). */
duct_affine duct_svg_viewbox_map(const double box[4], const char *preserve, double width, double height);

#endif
