/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact search. Neighbouring rows are neighbouring samples of one stroke and so lie close together in feature
 * space: blocks of them have small bounding boxes, and most blocks are left out by one comparison of a query
 * with their box.
 *
 * Both loops run across rows (or boxes), never across dimensions, so each row's sum is formed in the same
 * order whatever the vector width: the same bits on every processor. */
#include "search/search_private.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

enum {
    LANES = 8, /* rows a block, and boxes a group */
    MOST_DIMENSIONS = 256
};

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__clang__)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

typedef struct {
    duct_search base;
    size_t block_count, group_count;
    float *blocks; /* [block][dimension][LANES] */
    /* The boxes' dimensions are in the order in which the rows spread most: what is too far shows early. */
    uint32_t *order; /* [dimension] */
    float *low;      /* [group][dimension][LANES]: boxes' lower corners */
    float *high;
} exact;

/* LANES floats side by side; the compiler turns them into what the processor has. */
typedef float lanes __attribute__((vector_size(LANES * sizeof(float)), aligned(sizeof(float))));
typedef int32_t masks __attribute__((vector_size(LANES * sizeof(int32_t))));

/* Squared distances of LANES rows. */
WIDE static void block_squares(const float *block, const float *query, size_t dimensions, float *squares)
{
    const lanes *rows = (const lanes *)block;
    lanes sum = {0};
    for (size_t d = 0; d < dimensions; d++) {
        lanes difference = query[d] - rows[d];
        sum += difference * difference;
    }
    memcpy(squares, &sum, sizeof sum);
}

/* By address: passing vectors by value would depend on the processor's calling convention. */
static inline bool any_within(const lanes *sum, float limit)
{
    masks within = *sum <= limit;
    int32_t any = 0;
    for (size_t lane = 0; lane < LANES; lane++) {
        any |= within[lane];
    }
    return any != 0;
}

/* Squared distances of LANES boxes: lower bounds for all rows in them. False, with the bounds incomplete, as
 * soon as all are above the limit. */
WIDE static bool group_bounds(const float *low, const float *high, const float *query, size_t dimensions,
                              float limit, float *bounds)
{
    enum { STRIDE = 8 };
    const lanes *lows = (const lanes *)low, *highs = (const lanes *)high;
    const lanes zero = {0};
    lanes sum = {0};
    for (size_t d = 0; d < dimensions;) {
        size_t stop = d + STRIDE < dimensions ? d + STRIDE : dimensions;
        for (; d < stop; d++) {
            lanes below = lows[d] - query[d], above = query[d] - highs[d];
            /* At most one of the two is positive: the distance from the box along this dimension. */
            lanes outside = (lanes)((masks)below & (below > zero)) + (lanes)((masks)above & (above > zero));
            sum += outside * outside;
        }
        if (!any_within(&sum, limit)) {
            return false;
        }
    }
    memcpy(bounds, &sum, sizeof sum);
    return true;
}

static void scan_block(const exact *self, size_t block, const float *query, duct_nearest *nearest)
{
    size_t dimensions = self->base.dimensions, first = block * LANES;
    float squares[LANES];
    block_squares(self->blocks + first * dimensions, query, dimensions, squares);
    for (size_t lane = 0; lane < LANES && first + lane < self->base.count; lane++) {
        if (duct_nearest_wants(nearest, squares[lane], (uint32_t)(first + lane))) {
            duct_nearest_put(nearest, squares[lane], (uint32_t)(first + lane));
        }
    }
}

/* The k-th smallest squared distance among the blocks of the hints: no row that is farther can be an answer.
 */
static float threshold_from(const exact *self, const float *query, size_t k, const uint32_t *hints,
                            size_t hint_count)
{
    enum { MOST = 256 };
    float squares[MOST];
    uint32_t rows[MOST];
    if (k > MOST || k == 0) {
        return INFINITY;
    }
    duct_nearest nearest = {rows, squares, 0, k};
    size_t dimensions = self->base.dimensions;
    for (size_t i = 0; i < hint_count; i++) {
        uint32_t row = hints[i];
        bool seen = row >= self->base.count;
        for (size_t n = 0; !seen && n < nearest.count; n++) {
            seen = rows[n] == row;
        }
        if (seen) {
            continue;
        }
        const float *block = self->blocks + row / LANES * LANES * dimensions;
        float square = 0;
        for (size_t d = 0; d < dimensions; d++) {
            float difference = query[d] - block[d * LANES + row % LANES];
            square += difference * difference;
        }
        if (duct_nearest_wants(&nearest, square, row)) {
            duct_nearest_put(&nearest, square, row);
        }
    }
    return nearest.count == k ? nearest.squares[0] : INFINITY;
}

static size_t exact_nearest(const duct_search *search, const float *query, size_t k, const uint32_t *hints,
                            size_t hint_count, uint32_t *rows, float *distances)
{
    const exact *self = (const exact *)search;
    size_t dimensions = search->dimensions;
    duct_nearest nearest = {rows, distances, 0, k};
    if (k == 0) {
        return 0;
    }
    const float slack = 1.0001f;
    float ordered[MOST_DIMENSIONS];
    for (size_t d = 0; d < dimensions; d++) {
        ordered[d] = query[self->order[d]];
    }
    float limit = threshold_from(self, query, k, hints, hint_count);
    for (size_t group = 0; group < self->group_count; group++) {
        float bounds[LANES];
        size_t at = group * LANES * dimensions;
        float most = nearest.count == k && nearest.squares[0] < limit ? nearest.squares[0] : limit;
        /* A box's bound is rounded differently from a row's distance: leave out only what is clearly farther.
         */
        if (!group_bounds(self->low + at, self->high + at, ordered, dimensions, most * slack, bounds)) {
            continue;
        }
        for (size_t lane = 0; lane < LANES && group * LANES + lane < self->block_count; lane++) {
            most = nearest.count == k && nearest.squares[0] < limit ? nearest.squares[0] : limit;
            if (bounds[lane] <= most * slack) {
                scan_block(self, group * LANES + lane, query, &nearest);
            }
        }
    }
    duct_nearest_finish(&nearest);
    return nearest.count;
}

static void exact_destroy(duct_search *search)
{
    exact *self = (exact *)search;
    const duct_allocator allocator = search->allocator;
    duct_release(&allocator, self->blocks);
    duct_release(&allocator, self->order);
    duct_release(&allocator, self->low);
    duct_release(&allocator, self->high);
    duct_release(&allocator, self);
}

static const duct_search_method exact_method = {exact_nearest, duct_search_one_by_one, exact_destroy};

/* Sorts the dimensions by falling variance of the rows. */
static void choose_order(exact *self)
{
    size_t dimensions = self->base.dimensions, count = self->base.count;
    double spread[MOST_DIMENSIONS];
    for (size_t d = 0; d < dimensions; d++) {
        double sum = 0, square = 0;
        for (size_t row = 0; row < count; row++) {
            double value = (double)self->base.rows[row * dimensions + d];
            sum += value;
            square += value * value;
        }
        spread[d] = square - sum * sum / (double)count;
        size_t at = d;
        for (; at > 0 && spread[self->order[at - 1]] < spread[d]; at--) {
            self->order[at] = self->order[at - 1];
        }
        self->order[at] = (uint32_t)d;
    }
}

static void fill_blocks(exact *self)
{
    size_t dimensions = self->base.dimensions, count = self->base.count, place[MOST_DIMENSIONS];
    for (size_t d = 0; d < dimensions; d++) {
        place[self->order[d]] = d;
    }
    for (size_t block = 0; block < self->block_count; block++) {
        float *to = self->blocks + block * LANES * dimensions;
        size_t box = block / LANES * LANES * dimensions + block % LANES;
        for (size_t d = 0; d < dimensions; d++) {
            float low = INFINITY, high = -INFINITY;
            for (size_t lane = 0; lane < LANES; lane++) {
                size_t row = block * LANES + lane;
                float value = self->base.rows[(row < count ? row : count - 1) * dimensions + d];
                to[d * LANES + lane] = value;
                low = value < low ? value : low;
                high = value > high ? value : high;
            }
            self->low[box + place[d] * LANES] = low;
            self->high[box + place[d] * LANES] = high;
        }
    }
}

duct_status duct_search_exact_new(const duct_allocator *allocator, const float *rows, size_t count,
                                  size_t dimensions, duct_search **search, duct_error *error)
{
    if (dimensions > MOST_DIMENSIONS) {
        return duct_fail(error, DUCT_UNSUPPORTED, "the exact search takes %d dimensions at most",
                         MOST_DIMENSIONS);
    }
    exact *self = duct_alloc(allocator, 1, sizeof *self);
    if (self == NULL) {
        return duct_fail_memory(error);
    }
    self->base = (duct_search){&exact_method, *allocator, rows, count, dimensions};
    self->block_count = (count + LANES - 1) / LANES;
    self->group_count = (self->block_count + LANES - 1) / LANES;
    size_t boxes = self->group_count * LANES * dimensions;
    self->blocks = duct_alloc(allocator, self->block_count * LANES * dimensions, sizeof(float));
    self->low = duct_alloc(allocator, boxes, sizeof(float));
    self->high = duct_alloc(allocator, boxes, sizeof(float));
    self->order = duct_alloc(allocator, dimensions, sizeof *self->order);
    if (self->blocks == NULL || self->low == NULL || self->high == NULL || self->order == NULL) {
        exact_destroy(&self->base);
        return duct_fail_memory(error);
    }
    choose_order(self);
    fill_blocks(self);
    *search = &self->base;
    return DUCT_OK;
}
