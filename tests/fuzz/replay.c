/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fuzzers as plain programs: runs through all files, and all files of the folders, that are given. */
#include "fuzz.h"

#include <dirent.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

static long runs;

static void run_file(const char *path, size_t size)
{
    FILE *file = fopen(path, "rb");
    char *data = malloc(size > 0 ? size : 1); /* of exactly its size, so that a step too far shows */
    if (file == NULL || data == NULL || fread(data, 1, size, file) != size) {
        fprintf(stderr, "%s: cannot be read\n", path);
        exit(1);
    }
    fclose(file);
    LLVMFuzzerTestOneInput((const uint8_t *)data, size);
    free(data);
    runs++;
}

static void run_path(const char *path)
{
    struct stat facts;
    if (stat(path, &facts) != 0) {
        fprintf(stderr, "%s: is not there\n", path);
        exit(1);
    }
    if (!S_ISDIR(facts.st_mode)) {
        run_file(path, (size_t)facts.st_size);
        return;
    }
    DIR *folder = opendir(path);
    struct dirent *entry;
    while (folder != NULL && (entry = readdir(folder)) != NULL) {
        char inside[4096];
        snprintf(inside, sizeof inside, "%s/%s", path, entry->d_name);
        if (entry->d_name[0] != '.') {
            run_path(inside);
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
}

int main(int count, char **paths)
{
    for (int i = 1; i < count; i++) {
        run_path(paths[i]);
    }
    printf("%ld files\n", runs);
    return runs > 0 ? 0 : 1;
}
