/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact search. Rows are ruled out by bounds: by the boxes of whole groups of leaves, and by their own few
 * coordinates (exact_private.h). What is left is compared in full.
 *
 * Bounds only rule out what is clearly too far, and every distance that counts is summed up dimension by
 * dimension, so the answer is the same bits whatever the order of the walk, the hints and the processor. */
#include "search/exact_private.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

enum {
    LANES = DUCT_EXACT_LANES,
    LEAF = DUCT_EXACT_LEAF,
    MOST_K = 128, /* beyond, rows are kept in a heap */
    ROOM = 2 * MOST_K + 32,
    ABREAST = 4 /* rows whose sums are formed side by side */
};

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif
/* Part of the functions above, whatever they are compiled for. */
#define INLINE static inline __attribute__((always_inline))

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

INLINE void set_limit(walk *self, float limit)
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

/* Squared distances of ABREAST rows, each summed up in the order of the dimensions. */
INLINE void squares_abreast(const float *query, const float *const *rows, size_t dimensions, float *squares)
{
    float a = 0, b = 0, c = 0, d = 0;
    const float *p = rows[0], *q = rows[1], *r = rows[2], *s = rows[3];
    for (size_t i = 0; i < dimensions; i++) {
        float value = query[i], x = value - p[i], y = value - q[i], z = value - r[i], w = value - s[i];
        a += x * x;
        b += y * y;
        c += z * z;
        d += w * w;
    }
    squares[0] = a;
    squares[1] = b;
    squares[2] = c;
    squares[3] = d;
}

/* Compares the last `many` of the pending rows in full. */
INLINE void compare_pending(walk *self, size_t many)
{
    const duct_search *base = &self->index->base;
    const float *rows[ABREAST];
    float squares[ABREAST];
    size_t first = self->pending_count - many;
    for (size_t i = 0; i < ABREAST; i++) {
        rows[i] = base->rows + self->pending[first + (i < many ? i : 0)] * base->dimensions;
    }
    squares_abreast(self->query, rows, base->dimensions, squares);
    self->pending_count = first;
    for (size_t i = 0; i < many; i++) {
        keep(self, squares[i], self->pending[first + i]);
    }
}

/* Squared distances from LANES boxes. */
INLINE void box_bounds(const walk *self, const float *box, lanes *bounds)
{
    const lanes *boxes = (const lanes *)box;
    const lanes zero = {0};
    lanes sum = {0};
    for (size_t c = 0; c < self->index->coordinates; c++) {
        lanes off = boxes[2 * c] - self->place[c];
        lanes outside = (lanes)((masks)off & INT32_MAX) - boxes[2 * c + 1];
        outside = (lanes)((masks)outside & (outside > zero));
        sum += outside * outside;
    }
    *bounds = sum;
}

/* A bit for each lane that is within the limit. */
INLINE unsigned within(const lanes *bounds, float limit)
{
    masks in = *bounds <= limit;
    unsigned bits = 0;
    for (unsigned lane = 0; lane < LANES; lane++) {
        bits |= (unsigned)in[lane] & 1u << lane;
    }
    return bits;
}

/* Rows of a leaf that their coordinates do not rule out become pending. */
INLINE void scan_leaf(walk *self, size_t leaf)
{
    const duct_exact *index = self->index;
    const lanes *places = (const lanes *)(index->places + leaf * index->coordinates * LEAF);
    const uint32_t *order = index->order + leaf * LEAF;
    lanes low = {0}, high = {0};
    for (size_t c = 0; c < index->coordinates; c++) {
        lanes a = places[2 * c] - self->place[c], b = places[2 * c + 1] - self->place[c];
        low += a * a;
        high += b * b;
    }
    unsigned near = within(&low, self->reach) | within(&high, self->reach) << LANES;
    for (; near != 0; near &= near - 1) {
        self->pending[self->pending_count++] = order[__builtin_ctz(near)];
    }
    while (self->pending_count >= ABREAST) {
        compare_pending(self, ABREAST);
    }
}

/* Walks the boxes from the outermost inwards, the nearest first. */
WIDE static void walk_boxes(walk *self)
{
    typedef struct {
        float bounds[LANES];
        size_t group;
        unsigned left; /* a bit for each box that has still to be looked into */
    } place;
    const duct_exact *index = self->index;
    const size_t size = index->coordinates * 2 * LANES;
    place path[DUCT_EXACT_LEVELS];
    size_t top = index->level_count - 1, level = top;
    bool fresh = true;
    path[top].group = 0;
    for (;;) {
        place *here = &path[level];
        if (fresh) {
            lanes bounds;
            box_bounds(self, index->levels[level].boxes + here->group * size, &bounds);
            here->left = within(&bounds, self->reach);
            memcpy(here->bounds, &bounds, sizeof bounds);
        }
        fresh = false;
        unsigned nearest = LANES;
        for (unsigned left = here->left; left != 0; left &= left - 1) {
            unsigned lane = (unsigned)__builtin_ctz(left);
            nearest = nearest == LANES || here->bounds[lane] < here->bounds[nearest] ? lane : nearest;
        }
        if (nearest == LANES || !(here->bounds[nearest] <= self->reach)) {
            if (level == top) {
                break;
            }
            level++;
            continue;
        }
        here->left &= ~(1u << nearest);
        size_t inner = here->group * LANES + nearest;
        if (level == 0) {
            scan_leaf(self, inner);
        } else {
            level--;
            path[level].group = inner;
            fresh = true;
        }
    }
    if (self->pending_count > 0) {
        compare_pending(self, self->pending_count);
    }
}

/* The k-th smallest distance among k of the hints: no row that is farther can be an answer. */
WIDE static void limit_by_hints(walk *self, const uint32_t *hints, size_t hint_count)
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
            squares_abreast(self->query, rows, base->dimensions, squares);
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
    limit_by_hints(&self, hints, hint_count);
    walk_boxes(&self);
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
