/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "geometry/fit.h"
#include "outline/outline_private.h"

#include <math.h>

/* The envelope of a moving nib. */

/* Adds points to edges that are much longer than their neighbours, more closely near their ends: the fit
 * judges a curve's direction by the points around. */
static bool add_graded(const duct_allocator *allocator, const double a[2], const double b[2], double before,
                       double after, duct_polygons *ring)
{
    double length = hypot(b[0] - a[0], b[1] - a[1]);
    double t0 = 3 * before / length, t1 = 1 - 3 * after / length;
    double forward[24], back[24];
    size_t n = 0, m = 0;
    for (; n < 24 && t0 < 0.4; t0 *= 3) {
        forward[n++] = t0;
    }
    for (; m < 24 && t1 > 0.6; t1 = 1 - 3 * (1 - t1)) {
        back[m++] = t1;
    }
    bool ok = duct_polygons_add(allocator, ring, a[0], a[1]);
    for (size_t i = 0; i < n && ok; i++) {
        ok = duct_polygons_add(allocator, ring, a[0] + forward[i] * (b[0] - a[0]),
                               a[1] + forward[i] * (b[1] - a[1]));
    }
    for (size_t i = m; i-- > 0 && ok;) {
        ok = duct_polygons_add(allocator, ring, a[0] + back[i] * (b[0] - a[0]),
                               a[1] + back[i] * (b[1] - a[1]));
    }
    return ok;
}

static double edge_length(const double *xy, size_t count, size_t i)
{
    const double *a = xy + 2 * (i % count), *b = xy + 2 * ((i + 1) % count);
    return hypot(b[0] - a[0], b[1] - a[1]);
}

/* The angle by which a ring turns at a point. */
static double ring_turn(const double *xy, size_t count, size_t i)
{
    const double *a = xy + 2 * ((i + count - 1) % count), *b = xy + 2 * (i % count),
                 *c = xy + 2 * ((i + 1) % count);
    double ax = b[0] - a[0], ay = b[1] - a[1], bx = c[0] - b[0], by = c[1] - b[1];
    return fabs(atan2(ax * by - ay * bx, ax * bx + ay * by));
}

/* A copy of a ring with what add_graded() adds. */
static bool grade(const duct_allocator *allocator, const double *xy, size_t count, double tolerance,
                  duct_polygons *graded)
{
    bool ok = true;
    double turn = ring_turn(xy, count, 0);
    for (size_t i = 0; i < count && ok; i++) {
        double next_turn = ring_turn(xy, count, i + 1);
        /* An edge that turns by too much at its ends for its length is no chord of a curve but straight, and
         * is given points enough to show it. */
        double rise = edge_length(xy, count, i) * (turn + next_turn) / 16;
        double most = rise > 0.5 * tolerance ? 0.3 * tolerance : INFINITY;
        double before = fmax(edge_length(xy, count, i + count - 1), 0.3 * tolerance);
        double after = fmax(edge_length(xy, count, i + 1), 0.3 * tolerance);
        ok = add_graded(allocator, xy + 2 * i, xy + 2 * ((i + 1) % count), fmin(before, most),
                        fmin(after, most), graded);
        turn = next_turn;
    }
    return ok;
}

/* Fits one ring as a closed curve. */
static bool fit_ring(const duct_allocator *allocator, const double *xy, size_t count, double tolerance,
                     duct_path *path)
{
    duct_polygons graded = {0};
    bool ok = grade(allocator, xy, count, tolerance, &graded);
    size_t n = graded.point_count;
    double *split = ok ? duct_alloc(allocator, n, 2 * sizeof *split) : NULL;
    ok = split != NULL;
    for (size_t i = 0; i < n && ok; i++) {
        split[i] = graded.xy[2 * i];
        split[n + i] = graded.xy[2 * i + 1];
    }
    if (ok) {
        duct_fit_curve(split, split + n, n, true, DUCT_SHARE_FIT * tolerance, path);
        ok = !path->failed;
    }
    duct_release(allocator, split);
    duct_polygons_free(allocator, &graded);
    return ok;
}

static duct_status outline_nibs(const duct_allocator *allocator, const duct_nib_list *nibs, double tolerance,
                                duct_path *path, duct_error *error)
{
    duct_polygons polygons = {0}, rings = {0};
    const duct_polygons *shape = &polygons;
    duct_status status = DUCT_OK;
    if (!duct_envelope(allocator, nibs, DUCT_SHARE_ARC * tolerance, false, &polygons)) {
        status = duct_fail_memory(error);
    } else if (polygons.count > 1) {
        status = duct_polygons_union(allocator, &polygons, tolerance * tolerance, &rings, error);
        shape = &rings;
    }
    for (size_t i = 0, begin = 0; status == DUCT_OK && i < shape->count; begin = shape->ends[i++]) {
        if (!fit_ring(allocator, shape->xy + 2 * begin, shape->ends[i] - begin, tolerance, path)) {
            status = duct_fail_memory(error);
        }
    }
    duct_polygons_free(allocator, &polygons);
    duct_polygons_free(allocator, &rings);
    return status;
}

duct_status duct_path_outline(duct_path *path, const duct_stroke *stroke, const duct_nib_options *options,
                              duct_error *error)
{
    if (path->failed) {
        return duct_fail_memory(error);
    }
    if (duct_stroke_size(stroke) == 0) {
        return DUCT_OK;
    }
    duct_nib_options checked = options != NULL ? *options : duct_nib_options_default();
    /* Finer than a ten thousandth of a pixel nobody sees and GEOS does not compute. */
    checked.fit_tolerance = checked.fit_tolerance > 1e-4 ? fmin(checked.fit_tolerance, 1e3) : 1e-4;
    const size_t verbs = path->verb_count, points = path->point_count;
    duct_nib_list nibs = {0};
    duct_status status;
    if (duct_sweep_nibs(path->allocator, stroke, &checked, &nibs)) {
        status = outline_nibs(path->allocator, &nibs, checked.fit_tolerance, path, error);
    } else {
        status = duct_fail_memory(error);
    }
    duct_release(path->allocator, nibs.items);
    if (status != DUCT_OK) {
        path->verb_count = verbs;
        path->point_count = points;
        path->failed = false;
    }
    return status;
}
