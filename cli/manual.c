/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "manual.h"

#include "describe.h"
#include "help.h"
#include "message.h"

#include <ductus/version.h>

#include <stdio.h>
#include <string.h>

static const char DESCRIPTION[] =
    "Ductus draws with somebody's hand: strokes go in, strokes of that hand come out. A hand is a library of "
    "one "
    "person's recorded strokes; a few synthetic ones come with the program. Files are drawings (SVG, InkML "
    "and "
    "others) or images; the ending of OUT picks the format, and - is standard input or output. Output files "
    "appear "
    "whole or not at all. The same input, options and seed give the same bytes, on any number of threads.";

/* Text with what troff would take for itself escaped. `hyphens`: a - is the character of options. */
static void print_escaped(const char *text, bool hyphens)
{
    if (*text == '.' || *text == '\'') {
        fputs("\\&", stdout);
    }
    for (; *text != '\0'; text++) {
        if (*text == '\\') {
            fputs("\\e", stdout);
        } else if (*text == '-' && hyphens) {
            fputs("\\-", stdout);
        } else if (*text == '\'') {
            fputs("\\(aq", stdout);
        } else if (*text == '`') {
            fputs("\\(ga", stdout);
        } else if (*text == '^') {
            fputs("\\(ha", stdout);
        } else if (*text == '~') {
            fputs("\\(ti", stdout);
        } else {
            putchar(*text);
        }
    }
}

static void print_paragraph(const char *text)
{
    print_escaped(text, true);
    putchar('\n');
}

/* A term in bold and what it means. */
static void print_item(const char *name, const char *text)
{
    fputs(".TP\n.B ", stdout);
    print_escaped(name, true);
    putchar('\n');
    print_paragraph(text);
}

static void print_choice(const char *name, const char *text)
{
    fputs(".TP 14\n.I ", stdout);
    print_escaped(name, true);
    putchar('\n');
    print_paragraph(text);
}

static void print_option(const cli_option *option)
{
    char name[CLI_HELP_LINE], facts[CLI_HELP_LINE];
    size_t choices = (option->param != NULL ? option->param->choice_count : 0) + option->preset_count;
    cli_help_name(option, name);
    cli_help_facts(option, facts);
    if (option->kind == CLI_CHOICE) {
        size_t used = strlen(facts);
        snprintf(facts + used, sizeof facts - used, "%sone of: %s", used > 0 ? "; " : "", option->choices);
    }
    fputs(".TP\n.B ", stdout);
    print_escaped(name, true);
    putchar('\n');
    print_escaped(option->help, true);
    if (facts[0] != '\0') {
        fputs(" (", stdout);
        print_escaped(facts, true);
        putchar(')');
    }
    putchar('\n');
    if (choices == 0) {
        return;
    }
    fputs(".RS\n", stdout);
    for (size_t i = 0; option->param != NULL && i < option->param->choice_count; i++) {
        print_choice(option->param->choices[i].id, option->param->choices[i].tooltip);
    }
    for (size_t i = 0; i < option->preset_count; i++) {
        print_choice(option->preset[i].id, option->preset[i].tooltip);
    }
    fputs(".RE\n", stdout);
}

/* An option is common where two commands have the very same. */
static bool is_common(const cli_pages *pages, const cli_option *option)
{
    size_t found = 0;
    for (size_t i = 0; i < pages->count; i++) {
        for (size_t j = 0; j < pages->items[i].option_count; j++) {
            const cli_option *other = &pages->items[i].options[j];
            found += option->param == NULL && strcmp(other->name, option->name) == 0 &&
                     strcmp(other->help, option->help) == 0;
        }
    }
    return found > 1;
}

static void print_group(const char *group, const char **last)
{
    if (*last == NULL || strcmp(*last, group) != 0) {
        fputs(".PP\n.I ", stdout);
        print_escaped(group, true);
        putchar('\n');
        *last = group;
    }
}

static void print_options(const cli_pages *pages, const cli_page *page)
{
    const char *last = NULL;
    size_t common = 0;
    for (size_t i = 0; i < page->option_count; i++) {
        if (is_common(pages, &page->options[i])) {
            common++;
        } else {
            print_group(page->options[i].group, &last);
            print_option(&page->options[i]);
        }
    }
    if (common == 0) {
        return;
    }
    fputs(".PP\nSee COMMON OPTIONS for:", stdout);
    for (size_t i = 0; i < page->option_count; i++) {
        if (is_common(pages, &page->options[i])) {
            fputs(" \\-\\-", stdout);
            print_escaped(page->options[i].name, true);
            common--;
            putchar(common > 0 ? ',' : '.');
        }
    }
    putchar('\n');
}

static bool is_first(const cli_pages *pages, size_t page, size_t option)
{
    const cli_option *wanted = &pages->items[page].options[option];
    for (size_t i = 0; i < page; i++) {
        for (size_t j = 0; j < pages->items[i].option_count; j++) {
            const cli_option *other = &pages->items[i].options[j];
            if (strcmp(other->name, wanted->name) == 0 && strcmp(other->help, wanted->help) == 0) {
                return false;
            }
        }
    }
    return true;
}

static void print_common(const cli_pages *pages)
{
    const char *last = NULL;
    fputs(".SH COMMON OPTIONS\n", stdout);
    for (size_t i = 0; i < pages->count; i++) {
        for (size_t j = 0; j < pages->items[i].option_count; j++) {
            const cli_option *option = &pages->items[i].options[j];
            if (is_common(pages, option) && is_first(pages, i, j)) {
                print_group(option->group, &last);
                print_option(option);
            }
        }
    }
}

static void print_page(const cli_pages *pages, const cli_page *page)
{
    if (page->part_count > 0) {
        return; /* its parts have pages of their own */
    }
    fputs(".SS ductus ", stdout);
    print_escaped(page->usage != NULL ? page->usage : page->name, true);
    putchar('\n');
    print_paragraph(page->text != NULL ? page->text : "");
    print_options(pages, page);
}

static void print_end(void)
{
    fputs(".SH EXIT STATUS\n", stdout);
    print_item("0", "Done.");
    print_item("1",
               "The input or the work failed; one line on standard error names the file, the place and the "
               "reason, and nothing was written.");
    print_item("2", "The command line was not right.");
    print_item("128 + N", "Stopped by signal N; nothing was written.");
    fputs(".SH FILES\n", stdout);
    print_item("~/.local/share/ductus/hands",
               "Your own hands: libraries that can be named without their paths. "
               "$XDG_DATA_HOME/ductus/hands where that is set.");
    fputs(".SH ENVIRONMENT\n", stdout);
    print_item("DUCTUS_DATA_FOLDER",
               "The folder of the hands and brushes that come with Ductus, where it is not "
               "the one of the installation.");
    print_item("TMPDIR", "Where an image lies while it is made for standard output.");
}

int cli_manual_print(void)
{
    cli_pages pages;
    int result = cli_describe(&pages);
    if (result == CLI_DONE) {
        printf(".\\\" Made by 'ductus help --man'; do not edit.\n.TH DUCTUS 1 \"\" \"Ductus %s\" \"User "
               "Commands\"\n.SH NAME\nductus \\- draw with somebody\\(aqs hand\n.SH SYNOPSIS\n",
               duct_version());
        for (size_t i = 0; i < pages.count; i++) {
            if (pages.items[i].part_count == 0) {
                fputs(i > 0 ? ".br\n.B ductus " : ".B ductus ", stdout);
                print_paragraph(pages.items[i].usage != NULL ? pages.items[i].usage : pages.items[i].name);
            }
        }
        fputs(".SH DESCRIPTION\n", stdout);
        print_paragraph(DESCRIPTION);
        fputs(".SH COMMANDS\n", stdout);
        for (size_t i = 0; i < pages.count; i++) {
            print_page(&pages, &pages.items[i]);
        }
        print_common(&pages);
        print_end();
    }
    cli_describe_free(&pages);
    return result;
}
