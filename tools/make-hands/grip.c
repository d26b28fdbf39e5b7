/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grip.h"

#include "wander.h"

#include <ductus/random.h>

#include <math.h>

static double clamped(double value, double low, double high)
{
    return fmax(low, fmin(high, value));
}

/* Angle of the forearm when the hand rests at (x, y), against its angle at the page's middle. */
static double forearm_turn(const grip_style *style, double page, double x, double y)
{
    const double wrist_x = x + style->wrist_x - style->elbow_x;
    const double wrist_y = y + style->wrist_y - style->elbow_y;
    const double rest_x = page / 2 + style->wrist_x - style->elbow_x;
    const double rest_y = page / 2 + style->wrist_y - style->elbow_y;
    return remainder(atan2(wrist_y, wrist_x) - atan2(rest_y, rest_x), 2 * M_PI);
}

static void rotate(double angle, double *x, double *y)
{
    const double c = cos(angle), s = sin(angle);
    const double turned = c * *x - s * *y;
    *y = s * *x + c * *y;
    *x = turned;
}

/* The pose of tip (x, y) over the hand resting at `hand`. */
static void pose_at(const grip_style *style, const hand_place *hand, double page, double x, double y,
                    double angles[3] /* tilt x, tilt y, twist */)
{
    const double reach = hypot(style->wrist_x, style->wrist_y);
    const double forearm = forearm_turn(style, page, hand->x, hand->y);
    /* The finger axis points from the wrist to the tip. */
    double along_x = -style->wrist_x / reach, along_y = -style->wrist_y / reach;
    rotate(forearm, &along_x, &along_y);
    const double dx = x - hand->x, dy = y - hand->y;
    const double stretch = dx * along_x + dy * along_y;
    const double across = dy * along_x - dx * along_y;
    const double turn = atan2(across, reach + stretch);

    /* The arm folds as the hand comes nearer to the body, and the pen stands up. */
    double pivot_x = style->pivot_x + style->pivot_shift_x * (hand->x - page / 2);
    double pivot_y = style->pivot_y + style->pivot_shift_y * (hand->y - page / 2);
    rotate(forearm + turn * style->pivot_turns, &pivot_x, &pivot_y);
    const double lean_x = pivot_x + (style->pivot_stretches * stretch - stretch) * along_x -
                          (style->pivot_turns * across - across) * along_y;
    const double lean_y = pivot_y + (style->pivot_stretches * stretch - stretch) * along_y +
                          (style->pivot_turns * across - across) * along_x;
    angles[0] = atan2(lean_x, style->pivot_height);
    angles[1] = atan2(lean_y, style->pivot_height);
    angles[2] = style->twist + forearm + style->turn_twist * turn + style->stretch_twist * stretch / reach;
}

/* The pressure that speed, direction and curvature at sample `k` ask for. */
static double wanted_pressure(const grip_style *style, const trajectory *way, size_t k)
{
    const size_t a = k >= 2 ? k - 2 : 0;
    const size_t b = k + 2 < way->size ? k + 2 : way->size - 1;
    const size_t middle = (a + b) / 2;
    const double dx = way->x[b] - way->x[a], dy = way->y[b] - way->y[a];
    const double length = hypot(dx, dy);
    if (b == a || length <= 0) {
        return style->pressure;
    }
    const double speed = length / (way->t[b] - way->t[a]);
    const double slow = clamped(-log((speed + 0.05 * style->usual_speed) / style->usual_speed), -1.2, 1.2);
    const double ux = way->x[middle] - way->x[a], uy = way->y[middle] - way->y[a];
    const double wx = way->x[b] - way->x[middle], wy = way->y[b] - way->y[middle];
    const double turn = fabs(atan2(ux * wy - uy * wx, ux * wx + uy * wy));
    const double steady = fmin(1, speed / (0.4 * style->usual_speed));
    return style->pressure + style->speed_pressure * slow + style->down_pressure * steady * dy / length +
           style->bend_pressure * fmin(1, turn);
}

/* 0 when the pen touches down, towards 1 as the fingers close on it. */
static double settled(const grip_style *style, double t)
{
    return 1 - exp(-t / style->settle_time);
}

static void press(const grip_style *style, const trajectory *way, uint64_t seed, uint64_t stroke,
                  pose *result)
{
    const double level = style->pressure_level * duct_random_normal(seed, stroke, 0, CHANCE_PRESSURE_LEVEL);
    const double follow = 1 - exp(-1 / (style->lag * MOTION_RATE));
    const double duration = way->t[way->size - 1];
    /* A tick is over before the pen has come down fully. */
    const double touch_time = fmin(style->touch_time, 0.3 * duration + 1e-3);
    const double leave_time = fmin(style->leave_time, 0.3 * duration + 1e-3);
    double smooth = wanted_pressure(style, way, way->size < 4 ? 0 : 3);
    for (size_t k = 0; k < way->size; k++) {
        const double t = way->t[k];
        smooth += follow * (wanted_pressure(style, way, k) - smooth);
        const double drift =
            style->pressure_drift * wander(seed, stroke, CHANCE_PRESSURE, t * style->drift_rate);
        const double touch = 1 - (1 - style->touch_pressure) * exp(-t / touch_time);
        const double left = (duration - t) / leave_time;
        const double leave = 1 - (1 - style->leave_pressure) * exp(-left);
        const double settle = 1 - style->settle_pressure * (1 - settled(style, t));
        result->pressure[k] = clamped((smooth + level + drift) * touch * leave * settle, 0.01, 0.99);
    }
}

static void follow_hand(double share, double x, double y, hand_place *hand)
{
    hand->x += share * (x - hand->x);
    hand->y += share * (y - hand->y);
}

/* While the pen is up the hand moves to the next stroke, and never quite to the same place under it. */
static void move_hand(const grip_style *style, const trajectory *way, double pause, uint64_t seed,
                      uint64_t stroke, hand_place *hand)
{
    double x = 0, y = 0;
    const size_t ahead = way->size < MOTION_RATE / 4 ? way->size : MOTION_RATE / 4;
    for (size_t k = 0; k < ahead; k++) {
        x += way->x[k] / (double)ahead;
        y += way->y[k] / (double)ahead;
    }
    x += 4 * duct_random_normal(seed, stroke, 0, CHANCE_WRIST_X);
    y += 4 * duct_random_normal(seed, stroke, 0, CHANCE_WRIST_Y);
    /* Quicker than while writing: the wrist is lifted for longer ways. */
    const double way_off = hypot(x - hand->x, y - hand->y) / 150;
    follow_hand(hand->placed ? 1 - exp(-pause / (0.4 * style->wrist_time) - way_off) : 1, x, y, hand);
    hand->placed = true;
}

/* The same way can be made with more of the wrist or more of the fingers. */
static void vary_habits(const grip_style *style, uint64_t seed, uint64_t stroke, double u, grip_style *now)
{
    double chance[4];
    for (uint64_t i = 0; i < 4; i++) {
        chance[i] = style->habit * wander(seed, stroke, CHANCE_HABIT + i, u);
    }
    now->pivot_turns = style->pivot_turns + 0.5 * chance[0];
    now->pivot_stretches = style->pivot_stretches + 0.5 * chance[1];
    now->turn_twist = style->turn_twist * (1 + chance[2]);
    now->stretch_twist = style->stretch_twist * (1 + chance[3]);
}

void grip_hold(const grip_style *style, const trajectory *way, double page, double pause,
               size_t stroke_number, uint64_t seed, uint64_t stroke, hand_place *hand, pose *result)
{
    if (way->size == 0) {
        return;
    }
    move_hand(style, way, pause, seed, stroke, hand);
    press(style, way, seed, stroke, result);
    grip_style now = *style;
    const double page_time = (double)stroke_number / 40;
    const double regrip_x = style->regrip_tilt * wander(seed, 0, CHANCE_GRIP_TILT, page_time);
    const double regrip_y = style->regrip_tilt * wander(seed, 1, CHANCE_GRIP_TILT, page_time);
    const double regrip_twist = style->regrip_twist * wander(seed, 0, CHANCE_GRIP_TWIST, page_time);
    for (size_t k = 0; k < way->size; k++) {
        const double u = way->t[k] * style->drift_rate;
        double angles[3];
        follow_hand(1 - exp(-1 / (style->wrist_time * MOTION_RATE)), way->x[k], way->y[k], hand);
        const double settle = settled(style, way->t[k]);
        vary_habits(style, seed, stroke, u / 3, &now);
        pose_at(&now, hand, page, way->x[k], way->y[k], angles);
        result->tilt_x[k] = angles[0] + style->settle_tilt * settle + regrip_x +
                            style->tilt_drift * wander(seed, stroke, CHANCE_TILT_X, u);
        result->tilt_y[k] = angles[1] + style->settle_tilt * settle + regrip_y +
                            style->tilt_drift * wander(seed, stroke, CHANCE_TILT_Y, u);
        result->twist[k] = angles[2] + style->settle_twist * settle + regrip_twist +
                           style->twist_drift * wander(seed, stroke, CHANCE_TWIST, u);
    }
}
