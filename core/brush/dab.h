/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_DAB_H
#define DUCTUS_BRUSH_DAB_H

#include "brush/canvas.h"

/* One touch of a brush: an ellipse whose opacity falls from its middle to its rim as libmypaint's dabs do. */
typedef struct duct_dab {
    double x, y;            /* middle, canvas pixels */
    double radius;          /* half the long axis, canvas pixels */
    double ratio;           /* long axis to short axis, at least 1 */
    double angle;           /* of the long axis, radians, clockwise on the screen */
    double hardness;        /* 0..1: the square of the relative distance at which the quick fall begins */
    double opacity;         /* 0..1 */
    float red, green, blue; /* 0..1, sRGB-encoded */
    double target_alpha;    /* the alpha that the dab pulls towards: 1 paints, 0 erases */
    bool wash; /* the pixel becomes what it was or what the dab makes of it, whichever is more opaque: the
                  dabs of a stroke on a layer of its own do not build up, and its edges stay as smooth as one
                  dab's */
} duct_dab;

/* Paints a dab, clipped to the canvas. The opacity is filtered over one pixel across the rim, so that thin
 * and small dabs have smooth edges too. */
void duct_dab_paint(duct_canvas *canvas, const duct_dab *dab);

/* The average colour (not premultiplied) and alpha of the canvas under a soft round dab, by a fixed grid of
 * samples: libmypaint's own picks its samples with the process's rand(). */
void duct_dab_average(const duct_canvas *canvas, double x, double y, double radius, float colour[4]);

#endif
