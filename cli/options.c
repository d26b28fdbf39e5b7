/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "options.h"

#include "message.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

void cli_options_add(cli_option_list *list, const cli_option *options, size_t count)
{
    cli_option *grown = list->failed ? NULL : realloc(list->items, (list->count + count) * sizeof *grown);
    if (grown == NULL) {
        list->failed = true;
        return;
    }
    list->items = grown;
    for (size_t i = 0; i < count; i++) {
        bool taken = false, letter_taken = false;
        for (size_t j = 0; j < list->count; j++) {
            taken = taken || strcmp(grown[j].name, options[i].name) == 0;
            letter_taken = letter_taken || grown[j].letter == options[i].letter;
        }
        if (!taken) {
            cli_option *item = &grown[list->count++];
            *item = options[i];
            item->letter = letter_taken ? 0 : item->letter;
        }
    }
}

void cli_options_free(cli_option_list *list)
{
    free(list->items);
    *list = (cli_option_list){NULL, 0, false};
}

bool cli_parse_number(const char *text, double *number)
{
    /* strtod() alone would take spaces, hexadecimal, "inf" and "nan". */
    if (text[strspn(text, "+-.0123456789eE")] != '\0') {
        return false;
    }
    char *end;
    double value = strtod(text, &end);
    if (end == text || *end != '\0' || !isfinite(value)) {
        return false;
    }
    *number = value;
    return true;
}

static const char *option_name_at(const void *list, size_t index)
{
    static const char *const ALWAYS[] = {"help"};
    const cli_option_list *options = list;
    if (index < options->count) {
        return options->items[index].name;
    }
    return index == options->count ? ALWAYS[0] : NULL;
}

static bool is_switch(const cli_option *option)
{
    return option->kind == CLI_SWITCH || (option->param != NULL && option->param->type == DUCT_PARAM_BOOL);
}

static bool takes_value(const cli_option *option)
{
    return option->kind != CLI_FLAG && !is_switch(option);
}

static bool is_truth(const char *text)
{
    return strcmp(text, "true") == 0 || strcmp(text, "false") == 0;
}

/* Finds the option of a name of `length` characters; `*off` where it was written as --no-NAME. */
static size_t find_option(const cli_option_list *options, const char *name, size_t length, bool *off)
{
    *off = false;
    for (size_t i = 0; i < options->count; i++) {
        if (strlen(options->items[i].name) == length && strncmp(options->items[i].name, name, length) == 0) {
            return i;
        }
    }
    if (length > 3 && strncmp(name, "no-", 3) == 0) {
        size_t found = find_option(options, name + 3, length - 3, off);
        if (found < options->count && is_switch(&options->items[found]) && !*off) {
            *off = true;
            return found;
        }
    }
    return options->count;
}

static bool is_word_of(const char *words, const char *word)
{
    size_t length = strlen(word);
    for (const char *at = words; length > 0 && (at = strstr(at, word)) != NULL; at++) {
        if ((at == words || at[-1] == ' ') && (at[length] == ' ' || at[length] == '\0')) {
            return true;
        }
    }
    return false;
}

static int check_value(const cli_option *option, const char *command, const char *value)
{
    double number;
    if (option->kind == CLI_CHOICE && !is_word_of(option->choices, value)) {
        return cli_misused("%s: --%s: '%s' is none of: %s", command, option->name, value, option->choices);
    }
    if (option->kind != CLI_REAL && option->kind != CLI_WHOLE) {
        return CLI_DONE;
    }
    bool whole = option->kind == CLI_WHOLE;
    if (!cli_parse_number(value, &number) || (whole && number != floor(number))) {
        return cli_misused("%s: --%s: '%s' is not a %snumber", command, option->name, value,
                           whole ? "whole " : "");
    }
    if (number < option->minimum || number > option->maximum) {
        return cli_misused("%s: --%s: %s is outside %g to %g", command, option->name, value, option->minimum,
                           option->maximum);
    }
    return CLI_DONE;
}

/* Stores an option's value. `attached` is what stood behind '=' (or behind the letter), or NULL; then a value
 * is taken from the next word, and `*next` moves on. */
static int take_value(cli_arguments *arguments, size_t index, const char *command, bool off,
                      const char *attached, char **words, int count, int *next)
{
    const cli_option *option = &arguments->options->items[index];
    const char *value = attached;
    if (!takes_value(option)) {
        if (value != NULL && (!is_switch(option) || off)) {
            return cli_misused("%s: --%s%s takes no value", command, off ? "no-" : "", option->name);
        }
        if (value != NULL && !is_truth(value)) {
            return cli_misused("%s: --%s: '%s' is neither true nor false", command, option->name, value);
        }
        if (value == NULL && is_switch(option) && !off && *next < count && is_truth(words[*next])) {
            value = words[(*next)++];
        }
        arguments->values[index] = off ? "false" : value != NULL ? value : "true";
        return CLI_DONE;
    }
    if (value == NULL) {
        if (*next >= count) {
            return cli_misused("%s: --%s needs a value (%s)", command, option->name, option->value);
        }
        value = words[(*next)++];
    }
    arguments->values[index] = value;
    return check_value(option, command, value);
}

static int read_long(cli_arguments *arguments, const char *command, const char *word, char **words, int count,
                     int *next)
{
    const cli_option_list *options = arguments->options;
    const char *name = word + 2, *equals = strchr(name, '=');
    size_t length = equals != NULL ? (size_t)(equals - name) : strlen(name);
    bool off;
    size_t index = find_option(options, name, length, &off);
    if (index < options->count) {
        return take_value(arguments, index, command, off, equals != NULL ? equals + 1 : NULL, words, count,
                          next);
    }
    char typed[64];
    if (length >= sizeof typed) {
        return cli_misused("%s: there is no option --%.40s...; see ductus %s --help", command, name, command);
    }
    memcpy(typed, name, length);
    typed[length] = '\0';
    const char *nearest = cli_nearest(typed, option_name_at, options);
    if (nearest == NULL && strncmp(typed, "no-", 3) == 0) {
        nearest = cli_nearest(typed + 3, option_name_at, options);
    }
    if (nearest != NULL) {
        return cli_misused("%s: there is no option --%s; did you mean --%s?", command, typed, nearest);
    }
    return cli_misused("%s: there is no option --%s; see ductus %s --help", command, typed, command);
}

static int read_short(cli_arguments *arguments, const char *command, const char *word, char **words,
                      int count, int *next)
{
    const cli_option_list *options = arguments->options;
    for (size_t i = 0; i < options->count; i++) {
        if (options->items[i].letter == word[1] && word[1] != '\0') {
            if (takes_value(&options->items[i]) || word[2] == '\0') {
                const char *attached = word[2] != '\0' ? word + 2 : NULL;
                return take_value(arguments, i, command, false, attached, words, count, next);
            }
        }
    }
    return cli_misused("%s: there is no option %s; see ductus %s --help", command, word, command);
}

int cli_arguments_read(cli_arguments *arguments, const cli_option_list *options, const char *command,
                       int count, char **words)
{
    *arguments = (cli_arguments){.options = options};
    if (options->failed) {
        return cli_fail_memory();
    }
    arguments->values = calloc(options->count + 1, sizeof *arguments->values);
    arguments->inputs = calloc((size_t)count + 1, sizeof *arguments->inputs);
    if (arguments->values == NULL || arguments->inputs == NULL) {
        return cli_fail_memory();
    }
    bool only_inputs = false;
    int result = CLI_DONE;
    for (int next = 0; next < count && result == CLI_DONE && !arguments->help;) {
        const char *word = words[next++];
        if (only_inputs || word[0] != '-' || word[1] == '\0') {
            arguments->inputs[arguments->input_count++] = word;
        } else if (strcmp(word, "--") == 0) {
            only_inputs = true;
        } else if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
            arguments->help = true;
        } else if (word[1] == '-') {
            result = read_long(arguments, command, word, words, count, &next);
        } else {
            result = read_short(arguments, command, word, words, count, &next);
        }
    }
    return result;
}

void cli_arguments_free(cli_arguments *arguments)
{
    free(arguments->values);
    free(arguments->inputs);
    *arguments = (cli_arguments){.options = NULL};
}

const char *cli_text(const cli_arguments *arguments, const char *name)
{
    for (size_t i = 0; i < arguments->options->count; i++) {
        const cli_option *option = &arguments->options->items[i];
        if (option->param == NULL && strcmp(option->name, name) == 0) {
            return arguments->values[i];
        }
    }
    return NULL;
}

bool cli_switch(const cli_arguments *arguments, const char *name, bool fallback)
{
    const char *value = cli_text(arguments, name);
    return value != NULL ? strcmp(value, "true") == 0 : fallback;
}

double cli_number(const cli_arguments *arguments, const char *name, double fallback)
{
    double number = fallback;
    const char *value = cli_text(arguments, name);
    return value != NULL && cli_parse_number(value, &number) ? number : fallback;
}
