/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "line_art.h"

#include "colours.h"
#include "failure.h"

#include <ductus/lineart.h>

#include <math.h>
#include <string.h>

enum { STRIP = 64 /* rows read at a time */ };

struct line_art {
    GeglBuffer *buffer;
    const Babl *own;    /* its format, with the image's colour space */
    GeglRectangle area; /* in the layer's pixels */
    int left, top;      /* of the area in the image */
    char *name;         /* the layer's */
    bool by_alpha;      /* where it is transparent there is paper, whatever the colours */
    bool own_colours;
    duct_lineart_options options;
    float *strip;    /* two values a pixel */
    uint8_t *grey;   /* all pixels; NULL: they are read when needed */
    uint8_t *colour; /* all pixels' red, green and blue; NULL: the same, or not needed */
};

static void read_strip(struct line_art *art, int y, int count, uint8_t *grey)
{
    const GeglRectangle strip = {art->area.x, art->area.y + y, art->area.width, count};
    gegl_buffer_get(art->buffer, &strip, 1, babl_format("Y'A float"), art->strip, GEGL_AUTO_ROWSTRIDE,
                    GEGL_ABYSS_NONE);
    size_t size = (size_t)count * (size_t)strip.width;
    for (size_t i = 0; i < size; i++) {
        float value = art->strip[2 * i], alpha = art->strip[2 * i + 1];
        float shown = art->by_alpha ? 1 - alpha : 1 - alpha + value * alpha;
        grey[i] = (uint8_t)(CLAMP(shown, 0, 1) * 255 + 0.5F);
    }
}

static bool read_rows(void *user, int y, int count, uint8_t *grey)
{
    struct line_art *art = user;
    size_t width = (size_t)art->area.width;
    if (art->grey != NULL) {
        memcpy(grey, art->grey + (size_t)y * width, (size_t)count * width);
        return true;
    }
    for (int done = 0; done < count; done += STRIP) {
        read_strip(art, y + done, MIN(STRIP, count - done), grey + (size_t)done * width);
    }
    return true;
}

/* Whether the layer is transparent paper: then its ink may have any colour, white too. */
static bool is_transparent(const struct line_art *art)
{
    enum { side = 256 };
    double scale = MIN(1, (double)side / MAX(art->area.width, art->area.height));
    const GeglRectangle small = {(int)(art->area.x * scale), (int)(art->area.y * scale),
                                 MAX(1, (int)(art->area.width * scale)),
                                 MAX(1, (int)(art->area.height * scale))};
    size_t size = (size_t)small.width * (size_t)small.height, clear = 0;
    float *pixels = g_new0(float, 2 * size); /* grey and alpha */
    gegl_buffer_get(art->buffer, &small, scale, babl_format("YA float"), pixels, GEGL_AUTO_ROWSTRIDE,
                    GEGL_ABYSS_NONE);
    for (size_t i = 0; i < size; i++) {
        clear += pixels[2 * i + 1] < 0.5F;
    }
    g_free(pixels);
    return clear > size / 4;
}

static void pixel_at(const struct line_art *art, double x, double y, uint8_t rgb[3])
{
    int column = (int)CLAMP(floor(x), 0, art->area.width - 1);
    int row = (int)CLAMP(floor(y), 0, art->area.height - 1);
    if (art->colour != NULL) {
        memcpy(rgb, art->colour + 3 * ((size_t)row * (size_t)art->area.width + (size_t)column), 3);
        return;
    }
    const GeglRectangle place = {art->area.x + column, art->area.y + row, 1, 1};
    plug_colours_read(art->buffer, &place, art->own, babl_format("R'G'B' u8"), rgb);
}

/* The mean colour of the pixels under a stroke. */
static void pick_colour(const struct line_art *art, duct_stroke *stroke)
{
    enum { most = 64 };
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    size_t size = duct_stroke_size(stroke), step = size / most + 1, count = 0;
    float sum[3] = {0};
    for (size_t i = 0; i < size; i += step, count++) {
        uint8_t rgb[3];
        pixel_at(art, x[i], y[i], rgb);
        for (size_t k = 0; k < 3; k++) {
            sum[k] += (float)rgb[k] / 255;
        }
    }
    duct_stroke_style style = duct_stroke_get_style(stroke);
    if (count > 0) {
        style.red = sum[0] / (float)count;
        style.green = sum[1] / (float)count;
        style.blue = sum[2] / (float)count;
    }
    duct_stroke_set_style(stroke, style);
}

static duct_lineart_options options_of(const duct_settings *options)
{
    duct_lineart_options made = duct_lineart_options_default();
    made.ink = plug_option_is(options, OPTION_INK, "dark")    ? DUCT_INK_DARK
               : plug_option_is(options, OPTION_INK, "light") ? DUCT_INK_LIGHT
                                                              : DUCT_INK_AUTO;
    made.threshold = plug_option_number(options, OPTION_THRESHOLD, 0);
    made.widest = plug_option_number(options, OPTION_WIDEST, made.widest);
    made.shortest = plug_option_number(options, OPTION_SHORTEST, made.shortest);
    return made;
}

static duct_status take_pixels(struct line_art *art, plug_hold hold, void *user, duct_error *error)
{
    size_t width = (size_t)art->area.width, height = (size_t)art->area.height;
    art->grey = g_try_malloc_n(width, height);
    art->colour = art->own_colours ? g_try_malloc_n(width * 3, height) : NULL;
    if (art->grey == NULL || (art->own_colours && art->colour == NULL)) {
        return plug_fail(error, DUCT_NO_MEMORY, "there is not enough memory for the layer's pixels");
    }
    for (int y = 0; y < art->area.height; y += STRIP) {
        int count = MIN(STRIP, art->area.height - y);
        if (!hold(user, (double)y / art->area.height)) {
            return plug_fail(error, DUCT_CANCELLED, "cancelled");
        }
        read_strip(art, y, count, art->grey + (size_t)y * width);
        if (art->colour != NULL) {
            const GeglRectangle strip = {art->area.x, art->area.y + y, art->area.width, count};
            plug_colours_read(art->buffer, &strip, art->own, babl_format("R'G'B' u8"),
                              art->colour + 3 * (size_t)y * width);
        }
    }
    return DUCT_OK;
}

duct_status plug_line_art_open(const struct job *job, plug_hold hold, void *user, struct line_art **art,
                               duct_error *error)
{
    if (job->drawable <= 0 || !gimp_item_is_drawable(job->drawable)) {
        return plug_fail(error, DUCT_UNSUPPORTED, "there is no active layer to find lines on: choose one");
    }
    GeglRectangle area;
    /* Gives the whole layer where nothing is selected. */
    if (!gimp_drawable_mask_intersect(job->drawable, &area.x, &area.y, &area.width, &area.height)) {
        return plug_fail(
            error, DUCT_UNSUPPORTED,
            "the selection does not touch the active layer: choose another layer, or select nothing");
    }
    struct line_art *made = g_new0(struct line_art, 1);
    made->area = area;
    gimp_drawable_offsets(job->drawable, &made->left, &made->top);
    made->left += area.x;
    made->top += area.y;
    made->name = gimp_item_get_name(job->drawable);
    made->options = options_of(job->options);
    made->own_colours = plug_option_is(job->options, OPTION_COLOUR, "line-art");
    made->strip = g_new(float, 2 * STRIP * (size_t)area.width);
    made->buffer = gimp_drawable_get_buffer(job->drawable);
    made->own = plug_colours_format(job->image, made->buffer);
    made->by_alpha = gimp_drawable_has_alpha(job->drawable) && is_transparent(made);
    duct_status status = hold != NULL ? take_pixels(made, hold, user, error) : DUCT_OK;
    if (status != DUCT_OK) {
        plug_line_art_close(made);
        return status;
    }
    *art = made;
    return DUCT_OK;
}

void plug_line_art_close(struct line_art *art)
{
    if (art != NULL) {
        g_object_unref(art->buffer);
        g_free(art->name);
        g_free(art->strip);
        g_free(art->grey);
        g_free(art->colour);
        g_free(art);
    }
}

/* Into the image's pixels, under the layer's name. */
static duct_status settle(const struct line_art *art, duct_drawing *drawing, size_t first, duct_error *error)
{
    duct_status status = DUCT_OK;
    for (size_t i = first; i < duct_drawing_stroke_count(drawing) && status == DUCT_OK; i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            x[k] += art->left;
            y[k] += art->top;
        }
        status = duct_stroke_set_group(stroke, art->name != NULL ? art->name : "", error);
    }
    return status;
}

duct_status plug_line_art_trace(struct line_art *art, const duct_context *context, duct_drawing *drawing,
                                duct_error *error)
{
    size_t first = duct_drawing_stroke_count(drawing);
    duct_status status = duct_lineart_trace(context, art->area.width, art->area.height, read_rows, art,
                                            &art->options, drawing, error);
    if (status == DUCT_OK && duct_drawing_stroke_count(drawing) == first) {
        return plug_fail(error, DUCT_UNSUPPORTED,
                         "no lines were found on the layer: choose a layer with lines on even paper, or set "
                         "threshold and ink by hand");
    }
    for (size_t i = first; art->own_colours && status == DUCT_OK && i < duct_drawing_stroke_count(drawing);
         i++) {
        pick_colour(art, duct_drawing_edit_stroke(drawing, i));
    }
    return status == DUCT_OK ? settle(art, drawing, first, error) : status;
}
