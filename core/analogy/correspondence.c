/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/correspondence.h"

#include "base/error.h"

#include <math.h>

enum { WARPED = 256, FEWEST = 8 };

/* Parameters of b's control points by their share of a's parameter at the same number; strictly increasing.
 */
static void by_samples(const duct_curve *a, duct_curve *b)
{
    duct_curve_use_arc_length(b);
    for (size_t i = 0; i < b->count; i++) {
        /* A little of b's own arc length, so that the parameter goes on where A stands still. */
        b->t[i] = 0.98 * a->t[i] + 0.02 * b->t[i];
    }
}

/* Dynamic time warping of two curves sampled evenly: the monotone path of least total squared distance. Fills
 * where[i] with the place on a, 0..1, that belongs to sample i of b. */
static void warp(const duct_curve *a, const duct_curve *b, double *costs, unsigned char *from, double *where)
{
    size_t n = a->count, m = b->count;
    for (size_t i = 0; i < m; i++) {
        for (size_t j = 0; j < n; j++) {
            double dx = b->x[i] - a->x[j], dy = b->y[i] - a->y[j], least = i + j > 0 ? INFINITY : 0;
            unsigned char way = 0;
            /* Both on, only b on, only a on; the first one wins among equals. */
            if (i > 0 && j > 0 && costs[(i - 1) * n + j - 1] < least) {
                least = costs[(i - 1) * n + j - 1];
                way = 0;
            }
            if (i > 0 && costs[(i - 1) * n + j] < least) {
                least = costs[(i - 1) * n + j];
                way = 1;
            }
            if (j > 0 && costs[i * n + j - 1] < least) {
                least = costs[i * n + j - 1];
                way = 2;
            }
            costs[i * n + j] = least + dx * dx + dy * dy;
            from[i * n + j] = way;
        }
    }
    size_t i = m - 1, j = n - 1, run = j;
    for (;;) {
        unsigned char way = from[i * n + j];
        if (way != 2 || (i == 0 && j == 0)) {
            where[i] = 0.5 * (double)(run + j) / (double)(n - 1);
        }
        if (i == 0 && j == 0) {
            return;
        }
        i -= way != 2;
        j -= way != 1;
        run = way != 2 ? j : run;
    }
}

static duct_status by_warp(const duct_allocator *allocator, const duct_curve *a, duct_curve *b,
                           duct_error *error)
{
    duct_curve even_a, even_b;
    double step_a = duct_curve_length(a) / (WARPED - 1), step_b = duct_curve_length(b) / (WARPED - 1);
    duct_status status = duct_curve_resample(allocator, a, step_a, 1, &even_a, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = duct_curve_resample(allocator, b, step_b, 1, &even_b, error);
    if (status != DUCT_OK) {
        duct_curve_done(allocator, &even_a);
        return status;
    }
    double *costs = duct_alloc(allocator, even_a.count * even_b.count + even_b.count, sizeof *costs);
    unsigned char *from = duct_alloc(allocator, even_a.count * even_b.count, 1);
    if (costs == NULL || from == NULL) {
        status = duct_fail_memory(error);
    } else {
        double *where = costs + even_a.count * even_b.count;
        warp(&even_a, &even_b, costs, from, where);
        duct_curve_use_arc_length(b);
        size_t last = even_b.count - 1;
        for (size_t i = 0; i < b->count; i++) {
            double at = b->t[i] * (double)last;
            size_t k = at < (double)last ? (size_t)at : last - 1;
            double warped = where[k] + (at - (double)k) * (where[k + 1] - where[k]);
            b->t[i] = 0.9 * warped + 0.1 * b->t[i];
        }
    }
    duct_release(allocator, costs);
    duct_release(allocator, from);
    duct_curve_done(allocator, &even_a);
    duct_curve_done(allocator, &even_b);
    return status;
}

duct_status duct_correspond(const duct_allocator *allocator, duct_correspondence how, duct_curve *a,
                            duct_curve *b, duct_error *error)
{
    duct_curve_use_arc_length(a);
    bool paired = a->count == b->count && a->closed == b->closed;
    if (paired && (how == DUCT_CORRESPOND_SAMPLES || (how == DUCT_CORRESPOND_AUTO && a->count >= FEWEST))) {
        by_samples(a, b);
        return DUCT_OK;
    }
    /* A closed curve has no end for a warping path to hold on to. */
    if (how == DUCT_CORRESPOND_WARP && !a->closed && !b->closed) {
        return by_warp(allocator, a, b, error);
    }
    duct_curve_use_arc_length(b);
    return DUCT_OK;
}
