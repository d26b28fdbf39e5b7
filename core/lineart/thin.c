/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Thinning after Guo and Hall (Parallel thinning with two-subiteration algorithms, 1989, algorithm A1), 64
 * pixels at a time: each condition on a pixel's eight neighbours is an expression on words of bits. Rows
 * around which nothing changed in the last round are passed over. */
#include "lineart/lineart_private.h"

#include "base/error.h"
#include "base/pool.h"

#include <math.h>
#include <string.h>

struct rows {
    const uint64_t *above, *here, *below; /* as they were before this pass */
    size_t stride;
};

/* The left and the right neighbour of each bit. */
static inline uint64_t west(const uint64_t *row, size_t w)
{
    return (row[w] << 1) | (w > 0 ? row[w - 1] >> 63 : 0);
}

static inline uint64_t east(const uint64_t *row, size_t w, size_t stride)
{
    return (row[w] >> 1) | (w + 1 < stride ? row[w + 1] << 63 : 0);
}

/* Bits where exactly one of the four is set. */
static inline uint64_t exactly_one(uint64_t a, uint64_t b, uint64_t c, uint64_t d)
{
    uint64_t pairs = (a & b) | (c & d) | ((a | b) & (c | d));
    return (a | b | c | d) & ~pairs;
}

static inline uint64_t two_or_more(uint64_t a, uint64_t b, uint64_t c, uint64_t d)
{
    return (a & b) | (c & d) | ((a | b) & (c | d));
}

/* The pixels of a word that this pass takes away. */
static uint64_t removable(const struct rows *rows, size_t w, bool second)
{
    uint64_t p2 = rows->above[w], p6 = rows->below[w];
    uint64_t p3 = east(rows->above, w, rows->stride), p9 = west(rows->above, w);
    uint64_t p4 = east(rows->here, w, rows->stride), p8 = west(rows->here, w);
    uint64_t p5 = east(rows->below, w, rows->stride), p7 = west(rows->below, w);
    uint64_t once = exactly_one(~p2 & (p3 | p4), ~p4 & (p5 | p6), ~p6 & (p7 | p8), ~p8 & (p9 | p2));
    uint64_t a1 = p9 | p2, a2 = p3 | p4, a3 = p5 | p6, a4 = p7 | p8;
    uint64_t b1 = p2 | p3, b2 = p4 | p5, b3 = p6 | p7, b4 = p8 | p9;
    uint64_t enough = two_or_more(a1, a2, a3, a4) & two_or_more(b1, b2, b3, b4);
    uint64_t too_many = a1 & a2 & a3 & a4 & b1 & b2 & b3 & b4;
    uint64_t kept = second ? (p2 | p3 | ~p5) & p4 : (p6 | p7 | ~p9) & p8;
    return rows->here[w] & once & enough & ~too_many & ~kept;
}

struct thinner {
    duct_bitmap *bitmap;
    uint64_t *above, *here;  /* copies of rows as they were */
    uint8_t *active, *woken; /* rows to look at in this round and the next; with the rim */
};

static bool thin_row(struct thinner *thinner, int y, bool second)
{
    uint64_t *row = duct_bitmap_row(thinner->bitmap, y);
    const struct rows rows = {thinner->above, thinner->here, duct_bitmap_row(thinner->bitmap, y + 1),
                              thinner->bitmap->stride};
    bool changed = false;
    for (size_t w = 0; w < rows.stride; w++) {
        if (rows.here[w] != 0) {
            uint64_t gone = removable(&rows, w, second);
            row[w] &= ~gone;
            changed = changed || gone != 0;
        }
    }
    return changed;
}

static bool thin_pass(struct thinner *thinner, bool second)
{
    const duct_bitmap *bitmap = thinner->bitmap;
    size_t bytes = bitmap->stride * sizeof(uint64_t);
    bool changed = false;
    memset(thinner->above, 0, bytes);
    for (int y = 0; y < bitmap->height; y++) {
        memcpy(thinner->here, duct_bitmap_row(bitmap, y), bytes);
        if ((thinner->active[y + 1] || thinner->woken[y + 1]) && thin_row(thinner, y, second)) {
            memset(thinner->woken + y, 1, 3);
            changed = true;
        }
        uint64_t *swapped = thinner->above;
        thinner->above = thinner->here;
        thinner->here = swapped;
    }
    return changed;
}

/* Takes away pixels whose neighbours are all set, and those around them: what is left of areas. */
static void drop_areas(struct thinner *thinner, duct_bitmap *inner)
{
    duct_bitmap *bitmap = thinner->bitmap;
    for (int y = 0; y < bitmap->height; y++) {
        const struct rows rows = {duct_bitmap_row(bitmap, y - 1), duct_bitmap_row(bitmap, y),
                                  duct_bitmap_row(bitmap, y + 1), bitmap->stride};
        uint64_t *to = duct_bitmap_row(inner, y);
        for (size_t w = 0; w < bitmap->stride; w++) {
            to[w] = rows.above[w] & rows.here[w] & rows.below[w] & west(rows.above, w) & west(rows.here, w) &
                    west(rows.below, w) & east(rows.above, w, rows.stride) & east(rows.here, w, rows.stride) &
                    east(rows.below, w, rows.stride);
        }
    }
    for (int y = 0; y < bitmap->height; y++) {
        uint64_t *row = duct_bitmap_row(bitmap, y);
        for (int dy = -1; dy <= 1; dy++) {
            const uint64_t *from = duct_bitmap_row(inner, y + dy);
            for (size_t w = 0; w < bitmap->stride; w++) {
                row[w] &= ~(from[w] | west(from, w) | east(from, w, bitmap->stride));
            }
        }
    }
}

static duct_status thin_all(const duct_context *context, struct thinner *thinner, int rounds,
                            duct_error *error)
{
    size_t lines = (size_t)thinner->bitmap->height + 2;
    bool changed = true;
    memset(thinner->active, 1, lines);
    for (int round = 0; changed && round < rounds; round++) {
        duct_status status = duct_progress_report(context, 0.45 + 0.25 * (1 - 1 / (1 + 0.1 * round)), error);
        if (status != DUCT_OK) {
            return status;
        }
        memset(thinner->woken, 0, lines);
        changed = thin_pass(thinner, false);
        changed = thin_pass(thinner, true) || changed;
        uint8_t *swapped = thinner->active;
        thinner->active = thinner->woken;
        thinner->woken = swapped;
    }
    duct_bitmap inner;
    if (!changed) {
        return DUCT_OK;
    }
    if (!duct_bitmap_init(&inner, thinner->bitmap->allocator, thinner->bitmap->width,
                          thinner->bitmap->height)) {
        return duct_fail_memory(error);
    }
    drop_areas(thinner, &inner);
    duct_bitmap_done(&inner);
    return DUCT_OK;
}

duct_status duct_thin(const duct_context *context, duct_bitmap *bitmap, double widest, duct_error *error)
{
    const duct_allocator *allocator = bitmap->allocator;
    size_t lines = (size_t)bitmap->height + 2;
    struct thinner thinner = {bitmap, NULL, NULL, NULL, NULL};
    thinner.above = duct_alloc(allocator, bitmap->stride, sizeof *thinner.above);
    thinner.here = duct_alloc(allocator, bitmap->stride, sizeof *thinner.here);
    thinner.active = duct_alloc(allocator, lines, 1);
    thinner.woken = duct_alloc(allocator, lines, 1);
    /* A round takes a pixel off each side; one more to see that nothing is left to take. */
    int rounds = (int)ceil(widest / 2) + 1;
    duct_status status =
        thinner.above != NULL && thinner.here != NULL && thinner.active != NULL && thinner.woken != NULL
            ? thin_all(context, &thinner, rounds, error)
            : duct_fail_memory(error);
    duct_release(allocator, thinner.above);
    duct_release(allocator, thinner.here);
    duct_release(allocator, thinner.active);
    duct_release(allocator, thinner.woken);
    return status;
}
