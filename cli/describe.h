/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_DESCRIBE_H
#define DUCTUS_CLI_DESCRIBE_H

#include "options.h"

/* All commands as data, gathered from what their --help says: for the manual page and the completion scripts.
 */

typedef struct cli_page {
    char *name;  /* "library build" */
    char *usage; /* behind "ductus " */
    char *text;  /* what it does */
    cli_option *options;
    size_t option_count;
    char **parts; /* of a command that has commands: their names and what they do, in turn */
    size_t part_count;
} cli_page;

typedef struct cli_pages {
    cli_page *items; /* operations first, then the other commands, each before its parts */
    size_t count;
    bool failed; /* there was no memory */
} cli_pages;

/* Returns an exit code. Free with cli_describe_free() either way. */
int cli_describe(cli_pages *pages);
void cli_describe_free(cli_pages *pages);

/* How an option's value is completed. */
typedef enum cli_value_kind {
    CLI_VALUE_NONE, /* it takes none */
    CLI_VALUE_FREE, /* nothing can be offered */
    CLI_VALUE_WORDS,
    CLI_VALUE_FILES,
    CLI_VALUE_HANDS,   /* names, and files */
    CLI_VALUE_BRUSHES, /* names, and files */
    CLI_VALUE_STYLES   /* names, and files */
} cli_value_kind;

enum { CLI_VALUE_ROOM = 1024 };

/* `words` gets the words of CLI_VALUE_WORDS, with spaces between. */
cli_value_kind cli_value_of(const cli_option *option, char words[CLI_VALUE_ROOM]);

/* The same for what is no option. */
cli_value_kind cli_input_of(const cli_page *page, char words[CLI_VALUE_ROOM]);

/* True where the option is written --[no-]NAME. */
bool cli_is_switch(const cli_option *option);

/* The length of a text's first sentence, without its full stop. */
int cli_first_sentence(const char *text);

#endif
