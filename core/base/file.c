/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"

#include "base/error.h"

#include <ductus/random.h>

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static duct_status fail_file(duct_error *error, const char *path, const char *verb, int number)
{
    char reason[128] = "";
    duct_status status = number == ENOENT ? DUCT_NOT_FOUND : DUCT_IO;
    const char *text = strerror_r(number, reason, sizeof reason);
    return duct_fail(error, status, "%s: cannot be %s: %s", path, verb, text);
}

static duct_status read_all(const duct_allocator *allocator, int file, const char *path, size_t expected,
                            size_t limit, char **data, size_t *size, duct_error *error)
{
    size_t capacity = expected + 1, length = 0;
    char *buffer = duct_realloc(allocator, NULL, capacity, 1);
    if (buffer == NULL) {
        return duct_fail_memory(error);
    }
    for (;;) {
        if (length + 1 >= capacity) {
            void *grown = buffer;
            if (!duct_reserve(allocator, &grown, &capacity, capacity + 65536, 1)) {
                duct_release(allocator, buffer);
                return duct_fail_memory(error);
            }
            buffer = grown;
        }
        ssize_t got = read(file, buffer + length, capacity - length - 1);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            int number = errno;
            duct_release(allocator, buffer);
            return fail_file(error, path, "read", number);
        }
        if (got == 0) {
            break;
        }
        length += (size_t)got;
        if (length > limit) {
            duct_release(allocator, buffer);
            return duct_fail(error, DUCT_LIMIT, "%s: is larger than the limit of %zu MiB", path, limit >> 20);
        }
    }
    buffer[length] = '\0';
    *data = buffer;
    *size = length;
    return DUCT_OK;
}

duct_status duct_file_read(const duct_allocator *allocator, const char *path, size_t limit, char **data,
                           size_t *size, duct_error *error)
{
    int file = open(path, O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        return fail_file(error, path, "read", errno);
    }
    struct stat facts;
    duct_status status;
    if (fstat(file, &facts) != 0) {
        status = fail_file(error, path, "read", errno);
    } else if (S_ISDIR(facts.st_mode)) {
        status = duct_fail(error, DUCT_IO, "%s: is a folder, not a file", path);
    } else if (S_ISREG(facts.st_mode) && facts.st_size > 0 && (uint64_t)facts.st_size > limit) {
        status = duct_fail(error, DUCT_LIMIT, "%s: is larger than the limit of %zu MiB", path, limit >> 20);
    } else {
        size_t expected = S_ISREG(facts.st_mode) && facts.st_size > 0 ? (size_t)facts.st_size + 1 : 65536;
        status = read_all(allocator, file, path, expected, limit, data, size, error);
    }
    close(file);
    return status;
}

static int write_all(int file, const void *data, size_t size)
{
    const char *bytes = data;
    while (size > 0) {
        ssize_t put = write(file, bytes, size);
        if (put < 0 && errno == EINTR) {
            continue;
        }
        if (put < 0) {
            return errno;
        }
        bytes += put;
        size -= (size_t)put;
    }
    return 0;
}

duct_status duct_file_beside(const duct_allocator *allocator, const char *path, char **beside,
                             duct_error *error)
{
    const char *ending = duct_path_ending(path);
    size_t suffix = *ending != '\0' ? strlen(ending) + 1 : 0;
    size_t folder = (size_t)(duct_path_name(path) - path);
    size_t size = folder + strlen(".ductus-XXXXXX") + suffix + 1;
    char *name = duct_alloc(allocator, size, 1);
    if (name == NULL) {
        return duct_fail_memory(error);
    }
    /* open() rather than mkstemp(), so that a new file gets the mode that any new file has. */
    int file = -1, number = EEXIST;
    for (unsigned attempt = 0; file < 0 && number == EEXIST && attempt < 100; attempt++) {
        struct timespec time;
        clock_gettime(CLOCK_MONOTONIC, &time);
        uint64_t bits = duct_random_bits((uint64_t)time.tv_nsec, (uint64_t)getpid(), attempt, 0);
        snprintf(name, size, "%.*s.ductus-%06x%s%s", (int)folder, path, (unsigned)(bits & 0xffffff),
                 suffix > 0 ? "." : "", ending);
        file = open(name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        number = errno;
    }
    if (file < 0) {
        duct_release(allocator, name);
        return fail_file(error, path, "written", number);
    }
    struct stat facts;
    if (stat(path, &facts) == 0) {
        fchmod(file, facts.st_mode & 07777);
    }
    close(file);
    *beside = name;
    return DUCT_OK;
}

duct_status duct_file_commit(const char *beside, const char *path, duct_error *error)
{
    if (rename(beside, path) != 0) {
        int number = errno;
        unlink(beside);
        return fail_file(error, path, "written", number);
    }
    return DUCT_OK;
}

duct_status duct_file_write(const duct_allocator *allocator, const char *path, const void *data, size_t size,
                            duct_error *error)
{
    struct stat facts;
    bool direct = stat(path, &facts) == 0 && !S_ISREG(facts.st_mode);
    if (direct && S_ISDIR(facts.st_mode)) {
        return duct_fail(error, DUCT_IO, "%s: is a folder; give the name of a file", path);
    }
    /* A symbolic link stays one: the file that it points to is replaced. */
    char *real = direct ? NULL : realpath(path, NULL);
    path = real != NULL ? real : path;
    char *beside = NULL;
    if (!direct) {
        duct_status status = duct_file_beside(allocator, path, &beside, error);
        if (status != DUCT_OK) {
            free(real);
            return status;
        }
    }
    const char *target = direct ? path : beside;
    int file = open(target, O_WRONLY | O_CLOEXEC | (direct ? 0 : O_TRUNC));
    int number = file < 0 ? errno : write_all(file, data, size);
    if (file >= 0 && close(file) != 0 && number == 0) {
        number = errno;
    }
    duct_status status = DUCT_OK;
    if (number != 0) {
        status = fail_file(error, path, "written", number);
        if (!direct) {
            unlink(beside);
        }
    } else if (!direct) {
        status = duct_file_commit(beside, path, error);
    }
    duct_release(allocator, beside);
    free(real);
    return status;
}

bool duct_file_exists(const char *path)
{
    struct stat facts;
    return stat(path, &facts) == 0;
}

bool duct_file_is_folder(const char *path)
{
    struct stat facts;
    return stat(path, &facts) == 0 && S_ISDIR(facts.st_mode);
}

const char *duct_path_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

const char *duct_path_ending(const char *path)
{
    const char *name = duct_path_name(path);
    const char *dot = strrchr(name, '.');
    return dot != NULL && dot != name ? dot + 1 : "";
}

bool duct_path_ends(const char *path, const char *ending)
{
    return strcasecmp(duct_path_ending(path), ending) == 0;
}

char *duct_path_join(const duct_allocator *allocator, const char *folder, const char *name)
{
    size_t size = strlen(folder) + strlen(name) + 2;
    char *path = duct_alloc(allocator, size, 1);
    if (path != NULL) {
        snprintf(path, size, "%s/%s", folder, name);
    }
    return path;
}
