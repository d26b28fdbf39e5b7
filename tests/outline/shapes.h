/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_SHAPES_H
#define DUCTUS_TESTS_SHAPES_H

/* Strokes to outline, and outlines as GEOS shapes to be measured. Include after testing.h. */

#include "base/memory.h"
#include "geometry/path.h"
#include "outline/outline_private.h"

#include <ductus/drawing.h>

#include <geos_c.h>
#include <math.h>

static const double pi = 3.14159265358979323846;

#define assert_near(value, expected, most) assert_true(fabs((value) - (expected)) <= (most))

/* A drawing with one stroke, to be filled by the test. */
typedef struct sheet {
    duct_drawing *drawing;
    duct_stroke *stroke;
    double *x, *y;
    size_t count;
} sheet;

static inline sheet sheet_new(size_t count)
{
    duct_error error;
    sheet s = {.count = count};
    assert_ok(duct_drawing_new(NULL, &s.drawing, &error));
    assert_ok(duct_drawing_add_stroke(s.drawing, "s", count, &s.stroke, &error));
    s.x = duct_stroke_edit(s.stroke, DUCT_X);
    s.y = duct_stroke_edit(s.stroke, DUCT_Y);
    return s;
}

static inline double *sheet_channel(const sheet *s, duct_channel channel, double value)
{
    double *values = duct_stroke_edit(s->stroke, channel);
    assert_non_null(values);
    for (size_t i = 0; i < s->count; i++) {
        values[i] = value;
    }
    return values;
}

static inline duct_nib_options round_nib(double width)
{
    duct_nib_options options = duct_nib_options_default();
    options.width = width;
    options.aspect = 1;
    return options;
}

static inline duct_path outline_of(const duct_stroke *stroke, const duct_nib_options *options)
{
    duct_error error;
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    assert_ok(duct_path_outline(&path, stroke, options, &error));
    return path;
}

static inline size_t ring_count(const duct_path *path)
{
    size_t count = 0;
    for (size_t i = 0; i < path->verb_count; i++) {
        count += path->verbs[i] == DUCT_PATH_MOVE;
    }
    return count;
}

static inline GEOSGeometry *polygon(GEOSContextHandle_t geos, const double *xy, size_t count)
{
    GEOSCoordSequence *points = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    for (size_t i = 0; i <= count; i++) {
        GEOSCoordSeq_setXY_r(geos, points, (unsigned)i, xy[2 * (i % count)], xy[2 * (i % count) + 1]);
    }
    return GEOSGeom_createPolygon_r(geos, GEOSGeom_createLinearRing_r(geos, points), NULL, 0);
}

/* Adds a ring to a shape by the even-odd rule; takes both over. */
static inline GEOSGeometry *toggle(GEOSContextHandle_t geos, GEOSGeometry *shape, GEOSGeometry *ring)
{
    GEOSGeometry *valid = GEOSMakeValid_r(geos, ring);
    GEOSGeometry *both = GEOSSymDifference_r(geos, shape, valid);
    assert_non_null(both);
    GEOSGeom_destroy_r(geos, valid);
    GEOSGeom_destroy_r(geos, ring);
    GEOSGeom_destroy_r(geos, shape);
    return both;
}

enum { STEPS = 100 };

static inline size_t flatten_step(const double *from, const double *p, double *xy)
{
    for (int k = 1; k <= STEPS; k++) {
        double u = (double)k / STEPS, v = 1 - u;
        for (int c = 0; c < 2; c++) {
            *xy++ =
                v * v * v * from[c] + 3 * v * v * u * p[c] + 3 * v * u * u * p[2 + c] + u * u * u * p[4 + c];
        }
    }
    return STEPS;
}

/* The shape that a path fills. `self_crossing` counts the rings that cross themselves. */
static inline GEOSGeometry *shape_of_path(GEOSContextHandle_t geos, const duct_path *path,
                                          size_t *self_crossing)
{
    GEOSGeometry *shape = GEOSGeom_createEmptyPolygon_r(geos);
    double *xy = malloc((path->verb_count * STEPS + 1) * 2 * sizeof(double));
    const double *p = path->points, *from = p;
    size_t count = 0;
    for (size_t i = 0; i < path->verb_count; i++) {
        switch (path->verbs[i]) {
        case DUCT_PATH_MOVE:
            count = 0;
            xy[0] = p[0];
            xy[1] = p[1];
            count = 1;
            from = p;
            p += 2;
            break;
        case DUCT_PATH_LINE:
            xy[2 * count] = p[0];
            xy[2 * count + 1] = p[1];
            count++;
            from = p;
            p += 2;
            break;
        case DUCT_PATH_CUBIC:
            count += flatten_step(from, p, xy + 2 * count);
            from = p + 4;
            p += 6;
            break;
        default:
            if (count >= 3) {
                GEOSGeometry *ring = polygon(geos, xy, count);
                *self_crossing += GEOSisValid_r(geos, ring) != 1;
                shape = toggle(geos, shape, ring);
            }
        }
    }
    free(xy);
    return shape;
}

static inline GEOSGeometry *shape_of_rings(GEOSContextHandle_t geos, const duct_polygons *rings)
{
    GEOSGeometry *shape = GEOSGeom_createEmptyPolygon_r(geos);
    for (size_t i = 0, begin = 0; i < rings->count; begin = rings->ends[i++]) {
        shape = toggle(geos, shape, polygon(geos, rings->xy + 2 * begin, rings->ends[i] - begin));
    }
    return shape;
}

static inline double area_of(GEOSContextHandle_t geos, const GEOSGeometry *shape)
{
    double area = 0;
    GEOSArea_r(geos, shape, &area);
    return area;
}

/* The area that a path fills. */
static inline double path_area(const duct_path *path)
{
    GEOSContextHandle_t geos = GEOS_init_r();
    size_t crossing = 0;
    GEOSGeometry *shape = shape_of_path(geos, path, &crossing);
    double area = area_of(geos, shape);
    GEOSGeom_destroy_r(geos, shape);
    GEOS_finish_r(geos);
    return area;
}

#endif
