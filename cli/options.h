/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_OPTIONS_H
#define DUCTUS_CLI_OPTIONS_H

#include <ductus/operation.h>

#include <stdbool.h>
#include <stddef.h>

/* Options as data: the same table reads the command line and prints the help. */

typedef enum cli_kind {
    CLI_FLAG,   /* --name */
    CLI_SWITCH, /* --name, --no-name, --name true, --name=false */
    CLI_TEXT,
    CLI_CHOICE, /* one of `choices` */
    CLI_REAL,   /* a finite number in minimum..maximum */
    CLI_WHOLE,  /* a whole number in minimum..maximum */
    CLI_PARAM   /* an operation's parameter that takes a value: the library checks it */
} cli_kind;

/* What a shell offers for a value of CLI_TEXT. */
typedef enum cli_completion {
    CLI_COMPLETES_FILES,
    CLI_COMPLETES_NOTHING,
    CLI_COMPLETES_HANDS,    /* and files */
    CLI_COMPLETES_BRUSHES,  /* and files */
    CLI_COMPLETES_READABLE, /* the formats' names */
    CLI_COMPLETES_WRITABLE
} cli_completion;

typedef struct cli_option {
    const char *name; /* without its dashes */
    char letter;      /* the short form, or 0 */
    cli_kind kind;
    const char *value; /* what help calls the value */
    double minimum, maximum;
    const char *choices; /* for CLI_CHOICE: words separated by spaces */
    const char *help;
    const char *fallback; /* what happens without it, for help; NULL: help says nothing */
    const char *group;    /* the heading in help */
    cli_completion completes;
    const duct_param *param;   /* where the option is an operation's parameter */
    const duct_preset *preset; /* where it chooses one of an operation's presets: the first of them */
    size_t preset_count;
} cli_option;

/* A growing table. */
typedef struct cli_option_list {
    cli_option *items;
    size_t count;
    bool failed; /* there was no memory */
} cli_option_list;

/* Appends options, except those whose name or letter is taken: an operation's parameters come first and win.
 */
void cli_options_add(cli_option_list *list, const cli_option *options, size_t count);
void cli_options_free(cli_option_list *list);

/* A command line, read. */
typedef struct cli_arguments {
    const cli_option_list *options;
    const char **values; /* for each option the last value, or NULL; "true" and "false" for switches */
    const char **inputs; /* what is no option, in order */
    size_t input_count;
    bool help; /* --help was given: nothing else counts */
} cli_arguments;

/* Reads the words after a command. `command` stands in sentences, e.g. "library build". Returns CLI_DONE, or
 * what cli_misused() returned. The caller frees it with cli_arguments_free() either way. */
int cli_arguments_read(cli_arguments *arguments, const cli_option_list *options, const char *command,
                       int count, char **words);
void cli_arguments_free(cli_arguments *arguments);

/* The value of an option that is no operation's parameter, or NULL where it was not given. */
const char *cli_text(const cli_arguments *arguments, const char *name);
bool cli_switch(const cli_arguments *arguments, const char *name, bool fallback);
double cli_number(const cli_arguments *arguments, const char *name, double fallback);

/* Whether a text is one finite number. */
bool cli_parse_number(const char *text, double *number);

#endif
