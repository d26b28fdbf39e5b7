/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "search/search_private.h"

#include "base/error.h"
#include "search/abreast.h"

#include <math.h>

duct_status duct_search_new(const duct_allocator *allocator, duct_search_kind kind, const float *rows,
                            size_t count, size_t dimensions, const uint32_t *starts, duct_search **search,
                            duct_error *error)
{
    if (count == 0 || count > UINT32_MAX / 2) {
        return duct_fail(error, DUCT_UNSUPPORTED, "a search index needs 1 to %u rows, not %zu",
                         UINT32_MAX / 2, count);
    }
    switch (kind) {
    case DUCT_SEARCH_FLANN:
        return duct_search_flann_new(allocator, rows, count, dimensions, search, error);
    case DUCT_SEARCH_PATCHMATCH:
        return duct_search_patchmatch_new(allocator, rows, count, dimensions, starts, search, error);
    default:
        return duct_search_exact_new(allocator, rows, count, dimensions, search, error);
    }
}

void duct_search_free(duct_search *search)
{
    if (search != NULL) {
        search->method->destroy(search);
    }
}

size_t duct_search_nearest(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                           size_t hint_count, uint32_t *rows, float *distances)
{
    return search->method->nearest(search, query, k < search->count ? k : search->count, hints, hint_count,
                                   rows, distances);
}

float duct_feature_distance(const float *query, const float *row, size_t dimensions)
{
    return sqrtf(duct_feature_square(query, row, dimensions));
}

WIDE static void feature_distances(const float *query, const float *rows, size_t dimensions,
                                   const uint32_t *which, size_t count, float *distances)
{
    for (size_t first = 0; first < count; first += DUCT_ABREAST) {
        const float *places[DUCT_ABREAST];
        float squares[DUCT_ABREAST];
        for (size_t i = 0; i < DUCT_ABREAST; i++) {
            places[i] = rows + (size_t)which[first + i < count ? first + i : first] * dimensions;
        }
        duct_squares_abreast(query, places, dimensions, squares);
        for (size_t i = 0; i < DUCT_ABREAST && first + i < count; i++) {
            distances[first + i] = sqrtf(squares[i]);
        }
    }
}

void duct_feature_distances(const float *query, const float *rows, size_t dimensions, const uint32_t *which,
                            size_t count, float *distances)
{
    feature_distances(query, rows, dimensions, which, count, distances);
}

duct_status duct_search_sequence(const duct_search *search, const duct_allocator *allocator,
                                 const duct_search_query *query, uint32_t *rows, float *distances,
                                 size_t *found, duct_error *error)
{
    return search->method->sequence(search, allocator, query, rows, distances, found, error);
}

duct_status duct_search_one_by_one(const duct_search *search, const duct_allocator *allocator,
                                   const duct_search_query *query, uint32_t *rows, float *distances,
                                   size_t *found, duct_error *error)
{
    size_t k = query->k, hint_count = 0;
    uint32_t *hints = duct_alloc(allocator, 2 * k, sizeof *hints);
    if (hints == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < query->count; i++) {
        uint32_t *near = rows + i * k;
        found[i] = duct_search_nearest(search, query->rows + i * search->dimensions, k, hints, hint_count,
                                       near, distances + i * k);
        /* The next sample's neighbours are likely those that follow this one's. */
        hint_count = 0;
        for (size_t n = 0; n < found[i]; n++) {
            hints[hint_count++] = near[n] + 1;
        }
        for (size_t n = 0; n < found[i]; n++) {
            hints[hint_count++] = near[n];
        }
    }
    duct_release(allocator, hints);
    return DUCT_OK;
}

static bool worse(const duct_nearest *nearest, size_t a, size_t b)
{
    return nearest->squares[a] > nearest->squares[b] ||
           (nearest->squares[a] == nearest->squares[b] && nearest->rows[a] > nearest->rows[b]);
}

static void swap(duct_nearest *nearest, size_t a, size_t b)
{
    float square = nearest->squares[a];
    uint32_t row = nearest->rows[a];
    nearest->squares[a] = nearest->squares[b];
    nearest->rows[a] = nearest->rows[b];
    nearest->squares[b] = square;
    nearest->rows[b] = row;
}

static void sift_down(duct_nearest *nearest, size_t at, size_t count)
{
    for (;;) {
        size_t child = 2 * at + 1;
        if (child >= count) {
            return;
        }
        if (child + 1 < count && worse(nearest, child + 1, child)) {
            child++;
        }
        if (!worse(nearest, child, at)) {
            return;
        }
        swap(nearest, at, child);
        at = child;
    }
}

void duct_nearest_put(duct_nearest *nearest, float square, uint32_t row)
{
    if (nearest->count < nearest->capacity) {
        size_t at = nearest->count++;
        nearest->squares[at] = square;
        nearest->rows[at] = row;
        while (at > 0 && worse(nearest, at, (at - 1) / 2)) {
            swap(nearest, at, (at - 1) / 2);
            at = (at - 1) / 2;
        }
        return;
    }
    nearest->squares[0] = square;
    nearest->rows[0] = row;
    sift_down(nearest, 0, nearest->count);
}

void duct_nearest_finish(duct_nearest *nearest)
{
    for (size_t count = nearest->count; count > 1; count--) {
        swap(nearest, 0, count - 1);
        sift_down(nearest, 0, count - 1);
    }
    for (size_t i = 0; i < nearest->count; i++) {
        nearest->squares[i] = sqrtf(nearest->squares[i]);
    }
}
