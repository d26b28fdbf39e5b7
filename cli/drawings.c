/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"
#include "help.h"
#include "input.h"
#include "message.h"
#include "output.h"
#include "session.h"
#include "targets.h"

#include <stdio.h>

/* render and convert: a drawing read and written, with nothing done between. */

static const cli_option SEED[] = {
    {.name = "seed",
     .kind = CLI_WHOLE,
     .value = "N",
     .minimum = 0,
     .maximum = 9007199254740992.0,
     .group = "Images",
     .help = "Where the random numbers of brushes that draw randomly begin.",
     .fallback = "0"},
};

static int write_target(cli_session *session, const cli_arguments *arguments, cli_output *output,
                        const cli_target *target)
{
    duct_drawing *drawing = NULL;
    int result = cli_input_read(session, arguments, target->input, &drawing);
    if (result != CLI_DONE) {
        return result;
    }
    result = cli_output_write(output, drawing, target->output, target->format);
    if (result == CLI_DONE) {
        cli_summary(session, "%s -> %s: %zu strokes", cli_input_name(target->input), target->output,
                    duct_drawing_stroke_count(drawing));
    }
    duct_drawing_free(drawing);
    return result;
}

static int write_targets(const cli_arguments *arguments, const char *command, bool images_only)
{
    cli_session session;
    cli_output output;
    cli_targets targets = {NULL, 0, {NULL, NULL}};
    cli_session_begin(&session, arguments);
    int result = cli_input_check(arguments, command);
    result = result != CLI_DONE ? result : cli_output_begin(&output, &session, arguments, command);
    if (result != CLI_DONE) {
        return result;
    }
    result = cli_targets_plan(&targets, arguments, command);
    for (size_t i = 0; i < targets.count && result == CLI_DONE; i++) {
        if (images_only && !targets.items[i].image) {
            result = cli_misused("%s: %s is no image; 'ductus convert' writes vector formats", command,
                                 targets.items[i].output);
        } else if (targets.items[i].image) {
            result = cli_output_load_brush(&output);
        }
    }
    for (size_t i = 0; i < targets.count && result == CLI_DONE; i++) {
        result = write_target(&session, arguments, &output, &targets.items[i]);
    }
    if (result != CLI_DONE) {
        cli_targets_undo(&targets);
    }
    cli_targets_free(&targets);
    cli_output_end(&output);
    return result;
}

static int run(const char *command, const char *usage, const char *summary, bool images_only, int count,
               char **words)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    cli_options_add(&options, cli_input_options, cli_input_option_count);
    cli_options_add(&options, cli_output_options, cli_output_option_count);
    cli_options_add(&options, SEED, 1);
    cli_options_add(&options, cli_session_options, cli_session_option_count);
    int result = cli_arguments_read(&arguments, &options, command, count, words);
    if (result == CLI_DONE && arguments.help) {
        cli_help_usage(usage);
        cli_help_text(summary);
        cli_help_options(&options);
    } else if (result == CLI_DONE) {
        result = write_targets(&arguments, command, images_only);
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}

int cli_render(int count, char **words)
{
    return run(
        "render", "render IN... -o OUT.png [OPTION...]",
        "Paints drawings with the brush engine. Pressure, tilt and the barrel's rotation reach the brush "
        "where the strokes have them.",
        true, count, words);
}

int cli_convert(int count, char **words)
{
    return run("convert", "convert IN... -o OUT [OPTION...]",
               "Writes drawings in another format; images are painted as 'ductus render' does.", false, count,
               words);
}
