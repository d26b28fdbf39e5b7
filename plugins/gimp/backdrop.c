/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "backdrop.h"

#include <math.h>
#include <string.h>

enum { THUMBNAIL = 1024 /* the largest that GIMP gives */ };

struct backdrop {
    gint32 image;
    cairo_surface_t *whole; /* the whole image, small */
    gint32 layer; /* everything visible, full size; never in the image's stack; -1: not asked for yet */
    GeglBuffer *pixels;
};

struct backdrop *plug_backdrop_new(gint32 image)
{
    struct backdrop *backdrop = g_new0(struct backdrop, 1);
    backdrop->image = image;
    backdrop->layer = -1;
    return backdrop;
}

void plug_backdrop_free(struct backdrop *backdrop)
{
    if (backdrop->pixels != NULL) {
        g_object_unref(backdrop->pixels);
    }
    if (backdrop->layer > 0) {
        gimp_item_delete(backdrop->layer);
    }
    if (backdrop->whole != NULL) {
        cairo_surface_destroy(backdrop->whole);
    }
    g_free(backdrop);
}

static uint32_t premultiplied(const guchar *pixel, int channels)
{
    uint32_t alpha = channels % 2 == 0 ? pixel[channels - 1] : 255, out = alpha << 24;
    for (int k = 0; k < 3; k++) {
        uint32_t value = pixel[channels >= 3 ? k : 0];
        out |= (value * alpha + 127) / 255 << (16 - 8 * k);
    }
    return out;
}

/* GIMP makes thumbnails from its own pyramid of tiles, so this is quick for images of any size. */
static void get_whole(struct backdrop *backdrop)
{
    int width = THUMBNAIL, height = THUMBNAIL, channels = 0;
    guchar *data = gimp_image_get_thumbnail_data(backdrop->image, &width, &height, &channels);
    if (data == NULL) {
        return;
    }
    backdrop->whole = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, width, height);
    unsigned char *to = cairo_image_surface_get_data(backdrop->whole);
    const int stride = cairo_image_surface_get_stride(backdrop->whole);
    for (int y = 0; y < height; y++) {
        uint32_t *row = (uint32_t *)(void *)(to + (size_t)y * (size_t)stride);
        for (int x = 0; x < width; x++) {
            row[x] =
                premultiplied(data + ((size_t)y * (size_t)width + (size_t)x) * (size_t)channels, channels);
        }
    }
    cairo_surface_mark_dirty(backdrop->whole);
    g_free(data);
}

static void show_whole(struct backdrop *backdrop, const struct view *view, cairo_surface_t *surface)
{
    if (backdrop->whole == NULL) {
        get_whole(backdrop);
    }
    if (backdrop->whole == NULL) {
        return;
    }
    double across =
        (double)gimp_image_width(backdrop->image) / cairo_image_surface_get_width(backdrop->whole);
    double down =
        (double)gimp_image_height(backdrop->image) / cairo_image_surface_get_height(backdrop->whole);
    cairo_t *cairo = cairo_create(surface);
    cairo_scale(cairo, view->scale, view->scale);
    cairo_translate(cairo, -view->x, -view->y);
    cairo_scale(cairo, across, down);
    cairo_set_source_surface(cairo, backdrop->whole, 0, 0);
    cairo_paint(cairo);
    cairo_destroy(cairo);
}

static bool get_pixels(struct backdrop *backdrop)
{
    if (backdrop->pixels == NULL) {
        backdrop->layer = gimp_layer_new_from_visible(backdrop->image, backdrop->image, "preview");
        if (backdrop->layer > 0) {
            backdrop->pixels = gimp_drawable_get_buffer(backdrop->layer);
        }
    }
    return backdrop->pixels != NULL;
}

static void show_part(struct backdrop *backdrop, const struct view *view, cairo_surface_t *surface)
{
    const GeglRectangle area = {(int)floor(view->x * view->scale), (int)floor(view->y * view->scale),
                                view->width, view->height};
    cairo_surface_flush(surface);
    gegl_buffer_get(backdrop->pixels, &area, view->scale, babl_format("cairo-ARGB32"),
                    cairo_image_surface_get_data(surface), cairo_image_surface_get_stride(surface),
                    GEGL_ABYSS_NONE);
    cairo_surface_mark_dirty(surface);
}

cairo_surface_t *plug_backdrop_show(struct backdrop *backdrop, const struct view *view)
{
    cairo_surface_t *surface = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, view->width, view->height);
    if (cairo_surface_status(surface) != CAIRO_STATUS_SUCCESS) {
        return surface;
    }
    /* Where a thumbnail has as many pixels as are shown, it will do. */
    double most = MAX(gimp_image_width(backdrop->image), gimp_image_height(backdrop->image));
    if (most * view->scale <= THUMBNAIL / 2 || most <= THUMBNAIL || !get_pixels(backdrop)) {
        show_whole(backdrop, view, surface);
    } else {
        show_part(backdrop, view, surface);
    }
    return surface;
}
