/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_MESSAGE_H
#define DUCTUS_CLI_MESSAGE_H

#include <ductus/status.h>

#include <stddef.h>

/* Exit codes, which are a contract; 128 + signal where a signal stopped the work. */
enum { CLI_DONE = 0, CLI_FAILED = 1, CLI_USAGE = 2 };

/* Prints "ductus: SENTENCE" as one line on stderr and returns CLI_FAILED. */
int cli_fail(const char *format, ...) DUCT_PRINTF(1, 2);

/* The same for a command that was not typed right; returns CLI_USAGE. */
int cli_misused(const char *format, ...) DUCT_PRINTF(1, 2);

/* The same for a failed call of the library: its sentence, after "PLACE: " unless `place` is NULL or the
 * sentence begins with it already. Returns CLI_FAILED, or 128 + signal where the user stopped the work. */
int cli_fail_error(const char *place, duct_status status, const duct_error *error);

int cli_fail_memory(void);

/* Walks a list of names: the one at `index`, or NULL past the end. */
typedef const char *(*cli_name_at)(const void *list, size_t index);

/* The name of the list that `typed` most likely stands for, or NULL where none is near. */
const char *cli_nearest(const char *typed, cli_name_at name_at, const void *list);

#endif
