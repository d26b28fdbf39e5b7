/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_SEARCH_PRIVATE_H
#define DUCTUS_SEARCH_PRIVATE_H

#include "search/search.h"

/* A method of searching: a constant of this type in a file of its own. */
typedef struct duct_search_method {
    size_t (*nearest)(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                      size_t hint_count, uint32_t *rows, float *distances);
    duct_status (*sequence)(const duct_search *search, const duct_allocator *allocator,
                            const duct_search_query *query, uint32_t *rows, float *distances, size_t *found,
                            duct_error *error);
    void (*destroy)(duct_search *search);
} duct_search_method;

struct duct_search {
    const duct_search_method *method;
    duct_allocator allocator;
    const float *rows;
    size_t count, dimensions;
};

/* The k best rows so far: a heap whose top is the worst of them, by (squared distance, row). */
typedef struct duct_nearest {
    uint32_t *rows;
    float *squares;
    size_t count, capacity;
} duct_nearest;

/* True where a row of that squared distance would be kept. */
static inline bool duct_nearest_wants(const duct_nearest *nearest, float square, uint32_t row)
{
    return nearest->count < nearest->capacity || square < nearest->squares[0] ||
           (square == nearest->squares[0] && row < nearest->rows[0]);
}

void duct_nearest_put(duct_nearest *nearest, float square, uint32_t row);

/* Sorts by (distance, row) and replaces the squares by their roots. */
void duct_nearest_finish(duct_nearest *nearest);

/* The squared distance, summed up in the order of the dimensions: the same bits whoever computes it. */
static inline float duct_feature_square(const float *query, const float *row, size_t dimensions)
{
    float square = 0;
    for (size_t d = 0; d < dimensions; d++) {
        float difference = query[d] - row[d];
        square += difference * difference;
    }
    return square;
}

/* The `sequence` of methods that answer queries one at a time. */
duct_status duct_search_one_by_one(const duct_search *search, const duct_allocator *allocator,
                                   const duct_search_query *query, uint32_t *rows, float *distances,
                                   size_t *found, duct_error *error);

duct_status duct_search_exact_new(const duct_allocator *allocator, const float *rows, size_t count,
                                  size_t dimensions, duct_search **search, duct_error *error);
duct_status duct_search_flann_new(const duct_allocator *allocator, const float *rows, size_t count,
                                  size_t dimensions, duct_search **search, duct_error *error);
duct_status duct_search_patchmatch_new(const duct_allocator *allocator, const float *rows, size_t count,
                                       size_t dimensions, const uint32_t *starts, duct_search **search,
                                       duct_error *error);

#endif
