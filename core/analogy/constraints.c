/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/constraints.h"

#include "base/error.h"

#include <math.h>

double duct_pulls_solve(const duct_pull *pulls, size_t count, double *x, double *y)
{
    double sum = 0, sum_x = 0, sum_y = 0, cost = 0;
    const duct_pull *hard = NULL;
    for (size_t i = 0; i < count; i++) {
        if (isinf(pulls[i].weight)) {
            hard = &pulls[i];
            continue;
        }
        sum += pulls[i].weight;
        sum_x += pulls[i].weight * pulls[i].x;
        sum_y += pulls[i].weight * pulls[i].y;
    }
    *x = hard != NULL ? hard->x : sum_x / sum;
    *y = hard != NULL ? hard->y : sum_y / sum;
    for (size_t i = 0; i < count; i++) {
        if (!isinf(pulls[i].weight)) {
            double dx = *x - pulls[i].x, dy = *y - pulls[i].y;
            cost += pulls[i].weight * (dx * dx + dy * dy);
        }
    }
    return cost;
}

double duct_constraint_soften(double weight, size_t level)
{
    double variance = isinf(weight) ? 0 : 1 / weight;
    return level == 0 ? weight : 1 / (variance + (double)level);
}

void duct_constraints_pin(duct_curve *curve, const duct_curve_constraint *constraints, size_t count,
                          size_t level, duct_pin *pins)
{
    for (size_t i = 0; i < count; i++) {
        const duct_curve_constraint *wanted = &constraints[i];
        duct_pin pin = {duct_curve_pin(curve, wanted->t),
                        {wanted->x, wanted->y, duct_constraint_soften(wanted->weight, level)},
                        {wanted->x, wanted->y}};
        size_t at = i;
        for (; at > 0 && pins[at - 1].at > pin.at; at--) {
            pins[at] = pins[at - 1];
        }
        pins[at] = pin;
    }
}

static double step_of(const duct_curve *curve, size_t i)
{
    size_t next = i + 1 < curve->count ? i + 1 : 0;
    return hypot(curve->x[next] - curve->x[i], curve->y[next] - curve->y[i]);
}

static bool is_pin(const duct_pin *pins, size_t count, size_t at)
{
    for (size_t p = 0; p < count; p++) {
        if (pins[p].at == at) {
            return true;
        }
    }
    return false;
}

/* The displacement of one pin, added to the control points on one side of it. Where another pin comes within
 * two reaches, it falls to 0 there. */
static void spread_side(const duct_curve *curve, const duct_pin *pins, size_t count, size_t which, int way,
                        double dx, double dy, double reach, double *out_x, double *out_y)
{
    long at = (long)pins[which].at, points = (long)curve->count;
    double room = 0, walked = 0;
    long i = at;
    bool met = false;
    for (long n = 0; n < points && room < 2 * reach && !met; n++) {
        long next = i + way;
        if (next < 0 || next >= points) {
            if (!curve->closed) {
                break;
            }
            next = next < 0 ? points - 1 : 0;
        }
        room += step_of(curve, (size_t)(way > 0 ? i : next));
        i = next;
        met = is_pin(pins, count, (size_t)i);
    }
    double fall = met && room < 2 * reach ? room : reach;
    i = at;
    for (long n = 0; n < points; n++) {
        long next = i + way;
        if (next < 0 || next >= points) {
            if (!curve->closed) {
                return;
            }
            next = next < 0 ? points - 1 : 0;
        }
        walked += step_of(curve, (size_t)(way > 0 ? i : next));
        double share = 1 - walked / fall;
        if (share <= 0 || next == at || is_pin(pins, count, (size_t)next)) {
            return;
        }
        out_x[next] += share * dx;
        out_y[next] += share * dy;
        i = next;
    }
}

void duct_constraints_spread(duct_curve *curve, const duct_pin *pins, size_t count, double reach)
{
    /* One pin after another: each meets the curve as the ones before have left it, and falls to 0 at all
     * others. */
    for (size_t i = 0; i < count; i++) {
        const duct_pin *pin = &pins[i];
        double share = isinf(pin->pull.weight) ? 1 : pin->pull.weight / (1 + pin->pull.weight);
        double dx = share * (pin->pull.x - curve->x[pin->at]), dy = share * (pin->pull.y - curve->y[pin->at]);
        spread_side(curve, pins, count, i, 1, dx, dy, reach, curve->x, curve->y);
        spread_side(curve, pins, count, i, -1, dx, dy, reach, curve->x, curve->y);
        curve->x[pin->at] = share >= 1 ? pin->pull.x : curve->x[pin->at] + dx;
        curve->y[pin->at] = share >= 1 ? pin->pull.y : curve->y[pin->at] + dy;
    }
}

void duct_constraints_settle(duct_curve *curve, const duct_pin *pins, size_t count, double reach)
{
    for (size_t i = 0; i < count; i++) {
        if (isinf(pins[i].pull.weight)) {
            curve->x[pins[i].at] = pins[i].free[0];
            curve->y[pins[i].at] = pins[i].free[1];
        }
    }
    duct_constraints_spread(curve, pins, count, reach);
}

duct_status duct_constraints_check(const duct_curve_constraint *constraints, size_t count, duct_error *error)
{
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < i; j++) {
            const duct_curve_constraint *a = &constraints[i], *b = &constraints[j];
            if (isinf(a->weight) && isinf(b->weight) && a->t == b->t && (a->x != b->x || a->y != b->y)) {
                return duct_fail(
                    error, DUCT_UNSUPPORTED,
                    "two fixed points contradict each other: one place of the curve cannot be at "
                    "(%g, %g) and at (%g, %g); take one of them away or make it soft",
                    b->x, b->y, a->x, a->y);
            }
        }
    }
    return DUCT_OK;
}
