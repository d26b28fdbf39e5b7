/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The anchor points of "HelpingHand" section 4.3.2. */
#include "helpinghand/shape.h"

#include "base/error.h"
#include "geometry/polyline.h"

#include <math.h>

enum {
    INSIDE = 3, /* how many samples the end anchors lie inside the ends */
    WINDOW = 5  /* samples before and after one that its turning angle is measured over */
};

/* The turning angle at sample i, 0..pi, between the chords of the window before and after it. */
static double turning(const double *x, const double *y, size_t count, size_t i)
{
    size_t a = i >= WINDOW ? i - WINDOW : 0, b = i + WINDOW < count ? i + WINDOW : count - 1;
    double ux = x[i] - x[a], uy = y[i] - y[a], vx = x[b] - x[i], vy = y[b] - y[i];
    return fabs(atan2(ux * vy - uy * vx, ux * vx + uy * vy));
}

/* Marks the local maxima of the turning angle above the threshold; the first of equals. */
static void mark_angles(const duct_shape_options *options, size_t count, const double *angles, bool *marks)
{
    for (size_t i = 1; i + 1 < count; i++) {
        if (angles[i] <= options->corner) {
            continue;
        }
        size_t first = i >= WINDOW ? i - WINDOW : 0, last = i + WINDOW < count ? i + WINDOW : count - 1;
        bool highest = true;
        for (size_t k = first; k <= last && highest; k++) {
            highest = k < i ? angles[k] < angles[i] : angles[k] <= angles[i];
        }
        marks[i] = marks[i] || highest;
    }
}

duct_status duct_anchors_find(const duct_allocator *allocator, const duct_shape_options *options,
                              const double *x, const double *y, size_t count, bool *marks, bool *corners,
                              duct_error *error)
{
    for (size_t i = 0; i < count; i++) {
        marks[i] = false;
        if (corners != NULL) {
            corners[i] = false;
        }
    }
    if (count < 3) {
        for (size_t i = 0; i < count; i++) {
            marks[i] = true;
        }
        return DUCT_OK;
    }
    size_t inside = count > 4 * INSIDE ? INSIDE : 0;
    marks[inside] = marks[count - 1 - inside] = true;
    double *angles = duct_alloc(allocator, count, sizeof *angles);
    if (angles == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 1; i + 1 < count; i++) {
        angles[i] = turning(x, y, count, i);
    }
    mark_angles(options, count, angles, marks);
    if (corners != NULL) {
        mark_angles(options, count, angles, corners);
    }
    duct_release(allocator, angles);
    duct_status status = DUCT_OK;
    size_t from = inside;
    for (size_t i = inside + 1; status == DUCT_OK && i + inside < count; i++) {
        if (marks[i]) {
            status = duct_polyline_vertices(allocator, x, y, from, i, options->vertex_cost, options->longest,
                                            marks, error);
            from = i;
        }
    }
    return status;
}
