/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_SURFACE_H
#define DUCTUS_BRUSH_SURFACE_H

#include "brush/canvas.h"

#include <mypaint-tiled-surface.h>

/* The surface that libmypaint paints a canvas through.
 *
 * Plain dabs are painted by duct_dab_paint(), whose edges are smooth at any size and which needs no queue.
 * Dabs in libmypaint's other modes (spectral mixing, locked alpha, colourising, posterising) go through its
 * own tile painter. Neither uses rand() or threads. */
typedef struct duct_surface {
    MyPaintTiledSurface2 tiled; /* first: libmypaint hands it back */
    duct_canvas *canvas;
    MyPaintSurfaceDrawDabFunction2 queue_dab; /* libmypaint's own */
    /* libmypaint's queue holds a square map of tiles around (0, 0) as large as the farthest tile, so far dabs
     * are queued from an origin nearby. */
    int base_tx, base_ty;
    int queued;                           /* dabs in the queue */
    bool muted;                           /* dabs are dropped */
    bool wash;                            /* plain dabs do not build up */
    uint16_t spare[DUCT_TILE_PIXELS * 4]; /* stands for tiles outside the canvas or without memory */
} duct_surface;

void duct_surface_begin(duct_surface *surface, duct_canvas *canvas);

/* Paints what is queued and frees libmypaint's part. */
void duct_surface_end(duct_surface *surface);

#endif
