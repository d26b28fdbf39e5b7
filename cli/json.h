/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_JSON_H
#define DUCTUS_CLI_JSON_H

/* Prints a text as a JSON string, with its quotes, on stdout. */
void cli_json_string(const char *text);

#endif
