/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"
#include "help.h"
#include "input.h"
#include "json.h"
#include "message.h"
#include "report.h"
#include "session.h"

#include <ductus/library.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const cli_option BUILD[] = {
    {.name = "output",
     .letter = 'o',
     .kind = CLI_TEXT,
     .value = "LIB.inkml",
     .group = "Library",
     .help = "The library to write."},
    {.name = "name",
     .kind = CLI_TEXT,
     .value = "TEXT",
     .completes = CLI_COMPLETES_NOTHING,
     .group = "Library",
     .help = "The hand's name. Without it: the recording's."},
    {.name = "artist",
     .kind = CLI_TEXT,
     .value = "TEXT",
     .completes = CLI_COMPLETES_NOTHING,
     .group = "Library",
     .help = "Whose hand it is. Without it: what the recording says."},
    {.name = "licence",
     .kind = CLI_TEXT,
     .value = "TEXT",
     .completes = CLI_COMPLETES_NOTHING,
     .group = "Library",
     .help = "What others may do with it. Without it: what the recording says."},
    {.name = "unit",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 0,
     .maximum = 1e6,
     .group = "Library",
     .help =
         "Distance of neighbouring samples in the recording's pixels; 0: the median stroke gets 60 samples.",
     .fallback = "0"},
    {.name = "weights",
     .kind = CLI_TEXT,
     .value = "W,W,...",
     .completes = CLI_COMPLETES_NOTHING,
     .group = "Library",
     .help = "A weight for each recording, in their order: strokes of one that weighs 2 are taken where they "
             "are up "
             "to twice as far from the shape that is asked for.",
     .fallback = "1 each"},
    {.name = "scales",
     .kind = CLI_TEXT,
     .value = "S,S,...",
     .completes = CLI_COMPLETES_NOTHING,
     .group = "Library",
     .help = "Enriches the library: each stroke in each of these sizes, such as 0.5,1,1.5. Restyling takes "
             "that many "
             "times as long, and seldom looks better: the authors of HelpingHand saw no significant gain.",
     .fallback = "1"},
    {.name = "remove-position",
     .kind = CLI_FLAG,
     .group = "Library",
     .help = "Takes out of pressure, tilt and rotation what depends on the place on the page, and leaves "
             "what depends "
             "on the stroke; for a hand that turns as it moves across a large tablet."},
};

static const cli_option JSON[] = {
    {.name = "json", .kind = CLI_FLAG, .group = "Options", .help = "Print it as JSON, for programs."},
};

static int read_recordings(const cli_session *session, const cli_arguments *arguments,
                           duct_drawing **drawings)
{
    int result = CLI_DONE;
    for (size_t i = 0; i < arguments->input_count && result == CLI_DONE; i++) {
        result = cli_input_read(session, arguments, arguments->inputs[i], &drawings[i]);
    }
    return result;
}

/* Numbers separated by commas. */
typedef struct {
    double *items;
    size_t count;
} numbers;

/* Reads the value of an option, which may be missing: then there are none. Each must lie in minimum..maximum.
 */
static int read_numbers(const cli_arguments *arguments, const char *option, double minimum, double maximum,
                        numbers *list)
{
    const char *text = cli_text(arguments, option);
    size_t size = text != NULL ? strlen(text) : 0;
    *list = (numbers){NULL, 0};
    if (text == NULL) {
        return CLI_DONE;
    }
    list->items = malloc((size / 2 + 1) * sizeof *list->items);
    char *copy = malloc(size + 1);
    int result = list->items != NULL && copy != NULL ? CLI_DONE : cli_fail_memory();
    for (size_t at = 0; result == CLI_DONE && at <= size;) {
        size_t length = strcspn(text + at, ",");
        double number;
        memcpy(copy, text + at, length);
        copy[length] = '\0';
        if (!cli_parse_number(copy, &number) || number < minimum || number > maximum) {
            result = cli_misused("library build: --%s '%s': give numbers from %g to %g, separated by commas",
                                 option, text, minimum, maximum);
        } else {
            list->items[list->count++] = number;
        }
        at += length + 1;
    }
    free(copy);
    return result;
}

/* How many of a recording's strokes have the channel. */
static size_t strokes_with(const duct_drawing *drawing, duct_channel channel)
{
    size_t count = 0;
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        count += duct_stroke_values(duct_drawing_stroke(drawing, i), channel) != NULL;
    }
    return count;
}

/* A channel that some strokes lack is not in the library: says so, a line for each recording at fault. */
static void note_lost_channels(const cli_session *session, const cli_arguments *arguments,
                               duct_drawing *const *drawings, const duct_library *library)
{
    for (size_t i = 0; i < arguments->input_count; i++) {
        char list[128] = "";
        for (int c = DUCT_PRESSURE; c <= DUCT_TWIST; c++) {
            size_t own = strokes_with(drawings[i], (duct_channel)c), all = 0;
            for (size_t k = 0; k < arguments->input_count; k++) {
                all += strokes_with(drawings[k], (duct_channel)c);
            }
            if (all > 0 && own < duct_drawing_stroke_count(drawings[i]) &&
                !duct_library_has(library, (duct_channel)c)) {
                size_t used = strlen(list);
                snprintf(list + used, sizeof list - used, "%s%s%s", used > 0 ? ", " : "",
                         own > 0 ? "in some strokes no " : "no ", duct_channel_name((duct_channel)c));
            }
        }
        if (*list != '\0') {
            cli_note(session, "%s has %s; so the library goes without", cli_input_name(arguments->inputs[i]),
                     list);
        }
    }
}

static int write_library(const cli_session *session, const cli_arguments *arguments, duct_drawing **drawings,
                         const numbers *scales, const numbers *weights)
{
    const char *path = cli_text(arguments, "output");
    duct_library_options options = {.unit = cli_number(arguments, "unit", 0),
                                    .name = cli_text(arguments, "name"),
                                    .artist = cli_text(arguments, "artist"),
                                    .licence = cli_text(arguments, "licence"),
                                    .remove_position = cli_text(arguments, "remove-position") != NULL,
                                    .scales = scales->items,
                                    .scale_count = scales->count,
                                    .weights = weights->count > 0 ? weights->items : NULL};
    duct_library *library = NULL;
    duct_error error = {DUCT_OK, ""};
    cli_progress_phase("building the library");
    duct_status status = duct_library_build(&session->context, (const duct_drawing *const *)drawings,
                                            arguments->input_count, &options, &library, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(arguments->input_count == 1 ? cli_input_name(arguments->inputs[0]) : NULL,
                              status, &error);
    }
    int result = cli_stopped();
    if (result == CLI_DONE) {
        status = duct_library_save(&session->context, library, path, &error);
        result = status == DUCT_OK ? CLI_DONE : cli_fail_error(path, status, &error);
    }
    if (result == CLI_DONE) {
        note_lost_channels(session, arguments, drawings, library);
        cli_summary(session, "%s: %zu strokes, %zu samples", path, duct_library_stroke_count(library),
                    duct_library_sample_count(library));
    }
    duct_library_free(library);
    return result;
}

static int build_read(const cli_arguments *arguments, const numbers *scales, const numbers *weights)
{
    cli_session session;
    cli_session_begin(&session, arguments);
    duct_drawing **drawings = calloc(arguments->input_count, sizeof *drawings);
    if (drawings == NULL) {
        return cli_fail_memory();
    }
    int result = read_recordings(&session, arguments, drawings);
    result = result != CLI_DONE ? result : write_library(&session, arguments, drawings, scales, weights);
    for (size_t i = 0; i < arguments->input_count; i++) {
        duct_drawing_free(drawings[i]);
    }
    free(drawings);
    return result;
}

static int build_checked(const cli_arguments *arguments, const char *command)
{
    const char *path = cli_text(arguments, "output");
    const char *dot = path != NULL ? strrchr(path, '.') : NULL;
    if (arguments->input_count == 0) {
        return cli_misused("%s: give one or more recordings", command);
    }
    if (dot == NULL || strcasecmp(dot, ".inkml") != 0) {
        return cli_misused("%s: say where to write: -o LIB.inkml", command);
    }
    int result = cli_input_check(arguments, command);
    if (result != CLI_DONE) {
        return result;
    }
    numbers scales, weights = {NULL, 0};
    result = read_numbers(arguments, "scales", 0.01, 100, &scales);
    result = result != CLI_DONE ? result : read_numbers(arguments, "weights", 0.001, 1000, &weights);
    if (result == CLI_DONE && scales.count > 16) {
        result = cli_misused("%s: --scales: 16 at most", command);
    }
    if (result == CLI_DONE && weights.count > 0 && weights.count != arguments->input_count) {
        result = cli_misused("%s: --weights: there are %zu weights for %zu recordings", command,
                             weights.count, arguments->input_count);
    }
    result = result != CLI_DONE ? result : build_read(arguments, &scales, &weights);
    free(scales.items);
    free(weights.items);
    return result;
}

static int build(int count, char **words)
{
    static const char COMMAND[] = "library build";
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    cli_options_add(&options, BUILD, sizeof BUILD / sizeof *BUILD);
    cli_options_add(&options, cli_input_options, cli_input_option_count);
    cli_options_add(&options, cli_session_options, cli_session_option_count);
    int result = cli_arguments_read(&arguments, &options, COMMAND, count, words);
    if (result == CLI_DONE && arguments.help) {
        cli_help_usage("library build IN... -o LIB.inkml [OPTION...]");
        cli_help_text("Makes a stroke library of one person's recordings: strokes resampled uniformly in arc "
                      "length, and beside it the index that finds them.");
        cli_help_options(&options);
    } else if (result == CLI_DONE) {
        result = build_checked(&arguments, COMMAND);
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}

/* The channels beyond x and y, e.g. "t pressure tilt_x". */
static void channels_of(const duct_library *library, char *text, size_t size)
{
    size_t used = 0;
    text[0] = '\0';
    for (int channel = DUCT_T; channel < DUCT_CHANNEL_COUNT; channel++) {
        if (duct_library_has(library, (duct_channel)channel) && used < size) {
            used += (size_t)snprintf(text + used, size - used, "%s%s", used > 0 ? " " : "",
                                     duct_channel_name((duct_channel)channel));
        }
    }
}

static void print_field(const char *key, const char *value)
{
    printf(", \"%s\": ", key);
    cli_json_string(value);
}

static void print_channels_json(const duct_library *library)
{
    bool first = true;
    fputs(", \"channels\": [", stdout);
    for (int channel = 0; channel < DUCT_CHANNEL_COUNT; channel++) {
        if (duct_library_has(library, (duct_channel)channel)) {
            fputs(first ? "" : ", ", stdout);
            cli_json_string(duct_channel_name((duct_channel)channel));
            first = false;
        }
    }
    putchar(']');
}

static void print_hand_json(const duct_hand *hand, const duct_library *library, const duct_error *error)
{
    fputs("  {\"name\": ", stdout);
    cli_json_string(hand->name);
    print_field("path", hand->path);
    printf(", \"builtin\": %s", hand->builtin ? "true" : "false");
    if (library != NULL) {
        printf(", \"strokes\": %zu, \"samples\": %zu, \"unit\": %.17g", duct_library_stroke_count(library),
               duct_library_sample_count(library), duct_library_unit(library));
        print_channels_json(library);
        print_field("artist", duct_library_artist(library));
        print_field("licence", duct_library_licence(library));
    } else {
        print_field("error", error->message);
    }
    putchar('}');
}

static void print_hand(const duct_hand *hand, const duct_library *library, const duct_error *error)
{
    char text[1024], channels[256];
    if (library == NULL) {
        snprintf(text, sizeof text, "cannot be opened: %s", error->message);
    } else {
        const char *artist = duct_library_artist(library);
        channels_of(library, channels, sizeof channels);
        snprintf(text, sizeof text, "%zu strokes; %s%s%s; %s", duct_library_stroke_count(library),
                 *channels != '\0' ? channels : "x and y only", *artist != '\0' ? "; by " : "", artist,
                 hand->builtin ? "built in, synthetic" : hand->path);
    }
    cli_help_row(hand->name, text, 20);
}

static int list_hands(bool json)
{
    duct_context context = duct_context_default();
    duct_hand *hands = NULL;
    size_t count = 0;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_library_list(&context, &hands, &count, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    fputs(json ? "[" : "", stdout);
    for (size_t i = 0; i < count; i++) {
        duct_library *library = NULL;
        error = (duct_error){DUCT_OK, ""};
        duct_library_open(&context, hands[i].path, &library, &error);
        if (json) {
            fputs(i > 0 ? ",\n" : "\n", stdout);
            print_hand_json(&hands[i], library, &error);
        } else {
            print_hand(&hands[i], library, &error);
        }
        duct_library_free(library);
    }
    fputs(json ? "\n]\n" : "", stdout);
    duct_hands_free(&context, hands, count);
    return CLI_DONE;
}

static int list(int count, char **words)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    cli_options_add(&options, JSON, 1);
    int result = cli_arguments_read(&arguments, &options, "library list", count, words);
    if (result == CLI_DONE && arguments.help) {
        cli_help_usage("library list [--json]");
        cli_help_text("Lists the hands that can be named: the built-in ones, which are synthetic, and yours "
                      "in $XDG_DATA_HOME/ductus/hands (~/.local/share/ductus/hands).");
        cli_help_options(&options);
    } else if (result == CLI_DONE && arguments.input_count > 0) {
        result = cli_misused("library list: '%s': takes no files", arguments.inputs[0]);
    } else if (result == CLI_DONE) {
        result = list_hands(cli_text(&arguments, "json") != NULL);
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}

static const struct {
    const char *name;
    int (*run)(int count, char **words);
    const char *summary;
} PARTS[] = {
    {"build", build, "Make a library of one person's recordings."},
    {"report", cli_library_report, "Tell what libraries are good for, and how alike they are."},
    {"list", list, "List the hands that can be named."},
};
enum { PART_COUNT = sizeof PARTS / sizeof *PARTS };

static const char *part_at(const void *unused, size_t index)
{
    (void)unused;
    return index < PART_COUNT ? PARTS[index].name : NULL;
}

int cli_library(int count, char **words)
{
    if (count == 0) {
        return cli_misused("library: say what to do: build, report or list; see ductus library --help");
    }
    for (size_t i = 0; i < PART_COUNT; i++) {
        if (strcmp(words[0], PARTS[i].name) == 0) {
            return PARTS[i].run(count - 1, words + 1);
        }
    }
    if (strcmp(words[0], "--help") == 0 || strcmp(words[0], "-h") == 0) {
        cli_help_usage("library COMMAND ...");
        for (size_t i = 0; i < PART_COUNT; i++) {
            cli_help_row(PARTS[i].name, PARTS[i].summary, 14);
        }
        return CLI_DONE;
    }
    const char *nearest = cli_nearest(words[0], part_at, NULL);
    return nearest != NULL
               ? cli_misused("library: there is no command '%s'; did you mean '%s'?", words[0], nearest)
               : cli_misused("library: there is no command '%s'; there are build, report and list", words[0]);
}
