/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_CORRESPONDENCE_H
#define DUCTUS_ANALOGY_CORRESPONDENCE_H

#include "analogy/curve.h"

/* How A and A' get one parameter ("Curve analogies" section 3.3). */
typedef enum duct_correspondence {
    DUCT_CORRESPOND_AUTO,   /* by samples where both have as many and 8 or more, else by length */
    DUCT_CORRESPOND_LENGTH, /* the same share of the arc length */
    DUCT_CORRESPOND_WARP,   /* dynamic time warping of their places */
    DUCT_CORRESPOND_SAMPLES /* control points of the same number belong together */
} duct_correspondence;

/* Gives A its arc length as parameter, and A' the parameter of what it belongs to on A. Errors:
 * DUCT_NO_MEMORY. */
duct_status duct_correspond(const duct_allocator *allocator, duct_correspondence how, duct_curve *a,
                            duct_curve *b, duct_error *error);

#endif
