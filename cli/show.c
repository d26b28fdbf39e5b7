/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"
#include "help.h"
#include "input.h"
#include "message.h"
#include "session.h"

#include <ductus/diagram.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* show: diagrams of drawings. */

static const char CHOICES_BY[] = "pressure tilt tilt-x tilt-y twist speed segments none";

static const cli_option OPTIONS[] = {
    {.name = "output",
     .letter = 'o',
     .kind = CLI_TEXT,
     .value = "OUT.svg|OUT.png",
     .group = "Diagram",
     .help = "The picture to write; its ending picks the format."},
    {.name = "by",
     .kind = CLI_CHOICE,
     .choices = CHOICES_BY,
     .value = "WHAT",
     .group = "Diagram",
     .help = "What the colour of a line shows: a channel of the pen's pose, or the segments of a trace, or "
             "nothing (none: each line in its own colour).",
     .fallback = "pressure, or segments with --trace"},
    {.name = "range",
     .kind = CLI_TEXT,
     .value = "LOW,HIGH",
     .group = "Diagram",
     .completes = CLI_COMPLETES_NOTHING,
     .help = "The values at the ends of the colours, in the legend's unit. Without it: all but the outermost "
             "hundredths of what the drawings hold."},
    {.name = "palette",
     .kind = CLI_CHOICE,
     .choices = "violet-yellow blue-red",
     .value = "NAME",
     .group = "Diagram",
     .help = "The colours from low to high. 'violet-yellow' gets evenly lighter, which reads without colour "
             "vision too; 'blue-red' is that of the HelpingHand paper.",
     .fallback = "violet-yellow"},
    {.name = "marks",
     .kind = CLI_CHOICE,
     .choices = "none nibs needles both",
     .value = "WHICH",
     .group = "Diagram",
     .help = "Marks of the pen along the lines: 'nibs' are ellipses, longer with pressure and turned as the "
             "barrel; 'needles' are the barrel's shadow, from the tip to where the pen leans.",
     .fallback = "none"},
    {.name = "width",
     .kind = CLI_CHOICE,
     .choices = "even pressure",
     .value = "HOW",
     .group = "Diagram",
     .help = "Lines of one width, or wider with pressure.",
     .fallback = "even"},
    {.name = "trace",
     .kind = CLI_TEXT,
     .value = "FILE.json",
     .group = "Segments",
     .help = "The trace that the operation wrote beside the drawing: colours each run of samples that came "
             "from one place of the hand's recordings."},
    {.name = "hand",
     .kind = CLI_TEXT,
     .value = "HAND",
     .group = "Segments",
     .completes = CLI_COMPLETES_HANDS,
     .help = "The hand of the trace: the strokes of it that were used are drawn beside."},
    {.name = "pass",
     .kind = CLI_CHOICE,
     .choices = "trajectory pose",
     .value = "NAME",
     .group = "Segments",
     .help = "Which pass of the trace to show. Without it: the last one of each stroke."},
    {.name = "captions",
     .kind = CLI_TEXT,
     .value = "TEXT|TEXT...",
     .group = "Layout",
     .completes = CLI_COMPLETES_NOTHING,
     .help = "The captions, with | between them. Without it: the files' names where there are several."},
    {.name = "columns",
     .kind = CLI_WHOLE,
     .value = "N",
     .minimum = 0,
     .maximum = 64,
     .group = "Layout",
     .help = "Panels in a row; 0: up to four.",
     .fallback = "0"},
    {.name = "panel",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 64,
     .maximum = 8192,
     .group = "Layout",
     .help = "Width of a panel in pixels.",
     .fallback = "560"},
    {.name = "line-width",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 0.1,
     .maximum = 100,
     .group = "Layout",
     .help = "Width of the lines in pixels.",
     .fallback = "2.5"},
    {.name = "scale",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 0.1,
     .maximum = 16,
     .group = "Layout",
     .help = "Makes the finished picture, text and lines included, so many times as large.",
     .fallback = "1"},
};

/* What a diagram is made of, to be freed together. */
typedef struct show_run {
    cli_session session;
    duct_diagram_options options;
    duct_diagram_panel *panels;
    duct_drawing **drawings;
    char *captions;
    size_t count;
    duct_segments *segments;
    duct_library *library;
} show_run;

/* The place of a choice in its option's words. */
static int choice_of(const cli_arguments *arguments, const char *name, int fallback)
{
    const char *value = cli_text(arguments, name);
    for (size_t i = 0; value != NULL && i < sizeof OPTIONS / sizeof *OPTIONS; i++) {
        if (strcmp(OPTIONS[i].name, name) == 0) {
            int place = 0;
            for (const char *at = OPTIONS[i].choices; *at != '\0'; place++) {
                size_t length = strcspn(at, " ");
                if (strlen(value) == length && strncmp(at, value, length) == 0) {
                    return place;
                }
                at += length;
                at += strspn(at, " ");
            }
        }
    }
    return fallback;
}

static int read_range(const char *text, duct_diagram_options *options)
{
    char low[64];
    const char *comma = strchr(text, ',');
    size_t length = comma != NULL ? (size_t)(comma - text) : 0;
    if (length == 0 || length >= sizeof low) {
        return cli_misused("show: --range: '%s' is not two numbers with a comma between", text);
    }
    memcpy(low, text, length);
    low[length] = '\0';
    if (!cli_parse_number(low, &options->low) || !cli_parse_number(comma + 1, &options->high) ||
        options->low >= options->high) {
        return cli_misused("show: --range: '%s' is not two numbers, the lower one first", text);
    }
    return CLI_DONE;
}

static int read_options(const cli_arguments *arguments, duct_diagram_options *options)
{
    static const duct_diagram_by by[] = {DUCT_BY_PRESSURE, DUCT_BY_TILT,  DUCT_BY_TILT_X,   DUCT_BY_TILT_Y,
                                         DUCT_BY_TWIST,    DUCT_BY_SPEED, DUCT_BY_SEGMENTS, DUCT_BY_NOTHING};
    const char *trace = cli_text(arguments, "trace"), *range = cli_text(arguments, "range");
    *options = duct_diagram_options_default();
    options->by = by[choice_of(arguments, "by", trace != NULL ? 6 : 0)];
    options->palette = (duct_diagram_palette)choice_of(arguments, "palette", 0);
    int marks = choice_of(arguments, "marks", 0);
    options->nibs = marks == 1 || marks == 3;
    options->needles = marks == 2 || marks == 3;
    options->width_by_pressure = choice_of(arguments, "width", 0) == 1;
    options->columns = (int)cli_number(arguments, "columns", 0);
    options->panel_width = cli_number(arguments, "panel", options->panel_width);
    options->line_width = cli_number(arguments, "line-width", options->line_width);
    options->scale = cli_number(arguments, "scale", options->scale);
    if (options->by == DUCT_BY_SEGMENTS && trace == NULL) {
        return cli_misused(
            "show: --by segments needs --trace FILE.json, which an operation writes with --trace");
    }
    if (trace == NULL && (cli_text(arguments, "hand") != NULL || cli_text(arguments, "pass") != NULL)) {
        return cli_misused("show: --%s goes with --trace FILE.json",
                           cli_text(arguments, "hand") != NULL ? "hand" : "pass");
    }
    if (trace != NULL && arguments->input_count > 1) {
        return cli_misused("show: a trace belongs to one drawing; give one");
    }
    return range != NULL ? read_range(range, options) : CLI_DONE;
}

static int check_output(const cli_arguments *arguments)
{
    const char *path = cli_text(arguments, "output");
    const char *dot = path != NULL ? strrchr(path, '.') : NULL;
    if (arguments->input_count == 0) {
        return cli_misused("show: give a drawing or recording to show; see ductus show --help");
    }
    if (dot == NULL || (strcasecmp(dot, ".svg") != 0 && strcasecmp(dot, ".png") != 0)) {
        return cli_misused("show: say where to write: -o OUT.svg or -o OUT.png");
    }
    return cli_input_check(arguments, "show");
}

/* Cuts the captions apart at | in place. */
static int set_captions(show_run *run, const cli_arguments *arguments)
{
    const char *given = cli_text(arguments, "captions");
    for (size_t i = 0; i < run->count && given == NULL && run->count > 1; i++) {
        const char *slash = strrchr(arguments->inputs[i], '/');
        run->panels[i].caption = slash != NULL ? slash + 1 : cli_input_name(arguments->inputs[i]);
    }
    if (given == NULL) {
        return CLI_DONE;
    }
    run->captions = strdup(given);
    char *at = run->captions;
    if (at == NULL) {
        return cli_fail_memory();
    }
    for (size_t i = 0; i < run->count && at != NULL; i++) {
        run->panels[i].caption = strsep(&at, "|");
    }
    return at == NULL
               ? CLI_DONE
               : cli_misused("show: --captions has more texts than there are drawings (%zu)", run->count);
}

static int read_trace(show_run *run, const cli_arguments *arguments)
{
    const char *trace = cli_text(arguments, "trace"), *hand = cli_text(arguments, "hand");
    duct_error error = {DUCT_OK, ""};
    if (trace == NULL) {
        return CLI_DONE;
    }
    cli_progress_phase("reading the trace");
    duct_status status =
        duct_segments_read(&run->session.context, trace, cli_text(arguments, "pass"), &run->segments, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(trace, status, &error);
    }
    if (hand != NULL) {
        status = duct_library_open(&run->session.context, hand, &run->library, &error);
        if (status != DUCT_OK) {
            return cli_fail_error(NULL, status, &error);
        }
    }
    return CLI_DONE;
}

static int write_diagram(show_run *run, const cli_arguments *arguments)
{
    int result = set_captions(run, arguments);
    for (size_t i = 0; i < run->count && result == CLI_DONE; i++) {
        result = cli_input_read(&run->session, arguments, arguments->inputs[i], &run->drawings[i]);
        run->panels[i].drawing = run->drawings[i];
    }
    result = result != CLI_DONE ? result : read_trace(run, arguments);
    if (result != CLI_DONE) {
        return result;
    }
    run->panels[0].segments = run->segments;
    run->panels[0].library = run->library;
    const char *path = cli_text(arguments, "output");
    duct_error error = {DUCT_OK, ""};
    cli_progress_phase("drawing");
    duct_status status =
        duct_diagram_write(&run->session.context, run->panels, run->count, &run->options, path, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(status == DUCT_UNSUPPORTED ? cli_input_name(arguments->inputs[0]) : path,
                              status, &error);
    }
    cli_summary(&run->session, "%s: %zu drawings", path, run->count);
    return CLI_DONE;
}

static int run_checked(const cli_arguments *arguments)
{
    show_run run = {.count = arguments->input_count};
    int result = check_output(arguments);
    result = result != CLI_DONE ? result : read_options(arguments, &run.options);
    if (result != CLI_DONE) {
        return result;
    }
    cli_session_begin(&run.session, arguments);
    run.panels = calloc(run.count, sizeof *run.panels);
    run.drawings = calloc(run.count, sizeof *run.drawings);
    result = run.panels != NULL && run.drawings != NULL ? write_diagram(&run, arguments) : cli_fail_memory();
    for (size_t i = 0; run.drawings != NULL && i < run.count; i++) {
        duct_drawing_free(run.drawings[i]);
    }
    duct_segments_free(run.segments);
    duct_library_free(run.library);
    free(run.captions);
    free(run.drawings);
    free(run.panels);
    return result;
}

int cli_show(int count, char **words)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    cli_options_add(&options, OPTIONS, sizeof OPTIONS / sizeof *OPTIONS);
    cli_options_add(&options, cli_input_options, cli_input_option_count);
    cli_options_add(&options, cli_session_options, cli_session_option_count);
    int result = cli_arguments_read(&arguments, &options, "show", count, words);
    if (result == CLI_DONE && arguments.help) {
        cli_help_usage("show IN... -o OUT.svg|OUT.png [OPTION...]");
        cli_help_text(
            "Draws diagrams of drawings and recordings: lines coloured by the pen's pose, marks of its "
            "nib and lean, and the segments of a hand that a traced drawing was made of. Several "
            "drawings become panels side by side with one legend.");
        cli_help_options(&options);
    } else if (result == CLI_DONE) {
        result = run_checked(&arguments);
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}
