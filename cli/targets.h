/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_TARGETS_H
#define DUCTUS_CLI_TARGETS_H

#include "options.h"

/* Which input becomes which output: IN... -o OUT, where OUT is a file, standard output, or a folder that
 * keeps the inputs' names. All is checked before any work begins. */

typedef struct cli_target {
    const char *input;
    char *output;       /* a path, or "-" */
    const char *format; /* the format's id, or an image's ending */
    bool image;
    char *trace; /* a path, or NULL */
} cli_target;

typedef struct cli_targets {
    cli_target *items;
    size_t count;
    char *made[2]; /* folders that were made for the outputs and traces, or NULL */
} cli_targets;

/* Plans the outputs and makes the folders. Returns an exit code. Free with cli_targets_free() either way. */
int cli_targets_plan(cli_targets *targets, const cli_arguments *arguments, const char *command);

/* Removes the folders that were made and are still empty, after a failure. */
void cli_targets_undo(const cli_targets *targets);
void cli_targets_free(cli_targets *targets);

#endif
