/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline/outline_private.h"

#include <math.h>

/* From the samples' nibs to those that the outline is made of. Pens report fast strokes sparsely: there a
 * smooth curve is laid through the samples, lest the outline shows the chords. Slow strokes are reported more
 * densely than an outline needs: there nibs are left out. */

enum { MAX_INSERTED = 64, CHUNK = 256, DIRECTIONS = 8 };

static const double pi = 3.14159265358979323846;
static const double corner = 0.96; /* radians, 55 degrees: a sharper turn is a corner and stays one */
static const double flattened = 2; /* tolerances: how far a flattened line's arc may rise above its chord */

static bool append(const duct_allocator *allocator, duct_nib_list *list, const duct_nib *nib)
{
    void *items = list->items;
    if (!duct_reserve(allocator, &items, &list->capacity, list->count + 1, sizeof(duct_nib))) {
        return false;
    }
    list->items = items;
    list->items[list->count++] = *nib;
    return true;
}

typedef struct {
    double x, y;
} vector;

/* The direction of the curve at a sample (its length is 1) as seen from one of its two chords: that of the
 * parabola through it and its neighbours, or the chord's own at a corner. `turn` is the angle by which the
 * chords differ. */
static vector direction_at(const duct_nib *before, const duct_nib *at, const duct_nib *after, bool incoming,
                           double *turn)
{
    double ax = at->x - before->x, ay = at->y - before->y, bx = after->x - at->x, by = after->y - at->y;
    double a = hypot(ax, ay), b = hypot(bx, by);
    vector own = incoming ? (vector){ax, ay} : (vector){bx, by};
    double own_length = incoming ? a : b;
    *turn = 0;
    if (own_length <= 0) {
        return (vector){0, 0};
    }
    if (a > 0 && b > 0) {
        *turn = fabs(atan2(ax * by - ay * bx, ax * bx + ay * by));
        if (*turn < corner) {
            double x = ax / a * b / a + bx / b * a / b, y = ay / a * b / a + by / b * a / b;
            /* Weighted by the other chord's length over its own: the nearer neighbour counts for more. */
            double norm = hypot(x, y);
            return (vector){x / norm, y / norm};
        }
        *turn = 0;
    }
    return (vector){own.x / own_length, own.y / own_length};
}

static size_t pieces_for(double excess)
{
    return (size_t)ceil(fmin(sqrt(fmax(excess, 0)), MAX_INSERTED));
}

/* Adds nibs between around[1] and around[2] where what is swept there leaves the hull of these two: on a
 * curve that leaves its chord by no more than `boldest`, and where the nib turns on its way. */
static bool insert_between(const duct_allocator *allocator, duct_nib_list *list,
                           const duct_nib *const around[4], double boldest, double tolerance)
{
    const duct_nib *from = around[1], *to = around[2];
    double length = hypot(to->x - from->x, to->y - from->y);
    double turn0, turn1;
    vector d0 = direction_at(around[0], from, to, false, &turn0);
    vector d1 = direction_at(from, to, around[3], true, &turn1);
    double bulge = length * (turn0 + turn1) / 16;
    if (bulge > boldest) {
        bulge = 0;
        d0 = d1 = (vector){(to->x - from->x) / length, (to->y - from->y) / length};
    }
    double twist = fabs(to->angle - from->angle);
    /* The ellipse's reach bends as (major^2 - minor^2) / minor over the angle where it bends most. */
    double flat = fmax(from->major - from->minor, to->major - to->minor);
    double rise = twist * twist * flat * (1 + fmax(from->major / from->minor, to->major / to->minor)) / 8;
    size_t pieces = pieces_for(bulge / tolerance), more = pieces_for(rise / tolerance);
    pieces = pieces > more ? pieces : more;
    for (size_t k = 1; k < pieces; k++) {
        double t = (double)k / (double)pieces, u = 1 - t;
        /* Hermite's cubic. */
        double h0 = u * u * (1 + 2 * t), h1 = t * t * (1 + 2 * u), g0 = length * u * u * t,
               g1 = -length * u * t * t;
        duct_nib nib = duct_nib_between(from, to, t, h0 * from->x + h1 * to->x + g0 * d0.x + g1 * d1.x,
                                        h0 * from->y + h1 * to->y + g0 * d0.y + g1 * d1.y);
        if (!append(allocator, list, &nib)) {
            return false;
        }
    }
    return true;
}

/* All samples' nibs with those between them; a closed stroke's first one again at its end. */
static bool fill_in(const duct_allocator *allocator, const duct_nib *nibs, size_t count, bool closed,
                    bool pen, double tolerance, duct_nib_list *list)
{
    double boldest = pen ? INFINITY : flattened * tolerance;
    size_t chords = closed ? count : count - 1;
    for (size_t i = 0; i < chords; i++) {
        size_t next = (i + 1) % count;
        /* Beyond an open end the chord goes on straight: there is no turn. */
        const duct_nib *around[4] = {&nibs[i > 0    ? i - 1
                                           : closed ? count - 1
                                                    : 0],
                                     &nibs[i], &nibs[next],
                                     &nibs[closed          ? (i + 2) % count
                                           : i + 2 < count ? i + 2
                                                           : i + 1]};
        duct_nib end = nibs[next];
        end.angle -= pi * floor((end.angle - nibs[i].angle) / pi + 0.5);
        around[2] = &end;
        if (!append(allocator, list, &nibs[i]) ||
            !insert_between(allocator, list, around, boldest, DUCT_SHARE_SWEEP * tolerance)) {
            return false;
        }
    }
    return append(allocator, list, &nibs[closed ? 0 : count - 1]);
}

static void measure_nib(const duct_nib *nib, double reach[DIRECTIONS])
{
    for (int k = 0; k < DIRECTIONS; k++) {
        double angle = pi * k / DIRECTIONS;
        reach[k] = duct_nib_support(nib, (duct_normal){cos(angle), sin(angle)});
    }
}

/* How much is lost or gained where the nib is left out between two others. */
static double deviation(const duct_nib *nibs, double (*reach)[DIRECTIONS], size_t a, size_t b, size_t i)
{
    double dx = nibs[b].x - nibs[a].x, dy = nibs[b].y - nibs[a].y;
    double px = nibs[i].x - nibs[a].x, py = nibs[i].y - nibs[a].y;
    double square = dx * dx + dy * dy;
    double t = square > 0 ? (px * dx + py * dy) / square : 0.5;
    t = fmin(fmax(t, 0), 1);
    double apart = hypot(px - t * dx, py - t * dy), change = 0;
    for (int k = 0; k < DIRECTIONS; k++) {
        change = fmax(change, fabs(reach[i][k] - reach[a][k] - t * (reach[b][k] - reach[a][k])));
    }
    return apart + change;
}

/* Marks which nibs of a..b are kept: the farthest off, and so on on both sides of it (Douglas and Peucker).
 */
static void thin_chunk(const duct_nib *nibs, double (*reach)[DIRECTIONS], size_t count, double tolerance,
                       bool *keep)
{
    size_t stack[CHUNK + 1], depth = 0;
    keep[0] = keep[count - 1] = true;
    stack[depth++] = count - 1;
    for (size_t a = 0; depth > 0;) {
        size_t b = stack[depth - 1], worst = 0;
        double most = tolerance;
        for (size_t i = a + 1; i < b; i++) {
            double off = deviation(nibs, reach, a, b, i);
            if (off > most) {
                most = off;
                worst = i;
            }
        }
        if (worst > 0) {
            keep[worst] = true;
            stack[depth++] = worst;
        } else {
            a = b;
            depth--;
        }
    }
}

/* Leaves nibs out, in chunks so that a million of them take no quadratic time. */
static void thin(duct_nib_list *list, double tolerance)
{
    double reach[CHUNK][DIRECTIONS];
    size_t kept = 0;
    for (size_t begin = 0; begin + 1 < list->count; begin += CHUNK - 1) {
        size_t count = list->count - begin < CHUNK ? list->count - begin : CHUNK;
        bool keep[CHUNK] = {false};
        for (size_t i = 0; i < count; i++) {
            measure_nib(&list->items[begin + i], reach[i]);
        }
        thin_chunk(list->items + begin, reach, count, tolerance, keep);
        for (size_t i = begin > 0 ? 1 : 0; i < count; i++) {
            if (keep[i]) {
                list->items[kept++] = list->items[begin + i];
            }
        }
    }
    list->count = list->count > 1 ? kept : list->count;
}

bool duct_sweep_nibs(const duct_allocator *allocator, const duct_stroke *stroke,
                     const duct_nib_options *options, duct_nib_list *nibs)
{
    size_t count = duct_stroke_size(stroke);
    duct_nib *all = duct_alloc(allocator, count, sizeof *all);
    if (all == NULL) {
        return false;
    }
    duct_nibs_of(stroke, options, all);
    bool closed = duct_stroke_closed(stroke) && count > 2, pen = duct_stroke_values(stroke, DUCT_T) != NULL;
    bool ok = fill_in(allocator, all, count, closed, pen, options->fit_tolerance, nibs);
    duct_release(allocator, all);
    if (ok) {
        thin(nibs, DUCT_SHARE_SWEEP * options->fit_tolerance);
    }
    return ok;
}
