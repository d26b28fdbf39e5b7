/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_OUTPUT_H
#define DUCTUS_CLI_OUTPUT_H

#include "session.h"

#include <ductus/drawing.h>
#include <ductus/format.h>
#include <ductus/image.h>

/* Writing drawings: the ending of the output's name picks a vector format or an image, which the brush engine
 * paints. */

/* Options of commands that write drawings: -o, --to, and those of vector formats and of images. */
extern const cli_option cli_output_options[];
extern const size_t cli_output_option_count;

typedef struct cli_output {
    const cli_session *session;
    duct_format_options vector;
    const char *brush_name;
    duct_brush *brush; /* loaded when the first image is written */
    duct_render_options render;
    duct_image_options image;
} cli_output;

/* Reads the options. Returns an exit code. */
int cli_output_begin(cli_output *output, const cli_session *session, const cli_arguments *arguments,
                     const char *command);
void cli_output_end(cli_output *output);

/* Whether a name's ending is that of a format that can be written: the format's id, or the ending itself
 * where it is an image's (then `*image` becomes true); NULL where it is neither. */
const char *cli_output_format(const char *path, bool *image);

/* The endings that can be written, as text for a sentence. */
void cli_output_formats(char *text, size_t size);

/* Writes a drawing; `path` may be "-" for standard output, and then `format` is a format's id or an image's
 * ending, which counts otherwise for nothing. Returns an exit code. */
int cli_output_write(cli_output *output, const duct_drawing *drawing, const char *path, const char *format);

/* Loads the brush if it is not loaded yet, so that a name that is not there is found out before the work. */
int cli_output_load_brush(cli_output *output);

#endif
