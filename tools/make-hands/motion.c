/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "motion.h"

#include "wander.h"

#include <ductus/random.h>

#include <math.h>

/* One lognormal movement along an arc. */
typedef struct movement {
    double t0, mu, sigma;
    double length, angle, bend; /* the arc's length, the direction of its chord, and its turn */
} movement;

typedef struct performance {
    const action_plan *plan;
    movement movements[PLAN_TARGETS];
    size_t count;
    double bends[PLAN_TARGETS];
    double passing[PLAN_TARGETS];   /* when the pen is nearest to a target */
    plan_target aims[PLAN_TARGETS]; /* where the hand heads for so that the pen passes the targets */
    double end;
} performance;

/* The share of a movement's way that is done at time t. */
static double progress(const movement *m, double t)
{
    const double since = t - m->t0;
    return since <= 0 ? 0 : 0.5 * erfc(-(log(since) - m->mu) / (m->sigma * M_SQRT2));
}

static void move_along(const movement *m, double share, double *x, double *y)
{
    const double start = m->angle - m->bend / 2;
    if (fabs(m->bend) < 1e-6) {
        *x += m->length * share * cos(m->angle);
        *y += m->length * share * sin(m->angle);
        return;
    }
    const double radius = m->length / m->bend;
    *x += radius * (sin(start + m->bend * share) - sin(start));
    *y += radius * (cos(start) - cos(start + m->bend * share));
}

static void position_at(const performance *p, double t, double *x, double *y)
{
    *x = p->aims[0].x;
    *y = p->aims[0].y;
    for (size_t i = 0; i < p->count; i++) {
        const double share = progress(&p->movements[i], t);
        if (share <= 0) {
            break; /* the later ones have not started either */
        }
        move_along(&p->movements[i], share, x, y);
    }
}

/* Fits each movement's arc between the aims. */
static void lay_arcs(performance *p)
{
    for (size_t i = 0; i < p->count; i++) {
        const double dx = p->aims[i + 1].x - p->aims[i].x;
        const double dy = p->aims[i + 1].y - p->aims[i].y;
        const double half = p->bends[i] / 2;
        const double chord = hypot(dx, dy);
        p->movements[i].angle = atan2(dy, dx);
        p->movements[i].bend = p->bends[i];
        p->movements[i].length = fabs(half) < 1e-6 ? chord : chord * half / sin(half);
    }
}

/* How long after a movement's onset the next one starts, as a share of its duration. */
static double delay_share(const motor_style *style, const action_plan *plan, size_t index)
{
    const double sharp =
        plan->targets[index].corner ? 1 : fmin(1, fabs(plan_turn(plan, index)) / M_PI) * 0.35;
    return style->smooth_delay + (style->corner_delay - style->smooth_delay) * sharp;
}

static void set_times(performance *p, const motor_style *style, uint64_t seed, uint64_t stroke)
{
    double onset = 0;
    for (size_t i = 0; i < p->count; i++) {
        movement *m = &p->movements[i];
        const double way = fmax(m->length, 0.05 * style->reach) / style->reach;
        const double chance = 1 + style->time_jitter * duct_random_normal(seed, stroke, i, CHANCE_DURATION);
        const double duration = style->duration * pow(way, style->isochrony) * fmax(0.6, chance);
        /* The lognormal's six sigmas take the whole duration, and begin at the onset. */
        m->sigma = style->sigma;
        m->mu = log(duration / (2 * sinh(3 * m->sigma)));
        m->t0 = onset - exp(m->mu - 3 * m->sigma);
        p->end = onset + duration;
        const double late =
            1 + 0.5 * style->time_jitter * duct_random_normal(seed, stroke, i, CHANCE_OVERLAP);
        onset += duration * delay_share(style, p->plan, i + 1) * late;
    }
    for (size_t i = 1; i < p->count; i++) {
        double peaks[2];
        for (size_t k = 0; k < 2; k++) {
            const movement *m = &p->movements[i - 1 + k];
            peaks[k] = m->t0 + exp(m->mu - m->sigma * m->sigma);
        }
        p->passing[i] = (peaks[0] + peaks[1]) / 2;
    }
}

/* Moves the aims until the pen passes the targets as well as `accuracy` wants. */
static void correct_aims(performance *p, double accuracy)
{
    for (int round = 0; round < 8; round++) {
        for (size_t i = 1; i < p->count; i++) {
            double x, y;
            position_at(p, p->passing[i], &x, &y);
            const plan_target *target = &p->plan->targets[i];
            /* Not all of the error at once: the neighbours correct theirs as well. */
            const double wanted_x = p->aims[i].x + 0.7 * (target->x - x);
            const double wanted_y = p->aims[i].y + 0.7 * (target->y - y);
            p->aims[i].x = wanted_x + (1 - accuracy) * 0.35 * (target->x - wanted_x);
            p->aims[i].y = wanted_y + (1 - accuracy) * 0.35 * (target->y - wanted_y);
        }
        lay_arcs(p);
    }
}

/* The pen comes down and leaves while it moves, so the slow ends of the lognormals are not seen. */
static void find_touch(const performance *p, double *from, double *to)
{
    const movement *first = &p->movements[0];
    const movement *last = &p->movements[p->count - 1];
    *from = first->t0 + exp(first->mu - 1.9 * first->sigma);
    *to = last->t0 + exp(last->mu + 1.75 * last->sigma);
}

void motion_perform(const motor_style *style, const action_plan *plan, double jitter, uint64_t seed,
                    uint64_t stroke, trajectory *result)
{
    result->size = 0;
    if (plan->count < 2) {
        return;
    }
    action_plan varied = *plan;
    for (size_t i = 0; i < varied.count; i++) {
        varied.targets[i].x += jitter * duct_random_normal(seed, stroke, i, CHANCE_POINT_X);
        varied.targets[i].y += jitter * duct_random_normal(seed, stroke, i, CHANCE_POINT_Y);
    }
    performance p = {.plan = &varied, .count = varied.count - 1};
    plan_bends(&varied, p.bends);
    for (size_t i = 0; i < p.count; i++) {
        p.bends[i] = style->roundness * p.bends[i] +
                     style->bend_jitter * duct_random_normal(seed, stroke, i, CHANCE_BEND);
    }
    for (size_t i = 0; i < varied.count; i++) {
        p.aims[i] = varied.targets[i];
    }
    lay_arcs(&p);
    set_times(&p, style, seed, stroke);
    correct_aims(&p, style->accuracy);

    double from, to;
    find_touch(&p, &from, &to);
    const size_t size = (size_t)fmax(2, floor((to - from) * MOTION_RATE) + 1);
    result->size = size < MOTION_SAMPLES ? size : MOTION_SAMPLES;
    for (size_t k = 0; k < result->size; k++) {
        const double t = (double)k / MOTION_RATE;
        double x, y;
        position_at(&p, from + t, &x, &y);
        result->t[k] = t;
        result->x[k] = x + style->tremor * wander(seed, stroke, CHANCE_TREMOR_X, t * style->tremor_rate);
        result->y[k] = y + style->tremor * wander(seed, stroke, CHANCE_TREMOR_Y, t * style->tremor_rate);
    }
}
