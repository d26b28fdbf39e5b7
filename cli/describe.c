/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "describe.h"

#include "commands.h"
#include "help.h"
#include "message.h"
#include "output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char *copy(cli_pages *pages, const char *text)
{
    char *made = strdup(text);
    pages->failed = pages->failed || made == NULL;
    return made;
}

static cli_page *last_page(cli_pages *pages)
{
    return pages->failed || pages->count == 0 ? NULL : &pages->items[pages->count - 1];
}

static void hear_usage(void *user, const char *usage)
{
    cli_pages *pages = user;
    cli_page *page = last_page(pages);
    if (page != NULL && page->usage == NULL) {
        page->usage = copy(pages, usage);
    }
}

static void hear_text(void *user, const char *text)
{
    cli_pages *pages = user;
    cli_page *page = last_page(pages);
    if (page != NULL && page->text == NULL) {
        page->text = copy(pages, text);
    }
}

static void hear_row(void *user, const char *name, const char *text)
{
    cli_pages *pages = user;
    cli_page *page = last_page(pages);
    char **grown = page != NULL ? realloc(page->parts, 2 * (page->part_count + 1) * sizeof *grown) : NULL;
    if (grown == NULL) {
        pages->failed = true;
        return;
    }
    page->parts = grown;
    grown[2 * page->part_count] = copy(pages, name);
    grown[2 * page->part_count + 1] = copy(pages, text);
    page->part_count++;
}

static void hear_options(void *user, const cli_option_list *options)
{
    cli_pages *pages = user;
    cli_page *page = last_page(pages);
    cli_option *items =
        page != NULL && page->options == NULL ? calloc(options->count + 1, sizeof *items) : NULL;
    if (items == NULL) {
        pages->failed = true;
        return;
    }
    memcpy(items, options->items, options->count * sizeof *items);
    page->options = items;
    page->option_count = options->count;
}

/* Adds the page of a command, or of a part of one. */
static void add_page(cli_pages *pages, const char *command, const char *part)
{
    static char help[] = "--help";
    cli_page *grown = pages->failed ? NULL : realloc(pages->items, (pages->count + 1) * sizeof *grown);
    char name[128], word[64];
    if (grown == NULL) {
        pages->failed = true;
        return;
    }
    snprintf(name, sizeof name, "%s%s%s", command, part != NULL ? " " : "", part != NULL ? part : "");
    snprintf(word, sizeof word, "%s", part != NULL ? part : "");
    pages->items = grown;
    grown[pages->count++] = (cli_page){.name = copy(pages, name)};
    char *words[] = {word, help};
    int result;
    cli_command_run(command, part != NULL ? 2 : 1, part != NULL ? words : words + 1, &result);
}

static void add_with_parts(cli_pages *pages, const char *command)
{
    size_t index = pages->count;
    add_page(pages, command, NULL);
    for (size_t i = 0; !pages->failed && i < pages->items[index].part_count; i++) {
        add_page(pages, command, pages->items[index].parts[2 * i]);
    }
}

int cli_describe(cli_pages *pages)
{
    *pages = (cli_pages){NULL, 0, false};
    const cli_help_listener listener = {hear_usage, hear_text, hear_row, hear_options, pages};
    const char *name;
    cli_help_listen(&listener);
    for (size_t i = cli_command_count; (name = cli_command_name(i)) != NULL; i++) {
        add_with_parts(pages, name);
    }
    for (size_t i = 0; i < cli_command_count; i++) {
        add_with_parts(pages, cli_commands[i].name);
    }
    cli_help_listen(NULL);
    return pages->failed ? cli_fail_memory() : CLI_DONE;
}

void cli_describe_free(cli_pages *pages)
{
    for (size_t i = 0; i < pages->count; i++) {
        cli_page *page = &pages->items[i];
        for (size_t part = 0; part < 2 * page->part_count; part++) {
            free(page->parts[part]);
        }
        free(page->parts);
        free(page->name);
        free(page->usage);
        free(page->text);
        free(page->options);
    }
    free(pages->items);
    *pages = (cli_pages){NULL, 0, false};
}

bool cli_is_switch(const cli_option *option)
{
    return option->kind == CLI_SWITCH || (option->param != NULL && option->param->type == DUCT_PARAM_BOOL);
}

static void add_word(char words[CLI_VALUE_ROOM], const char *word)
{
    size_t used = strlen(words);
    snprintf(words + used, CLI_VALUE_ROOM - used, "%s%s", used > 0 ? " " : "", word);
}

static cli_value_kind value_of_param(const duct_param *param, char words[CLI_VALUE_ROOM])
{
    switch (param->type) {
    case DUCT_PARAM_BOOL:
        return CLI_VALUE_NONE;
    case DUCT_PARAM_CHOICE:
        for (size_t i = 0; i < param->choice_count; i++) {
            add_word(words, param->choices[i].id);
        }
        return CLI_VALUE_WORDS;
    case DUCT_PARAM_AUTO:
        add_word(words, "auto");
        return CLI_VALUE_WORDS;
    case DUCT_PARAM_HAND:
        return CLI_VALUE_HANDS;
    case DUCT_PARAM_STYLE:
        return CLI_VALUE_STYLES;
    default:
        return CLI_VALUE_FREE;
    }
}

static cli_value_kind value_of_text(const cli_option *option, char words[CLI_VALUE_ROOM])
{
    const duct_format *format;
    switch (option->completes) {
    case CLI_COMPLETES_NOTHING:
        return CLI_VALUE_FREE;
    case CLI_COMPLETES_HANDS:
        return CLI_VALUE_HANDS;
    case CLI_COMPLETES_BRUSHES:
        return CLI_VALUE_BRUSHES;
    case CLI_COMPLETES_READABLE:
        for (size_t i = 0; (format = duct_format_at(i)) != NULL; i++) {
            if (format->reads) {
                add_word(words, format->id);
            }
        }
        return CLI_VALUE_WORDS;
    case CLI_COMPLETES_WRITABLE:
        cli_output_formats(words, CLI_VALUE_ROOM);
        /* "svg, png" without its commas. */
        for (char *from = words, *to = words;; from++) {
            if (*from != ',') {
                *to++ = *from;
            }
            if (*from == '\0') {
                return CLI_VALUE_WORDS;
            }
        }
    case CLI_COMPLETES_FILES:
        break;
    }
    return CLI_VALUE_FILES;
}

cli_value_kind cli_value_of(const cli_option *option, char words[CLI_VALUE_ROOM])
{
    words[0] = '\0';
    if (option->preset_count > 0) {
        for (size_t i = 0; i < option->preset_count; i++) {
            add_word(words, option->preset[i].id);
        }
        return CLI_VALUE_WORDS;
    }
    switch (option->kind) {
    case CLI_FLAG:
    case CLI_SWITCH:
        return CLI_VALUE_NONE;
    case CLI_CHOICE:
        add_word(words, option->choices);
        return CLI_VALUE_WORDS;
    case CLI_PARAM:
        return value_of_param(option->param, words);
    case CLI_TEXT:
        return value_of_text(option, words);
    default:
        return CLI_VALUE_FREE;
    }
}

cli_value_kind cli_input_of(const cli_page *page, char words[CLI_VALUE_ROOM])
{
    const char *usage = page->usage != NULL ? page->usage : "";
    words[0] = '\0';
    if (strstr(usage, " SHELL") != NULL) {
        add_word(words, "bash zsh fish");
        return CLI_VALUE_WORDS;
    }
    if (strstr(usage, " LIB...") != NULL || strstr(usage, " HAND") != NULL) {
        return CLI_VALUE_HANDS;
    }
    return strstr(usage, " IN") != NULL ? CLI_VALUE_FILES : CLI_VALUE_FREE;
}

int cli_first_sentence(const char *text)
{
    const char *end = strstr(text, ". ");
    size_t length = end != NULL ? (size_t)(end - text) : strlen(text);
    return (int)(length > 0 && text[length - 1] == '.' ? length - 1 : length);
}
