/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_PAINT_H
#define PLUG_PAINT_H

#include "clip.h"

#include <ductus/render.h>

/* Makes a layer of the image's size, kind and precision, not in the image yet, and puts the canvas's tiles on
 * it, one by one, where `clip` lets paint through. Colours are sRGB in the canvas and become the image's own;
 * a grey image gets their luminance. `*layer` is then the caller's to insert or delete. Errors:
 * DUCT_UNSUPPORTED (nothing was painted, or GIMP failed), DUCT_CANCELLED. */
duct_status plug_paint_layer(const struct job *job, const duct_context *context, const duct_canvas *canvas,
                             const struct clip *clip, gint32 *layer, duct_error *error);

#endif
