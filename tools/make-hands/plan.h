/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_PLAN_H
#define MAKE_HANDS_PLAN_H

#include <stdbool.h>
#include <stddef.h>

/* An action plan: the virtual targets that the pen heads for one after the other, in page pixels, y down.
 *
 * Between two targets lies one movement, a circular arc. Its bend follows from the targets around it: the arc
 * leaves and reaches a smooth target along a common tangent. */
typedef struct plan_target {
    double x, y;
    bool corner;   /* the line turns sharply here; the pen nearly stops */
    bool straight; /* the movement that ends here is a straight line */
} plan_target;

enum { PLAN_TARGETS = 320 };

typedef struct action_plan {
    plan_target targets[PLAN_TARGETS];
    size_t count;
} action_plan;

/* Appends a target. False where the plan is full. */
bool plan_add(action_plan *plan, double x, double y, bool corner, bool straight);

/* The bend of each movement, in radians, positive from x to y: `bends` holds count - 1 numbers. */
void plan_bends(const action_plan *plan, double *bends);

/* The turn at target `index` from the chord before it to the chord behind it, radians, 0 at the ends. */
double plan_turn(const action_plan *plan, size_t index);

#endif
