/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_INPUT_H
#define DUCTUS_CLI_INPUT_H

#include "session.h"

#include <ductus/drawing.h>

/* Options of commands that read drawings: --from, --flatten-tolerance. */
extern const cli_option cli_input_options[];
extern const size_t cli_input_option_count;

/* Checks --from. Returns CLI_DONE or CLI_USAGE. */
int cli_input_check(const cli_arguments *arguments, const char *command);

/* What a path is called in sentences: itself, or "standard input" for "-". */
const char *cli_input_name(const char *path);

/* Reads a drawing from a file, or from standard input for "-". Returns an exit code, after the error was
 * printed. The caller frees the drawing. */
int cli_input_read(const cli_session *session, const cli_arguments *arguments, const char *path,
                   duct_drawing **drawing);

#endif
