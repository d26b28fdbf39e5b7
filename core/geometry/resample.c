/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/resample.h"

#include "base/error.h"

#include <ductus/drawing.h>

#include <math.h>
#include <string.h>

double duct_arc_lengths(const double *x, const double *y, size_t count, double *at)
{
    double length = 0;
    for (size_t i = 0; i < count; i++) {
        if (i > 0) {
            length += hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
        }
        at[i] = length;
    }
    return length;
}

double duct_interpolate(const double *at, const double *values, size_t count, double where, size_t *hint)
{
    size_t i = *hint < count ? *hint : 0;
    if (at[i] > where) {
        i = 0;
    }
    while (i + 1 < count && at[i + 1] < where) {
        i++;
    }
    *hint = i;
    if (i + 1 >= count || where <= at[i]) {
        return values[i];
    }
    double share = (where - at[i]) / (at[i + 1] - at[i]);
    return values[i] + share * (values[i + 1] - values[i]);
}

double duct_stroke_length(const duct_stroke *stroke)
{
    const double *x = duct_stroke_values(stroke, DUCT_X);
    const double *y = duct_stroke_values(stroke, DUCT_Y);
    size_t count = duct_stroke_size(stroke);
    double length = 0;
    for (size_t i = 1; i < count; i++) {
        length += hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
    }
    if (duct_stroke_closed(stroke) && count > 1) {
        length += hypot(x[0] - x[count - 1], y[0] - y[count - 1]);
    }
    return length;
}

/* The stroke's points with the closing one repeated, and with curves between recorded points that are far
 * apart. */
typedef struct {
    size_t count;
    double *at;     /* arc length */
    double *own_at; /* of the stroke's own points */
    double *channels[DUCT_CHANNEL_COUNT];
} dense;

static void dense_free(const duct_allocator *allocator, dense *points)
{
    duct_release(allocator, points->at);
    duct_release(allocator, points->own_at);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(allocator, points->channels[c]);
    }
}

/* Catmull-Rom between b and c with end tangents from the neighbours, at u in 0..1. The tangents are those of
 * equal steps, which recorded samples nearly have. */
static double catmull_rom(double a, double b, double c, double d, double u)
{
    double u2 = u * u, u3 = u2 * u;
    return 0.5 * (2 * b + (c - a) * u + (2 * a - 5 * b + 4 * c - d) * u2 + (3 * b - a - 3 * c + d) * u3);
}

/* How many pieces the span behind point i is cut into. */
static size_t pieces_of(const double *x, const double *y, size_t i, size_t next, double unit, bool smooth)
{
    if (!smooth) {
        return 1;
    }
    double pieces = ceil(2 * hypot(x[next] - x[i], y[next] - y[i]) / unit);
    return pieces < 1 ? 1 : pieces > 64 ? 64 : (size_t)pieces;
}

static duct_status make_dense(const duct_allocator *allocator, const duct_stroke *stroke, double unit,
                              dense *points, duct_error *error)
{
    size_t size = duct_stroke_size(stroke);
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    bool closed = duct_stroke_closed(stroke) && size > 2;
    bool smooth = duct_stroke_values(stroke, DUCT_T) != NULL && size > 2;
    size_t spans = closed ? size : size - 1, count = 1;
    for (size_t i = 0; i < spans; i++) {
        count += pieces_of(x, y, i, (i + 1) % size, unit, smooth);
    }
    memset(points, 0, sizeof *points);
    points->at = duct_alloc(allocator, count, sizeof(double));
    points->own_at = duct_alloc(allocator, size, sizeof(double));
    bool good = points->at != NULL && points->own_at != NULL;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        if (duct_stroke_values(stroke, (duct_channel)c) != NULL) {
            points->channels[c] = duct_alloc(allocator, count, sizeof(double));
            good = good && points->channels[c] != NULL;
        }
    }
    if (!good) {
        dense_free(allocator, points);
        return duct_fail_memory(error);
    }
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        const double *from = duct_stroke_values(stroke, (duct_channel)c);
        double *to = points->channels[c];
        if (from == NULL) {
            continue;
        }
        size_t k = 0;
        to[k++] = from[0];
        for (size_t i = 0; i < spans; i++) {
            /* Time and pose do not jump back to the start on the closing span: they hold their last value. */
            bool wraps = closed && i == spans - 1;
            size_t next = (i + 1) % size;
            bool place = c == DUCT_X || c == DUCT_Y;
            double b = from[i], d = wraps && !place ? from[i] : from[next];
            size_t before = i > 0 ? i - 1 : closed ? size - 1 : i, after = closed ? (i + 2) % size : i + 2;
            double a = place ? from[before] : b, e = place ? from[after < size ? after : next] : d;
            size_t pieces = pieces_of(x, y, i, next, unit, smooth);
            for (size_t p = 1; p <= pieces; p++) {
                double u = (double)p / (double)pieces;
                to[k++] = p == pieces ? d : place ? catmull_rom(a, b, d, e, u) : b + u * (d - b);
            }
        }
    }
    points->count = count;
    duct_arc_lengths(points->channels[DUCT_X], points->channels[DUCT_Y], count, points->at);
    size_t place = 0;
    for (size_t i = 0; i < size; i++) {
        points->own_at[i] = points->at[place];
        place += i < spans ? pieces_of(x, y, i, (i + 1) % size, unit, smooth) : 0;
    }
    return DUCT_OK;
}

duct_status duct_samples_make(const duct_allocator *allocator, const duct_stroke *stroke, double unit,
                              duct_samples *samples, duct_error *error)
{
    memset(samples, 0, sizeof *samples);
    double chord = duct_stroke_length(stroke);
    if (duct_stroke_size(stroke) < 2 || !(chord > 0) || !isfinite(chord)) {
        return DUCT_OK;
    }
    if (!(chord / unit < DUCT_MAX_SAMPLES)) {
        return duct_fail(error, DUCT_LIMIT,
                         "stroke '%.60s' is too long for its scale: %g times the sampling unit",
                         duct_stroke_id(stroke), chord / unit);
    }
    dense points;
    duct_status status = make_dense(allocator, stroke, unit, &points, error);
    if (status != DUCT_OK) {
        return status;
    }
    double length = points.at[points.count - 1];
    size_t steps = (size_t)floor(length / unit + 0.5);
    size_t count = (steps < 1 ? 1 : steps) + 1;
    samples->count = count;
    samples->step = length / (double)(count - 1);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        if (points.channels[c] == NULL) {
            continue;
        }
        double *to = duct_alloc(allocator, count, sizeof(double));
        samples->channels[c] = to;
        if (to == NULL) {
            duct_samples_free(allocator, samples);
            dense_free(allocator, &points);
            return duct_fail_memory(error);
        }
        size_t hint = 0;
        for (size_t i = 0; i < count; i++) {
            double where = i + 1 == count ? length : (double)i * samples->step;
            to[i] = duct_interpolate(points.at, points.channels[c], points.count, where, &hint);
        }
    }
    samples->at = points.own_at;
    points.own_at = NULL;
    dense_free(allocator, &points);
    return DUCT_OK;
}

void duct_samples_free(const duct_allocator *allocator, duct_samples *samples)
{
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(allocator, samples->channels[c]);
    }
    duct_release(allocator, samples->at);
    memset(samples, 0, sizeof *samples);
}
