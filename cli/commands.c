/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"

#include <string.h>

const cli_command cli_commands[] = {
    {"render", cli_render, "Paint drawings with the brush engine."},
    {"convert", cli_convert, "Write drawings in another format."},
    {"show", cli_show, "Draw diagrams of pose and of a trace's segments."},
    {"library", cli_library, "Make, measure and list stroke libraries (hands)."},
    {"brushes", cli_brushes, "List the brushes."},
    {"styles", cli_styles, "List the styles of example curves."},
    {"ops", cli_operations, "List the operations and their parameters."},
    {"completion", cli_completion_script, "Print a shell's completion script."},
};
const size_t cli_command_count = sizeof cli_commands / sizeof *cli_commands;

const char *cli_command_name(size_t index)
{
    if (index < cli_command_count) {
        return cli_commands[index].name;
    }
    const duct_operation *operation = duct_operation_at(index - cli_command_count);
    return operation != NULL ? operation->id : NULL;
}

bool cli_command_run(const char *name, int count, char **words, int *result)
{
    const duct_operation *operation;
    for (size_t i = 0; i < cli_command_count; i++) {
        if (strcmp(name, cli_commands[i].name) == 0) {
            *result = cli_commands[i].run(count, words);
            return true;
        }
    }
    for (size_t i = 0; (operation = duct_operation_at(i)) != NULL; i++) {
        if (strcmp(name, operation->id) == 0) {
            *result = cli_operate(operation, count, words);
            return true;
        }
    }
    return false;
}
