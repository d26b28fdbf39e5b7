/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "completion.h"

#include <stdio.h>
#include <string.h>

static const char HEAD[] = "#compdef ductus\n"
                           "# Completion of ductus for zsh; made by 'ductus completion zsh'.\n"
                           "\n"
                           "# The command as it was typed, which need not be in the path.\n"
                           "_ductus_names() {\n"
                           "  local -a names expl\n"
                           "  names=(${(f)\"$($_ductus_program completion $1 2>/dev/null)\"})\n"
                           "  local found=1\n"
                           "  _wanted names expl $1 compadd -a names && found=0\n"
                           "  _files && found=0\n"
                           "  return found\n"
                           "}\n";

/* _arguments cuts at colons and closes at brackets. */
static const char SPECIAL[] = "\\:[]";

static void print_action(cli_value_kind kind, const char *value, const char *words)
{
    printf("':%s:", value);
    switch (kind) {
    case CLI_VALUE_WORDS:
        printf("(%s)", words);
        break;
    case CLI_VALUE_FILES:
        fputs("_files", stdout);
        break;
    case CLI_VALUE_HANDS:
        fputs("{_ductus_names hands}", stdout);
        break;
    case CLI_VALUE_BRUSHES:
        fputs("{_ductus_names brushes}", stdout);
        break;
    case CLI_VALUE_STYLES:
        fputs("{_ductus_names styles}", stdout);
        break;
    default:
        putchar(' ');
        break;
    }
    putchar('\'');
}

/* '--name=[what it does]':value:action, with the name's other form before it. */
static void print_option(const cli_option *option)
{
    char words[CLI_VALUE_ROOM];
    cli_value_kind kind = cli_value_of(option, words);
    int size = cli_first_sentence(option->help);
    const char *equals = kind == CLI_VALUE_NONE ? "" : "=";
    fputs(" \\\n      ", stdout);
    if (cli_is_switch(option)) {
        printf("'(--%s --no-%s)'{--%s,--no-%s}", option->name, option->name, option->name, option->name);
    } else if (option->letter != 0) {
        printf("'(-%c --%s)'{-%c%s,--%s%s}", option->letter, option->name, option->letter,
               kind == CLI_VALUE_NONE ? "" : "+", option->name, equals);
    } else {
        printf("--%s%s", option->name, equals);
    }
    fputs("'['", stdout);
    cli_print_quoted(option->help, size, "'\\''", SPECIAL);
    fputs("']'", stdout);
    if (kind != CLI_VALUE_NONE) {
        const char *value = option->value != NULL ? option->value : "value";
        char shown[32];
        snprintf(shown, sizeof shown, "%.*s", (int)strcspn(value, "|:'"), value);
        print_action(kind, shown, words);
    }
}

static void print_page(const cli_page *page)
{
    char words[CLI_VALUE_ROOM];
    printf("    '%s')\n      _arguments -s -S", page->name);
    for (size_t i = 0; i < page->option_count; i++) {
        print_option(&page->options[i]);
    }
    fputs(" \\\n      '(- *)'{-h,--help}'[Print help]'", stdout);
    cli_value_kind kind = cli_input_of(page, words);
    if (kind != CLI_VALUE_FREE) {
        fputs(" \\\n      '*'", stdout);
        print_action(kind, "file", words);
    }
    puts(" ;;");
}

static void print_list(const cli_pages *pages, const char *variable, const char *whole)
{
    printf("%s=(", variable);
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *page = &pages->items[i];
        size_t length = strlen(whole);
        bool listed = length == 0 ? !cli_is_part(page)
                                  : strncmp(page->name, whole, length) == 0 && page->name[length] == ' ';
        if (listed) {
            const char *summary = cli_page_summary(pages, page);
            printf("%s:", page->name + (length > 0 ? length + 1 : 0));
            cli_print_quoted(summary, cli_first_sentence(summary), "'\\''", "");
            putchar(' ');
        }
    }
    fputs(")\n", stdout);
}

void cli_complete_zsh(const cli_pages *pages)
{
    fputs(HEAD, stdout);
    fputs("\n_ductus() {\n  local _ductus_program=$words[1]\n  local -a commands\n  ", stdout);
    print_list(pages, "commands", "");
    fputs("  commands+=(help:'Print help, or the manual page')\n"
          "  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n"
          "  local command=$words[2]\n"
          "  shift words\n  (( CURRENT-- ))\n"
          "  case $command in\n    help)\n      _describe command commands\n      return ;;\n",
          stdout);
    for (size_t i = 0; i < pages->count; i++) {
        const cli_page *page = &pages->items[i];
        if (page->part_count > 0) {
            printf("    %s)\n      ", page->name);
            print_list(pages, "commands", page->name);
            fputs("      if (( CURRENT == 2 )); then\n        _describe command commands\n        return\n   "
                  "   fi\n"
                  "      command=\"$command $words[2]\"\n      shift words\n      (( CURRENT-- )) ;;\n",
                  stdout);
        }
    }
    fputs("  esac\n  case $command in\n", stdout);
    for (size_t i = 0; i < pages->count; i++) {
        if (pages->items[i].part_count == 0) {
            print_page(&pages->items[i]);
        }
    }
    fputs("  esac\n}\n\nif [ \"$funcstack[1]\" = _ductus ]; then\n  _ductus \"$@\"\nelse\n  compdef _ductus "
          "ductus\nfi\n",
          stdout);
}
