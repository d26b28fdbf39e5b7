/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_SINK_H
#define DUCTUS_CLI_SINK_H

#include <stdbool.h>
#include <stdio.h>

/* A file that is written piece by piece and appears whole or not at all: beside its place under another name,
 * then renamed. A path that is no regular file (such as a pipe) is written to directly. */
typedef struct cli_sink {
    FILE *file;
    const char *path;
    char *beside; /* NULL where the path is written to directly */
} cli_sink;

/* Returns an exit code. `path` must outlive the sink. */
int cli_sink_open(cli_sink *sink, const char *path);

/* A duct_trace: takes text, `user` being the sink. */
bool cli_sink_take(void *user, const char *text, size_t size);

/* Puts the file in its place. Returns an exit code. */
int cli_sink_commit(cli_sink *sink);

/* Removes what was written; does nothing after a commit or on a zeroed sink. */
void cli_sink_drop(cli_sink *sink);

#endif
