/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "help.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

enum { NARROWEST = 48, WIDEST = 110, USUAL = 80, INDENT = 2, COLUMN = 28, LINE = CLI_HELP_LINE };

/* Where help goes belongs to the process, as the terminal does. */
static const cli_help_listener *heard;

void cli_help_listen(const cli_help_listener *listener)
{
    heard = listener;
}

static int terminal_width(void)
{
    struct winsize size;
    int width = 0;
    if (isatty(STDOUT_FILENO) == 1 && ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) {
        width = size.ws_col;
    }
    const char *columns = getenv("COLUMNS");
    if (width <= 0 && columns != NULL) {
        width = atoi(columns);
    }
    if (width <= 0) {
        width = USUAL;
    }
    return width < NARROWEST ? NARROWEST : width > WIDEST ? WIDEST : width;
}

/* Columns that a piece of UTF-8 takes: characters, not bytes. */
static int columns_of(const char *text, size_t size)
{
    int columns = 0;
    for (size_t i = 0; i < size; i++) {
        columns += ((unsigned char)text[i] & 0xc0) != 0x80;
    }
    return columns;
}

/* Prints words from column `at`, wrapped and indented by `indent`. */
static void print_wrapped(const char *text, int indent, int at)
{
    int width = terminal_width();
    bool first = true;
    while (*text != '\0') {
        size_t size = strcspn(text, " ");
        int columns = columns_of(text, size);
        if (!first && at + 1 + columns > width) {
            printf("\n%*s", indent, "");
            at = indent;
        } else if (!first) {
            putchar(' ');
            at++;
        }
        fwrite(text, 1, size, stdout);
        at += columns;
        first = false;
        text += size;
        text += strspn(text, " ");
    }
    putchar('\n');
}

void cli_help_usage(const char *usage)
{
    if (heard != NULL) {
        heard->usage(heard->user, usage);
        return;
    }
    printf("Usage: ductus %s\n\n", usage);
}

void cli_help_text(const char *text)
{
    if (heard != NULL) {
        heard->text(heard->user, text);
        return;
    }
    print_wrapped(text, 0, 0);
}

static void print_row(int indent, const char *name, const char *text, int column)
{
    printf("%*s%s", indent, "", name);
    int at = indent + columns_of(name, strlen(name));
    if (at + 2 > column) {
        putchar('\n');
        at = 0;
    }
    printf("%*s", column - at, "");
    print_wrapped(text, column, column);
}

void cli_help_row(const char *name, const char *text, int column)
{
    if (heard != NULL) {
        heard->row(heard->user, name, text);
        return;
    }
    print_row(INDENT, name, text, column);
}

void cli_help_name(const cli_option *option, char name[LINE])
{
    const duct_param *param = option->param;
    char letter[8] = "";
    if (option->letter != 0) {
        snprintf(letter, sizeof letter, "-%c, ", option->letter);
    }
    if (option->kind == CLI_SWITCH || (param != NULL && param->type == DUCT_PARAM_BOOL)) {
        snprintf(name, LINE, "--[no-]%s", option->name);
    } else {
        snprintf(name, LINE, "%s--%s%s%s", letter, option->name, option->value != NULL ? " " : "",
                 option->value != NULL ? option->value : "");
    }
}

/* "0 to 10 pixels, default 5" */
void cli_help_facts(const cli_option *option, char facts[LINE])
{
    const duct_param *param = option->param;
    const char *fallback = param != NULL ? param->fallback : option->fallback;
    const char *unit = param != NULL && param->unit != NULL ? param->unit : "";
    bool number = option->kind == CLI_REAL || option->kind == CLI_WHOLE;
    double minimum = option->minimum, maximum = option->maximum;
    const char *otherwise = "";
    if (param != NULL) {
        number =
            param->type == DUCT_PARAM_INT || param->type == DUCT_PARAM_REAL || param->type == DUCT_PARAM_AUTO;
        minimum = param->minimum;
        maximum = param->maximum;
        otherwise = param->type == DUCT_PARAM_AUTO ? "auto, or " : "";
    }
    size_t used = 0;
    facts[0] = '\0';
    if (number) {
        used += (size_t)snprintf(facts, LINE, "%s%g to %g%s%s", otherwise, minimum, maximum,
                                 *unit != '\0' ? " " : "", unit);
    }
    if (fallback != NULL && *fallback != '\0' && used < LINE) {
        snprintf(facts + used, LINE - used, "%sdefault %s", used > 0 ? ", " : "", fallback);
    } else if (fallback != NULL && param != NULL && param->type != DUCT_PARAM_STROKES && used < LINE) {
        snprintf(facts + used, LINE - used, "%shas to be given", used > 0 ? ", " : "");
    }
}

static void print_choices(const cli_option *option)
{
    const duct_param *param = option->param;
    char name[LINE];
    for (size_t i = 0; param != NULL && i < param->choice_count; i++) {
        const duct_choice *choice = &param->choices[i];
        snprintf(name, sizeof name, "%s", choice->id);
        print_row(COLUMN, name, choice->tooltip, COLUMN + 12);
    }
    for (size_t i = 0; i < option->preset_count; i++) {
        print_row(COLUMN, option->preset[i].id, option->preset[i].tooltip, COLUMN + 12);
    }
}

static void print_option(const cli_option *option)
{
    char name[LINE], facts[LINE], text[4 * LINE];
    cli_help_name(option, name);
    cli_help_facts(option, facts);
    snprintf(text, sizeof text, "%s%s%s%s", option->help, facts[0] != '\0' ? " (" : "", facts,
             facts[0] != '\0' ? ")" : "");
    print_row(INDENT, name, text, COLUMN);
    print_choices(option);
}

void cli_help_options(const cli_option_list *options)
{
    if (heard != NULL) {
        heard->options(heard->user, options);
        return;
    }
    for (size_t i = 0; i < options->count; i++) {
        const char *group = options->items[i].group;
        bool seen = false;
        for (size_t j = 0; j < i; j++) {
            seen = seen || strcmp(options->items[j].group, group) == 0;
        }
        if (seen) {
            continue;
        }
        printf("\n%s:\n", group);
        for (size_t j = i; j < options->count; j++) {
            if (strcmp(options->items[j].group, group) == 0) {
                print_option(&options->items[j]);
            }
        }
    }
}
