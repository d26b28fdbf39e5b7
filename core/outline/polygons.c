/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline/outline_private.h"

#include "base/error.h"

#include <geos_c.h>
#include <math.h>
#include <stdio.h>

/* Polygons and their union by GEOS. Each call has a GEOS handle of its own: threads share nothing. */

void duct_polygons_free(const duct_allocator *allocator, duct_polygons *polygons)
{
    duct_release(allocator, polygons->xy);
    duct_release(allocator, polygons->ends);
    *polygons = (duct_polygons){0};
}

bool duct_polygons_add(const duct_allocator *allocator, duct_polygons *polygons, double x, double y)
{
    void *xy = polygons->xy;
    if (!duct_reserve(allocator, &xy, &polygons->point_capacity, polygons->point_count + 1,
                      2 * sizeof(double))) {
        return false;
    }
    polygons->xy = xy;
    polygons->xy[2 * polygons->point_count] = x;
    polygons->xy[2 * polygons->point_count + 1] = y;
    polygons->point_count++;
    return true;
}

bool duct_polygons_end(const duct_allocator *allocator, duct_polygons *polygons)
{
    size_t begin = polygons->count > 0 ? polygons->ends[polygons->count - 1] : 0;
    if (polygons->point_count < begin + 3) {
        polygons->point_count = begin;
        return true;
    }
    void *ends = polygons->ends;
    if (!duct_reserve(allocator, &ends, &polygons->capacity, polygons->count + 1, sizeof(size_t))) {
        return false;
    }
    polygons->ends = ends;
    polygons->ends[polygons->count++] = polygons->point_count;
    return true;
}

/* What GEOS said last, for the sentence. */
typedef struct {
    char text[256];
} geos_message;

static void take_message(const char *text, void *user)
{
    geos_message *message = user;
    snprintf(message->text, sizeof message->text, "%s", text);
}

static duct_status geos_failed(const geos_message *message, duct_error *error)
{
    return duct_fail(
        error, DUCT_UNSUPPORTED,
        "the geometry library GEOS could not unite a stroke's outline (%s); write plain paths instead",
        message->text[0] != '\0' ? message->text : "it did not say why");
}

static GEOSGeometry *polygon_of(GEOSContextHandle_t geos, const double *xy, size_t count)
{
    GEOSCoordSequence *points = GEOSCoordSeq_create_r(geos, (unsigned)count + 1, 2);
    if (points == NULL) {
        return NULL;
    }
    for (size_t i = 0; i <= count; i++) {
        size_t k = i < count ? i : 0;
        GEOSCoordSeq_setXY_r(geos, points, (unsigned)i, xy[2 * k], xy[2 * k + 1]);
    }
    GEOSGeometry *ring = GEOSGeom_createLinearRing_r(geos, points);
    return ring != NULL ? GEOSGeom_createPolygon_r(geos, ring, NULL, 0) : NULL;
}

/* All polygons as one geometry, or NULL. */
static GEOSGeometry *collect(GEOSContextHandle_t geos, const duct_allocator *allocator,
                             const duct_polygons *polygons, bool *memory)
{
    GEOSGeometry **parts = duct_alloc(allocator, polygons->count, sizeof(GEOSGeometry *));
    *memory = parts != NULL;
    size_t made = 0, begin = 0;
    while (parts != NULL && made < polygons->count) {
        parts[made] = polygon_of(geos, polygons->xy + 2 * begin, polygons->ends[made] - begin);
        if (parts[made] == NULL) {
            break;
        }
        begin = polygons->ends[made++];
    }
    GEOSGeometry *all = NULL;
    if (parts != NULL && made == polygons->count) {
        all = GEOSGeom_createCollection_r(geos, GEOS_MULTIPOLYGON, parts, (unsigned)made);
    } else {
        while (made > 0) {
            GEOSGeom_destroy_r(geos, parts[--made]);
        }
    }
    duct_release(allocator, parts);
    return all;
}

static bool add_ring(GEOSContextHandle_t geos, const duct_allocator *allocator, const GEOSGeometry *ring,
                     double speck, duct_polygons *rings)
{
    const GEOSCoordSequence *points = ring != NULL ? GEOSGeom_getCoordSeq_r(geos, ring) : NULL;
    unsigned count = 0;
    if (points == NULL || !GEOSCoordSeq_getSize_r(geos, points, &count)) {
        return true;
    }
    double area = 0, x0 = 0, y0 = 0, bx = 0, by = 0;
    size_t before = rings->point_count;
    for (unsigned i = 0; i + 1 < count; i++) {
        double x, y;
        GEOSCoordSeq_getXY_r(geos, points, i, &x, &y);
        if (i == 0) {
            x0 = x;
            y0 = y;
        } else {
            area += 0.5 * ((bx - x0) * (y - y0) - (by - y0) * (x - x0));
        }
        bx = x;
        by = y;
        if (!duct_polygons_add(allocator, rings, x, y)) {
            return false;
        }
    }
    if (fabs(area) < speck) {
        rings->point_count = before;
    }
    return duct_polygons_end(allocator, rings);
}

static bool add_rings(GEOSContextHandle_t geos, const duct_allocator *allocator, const GEOSGeometry *shape,
                      double speck, duct_polygons *rings)
{
    int parts = GEOSGetNumGeometries_r(geos, shape);
    for (int i = 0; i < parts; i++) {
        const GEOSGeometry *part = GEOSGetGeometryN_r(geos, shape, i);
        if (GEOSGeomTypeId_r(geos, part) != GEOS_POLYGON) {
            continue;
        }
        if (!add_ring(geos, allocator, GEOSGetExteriorRing_r(geos, part), speck, rings)) {
            return false;
        }
        int holes = GEOSGetNumInteriorRings_r(geos, part);
        for (int k = 0; k < holes; k++) {
            if (!add_ring(geos, allocator, GEOSGetInteriorRingN_r(geos, part, k), speck, rings)) {
                return false;
            }
        }
    }
    return true;
}

duct_status duct_polygons_union(const duct_allocator *allocator, const duct_polygons *polygons, double speck,
                                duct_polygons *rings, duct_error *error)
{
    geos_message message = {""};
    GEOSContextHandle_t geos = GEOS_init_r();
    if (geos == NULL) {
        return duct_fail_memory(error);
    }
    GEOSContext_setErrorMessageHandler_r(geos, take_message, &message);
    bool memory = true;
    GEOSGeometry *all = collect(geos, allocator, polygons, &memory);
    GEOSGeometry *shape = all != NULL ? GEOSUnaryUnion_r(geos, all) : NULL;
    duct_status status = DUCT_OK;
    if (!memory) {
        status = duct_fail_memory(error);
    } else if (shape == NULL) {
        status = geos_failed(&message, error);
    } else if (!add_rings(geos, allocator, shape, speck, rings)) {
        status = duct_fail_memory(error);
    }
    if (shape != NULL) {
        GEOSGeom_destroy_r(geos, shape);
    }
    if (all != NULL) {
        GEOSGeom_destroy_r(geos, all);
    }
    GEOS_finish_r(geos);
    return status;
}
