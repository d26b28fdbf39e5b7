/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_SEARCH_H
#define DUCTUS_SEARCH_H

#include "base/memory.h"

#include <ductus/status.h>

#include <stdint.h>

/* Nearest neighbours among feature vectors, by Euclidean distance: "HelpingHand" section 4.2. One small
 * interface over several methods; all of them give the same answer to the same question on every run and from
 * any thread. */
typedef enum duct_search_kind {
    DUCT_SEARCH_EXACT,     /* all rows, with whole blocks left out where their bounding box is too far away */
    DUCT_SEARCH_FLANN,     /* FLANN's single kd-tree, the one of its indices that has no randomness */
    DUCT_SEARCH_PATCHMATCH /* PatchMatch over the 1-D domain of samples: approximate, for whole strokes */
} duct_search_kind;

typedef struct duct_search duct_search;

/* An index over `count` >= 1 rows of `dimensions` floats each, row by row. The rows are copied or kept as the
 * method needs; they must outlive the index. Stroke s has rows starts[s] .. starts[s + 1] - 1, the last of
 * `starts` is `count`; NULL: all rows are one stroke's. The caller frees the index. Errors: DUCT_NO_MEMORY,
 * DUCT_UNSUPPORTED. */
duct_status duct_search_new(const duct_allocator *allocator, duct_search_kind kind, const float *rows,
                            size_t count, size_t dimensions, const uint32_t *starts, duct_search **search,
                            duct_error *error);
void duct_search_free(duct_search *search); /* NULL is allowed */

/* Finds the min(k, count) nearest rows of `query`, by distance, then by row. `rows` and `distances` (not
 * squared) have room for k. `hints` are rows that are likely near (they only save time); `hint_count` may be
 * 0. Returns how many were found: min(k, count), or less where an approximate method found less. Safe from
 * several threads. */
size_t duct_search_nearest(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                           size_t hint_count, uint32_t *rows, float *distances);

/* Neighbouring samples of a query stroke, to be searched together. */
typedef struct duct_search_query {
    const float *rows; /* `count` feature vectors, sample by sample */
    size_t count, k;
    size_t first;       /* which sample of the stroke the first one is: an address of randomness */
    uint64_t seed;      /* for methods that search by chance */
    uint64_t stroke_id; /* duct_random_id() of the query stroke */
} duct_search_query;

/* Finds the min(k, count) nearest rows of every sample: those of sample i are rows[i * k] and on, by
 * distance, then by row, and found[i] says how many they are, fewer than k where an approximate method or a
 * small library has less. `rows` and `distances` (not squared) have room for count * k. Methods that answer
 * queries one at a time get each sample's neighbours and their successors as hints for the next one. Safe
 * from several threads. Errors: DUCT_NO_MEMORY. */
duct_status duct_search_sequence(const duct_search *search, const duct_allocator *allocator,
                                 const duct_search_query *query, uint32_t *rows, float *distances,
                                 size_t *found, duct_error *error);

/* The distance between a query and a row, computed as the methods do. */
float duct_feature_distance(const float *query, const float *row, size_t dimensions);

/* The same for `count` of the `rows`. */
void duct_feature_distances(const float *query, const float *rows, size_t dimensions, const uint32_t *which,
                            size_t count, float *distances);

#endif
