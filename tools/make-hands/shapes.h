/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_SHAPES_H
#define MAKE_HANDS_SHAPES_H

#include "plan.h"

/* Drawing strokes: what a hand needs to have done before it can restyle line art. */

typedef enum shape_kind {
    SHAPE_LINE,   /* from (x, y), `a` pixels in direction `angle`, in the middle b to its right */
    SHAPE_ARC,    /* part of an ellipse around (x, y) with half axes a, b: from `from` on, `amount` degrees */
    SHAPE_SPIRAL, /* around (x, y), radius from a to b, `amount` turns, signed, from `from` on */
    SHAPE_WAVE,   /* from (x, y), `amount` half waves of length a and height b in direction `angle` */
    SHAPE_ZIGZAG, /* the same with corners; `from` > 0: the corners' share of a, for hatching */
    SHAPE_LOOPS,  /* from (x, y), `amount` loops a apart, b high, in direction `angle` */
    SHAPE_CORNERS /* a polygon's sides around (x, y), radius a, `amount` corners, b sides, from `from` on */
} shape_kind;

/* Angles in degrees, clockwise on the page from the right. */
typedef struct shape {
    shape_kind kind;
    double x, y;
    double a, b;
    double angle, from, amount;
} shape;

/* What is drawn on a page of 2000 x 2000 pixels, in this order. It leaves the band above y = 600, and left of
 * x = 1000 above y = 780, to the text.
 */
extern const shape shapes_page[];
extern const size_t shapes_count;

/* Appends the shape's targets. False where the plan is full. */
bool shape_write(const shape *form, action_plan *plan);

/* A typical extent in pixels, for the size of its variation. */
double shape_size(const shape *form);

#endif
