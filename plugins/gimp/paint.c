/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "paint.h"

#include "colours.h"
#include "failure.h"

#include <string.h>

enum { PIXELS = DUCT_TILE_SIZE * DUCT_TILE_SIZE };

/* One tile of the canvas on its way into the layer. */
struct tile {
    GeglRectangle area;
    float mask[PIXELS];
    float pixels[PIXELS * 4]; /* premultiplied, sRGB-encoded */
};

/* Canvas rows are always whole tiles; at the image's edge the area is narrower. False where nothing is left.
 */
static bool fill(struct tile *tile, const uint16_t *painted, const struct clip *clip)
{
    const float one = 1 << 15;
    const size_t width = (size_t)tile->area.width, height = (size_t)tile->area.height;
    for (size_t i = 0; i < width * height; i++) {
        tile->mask[i] = 1;
    }
    plug_clip_apply(clip, &tile->area, 1, tile->mask);
    bool any = false;
    for (size_t y = 0; y < height; y++) {
        const uint16_t *from = painted + y * DUCT_TILE_SIZE * 4;
        float *to = tile->pixels + y * width * 4;
        for (size_t x = 0; x < width; x++) {
            float share = tile->mask[y * width + x] / one;
            any = any || (share > 0 && from[4 * x + 3] > 0);
            for (size_t k = 0; k < 4; k++) {
                to[4 * x + k] = (float)from[4 * x + k] * share;
            }
        }
    }
    return any;
}

static duct_status copy_tiles(const struct job *job, const duct_context *context, const duct_canvas *canvas,
                              const struct clip *clip, GeglBuffer *buffer, size_t *count, duct_error *error)
{
    const int width = duct_canvas_width(canvas), height = duct_canvas_height(canvas);
    const Babl *format = babl_format("R'aG'aB'aA float"), *own = plug_colours_format(job->image, buffer);
    struct tile *tile = g_new(struct tile, 1);
    duct_status status = DUCT_OK;
    *count = 0;
    for (int y = 0; y < height && status == DUCT_OK; y += DUCT_TILE_SIZE) {
        for (int x = 0; x < width; x += DUCT_TILE_SIZE) {
            const uint16_t *painted = duct_canvas_tile(canvas, x / DUCT_TILE_SIZE, y / DUCT_TILE_SIZE);
            tile->area =
                (GeglRectangle){x, y, MIN(DUCT_TILE_SIZE, width - x), MIN(DUCT_TILE_SIZE, height - y)};
            if (painted != NULL && fill(tile, painted, clip)) {
                plug_colours_write(buffer, &tile->area, own, format, tile->pixels);
                (*count)++;
            }
        }
        if (context->progress != NULL && !context->progress(context->progress_user, (double)y / height)) {
            status = plug_fail(error, DUCT_CANCELLED, "cancelled");
        }
    }
    g_free(tile);
    return status;
}

duct_status plug_paint_layer(const struct job *job, const duct_context *context, const duct_canvas *canvas,
                             const struct clip *clip, gint32 *layer, duct_error *error)
{
    bool grey = gimp_image_base_type(job->image) == GIMP_GRAY;
    gint32 made =
        gimp_layer_new(job->image, job->operation->label, duct_canvas_width(canvas),
                       duct_canvas_height(canvas), grey ? GIMP_GRAYA_IMAGE : GIMP_RGBA_IMAGE,
                       plug_option_number(job->options, OPTION_OPACITY, 100), plug_option_mode(job->options));
    if (made <= 0) {
        return plug_fail_gimp(error, "make a layer");
    }
    size_t count = 0;
    GeglBuffer *buffer = gimp_drawable_get_buffer(made);
    duct_status status = copy_tiles(job, context, canvas, clip, buffer, &count, error);
    gegl_buffer_flush(buffer);
    g_object_unref(buffer);
    if (status == DUCT_OK && count == 0) {
        status =
            plug_fail(error, DUCT_UNSUPPORTED, "nothing was painted: the lines are outside %s",
                      clip->count > 0 ? "the selection, the layer's mask or its locked alpha" : "the image");
    }
    if (status != DUCT_OK) {
        gimp_item_delete(made);
        return status;
    }
    *layer = made;
    return DUCT_OK;
}
