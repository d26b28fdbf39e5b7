/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_GRAIN_H
#define DUCTUS_BRUSH_GRAIN_H

#include "brush/canvas.h"

/* The tooth of the paper. Its heights are a function of the place on the page alone, so strokes that lie over
 * one another meet the same peaks and valleys, at any resolution. */
typedef struct duct_grain {
    double depth; /* 0: smooth paper; 3: peaks are covered long before valleys */
    double size;  /* of the tooth, drawing pixels */
    double cover; /* 0..1: alpha of paper that is covered fully */
} duct_grain;

/* The height at a place of the page: mean 0, variance 1 less `missing`, which is what of it is finer than a
 * pixel. `pixel` is a pixel's size; both in units of the tooth's size. */
double duct_grain_height(double x, double y, double pixel, double *missing);

/* Turns the layer's alpha, which says how hard each pixel was pressed (0..1), into what the paper takes: the
 * peaks first, the valleys last, in the mean over many pixels as much as was pressed. Since more pressing
 * never gives less, a stroke whose dabs do not build up is textured once, whatever its dabs. */
void duct_grain_apply(duct_canvas *layer, const duct_grain *grain, const duct_paint_options *options);

#endif
