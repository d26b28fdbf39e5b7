/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "colours.h"

const Babl *plug_colours_format(gint32 image, GeglBuffer *buffer)
{
    const Babl *format = gegl_buffer_get_format(buffer), *space = NULL;
    GimpColorProfile *profile = gimp_image_get_effective_color_profile(image);
    if (profile != NULL) {
        space =
            gimp_color_profile_get_space(profile, GIMP_COLOR_RENDERING_INTENT_RELATIVE_COLORIMETRIC, NULL);
        g_object_unref(profile);
    }
    return space != NULL ? babl_format_with_space(babl_format_get_encoding(format), space) : format;
}

void plug_colours_write(GeglBuffer *buffer, const GeglRectangle *area, const Babl *own, const Babl *format,
                        const void *pixels)
{
    glong count = (glong)area->width * area->height;
    void *converted = g_malloc_n((gsize)count, (gsize)babl_format_get_bytes_per_pixel(own));
    babl_process(babl_fish(format, own), pixels, converted, count);
    gegl_buffer_set(buffer, area, 0, gegl_buffer_get_format(buffer), converted, GEGL_AUTO_ROWSTRIDE);
    g_free(converted);
}

void plug_colours_read(GeglBuffer *buffer, const GeglRectangle *area, const Babl *own, const Babl *format,
                       void *pixels)
{
    glong count = (glong)area->width * area->height;
    void *taken = g_malloc_n((gsize)count, (gsize)babl_format_get_bytes_per_pixel(own));
    gegl_buffer_get(buffer, area, 1, gegl_buffer_get_format(buffer), taken, GEGL_AUTO_ROWSTRIDE,
                    GEGL_ABYSS_NONE);
    babl_process(babl_fish(own, format), taken, pixels, count);
    g_free(taken);
}
