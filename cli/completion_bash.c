/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "completion.h"

#include <stdio.h>
#include <string.h>

/* Works with bash alone, without the package bash-completion. */

static const char HEAD[] =
    "# Completion of ductus for bash; made by 'ductus completion bash'.\n"
    "\n"
    "# What there is to say: the words of the line, or files.\n"
    "_ductus_words() { COMPREPLY=($(compgen -W \"$1\" -- \"$current\")); compopt +o default 2>/dev/null; "
    "return 0; }\n"
    "_ductus_names() {\n"
    "  local IFS=$'\\n'\n"
    "  COMPREPLY=($(compgen -W \"$(\"${COMP_WORDS[0]}\" completion \"$1\" 2>/dev/null)\" -- \"$current\")\n"
    "             $(compgen -f -- \"$current\"))\n"
    "  compopt -o filenames 2>/dev/null\n"
    "  return 0\n"
    "}\n"
    "_ductus_files() {\n"
    "  local IFS=$'\\n'\n"
    "  COMPREPLY=($(compgen -f -- \"$current\"))\n"
    "  compopt -o filenames 2>/dev/null\n"
    "  return 0\n"
    "}\n"
    "_ductus_nothing() { COMPREPLY=(); compopt +o default 2>/dev/null; return 0; }\n";

static const char BODY[] =
    "\n"
    "_ductus() {\n"
    "  local current=${COMP_WORDS[COMP_CWORD]} previous= command=${COMP_WORDS[1]} first=2 i\n"
    "  COMPREPLY=()\n"
    "  if [ \"$COMP_CWORD\" -gt 0 ]; then previous=${COMP_WORDS[COMP_CWORD - 1]}; fi\n"
    "  # bash cuts --option=value into three words.\n"
    "  if [ \"$current\" = = ]; then\n"
    "    current=\n"
    "  elif [ \"$previous\" = = ] && [ \"$COMP_CWORD\" -gt 1 ]; then\n"
    "    previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
    "  fi\n"
    "  if [ \"$COMP_CWORD\" -le 1 ]; then\n"
    "    _ductus_words \"$_ductus_commands --help --version\"\n"
    "    return\n"
    "  fi\n"
    "  local parts\n"
    "  parts=$(_ductus_parts \"$command\")\n"
    "  if [ -n \"$parts\" ]; then\n"
    "    if [ \"$COMP_CWORD\" -eq 2 ]; then\n"
    "      _ductus_words \"$parts --help\"\n"
    "      return\n"
    "    fi\n"
    "    command=\"$command ${COMP_WORDS[2]}\"\n"
    "    first=3\n"
    "  fi\n"
    "  if [ \"$command\" = help ]; then\n"
    "    _ductus_words \"$_ductus_commands --man\"\n"
    "    return\n"
    "  fi\n"
    "  for ((i = first; i < COMP_CWORD; i++)); do\n"
    "    if [ \"${COMP_WORDS[i]}\" = -- ]; then _ductus_files; return; fi\n"
    "  done\n"
    "  if _ductus_value \"$command $previous\"; then return; fi\n"
    "  case $current in\n"
    "    -*) _ductus_words \"$(_ductus_options \"$command\") --help\" ;;\n"
    "    *) _ductus_value \"$command\" || _ductus_nothing ;;\n"
    "  esac\n"
    "}\n"
    "complete -o default -F _ductus ductus\n";

static void print_value(cli_value_kind kind, const char *words)
{
    switch (kind) {
    case CLI_VALUE_NONE:
        break;
    case CLI_VALUE_FREE:
        puts(") _ductus_nothing ;;");
        break;
    case CLI_VALUE_WORDS:
        fputs(") _ductus_words ", stdout);
        cli_print_quoted(words, CLI_VALUE_ROOM, "'\\''", "");
        puts(" ;;");
        break;
    case CLI_VALUE_FILES:
        puts(") _ductus_files ;;");
        break;
    case CLI_VALUE_HANDS:
        puts(") _ductus_names hands ;;");
        break;
    case CLI_VALUE_BRUSHES:
        puts(") _ductus_names brushes ;;");
        break;
    case CLI_VALUE_STYLES:
        puts(") _ductus_names styles ;;");
        break;
    }
}

static void print_commands(const cli_pages *pages)
{
    fputs("\n_ductus_commands='", stdout);
    for (size_t i = 0; i < pages->count; i++) {
        if (!cli_is_part(&pages->items[i])) {
            printf("%s ", pages->items[i].name);
        }
    }
    fputs("help'\n\n_ductus_parts() {\n  case $1 in\n", stdout);
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *page = &pages->items[i];
        if (page->part_count > 0) {
            printf("    %s) echo '", page->name);
            for (size_t part = 0; part < page->part_count; part++) {
                printf("%s%s", part > 0 ? " " : "", page->parts[2 * part]);
            }
            puts("' ;;");
        }
    }
    fputs("  esac\n}\n", stdout);
}

static void print_options(const cli_pages *pages)
{
    fputs("\n_ductus_options() {\n  case $1 in\n", stdout);
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *page = &pages->items[i];
        if (page->option_count == 0) {
            continue;
        }
        printf("    '%s') echo '", page->name);
        for (size_t j = 0; j < page->option_count; j++) {
            const cli_option *option = &page->options[j];
            printf("%s--%s", j > 0 ? " " : "", option->name);
            if (option->letter != 0) {
                printf(" -%c", option->letter);
            }
            if (cli_is_switch(option)) {
                printf(" --no-%s", option->name);
            }
        }
        puts("' ;;");
    }
    fputs("  esac\n}\n", stdout);
}

/* By "COMMAND --OPTION" the values of options, by "COMMAND" what is no option. */
static void print_values(const cli_pages *pages)
{
    char words[CLI_VALUE_ROOM];
    fputs("\n_ductus_value() {\n  case $1 in\n", stdout);
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *page = &pages->items[i];
        for (size_t j = 0; j < page->option_count; j++) {
            const cli_option *option = &page->options[j];
            cli_value_kind kind = cli_value_of(option, words);
            if (kind == CLI_VALUE_NONE) {
                continue;
            }
            printf("    '%s --%s'", page->name, option->name);
            if (option->letter != 0) {
                printf(" | '%s -%c'", page->name, option->letter);
            }
            print_value(kind, words);
        }
        cli_value_kind kind = cli_input_of(page, words);
        if (page->part_count == 0 && kind != CLI_VALUE_FREE) {
            printf("    '%s'", page->name);
            print_value(kind, words);
        }
    }
    fputs("    *) return 1 ;;\n  esac\n}\n", stdout);
}

void cli_complete_bash(const cli_pages *pages)
{
    fputs(HEAD, stdout);
    print_commands(pages);
    print_options(pages);
    print_values(pages);
    fputs(BODY, stdout);
}
