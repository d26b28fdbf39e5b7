/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LINEART_BITMAP_H
#define DUCTUS_LINEART_BITMAP_H

#include "base/memory.h"

#include <stdint.h>

/* A picture of bits with a rim of one empty pixel, so that every pixel has eight neighbours. */
typedef struct duct_bitmap {
    const duct_allocator *allocator;
    int width, height;
    size_t stride;   /* words a row */
    uint64_t *words; /* height + 2 rows; pixel x of a row is bit x + 1 */
} duct_bitmap;

/* All bits 0; false without memory. */
bool duct_bitmap_init(duct_bitmap *bitmap, const duct_allocator *allocator, int width, int height);
bool duct_bitmap_copy(duct_bitmap *copy, const duct_bitmap *bitmap);
void duct_bitmap_done(duct_bitmap *bitmap);

/* The row's words; y from -1 to height. */
static inline uint64_t *duct_bitmap_row(const duct_bitmap *bitmap, int y)
{
    return bitmap->words + (size_t)(y + 1) * bitmap->stride;
}

/* x from -1 to width, y from -1 to height. */
static inline bool duct_bitmap_get(const duct_bitmap *bitmap, int x, int y)
{
    return (duct_bitmap_row(bitmap, y)[(size_t)(x + 1) / 64] >> ((unsigned)(x + 1) % 64)) & 1;
}

static inline void duct_bitmap_set(const duct_bitmap *bitmap, int x, int y)
{
    duct_bitmap_row(bitmap, y)[(size_t)(x + 1) / 64] |= (uint64_t)1 << ((unsigned)(x + 1) % 64);
}

/* The distance from the middle of a pixel that is set to the edge of the nearest one that is not: about half
 * the line's width. `near` is a place's distance at most 1.5 pixels away, or negative where none is known. */
double duct_bitmap_radius(const duct_bitmap *bitmap, int x, int y, double near);

#endif
