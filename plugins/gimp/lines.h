/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_LINES_H
#define PLUG_LINES_H

#include "job.h"

/* The drawing that a job works on: its lines in image pixels, on a page of the image's size, in the colour
 * that they are to be painted with. The image is not changed. The caller frees it. Errors: DUCT_UNSUPPORTED
 * with a sentence where there is no line; DUCT_CANCELLED. */
duct_status plug_lines_read(const struct job *job, const duct_context *context, duct_drawing **drawing,
                            duct_error *error);

#endif
