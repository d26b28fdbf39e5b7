/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_CANVAS_H
#define DUCTUS_BRUSH_CANVAS_H

#include "base/memory.h"

#include <ductus/render.h>

enum {
    DUCT_TILE_PIXELS = DUCT_TILE_SIZE * DUCT_TILE_SIZE,
    DUCT_MAX_CANVAS = 65536, /* pixels a side */
    DUCT_FIX_ONE = 1 << 15   /* 1.0 in 15-bit fixed point */
};

/* Tiles are made when first painted on. A tile that cannot be made sets `failed`, and what would have been
 * painted there is lost: painting has no way to report a failure dab by dab. */
struct duct_canvas {
    const duct_allocator *allocator;
    int width, height;
    int columns, rows; /* of tiles */
    uint16_t **tiles;  /* columns * rows */
    bool failed;
    int dirty[4];       /* box of tiles made since duct_canvas_clean(): x0 y0 x1 y1, empty where x1 < x0 */
    duct_canvas *layer; /* where a translucent stroke is painted before it is laid over the canvas */
};

/* The tile for painting, made where there is none; NULL outside the canvas or without memory. */
uint16_t *duct_canvas_touch(duct_canvas *canvas, int tx, int ty);

/* The canvas's own layer of the same size, empty. NULL without memory. */
duct_canvas *duct_canvas_layer(duct_canvas *canvas);

/* Lays the layer over the canvas with an opacity of 0..1 and empties it. */
void duct_canvas_merge(duct_canvas *canvas, duct_canvas *layer, double opacity);

#endif
