/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/neighbourhood.h"

#include <math.h>
#include <string.h>

void duct_neighbourhood_lay(duct_neighbourhood *samples, double *block, int reach, bool extra)
{
    size_t room = 2 * (size_t)reach + 1;
    samples->x = block;
    samples->y = block + room;
    samples->u = block + 2 * room;
    samples->v = block + 3 * room;
    samples->extra = extra ? block + 4 * room : NULL;
}

/* Walks from (x, y), which lies just before control point `next` in walking direction, along the curve, and
 * puts down a sample after `first` and then every `spacing`, as numbers `from`, `from` + step ... `to`.
 * Returns the number of the last one. */
static int walk(const duct_curve *curve, double x, double y, double extra, long next, size_t made, int step,
                double first, double spacing, int from, int to, int reach, duct_neighbourhood *samples)
{
    long count = (long)made;
    double left = first, slack = 1e-9 * spacing;
    int k = from, last = from - step;
    long still = 0;
    while (k != to + step) {
        if (next < 0 || next >= count) {
            if (!curve->closed || made != curve->count) {
                break;
            }
            next = next < 0 ? count - 1 : 0;
        }
        double dx = curve->x[next] - x, dy = curve->y[next] - y, length = sqrt(dx * dx + dy * dy);
        double extra_there = curve->extra != NULL ? curve->extra[next] : 0;
        if (length < left - slack) {
            left -= length;
            x = curve->x[next];
            y = curve->y[next];
            extra = extra_there;
            next += step;
            still = length > 0 ? 0 : still + 1;
            if (still > count) {
                break; /* a closed curve without length */
            }
            continue;
        }
        double share = length > left ? left / length : 1;
        x += share * dx;
        y += share * dy;
        extra += share * (extra_there - extra);
        samples->x[k + reach] = x;
        samples->y[k + reach] = y;
        if (samples->extra != NULL) {
            samples->extra[k + reach] = extra;
        }
        last = k;
        k += step;
        left = spacing;
    }
    return last;
}

/* Makes positions relative to the centre and fills the tangents. */
static void finish(duct_neighbourhood *samples, int reach)
{
    for (int k = samples->low; k <= samples->high; k++) {
        samples->x[k + reach] -= samples->centre[0];
        samples->y[k + reach] -= samples->centre[1];
    }
    for (int k = samples->low; k <= samples->high; k++) {
        int i = k + reach;
        double dx = k > samples->low ? samples->x[i] - samples->x[i - 1] : 0;
        double dy = k > samples->low ? samples->y[i] - samples->y[i - 1] : 0;
        double length = sqrt(dx * dx + dy * dy);
        samples->u[i] = length > 0 ? dx / length : 0;
        samples->v[i] = length > 0 ? dy / length : 0;
    }
}

void duct_neighbourhood_around(const duct_curve *curve, duct_place place, double spacing, int reach,
                               duct_neighbourhood *samples)
{
    double x, y, extra = curve->extra != NULL ? duct_curve_extra(curve, place) : 0;
    duct_curve_point(curve, place, &x, &y);
    samples->centre[0] = samples->x[reach] = x;
    samples->centre[1] = samples->y[reach] = y;
    if (samples->extra != NULL) {
        samples->extra[reach] = extra;
    }
    long at = (long)place.at;
    samples->high =
        walk(curve, x, y, extra, at + 1, curve->count, 1, spacing, spacing, 1, reach, reach, samples);
    samples->low = walk(curve, x, y, extra, place.share > 0 ? at : at - 1, curve->count, -1, spacing, spacing,
                        -1, -reach, reach, samples);
    finish(samples, reach);
}

void duct_neighbourhood_before(const duct_curve *curve, size_t made, double gap, double spacing, int reach,
                               duct_neighbourhood *samples)
{
    samples->low = 1;
    samples->high = 0;
    samples->centre[0] = made > 0 ? curve->x[made - 1] : 0;
    samples->centre[1] = made > 0 ? curve->y[made - 1] : 0;
    int nearest = (int)ceil(gap / spacing - 1e-9);
    nearest = nearest < 1 ? 1 : nearest;
    if (made == 0 || nearest > reach) {
        return;
    }
    double first = spacing * nearest - gap, extra = curve->extra != NULL ? curve->extra[made - 1] : 0;
    first = first < 0 ? 0 : first;
    int last = walk(curve, samples->centre[0], samples->centre[1], extra, (long)made - 1, made, -1, first,
                    spacing, -nearest, -reach, reach, samples);
    samples->high = -nearest;
    samples->low = last;
    finish(samples, reach);
}

void duct_neighbourhood_weights(int neighbourhood, int reach, double *weights)
{
    int n = neighbourhood - 1, middle = n / 2;
    weights[reach] = 1;
    for (int k = 1; k <= reach; k++) {
        /* C(n, middle + k) / C(n, middle), from one to the next; 0 beyond the neighbourhood. */
        double ratio = middle + k <= n ? (double)(n - middle - k + 1) / (double)(middle + k) : 0;
        weights[reach + k] = weights[reach + k - 1] * ratio;
        weights[reach - k] = weights[reach + k];
    }
}

void duct_align(const duct_neighbourhood *a, const duct_neighbourhood *b, int reach, const double *weights,
                double tangent, duct_alignment *sums)
{
    int low = a->low > b->low ? a->low : b->low, high = a->high < b->high ? a->high : b->high;
    double mass = 0, ax = 0, ay = 0, bx = 0, by = 0, squares = 0, re = 0, im = 0;
    double tangent_squares = 0, tangent_re = 0, tangent_im = 0, extra = 0;
    bool both = a->extra != NULL && b->extra != NULL;
    for (int k = low; k <= high; k++) {
        int i = k + reach;
        double w = weights[i], px = a->x[i], py = a->y[i], qx = b->x[i], qy = b->y[i];
        mass += w;
        ax += w * px;
        ay += w * py;
        bx += w * qx;
        by += w * qy;
        squares += w * (px * px + py * py + qx * qx + qy * qy);
        re += w * (px * qx + py * qy);
        im += w * (px * qy - py * qx);
        if (k > low) {
            double pu = a->u[i], pv = a->v[i], qu = b->u[i], qv = b->v[i];
            tangent_squares += w * (pu * pu + pv * pv + qu * qu + qv * qv);
            tangent_re += w * (pu * qu + pv * qv);
            tangent_im += w * (pu * qv - pv * qu);
        }
        if (both) {
            extra += w * (a->extra[i] - b->extra[i]) * (a->extra[i] - b->extra[i]);
        }
    }
    memset(sums, 0, sizeof *sums);
    if (!(mass > 0)) {
        return;
    }
    sums->mass = mass;
    sums->a[0] = ax / mass;
    sums->a[1] = ay / mass;
    sums->b[0] = bx / mass;
    sums->b[1] = by / mass;
    sums->squares = squares - (ax * ax + ay * ay + bx * bx + by * by) / mass + tangent * tangent_squares;
    sums->product[0] = re - (ax * bx + ay * by) / mass + tangent * tangent_re;
    sums->product[1] = im - (ax * by - ay * bx) / mass + tangent * tangent_im;
    sums->extra = extra;
}

void duct_align_prepare(const duct_neighbourhood *samples, int reach, const double *weights, double tangent,
                        duct_full_sums *sums, double *weighted)
{
    size_t room = 2 * (size_t)reach + 1;
    double mass = 0, x = 0, y = 0, squares = 0;
    for (size_t k = 0; k < room; k++) {
        double w = weights[k], turned = k > 0 ? w * tangent : 0;
        mass += w;
        x += w * samples->x[k];
        y += w * samples->y[k];
        squares += w * (samples->x[k] * samples->x[k] + samples->y[k] * samples->y[k]);
        squares += turned * (samples->u[k] * samples->u[k] + samples->v[k] * samples->v[k]);
        if (weighted != NULL) {
            weighted[4 * k] = w * samples->x[k];
            weighted[4 * k + 1] = w * samples->y[k];
            weighted[4 * k + 2] = turned * samples->u[k];
            weighted[4 * k + 3] = turned * samples->v[k];
        }
    }
    *sums = (duct_full_sums){{x / mass, y / mass}, squares - (x * x + y * y) / mass};
}

void duct_align_full(const duct_neighbourhood *a, const duct_full_sums *a_sums, const double *b_weighted,
                     const duct_full_sums *b_sums, int reach, double mass, duct_alignment *sums)
{
    size_t room = 2 * (size_t)reach + 1;
    double re = 0, im = 0, tangent_re = 0, tangent_im = 0;
    for (size_t k = 0; k < room; k++) {
        const double *b = b_weighted + 4 * k;
        re += a->x[k] * b[0] + a->y[k] * b[1];
        im += a->x[k] * b[1] - a->y[k] * b[0];
        tangent_re += a->u[k] * b[2] + a->v[k] * b[3];
        tangent_im += a->u[k] * b[3] - a->v[k] * b[2];
    }
    const double *p = a_sums->mean, *q = b_sums->mean;
    sums->mass = mass;
    sums->a[0] = p[0];
    sums->a[1] = p[1];
    sums->b[0] = q[0];
    sums->b[1] = q[1];
    sums->squares = a_sums->squares + b_sums->squares;
    sums->product[0] = re - mass * (p[0] * q[0] + p[1] * q[1]) + tangent_re;
    sums->product[1] = im - mass * (p[0] * q[1] - p[1] * q[0]) + tangent_im;
    sums->extra = 0;
}

double duct_align_extra(const duct_neighbourhood *a, const duct_neighbourhood *b, int reach,
                        const double *weights)
{
    double sum = 0;
    for (int k = 0; k < 2 * reach + 1; k++) {
        double off = a->extra[k] - b->extra[k];
        sum += weights[k] * off * off;
    }
    return sum;
}
