/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "message.h"

#include "session.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

/* One line, whatever the arguments of a hostile caller hold. */
static void print_line(const char *format, va_list arguments) __attribute__((__format__(__printf__, 1, 0)));

static void print_line(const char *format, va_list arguments)
{
    char line[4096];
    vsnprintf(line, sizeof line, format, arguments);
    for (char *c = line; *c != '\0'; c++) {
        if ((unsigned char)*c < ' ' || *c == 0x7f) {
            *c = '?';
        }
    }
    cli_progress_erase();
    fprintf(stderr, "ductus: %s\n", line);
}

int cli_fail(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_line(format, arguments);
    va_end(arguments);
    return CLI_FAILED;
}

void cli_note(const cli_session *session, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    if (!session->quiet) {
        print_line(format, arguments);
    }
    va_end(arguments);
}

int cli_misused(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    print_line(format, arguments);
    va_end(arguments);
    return CLI_USAGE;
}

int cli_fail_error(const char *place, duct_status status, const duct_error *error)
{
    if (status == DUCT_CANCELLED) {
        cli_fail("stopped; nothing was written");
        return 128 + cli_signal();
    }
    const char *sentence = error->message[0] != '\0' ? error->message : duct_status_text(status);
    if (place == NULL || strncmp(sentence, place, strlen(place)) == 0) {
        return cli_fail("%s", sentence);
    }
    return cli_fail("%s: %s", place, sentence);
}

int cli_fail_memory(void)
{
    return cli_fail("there is not enough memory");
}

/* Damerau-Levenshtein distance (insertions, deletions, replacements, swapped neighbours) of short names;
 * SIZE_MAX where one is too long to be a name. */
static size_t distance(const char *a, const char *b)
{
    enum { LONGEST = 64 };
    size_t m = strlen(a), n = strlen(b), rows[3][LONGEST + 1];
    if (m > LONGEST || n > LONGEST) {
        return SIZE_MAX;
    }
    for (size_t j = 0; j <= n; j++) {
        rows[0][j] = j;
    }
    for (size_t i = 1; i <= m; i++) {
        const size_t *before = rows[(i + 1) % 3], *last = rows[(i - 1) % 3];
        size_t *row = rows[i % 3];
        row[0] = i;
        for (size_t j = 1; j <= n; j++) {
            size_t best = last[j - 1] + (a[i - 1] != b[j - 1]);
            best = last[j] + 1 < best ? last[j] + 1 : best;
            best = row[j - 1] + 1 < best ? row[j - 1] + 1 : best;
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] && before[j - 2] + 1 < best) {
                best = before[j - 2] + 1;
            }
            row[j] = best;
        }
    }
    return rows[m % 3][n];
}

const char *cli_nearest(const char *typed, cli_name_at name_at, const void *list)
{
    size_t length = strlen(typed);
    size_t nearest = length / 3 + 1 < 3 ? length / 3 + 1 : 3;
    const char *found = NULL, *begun = NULL, *name;
    for (size_t i = 0; (name = name_at(list, i)) != NULL; i++) {
        size_t d = distance(typed, name);
        if (d < nearest || (d == nearest && found == NULL)) {
            nearest = d;
            found = name;
        }
        if (length >= 3 && begun == NULL && strncmp(name, typed, length) == 0) {
            begun = name;
        }
    }
    return found != NULL ? found : begun;
}
