/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OUTLINE_H
#define DUCTUS_OUTLINE_H

#include "geometry/path.h"

#include <ductus/stroke.h>

/* The mark of a nib that follows a stroke's pose, as one clean filled path: the envelope of an ellipse whose
 * size follows pressure, whose aspect follows tilt, and whose angle follows twist (tilt direction where there
 * is none). */
typedef struct duct_outline_options {
    double width;         /* full line width at pressure 0.5, in drawing pixels; 0: the stroke's own, or 1 */
    double thinnest;      /* width at pressure 0, as a share of `width` */
    double thickest;      /* width at pressure 1, as a share of `width` */
    double aspect;        /* nib's long over short axis when the pen is upright; 1 is round */
    double fit_tolerance; /* largest distance of the outline from the true envelope, drawing pixels */
} duct_outline_options;

duct_outline_options duct_outline_options_default(void);

/* Appends the outline of `stroke` to `path`: outer contours and holes as closed subpaths, holes against the
 * sense of the outer ones, to be filled with either fill rule. They do not cross, but where edges come closer
 * to each other than the tolerance, and then by no more. Without pressure the width is constant; without
 * twist and tilt the nib is round. A stroke of one sample gives a dot; an empty one gives nothing. Errors:
 * DUCT_NO_MEMORY, DUCT_UNSUPPORTED (the geometry library failed; the sentence says so). */
duct_status duct_outline(const duct_stroke *stroke, const duct_outline_options *options, duct_path *path,
                         duct_error *error);

#endif
