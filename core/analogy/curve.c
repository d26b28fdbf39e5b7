/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/curve.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

/* More control points than this take minutes and gigabytes. */
#define MOST_POINTS 1000000.0

duct_status duct_curve_init(const duct_allocator *allocator, size_t count, bool closed, bool extra,
                            duct_curve *curve, duct_error *error)
{
    double *block = duct_alloc(allocator, count * (extra ? 4 : 3), sizeof *block);
    if (block == NULL) {
        return duct_fail_memory(error);
    }
    *curve = (duct_curve){.count = count, .closed = closed, .block = block};
    curve->t = block;
    curve->x = block + count;
    curve->y = block + 2 * count;
    curve->extra = extra ? block + 3 * count : NULL;
    return DUCT_OK;
}

void duct_curve_done(const duct_allocator *allocator, duct_curve *curve)
{
    duct_release(allocator, curve->block);
    memset(curve, 0, sizeof *curve);
}

size_t duct_curve_segments(const duct_curve *curve)
{
    return curve->closed ? curve->count : curve->count > 0 ? curve->count - 1 : 0;
}

static double segment_length(const duct_curve *curve, size_t i)
{
    size_t next = i + 1 < curve->count ? i + 1 : 0;
    return hypot(curve->x[next] - curve->x[i], curve->y[next] - curve->y[i]);
}

double duct_curve_length(const duct_curve *curve)
{
    double length = 0;
    for (size_t i = 0; i < duct_curve_segments(curve); i++) {
        length += segment_length(curve, i);
    }
    return length;
}

void duct_curve_use_arc_length(duct_curve *curve)
{
    double length = duct_curve_length(curve), sum = 0;
    for (size_t i = 0; i < curve->count; i++) {
        curve->t[i] = length > 0 ? sum / length : 0;
        sum += segment_length(curve, i);
    }
    if (!curve->closed && curve->count > 1) {
        curve->t[curve->count - 1] = 1;
    }
}

/* The parameter at the end of segment i. */
static double end_parameter(const duct_curve *curve, size_t i)
{
    return i + 1 < curve->count ? curve->t[i + 1] : curve->t[0] + 1;
}

duct_place duct_curve_find(const duct_curve *curve, double t, size_t *hint)
{
    size_t segments = duct_curve_segments(curve), i = *hint < segments ? *hint : 0;
    if (segments == 0) {
        return (duct_place){0, 0};
    }
    if (curve->t[i] > t) {
        i = 0;
    }
    while (i + 1 < segments && end_parameter(curve, i) <= t) {
        i++;
    }
    *hint = i;
    double begin = curve->t[i], end = end_parameter(curve, i);
    double share = end > begin ? (t - begin) / (end - begin) : 0;
    return (duct_place){i, share < 0 ? 0 : share > 1 ? 1 : share};
}

static double between(const duct_curve *curve, const double *values, duct_place place)
{
    size_t next = place.at + 1 < curve->count ? place.at + 1 : curve->closed ? 0 : place.at;
    return values[place.at] + place.share * (values[next] - values[place.at]);
}

void duct_curve_point(const duct_curve *curve, duct_place place, double *x, double *y)
{
    *x = between(curve, curve->x, place);
    *y = between(curve, curve->y, place);
}

double duct_curve_extra(const duct_curve *curve, duct_place place)
{
    return between(curve, curve->extra, place);
}

duct_status duct_curve_resample(const duct_allocator *allocator, const duct_curve *curve, double spacing,
                                size_t fewest, duct_curve *resampled, duct_error *error)
{
    double length = duct_curve_length(curve), wanted = length / spacing;
    if (!(wanted < MOST_POINTS)) {
        return duct_fail(error, DUCT_LIMIT,
                         "a curve is too long for its scale: %.3g control points; give a larger scale or "
                         "spacing",
                         wanted);
    }
    size_t segments = (size_t)floor(wanted + 0.5);
    fewest = curve->closed && fewest < 3 ? 3 : fewest < 1 ? 1 : fewest;
    segments = segments < fewest ? fewest : segments;
    duct_status status = duct_curve_init(allocator, curve->closed ? segments : segments + 1, curve->closed,
                                         curve->extra != NULL, resampled, error);
    if (status != DUCT_OK) {
        return status;
    }
    double step = length / (double)segments, passed = 0, here = segment_length(curve, 0);
    size_t at = 0, last = duct_curve_segments(curve) - 1;
    for (size_t i = 0; i < resampled->count; i++) {
        double where = (double)i * step;
        while (at < last && passed + here < where) {
            passed += here;
            here = segment_length(curve, ++at);
        }
        double share = here > 0 ? (where - passed) / here : 0;
        duct_place place = {at, share < 0 ? 0 : share > 1 ? 1 : share};
        if (!curve->closed && i + 1 == resampled->count) {
            place = (duct_place){curve->count - 1, 0};
        }
        duct_curve_point(curve, place, &resampled->x[i], &resampled->y[i]);
        double begin = curve->t[place.at];
        double end = curve->closed || place.at < last + 1 ? end_parameter(curve, place.at) : begin;
        resampled->t[i] = place.share > 0 ? begin + place.share * (end - begin) : begin;
        if (curve->extra != NULL) {
            resampled->extra[i] = duct_curve_extra(curve, place);
        }
    }
    return DUCT_OK;
}

size_t duct_curve_pin(duct_curve *curve, double t)
{
    size_t hint = 0;
    duct_place place = duct_curve_find(curve, t, &hint);
    size_t nearest = place.share > 0.5 ? place.at + 1 : place.at;
    if (!curve->closed) {
        size_t end = curve->count - 1;
        nearest = t <= 0 ? 0 : t >= 1 ? end : nearest < 1 && end > 1 ? 1 : nearest;
        nearest = t > 0 && t < 1 && nearest >= end && end > 1 ? end - 1 : nearest;
        if (t <= 0 || t >= 1) {
            return nearest;
        }
    } else if (nearest >= curve->count) {
        nearest = 0;
    }
    if (curve->closed && nearest == 0) {
        return 0; /* the beginning keeps its parameter */
    }
    double x, y, extra = curve->extra != NULL ? duct_curve_extra(curve, place) : 0;
    duct_curve_point(curve, place, &x, &y);
    curve->t[nearest] = t;
    curve->x[nearest] = x;
    curve->y[nearest] = y;
    if (curve->extra != NULL) {
        curve->extra[nearest] = extra;
    }
    return nearest;
}
