/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "completion.h"

#include <stdio.h>
#include <string.h>

static const char HEAD[] =
    "# Completion of ductus for fish; made by 'ductus completion fish'.\n"
    "\n"
    "function __ductus_names\n"
    "    set -l words (commandline -opc)\n"
    "    eval $words[1] completion $argv[1] 2>/dev/null\n"
    "end\n"
    "\n"
    "# True where the words behind 'ductus' begin with the given ones.\n"
    "function __ductus_is\n"
    "    set -l words (commandline -opc)\n"
    "    for i in (seq (count $argv))\n"
    "        set -l at (math $i + 1)\n"
    "        if test (count $words) -lt $at\n"
    "            return 1\n"
    "        end\n"
    "        if test \"$words[$at]\" != \"$argv[$i]\"\n"
    "            return 1\n"
    "        end\n"
    "    end\n"
    "end\n"
    "\n"
    "# True where there are exactly so many words before the one that is typed.\n"
    "function __ductus_at\n"
    "    test (count (commandline -opc)) -eq $argv[1]\n"
    "end\n"
    "\n"
    "complete -c ductus -f\n"
    "complete -c ductus -n '__ductus_at 1' -l version -d 'Print the version'\n"
    "complete -c ductus -s h -l help -d 'Print help'\n"
    "complete -c ductus -n '__ductus_at 1' -a help -d 'Print help, or the manual page'\n";

static const char QUOTE[] = "\\'", SPECIAL[] = "\\";

static void print_value(cli_value_kind kind, const char *words)
{
    switch (kind) {
    case CLI_VALUE_NONE:
        break;
    case CLI_VALUE_FREE:
        fputs(" -x", stdout);
        break;
    case CLI_VALUE_WORDS:
        fputs(" -x -a ", stdout);
        cli_print_quoted(words, CLI_VALUE_ROOM, QUOTE, SPECIAL);
        break;
    case CLI_VALUE_FILES:
        fputs(" -r -F", stdout);
        break;
    case CLI_VALUE_HANDS:
        fputs(" -r -F -a '(__ductus_names hands)'", stdout);
        break;
    case CLI_VALUE_BRUSHES:
        fputs(" -r -F -a '(__ductus_names brushes)'", stdout);
        break;
    case CLI_VALUE_STYLES:
        fputs(" -r -F -a '(__ductus_names styles)'", stdout);
        break;
    }
}

static void print_condition(const cli_page *page)
{
    printf("complete -c ductus -n '__ductus_is %s'", page->name);
}

static void print_option(const cli_page *page, const cli_option *option)
{
    char words[CLI_VALUE_ROOM];
    cli_value_kind kind = cli_value_of(option, words);
    for (int off = 0; off <= (cli_is_switch(option) ? 1 : 0); off++) {
        print_condition(page);
        if (option->letter != 0) {
            printf(" -s %c", option->letter);
        }
        printf(" -l %s%s", off ? "no-" : "", option->name);
        print_value(kind, words);
        fputs(" -d ", stdout);
        cli_print_quoted(option->help, cli_first_sentence(option->help), QUOTE, SPECIAL);
        putchar('\n');
    }
}

static void print_name(const cli_pages *pages, const cli_page *page)
{
    const char *space = strchr(page->name, ' '), *summary = cli_page_summary(pages, page);
    if (space == NULL) {
        printf("complete -c ductus -n '__ductus_at 1' -a %s -d ", page->name);
    } else {
        printf("complete -c ductus -n '__ductus_at 2; and __ductus_is %.*s' -a %s -d ",
               (int)(space - page->name), page->name, space + 1);
    }
    cli_print_quoted(summary, cli_first_sentence(summary), QUOTE, SPECIAL);
    putchar('\n');
}

void cli_complete_fish(const cli_pages *pages)
{
    char words[CLI_VALUE_ROOM];
    fputs(HEAD, stdout);
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *page = &pages->items[i];
        print_name(pages, page);
        for (size_t j = 0; j < page->option_count; j++) {
            print_option(page, &page->options[j]);
        }
        cli_value_kind kind = cli_input_of(page, words);
        if (page->part_count == 0 && kind != CLI_VALUE_FREE) {
            print_condition(page);
            if (kind == CLI_VALUE_WORDS) {
                printf(" -a '%s'\n", words);
            } else {
                puts(kind == CLI_VALUE_HANDS ? " -F -a '(__ductus_names hands)'" : " -F");
            }
        }
    }
}
