/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_COLOURS_H
#define PLUG_COLOURS_H

#include <gegl.h>
#include <libgimp/gimp.h>

/* A drawable's own pixels as the image's colour profile has them. GIMP 2.10 gives plug-ins the pixels'
 * encoding but not their colour space, so pixels are read and written as they are and converted here. */

/* The format of the buffer, a drawable's of the image, with the space of the image's profile. */
const Babl *plug_colours_format(gint32 image, GeglBuffer *buffer);

/* Writes pixels of `format` in the space that it names. */
void plug_colours_write(GeglBuffer *buffer, const GeglRectangle *area, const Babl *own, const Babl *format,
                        const void *pixels);

/* Reads pixels as `format` in the space that it names; nothing outside of the buffer. */
void plug_colours_read(GeglBuffer *buffer, const GeglRectangle *area, const Babl *own, const Babl *format,
                       void *pixels);

#endif
