/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_WANDER_H
#define MAKE_HANDS_WANDER_H

#include <stdint.h>

/* What randomness is used for: the `purpose` of duct_random_*. */
enum {
    CHANCE_POINT_X = 1,
    CHANCE_POINT_Y,
    CHANCE_BEND,
    CHANCE_DURATION,
    CHANCE_OVERLAP,
    CHANCE_TREMOR_X,
    CHANCE_TREMOR_Y,
    CHANCE_PRESSURE,
    CHANCE_PRESSURE_LEVEL,
    CHANCE_TILT_X,
    CHANCE_TILT_Y,
    CHANCE_TWIST,
    CHANCE_BASELINE,
    CHANCE_SIZE,
    CHANCE_SLANT,
    CHANCE_SPACE,
    CHANCE_JOIN,
    CHANCE_PAUSE,
    CHANCE_WRIST_X,
    CHANCE_WRIST_Y,
    CHANCE_GRIP_TWIST,
    CHANCE_GRIP_TILT,
    CHANCE_HABIT
};

/* Smooth noise of mean 0 and standard deviation about 1: a cubic B-spline over normal numbers at the whole
 * values of `u` (u >= 0), so that it turns about once a unit. */
double wander(uint64_t seed, uint64_t stroke, uint64_t purpose, double u);

#endif
