/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_CURVES_H
#define DUCTUS_TESTS_CURVES_H

/* Made-up curves and examples. */
#include "testing.h"

#include "analogy/analogy.h"

#include <math.h>

static inline duct_curve make_curve(size_t count, bool closed, bool extra)
{
    duct_error error;
    duct_curve curve;
    assert_ok(duct_curve_init(duct_allocator_of(NULL), count, closed, extra, &curve, &error));
    return curve;
}

/* A bent line whose bends never repeat, so that no two of its places are alike. */
static inline duct_curve make_course(size_t count, double length, double bend)
{
    duct_curve curve = make_curve(count, false, false);
    double angle = 0.3, x = 0, y = 0, step = length / (double)(count - 1);
    for (size_t i = 0; i < count; i++) {
        double at = (double)i * step;
        curve.x[i] = x;
        curve.y[i] = y;
        angle = 0.3 + bend * sin(at / 47) + 0.6 * bend * sin(at / 31.7 + 1);
        x += step * cos(angle);
        y += step * sin(angle);
    }
    duct_curve_use_arc_length(&curve);
    return curve;
}

/* A straight line as A, and as A' a wave on it whose length and height drift. */
static inline duct_curve_pair make_waves(double length, bool extra)
{
    size_t count = (size_t)length + 1;
    duct_curve_pair pair = {make_curve(count, false, false), make_curve(count, false, extra)};
    for (size_t i = 0; i < count; i++) {
        double at = (double)i;
        pair.a.x[i] = pair.b.x[i] = at;
        pair.a.y[i] = 5;
        pair.b.y[i] = 5 + (6 + sin(at / 53)) * sin(at / (3.6 + 0.3 * sin(at / 71)));
        if (extra) {
            pair.b.extra[i] = 0.5 + 0.4 * sin(at / 17);
        }
    }
    duct_curve_use_arc_length(&pair.a);
    memcpy(pair.b.t, pair.a.t, count * sizeof *pair.b.t);
    return pair;
}

static inline void free_pair(duct_curve_pair *pair)
{
    duct_curve_done(duct_allocator_of(NULL), &pair->a);
    duct_curve_done(duct_allocator_of(NULL), &pair->b);
}

static inline duct_analogy *make_model(const duct_curve_pair *pair, const duct_analogy_options *options)
{
    duct_error error;
    duct_analogy *model;
    assert_ok(duct_analogy_new(duct_allocator_of(NULL), pair, 1, options, &model, &error));
    return model;
}

static inline void free_curve(duct_curve *curve)
{
    duct_curve_done(duct_allocator_of(NULL), curve);
}

#endif
