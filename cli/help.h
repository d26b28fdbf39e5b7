/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_HELP_H
#define DUCTUS_CLI_HELP_H

#include "options.h"

/* Help on stdout, made from the tables and wrapped at the terminal's width; or told to a listener instead, so
 * that the manual page and the shells' completion are made of the very same. */
typedef struct cli_help_listener {
    void (*usage)(void *user, const char *usage);
    void (*text)(void *user, const char *text);
    void (*row)(void *user, const char *name, const char *text);
    void (*options)(void *user, const cli_option_list *options);
    void *user;
} cli_help_listener;

/* Help goes to the listener from now on; NULL: to stdout. */
void cli_help_listen(const cli_help_listener *listener);

/* "Usage: ductus USAGE" and an empty line. */
void cli_help_usage(const char *usage);

/* A paragraph. */
void cli_help_text(const char *text);

/* "NAME   what it is" with the second column aligned at `column`. */
void cli_help_row(const char *name, const char *text, int column);

/* All options under their headings, with their defaults, ranges and choices. */
void cli_help_options(const cli_option_list *options);

/* An option's name as help shows it, e.g. "-o, --output OUT", and its facts, e.g. "0 to 10 pixels, default
 * 5". */
enum { CLI_HELP_LINE = 512 };
void cli_help_name(const cli_option *option, char name[CLI_HELP_LINE]);
void cli_help_facts(const cli_option *option, char facts[CLI_HELP_LINE]);

#endif
