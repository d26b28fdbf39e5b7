/* SPDX-License-Identifier: GPL-3.0-or-later */
/* PatchMatch (Barnes, Shechtman, Goldman, Finkelstein: "The generalized PatchMatch correspondence algorithm",
 * 2010) over the 1-D domain of samples: "HelpingHand" section 4.2. All samples of a query stroke are searched
 * together. Each begins with k rows by chance; then, pass after pass, forward and backward in turn, it tries
 * what follows (or precedes) its neighbour's rows in their library strokes, and rows by chance around its
 * own, ever nearer. What one sample finds so spreads along the whole stroke.
 *
 * It needs no index, and its time hardly grows with the library; its answers are approximate. Chance comes
 * from (seed, stroke, sample, purpose) alone. */
#include "search/search_private.h"

#include "base/error.h"

#include <ductus/random.h>

#include <string.h>

/* The paper saw convergence in about five passes; the sixth is for short strokes, along which little spreads.
 * On recordings of 10000 samples nine in ten of the 20 nearest are found (eight in ten with shape contexts),
 * and those found are 1 to 4 hundredths farther on average; of 150000 samples, half are found, and those are
 * a tenth farther. Libraries of up to SMALL times k rows are compared whole: nothing is saved there. */
enum { PASSES = 6, SMALL = 8 };

enum { PURPOSE_SEARCH = 2 }; /* 1 is the variation of candidates */

typedef struct {
    duct_search base;
    unsigned char *edges; /* by row: FIRST and LAST of its stroke */
} patchmatch;

enum { FIRST = 1, LAST = 2 };

typedef float quad __attribute__((vector_size(4 * sizeof(float)), aligned(sizeof(float))));

/* The squared distance, summed up in four lanes: quick, and the same on every processor, but not the bits of
 * duct_feature_distance(). */
static float quick_square(const float *query, const float *row, size_t dimensions)
{
    quad sum = {0}, more = {0};
    size_t d = 0;
    for (; d + 8 <= dimensions; d += 8) {
        quad a = *(const quad *)(query + d) - *(const quad *)(row + d);
        quad b = *(const quad *)(query + d + 4) - *(const quad *)(row + d + 4);
        sum += a * a;
        more += b * b;
    }
    sum += more;
    float square = (sum[0] + sum[1]) + (sum[2] + sum[3]);
    for (; d < dimensions; d++) {
        float difference = query[d] - row[d];
        square += difference * difference;
    }
    return square;
}

/* Keeps a row if it is among the best so far and not kept already. */
static void offer(const duct_search *search, const float *query, duct_nearest *nearest, uint32_t row)
{
    bool kept = false;
    for (size_t n = 0; n < nearest->count; n++) {
        kept |= nearest->rows[n] == row;
    }
    if (kept) {
        return;
    }
    float square = quick_square(query, search->rows + (size_t)row * search->dimensions, search->dimensions);
    if (duct_nearest_wants(nearest, square, row)) {
        duct_nearest_put(nearest, square, row);
    }
}

/* A search under way. */
typedef struct {
    const patchmatch *index;
    const duct_search_query *query;
    size_t k;
    duct_nearest *nearest; /* by query sample */
    uint32_t *around;      /* room for k: the rows of the sample at work */
} work;

static const float *query_row(const work *self, size_t i)
{
    return self->query->rows + i * self->index->base.dimensions;
}

static uint64_t draw(const work *self, size_t i, uint64_t number)
{
    return duct_random_bits(self->query->seed, self->query->stroke_id, self->query->first + i,
                            ((uint64_t)PURPOSE_SEARCH << 32) + number);
}

/* A number below `count`, of 32 random bits. */
static uint32_t below(uint32_t bits, size_t count)
{
    return (uint32_t)(((uint64_t)bits * count) >> 32);
}

static void begin(const work *self, size_t i)
{
    size_t count = self->index->base.count;
    for (size_t n = 0; n < self->k; n++) {
        size_t before = self->nearest[i].count;
        uint32_t row = below((uint32_t)(draw(self, i, n) >> 32), count);
        while (self->nearest[i].count == before) {
            offer(&self->index->base, query_row(self, i), &self->nearest[i], row);
            row = row + 1 < count ? row + 1 : 0;
        }
    }
}

/* What comes after (forward) or before the rows of the sample before (or after) this one. */
static void propagate(const work *self, size_t i, size_t from, bool forward)
{
    const duct_nearest *neighbour = &self->nearest[from];
    for (size_t n = 0; n < neighbour->count; n++) {
        uint32_t row = neighbour->rows[n];
        if ((self->index->edges[row] & (forward ? LAST : FIRST)) == 0) {
            offer(&self->index->base, query_row(self, i), &self->nearest[i], forward ? row + 1 : row - 1);
        }
    }
}

/* Rows by chance around those kept, in windows that shrink from the whole library down to the next row. */
static void search_around(const work *self, size_t i, uint64_t pass)
{
    size_t count = self->index->base.count;
    duct_nearest *nearest = &self->nearest[i];
    memcpy(self->around, nearest->rows, nearest->count * sizeof *self->around);
    uint64_t number = (pass + 1) << 16;
    for (size_t n = 0; n < self->k; n++) {
        size_t row = self->around[n];
        uint64_t bits = 0;
        unsigned left = 0;
        for (size_t window = count / 2; window > 0; window /= 2) {
            if (left == 0) {
                bits = draw(self, i, number++);
            }
            size_t low = row > window ? row - window : 0;
            size_t high = row + window < count ? row + window : count - 1;
            /* Any row of the window but the one in its middle. */
            size_t chosen = low + below((uint32_t)(bits >> 32 * left), high - low);
            left ^= 1;
            offer(&self->index->base, query_row(self, i), nearest, (uint32_t)(chosen + (chosen >= row)));
        }
    }
}

static void run_pass(const work *self, uint64_t pass)
{
    size_t count = self->query->count;
    bool forward = pass % 2 == 0;
    for (size_t step = 0; step < count; step++) {
        size_t i = forward ? step : count - 1 - step;
        if (step > 0) {
            propagate(self, i, forward ? i - 1 : i + 1, forward);
        }
        search_around(self, i, pass);
    }
}

/* Replaces the quick distances by those that every method gives, and sorts. */
static void finish(const duct_search *search, const float *query, duct_nearest *nearest)
{
    size_t count = nearest->count;
    nearest->count = 0;
    for (size_t n = 0; n < count; n++) {
        uint32_t row = nearest->rows[n];
        duct_nearest_put(
            nearest,
            duct_feature_square(query, search->rows + (size_t)row * search->dimensions, search->dimensions),
            row);
    }
    duct_nearest_finish(nearest);
}

/* One query alone has no neighbour to learn from: all rows are compared. */
static size_t patchmatch_nearest(const duct_search *search, const float *query, size_t k,
                                 const uint32_t *hints, size_t hint_count, uint32_t *rows, float *distances)
{
    (void)hints;
    (void)hint_count;
    duct_nearest nearest = {rows, distances, 0, k};
    for (uint32_t row = 0; k > 0 && row < search->count; row++) {
        float square =
            duct_feature_square(query, search->rows + (size_t)row * search->dimensions, search->dimensions);
        if (duct_nearest_wants(&nearest, square, row)) {
            duct_nearest_put(&nearest, square, row);
        }
    }
    duct_nearest_finish(&nearest);
    return nearest.count;
}

static duct_status patchmatch_sequence(const duct_search *search, const duct_allocator *allocator,
                                       const duct_search_query *query, uint32_t *rows, float *distances,
                                       size_t *found, duct_error *error)
{
    size_t k = query->k;
    if (search->count <= SMALL * k) {
        return duct_search_one_by_one(search, allocator, query, rows, distances, found, error);
    }
    work self = {(const patchmatch *)search, query, k, NULL, NULL};
    self.nearest = duct_alloc(allocator, query->count, sizeof *self.nearest);
    self.around = duct_alloc(allocator, k, sizeof *self.around);
    duct_status status = DUCT_OK;
    if (self.nearest == NULL || self.around == NULL) {
        status = duct_fail_memory(error);
    } else {
        for (size_t i = 0; i < query->count; i++) {
            self.nearest[i] = (duct_nearest){rows + i * k, distances + i * k, 0, k};
            begin(&self, i);
        }
        for (uint64_t pass = 0; pass < PASSES; pass++) {
            run_pass(&self, pass);
        }
        for (size_t i = 0; i < query->count; i++) {
            finish(search, query_row(&self, i), &self.nearest[i]);
            found[i] = self.nearest[i].count;
        }
    }
    duct_release(allocator, self.nearest);
    duct_release(allocator, self.around);
    return status;
}

static void patchmatch_destroy(duct_search *search)
{
    const duct_allocator allocator = search->allocator;
    duct_release(&allocator, ((patchmatch *)search)->edges);
    duct_release(&allocator, search);
}

static const duct_search_method patchmatch_method = {patchmatch_nearest, patchmatch_sequence,
                                                     patchmatch_destroy};

duct_status duct_search_patchmatch_new(const duct_allocator *allocator, const float *rows, size_t count,
                                       size_t dimensions, const uint32_t *starts, duct_search **search,
                                       duct_error *error)
{
    patchmatch *self = duct_alloc(allocator, 1, sizeof *self);
    if (self == NULL) {
        return duct_fail_memory(error);
    }
    self->base = (duct_search){&patchmatch_method, *allocator, rows, count, dimensions};
    self->edges = duct_alloc(allocator, count, sizeof *self->edges);
    if (self->edges == NULL) {
        patchmatch_destroy(&self->base);
        return duct_fail_memory(error);
    }
    self->edges[0] |= FIRST;
    self->edges[count - 1] |= LAST;
    for (size_t s = 1; starts != NULL && starts[s] < count; s++) {
        self->edges[starts[s]] |= FIRST;
        self->edges[starts[s] - 1] |= LAST;
    }
    *search = &self->base;
    return DUCT_OK;
}
