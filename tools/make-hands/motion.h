/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_MOTION_H
#define MAKE_HANDS_MOTION_H

#include "plan.h"

#include <stdint.h>

/* The sigma-lognormal model of rapid human movements: R. Plamondon, "A kinematic theory of rapid human
 * movements", Biological Cybernetics 72, 1995; R. Plamondon and M. Djioua, "A multi-level representation
 * paradigm for handwriting stroke generation", Human Movement Science 25, 2006.
 *
 * A stroke is a sum of movements that overlap in time. Each runs along a circular arc from one virtual target
 * to the next, and its speed over time is a lognormal curve D / ((t - t0) sigma sqrt(2 pi))
 * exp(-(ln(t - t0) - mu)^2 / (2 sigma^2)). */

enum { MOTION_RATE = 140 /* samples a second */, MOTION_SAMPLES = 4096 };

/* How a person moves. */
typedef struct motor_style {
    double duration;  /* s, of a movement as long as `reach` */
    double reach;     /* pixels */
    double isochrony; /* a movement k times as long lasts k^isochrony times as long */
    double sigma;     /* the lognormal's spread: small is symmetric, large starts abruptly */
    double
        smooth_delay; /* the next movement starts after this share of the duration, where the line goes on */
    double corner_delay; /* the same at corners */
    double roundness;    /* factor on the arcs' bends: 1 as planned, 0 straight lines */
    double accuracy;     /* 0: overlapping movements cut curves short; 1: the hand allows for it */
    double bend_jitter;  /* standard deviation, radians */
    double time_jitter;  /* standard deviation, share of a movement's duration */
    double tremor;       /* pixels */
    double tremor_rate;  /* turns a second */
} motor_style;

/* The pen's way at MOTION_RATE, page pixels, time from 0. */
typedef struct trajectory {
    double x[MOTION_SAMPLES], y[MOTION_SAMPLES], t[MOTION_SAMPLES];
    size_t size;
} trajectory;

/* Carries a plan out. `jitter`: standard deviation of the targets' places in pixels. What comes out is a
 * function of the arguments only. A plan of fewer than two targets gives an empty trajectory; one that lasts
 * longer than the trajectory holds is cut. */
void motion_perform(const motor_style *style, const action_plan *plan, double jitter, uint64_t seed,
                    uint64_t stroke, trajectory *result);

#endif
