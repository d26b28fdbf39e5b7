/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a library's index file: the input as it is, and a good file with the input's changes, which are an
 * offset (two bytes) and a byte each, or with its end cut off. Only the good file itself may be taken. */
#include "fuzz.h"

#include "base/file.h"
#include "library/library_private.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { ROWS = 5, DIMENSIONS = 3 };

static const char key[] = "features 3";
static const float rows[ROWS * DIMENSIONS] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};

/* A name in memory's file system, so that no disk is worn. */
static const char *path(void)
{
    static char name[64];
    snprintf(name, sizeof name, "/dev/shm/ductus-fuzz-%d.index", (int)getpid());
    return name;
}

static bool is_taken(duct_library *library, const void *data, size_t size)
{
    float got[ROWS * DIMENSIONS] = {0};
    FILE *file = fopen(path(), "wb");
    fuzz_require(file != NULL && fwrite(data, 1, size, file) == size && fclose(file) == 0, "");
    bool taken = duct_index_read(library, key, got, ROWS, DIMENSIONS);
    fuzz_require(!taken || memcmp(got, rows, sizeof rows) == 0, "");
    unlink(path());
    return taken;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    duct_library library = {.allocator = *duct_allocator_of(NULL), .fingerprint = 77};
    char name[64], *good;
    size_t good_size;
    duct_error error = {DUCT_OK, ""};
    strcpy(name, path());
    library.index_path = name;
    fuzz_require(duct_index_write(&library, name, key, rows, ROWS, DIMENSIONS, &error) == DUCT_OK,
                 error.message);
    fuzz_require(duct_file_read(&library.allocator, name, 1 << 20, &good, &good_size, &error) == DUCT_OK,
                 error.message);
    char *changed = malloc(good_size);
    fuzz_require(changed != NULL && is_taken(&library, good, good_size), "");
    memcpy(changed, good, good_size);
    for (size_t i = 0; i + 2 < size; i += 3) {
        changed[(data[i] * 256u + data[i + 1]) % good_size] = (char)data[i + 2];
    }
    size_t length = size > 0 && data[size - 1] % 2 == 0 ? data[size - 1] * good_size / 256 : good_size;
    bool same = length == good_size && memcmp(changed, good, good_size) == 0;
    fuzz_require(is_taken(&library, changed, length) == same, "");
    same = size == good_size && memcmp(data, good, size) == 0;
    fuzz_require(is_taken(&library, data, size) == same, "");
    free(changed);
    duct_release(&library.allocator, good);
    return 0;
}
