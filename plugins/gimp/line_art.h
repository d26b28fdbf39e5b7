/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_LINE_ART_H
#define PLUG_LINE_ART_H

#include "job.h"

#include <ductus/drawing.h>

/* The picture of lines on a job's layer, inside the selection. */
struct line_art;

/* Called between strips of pixels; false stops. */
typedef bool (*plug_hold)(void *user, double fraction);

/* Without `hold` pixels are read in strips when the lines are traced, by the main thread. With it all of them
 * are taken into memory, a byte each (and three more where strokes get the colours of the lines). Errors:
 * DUCT_UNSUPPORTED (no layer), DUCT_NO_MEMORY, DUCT_CANCELLED. */
duct_status plug_line_art_open(const struct job *job, plug_hold hold, void *user, struct line_art **art,
                               duct_error *error);

/* Appends the lines, in pixels of the image, under the layer's name. Errors: DUCT_UNSUPPORTED (there are
 * none), those of duct_lineart_trace(). */
duct_status plug_line_art_trace(struct line_art *art, const duct_context *context, duct_drawing *drawing,
                                duct_error *error);

void plug_line_art_close(struct line_art *art); /* NULL is allowed */

#endif
