/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "shapes.h"

#include <math.h>

static double radians(double degrees)
{
    return degrees * M_PI / 180;
}

/* Appends the point (along, across) of a frame at the shape's place, turned by its angle. */
static bool add_turned(const shape *form, double along, double across, bool corner, bool straight,
                       action_plan *plan)
{
    const double c = cos(radians(form->angle)), s = sin(radians(form->angle));
    return plan_add(plan, form->x + c * along - s * across, form->y + s * along + c * across, corner,
                    straight);
}

static bool write_line(const shape *form, action_plan *plan)
{
    return add_turned(form, 0, 0, false, false, plan) &&
           (fabs(form->b) < 0.5 || add_turned(form, form->a / 2, form->b, false, false, plan)) &&
           add_turned(form, form->a, 0, false, false, plan);
}

static bool write_arc(const shape *form, action_plan *plan)
{
    /* Four or five movements a turn for circles; ellipses need more to keep their form. */
    const int steps = (int)fmax(2, ceil(fabs(form->amount) / (form->a == form->b ? 80 : 50)));
    for (int i = 0; i <= steps; i++) {
        const double at = radians(form->from + form->amount * i / steps);
        if (!add_turned(form, form->a * cos(at), form->b * sin(at), false, false, plan)) {
            return false;
        }
    }
    return true;
}

static bool write_spiral(const shape *form, action_plan *plan)
{
    const int steps = (int)fmax(4, ceil(fabs(form->amount) * 5));
    for (int i = 0; i <= steps; i++) {
        const double share = (double)i / steps;
        const double radius = form->a + (form->b - form->a) * share;
        const double at = radians(form->from + 360 * form->amount * share);
        if (!add_turned(form, radius * cos(at), radius * sin(at), false, false, plan)) {
            return false;
        }
    }
    return true;
}

static bool write_wave(const shape *form, action_plan *plan)
{
    bool written = add_turned(form, 0, 0, false, false, plan);
    for (int i = 0; i < (int)form->amount; i++) {
        const double side = i % 2 == 0 ? -form->b : form->b;
        written = written && add_turned(form, (i + 0.5) * form->a, side, false, false, plan) &&
                  add_turned(form, (i + 1) * form->a, 0, false, false, plan);
    }
    return written;
}

static bool write_zigzag(const shape *form, action_plan *plan)
{
    bool written = true;
    for (int i = 0; i <= (int)form->amount; i++) {
        const double lean = i % 2 == 0 ? 0 : form->from * form->a;
        written =
            written && add_turned(form, i * form->a + lean, i % 2 == 0 ? 0 : -form->b, true, false, plan);
    }
    return written;
}

static bool write_loops(const shape *form, action_plan *plan)
{
    bool written = add_turned(form, 0, 0, false, false, plan);
    for (int i = 0; i < (int)form->amount; i++) {
        const double at = i * form->a;
        written = written && add_turned(form, at + 0.72 * form->a, -0.45 * form->b, false, false, plan) &&
                  add_turned(form, at + 0.5 * form->a, -form->b, false, false, plan) &&
                  add_turned(form, at + 0.28 * form->a, -0.5 * form->b, false, false, plan) &&
                  add_turned(form, at + 0.62 * form->a, 0, false, false, plan);
    }
    return written &&
           add_turned(form, form->amount * form->a + 0.4 * form->a, -0.3 * form->b, false, false, plan);
}

static bool write_corners(const shape *form, action_plan *plan)
{
    bool written = true;
    for (int i = 0; i <= (int)form->b; i++) {
        const double at = radians(form->from + 360.0 * i / form->amount);
        written = written && add_turned(form, form->a * cos(at), form->a * sin(at), true, true, plan);
    }
    return written;
}

bool shape_write(const shape *form, action_plan *plan)
{
    switch (form->kind) {
    case SHAPE_LINE:
        return write_line(form, plan);
    case SHAPE_ARC:
        return write_arc(form, plan);
    case SHAPE_SPIRAL:
        return write_spiral(form, plan);
    case SHAPE_WAVE:
        return write_wave(form, plan);
    case SHAPE_ZIGZAG:
        return write_zigzag(form, plan);
    case SHAPE_LOOPS:
        return write_loops(form, plan);
    case SHAPE_CORNERS:
        return write_corners(form, plan);
    }
    return false;
}

double shape_size(const shape *form)
{
    switch (form->kind) {
    case SHAPE_ARC:
    case SHAPE_SPIRAL:
        return fmin(form->a, form->b) < 1 ? fmax(form->a, form->b) : sqrt(form->a * form->b);
    case SHAPE_LINE:
    case SHAPE_CORNERS:
        return form->a;
    case SHAPE_WAVE:
    case SHAPE_ZIGZAG:
    case SHAPE_LOOPS:
        break;
    }
    return fmax(form->a, form->b);
}
