/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/surface.h"

#include "brush/dab.h"

#include <math.h>
#include <string.h>

enum {
    BASE_TILES = 16,  /* the origin for queued dabs is a multiple of this many tiles */
    QUEUE_LIMIT = 256 /* dabs that wait at most */
};

static const double pi = 3.14159265358979323846;

static void start_tile(MyPaintTiledSurface2 *tiled, MyPaintTileRequest *request)
{
    duct_surface *surface = (duct_surface *)tiled;
    request->buffer =
        duct_canvas_touch(surface->canvas, request->tx + surface->base_tx, request->ty + surface->base_ty);
    if (request->buffer == NULL) {
        memset(surface->spare, 0, sizeof surface->spare);
        request->buffer = surface->spare;
    }
}

static void end_tile(MyPaintTiledSurface2 *tiled, MyPaintTileRequest *request)
{
    (void)tiled;
    (void)request;
}

static void flush(duct_surface *surface)
{
    if (surface->queued > 0) {
        surface->queued = 0;
        mypaint_tiled_surface2_end_atomic(&surface->tiled, NULL);
        mypaint_tiled_surface2_begin_atomic(&surface->tiled);
    }
}

static int base_tile(double position)
{
    return (int)floor(position / (DUCT_TILE_SIZE * BASE_TILES)) * BASE_TILES;
}

static int draw_dab(MyPaintSurface2 *parent, float x, float y, float radius, float red, float green,
                    float blue, float opacity, float hardness, float target_alpha, float ratio, float angle,
                    float lock_alpha, float colourise, float posterise, float posterise_count, float paint)
{
    duct_surface *surface = (duct_surface *)parent;
    float reach = radius + 2;
    if (surface->muted || !(opacity > 0) || !isfinite(x) || !isfinite(y) || !isfinite(radius) ||
        x + reach < 0 || y + reach < 0 || x - reach > (float)surface->canvas->width ||
        y - reach > (float)surface->canvas->height) {
        return 0;
    }
    if (!(lock_alpha > 0) && !(colourise > 0) && !(posterise > 0) && !(paint > 0)) {
        flush(surface);
        const duct_dab dab = {(double)x,
                              (double)y,
                              (double)radius,
                              (double)ratio,
                              (double)angle * pi / 180,
                              hardness,
                              (double)opacity,
                              red,
                              green,
                              blue,
                              target_alpha,
                              surface->wash};
        duct_dab_paint(surface->canvas, &dab);
        return 1;
    }
    int base_tx = base_tile((double)x), base_ty = base_tile((double)y);
    if (base_tx != surface->base_tx || base_ty != surface->base_ty || surface->queued >= QUEUE_LIMIT) {
        flush(surface);
        surface->base_tx = base_tx;
        surface->base_ty = base_ty;
    }
    surface->queued++;
    return surface->queue_dab(parent, x - (float)(base_tx * DUCT_TILE_SIZE),
                              y - (float)(base_ty * DUCT_TILE_SIZE), radius, red, green, blue, opacity,
                              hardness, target_alpha, ratio, angle, lock_alpha, colourise, posterise,
                              posterise_count, paint);
}

static void get_colour_pigment(MyPaintSurface2 *parent, float x, float y, float radius, float *red,
                               float *green, float *blue, float *alpha, float paint)
{
    (void)paint;
    duct_surface *surface = (duct_surface *)parent;
    flush(surface);
    float colour[4];
    duct_dab_average(surface->canvas, (double)x, (double)y, (double)radius, colour);
    *red = colour[0];
    *green = colour[1];
    *blue = colour[2];
    *alpha = colour[3];
}

static void get_colour(MyPaintSurface *parent, float x, float y, float radius, float *red, float *green,
                       float *blue, float *alpha)
{
    get_colour_pigment((MyPaintSurface2 *)parent, x, y, radius, red, green, blue, alpha, 0);
}

void duct_surface_begin(duct_surface *surface, duct_canvas *canvas)
{
    memset(surface, 0, sizeof *surface);
    surface->canvas = canvas;
    mypaint_tiled_surface2_init(&surface->tiled, start_tile, end_tile);
    surface->tiled.threadsafe_tile_requests = 0;
    surface->queue_dab = surface->tiled.parent.draw_dab_pigment;
    surface->tiled.parent.draw_dab_pigment = draw_dab;
    surface->tiled.parent.get_color_pigment = get_colour_pigment;
    surface->tiled.parent.parent.get_color = get_colour;
    mypaint_tiled_surface2_begin_atomic(&surface->tiled);
}

void duct_surface_end(duct_surface *surface)
{
    flush(surface);
    mypaint_tiled_surface2_end_atomic(&surface->tiled, NULL);
    mypaint_tiled_surface2_destroy(&surface->tiled);
}
