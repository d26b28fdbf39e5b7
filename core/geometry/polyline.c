/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/polyline.h"

#include "base/error.h"

#include <math.h>

/* Running sums over the points, from which the squared distances of any run of points from any line come in
 * O(1). */
typedef struct {
    double x, y, xx, xy, yy;
} moments;

typedef struct {
    double cost; /* of the best polyline from the first point to this one */
    size_t from; /* the vertex before this one in it */
} vertex;

/* The sum of squared distances of points i..j from the line through both; coordinates are relative to the
 * first point, which keeps the sums small. */
static double misfit(const moments *sums, const double *x, const double *y, size_t first, size_t i, size_t j)
{
    double ox = x[first], oy = y[first];
    double px = x[first + i] - ox, py = y[first + i] - oy;
    double dx = x[first + j] - ox - px, dy = y[first + j] - oy - py;
    double length = hypot(dx, dy);
    double n = (double)(j - i + 1);
    moments s = {sums[j + 1].x - sums[i].x, sums[j + 1].y - sums[i].y, sums[j + 1].xx - sums[i].xx,
                 sums[j + 1].xy - sums[i].xy, sums[j + 1].yy - sums[i].yy};
    double cxx = s.xx - 2 * px * s.x + n * px * px;
    double cyy = s.yy - 2 * py * s.y + n * py * py;
    double cxy = s.xy - px * s.y - py * s.x + n * px * py;
    if (length == 0) {
        return cxx + cyy;
    }
    dx /= length;
    dy /= length;
    double sum = cxx * dy * dy - 2 * cxy * dx * dy + cyy * dx * dx;
    return sum > 0 ? sum : 0;
}

duct_status duct_polyline_vertices(const duct_allocator *allocator, const double *x, const double *y,
                                   size_t first, size_t last, double cost, size_t longest, bool *marks,
                                   duct_error *error)
{
    size_t count = last - first + 1;
    if (count < 3) {
        return DUCT_OK;
    }
    moments *sums = duct_alloc(allocator, count + 1, sizeof *sums);
    vertex *best = duct_alloc(allocator, count, sizeof *best);
    if (sums == NULL || best == NULL) {
        duct_release(allocator, sums);
        duct_release(allocator, best);
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        double px = x[first + i] - x[first], py = y[first + i] - y[first];
        sums[i + 1] = (moments){sums[i].x + px, sums[i].y + py, sums[i].xx + px * px, sums[i].xy + px * py,
                                sums[i].yy + py * py};
    }
    for (size_t j = 1; j < count; j++) {
        size_t earliest = j > longest ? j - longest : 0;
        best[j].cost = INFINITY;
        for (size_t i = earliest; i < j; i++) {
            double total = best[i].cost + cost;
            if (total < best[j].cost) {
                total += misfit(sums, x, y, first, i, j);
                if (total < best[j].cost) {
                    best[j] = (vertex){total, i};
                }
            }
        }
    }
    for (size_t i = best[count - 1].from; i > 0; i = best[i].from) {
        marks[first + i] = true;
    }
    duct_release(allocator, sums);
    duct_release(allocator, best);
    return DUCT_OK;
}
