/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_WALK_H
#define DUCTUS_BRUSH_WALK_H

#include <ductus/render.h>

/* The pen at one place of a stroke. */
typedef struct duct_pose {
    double x, y;     /* canvas pixels */
    double pressure; /* 0..1 */
    double lean_x,
        lean_y;   /* where the pen leans to, right and down; length 0 (upright) .. 1 (60 degrees or more) */
    double twist; /* radians, clockwise */
    double time;  /* seconds since the pose before */
    double distance; /* canvas pixels along the stroke from its beginning */
    bool jump;       /* the way from the pose before is outside the box: nothing is painted on it */
} duct_pose;

/* Goes along a stroke in equal steps of arc length, the pose interpolated linearly between samples, and only
 * within a box: what lies outside costs nothing, however far it goes. The places of the poses do not depend
 * on the box. Samples that are not finite are passed over. */
typedef struct duct_walk {
    const duct_stroke *stroke;
    const double *values[DUCT_CHANNEL_COUNT];
    double scale, offset_x, offset_y;
    double box[4]; /* x0 y0 x1 y1, canvas pixels */
    double step;   /* canvas pixels */
    size_t size;   /* samples, counting a closed stroke's first again */
    size_t next;   /* the next sample to go to */
    duct_pose from, to;
    double length;   /* of the segment from `from` to `to` */
    double at, end;  /* the next place on it and where the walk has to leave it, canvas pixels from `from` */
    double carry;    /* how far the last place lies behind `from` */
    double distance; /* of `from` */
    double clock, told;   /* seconds at `from`; seconds when the last pose was given */
    double default_speed; /* canvas pixels a second where there is no time */
    bool timed;           /* the stroke's own times are used */
    bool started, jump, in_segment, ended;
} duct_walk;

/* `step` > 0 and the box are in canvas pixels. */
void duct_walk_begin(duct_walk *walk, const duct_stroke *stroke, const duct_paint_options *options,
                     const double box[4], double step);

/* The next pose; false at the stroke's end. The stroke's first and last places are given where they lie in
 * the box. */
bool duct_walk_next(duct_walk *walk, duct_pose *pose);

#endif
