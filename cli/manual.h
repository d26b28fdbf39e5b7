/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_MANUAL_H
#define DUCTUS_CLI_MANUAL_H

/* Prints the manual page ductus(1), made from the same tables as --help, as troff. Returns an exit code. */
int cli_manual_print(void);

#endif
