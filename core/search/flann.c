/* SPDX-License-Identifier: GPL-3.0-or-later */
/* FLANN (Muja and Lowe), as "HelpingHand" section 4.2 uses it. Of its indices only the single kd-tree has no
 * randomness: the kd-forest shuffles with the system's random device whatever its seed, and the k-means trees
 * draw their first centres from the C library's generator, which belongs to the host program. FLANN's answers
 * come as rows: their distances are computed again here, so that they are the same bits as the exact
 * search's. */
#include "search/search_private.h"

#include "base/error.h"

#include <flann/flann.h>
#include <math.h>

enum { LEAF_ROWS = 16 };

typedef struct {
    duct_search base;
    struct FLANNParameters parameters;
    flann_index_t index;
} tree;

static size_t tree_nearest(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                           size_t hint_count, uint32_t *rows, float *distances)
{
    (void)hints;
    (void)hint_count;
    const tree *self = (const tree *)search;
    enum { MOST = 256 };
    int found[MOST];
    float squares[MOST];
    if (k == 0 || k > MOST) {
        return 0;
    }
    for (size_t d = 0; d < search->dimensions; d++) {
        if (!isfinite(query[d])) {
            return 0;
        }
    }
    struct FLANNParameters parameters = self->parameters;
    float *question = (float *)(uintptr_t)query; /* FLANN's C interface lacks the const */
    if (flann_find_nearest_neighbors_index_float(self->index, question, 1, found, squares, (int)k,
                                                 &parameters) != 0) {
        return 0;
    }
    duct_nearest nearest = {rows, distances, 0, k};
    for (size_t i = 0; i < k; i++) {
        if (found[i] >= 0 && (size_t)found[i] < search->count) {
            const float *row = search->rows + (size_t)found[i] * search->dimensions;
            duct_nearest_put(&nearest, duct_feature_square(query, row, search->dimensions),
                             (uint32_t)found[i]);
        }
    }
    duct_nearest_finish(&nearest);
    return nearest.count;
}

static void tree_destroy(duct_search *search)
{
    tree *self = (tree *)search;
    const duct_allocator allocator = search->allocator;
    if (self->index != NULL) {
        flann_free_index_float(self->index, &self->parameters);
    }
    duct_release(&allocator, self);
}

static const duct_search_method tree_method = {tree_nearest, duct_search_one_by_one, tree_destroy};

duct_status duct_search_flann_new(const duct_allocator *allocator, const float *rows, size_t count,
                                  size_t dimensions, duct_search **search, duct_error *error)
{
    tree *self = duct_alloc(allocator, 1, sizeof *self);
    if (self == NULL) {
        return duct_fail_memory(error);
    }
    self->base = (duct_search){&tree_method, *allocator, rows, count, dimensions};
    self->parameters = DEFAULT_FLANN_PARAMETERS;
    self->parameters.algorithm = FLANN_INDEX_KDTREE_SINGLE;
    self->parameters.leaf_max_size = LEAF_ROWS;
    self->parameters.eps = 0;
    self->parameters.checks = FLANN_CHECKS_UNLIMITED;
    self->parameters.sorted = 1;
    self->parameters.cores = 1;
    self->parameters.log_level = FLANN_LOG_NONE;
    /* Seed 0: otherwise every call seeds the C library's generator, which belongs to the host program. */
    self->parameters.random_seed = 0;
    float speedup;
    float *data = (float *)(uintptr_t)rows;
    self->index = flann_build_index_float(data, (int)count, (int)dimensions, &speedup, &self->parameters);
    if (self->index == NULL) {
        tree_destroy(&self->base);
        return duct_fail(error, DUCT_UNSUPPORTED, "FLANN cannot index %zu rows; use the exact search", count);
    }
    *search = &self->base;
    return DUCT_OK;
}
