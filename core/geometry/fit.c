/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/fit.h"

#include "base/memory.h"
#include "geometry/fit_private.h"

#include <math.h>

/* From points to a path: corners divide the points into runs, a straight run becomes a line, and any other is
 * covered by cubics from its beginning to its end, each as long as the tolerance allows. Its length is found
 * by doubling and bisection, which gives fewer nodes than dividing at the worst sample does: samples of a
 * path of n cubics give about n cubics. No recursion; a run of n points takes O(n log n). */

static const double largest = 1e60; /* beyond it squares of squares overflow */

static bool usable(double x, double y)
{
    return fabs(x) <= largest && fabs(y) <= largest; /* false for NaN */
}

/* Copies the points, less those within `apart` of the one before. */
static void copy_points(const double *x, const double *y, size_t count, double apart, duct_fit_points *points)
{
    size_t kept = 0, last = 0;
    for (size_t i = 0; i < count; i++) {
        if (!usable(x[i], y[i])) {
            continue;
        }
        last = i;
        if (kept == 0 || duct_length(x[i] - points->x[kept - 1], y[i] - points->y[kept - 1]) > apart) {
            points->x[kept] = x[i];
            points->y[kept++] = y[i];
        }
    }
    /* An open curve ends exactly where its points do. */
    if (kept > 1 && !points->closed) {
        points->x[kept - 1] = x[last];
        points->y[kept - 1] = y[last];
    }
    while (points->closed && kept > 1 &&
           duct_length(points->x[kept - 1] - points->x[0], points->y[kept - 1] - points->y[0]) <= apart) {
        kept--;
    }
    points->count = kept;
}

static void measure(duct_fit_points *points)
{
    points->s[0] = 0;
    for (size_t i = 1; i < points->count; i++) {
        points->s[i] =
            points->s[i - 1] + duct_length(points->x[i] - points->x[i - 1], points->y[i] - points->y[i - 1]);
    }
}

/* Repeats a closed curve's first point at its end. */
static void append_first(duct_fit_points *points)
{
    points->x[points->count] = points->x[0];
    points->y[points->count] = points->y[0];
    points->count++;
}

static void reverse(double *values, size_t begin, size_t end)
{
    for (; begin + 1 < end; begin++) {
        double swapped = values[--end];
        values[end] = values[begin];
        values[begin] = swapped;
    }
}

/* Makes point `first` of a closed curve the first one. */
static void rotate(duct_fit_points *points, size_t first)
{
    size_t count = points->count - 1;
    double *arrays[2] = {points->x, points->y};
    for (size_t k = 0; k < 2; k++) {
        reverse(arrays[k], 0, first);
        reverse(arrays[k], first, count);
        reverse(arrays[k], 0, count);
    }
    points->count = count;
    append_first(points);
    measure(points);
}

/* The angle by which the polyline turns at a point, 0 at corners and ends. */
static double turn_at(const duct_fit_points *points, size_t i, bool corner)
{
    size_t last = points->count - 1;
    if (corner || (!points->closed && (i == 0 || i == last))) {
        return 0;
    }
    size_t before = i > 0 ? i - 1 : last - 1, after = i < last ? i + 1 : 1;
    double ax = points->x[i] - points->x[before], ay = points->y[i] - points->y[before];
    double bx = points->x[after] - points->x[i], by = points->y[after] - points->y[i];
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by));
}

/* An arc over the chord d that turns by an angle at its ends rises by about d angle / 8; twice that is
 * allowed. An edge far longer than those beside it is no such chord but straight. */
static void measure_sags(duct_fit_points *points, const size_t *corners, size_t corner_count)
{
    const double *s = points->s;
    size_t next = 0, last = points->count - 1;
    double turn_before = 0;
    for (size_t i = 0; i <= last; i++) {
        bool corner = next < corner_count && corners[next] == i;
        next += corner;
        corner = corner || (points->closed && i == last && corner_count > 0 && corners[0] == 0);
        double turn = turn_at(points, i, corner);
        if (i > 0) {
            double chord = s[i] - s[i - 1];
            double before = i > 1 ? s[i - 1] - s[i - 2] : points->closed ? s[last] - s[last - 1] : chord;
            double after = i < last ? s[i + 1] - s[i] : points->closed ? s[1] : chord;
            points->sag[i - 1] = fmin(chord, 2 * fmin(before, after)) * (turn + turn_before) / 16;
        }
        turn_before = turn;
    }
    points->sag[last] = 0;
}

static bool straight(const duct_fit_points *points, size_t first, size_t last)
{
    double ax = points->x[first], ay = points->y[first];
    double dx = points->x[last] - ax, dy = points->y[last] - ay, square = dx * dx + dy * dy;
    double limit = points->tolerance * points->tolerance;
    for (size_t i = first + 1; i < last; i++) {
        double px = points->x[i] - ax, py = points->y[i] - ay;
        double t = square > 0 ? fmin(fmax((px * dx + py * dy) / square, 0), 1) : 0;
        double ex = px - t * dx, ey = py - t * dy;
        if (ex * ex + ey * ey > limit) {
            return false;
        }
    }
    return true;
}

/* True where the curve is a line to the eye: its control points lie on the chord, in order. */
static bool flat(const duct_cubic *cubic, double tolerance)
{
    const duct_vector *p = cubic->p;
    double dx = p[3].x - p[0].x, dy = p[3].y - p[0].y, length = duct_length(dx, dy);
    if (length <= 0) {
        return false;
    }
    double begin = 0;
    for (size_t i = 1; i <= 2; i++) {
        double x = p[i].x - p[0].x, y = p[i].y - p[0].y;
        double t = (x * dx + y * dy) / length;
        if (t < begin || t > length ||
            fabs(x * dy - y * dx) > fmin(0.05 * tolerance, 0.002 * length) * length) {
            return false;
        }
        begin = t;
    }
    return true;
}

/* A piece of a run: the cubic from one point to a later one. */
typedef struct {
    size_t first, last;
    duct_cubic cubic;
} piece;

typedef struct {
    const duct_fit_points *points;
    double *u;
    size_t first, last; /* the run */
    bool free_first, free_last;
    piece *pieces;
    size_t piece_count, piece_capacity;
} run;

static duct_fit_end start_of(const run *r, size_t index)
{
    bool end = r->free_first && index == r->first;
    return (duct_fit_end){duct_fit_tangent(r->points, index, end ? 1 : 0), end};
}

static duct_fit_end end_of(const run *r, size_t index)
{
    bool end = r->free_last && index == r->last;
    duct_vector direction = duct_fit_tangent(r->points, index, end ? -1 : 0);
    return (duct_fit_end){{-direction.x, -direction.y}, end};
}

static bool try_piece(const run *r, size_t first, size_t last, piece *found)
{
    duct_cubic cubic;
    if (!duct_fit_cubic(r->points, first, last, start_of(r, first), end_of(r, last), r->u, &cubic)) {
        return false;
    }
    *found = (piece){first, last, cubic};
    return true;
}

/* The longest piece from `first` on, found by doubling from a guess and bisection. */
static piece longest_piece(const run *r, size_t first, size_t guess)
{
    size_t good = first + 1, bad = r->last + 1;
    piece found;
    size_t last = guess < r->last - first ? first + guess : r->last;
    while (last > good && last < bad) {
        if (try_piece(r, first, last, &found)) {
            good = last;
            size_t step = 2 * (good - first);
            last = step < r->last - first ? first + step : r->last;
        } else {
            bad = last;
            last = good > first + 1 ? good : first + (last - first) / 2;
        }
    }
    while (bad - good > 1 + (good - first) / 16) {
        size_t middle = good + (bad - good) / 2;
        if (try_piece(r, first, middle, &found)) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    if (good == first + 1 && !try_piece(r, first, good, &found)) {
        found = (piece){first, good, duct_fit_straight(r->points, first, good)};
    }
    return found;
}

/* The last piece is what was left over: where it is short, the last two share their stretch evenly. */
static void balance(run *r)
{
    if (r->piece_count < 2) {
        return;
    }
    piece *before = &r->pieces[r->piece_count - 2], *last = before + 1;
    const double *s = r->points->s;
    double begin = s[before->first], end = s[last->last];
    if (end - s[last->first] > 0.7 * (s[before->last] - begin)) {
        return;
    }
    size_t middle = before->last;
    while (middle > before->first + 1 && s[middle] > 0.5 * (begin + end)) {
        middle--;
    }
    piece one, two;
    if (try_piece(r, before->first, middle, &one) && try_piece(r, middle, last->last, &two)) {
        *before = one;
        *last = two;
    }
}

static bool fit_run(run *r, const duct_allocator *allocator)
{
    r->piece_count = 0;
    size_t guess = 16;
    for (size_t first = r->first; first < r->last;) {
        void *pieces = r->pieces;
        if (!duct_reserve(allocator, &pieces, &r->piece_capacity, r->piece_count + 1, sizeof(piece))) {
            return false;
        }
        r->pieces = pieces;
        piece found = longest_piece(r, first, guess);
        r->pieces[r->piece_count++] = found;
        guess = found.last - found.first;
        first = found.last;
    }
    balance(r);
    return true;
}

static void line_to(const duct_fit_points *points, size_t index, duct_path *path)
{
    /* The line that ends a closed curve is drawn by closing it. */
    if (!points->closed || index + 1 < points->count) {
        duct_path_line(path, points->x[index], points->y[index]);
    }
}

static void emit_run(const run *r, duct_path *path)
{
    for (size_t i = 0; i < r->piece_count; i++) {
        const duct_vector *p = r->pieces[i].cubic.p;
        if (flat(&r->pieces[i].cubic, r->points->tolerance)) {
            line_to(r->points, r->pieces[i].last, path);
        } else {
            duct_path_cubic(path, p[1].x, p[1].y, p[2].x, p[2].y, p[3].x, p[3].y);
        }
    }
}

/* Fits all runs between the corners. */
static void fit_points(const duct_fit_points *points, const size_t *corners, size_t corner_count, double *u,
                       duct_path *path)
{
    size_t last = points->count - 1, next = 0;
    bool smooth = points->closed && corner_count == 0; /* no corner at the seam either */
    run r = {.points = points, .u = u};
    duct_path_move(path, points->x[0], points->y[0]);
    if (corner_count > 0 && corners[0] == 0) {
        next = 1;
    }
    while (r.last < last && !path->failed) {
        r.first = r.last;
        r.last = next < corner_count ? corners[next++] : last;
        r.free_first = r.first > 0 || !smooth;
        r.free_last = r.last < last || !smooth;
        if (!smooth && straight(points, r.first, r.last)) {
            line_to(points, r.last, path);
        } else if (fit_run(&r, path->allocator)) {
            emit_run(&r, path);
        } else {
            path->failed = true;
        }
    }
    duct_release(path->allocator, r.pieces);
    if (points->closed) {
        duct_path_close(path);
    }
}

/* One or two points, or all in one place. */
static void fit_few(const duct_fit_points *points, duct_path *path)
{
    duct_path_move(path, points->x[0], points->y[0]);
    if (points->count > 1 || !points->closed) {
        duct_path_line(path, points->x[points->count - 1], points->y[points->count - 1]);
    }
    if (points->closed) {
        duct_path_close(path);
    }
}

/* The tolerance, kept from being so small that rounding decides. */
static double usable_tolerance(const double *x, const double *y, size_t count, double tolerance)
{
    double extent = 0;
    for (size_t i = 0; i < count; i++) {
        if (usable(x[i], y[i])) {
            extent = fmax(extent, fmax(fabs(x[i]), fabs(y[i])));
        }
    }
    double least = fmax(extent * 1e-10, 1e-60);
    return tolerance > least ? fmin(tolerance, largest) : least; /* least for NaN too */
}

/* How far apart points are kept. Where samples crowd, their noise would drown the curve's direction. */
static double spacing(const double *x, const double *y, size_t count, double tolerance)
{
    double length = 0;
    for (size_t i = 1; i < count; i++) {
        if (usable(x[i], y[i]) && usable(x[i - 1], y[i - 1])) {
            length += duct_length(x[i] - x[i - 1], y[i] - y[i - 1]);
        }
    }
    return (length < 0.2 * tolerance * (double)count ? 0.25 : 1e-3) * tolerance;
}

void duct_fit_curve(const double *x, const double *y, size_t count, bool closed, double tolerance,
                    duct_path *path)
{
    if (path->failed || count == 0) {
        return;
    }
    tolerance = usable_tolerance(x, y, count, tolerance);
    size_t room = count + 1;
    double *values = room <= (size_t)-1 / 5 ? duct_alloc(path->allocator, 5 * room, sizeof *values) : NULL;
    size_t *corners = duct_alloc(path->allocator, room, sizeof *corners);
    if (values == NULL || corners == NULL) {
        duct_release(path->allocator, values);
        duct_release(path->allocator, corners);
        path->failed = true;
        return;
    }
    double apart = spacing(x, y, count, tolerance);
    duct_fit_points points = {values, values + room, values + 2 * room, values + 3 * room,
                              0,      closed,        tolerance - apart};
    copy_points(x, y, count, apart, &points);
    if (points.count > 0 && points.count < 3) {
        fit_few(&points, path);
    } else if (points.count > 0) {
        if (closed) {
            append_first(&points);
        }
        measure(&points);
        size_t sharpest;
        size_t corner_count = duct_fit_corners(&points, corners, &sharpest);
        if (closed) {
            size_t first = corner_count > 0 ? corners[0] : sharpest;
            rotate(&points, first);
            for (size_t i = 0; i < corner_count; i++) {
                corners[i] -= first;
            }
        }
        measure_sags(&points, corners, corner_count);
        fit_points(&points, corners, corner_count, values + 4 * room, path);
    }
    duct_release(path->allocator, values);
    duct_release(path->allocator, corners);
}
