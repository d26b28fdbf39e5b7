/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "manner.h"

#include <math.h>

/* Arcs of at least this many degrees are closed rounds. */
static const double closed = 350;

void manner_hook(const stroke_manner *manner, action_plan *plan)
{
    if (!(manner->hook > 0) || plan->count < 2 || plan->count == PLAN_TARGETS) {
        return;
    }
    const double dx = plan->targets[1].x - plan->targets[0].x, dy = plan->targets[1].y - plan->targets[0].y;
    const double length = fmin(manner->hook, 0.3 * hypot(dx, dy));
    const double angle = atan2(dy, dx) + manner->hook_turn;
    for (size_t i = plan->count; i > 0; i--) {
        plan->targets[i] = plan->targets[i - 1];
    }
    plan->count++;
    plan->targets[0] = (plan_target){plan->targets[1].x + length * cos(angle),
                                     plan->targets[1].y + length * sin(angle), false, false};
    plan->targets[1].corner = true;
}

static double pieced_length(const stroke_manner *manner, const shape *form)
{
    if (manner->piece > 0 && form->kind == SHAPE_LINE) {
        return form->a;
    }
    if (manner->piece > 0 && form->kind == SHAPE_ARC && fabs(form->amount) < closed) {
        return hypot(form->a, form->b) / M_SQRT2 * fabs(form->amount) * M_PI / 180;
    }
    return 0;
}

size_t manner_pieces(const stroke_manner *manner, const shape *form)
{
    const double length = pieced_length(manner, form);
    return length > 1.4 * manner->piece ? (size_t)ceil(length / manner->piece) : 1;
}

shape manner_piece(const stroke_manner *manner, const shape *form, size_t index)
{
    shape piece = *form;
    const size_t count = manner_pieces(manner, form);
    /* The part of the shape that this stroke covers, its neighbours' ends included. */
    const double share = 1 / (double)count, more = count > 1 ? manner->overlap * share : 0;
    const double from = fmax((double)index * share - more / 2, 0);
    const double to = fmin((double)(index + 1) * share + more / 2, 1);
    if (form->kind == SHAPE_LINE) {
        const double angle = form->angle * M_PI / 180;
        piece.x += from * form->a * cos(angle);
        piece.y += from * form->a * sin(angle);
        piece.a = (to - from) * form->a;
        piece.b += manner->bow * piece.a;
    } else if (form->kind == SHAPE_ARC) {
        piece.from += from * form->amount;
        piece.amount *= to - from;
        if (fabs(form->amount) >= closed) {
            piece.amount *= manner->rounds;
        }
    }
    return piece;
}
