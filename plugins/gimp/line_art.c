/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "line_art.h"

#include "failure.h"

#include <ductus/lineart.h>

#include <math.h>
#include <string.h>

/* The part of a layer that is read. */
struct source {
    GeglBuffer *buffer;
    GeglRectangle area; /* in the layer's pixels */
    bool by_alpha;      /* where it is transparent there is paper, whatever the colours */
    float *pixels;      /* of a strip */
    int room;           /* rows of it */
};

static bool reserve(struct source *source, int rows, size_t channels)
{
    if (rows > source->room) {
        g_free(source->pixels);
        source->pixels = g_try_malloc_n((gsize)rows * (gsize)source->area.width, channels * sizeof(float));
        source->room = source->pixels != NULL ? rows : 0;
    }
    return source->pixels != NULL;
}

static bool read_rows(void *user, int y, int count, uint8_t *grey)
{
    struct source *source = user;
    const GeglRectangle strip = {source->area.x, source->area.y + y, source->area.width, count};
    if (!reserve(source, count, 2)) {
        return false;
    }
    gegl_buffer_get(source->buffer, &strip, 1, babl_format("Y'A float"), source->pixels, GEGL_AUTO_ROWSTRIDE,
                    GEGL_ABYSS_NONE);
    size_t size = (size_t)count * (size_t)strip.width;
    for (size_t i = 0; i < size; i++) {
        float value = source->pixels[2 * i], alpha = source->pixels[2 * i + 1];
        float shown = source->by_alpha ? 1 - alpha : 1 - alpha + value * alpha;
        grey[i] = (uint8_t)(CLAMP(shown, 0, 1) * 255 + 0.5F);
    }
    return true;
}

/* Whether the layer is transparent paper: then its ink may have any colour, white too. */
static bool is_transparent(const struct source *source)
{
    enum { side = 256 };
    double scale = MIN(1, (double)side / MAX(source->area.width, source->area.height));
    const GeglRectangle small = {(int)(source->area.x * scale), (int)(source->area.y * scale),
                                 MAX(1, (int)(source->area.width * scale)),
                                 MAX(1, (int)(source->area.height * scale))};
    size_t size = (size_t)small.width * (size_t)small.height, clear = 0;
    float *alpha = g_new0(float, size);
    gegl_buffer_get(source->buffer, &small, scale, babl_format("A float"), alpha, GEGL_AUTO_ROWSTRIDE,
                    GEGL_ABYSS_NONE);
    for (size_t i = 0; i < size; i++) {
        clear += alpha[i] < 0.5F;
    }
    g_free(alpha);
    return clear > size / 4;
}

/* The mean colour of the pixels under a stroke, weighted by their alpha. */
static void pick_colour(struct source *source, duct_stroke *stroke)
{
    enum { most = 64 };
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    size_t size = duct_stroke_size(stroke), step = size / most + 1;
    double sum[4] = {0};
    for (size_t i = 0; i < size; i += step) {
        float pixel[4];
        const GeglRectangle place = {source->area.x + (int)floor(x[i]), source->area.y + (int)floor(y[i]), 1,
                                     1};
        gegl_buffer_get(source->buffer, &place, 1, babl_format("R'G'B'A float"), pixel, GEGL_AUTO_ROWSTRIDE,
                        GEGL_ABYSS_NONE);
        for (size_t k = 0; k < 3; k++) {
            sum[k] += (double)(pixel[k] * pixel[3]);
        }
        sum[3] += (double)pixel[3];
    }
    duct_stroke_style style = duct_stroke_get_style(stroke);
    if (sum[3] > 0) {
        style.red = (float)CLAMP(sum[0] / sum[3], 0, 1);
        style.green = (float)CLAMP(sum[1] / sum[3], 0, 1);
        style.blue = (float)CLAMP(sum[2] / sum[3], 0, 1);
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

/* Into the image's pixels, under the layer's name. */
static duct_status settle(const struct source *source, gint32 drawable, duct_drawing *drawing, size_t first,
                          duct_error *error)
{
    int left = 0, top = 0;
    gimp_drawable_offsets(drawable, &left, &top);
    left += source->area.x;
    top += source->area.y;
    char *name = gimp_item_get_name(drawable);
    duct_status status = DUCT_OK;
    for (size_t i = first; i < duct_drawing_stroke_count(drawing) && status == DUCT_OK; i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            x[k] += left;
            y[k] += top;
        }
        status = duct_stroke_set_group(stroke, name != NULL ? name : "", error);
    }
    g_free(name);
    return status;
}

static duct_status trace(struct source *source, const struct job *job, const duct_context *context,
                         duct_drawing *drawing, duct_error *error)
{
    size_t first = duct_drawing_stroke_count(drawing);
    const duct_lineart_options options = options_of(job->options);
    duct_status status = duct_lineart_trace(context, source->area.width, source->area.height, read_rows,
                                            source, &options, drawing, error);
    if (status == DUCT_OK && duct_drawing_stroke_count(drawing) == first) {
        return plug_fail(error, DUCT_UNSUPPORTED,
                         "no lines were found on the layer: choose a layer with lines on even paper, or set "
                         "threshold and ink by hand");
    }
    bool own = plug_option_is(job->options, OPTION_COLOUR, "line-art");
    for (size_t i = first; own && status == DUCT_OK && i < duct_drawing_stroke_count(drawing); i++) {
        pick_colour(source, duct_drawing_edit_stroke(drawing, i));
    }
    return status == DUCT_OK ? settle(source, job->drawable, drawing, first, error) : status;
}

duct_status plug_line_art_read(const struct job *job, const duct_context *context, duct_drawing *drawing,
                               duct_error *error)
{
    if (job->drawable <= 0 || !gimp_item_is_drawable(job->drawable)) {
        return plug_fail(error, DUCT_UNSUPPORTED, "there is no active layer to find lines on: choose one");
    }
    struct source source = {NULL, {0, 0, 0, 0}, false, NULL, 0};
    /* Gives the whole layer where nothing is selected. */
    if (!gimp_drawable_mask_intersect(job->drawable, &source.area.x, &source.area.y, &source.area.width,
                                      &source.area.height)) {
        return plug_fail(error, DUCT_UNSUPPORTED, "the selection does not touch the active layer");
    }
    source.buffer = gimp_drawable_get_buffer(job->drawable);
    source.by_alpha = gimp_drawable_has_alpha(job->drawable) && is_transparent(&source);
    duct_status status = trace(&source, job, context, drawing, error);
    g_object_unref(source.buffer);
    g_free(source.pixels);
    return status;
}
