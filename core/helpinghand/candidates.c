/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/candidates.h"

#include "base/error.h"
#include "base/pool.h"
#include "library/library_private.h"

#include <ductus/random.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { PURPOSE_VARIATION = 1 };

/* A column may grow by coherence to this many times k; then its farthest candidates go.
 */
enum { MOST_TIMES_K = 8 };

/* So many samples are searched together: enough for any method, and little memory beside the columns. */
enum { PIECE = 4096 };

typedef struct {
    const duct_allocator *allocator;
    const duct_library *library;
    const duct_feature_index *index;
    const duct_candidate_options *options;
    size_t item_capacity;
    uint32_t *near;          /* PIECE times k, as duct_search_sequence() gives them */
    float *distances;        /* as many */
    size_t *found;           /* PIECE */
    duct_candidate *nearest; /* room for k */
    duct_candidate *merged;  /* room for 1 + MOST_TIMES_K times k */
    uint32_t *fresh,
        *places; /* as many: successors that are not among the nearest, and where they are merged */
    float *fresh_distances;
    /* Of a library with weights: */
    double most_weight;
    uint32_t *wide_rows; /* as many as a sample's search had to be widened to so far, as the two below */
    float *wide_distances;
    duct_candidate *wide;
    size_t wide_capacity[3];
} finder;

static int by_sample(const void *a, const void *b)
{
    uint32_t x = ((const duct_candidate *)a)->sample, y = ((const duct_candidate *)b)->sample;
    return (x > y) - (x < y);
}

static int by_distance(const void *a, const void *b)
{
    float x = ((const duct_candidate *)a)->distance, y = ((const duct_candidate *)b)->distance;
    return x < y ? -1 : x > y ? 1 : by_sample(a, b);
}

/* Candidates of recordings that weigh more are nearer by that factor. */
static void weigh(const finder *self, duct_candidate *candidates, size_t count)
{
    const double *weights = self->library->weights;
    for (size_t i = 0; weights != NULL && i < count; i++) {
        candidates[i].distance = (float)((double)candidates[i].distance / weights[candidates[i].stroke]);
    }
}

/* Adds to the `near` nearest candidates, which ascend, the successors of the column before, in ascending
 * order; `merged` gets both. Returns how many there are. */
static size_t add_successors(const finder *self, const float *query, const duct_columns *columns,
                             size_t column, const duct_candidate *nearest, size_t near,
                             duct_candidate *merged)
{
    const duct_candidate *before = columns->items + columns->starts[column - 1];
    size_t before_count = columns->starts[column] - columns->starts[column - 1], at = 0, count = 0;
    size_t fresh = 0;
    for (size_t b = 0; b < before_count; b++) {
        uint32_t next = before[b].sample + 1;
        if (next >= self->library->starts[before[b].stroke + 1]) {
            continue;
        }
        while (at < near && nearest[at].sample < next) {
            merged[count++] = nearest[at++];
        }
        if (at < near && nearest[at].sample == next) {
            continue;
        }
        self->fresh[fresh] = next;
        self->places[fresh++] = (uint32_t)count;
        merged[count++] = (duct_candidate){next, before[b].stroke, 0};
    }
    while (at < near) {
        merged[count++] = nearest[at++];
    }
    duct_feature_distances(query, self->index->rows, self->index->dimensions, self->fresh, fresh,
                           self->fresh_distances);
    for (size_t i = 0; i < fresh; i++) {
        duct_candidate *candidate = &merged[self->places[i]];
        candidate->distance = self->fresh_distances[i];
        weigh(self, candidate, 1);
    }
    return count;
}

/* Leaves out the farthest beyond the most that a column may have. The k nearest are never
 * among these with an exact search. */
static size_t limit_width(const finder *self, duct_candidate *merged, size_t count)
{
    size_t most = MOST_TIMES_K * self->options->neighbours;
    if (count > most) {
        qsort(merged, count, sizeof *merged, by_distance);
        count = most;
        qsort(merged, count, sizeof *merged, by_sample);
    }
    return count;
}

static void vary(const finder *self, duct_candidate *candidates, size_t count)
{
    for (size_t i = 0; self->options->variation > 0 && i < count; i++) {
        candidates[i].distance += (float)(self->options->variation *
                                          duct_random_uniform(self->options->seed, self->options->stroke_id,
                                                              candidates[i].stroke, PURPOSE_VARIATION));
    }
}

static duct_status append(finder *self, duct_columns *columns, size_t column,
                          const duct_candidate *candidates, size_t count, duct_error *error)
{
    size_t start = columns->starts[column];
    void *items = columns->items;
    if (!duct_reserve(self->allocator, &items, &self->item_capacity, start + count, sizeof *columns->items)) {
        return duct_fail_memory(error);
    }
    columns->items = items;
    memcpy(columns->items + start, candidates, count * sizeof *candidates);
    columns->starts[column + 1] = start + count;
    return DUCT_OK;
}

static bool make_wide_room(finder *self, size_t k)
{
    void *rows = self->wide_rows, *distances = self->wide_distances, *wide = self->wide;
    bool good =
        duct_reserve(self->allocator, &rows, &self->wide_capacity[0], k, sizeof *self->wide_rows) &&
        duct_reserve(self->allocator, &distances, &self->wide_capacity[1], k, sizeof *self->wide_distances) &&
        duct_reserve(self->allocator, &wide, &self->wide_capacity[2], k, sizeof *self->wide);
    self->wide_rows = rows;
    self->wide_distances = distances;
    self->wide = wide;
    return good;
}

/* The k nearest by weighted distance. The search knows no weights, so it is asked for more until none that it
 * left out can be nearer: what it left out is as far as the last one found, and weighs no more than the
 * heaviest stroke. So the answer is exact as far as the search is. `found` is at least one. */
static duct_status find_weighted(finder *self, const float *query, const uint32_t *near,
                                 const float *distances, size_t *found, duct_error *error)
{
    size_t k = self->options->neighbours, asked = k, count = *found;
    for (;;) {
        if (!make_wide_room(self, count)) {
            return duct_fail_memory(error);
        }
        for (size_t n = 0; n < count; n++) {
            self->wide[n] =
                (duct_candidate){near[n], duct_library_stroke_of(self->library, near[n]), distances[n]};
        }
        float last = distances[count - 1];
        weigh(self, self->wide, count);
        qsort(self->wide, count, sizeof *self->wide, by_distance);
        if (count < asked || asked >= self->library->sample_count ||
            self->wide[k - 1].distance < (float)((double)last / self->most_weight)) {
            break;
        }
        asked = asked < self->library->sample_count / 4 ? 4 * asked : self->library->sample_count;
        if (!make_wide_room(self, asked)) {
            return duct_fail_memory(error);
        }
        size_t more = duct_search_nearest(self->index->search, query, asked, NULL, 0, self->wide_rows,
                                          self->wide_distances);
        if (more < count) {
            break; /* an approximate method that finds no more */
        }
        near = self->wide_rows;
        distances = self->wide_distances;
        count = more;
    }
    *found = count < k ? count : k;
    memcpy(self->nearest, self->wide, *found * sizeof *self->nearest);
    qsort(self->nearest, *found, sizeof *self->nearest, by_sample);
    return DUCT_OK;
}

/* The nearest as the search found them, by sample. */
static void take_nearest(finder *self, const uint32_t *near, const float *distances, size_t found)
{
    for (size_t n = 0; n < found; n++) {
        /* Put in order as they come: they are few. */
        size_t at = n;
        for (; at > 0 && self->nearest[at - 1].sample > near[n]; at--) {
            self->nearest[at] = self->nearest[at - 1];
        }
        self->nearest[at] = (duct_candidate){near[n], 0, distances[n]};
    }
    uint32_t stroke = 0;
    for (size_t n = 0; n < found; n++) {
        if (n == 0 || self->nearest[n].sample >= self->library->starts[stroke + 1]) {
            stroke = duct_library_stroke_of(self->library, self->nearest[n].sample);
        }
        self->nearest[n].stroke = stroke;
    }
}

/* Fills one column from what the search found for it. */
static duct_status fill_column(finder *self, const float *query, const uint32_t *near, const float *distances,
                               size_t found, duct_columns *columns, size_t column, duct_error *error)
{
    if (found == 0) {
        return duct_fail(error, DUCT_UNSUPPORTED, "the search found no neighbours; use the exact search");
    }
    if (self->library->weights != NULL) {
        duct_status status = find_weighted(self, query, near, distances, &found, error);
        if (status != DUCT_OK) {
            return status;
        }
    } else {
        take_nearest(self, near, distances, found);
    }
    const duct_candidate *all = self->nearest;
    size_t count = found;
    if (self->options->coherent && column > 0) {
        count = add_successors(self, query, columns, column, self->nearest, found, self->merged);
        count = limit_width(self, self->merged, count);
        all = self->merged;
    }
    return append(self, columns, column, all, count, error);
}

static duct_status fill(finder *self, const float *rows, duct_columns *columns, duct_error *error)
{
    size_t k = self->options->neighbours, dimensions = self->index->dimensions;
    duct_status status = DUCT_OK;
    for (size_t first = 0; status == DUCT_OK && first < columns->count; first += PIECE) {
        size_t count = columns->count - first < PIECE ? columns->count - first : PIECE;
        status = duct_pool_check(error);
        if (status != DUCT_OK) {
            break;
        }
        const duct_search_query query = {rows + first * dimensions, count, k, first, self->options->seed,
                                         self->options->stroke_id};
        status = duct_search_sequence(self->index->search, self->allocator, &query, self->near,
                                      self->distances, self->found, error);
        for (size_t i = 0; status == DUCT_OK && i < count; i++) {
            status = fill_column(self, query.rows + i * dimensions, self->near + i * k,
                                 self->distances + i * k, self->found[i], columns, first + i, error);
        }
    }
    if (status == DUCT_OK) {
        vary(self, columns->items, columns->starts[columns->count]);
    }
    return status;
}

duct_status duct_candidates_find(const duct_allocator *allocator, const duct_library *library,
                                 const duct_feature_index *index, const duct_candidate_options *options,
                                 const double *x, const double *y, size_t count, duct_columns *columns,
                                 duct_error *error)
{
    memset(columns, 0, sizeof *columns);
    columns->count = count;
    size_t k = options->neighbours, piece = count < PIECE ? count : PIECE;
    finder self = {.allocator = allocator, .library = library, .index = index, .options = options};
    for (size_t s = 0; library->weights != NULL && s < library->stroke_count; s++) {
        self.most_weight = fmax(self.most_weight, library->weights[s]);
    }
    float *rows = duct_alloc_raw(allocator, count * index->dimensions, sizeof *rows);
    columns->starts = duct_alloc(allocator, count + 1, sizeof *columns->starts);
    self.near = duct_alloc(allocator, piece * k, sizeof *self.near);
    self.distances = duct_alloc(allocator, piece * k, sizeof *self.distances);
    self.found = duct_alloc(allocator, piece, sizeof *self.found);
    self.nearest = duct_alloc(allocator, k, sizeof *self.nearest);
    size_t widest = (MOST_TIMES_K + 1) * k;
    self.merged = duct_alloc(allocator, widest, sizeof *self.merged);
    self.fresh = duct_alloc(allocator, 2 * widest, sizeof *self.fresh);
    self.fresh_distances = duct_alloc(allocator, widest, sizeof *self.fresh_distances);
    duct_status status;
    if (rows == NULL || columns->starts == NULL || self.near == NULL || self.distances == NULL ||
        self.found == NULL || self.nearest == NULL || self.merged == NULL || self.fresh == NULL ||
        self.fresh_distances == NULL) {
        status = duct_fail_memory(error);
    } else {
        self.places = self.fresh + widest;
        status = duct_features_compute(allocator, &options->features, x, y, count, rows, error);
    }
    if (status == DUCT_OK) {
        status = fill(&self, rows, columns, error);
    }
    duct_release(allocator, rows);
    duct_release(allocator, self.near);
    duct_release(allocator, self.distances);
    duct_release(allocator, self.found);
    duct_release(allocator, self.nearest);
    duct_release(allocator, self.merged);
    duct_release(allocator, self.fresh);
    duct_release(allocator, self.fresh_distances);
    duct_release(allocator, self.wide_rows);
    duct_release(allocator, self.wide_distances);
    duct_release(allocator, self.wide);
    if (status != DUCT_OK) {
        duct_columns_free(allocator, columns);
    }
    return status;
}

void duct_columns_free(const duct_allocator *allocator, duct_columns *columns)
{
    duct_release(allocator, columns->starts);
    duct_release(allocator, columns->items);
    memset(columns, 0, sizeof *columns);
}
