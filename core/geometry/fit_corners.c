/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/fit_private.h"

#include <math.h>

/* Corners and tangents of sampled curves. Both look at the curve as far as a distance that goes with the
 * tolerance and not from one sample to the next, so that they do not depend on how densely the curve was
 * sampled and are not led astray by noise below the tolerance. The distance is the straight one: noise makes
 * arc length meaningless. */

/* No more samples than these are looked at on a side, so that a million of them in one spot take no quadratic
 * time. */
enum { MAX_WINDOW = 64 };
static const double pi = 3.14159265358979323846;

/* The sample that is `steps` after (side +1) or before (-1) another; a closed curve goes round, an open one
 * stays at its ends. */
static size_t step_from(const duct_fit_points *points, size_t index, int side, size_t steps)
{
    size_t last = points->count - 1;
    if (!points->closed) {
        size_t most = side > 0 ? last - index : index;
        steps = steps < most ? steps : most;
        return side > 0 ? index + steps : index - steps;
    }
    steps %= last;
    index %= last;
    return side > 0 ? (index + steps) % last : (index + last - steps) % last;
}

/* The first sample on a side that is at least `distance` away, or the last one that is looked at. */
static size_t leave(const duct_fit_points *points, size_t index, int side, double distance)
{
    size_t most = points->count / 2 < MAX_WINDOW ? points->count / 2 : MAX_WINDOW;
    size_t found = index;
    for (size_t k = 1; k <= most; k++) {
        found = step_from(points, index, side, k);
        double dx = points->x[found] - points->x[index], dy = points->y[found] - points->y[index];
        if (dx * dx + dy * dy >= distance * distance) {
            break;
        }
    }
    return found;
}

/* The angle 0..pi by which the curve turns at a sample, seen at a distance. */
static double turn(const duct_fit_points *points, size_t i, double distance)
{
    size_t before = leave(points, i, -1, distance), after = leave(points, i, 1, distance);
    double ax = points->x[i] - points->x[before], ay = points->y[i] - points->y[before];
    double bx = points->x[after] - points->x[i], by = points->y[after] - points->y[i];
    return atan2(fabs(ax * by - ay * bx), ax * bx + ay * by);
}

/* How surely point i is a corner, 0 where it is none: a smooth bend turns less the closer one looks; a corner
 * does not. */
static double corner_strength(const duct_fit_points *points, size_t i, double width, double near_turn)
{
    size_t last = points->count - 1;
    double s = points->s[i];
    double step_before = i > 0 ? s - points->s[i - 1] : points->s[last] - points->s[last - 1];
    double step_after = points->s[i + 1] - s;
    /* Single long edges tell less than many short ones: a coarsely sampled arc turns by much at every sample.
     */
    double least = (step_before > width || step_after > width ? 55 : 40) * pi / 180;
    if (near_turn < least) {
        return 0;
    }
    double far_turn = turn(points, i, 4 * width);
    if (far_turn < least || near_turn < 0.6 * far_turn) {
        return 0;
    }
    /* Around the tip of a narrow wedge many samples see all of its turn: the tip turns by itself. */
    return near_turn + 0.25 * turn(points, i, 0);
}

/* Takes the corner at the seam's other side away where both are one. */
static size_t merge_at_seam(const duct_fit_points *points, size_t *corners, const double kept[2],
                            double width, size_t count)
{
    double gap = points->s[points->count - 1] - points->s[corners[count - 1]] + points->s[corners[0]];
    if (count < 2 || gap >= width) {
        return count;
    }
    if (kept[1] > kept[0]) {
        for (size_t i = 0; i + 1 < count; i++) {
            corners[i] = corners[i + 1];
        }
    }
    return count - 1;
}

size_t duct_fit_corners(const duct_fit_points *points, size_t *corners, size_t *sharpest)
{
    size_t last = points->count - 1, count = 0;
    double width = fmin(2 * points->tolerance, points->s[last] / 16);
    double greatest = -1, kept[2] = {0, 0}; /* of the first and the last corner */
    *sharpest = 0;
    for (size_t i = points->closed ? 0 : 1; i < last; i++) {
        double near_turn = turn(points, i, width);
        if (near_turn > greatest) {
            greatest = near_turn;
            *sharpest = i;
        }
        double strength = corner_strength(points, i, width, near_turn);
        if (strength <= 0) {
            continue;
        }
        /* Among neighbours that see the same corner the surest is it. */
        if (count > 0 && points->s[i] - points->s[corners[count - 1]] < width) {
            if (strength <= kept[1]) {
                continue;
            }
            count--;
        }
        corners[count++] = i;
        kept[1] = strength;
        kept[0] = count == 1 ? strength : kept[0];
    }
    return points->closed && count > 1 ? merge_at_seam(points, corners, kept, width, count) : count;
}

/* Sums of the normal equations of position = b s + c s^2 + d s^3 around a point: powers s^2 .. s^6 and
 * moments. */
typedef struct {
    double power[7], x[4], y[4];
    size_t count;
} tangent_sums;

static void add_side(const duct_fit_points *points, size_t index, int side, double width, size_t least,
                     tangent_sums *sums)
{
    double s = 0, x = points->x[index], y = points->y[index];
    size_t most = points->count / 3 < MAX_WINDOW ? points->count / 3 : MAX_WINDOW;
    for (size_t k = 1, before = index; k <= most || k == 1; k++) {
        size_t i = step_from(points, index, side, k);
        double dx = points->x[i] - x, dy = points->y[i] - y;
        if (i == before || (k > least && dx * dx + dy * dy > width * width)) {
            return;
        }
        s += side * duct_length(points->x[i] - points->x[before], points->y[i] - points->y[before]);
        double power = 1;
        for (size_t n = 0; n <= 6; n++, power *= s) {
            sums->power[n] += power / (s * s);
            if (n >= 1 && n <= 3) {
                /* Points count by their nearness. */
                sums->x[n] += dx * power / (s * s);
                sums->y[n] += dy * power / (s * s);
            }
        }
        sums->count++;
        before = i;
    }
}

/* The first unknown of the symmetric system of `n` equations, by Cramer's rule. */
static bool first_unknown(const tangent_sums *sums, size_t n, duct_vector *b)
{
    const double *p = sums->power, *x = sums->x, *y = sums->y;
    if (n == 1) {
        *b = (duct_vector){x[1], y[1]};
        return true;
    }
    if (n == 2) {
        double det = p[2] * p[4] - p[3] * p[3];
        *b = (duct_vector){(x[1] * p[4] - p[3] * x[2]) / det, (y[1] * p[4] - p[3] * y[2]) / det};
        return det > 1e-9 * p[2] * p[4];
    }
    double m1 = p[4] * p[6] - p[5] * p[5], m2 = p[3] * p[6] - p[4] * p[5], m3 = p[3] * p[5] - p[4] * p[4];
    double det = p[2] * m1 - p[3] * m2 + p[4] * m3;
    *b = (duct_vector){(x[1] * m1 - x[2] * m2 + x[3] * m3) / det, (y[1] * m1 - y[2] * m2 + y[3] * m3) / det};
    return det > 1e-9 * p[2] * p[4] * p[6];
}

duct_vector duct_fit_tangent(const duct_fit_points *points, size_t index, int side)
{
    double width = 3 * points->tolerance;
    tangent_sums sums = {0};
    if (side <= 0) {
        add_side(points, index, -1, width, 2, &sums);
    }
    if (side >= 0) {
        add_side(points, index, 1, width, 2, &sums);
    }
    size_t unknowns = side == 0 && sums.count >= 4 ? 3 : sums.count >= 2 ? 2 : 1;
    duct_vector b = {1, 0};
    while (unknowns > 0 && !first_unknown(&sums, unknowns, &b)) {
        unknowns--;
    }
    double norm = duct_length(b.x, b.y);
    return norm > 0 ? (duct_vector){b.x / norm, b.y / norm} : (duct_vector){1, 0};
}
