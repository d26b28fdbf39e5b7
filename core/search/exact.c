/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact search. Rows are ruled out by bounds: by the boxes of whole groups of leaves, and by their own few
 * coordinates (exact_private.h). What is left is compared in full.
 *
 * Bounds only rule out what is clearly too far, and every distance that counts is summed up dimension by
 * dimension, so the answer is the same bits whatever the order of the walk, the hints and the processor. */
#include "search/abreast.h"
#include "search/exact_private.h"

#include "base/error.h"
#include "base/wide.h"

#include <math.h>
#include <string.h>

enum {
    LANES = DUCT_EXACT_LANES,
    LEAF = DUCT_EXACT_LEAF,
    STEP = 8,     /* coordinates between two looks at what is left */
    MOST_K = 128, /* beyond, rows are kept in a heap */
    ROOM = 2 * MOST_K + 32,
    ABREAST = DUCT_ABREAST
};

/* Floats side by side; the compiler turns them into what the processor has. */
typedef float lanes __attribute__((vector_size(LANES * sizeof(float)), aligned(sizeof(float))));
typedef int32_t masks __attribute__((vector_size(LANES * sizeof(int32_t))));

/* The rows found so far. */
typedef struct {
    const duct_exact *index;
    const float *query;
    float place[DUCT_EXACT_MOST_COORDINATES];
    size_t k;
    float limit; /* squared distance: rows beyond it are no answers */
    float reach; /* the same for bounds, which are rounded differently */
    float slack; /* the part of `reach` that does not grow with the limit */
    /* k <= MOST_K: the rows within the limit as (squared distance, row), which order as numbers. */
    uint64_t keys[ROOM];
    size_t count, room;
    duct_nearest heap; /* k > MOST_K */
    uint32_t pending[LEAF + ABREAST];
    size_t pending_count;
} walk;

static uint64_t key_of(float square, uint32_t row)
{
    uint32_t bits;
    memcpy(&bits, &square, sizeof bits);
    return (uint64_t)bits << 32 | row;
}

static float square_of(uint64_t key)
{
    uint32_t bits = (uint32_t)(key >> 32);
    float square;
    memcpy(&square, &bits, sizeof square);
    return square;
}

WIDE_PART void set_limit(walk *self, float limit)
{
    self->limit = limit;
    self->reach = limit * 1.0005f + self->slack;
}

/* Sorts keys that all differ, by counting how many are below each. */
WIDE static void sort_keys(const uint64_t *keys, size_t count, uint64_t *sorted)
{
    for (size_t i = 0; i < count; i++) {
        uint64_t rank = 0, key = keys[i];
        for (size_t j = 0; j < count; j++) {
            rank += keys[j] < key;
        }
        sorted[rank] = key;
    }
}

/* Leaves only the k best. */
static void narrow(walk *self)
{
    uint64_t sorted[ROOM];
    sort_keys(self->keys, self->count, sorted);
    if (self->count > self->k) {
        self->count = self->k;
        set_limit(self, square_of(sorted[self->k - 1]));
    }
    memcpy(self->keys, sorted, self->count * sizeof *sorted);
}

static void keep(walk *self, float square, uint32_t row)
{
    if (!(square <= self->limit)) {
        return;
    }
    if (self->k <= MOST_K) {
        self->keys[self->count++] = key_of(square, row);
        if (self->count == self->room) {
            narrow(self);
        }
    } else if (duct_nearest_wants(&self->heap, square, row)) {
        duct_nearest_put(&self->heap, square, row);
        if (self->heap.count == self->k && self->heap.squares[0] < self->limit) {
            set_limit(self, self->heap.squares[0]);
        }
    }
}

/* Compares the last `many` of the pending rows in full. */
WIDE_PART void compare_pending(walk *self, size_t many)
{
    const duct_search *base = &self->index->base;
    const float *rows[ABREAST];
    float squares[ABREAST];
    size_t first = self->pending_count - many;
    for (size_t i = 0; i < ABREAST; i++) {
        rows[i] = base->rows + self->pending[first + (i < many ? i : 0)] * base->dimensions;
    }
    duct_squares_abreast(self->query, rows, base->dimensions, squares);
    self->pending_count = first;
    for (size_t i = 0; i < many; i++) {
        keep(self, squares[i], self->pending[first + i]);
    }
}

/* A bit for each lane that is within the limit. */
WIDE_PART unsigned within(const lanes *bounds, float limit)
{
    masks in = *bounds <= limit;
#if defined(__SSE__)
    duct_fours low, high;
    memcpy(&low, &in, sizeof low);
    memcpy(&high, (const char *)&in + sizeof low, sizeof high);
    return (unsigned)__builtin_ia32_movmskps(low) | (unsigned)__builtin_ia32_movmskps(high) << 4;
#else
    unsigned bits = 0;
    for (unsigned lane = 0; lane < LANES; lane++) {
        bits |= (unsigned)in[lane] & 1u << lane;
    }
    return bits;
#endif
}

/* Squared distances from LANES boxes; a bit for each that is within reach. */
WIDE_PART unsigned near_boxes(const walk *self, const float *box, float *bounds)
{
    const lanes *boxes = (const lanes *)box, zero = {0};
    lanes sum = {0};
    unsigned near = 0;
    for (size_t first = 0; first < self->index->coordinates; first += STEP) {
        for (size_t c = first; c < first + STEP; c++) {
            lanes off = boxes[2 * c] - self->place[c];
            lanes outside = (lanes)((masks)off & INT32_MAX) - boxes[2 * c + 1];
            outside = (lanes)((masks)outside & (outside > zero));
            sum += outside * outside;
        }
        near = within(&sum, self->reach);
        if (near == 0) {
            break;
        }
    }
    memcpy(bounds, &sum, sizeof sum);
    return near;
}

/* Rows of a leaf that their coordinates do not rule out become pending. */
WIDE_PART void scan_leaf(walk *self, size_t leaf)
{
    const duct_exact *index = self->index;
    const lanes *places = (const lanes *)(index->places + leaf * index->coordinates * LEAF);
    const uint32_t *order = index->order + leaf * LEAF;
    lanes low = {0}, high = {0};
    unsigned near = 0;
    for (size_t first = 0; first < index->coordinates; first += STEP) {
        for (size_t c = first; c < first + STEP; c++) {
            lanes a = places[2 * c] - self->place[c], b = places[2 * c + 1] - self->place[c];
            low += a * a;
            high += b * b;
        }
        near = within(&low, self->reach) | within(&high, self->reach) << LANES;
        if (near == 0) {
            return;
        }
    }
    for (; near != 0; near &= near - 1) {
        self->pending[self->pending_count++] = order[__builtin_ctz(near)];
    }
    while (self->pending_count >= ABREAST) {
        compare_pending(self, ABREAST);
    }
}

/* The box among those left that is to be looked into next. */
WIDE_PART unsigned next_box(unsigned left, const float *bounds, bool nearest_first)
{
    unsigned next = (unsigned)__builtin_ctz(left);
    for (left &= left - 1; nearest_first && left != 0; left &= left - 1) {
        unsigned lane = (unsigned)__builtin_ctz(left);
        next = bounds[lane] < bounds[next] ? lane : next;
    }
    return next;
}

/* Walks the boxes from the outermost inwards. */
WIDE_PART void walk_boxes(walk *self, bool nearest_first)
{
    typedef struct {
        float bounds[LANES];
        size_t group;
        unsigned left; /* a bit for each box that has still to be looked into */
    } stage;
    const duct_exact *index = self->index;
    const size_t size = index->coordinates * 2 * LANES;
    stage path[DUCT_EXACT_LEVELS];
    size_t top = index->level_count - 1, level = top;
    path[top].group = 0;
    path[top].left = near_boxes(self, index->levels[top].boxes, path[top].bounds);
    for (;;) {
        stage *here = &path[level];
        if (here->left == 0) {
            if (level == top) {
                break;
            }
            level++;
            continue;
        }
        unsigned next = next_box(here->left, here->bounds, nearest_first);
        here->left &= ~(1u << next);
        if (!(here->bounds[next] <= self->reach)) {
            continue; /* the limit has come down since */
        }
        size_t inner = here->group * LANES + next;
        if (level == 0) {
            scan_leaf(self, inner);
            continue;
        }
        level--;
        path[level].group = inner;
        path[level].left = near_boxes(self, index->levels[level].boxes + inner * size, path[level].bounds);
    }
    if (self->pending_count > 0) {
        compare_pending(self, self->pending_count);
    }
}

/* The k-th smallest distance among k of the hints: no row that is farther can be an answer. */
WIDE_PART void limit_by_hints(walk *self, const uint32_t *hints, size_t hint_count)
{
    const duct_search *base = &self->index->base;
    /* Which rows were seen, by their last bits: a hint that only looks like one seen before is left out. */
    uint64_t seen[32] = {0};
    float most = 0;
    size_t taken = 0, waiting = 0;
    const float *rows[ABREAST];
    for (size_t i = 0; i < hint_count && taken < self->k; i++) {
        uint32_t row = hints[i], at = row % (64 * 32);
        uint64_t bit = (uint64_t)1 << (at % 64);
        if (row >= base->count || (seen[at / 64] & bit) != 0) {
            continue;
        }
        seen[at / 64] |= bit;
        rows[waiting++] = base->rows + row * base->dimensions;
        taken++;
        if (waiting == ABREAST || taken == self->k) {
            float squares[ABREAST];
            for (; waiting < ABREAST; waiting++) {
                rows[waiting] = rows[0];
            }
            duct_squares_abreast(self->query, rows, base->dimensions, squares);
            for (size_t n = 0; n < ABREAST; n++) {
                most = squares[n] > most ? squares[n] : most;
            }
            waiting = 0;
        }
    }
    if (taken == self->k) {
        set_limit(self, most);
    }
}

WIDE static void find(walk *self, const uint32_t *hints, size_t hint_count)
{
    limit_by_hints(self, hints, hint_count);
    /* Without a limit to begin with, one comes the sooner the nearer the first rows are. */
    if (self->limit < FLT_MAX) {
        walk_boxes(self, false);
    } else {
        walk_boxes(self, true);
    }
}

static size_t scan_all(const duct_search *search, const float *query, size_t k, uint32_t *rows,
                       float *distances)
{
    duct_nearest nearest = {rows, distances, 0, k};
    for (size_t row = 0; row < search->count; row++) {
        float square =
            duct_feature_square(query, search->rows + row * search->dimensions, search->dimensions);
        if (duct_nearest_wants(&nearest, square, (uint32_t)row)) {
            duct_nearest_put(&nearest, square, (uint32_t)row);
        }
    }
    duct_nearest_finish(&nearest);
    return nearest.count;
}

static size_t exact_nearest(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                            size_t hint_count, uint32_t *rows, float *distances)
{
    const duct_exact *index = (const duct_exact *)search;
    if (k == 0) {
        return 0;
    }
    walk self;
    if (index->plain || !duct_exact_place(index, query, self.place)) {
        return scan_all(search, query, k, rows, distances);
    }
    double largest = index->largest;
    for (size_t c = 0; c < index->coordinates; c++) {
        largest = fmax(largest, fabs((double)self.place[c]));
    }
    /* Coordinates are rounded by up to 2^-24 of the largest, so a distance by them may be off by 1e-6 of it;
     * (d + e)^2 <= 1.0001 d^2 + 10001 e^2. */
    self.slack = (float)(1e-8 * largest * largest) + FLT_MIN;
    self.index = index;
    self.query = query;
    self.k = k;
    self.count = self.pending_count = 0;
    self.room = 2 * k + 32;
    self.heap = (duct_nearest){rows, distances, 0, k};
    self.limit = self.reach = FLT_MAX;
    find(&self, hints, hint_count);
    if (k > MOST_K) {
        duct_nearest_finish(&self.heap);
        return self.heap.count;
    }
    narrow(&self);
    for (size_t i = 0; i < self.count; i++) {
        rows[i] = (uint32_t)self.keys[i];
        distances[i] = sqrtf(square_of(self.keys[i]));
    }
    return self.count;
}

static void exact_destroy(duct_search *search)
{
    const duct_allocator allocator = search->allocator;
    duct_exact_release((duct_exact *)search);
    duct_release(&allocator, search);
}

static const duct_search_method exact_method = {exact_nearest, duct_search_one_by_one, exact_destroy};

duct_status duct_search_exact_new(const duct_allocator *allocator, const float *rows, size_t count,
                                  size_t dimensions, duct_search **search, duct_error *error)
{
    if (dimensions > DUCT_EXACT_MOST_DIMENSIONS) {
        return duct_fail(error, DUCT_UNSUPPORTED, "the exact search takes %d dimensions at most",
                         DUCT_EXACT_MOST_DIMENSIONS);
    }
    duct_exact *self = duct_alloc(allocator, 1, sizeof *self);
    if (self == NULL) {
        return duct_fail_memory(error);
    }
    self->base = (duct_search){&exact_method, *allocator, rows, count, dimensions};
    duct_status status = duct_exact_build(self, error);
    if (status != DUCT_OK) {
        exact_destroy(&self->base);
        return status;
    }
    *search = &self->base;
    return DUCT_OK;
}
