/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "plan.h"

#include <math.h>

static const double largest_bend = 3.6;

bool plan_add(action_plan *plan, double x, double y, bool corner, bool straight)
{
    if (plan->count == PLAN_TARGETS) {
        return false;
    }
    plan->targets[plan->count++] = (plan_target){x, y, corner, straight};
    return true;
}

static double wrapped(double angle)
{
    return remainder(angle, 2 * M_PI);
}

static double chord_angle(const action_plan *plan, size_t movement)
{
    const plan_target *a = &plan->targets[movement];
    return atan2(a[1].y - a[0].y, a[1].x - a[0].x);
}

static double chord_length(const action_plan *plan, size_t movement)
{
    const plan_target *a = &plan->targets[movement];
    return hypot(a[1].x - a[0].x, a[1].y - a[0].y);
}

double plan_turn(const action_plan *plan, size_t index)
{
    if (index == 0 || index + 1 >= plan->count) {
        return 0;
    }
    return wrapped(chord_angle(plan, index) - chord_angle(plan, index - 1));
}

/* The direction in which the line passes a smooth inner target. False at ends and corners. */
static bool tangent_at(const action_plan *plan, size_t index, double *angle)
{
    if (index == 0 || index + 1 >= plan->count || plan->targets[index].corner) {
        return false;
    }
    const double before = chord_angle(plan, index - 1);
    const double turn = plan_turn(plan, index);
    const bool straight_before = plan->targets[index].straight;
    const bool straight_behind = plan->targets[index + 1].straight;
    if (straight_before != straight_behind) {
        *angle = straight_before ? before : before + turn;
        return true;
    }
    /* The circle through the three targets: each side turns in proportion to its chord. */
    const double a = chord_length(plan, index - 1);
    const double b = chord_length(plan, index);
    *angle = before + (a + b > 0 ? turn * a / (a + b) : 0);
    return true;
}

void plan_bends(const action_plan *plan, double *bends)
{
    for (size_t i = 0; i + 1 < plan->count; i++) {
        double start = 0, end = 0;
        const double chord = chord_angle(plan, i);
        const bool at_start = tangent_at(plan, i, &start);
        const bool at_end = tangent_at(plan, i + 1, &end);
        start = wrapped(start - chord);
        end = wrapped(end - chord);
        double bend = 0;
        if (plan->targets[i + 1].straight) {
            bend = 0;
        } else if (at_start && at_end) {
            bend = end - start;
        } else if (at_start) {
            bend = -2 * start;
        } else if (at_end) {
            bend = 2 * end;
        }
        bends[i] = fmax(-largest_bend, fmin(largest_bend, bend));
    }
}
