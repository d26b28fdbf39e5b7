/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "commands.h"
#include "help.h"
#include "manual.h"
#include "message.h"

#include <ductus/ductus.h>

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

/* The command `ductus`. Operations come from the library's tables; the commands are listed in commands.c. */

enum { COLUMN = 16 };

static const char *command_at(const void *unused, size_t index)
{
    (void)unused;
    return cli_command_name(index);
}

static int print_help(void)
{
    const duct_operation *operation;
    puts("Usage: ductus COMMAND [OPTION...] IN... -o OUT\n");
    cli_help_text(
        "Draws with somebody's hand: strokes go in, strokes of that hand come out. The ending of OUT picks "
        "the format; - is standard input or output.");
    puts("\nOperations:");
    for (size_t i = 0; (operation = duct_operation_at(i)) != NULL; i++) {
        cli_help_row(operation->id, operation->summary, COLUMN);
    }
    puts("\nOther commands:");
    for (size_t i = 0; i < cli_command_count; i++) {
        cli_help_row(cli_commands[i].name, cli_commands[i].summary, COLUMN);
    }
    puts("");
    cli_help_text("'ductus COMMAND --help' says more about each; 'ductus help --man' prints the manual page, "
                  "'ductus --version' the version.");
    return CLI_DONE;
}

static int run(int count, char **words)
{
    static char help[] = "--help";
    char *helped[2];
    if (count == 0) {
        return cli_misused("give a command; 'ductus --help' lists them");
    }
    if (strcmp(words[0], "--version") == 0) {
        printf("ductus %s\n", duct_version());
        return CLI_DONE;
    }
    if (strcmp(words[0], "--help") == 0 || strcmp(words[0], "-h") == 0 || strcmp(words[0], "help") == 0) {
        if (count == 1 || words[0][0] == '-') {
            return print_help();
        }
        if (strcmp(words[1], "--man") == 0) {
            return cli_manual_print();
        }
        helped[0] = words[1];
        helped[1] = help;
        words = helped;
        count = 2;
    }
    int result;
    if (cli_command_run(words[0], count - 1, words + 1, &result)) {
        return result;
    }
    const char *kind = words[0][0] == '-' ? "option" : "command";
    const char *nearest = cli_nearest(words[0], command_at, NULL);
    return nearest != NULL
               ? cli_misused("there is no %s '%s'; did you mean '%s'?", kind, words[0], nearest)
               : cli_misused("there is no %s '%s'; 'ductus --help' lists the commands", kind, words[0]);
}

int main(int count, char **words)
{
    /* A reader that went away is an error of writing, and temporary files are removed as after any other. */
    signal(SIGPIPE, SIG_IGN);
    signal(SIGXFSZ, SIG_IGN); /* a file size limit becomes an error of writing, too */
    int result = run(count > 0 ? count - 1 : 0, words + 1);
    if (fflush(stdout) != 0 && result == CLI_DONE) {
        result = cli_fail("standard output: cannot be written: %s", strerror(errno));
    }
    return result;
}
