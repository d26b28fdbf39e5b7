/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_LINES_H
#define PLUG_LINES_H

#include "line_art.h"

/* The lines that a job works on. They are had in two steps: asking GIMP, which only the main thread may do,
 * and what follows from the answer, which another thread may do if all pixels were taken into memory. */
struct lines {
    duct_drawing *drawing;
    struct line_art *art; /* NULL: paths, which are in the drawing already */
    GimpRGB colour;
    bool coloured; /* all lines get the colour */
};

/* Asks GIMP: the drawing has the image's size and, for paths, their lines. With `hold` pixels are taken into
 * memory; `hold` is then called now and then, and stops it by returning false. The image is not changed.
 * Errors: DUCT_UNSUPPORTED with a sentence where there is nothing to work on; DUCT_CANCELLED. */
duct_status plug_lines_open(const struct job *job, plug_hold hold, void *user, struct lines *lines,
                            duct_error *error);

/* Finds the lines in pixels where there are any, and colours all. Errors: DUCT_UNSUPPORTED where there is no
 * line, those of duct_lineart_trace(). */
duct_status plug_lines_find(struct lines *lines, const duct_context *context, duct_error *error);

void plug_lines_close(struct lines *lines);

#endif
