/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_LINE_ART_H
#define PLUG_LINE_ART_H

#include "job.h"

/* Appends the lines that are drawn on the job's layer, inside the selection, with the mean colours of their
 * pixels. The pixels are read in strips. Errors: DUCT_UNSUPPORTED (no layer, or no lines on it), those of
 * duct_lineart_trace(). */
duct_status plug_line_art_read(const struct job *job, const duct_context *context, duct_drawing *drawing,
                               duct_error *error);

#endif
