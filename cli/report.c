/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report.h"

#include "help.h"
#include "message.h"
#include "session.h"

#include <ductus/format.h>
#include <ductus/report.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const char COMMAND[] = "library report";

static const cli_option REPORT[] = {
    {.name = "json", .kind = CLI_FLAG, .group = "Report", .help = "Print it as JSON, for programs."},
    {.name = "output",
     .letter = 'o',
     .kind = CLI_TEXT,
     .value = "PICTURE",
     .group = "Report",
     .help = "Also draw it, as .svg or .png: bars for each library, and a matrix of all pairs."},
    {.name = "radius",
     .kind = CLI_WHOLE,
     .value = "N",
     .minimum = 2,
     .maximum = 1000,
     .group = "Report",
     .help = "Samples on each side of a patch's centre.",
     .fallback = "12"},
    {.name = "seed",
     .kind = CLI_WHOLE,
     .value = "N",
     .minimum = 0,
     .maximum = 9007199254740992.0,
     .group = "Report",
     .help = "Chooses the random pairs.",
     .fallback = "0"},
};

enum { NAME_WIDTH = 28 };

/* Columns of a name: characters, not bytes. */
static int columns_of(const char *text)
{
    int columns = 0;
    for (; *text != '\0'; text++) {
        columns += ((unsigned char)*text & 0xc0) != 0x80;
    }
    return columns;
}

static void print_name(const char *name)
{
    int columns = columns_of(name);
    printf("%s%*s", name, columns < NAME_WIDTH ? NAME_WIDTH - columns : 1, "");
}

static void print_number(double value, int width)
{
    if (isnan(value)) {
        printf("%*s", width, "-");
    } else {
        printf("%*.2f", width, value);
    }
}

static const duct_channel SHOWN[] = {DUCT_PRESSURE, DUCT_TILT_X, DUCT_TILT_Y, DUCT_TWIST};
enum { SHOWN_COUNT = sizeof SHOWN / sizeof *SHOWN };

static void print_head(const char *what)
{
    print_name(what);
    printf("%8s%8s%8s  ", "pairs", "similar", "random");
    for (size_t i = 0; i < SHOWN_COUNT; i++) {
        printf("%9s", duct_channel_name(SHOWN[i]));
    }
    putchar('\n');
}

static void print_entry(const char *name, const duct_report_entry *entry)
{
    print_name(name);
    printf("%8zu", entry->together.pairs);
    print_number(entry->together.similar, 8);
    print_number(entry->together.random, 8);
    fputs("  ", stdout);
    for (size_t i = 0; i < SHOWN_COUNT; i++) {
        print_number(entry->channels[SHOWN[i]].similar, 9);
    }
    printf("\n  %s\n", entry->sentence);
}

static int print_text(const duct_report *report)
{
    size_t count = duct_report_library_count(report);
    puts("Correlation of pose between patches of strokes: of similar and of random pairs, and of similar "
         "pairs by "
         "channel\n");
    print_head("library");
    for (size_t i = 0; i < count; i++) {
        print_entry(duct_report_library_name(report, i), duct_report_between(report, i, i));
    }
    if (count > 1) {
        putchar('\n');
        print_head("pair of libraries");
    }
    for (size_t a = 0; a < count; a++) {
        for (size_t b = a + 1; b < count; b++) {
            char name[512];
            snprintf(name, sizeof name, "%.250s, %.250s", duct_report_library_name(report, a),
                     duct_report_library_name(report, b));
            print_entry(name, duct_report_between(report, a, b));
        }
    }
    return CLI_DONE;
}

static int print_json(const cli_session *session, const duct_report *report)
{
    char *text = NULL;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_report_json(&session->context, report, &text, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    fputs(text, stdout);
    duct_memory_free(&session->context, text);
    return CLI_DONE;
}

static int open_libraries(const cli_session *session, const cli_arguments *arguments,
                          duct_library **libraries)
{
    cli_progress_phase("opening the libraries");
    for (size_t i = 0; i < arguments->input_count; i++) {
        duct_error error = {DUCT_OK, ""};
        duct_status status =
            duct_library_open(&session->context, arguments->inputs[i], &libraries[i], &error);
        if (status != DUCT_OK) {
            return cli_fail_error(arguments->inputs[i], status, &error);
        }
    }
    return cli_stopped();
}

static int analyse(const cli_session *session, const cli_arguments *arguments,
                   const duct_library *const *libraries)
{
    const char *picture = cli_text(arguments, "output");
    duct_report_options options = duct_report_options_default();
    options.radius = (int)cli_number(arguments, "radius", options.radius);
    options.seed = (uint64_t)cli_number(arguments, "seed", 0);
    duct_report *report = NULL;
    duct_error error = {DUCT_OK, ""};
    cli_progress_phase("comparing strokes");
    duct_status status =
        duct_library_report(&session->context, libraries, arguments->input_count, &options, &report, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    if (picture != NULL) {
        status = duct_report_draw(&session->context, report, picture, &error);
    }
    cli_progress_erase();
    int result = status != DUCT_OK                     ? cli_fail_error(picture, status, &error)
                 : cli_text(arguments, "json") != NULL ? print_json(session, report)
                                                       : print_text(report);
    duct_report_free(report);
    return result;
}

static int report_checked(const cli_arguments *arguments)
{
    const char *picture = cli_text(arguments, "output");
    const char *dot = picture != NULL ? strrchr(picture, '.') : NULL;
    if (arguments->input_count == 0) {
        return cli_misused("%s: give one or more libraries, recordings or names of hands", COMMAND);
    }
    if (picture != NULL && (dot == NULL || (strcasecmp(dot, ".svg") != 0 && strcasecmp(dot, ".png") != 0))) {
        return cli_misused("%s: '%s': the picture's name has to end in .svg or .png", COMMAND, picture);
    }
    cli_session session;
    cli_session_begin(&session, arguments);
    duct_library **libraries = calloc(arguments->input_count, sizeof *libraries);
    if (libraries == NULL) {
        return cli_fail_memory();
    }
    int result = open_libraries(&session, arguments, libraries);
    if (result == CLI_DONE) {
        result = analyse(&session, arguments, (const duct_library *const *)libraries);
    }
    for (size_t i = 0; i < arguments->input_count; i++) {
        duct_library_free(libraries[i]);
    }
    free(libraries);
    return result;
}

int cli_library_report(int count, char **words)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    cli_options_add(&options, REPORT, sizeof REPORT / sizeof *REPORT);
    cli_options_add(&options, cli_session_options, cli_session_option_count);
    int result = cli_arguments_read(&arguments, &options, COMMAND, count, words);
    if (result == CLI_DONE && arguments.help) {
        cli_help_usage("library report LIB... [OPTION...]");
        cli_help_text(
            "Tells what libraries are good for: how closely the pose of similar shapes agrees within each of "
            "them, against shapes paired at random, and between each two of them. 0.6 and more is a "
            "practised hand, 0.5 a beginner's, below 0.4 the pose does not follow the shape. A library is "
            "the name of a hand, a library's file, a recording, or a folder of recordings. "
            "Report a library before it is enriched by --scales: copies of a stroke would count as its "
            "likes.");
        cli_help_options(&options);
    } else if (result == CLI_DONE) {
        result = report_checked(&arguments);
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}
