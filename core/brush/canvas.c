/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/canvas.h"

#include "base/error.h"

#include <math.h>

static void forget_dirt(duct_canvas *canvas)
{
    canvas->dirty[0] = canvas->columns;
    canvas->dirty[1] = canvas->rows;
    canvas->dirty[2] = canvas->dirty[3] = -1;
}

duct_status duct_canvas_new(const duct_context *context, int width, int height, duct_canvas **canvas,
                            duct_error *error)
{
    if (width < 1 || height < 1 || width > DUCT_MAX_CANVAS || height > DUCT_MAX_CANVAS) {
        return duct_fail(error, DUCT_LIMIT,
                         "an image of %d x %d pixels cannot be painted: each side has to be 1 to %d", width,
                         height, DUCT_MAX_CANVAS);
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_canvas *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = allocator;
    made->width = width;
    made->height = height;
    made->columns = (width + DUCT_TILE_SIZE - 1) / DUCT_TILE_SIZE;
    made->rows = (height + DUCT_TILE_SIZE - 1) / DUCT_TILE_SIZE;
    made->tiles = duct_alloc(allocator, (size_t)made->columns * (size_t)made->rows, sizeof *made->tiles);
    if (made->tiles == NULL) {
        duct_release(allocator, made);
        return duct_fail_memory(error);
    }
    forget_dirt(made);
    *canvas = made;
    return DUCT_OK;
}

void duct_canvas_free(duct_canvas *canvas)
{
    if (canvas == NULL) {
        return;
    }
    duct_canvas_free(canvas->layer);
    size_t count = (size_t)canvas->columns * (size_t)canvas->rows;
    for (size_t i = 0; i < count; i++) {
        duct_release(canvas->allocator, canvas->tiles[i]);
    }
    duct_release(canvas->allocator, canvas->tiles);
    duct_release(canvas->allocator, canvas);
}

int duct_canvas_width(const duct_canvas *canvas)
{
    return canvas->width;
}

int duct_canvas_height(const duct_canvas *canvas)
{
    return canvas->height;
}

static bool inside(const duct_canvas *canvas, int tx, int ty)
{
    return tx >= 0 && ty >= 0 && tx < canvas->columns && ty < canvas->rows;
}

const uint16_t *duct_canvas_tile(const duct_canvas *canvas, int tx, int ty)
{
    return inside(canvas, tx, ty) ? canvas->tiles[(size_t)ty * (size_t)canvas->columns + (size_t)tx] : NULL;
}

uint16_t *duct_canvas_touch(duct_canvas *canvas, int tx, int ty)
{
    if (!inside(canvas, tx, ty)) {
        return NULL;
    }
    uint16_t **tile = &canvas->tiles[(size_t)ty * (size_t)canvas->columns + (size_t)tx];
    if (*tile == NULL) {
        *tile = duct_alloc(canvas->allocator, (size_t)DUCT_TILE_PIXELS * 4, sizeof **tile);
        if (*tile == NULL) {
            canvas->failed = true;
            return NULL;
        }
        canvas->dirty[0] = tx < canvas->dirty[0] ? tx : canvas->dirty[0];
        canvas->dirty[1] = ty < canvas->dirty[1] ? ty : canvas->dirty[1];
        canvas->dirty[2] = tx > canvas->dirty[2] ? tx : canvas->dirty[2];
        canvas->dirty[3] = ty > canvas->dirty[3] ? ty : canvas->dirty[3];
    }
    return *tile;
}

duct_canvas *duct_canvas_layer(duct_canvas *canvas)
{
    if (canvas->layer == NULL) {
        duct_context context = duct_context_default();
        context.allocator = canvas->allocator;
        duct_canvas *layer = NULL;
        if (duct_canvas_new(&context, canvas->width, canvas->height, &layer, NULL) == DUCT_OK) {
            canvas->layer = layer;
        }
    }
    return canvas->layer;
}

static void merge_tile(uint16_t *below, const uint16_t *above, unsigned opacity)
{
    const unsigned half = DUCT_FIX_ONE / 2;
    for (size_t i = 0; i < (size_t)DUCT_TILE_PIXELS * 4; i += 4) {
        unsigned alpha = (above[i + 3] * opacity + half) >> 15;
        unsigned rest = DUCT_FIX_ONE - alpha;
        for (size_t k = 0; k < 4; k++) {
            unsigned over = (above[i + k] * opacity + half) >> 15;
            below[i + k] = (uint16_t)(over + ((below[i + k] * rest + half) >> 15));
        }
    }
}

void duct_canvas_merge(duct_canvas *canvas, duct_canvas *layer, double opacity)
{
    unsigned fixed = (unsigned)lround(opacity * DUCT_FIX_ONE);
    for (int ty = layer->dirty[1]; ty <= layer->dirty[3]; ty++) {
        for (int tx = layer->dirty[0]; tx <= layer->dirty[2]; tx++) {
            uint16_t **above = &layer->tiles[(size_t)ty * (size_t)layer->columns + (size_t)tx];
            if (*above == NULL) {
                continue;
            }
            uint16_t *below = duct_canvas_touch(canvas, tx, ty);
            if (below != NULL) {
                merge_tile(below, *above, fixed);
            }
            duct_release(layer->allocator, *above);
            *above = NULL;
        }
    }
    canvas->failed = canvas->failed || layer->failed;
    layer->failed = false;
    forget_dirt(layer);
}
