/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/bezier.h"

#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

void duct_path_quadratic(duct_path *path, double x0, double y0, double x1, double y1, double x, double y)
{
    duct_path_cubic(path, x0 + (x1 - x0) * 2 / 3, y0 + (y1 - y0) * 2 / 3, x + (x1 - x) * 2 / 3,
                    y + (y1 - y) * 2 / 3, x, y);
}

/* An ellipse arc by its centre: the points are map(cos t, sin t) for t from `start` over `extent`. */
typedef struct {
    duct_affine map;
    double start, extent;
} centre_arc;

/* From end points to the centre: SVG 1.1, appendix F.6.5 and F.6.6. */
static centre_arc centre_of(double x0, double y0, double rx, double ry, double rotation, bool large,
                            bool sweep, double x, double y)
{
    double sine = sin(rotation), cosine = cos(rotation);
    double hx = (x0 - x) / 2, hy = (y0 - y) / 2;
    /* The chord in units of the radii: the ellipse is then a unit circle. */
    double ux = (cosine * hx + sine * hy) / rx, uy = (-sine * hx + cosine * hy) / ry;
    double chord = hypot(ux, uy);
    if (chord > 1) {
        rx *= chord;
        ry *= chord;
        ux /= chord;
        uy /= chord;
        chord = 1;
    }
    double height = sqrt(fmax(0, 1 - chord * chord)) / chord;
    if (large == sweep) {
        height = -height;
    }
    double cx = height * uy, cy = -height * ux;
    centre_arc arc;
    arc.map = (duct_affine){rx * cosine, rx * sine, -ry * sine, ry * cosine, 0, 0};
    arc.map.e = (x0 + x) / 2 + arc.map.a * cx + arc.map.c * cy;
    arc.map.f = (y0 + y) / 2 + arc.map.b * cx + arc.map.d * cy;
    arc.start = atan2(uy - cy, ux - cx);
    arc.extent = atan2(-uy - cy, -ux - cx) - arc.start;
    if (sweep && arc.extent < 0) {
        arc.extent += 2 * pi;
    } else if (!sweep && arc.extent > 0) {
        arc.extent -= 2 * pi;
    }
    return arc;
}

void duct_path_arc(duct_path *path, double x0, double y0, double rx, double ry, double rotation, bool large,
                   bool sweep, double x, double y)
{
    if (x0 == x && y0 == y) {
        return;
    }
    rx = fabs(rx);
    ry = fabs(ry);
    if (!(rx > 0) || !(ry > 0)) {
        duct_path_line(path, x, y);
        return;
    }
    centre_arc arc = centre_of(x0, y0, rx, ry, fmod(rotation, 360) * pi / 180, large, sweep, x, y);
    /* Radii that are absurd beside the chord leave no usable centre: the arc is straight then. */
    if (!isfinite(arc.map.a + arc.map.b + arc.map.c + arc.map.d + arc.map.e + arc.map.f + arc.start) ||
        !isfinite(arc.extent)) {
        duct_path_line(path, x, y);
        return;
    }
    int pieces = (int)ceil(fabs(arc.extent) / (pi / 8) - 1e-9);
    pieces = pieces < 1 ? 1 : pieces;
    double step = arc.extent / pieces, handle = 4.0 / 3 * tan(step / 4);
    for (int i = 0; i < pieces; i++) {
        double t0 = arc.start + i * step, t1 = arc.start + (i + 1) * step;
        double p[6] = {cos(t0) - handle * sin(t0),
                       sin(t0) + handle * cos(t0),
                       cos(t1) + handle * sin(t1),
                       sin(t1) - handle * cos(t1),
                       cos(t1),
                       sin(t1)};
        duct_affine_apply(arc.map, &p[0], &p[1]);
        duct_affine_apply(arc.map, &p[2], &p[3]);
        duct_affine_apply(arc.map, &p[4], &p[5]);
        bool last = i + 1 == pieces;
        duct_path_cubic(path, p[0], p[1], p[2], p[3], last ? x : p[4], last ? y : p[5]);
    }
}

void duct_path_transform(duct_path *path, duct_affine map)
{
    for (size_t i = 0; i < path->point_count; i++) {
        duct_affine_apply(map, &path->points[2 * i], &path->points[2 * i + 1]);
    }
}

void duct_path_map(duct_path *path, const double matrix[6])
{
    duct_path_transform(path,
                        (duct_affine){matrix[0], matrix[1], matrix[2], matrix[3], matrix[4], matrix[5]});
}

static size_t points_of(unsigned char verb)
{
    return verb == DUCT_PATH_CLOSE ? 0 : verb == DUCT_PATH_CUBIC ? 3 : 1;
}

bool duct_path_next(const duct_path *path, duct_subpath *subpath)
{
    size_t verb = subpath->verb_end;
    if (verb >= path->verb_count) {
        return false;
    }
    duct_subpath next = {verb, verb, subpath->point_end, subpath->point_end, false};
    do {
        next.closed = next.closed || path->verbs[verb] == DUCT_PATH_CLOSE;
        next.point_end += points_of(path->verbs[verb]);
        verb++;
    } while (verb < path->verb_count && path->verbs[verb] != DUCT_PATH_MOVE);
    next.verb_end = verb;
    *subpath = next;
    return true;
}

void duct_path_append(duct_path *path, const duct_path *other, const duct_subpath *subpath)
{
    const double *p = other->points + 2 * subpath->point;
    for (size_t v = subpath->verb; v < subpath->verb_end; v++) {
        switch ((duct_path_verb)other->verbs[v]) {
        case DUCT_PATH_MOVE:
            duct_path_move(path, p[0], p[1]);
            break;
        case DUCT_PATH_LINE:
            duct_path_line(path, p[0], p[1]);
            break;
        case DUCT_PATH_CUBIC:
            duct_path_cubic(path, p[0], p[1], p[2], p[3], p[4], p[5]);
            break;
        case DUCT_PATH_CLOSE:
            duct_path_close(path);
            break;
        }
        p += 2 * points_of(other->verbs[v]);
    }
}

void duct_points_init(duct_points *points, const duct_allocator *allocator, size_t limit)
{
    *points = (duct_points){.allocator = allocator, .limit = limit};
}

void duct_points_free(duct_points *points)
{
    duct_release(points->allocator, points->x);
    duct_release(points->allocator, points->y);
    duct_points_init(points, points->allocator, points->limit);
}

static bool coincide(double x0, double y0, double x1, double y1)
{
    return fabs(x0 - x1) <= 1e-9 && fabs(y0 - y1) <= 1e-9;
}

void duct_points_add(duct_points *points, double x, double y)
{
    if (points->failed || points->full) {
        return;
    }
    size_t count = points->count;
    if (count > 0 && coincide(points->x[count - 1], points->y[count - 1], x, y)) {
        return;
    }
    if (count >= points->limit) {
        points->full = true;
        return;
    }
    void *xs = points->x, *ys = points->y;
    bool room = duct_reserve(points->allocator, &xs, &points->x_capacity, count + 1, sizeof(double)) &&
                duct_reserve(points->allocator, &ys, &points->y_capacity, count + 1, sizeof(double));
    points->x = xs;
    points->y = ys;
    if (!room) {
        points->failed = true;
        return;
    }
    points->x[count] = x;
    points->y[count] = y;
    points->count++;
}

/* A curve's distance from its chords is at most an eighth of its second derivative's bound over the square of
 * the number of equal steps (Wang's formula). */
static size_t steps_of(const double c[8], double tolerance)
{
    enum { MOST = 65536 };
    double first = hypot(c[0] - 2 * c[2] + c[4], c[1] - 2 * c[3] + c[5]);
    double second = hypot(c[2] - 2 * c[4] + c[6], c[3] - 2 * c[5] + c[7]);
    double steps = ceil(sqrt(0.75 * fmax(first, second) / tolerance));
    return !(steps >= 1) ? 1 : steps > MOST ? MOST : (size_t)steps;
}

void duct_flatten_cubic(duct_points *points, const double c[8], double tolerance)
{
    size_t steps = steps_of(c, tolerance);
    for (size_t i = 1; i < steps && !points->failed && !points->full; i++) {
        double t = (double)i / (double)steps, s = 1 - t;
        double b0 = s * s * s, b1 = 3 * s * s * t, b2 = 3 * s * t * t, b3 = t * t * t;
        duct_points_add(points, b0 * c[0] + b1 * c[2] + b2 * c[4] + b3 * c[6],
                        b0 * c[1] + b1 * c[3] + b2 * c[5] + b3 * c[7]);
    }
    duct_points_add(points, c[6], c[7]);
}

void duct_flatten_subpath(duct_points *points, const duct_path *path, const duct_subpath *subpath,
                          double tolerance)
{
    points->count = 0;
    const double *p = path->points + 2 * subpath->point;
    for (size_t v = subpath->verb; v < subpath->verb_end && !points->failed && !points->full; v++) {
        if (path->verbs[v] == DUCT_PATH_CUBIC) {
            double c[8];
            memcpy(c, p - 2, sizeof c);
            duct_flatten_cubic(points, c, tolerance);
        } else if (path->verbs[v] != DUCT_PATH_CLOSE) {
            duct_points_add(points, p[0], p[1]);
        }
        p += 2 * points_of(path->verbs[v]);
    }
    if (subpath->closed && points->count > 1 &&
        coincide(points->x[0], points->y[0], points->x[points->count - 1], points->y[points->count - 1])) {
        points->count--;
    }
}
