/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "input.h"

#include "message.h"

#include <ductus/format.h>

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const cli_option cli_input_options[] = {
    {.name = "from",
     .kind = CLI_TEXT,
     .value = "FORMAT",
     .group = "Reading",
     .completes = CLI_COMPLETES_READABLE,
     .help = "The format of the input (svg, inkml, ...). Without it: told by the content, then by the file's "
             "ending."},
    {.name = "flatten-tolerance",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 0.0001,
     .maximum = 100,
     .group = "Reading",
     .help = "Largest distance, in pixels, of a flattened curve from the true one.",
     .fallback = "0.05"},
};
const size_t cli_input_option_count = sizeof cli_input_options / sizeof *cli_input_options;

int cli_input_check(const cli_arguments *arguments, const char *command)
{
    const char *from = cli_text(arguments, "from");
    char known[256] = "";
    const duct_format *format;
    for (size_t i = 0; from != NULL && (format = duct_format_at(i)) != NULL; i++) {
        if (format->reads && strcmp(format->id, from) == 0) {
            return CLI_DONE;
        }
        if (format->reads) {
            size_t used = strlen(known);
            snprintf(known + used, sizeof known - used, "%s%s", used > 0 ? ", " : "", format->id);
        }
    }
    return from == NULL ? CLI_DONE
                        : cli_misused("%s: --from: '%s' is no format that can be read; those are: %s",
                                      command, from, known);
}

const char *cli_input_name(const char *path)
{
    return strcmp(path, "-") == 0 ? "standard input" : path;
}

/* Reads all of a file or pipe. */
static int read_bytes(int file, const char *name, char **bytes, size_t *size)
{
    size_t capacity = 65536, length = 0;
    char *buffer = malloc(capacity);
    for (;;) {
        if (buffer == NULL) {
            return cli_fail_memory();
        }
        ssize_t got = read(file, buffer + length, capacity - length);
        int stopped = cli_stopped();
        if (stopped != 0 || (got < 0 && errno != EINTR) || length > DUCT_MAX_FILE_BYTES) {
            int number = errno;
            free(buffer);
            if (stopped != 0) {
                return stopped;
            }
            return got < 0
                       ? cli_fail("%s: cannot be read: %s", name, strerror(number))
                       : cli_fail("%s: is larger than the limit of %d MiB", name, DUCT_MAX_FILE_BYTES >> 20);
        }
        if (got == 0) {
            break;
        }
        length += got > 0 ? (size_t)got : 0;
        if (length == capacity) {
            char *grown = realloc(buffer, 2 * capacity);
            if (grown == NULL) {
                free(buffer);
            }
            buffer = grown;
            capacity *= 2;
        }
    }
    *bytes = buffer;
    *size = length;
    return CLI_DONE;
}

static int read_as(const cli_session *session, const char *path, const char *from,
                   const duct_format_options *options, duct_drawing **drawing)
{
    bool standard = strcmp(path, "-") == 0;
    const char *name = cli_input_name(path);
    int file = standard ? STDIN_FILENO : open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return cli_fail("%s: cannot be read: %s", path, strerror(errno));
    }
    char *bytes = NULL;
    size_t size = 0;
    int result = read_bytes(file, name, &bytes, &size);
    if (!standard) {
        close(file);
    }
    if (result == CLI_DONE) {
        duct_error error = {DUCT_OK, ""};
        duct_status status =
            duct_drawing_read_memory(&session->context, bytes, size, name, from, options, drawing, &error);
        result = status == DUCT_OK ? CLI_DONE : cli_fail_error(name, status, &error);
        free(bytes);
    }
    return result;
}

int cli_input_read(const cli_session *session, const cli_arguments *arguments, const char *path,
                   duct_drawing **drawing)
{
    duct_format_options options = duct_format_options_default();
    options.flatten_tolerance = cli_number(arguments, "flatten-tolerance", options.flatten_tolerance);
    const char *from = cli_text(arguments, "from");
    cli_progress_phase("reading");
    if (from != NULL || strcmp(path, "-") == 0) {
        return read_as(session, path, from, &options, drawing);
    }
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_drawing_read(&session->context, path, &options, drawing, &error);
    return status == DUCT_OK ? CLI_DONE : cli_fail_error(path, status, &error);
}
