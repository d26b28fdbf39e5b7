/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_COMPLETION_H
#define DUCTUS_CLI_COMPLETION_H

#include "describe.h"

/* Completion scripts, printed on stdout. Names of hands and brushes are asked of the program when they are
 * wanted: 'ductus completion hands' and 'ductus completion brushes'. */
void cli_complete_bash(const cli_pages *pages);
void cli_complete_zsh(const cli_pages *pages);
void cli_complete_fish(const cli_pages *pages);

/* The page of a command or of a part, e.g. the parts of "library": false past the end. Top commands are those
 * without a space in their names. */
bool cli_is_part(const cli_page *page);

/* What a command does, in one line. */
const char *cli_page_summary(const cli_pages *pages, const cli_page *page);

/* Prints a text, at most `size` bytes of it, within single quotes of a shell, its own ones as `quote`; the
 * characters of `escaped` get a backslash before them. */
void cli_print_quoted(const char *text, int size, const char *quote, const char *escaped);

#endif
