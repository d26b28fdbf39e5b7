/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_HELP_H
#define DUCTUS_CLI_HELP_H

#include "options.h"

/* Help on stdout, made from the tables and wrapped at the terminal's width. */

/* A paragraph. */
void cli_help_text(const char *text);

/* "NAME   what it is" with the second column aligned at `column`. */
void cli_help_row(const char *name, const char *text, int column);

/* All options under their headings, with their defaults, ranges and choices. */
void cli_help_options(const cli_option_list *options);

#endif
