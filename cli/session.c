/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "session.h"

#include "message.h"

#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

const cli_option cli_session_options[] = {
    {.name = "threads",
     .kind = CLI_WHOLE,
     .value = "N",
     .minimum = 0,
     .maximum = 1024,
     .group = "Running",
     .help = "Threads that work at the same time; 0: one per processor.",
     .fallback = "0"},
    {.name = "progress",
     .kind = CLI_SWITCH,
     .group = "Running",
     .help = "Show how far the work is. Without it: on a terminal, when the work takes longer than half a "
             "second."},
    {.name = "quiet",
     .letter = 'q',
     .kind = CLI_FLAG,
     .group = "Running",
     .help = "Print nothing but errors."},
};
const size_t cli_session_option_count = sizeof cli_session_options / sizeof *cli_session_options;

/* Signals and the terminal belong to the process, so this is global where nothing else is. */
static volatile sig_atomic_t caught;

static struct {
    bool shown_always, never, terminal, drawn;
    const char *phase;
    double begun, last; /* seconds: of the work, and of the last drawing */
    int tenth;          /* the last tenth that was printed where there is no terminal */
} progress;

enum { BAR = 24 };
static const double PATIENCE = 0.5, REDRAW = 0.1;

static void catch_signal(int number)
{
    caught = number;
}

double cli_seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

void cli_progress_erase(void)
{
    if (progress.drawn) {
        fputs("\r\033[K", stderr);
        progress.drawn = false;
    }
}

static void draw_bar(double fraction)
{
    char bar[BAR + 1];
    int filled = (int)(fraction * BAR);
    memset(bar, '-', BAR);
    memset(bar, '#', (size_t)(filled < BAR ? filled : BAR));
    bar[BAR] = '\0';
    fprintf(stderr, "\r\033[K%s [%s] %3.0f %%", progress.phase, bar, 100 * fraction);
    fflush(stderr);
    progress.drawn = true;
}

static bool hear_progress(void *user, double fraction)
{
    (void)user;
    if (caught != 0) {
        return false;
    }
    fraction = fraction > 0 ? (fraction < 1 ? fraction : 1) : 0;
    if (progress.never) {
        return true;
    }
    double now = cli_seconds();
    if (progress.terminal) {
        if ((progress.shown_always || now - progress.begun > PATIENCE) && now - progress.last > REDRAW) {
            draw_bar(fraction);
            progress.last = now;
        }
    } else if (progress.shown_always && (int)(10 * fraction) > progress.tenth) {
        progress.tenth = (int)(10 * fraction);
        fprintf(stderr, "%s: %d %%\n", progress.phase, 10 * progress.tenth);
    }
    return true;
}

void cli_progress_phase(const char *phase)
{
    cli_progress_erase();
    progress.phase = phase;
    progress.tenth = -1;
    progress.last = 0;
}

void cli_session_begin(cli_session *session, const cli_arguments *arguments)
{
    struct sigaction action = {.sa_handler = catch_signal, .sa_flags = (int)SA_RESETHAND};
    sigemptyset(&action.sa_mask);
    /* A second Ctrl-C ends the program at once. SIGPIPE becomes an error of writing. */
    const int stops[] = {SIGINT, SIGTERM, SIGHUP};
    for (size_t i = 0; i < sizeof stops / sizeof *stops; i++) {
        struct sigaction before;
        if (sigaction(stops[i], NULL, &before) == 0 && before.sa_handler != SIG_IGN) {
            sigaction(stops[i], &action, NULL);
        }
    }
    session->context = duct_context_default();
    session->context.progress = hear_progress;
    session->quiet = cli_switch(arguments, "quiet", false);
    session->context.threads = (int)cli_number(arguments, "threads", 0);
    progress.terminal = isatty(STDERR_FILENO) == 1;
    progress.shown_always = cli_switch(arguments, "progress", false);
    progress.never = session->quiet || !cli_switch(arguments, "progress", true);
    progress.begun = cli_seconds();
    cli_progress_phase("working");
}

int cli_signal(void)
{
    return caught != 0 ? caught : SIGINT;
}

int cli_stopped(void)
{
    return caught != 0 ? cli_fail_error(NULL, DUCT_CANCELLED, NULL) : 0;
}

void cli_summary(const cli_session *session, const char *format, ...)
{
    cli_progress_erase();
    if (session->quiet || isatty(STDERR_FILENO) != 1) {
        return;
    }
    va_list arguments;
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fprintf(stderr, ", %.1f s\n", cli_seconds() - progress.begun);
}
