/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_COMMANDS_H
#define DUCTUS_CLI_COMMANDS_H

#include <ductus/operation.h>

/* The program's commands. Each gets the words after its name, prints its own help, and returns an exit code.
 */

int cli_operations(int count, char **words); /* ops */
int cli_brushes(int count, char **words);
int cli_library(int count, char **words);
int cli_render(int count, char **words);
int cli_convert(int count, char **words);

/* Runs an operation: its options are made from its table. */
int cli_operate(const duct_operation *operation, int count, char **words);

#endif
