/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "completion.h"

#include "commands.h"
#include "help.h"
#include "message.h"

#include <ductus/format.h>
#include <ductus/render.h>

#include <stdio.h>
#include <string.h>

bool cli_is_part(const cli_page *page)
{
    return strchr(page->name, ' ') != NULL;
}

const char *cli_page_summary(const cli_pages *pages, const cli_page *page)
{
    for (size_t i = 0; i < cli_command_count; i++) {
        if (strcmp(cli_commands[i].name, page->name) == 0) {
            return cli_commands[i].summary;
        }
    }
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *whole = &pages->items[i];
        size_t length = strlen(whole->name);
        for (size_t part = 0; part < whole->part_count; part++) {
            if (strncmp(page->name, whole->name, length) == 0 && page->name[length] == ' ' &&
                strcmp(page->name + length + 1, whole->parts[2 * part]) == 0) {
                return whole->parts[2 * part + 1];
            }
        }
    }
    return page->text != NULL ? page->text : "";
}

void cli_print_quoted(const char *text, int size, const char *quote, const char *escaped)
{
    putchar('\'');
    for (int i = 0; i < size && text[i] != '\0'; i++) {
        if (text[i] == '\'') {
            fputs(quote, stdout);
        } else {
            if (strchr(escaped, text[i]) != NULL) {
                putchar('\\');
            }
            putchar(text[i]);
        }
    }
    putchar('\'');
}

/* One name a line, for the scripts; nothing where there are none. */
static int print_names(duct_param_type type)
{
    const duct_param param = {.type = type};
    char **names = NULL;
    size_t count = 0;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_param_names(NULL, &param, &names, &count, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    for (size_t i = 0; i < count; i++) {
        puts(names[i]);
        duct_memory_free(NULL, names[i]);
    }
    duct_memory_free(NULL, names);
    return CLI_DONE;
}

static int print_brushes(void)
{
    char **names = NULL;
    size_t count = 0;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_brush_list(NULL, &names, &count, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    for (size_t i = 0; i < count; i++) {
        puts(names[i]);
        duct_memory_free(NULL, names[i]);
    }
    duct_memory_free(NULL, names);
    return CLI_DONE;
}

static int print_script(const char *shell)
{
    static const struct {
        const char *name;
        void (*print)(const cli_pages *pages);
    } SHELLS[] = {{"bash", cli_complete_bash}, {"zsh", cli_complete_zsh}, {"fish", cli_complete_fish}};
    if (strcmp(shell, "hands") == 0) {
        return print_names(DUCT_PARAM_HAND);
    }
    if (strcmp(shell, "styles") == 0) {
        return print_names(DUCT_PARAM_STYLE);
    }
    if (strcmp(shell, "brushes") == 0) {
        return print_brushes();
    }
    for (size_t i = 0; i < sizeof SHELLS / sizeof *SHELLS; i++) {
        if (strcmp(shell, SHELLS[i].name) == 0) {
            cli_pages pages;
            int result = cli_describe(&pages);
            if (result == CLI_DONE) {
                SHELLS[i].print(&pages);
            }
            cli_describe_free(&pages);
            return result;
        }
    }
    return cli_misused("completion: '%s' is none of the shells: bash, zsh, fish", shell);
}

int cli_completion_script(int count, char **words)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    int result = cli_arguments_read(&arguments, &options, "completion", count, words);
    if (result == CLI_DONE && arguments.help) {
        cli_help_usage("completion SHELL");
        cli_help_text(
            "Prints the script by which a shell (bash, zsh or fish) completes commands, options, choices "
            "and the names of hands, styles and brushes. An installation has them in their usual places; "
            "otherwise: source <(ductus completion bash).");
    } else if (result == CLI_DONE) {
        result = arguments.input_count == 1 ? print_script(arguments.inputs[0])
                                            : cli_misused("completion: name one shell: bash, zsh or fish");
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}
