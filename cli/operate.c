/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"
#include "help.h"
#include "input.h"
#include "message.h"
#include "output.h"
#include "session.h"
#include "sink.h"
#include "targets.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const cli_option TRACE[] = {
    {.name = "trace",
     .kind = CLI_TEXT,
     .value = "FILE.json",
     .group = "Running",
     .help =
         "Write down what the operation chose and what it cost, for study. With several drawings: a folder."},
};

/* One run of an operation over one or more drawings. */
typedef struct operation_run {
    const duct_operation *operation;
    cli_session session;
    duct_settings *settings;
    duct_library **hands; /* for each parameter the opened hand, or NULL */
    cli_output output;
} operation_run;

static const char *value_name(const duct_param *param)
{
    switch (param->type) {
    case DUCT_PARAM_INT:
    case DUCT_PARAM_SEED:
        return "N";
    case DUCT_PARAM_REAL:
    case DUCT_PARAM_AUTO:
        return "X";
    case DUCT_PARAM_CHOICE:
        return "CHOICE";
    case DUCT_PARAM_HAND:
        return "HAND";
    case DUCT_PARAM_STYLE:
        return "STYLE";
    case DUCT_PARAM_STROKES:
        return "STROKES";
    case DUCT_PARAM_BOOL:
        break;
    }
    return NULL;
}

static void add_parameters(cli_option_list *list, const duct_operation *operation)
{
    for (size_t i = 0; i < operation->param_count; i++) {
        const duct_param *param = &operation->params[i];
        cli_option option = {.name = param->id,
                             .kind = CLI_PARAM,
                             .value = value_name(param),
                             .help = param->tooltip,
                             .group = param->group != NULL && *param->group != '\0' ? param->group
                                                                                    : operation->label,
                             .param = param};
        cli_options_add(list, &option, 1);
    }
    cli_option preset = {.name = "preset",
                         .kind = CLI_TEXT,
                         .value = "NAME",
                         .help =
                             "Settings to begin with; the other options change them, whatever their order.",
                         .group = "Presets",
                         .preset = operation->presets,
                         .preset_count = operation->preset_count};
    cli_options_add(list, &preset, 1);
}

static void make_options(cli_option_list *list, const duct_operation *operation)
{
    add_parameters(list, operation);
    cli_options_add(list, cli_input_options, cli_input_option_count);
    cli_options_add(list, cli_output_options, cli_output_option_count);
    cli_options_add(list, TRACE, 1);
    cli_options_add(list, cli_session_options, cli_session_option_count);
}

static int print_help(const duct_operation *operation, const cli_option_list *options)
{
    char usage[128];
    snprintf(usage, sizeof usage, "%s [OPTION...] IN... -o OUT", operation->id);
    cli_help_usage(usage);
    cli_help_text(operation->summary);
    cli_help_options(options);
    return CLI_DONE;
}

/* The preset first, then the other parameters, whatever their order on the command line. */
static int apply_settings(operation_run *run, const cli_arguments *arguments)
{
    duct_error error = {DUCT_OK, ""};
    const char *id = run->operation->id, *preset = cli_text(arguments, "preset");
    if (preset != NULL && duct_settings_preset(run->settings, preset, &error) != DUCT_OK) {
        return cli_misused("%s: %s", id, error.message);
    }
    for (size_t i = 0; i < arguments->options->count; i++) {
        const duct_param *param = arguments->options->items[i].param;
        const char *value = arguments->values[i];
        if (param == NULL || value == NULL) {
            continue;
        }
        duct_status status = duct_settings_set(run->settings, param->id, value, &error);
        if (status == DUCT_NO_MEMORY) {
            return cli_fail_memory();
        }
        if (status != DUCT_OK) {
            return cli_misused("%s: %s", id, error.message);
        }
    }
    return CLI_DONE;
}

static int hand_is_missing(const operation_run *run, const duct_param *param)
{
    char names[1024] = "";
    duct_hand *hands = NULL;
    size_t count = 0, used = 0;
    if (duct_library_list(&run->session.context, &hands, &count, NULL) == DUCT_OK) {
        for (size_t i = 0; i < count && used < sizeof names; i++) {
            used +=
                (size_t)snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "", hands[i].name);
        }
        duct_hands_free(&run->session.context, hands, count);
    }
    return cli_misused("%s: --%s has to be given: a recording's file, or one of these hands: %s",
                       run->operation->id, param->id, used > 0 ? names : "(there are none)");
}

/* Opens the hands once for all drawings. */
static int open_hands(operation_run *run)
{
    const duct_operation *operation = run->operation;
    run->hands = calloc(operation->param_count + 1, sizeof *run->hands);
    if (run->hands == NULL) {
        return cli_fail_memory();
    }
    for (size_t i = 0; i < operation->param_count; i++) {
        const duct_param *param = &operation->params[i];
        const char *name =
            param->type == DUCT_PARAM_HAND ? duct_settings_text(run->settings, param->id) : NULL;
        if (name == NULL) {
            continue;
        }
        if (*name == '\0') {
            return hand_is_missing(run, param);
        }
        cli_progress_phase("opening the hand");
        duct_error error = {DUCT_OK, ""};
        duct_status status = duct_library_open(&run->session.context, name, &run->hands[i], &error);
        if (status == DUCT_OK) {
            status = duct_settings_library(run->settings, param->id, run->hands[i], &error);
        }
        if (status != DUCT_OK) {
            return cli_fail_error(NULL, status, &error);
        }
    }
    return CLI_DONE;
}

static int run_traced(operation_run *run, const cli_target *target, const duct_drawing *input, cli_sink *sink)
{
    duct_run_options options = {NULL, NULL};
    if (target->trace != NULL) {
        int result = cli_sink_open(sink, target->trace);
        if (result != CLI_DONE) {
            return result;
        }
        options = (duct_run_options){cli_sink_take, sink};
    }
    duct_error error = {DUCT_OK, ""};
    duct_drawing *drawing = NULL;
    cli_progress_phase(run->operation->id);
    duct_status status =
        duct_operation_run(&run->session.context, run->settings, input, &options, &drawing, &error);
    if (status != DUCT_OK) {
        if (sink->file != NULL && ferror(sink->file)) {
            return cli_fail("%s: cannot be written", target->trace);
        }
        return cli_fail_error(cli_input_name(target->input), status, &error);
    }
    int result = cli_output_write(&run->output, drawing, target->output, target->format);
    if (result == CLI_DONE && sink->file != NULL) {
        result = cli_sink_commit(sink);
    }
    if (result == CLI_DONE) {
        cli_summary(&run->session, "%s -> %s: %zu strokes", cli_input_name(target->input), target->output,
                    duct_drawing_stroke_count(drawing));
    }
    duct_drawing_free(drawing);
    return result;
}

static int run_target(operation_run *run, const cli_arguments *arguments, const cli_target *target)
{
    duct_drawing *input = NULL;
    int result = cli_input_read(&run->session, arguments, target->input, &input);
    if (result == CLI_DONE) {
        cli_sink sink = {NULL, NULL, NULL};
        result = run_traced(run, target, input, &sink);
        cli_sink_drop(&sink);
        duct_drawing_free(input);
    }
    return result;
}

static int run_targets(operation_run *run, const cli_arguments *arguments, const cli_targets *targets)
{
    int result = open_hands(run);
    for (size_t i = 0; i < targets->count && result == CLI_DONE; i++) {
        if (targets->items[i].image) {
            result = cli_output_load_brush(&run->output);
        }
    }
    for (size_t i = 0; i < targets->count && result == CLI_DONE; i++) {
        result = run_target(run, arguments, &targets->items[i]);
    }
    return result;
}

/* A brush that draws randomly follows the operation's seed. */
static void share_seed(operation_run *run)
{
    for (size_t i = 0; i < run->operation->param_count; i++) {
        if (run->operation->params[i].type == DUCT_PARAM_SEED) {
            const char *seed = duct_settings_text(run->settings, run->operation->params[i].id);
            run->output.render.paint.seed = seed != NULL ? strtoull(seed, NULL, 10) : 0;
        }
    }
}

static int run_checked(operation_run *run, const cli_arguments *arguments)
{
    cli_targets targets = {NULL, 0, {NULL, NULL}};
    const char *id = run->operation->id;
    cli_session_begin(&run->session, arguments);
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_settings_new(&run->session.context, run->operation, &run->settings, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(NULL, status, &error);
    }
    int result = apply_settings(run, arguments);
    result = result != CLI_DONE ? result : cli_input_check(arguments, id);
    result = result != CLI_DONE ? result : cli_output_begin(&run->output, &run->session, arguments, id);
    result = result != CLI_DONE ? result : cli_targets_plan(&targets, arguments, id);
    if (result == CLI_DONE) {
        share_seed(run);
        result = run_targets(run, arguments, &targets);
    }
    if (result != CLI_DONE) {
        cli_targets_undo(&targets);
    }
    cli_targets_free(&targets);
    cli_output_end(&run->output);
    for (size_t i = 0; run->hands != NULL && i < run->operation->param_count; i++) {
        duct_library_free(run->hands[i]);
    }
    free(run->hands);
    duct_settings_free(run->settings);
    return result;
}

int cli_operate(const duct_operation *operation, int count, char **words)
{
    cli_option_list options = {NULL, 0, false};
    cli_arguments arguments;
    operation_run run = {.operation = operation};
    make_options(&options, operation);
    int result = cli_arguments_read(&arguments, &options, operation->id, count, words);
    if (result == CLI_DONE) {
        result = arguments.help ? print_help(operation, &options) : run_checked(&run, &arguments);
    }
    cli_arguments_free(&arguments);
    cli_options_free(&options);
    return result;
}
