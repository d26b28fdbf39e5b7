/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_REPORT_H
#define DUCTUS_CLI_REPORT_H

/* The command `library report`: gets the words after it, prints its own help, returns an exit code. */
int cli_library_report(int count, char **words);

#endif
