/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/fit_private.h"

#include <math.h>

/* One cubic Bezier curve through the two ends of a stretch of samples, near those between: least squares for
 * the two inner control points, in turn with Newton steps for the samples' parameters (Schneider, "An
 * algorithm for automatically fitting digitized curves", Graphics Gems 1990).
 *
 * Deviations from Schneider. After the first round, distances along the curve count little against those
 * across it (tangent distance minimisation, a Gauss-Newton method: Wang, Pottmann and Liu, "Fitting B-spline
 * curves to point clouds by curvature-based squared distance minimization", 2006): some rounds then do what
 * takes Schneider's hundreds, and a stretch of one cubic is found to be one. And an end that is a corner has
 * no prescribed direction: its control point is free in the plane. */

enum { SUBSET = 48, MAX_ITERATIONS = 14 };

/* Positions and parameters of the samples that take part in the least squares: all, or SUBSET of them. */
typedef struct {
    double x[SUBSET], y[SUBSET], u[SUBSET];
    duct_vector along[SUBSET]; /* unit vector along the curve */
    size_t index[SUBSET];
    size_t count;
} subset;

static duct_vector evaluate(const duct_cubic *c, double u)
{
    double v = 1 - u;
    double b0 = v * v * v, b1 = 3 * v * v * u, b2 = 3 * v * u * u, b3 = u * u * u;
    return (duct_vector){b0 * c->p[0].x + b1 * c->p[1].x + b2 * c->p[2].x + b3 * c->p[3].x,
                         b0 * c->p[0].y + b1 * c->p[1].y + b2 * c->p[2].y + b3 * c->p[3].y};
}

/* The curve as a polynomial, for many evaluations. */
typedef struct {
    duct_vector a, b, c, d; /* ((a u + b) u + c) u + d */
} polynomial;

static polynomial polynomial_of(const duct_cubic *q)
{
    const duct_vector *p = q->p;
    return (polynomial){{p[3].x - p[0].x + 3 * (p[1].x - p[2].x), p[3].y - p[0].y + 3 * (p[1].y - p[2].y)},
                        {3 * (p[0].x - 2 * p[1].x + p[2].x), 3 * (p[0].y - 2 * p[1].y + p[2].y)},
                        {3 * (p[1].x - p[0].x), 3 * (p[1].y - p[0].y)},
                        p[0]};
}

/* One Newton step towards the parameter of the curve's point nearest to (x, y), and the squared distance from
 * the curve's point at the new parameter. */
static double approach(const polynomial *q, double x, double y, double *u)
{
    double t = *u;
    double ex = ((q->a.x * t + q->b.x) * t + q->c.x) * t + q->d.x - x;
    double ey = ((q->a.y * t + q->b.y) * t + q->c.y) * t + q->d.y - y;
    double dx = (3 * q->a.x * t + 2 * q->b.x) * t + q->c.x, dy = (3 * q->a.y * t + 2 * q->b.y) * t + q->c.y;
    double ddx = 6 * q->a.x * t + 2 * q->b.x, ddy = 6 * q->a.y * t + 2 * q->b.y;
    double slope = dx * ex + dy * ey, bend = dx * dx + dy * dy + ddx * ex + ddy * ey;
    double before = ex * ex + ey * ey;
    if (bend <= 0) {
        return before;
    }
    t -= slope / bend;
    t = t > 0 ? t < 1 ? t : 1 : 0;
    ex = ((q->a.x * t + q->b.x) * t + q->c.x) * t + q->d.x - x;
    ey = ((q->a.y * t + q->b.y) * t + q->c.y) * t + q->d.y - y;
    double after = ex * ex + ey * ey;
    if (after < before) {
        *u = t;
        return after;
    }
    return before;
}

static duct_vector along(duct_vector from, duct_vector direction, double length)
{
    return (duct_vector){from.x + direction.x * length, from.y + direction.y * length};
}

static double dot(duct_vector a, duct_vector b)
{
    return a.x * b.x + a.y * b.y;
}

duct_cubic duct_fit_straight(const duct_fit_points *points, size_t first, size_t last)
{
    duct_vector a = {points->x[first], points->y[first]}, b = {points->x[last], points->y[last]};
    duct_vector chord = {b.x - a.x, b.y - a.y};
    return (duct_cubic){{a, along(a, chord, 1. / 3), along(b, chord, -1. / 3), b}};
}

/* The normal equations for the two arms (inner control point less end) in the plane: unknowns x1, y1, x2, y2.
 */
typedef struct {
    double m[4][4], r[4];
} normal_equations;

/* `tangential` is the weight of distances along the curve. */
static normal_equations equations_of(const subset *set, duct_vector first, duct_vector last,
                                     double tangential)
{
    normal_equations sums = {0};
    for (size_t i = 1; i + 1 < set->count; i++) {
        double u = set->u[i], v = 1 - u;
        double b1 = 3 * v * v * u, b2 = 3 * v * u * u;
        double ends0 = v * v * v + b1, ends3 = b2 + u * u * u;
        double x = set->x[i] - ends0 * first.x - ends3 * last.x,
               y = set->y[i] - ends0 * first.y - ends3 * last.y;
        duct_vector t = set->along[i];
        double wxx = t.y * t.y + tangential * t.x * t.x, wyy = t.x * t.x + tangential * t.y * t.y;
        double wxy = (tangential - 1) * t.x * t.y;
        double b11 = b1 * b1, b12 = b1 * b2, b22 = b2 * b2;
        sums.m[0][0] += b11 * wxx;
        sums.m[0][1] += b11 * wxy;
        sums.m[1][1] += b11 * wyy;
        sums.m[0][2] += b12 * wxx;
        sums.m[0][3] += b12 * wxy;
        sums.m[1][3] += b12 * wyy;
        sums.m[2][2] += b22 * wxx;
        sums.m[2][3] += b22 * wxy;
        sums.m[3][3] += b22 * wyy;
        double rx = wxx * x + wxy * y, ry = wxy * x + wyy * y;
        sums.r[0] += b1 * rx;
        sums.r[1] += b1 * ry;
        sums.r[2] += b2 * rx;
        sums.r[3] += b2 * ry;
    }
    sums.m[1][2] = sums.m[0][3];
    for (size_t i = 1; i < 4; i++) {
        for (size_t k = 0; k < i; k++) {
            sums.m[i][k] = sums.m[k][i];
        }
    }
    return sums;
}

/* Solves the symmetric positive definite system in place (Cholesky); false where it is singular. */
static bool solve_small(double m[4][4], double r[4], size_t n)
{
    for (size_t i = 0; i < n; i++) {
        double scale = m[i][i];
        for (size_t j = 0; j <= i; j++) {
            double sum = m[i][j];
            for (size_t k = 0; k < j; k++) {
                sum -= m[i][k] * m[j][k];
            }
            if (j < i) {
                m[i][j] = sum / m[j][j];
            } else if (sum > 1e-9 * scale) {
                m[i][i] = sqrt(sum);
            } else {
                return false;
            }
        }
    }
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < i; k++) {
            r[i] -= m[i][k] * r[k];
        }
        r[i] /= m[i][i];
    }
    for (size_t i = n; i-- > 0;) {
        for (size_t k = i + 1; k < n; k++) {
            r[i] -= m[k][i] * r[k];
        }
        r[i] /= m[i][i];
    }
    return true;
}

/* The arms of least squares, each free in the plane or along its end's direction. False where the samples do
 * not determine them. */
static bool solve(const normal_equations *full, duct_fit_end start, duct_fit_end end, duct_vector *arm1,
                  duct_vector *arm2)
{
    /* Columns: how each unknown moves the arms. */
    double column[4][4] = {{0}};
    size_t n = 0;
    const duct_fit_end ends[2] = {start, end};
    for (size_t k = 0; k < 2; k++) {
        if (ends[k].free) {
            column[n++][2 * k] = 1;
            column[n++][2 * k + 1] = 1;
        } else {
            column[n][2 * k] = ends[k].direction.x;
            column[n++][2 * k + 1] = ends[k].direction.y;
        }
    }
    double m[4][4] = {{0}}, r[4] = {0};
    for (size_t i = 0; i < n; i++) {
        for (size_t a = 0; a < 4; a++) {
            r[i] += column[i][a] * full->r[a];
            for (size_t j = 0; j < n; j++) {
                for (size_t b = 0; b < 4; b++) {
                    m[i][j] += column[i][a] * full->m[a][b] * column[j][b];
                }
            }
        }
    }
    if (!solve_small(m, r, n)) {
        return false;
    }
    double arms[4] = {0};
    for (size_t i = 0; i < n; i++) {
        for (size_t a = 0; a < 4; a++) {
            arms[a] += column[i][a] * r[i];
        }
    }
    *arm1 = (duct_vector){arms[0], arms[1]};
    *arm2 = (duct_vector){arms[2], arms[3]};
    return true;
}

/* True where the arm points about where the end's direction does and is neither negligible nor wildly long.
 */
static bool sane(duct_vector arm, duct_vector direction, double length)
{
    double norm = duct_length(arm.x, arm.y);
    return norm >= 1e-3 * length && norm <= length && dot(arm, direction) >= 0.5 * norm;
}

/* The best cubic for the parameters that the samples have now. */
static duct_cubic solve_cubic(const subset *set, duct_fit_end start, duct_fit_end end, double length,
                              double tangential)
{
    duct_vector first = {set->x[0], set->y[0]};
    duct_vector last = {set->x[set->count - 1], set->y[set->count - 1]};
    normal_equations sums = equations_of(set, first, last, tangential);
    duct_vector arm1, arm2;
    bool ok = solve(&sums, start, end, &arm1, &arm2);
    if (ok && (start.free || end.free)) {
        bool sane1 = sane(arm1, start.direction, length), sane2 = sane(arm2, end.direction, length);
        if (!sane1 || !sane2) {
            start.free = start.free && sane1;
            end.free = end.free && sane2;
            ok = solve(&sums, start, end, &arm1, &arm2);
        }
    }
    if (!ok || !sane(arm1, start.direction, length) || !sane(arm2, end.direction, length)) {
        arm1 = along((duct_vector){0, 0}, start.direction, length / 3);
        arm2 = along((duct_vector){0, 0}, end.direction, length / 3);
    }
    return (duct_cubic){{first, along(first, arm1, 1), along(last, arm2, 1), last}};
}

/* Picks the samples for the least squares: evenly by a mean of number and arc length, so that neither crowded
 * nor empty stretches rule the fit. Parameters begin as arc length. */
static void choose_subset(const duct_fit_points *points, size_t first, size_t last, subset *set)
{
    size_t count = last - first + 1;
    double begin = points->s[first], length = points->s[last] - begin;
    set->count = 0;
    for (size_t i = first; i <= last; i++) {
        if (count > SUBSET && i != last) {
            double share =
                0.5 * ((double)(i - first) / (double)(count - 1) + (points->s[i] - begin) / length);
            if (set->count >= SUBSET - 1 || share < (double)set->count / (SUBSET - 1)) {
                continue;
            }
        }
        set->index[set->count] = i;
        /* Any unit vector: the first round weighs all directions alike. */
        set->along[set->count] = (duct_vector){1, 0};
        set->x[set->count] = points->x[i];
        set->y[set->count] = points->y[i];
        set->u[set->count++] = (points->s[i] - begin) / length;
    }
}

/* Moves the parameters towards the nearest points; returns the largest squared distance. */
static double reparameterise(const duct_cubic *cubic, subset *set)
{
    polynomial q = polynomial_of(cubic);
    double worst = 0;
    for (size_t i = 1; i + 1 < set->count; i++) {
        double distance = approach(&q, set->x[i], set->y[i], &set->u[i]);
        double u = set->u[i] > set->u[i - 1] ? set->u[i] : set->u[i - 1];
        set->u[i] = u;
        double dx = (3 * q.a.x * u + 2 * q.b.x) * u + q.c.x, dy = (3 * q.a.y * u + 2 * q.b.y) * u + q.c.y;
        double norm = sqrt(dx * dx + dy * dy);
        set->along[i] = norm > 0 ? (duct_vector){dx / norm, dy / norm} : (duct_vector){0, 0};
        worst = distance > worst ? distance : worst;
    }
    return worst;
}

/* Checks every sample of the stretch, and that the curve does not leave the polyline between samples. */
static bool verify(const duct_fit_points *points, const duct_cubic *cubic, const subset *set, double *u)
{
    polynomial q = polynomial_of(cubic);
    double limit = points->tolerance * points->tolerance;
    for (size_t k = 0; k + 1 < set->count; k++) {
        size_t a = set->index[k], b = set->index[k + 1];
        u[a] = set->u[k];
        for (size_t i = a + 1; i < b; i++) {
            double share = (points->s[i] - points->s[a]) / (points->s[b] - points->s[a]);
            u[i] = set->u[k] + share * (set->u[k + 1] - set->u[k]);
            double distance = approach(&q, points->x[i], points->y[i], &u[i]);
            if (distance > limit) {
                distance = approach(&q, points->x[i], points->y[i], &u[i]);
            }
            if (distance > limit) {
                return false;
            }
        }
    }
    u[set->index[set->count - 1]] = 1;
    for (size_t i = set->index[0]; i < set->index[set->count - 1]; i++) {
        double step = points->s[i + 1] - points->s[i];
        if (step <= points->tolerance) {
            continue;
        }
        duct_vector middle = evaluate(cubic, 0.5 * (u[i] + u[i + 1]));
        double dx = points->x[i + 1] - points->x[i], dy = points->y[i + 1] - points->y[i];
        double across = (dx * (middle.y - points->y[i]) - dy * (middle.x - points->x[i])) / step;
        if (fabs(across) > points->tolerance + points->sag[i]) {
            return false;
        }
    }
    return true;
}

bool duct_fit_cubic(const duct_fit_points *points, size_t first, size_t last, duct_fit_end start,
                    duct_fit_end end, double *u, duct_cubic *cubic)
{
    subset set;
    choose_subset(points, first, last, &set);
    double length = points->s[last] - points->s[first];
    double limit = points->tolerance * points->tolerance;
    if (set.count <= 4) {
        /* Too few samples to choose a direction by. */
        start.free = end.free = false;
    }
    double before = INFINITY, tangential = 1;
    for (int iteration = 0; iteration < MAX_ITERATIONS; iteration++) {
        *cubic = solve_cubic(&set, start, end, length, tangential);
        double worst = reparameterise(cubic, &set);
        if (worst <= limit) {
            return verify(points, cubic, &set, u);
        }
        if (iteration >= 4 && worst > 0.8 * before) {
            return false;
        }
        tangential = worst < before ? fmax(0.1 * tangential, 1e-6) : fmin(100 * tangential, 1);
        before = worst;
    }
    return false;
}
