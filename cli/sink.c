/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "sink.h"

#include "message.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Opens a new file beside `path`, with the mode that any new file has (mkstemp() would make it private). */
static int open_beside(cli_sink *sink)
{
    const char *slash = strrchr(sink->path, '/');
    int folder = slash != NULL ? (int)(slash - sink->path) + 1 : 0;
    size_t size = (size_t)folder + 64;
    sink->beside = malloc(size);
    if (sink->beside == NULL) {
        errno = ENOMEM;
        return -1;
    }
    int file = -1;
    for (unsigned attempt = 0; attempt < 100 && file < 0; attempt++) {
        snprintf(sink->beside, size, "%.*s.ductus-%ld-%u", folder, sink->path, (long)getpid(), attempt);
        file = open(sink->beside, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file < 0 && errno != EEXIST) {
            break;
        }
    }
    return file;
}

int cli_sink_open(cli_sink *sink, const char *path)
{
    struct stat facts;
    bool direct = stat(path, &facts) == 0 && !S_ISREG(facts.st_mode);
    *sink = (cli_sink){.path = path};
    int file = direct ? open(path, O_WRONLY | O_CLOEXEC) : open_beside(sink);
    sink->file = file >= 0 ? fdopen(file, "wb") : NULL;
    if (sink->file == NULL) {
        int number = errno;
        if (file >= 0) {
            close(file);
        }
        cli_sink_drop(sink);
        return cli_fail("%s: cannot be written: %s", path, strerror(number));
    }
    return CLI_DONE;
}

bool cli_sink_take(void *user, const char *text, size_t size)
{
    const cli_sink *sink = user;
    return size == 0 || fwrite(text, 1, size, sink->file) == size;
}

int cli_sink_commit(cli_sink *sink)
{
    bool failed = ferror(sink->file) != 0;
    failed = fclose(sink->file) != 0 || failed;
    sink->file = NULL;
    if (!failed && sink->beside != NULL) {
        failed = rename(sink->beside, sink->path) != 0;
    }
    int number = errno;
    if (!failed) {
        free(sink->beside);
        sink->beside = NULL;
        return CLI_DONE;
    }
    cli_sink_drop(sink);
    return cli_fail("%s: cannot be written: %s", sink->path, strerror(number));
}

void cli_sink_drop(cli_sink *sink)
{
    if (sink->file != NULL) {
        fclose(sink->file);
        sink->file = NULL;
    }
    if (sink->beside != NULL) {
        unlink(sink->beside);
        free(sink->beside);
        sink->beside = NULL;
    }
}
