/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lineart/bitmap.h"

#include <math.h>
#include <string.h>

bool duct_bitmap_init(duct_bitmap *bitmap, const duct_allocator *allocator, int width, int height)
{
    bitmap->allocator = allocator;
    bitmap->width = width;
    bitmap->height = height;
    bitmap->stride = ((size_t)width + 2 + 63) / 64;
    bitmap->words = duct_alloc(allocator, ((size_t)height + 2) * bitmap->stride, sizeof *bitmap->words);
    return bitmap->words != NULL;
}

bool duct_bitmap_copy(duct_bitmap *copy, const duct_bitmap *bitmap)
{
    if (!duct_bitmap_init(copy, bitmap->allocator, bitmap->width, bitmap->height)) {
        return false;
    }
    memcpy(copy->words, bitmap->words, ((size_t)bitmap->height + 2) * bitmap->stride * sizeof *copy->words);
    return true;
}

void duct_bitmap_done(duct_bitmap *bitmap)
{
    duct_release(bitmap->allocator, bitmap->words);
    bitmap->words = NULL;
}

static bool is_empty(const duct_bitmap *bitmap, int x, int y)
{
    if (x < 0 || y < 0 || x >= bitmap->width || y >= bitmap->height) {
        return true;
    }
    return !duct_bitmap_get(bitmap, x, y);
}

/* The least squared distance to an empty pixel on the square ring at distance k, or `best`. */
static double search_ring(const duct_bitmap *bitmap, int x, int y, int k, double best)
{
    for (int i = -k; i <= k; i++) {
        double squared = (double)k * k + (double)i * i;
        if (squared < best && (is_empty(bitmap, x + i, y - k) || is_empty(bitmap, x + i, y + k) ||
                               is_empty(bitmap, x - k, y + i) || is_empty(bitmap, x + k, y + i))) {
            best = squared;
        }
    }
    return best;
}

double duct_bitmap_radius(const duct_bitmap *bitmap, int x, int y, double near)
{
    /* Neighbouring places differ by no more than they are apart, so the search need not begin at the middle.
     */
    int k = near > 0 ? (int)floor((near - 1.5) / sqrt(2)) : 1;
    double best = INFINITY;
    for (k = k < 1 ? 1 : k; (double)k * k < best; k++) {
        best = search_ring(bitmap, x, y, k, best);
    }
    /* To the pixel's edge it is half a pixel less; but a line of an even number of pixels has its middle
     * between two, and is half a pixel wider on the other side: the mean of both. */
    return sqrt(best) - 0.25;
}
