/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_GRIP_H
#define MAKE_HANDS_GRIP_H

#include "motion.h"

/* How a hand holds a pen: a plane model of elbow, wrist and fingers that gives the pen's pose along a
 * trajectory.
 *
 * The wrist rests on the page and follows the pen lazily. What the tip moves against the resting hand is made
 * by the wrist's rotation (across the fingers) and by bending and stretching the fingers (along them). The
 * barrel lies on a pivot between thumb and forefinger, which moves with the hand; the tip's place under the
 * pivot gives the tilt. Rotating the hand and rolling the pen between the fingers turn the barrel. The
 * forearm turns about the elbow as the hand goes over the page, and with it everything else: the slow spatial
 * component of "HelpingHand" section 3.2. */
typedef struct grip_style {
    /* Places in page pixels. */
    double elbow_x, elbow_y; /* on the page plane */
    double wrist_x, wrist_y; /* from the tip of the resting hand to the wrist */
    double pivot_x, pivot_y; /* from that tip to the point below the pivot */
    double pivot_height;     /* above the page */
    double pivot_shift_x,
        pivot_shift_y;      /* how far the pivot moves, for a pixel of the hand's way across and down */
    double wrist_time;      /* s: how lazily the wrist follows */
    double pivot_turns;     /* share of the tip's movement across the fingers that the pivot follows */
    double pivot_stretches; /* the same along the fingers */
    double twist;           /* radians, of the resting hand at the page's middle */
    double turn_twist;      /* radians of twist a radian of wrist rotation */
    double stretch_twist;   /* radians of twist for a stretch of the fingers by the hand's length */
    /* Pressure. */
    double pressure;               /* of the running stroke */
    double speed_pressure;         /* added where the pen is slow: times -ln(speed / usual speed) */
    double usual_speed;            /* pixels a second */
    double down_pressure;          /* added on downward movements, taken off upward ones */
    double bend_pressure;          /* added in tight curves */
    double touch_pressure;         /* share of the pressure at the first sample */
    double leave_pressure;         /* share at the last sample */
    double touch_time, leave_time; /* s */
    /* A stroke settles: what it gains over its first moments. */
    double settle_time;               /* s */
    double settle_pressure;           /* share of the pressure */
    double settle_tilt, settle_twist; /* radians */
    double lag;                       /* s: how fast the pressure follows its causes */
    /* Variation: standard deviations. */
    double habit; /* no two strokes share the work equally between wrist, fingers and rolling: share of the
                     shares and gains above */
    double pressure_drift, pressure_level; /* along a stroke; from stroke to stroke */
    double tilt_drift, twist_drift;        /* radians */
    double drift_rate;                     /* turns a second */
    double regrip_tilt, regrip_twist;      /* radians, slowly over the page */
} grip_style;

/* The pen's pose along a trajectory, in the units of duct_channel. */
typedef struct pose {
    double pressure[MOTION_SAMPLES];
    double tilt_x[MOTION_SAMPLES], tilt_y[MOTION_SAMPLES], twist[MOTION_SAMPLES];
} pose;

/* Where the hand is between strokes. */
typedef struct hand_place {
    double x, y; /* page pixels: where the tip of the resting hand would be */
    bool placed; /* false before the first stroke */
} hand_place;

/* The pose of a stroke that begins `pause` seconds after the last one; moves the hand. `page` is the page's
 * side in pixels, `stroke_number` counts the strokes of the page. */
void grip_hold(const grip_style *style, const trajectory *way, double page, double pause,
               size_t stroke_number, uint64_t seed, uint64_t stroke, hand_place *hand, pose *result);

#endif
