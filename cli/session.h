/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_SESSION_H
#define DUCTUS_CLI_SESSION_H

#include "options.h"

#include <ductus/context.h>

#include <stdbool.h>

/* One run of the program: the library's surroundings, progress on the terminal, and signals that stop the
 * work cleanly. */
typedef struct cli_session {
    duct_context context;
    bool quiet;
} cli_session;

/* Options that every command which works takes: --threads, --progress, --quiet. */
extern const cli_option cli_session_options[];
extern const size_t cli_session_option_count;

/* Sets up a run from the values of cli_session_options, and catches signals. */
void cli_session_begin(cli_session *session, const cli_arguments *arguments);

/* Names the part of the work that follows; its progress goes from 0 to 1. */
void cli_progress_phase(const char *phase);

/* Takes the progress line off the terminal. */
void cli_progress_erase(void);

/* The signal that asks to stop, or 0. */
int cli_signal(void);

/* Where a signal asks to stop: says so and returns 128 + signal; else 0. */
int cli_stopped(void);

/* Seconds since the program started. */
double cli_seconds(void);

/* Prints "ductus: SENTENCE" as one line on stderr unless the user has asked for quiet: what the result lacks
 * without anything having failed. */
void cli_note(const cli_session *session, const char *format, ...) DUCT_PRINTF(2, 3);

/* Prints one line about work that is done, where there is a terminal and the user has not asked for quiet. */
void cli_summary(const cli_session *session, const char *format, ...) DUCT_PRINTF(2, 3);

#endif
