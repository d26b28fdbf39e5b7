/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_COMMANDS_H
#define DUCTUS_CLI_COMMANDS_H

#include <ductus/operation.h>

#include <stdbool.h>
#include <stddef.h>

/* The program's commands. Each gets the words after its name, prints its own help, and returns an exit code.
 */

int cli_operations(int count, char **words); /* ops */
int cli_brushes(int count, char **words);
int cli_styles(int count, char **words);
int cli_library(int count, char **words);
int cli_render(int count, char **words);
int cli_convert(int count, char **words);
int cli_show(int count, char **words);
int cli_completion_script(int count, char **words); /* completion */

/* Runs an operation: its options are made from its table. */
int cli_operate(const duct_operation *operation, int count, char **words);

/* The commands that are no operations. */
typedef struct cli_command {
    const char *name;
    int (*run)(int count, char **words);
    const char *summary;
} cli_command;

extern const cli_command cli_commands[];
extern const size_t cli_command_count;

/* The names of the commands and then of the operations; NULL past the end. */
const char *cli_command_name(size_t index);

/* Runs a command or operation by its name; false where there is none of that name. */
bool cli_command_run(const char *name, int count, char **words, int *result);

#endif
