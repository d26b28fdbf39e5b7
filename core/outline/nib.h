/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OUTLINE_NIB_H
#define DUCTUS_OUTLINE_NIB_H

#include "geometry/path.h"

/* An ellipse at a place: the area that the nib covers at one moment. */
typedef struct duct_nib {
    double x, y;
    double major, minor; /* half axes in drawing pixels, major >= minor > 0 */
    double angle; /* of the major axis, radians; neighbours along a stroke differ by a quarter turn at most */
    double c, s;  /* cosine and sine of `angle` */
} duct_nib;

typedef struct duct_normal {
    double x, y; /* unit vector */
} duct_normal;

/* Fills nibs[0 .. duct_stroke_size() - 1] from the stroke's pose. */
void duct_nibs_of(const duct_stroke *stroke, const duct_nib_options *options, duct_nib *nibs);

/* The nib between two at t = 0..1, at a place of its own. */
duct_nib duct_nib_between(const duct_nib *a, const duct_nib *b, double t, double x, double y);

/* How far the ellipse reaches from its centre in a direction. */
double duct_nib_support(const duct_nib *nib, duct_normal normal);

/* The point of the ellipse that lies furthest in a direction: xy[0], xy[1]. */
void duct_nib_touch(const duct_nib *nib, duct_normal normal, double xy[2]);

/* The place of that point on the ellipse: the t of centre + major cos t, minor sin t along the axes. */
double duct_nib_parameter(const duct_nib *nib, duct_normal normal);
void duct_nib_point(const duct_nib *nib, double t, double xy[2]);

#endif
