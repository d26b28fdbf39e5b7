/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "targets.h"

#include "message.h"
#include "output.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static bool is_folder(const char *path)
{
    struct stat facts;
    return stat(path, &facts) == 0 && S_ISDIR(facts.st_mode);
}

static const char *name_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

/* FOLDER/NAME, with NAME's ending replaced unless `ending` is NULL. */
static char *path_in(const char *folder, const char *input, const char *ending)
{
    const char *name = name_of(input), *dot = strrchr(name, '.');
    size_t stem = ending != NULL && dot != NULL && dot != name ? (size_t)(dot - name) : strlen(name);
    size_t size = strlen(folder) + strlen(name) + (ending != NULL ? strlen(ending) : 0) + 3;
    char *path = malloc(size);
    if (path != NULL) {
        const char *slash = folder[0] != '\0' && folder[strlen(folder) - 1] == '/' ? "" : "/";
        snprintf(path, size, "%s%s%.*s%s%s", folder, slash, (int)stem, name, ending != NULL ? "." : "",
                 ending != NULL ? ending : "");
    }
    return path;
}

/* Fills in the format that the output's ending, or `to`, names. */
static int choose_format(cli_target *target, const char *to, const char *command)
{
    char name[64], known[256];
    const char *path = target->output;
    if (strcmp(path, "-") == 0) {
        snprintf(name, sizeof name, "x.%.32s", to);
        path = name;
    }
    const char *format = cli_output_format(path, &target->image);
    if (format == NULL) {
        cli_output_formats(known, sizeof known);
        return strcmp(target->output, "-") == 0
                   ? cli_misused("%s: --to: '%s' is no format that can be written; those are: %s", command,
                                 to, known)
                   : cli_misused("%s: %s: no format has that ending; those that can be written: %s", command,
                                 target->output, known);
    }
    /* For standard output, `to` lives as long as the command line; `name` does not. */
    target->format = strcmp(target->output, "-") == 0 && target->image ? to : format;
    return CLI_DONE;
}

/* A folder that is not there is a reason not to begin. */
static int check_place(const char *path)
{
    size_t length = (size_t)(name_of(path) - path);
    char *folder = length > 0 ? strndup(path, length) : strdup(".");
    if (folder == NULL) {
        return cli_fail_memory();
    }
    int result = CLI_DONE;
    if (is_folder(path)) {
        result = cli_fail("%s: cannot be written: it is a folder", path);
    } else if (!is_folder(folder)) {
        result = cli_fail("%s: cannot be written: there is no folder %s", path, folder);
    }
    free(folder);
    return result;
}

static int make_folder(const char *path, char **made)
{
    if (is_folder(path)) {
        return CLI_DONE;
    }
    if (mkdir(path, 0777) != 0) {
        return cli_fail("%s: the folder cannot be made: %s", path, strerror(errno));
    }
    *made = strdup(path);
    return CLI_DONE;
}

static int plan_one(cli_targets *targets, const char *out, const char *to, const char *command)
{
    cli_target *target = &targets->items[0];
    bool standard = strcmp(out, "-") == 0;
    if (standard && to == NULL) {
        return cli_misused("%s: standard output has no ending that would pick the format; add --to FORMAT",
                           command);
    }
    if (!standard && to != NULL) {
        return cli_misused("%s: --to is for standard output and folders; the ending of %s picks the format",
                           command, out);
    }
    target->output = strdup(out);
    if (target->output == NULL) {
        return cli_fail_memory();
    }
    int result = choose_format(target, to, command);
    return result != CLI_DONE || standard ? result : check_place(out);
}

static int check_twins(const cli_targets *targets, const char *command)
{
    for (size_t i = 0; i < targets->count; i++) {
        for (size_t j = 0; j < i; j++) {
            if (strcmp(targets->items[i].output, targets->items[j].output) == 0) {
                return cli_misused("%s: %s and %s would both be written to %s", command,
                                   targets->items[j].input, targets->items[i].input,
                                   targets->items[i].output);
            }
        }
    }
    return CLI_DONE;
}

static int plan_folder(cli_targets *targets, const char *out, const char *to, const char *command)
{
    bool image;
    if (!is_folder(out) && (strcmp(out, "-") == 0 || cli_output_format(out, &image) != NULL)) {
        return cli_misused("%s: several drawings need a folder after -o, and %s is none", command,
                           strcmp(out, "-") == 0 ? "standard output" : out);
    }
    for (size_t i = 0; i < targets->count; i++) {
        cli_target *target = &targets->items[i];
        if (strcmp(target->input, "-") == 0) {
            return cli_misused("%s: standard input has no name to keep in the folder %s", command, out);
        }
        target->output = path_in(out, target->input, to);
        if (target->output == NULL) {
            return cli_fail_memory();
        }
        int result = choose_format(target, to, command);
        if (result != CLI_DONE) {
            return result;
        }
    }
    int result = check_twins(targets, command);
    return result != CLI_DONE ? result : make_folder(out, &targets->made[0]);
}

/* One trace is a file; those of several drawings lie in a folder and have their names. */
static int plan_traces(cli_targets *targets, const char *trace)
{
    bool folder = targets->count > 1 || is_folder(trace) || trace[strlen(trace) - 1] == '/';
    for (size_t i = 0; i < targets->count; i++) {
        cli_target *target = &targets->items[i];
        target->trace = folder ? path_in(trace, target->input, "json") : strdup(trace);
        if (target->trace == NULL) {
            return cli_fail_memory();
        }
    }
    return folder ? make_folder(trace, &targets->made[1]) : check_place(trace);
}

/* True where both names are the same file, however they are spelled; neither need be there. */
static bool same_file(const char *a, const char *b)
{
    struct stat x, y;
    if (strcmp(a, b) == 0) {
        return true;
    }
    return stat(a, &x) == 0 && stat(b, &y) == 0 && x.st_dev == y.st_dev && x.st_ino == y.st_ino;
}

/* A trace must not replace a drawing, neither one that is read nor one that is written. */
static int check_traces(const cli_targets *targets, const char *command)
{
    for (size_t i = 0; i < targets->count; i++) {
        for (size_t j = 0; j < targets->count; j++) {
            const char *trace = targets->items[i].trace, *input = targets->items[j].input;
            const char *output = targets->items[j].output;
            if (same_file(trace, input) || same_file(trace, output)) {
                return cli_misused("%s: the trace would replace %s; give --trace another name", command,
                                   same_file(trace, input) ? input : output);
            }
        }
    }
    return CLI_DONE;
}

int cli_targets_plan(cli_targets *targets, const cli_arguments *arguments, const char *command)
{
    *targets = (cli_targets){NULL, 0, {NULL, NULL}};
    const char *out = cli_text(arguments, "output"), *to = cli_text(arguments, "to");
    const char *trace = cli_text(arguments, "trace");
    if (arguments->input_count == 0) {
        return cli_misused("%s: give a drawing to read, or - for standard input; see ductus %s --help",
                           command, command);
    }
    if (out == NULL || *out == '\0') {
        return cli_misused("%s: say where to write: -o OUT", command);
    }
    if (trace != NULL && (strcmp(trace, "-") == 0 || *trace == '\0')) {
        return cli_misused("%s: --trace needs the name of a file", command);
    }
    targets->items = calloc(arguments->input_count, sizeof *targets->items);
    if (targets->items == NULL) {
        return cli_fail_memory();
    }
    targets->count = arguments->input_count;
    for (size_t i = 0; i < targets->count; i++) {
        targets->items[i].input = arguments->inputs[i];
    }
    bool folder = targets->count > 1 || is_folder(out) || out[strlen(out) - 1] == '/';
    int result = folder ? plan_folder(targets, out, to, command) : plan_one(targets, out, to, command);
    if (result == CLI_DONE && trace != NULL) {
        result = plan_traces(targets, trace);
        result = result == CLI_DONE ? check_traces(targets, command) : result;
    }
    return result;
}

void cli_targets_undo(const cli_targets *targets)
{
    for (size_t i = 0; i < 2; i++) {
        if (targets->made[i] != NULL) {
            rmdir(targets->made[i]);
        }
    }
}

void cli_targets_free(cli_targets *targets)
{
    for (size_t i = 0; i < targets->count; i++) {
        free(targets->items[i].output);
        free(targets->items[i].trace);
    }
    free(targets->items);
    free(targets->made[0]);
    free(targets->made[1]);
    *targets = (cli_targets){NULL, 0, {NULL, NULL}};
}
