/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "geometry/bezier.h"
#include "geometry/fit.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

/* Paths to strokes and back. */

static const double farthest = 1e9; /* pixels, where no page reaches */

static duct_status check_tolerance(double tolerance, duct_error *error)
{
    return tolerance > 0 && isfinite(tolerance)
               ? DUCT_OK
               : duct_fail(error, DUCT_BAD_ARGUMENT,
                           "a tolerance of %g pixels was given; it has to be above 0", tolerance);
}

static duct_status check_points(const double *points, size_t count, duct_error *error)
{
    for (size_t i = 0; i < 2 * count; i++) {
        if (!isfinite(points[i])) {
            return duct_fail(error, DUCT_BAD_ARGUMENT, "point %zu of the path is not a finite number",
                             i / 2 + 1);
        }
        if (fabs(points[i]) > farthest) {
            return duct_fail(error, DUCT_LIMIT,
                             "point %zu of the path lies more than %g pixels from the page", i / 2 + 1,
                             farthest);
        }
    }
    return DUCT_OK;
}

static duct_status add_stroke(duct_drawing *drawing, const char *id, const duct_points *points, bool closed,
                              duct_error *error)
{
    if (points->failed) {
        return duct_fail_memory(error);
    }
    if (points->full) {
        return duct_fail(error, DUCT_LIMIT, "the path has more than %d points when flattened",
                         DUCT_MAX_SAMPLES);
    }
    duct_stroke *stroke;
    duct_status status = duct_drawing_add_stroke(drawing, id, points->count, &stroke, error);
    if (status == DUCT_OK) {
        memcpy(duct_stroke_edit(stroke, DUCT_X), points->x, points->count * sizeof(double));
        memcpy(duct_stroke_edit(stroke, DUCT_Y), points->y, points->count * sizeof(double));
        duct_stroke_set_closed(stroke, closed);
    }
    return status;
}

duct_status duct_path_flatten(const duct_path *path, const char *id, double tolerance, duct_drawing *drawing,
                              duct_error *error)
{
    duct_status status = path->failed ? duct_fail_memory(error) : check_tolerance(tolerance, error);
    if (status == DUCT_OK) {
        status = check_points(path->points, path->point_count, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    duct_points points;
    duct_text name;
    duct_points_init(&points, path->allocator, DUCT_MAX_SAMPLES);
    duct_text_init(&name, path->allocator);
    duct_subpath subpath = {0};
    for (size_t number = 1; status == DUCT_OK && duct_path_next(path, &subpath); number++) {
        if (subpath.verb_end - subpath.verb < 2) {
            continue;
        }
        name.size = 0;
        duct_text_add(&name, id);
        if (number > 1) {
            duct_text_addf(&name, "/%zu", number);
        }
        duct_flatten_subpath(&points, path, &subpath, tolerance);
        status = name.failed ? duct_fail_memory(error)
                             : add_stroke(drawing, name.data, &points, subpath.closed, error);
        points.limit -= status == DUCT_OK ? points.count : 0;
    }
    duct_points_free(&points);
    duct_text_free(&name);
    return status;
}

/* Points on the straight line between samples that are far apart, close together near its ends. The fit knows
 * of nothing between its points, and would round off a polyline's blunt corners. */
static void add_between(duct_points *points, double x0, double y0, double x1, double y1, double tolerance)
{
    double length = hypot(x1 - x0, y1 - y0), nearest = 4 * tolerance, from_end = length / 2;
    double along = nearest;
    for (; along < length / 2; along *= 2) {
        double t = along / length;
        duct_points_add(points, x0 + (x1 - x0) * t, y0 + (y1 - y0) * t);
        from_end = along;
    }
    for (; from_end >= nearest && from_end > 0; from_end /= 2) {
        double t = from_end / length;
        duct_points_add(points, x1 - (x1 - x0) * t, y1 - (y1 - y0) * t);
    }
}

/* Samples without times are corners of a line that was flattened. */
static void fit_polyline(const double *x, const double *y, size_t size, bool closed, double tolerance,
                         duct_path *path)
{
    duct_points points;
    duct_points_init(&points, path->allocator, SIZE_MAX);
    for (size_t i = 0; i < size; i++) {
        if (i > 0) {
            add_between(&points, x[i - 1], y[i - 1], x[i], y[i], tolerance);
        }
        duct_points_add(&points, x[i], y[i]);
    }
    if (closed) {
        add_between(&points, x[size - 1], y[size - 1], x[0], y[0], tolerance);
    }
    path->failed = path->failed || points.failed;
    duct_fit_curve(points.x, points.y, points.count, closed, tolerance, path);
    duct_points_free(&points);
}

duct_status duct_path_fit(duct_path *path, const duct_stroke *stroke, double tolerance, duct_error *error)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    size_t size = duct_stroke_size(stroke);
    bool closed = duct_stroke_closed(stroke);
    duct_status status = check_tolerance(tolerance, error);
    for (size_t i = 0; status == DUCT_OK && i < size; i++) {
        if (!isfinite(x[i]) || !isfinite(y[i])) {
            status = duct_fail(error, DUCT_BAD_ARGUMENT, "sample %zu of stroke '%s' is not a finite number",
                               i + 1, duct_stroke_id(stroke));
        }
    }
    if (status != DUCT_OK) {
        return status;
    }
    if (size == 1) {
        duct_path_move(path, x[0], y[0]);
        duct_path_line(path, x[0], y[0]);
        if (closed) {
            duct_path_close(path);
        }
    } else if (size > 1 && duct_stroke_values(stroke, DUCT_T) != NULL) {
        /* A pen's way between its samples is smooth. */
        duct_fit_curve(x, y, size, closed, tolerance, path);
    } else if (size > 1) {
        fit_polyline(x, y, size, closed, tolerance, path);
    }
    return path->failed ? duct_fail_memory(error) : DUCT_OK;
}
