/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"
#include "help.h"
#include "json.h"
#include "message.h"

#include <ductus/format.h>
#include <ductus/render.h>

#include <stdio.h>

/* ops, brushes and styles: what there is. */

static const cli_option JSON[] = {
    {.name = "json", .kind = CLI_FLAG, .group = "Options", .help = "Print it as JSON, for programs."},
};

/* Reads the words of a command that only prints a list; `*json` tells how. True where it is to go on. */
static bool read_words(const char *command, const char *summary, int count, char **words, bool *json,
                       int *result)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    cli_options_add(&options, JSON, 1);
    *result = cli_arguments_read(&arguments, &options, command, count, words);
    bool go_on = false;
    if (*result == CLI_DONE && arguments.help) {
        char usage[64];
        snprintf(usage, sizeof usage, "%s [--json]", command);
        cli_help_usage(usage);
        cli_help_text(summary);
        cli_help_options(&options);
    } else if (*result == CLI_DONE && arguments.input_count > 0) {
        *result = cli_misused("%s: '%s': takes no files", command, arguments.inputs[0]);
    } else if (*result == CLI_DONE) {
        *json = cli_text(&arguments, "json") != NULL;
        go_on = true;
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return go_on;
}

static void print_operation(const duct_operation *operation)
{
    printf("%s\n", operation->id);
    cli_help_row("", operation->summary, 4);
    for (size_t i = 0; i < operation->param_count; i++) {
        char name[96];
        snprintf(name, sizeof name, "--%s", operation->params[i].id);
        cli_help_row(name, operation->params[i].tooltip, 22);
    }
}

int cli_operations(int count, char **words)
{
    bool json = false;
    int result;
    if (!read_words("ops", "Lists the operations and their parameters.", count, words, &json, &result)) {
        return result;
    }
    if (json) {
        char *text = NULL;
        duct_error error = {DUCT_OK, ""};
        duct_status status = duct_operations_json(NULL, &text, &error);
        if (status != DUCT_OK) {
            return cli_fail_error(NULL, status, &error);
        }
        fputs(text, stdout);
        duct_memory_free(NULL, text);
        return CLI_DONE;
    }
    const duct_operation *operation;
    for (size_t i = 0; (operation = duct_operation_at(i)) != NULL; i++) {
        if (i > 0) {
            putchar('\n');
        }
        print_operation(operation);
    }
    return CLI_DONE;
}

/* Prints names, which it frees. */
static void print_names(char **names, size_t count, bool json)
{
    fputs(json ? "[" : "", stdout);
    for (size_t i = 0; i < count; i++) {
        if (json) {
            fputs(i > 0 ? ", " : "", stdout);
            cli_json_string(names[i]);
        } else {
            puts(names[i]);
        }
        duct_memory_free(NULL, names[i]);
    }
    fputs(json ? "]\n" : "", stdout);
    duct_memory_free(NULL, names);
}

int cli_brushes(int count, char **words)
{
    bool json = false;
    int result;
    if (!read_words("brushes", "Lists the brushes that --brush takes by name.", count, words, &json,
                    &result)) {
        return result;
    }
    char **names = NULL;
    size_t name_count = 0;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_brush_list(NULL, &names, &name_count, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    print_names(names, name_count, json);
    return CLI_DONE;
}

int cli_styles(int count, char **words)
{
    bool json = false;
    int result;
    if (!read_words("styles", "Lists the styles that operations with example curves take by name.", count,
                    words, &json, &result)) {
        return result;
    }
    const duct_param param = {.type = DUCT_PARAM_STYLE};
    char **names = NULL;
    size_t name_count = 0;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_param_names(NULL, &param, &names, &name_count, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    print_names(names, name_count, json);
    return CLI_DONE;
}
