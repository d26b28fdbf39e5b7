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
    DUCT_SEARCH_EXACT, /* all rows, with whole blocks left out where their bounding box is too far away */
    DUCT_SEARCH_FLANN  /* FLANN's single kd-tree, the one of its indices that has no randomness */
} duct_search_kind;

typedef struct duct_search duct_search;

/* An index over `count` >= 1 rows of `dimensions` floats each, row by row. The rows are copied or kept as the
 * method needs; they must outlive the index. The caller frees it. Errors: DUCT_NO_MEMORY, DUCT_UNSUPPORTED.
 */
duct_status duct_search_new(const duct_allocator *allocator, duct_search_kind kind, const float *rows,
                            size_t count, size_t dimensions, duct_search **search, duct_error *error);
void duct_search_free(duct_search *search); /* NULL is allowed */

/* Finds the min(k, count) nearest rows of `query`, by distance, then by row. `rows` and `distances` (not
 * squared) have room for k. `hints` are rows that are likely near (they only save time); `hint_count` may be
 * 0. Returns how many were found: min(k, count), or less where an approximate method found less. Safe from
 * several threads. */
size_t duct_search_nearest(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                           size_t hint_count, uint32_t *rows, float *distances);

/* The distance between a query and a row, computed as the methods do. */
float duct_feature_distance(const float *query, const float *row, size_t dimensions);

#endif
