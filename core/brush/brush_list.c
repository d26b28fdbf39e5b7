/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/brush_private.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

static int compare_names(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static void free_names(const duct_allocator *allocator, char **names, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        duct_release(allocator, names[i]);
    }
    duct_release(allocator, names);
}

/* The file name without ".myb". */
static char *bare_name(const duct_allocator *allocator, const char *path)
{
    char *name = duct_strdup(allocator, duct_path_name(path));
    if (name != NULL && duct_path_ends(name, "myb")) {
        name[strlen(name) - strlen(".myb")] = '\0';
    }
    return name;
}

static char *brush_folder(const duct_context *context)
{
    char *data = duct_data_folder(context);
    char *folder = data != NULL ? duct_path_join(duct_allocator_of(context), data, "brushes") : NULL;
    duct_release(duct_allocator_of(context), data);
    return folder;
}

duct_status duct_brush_list(const duct_context *context, char ***names, size_t *count, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    char *path = brush_folder(context);
    char **found = duct_alloc(allocator, 1, sizeof *found);
    if (path == NULL || found == NULL) {
        duct_release(allocator, path);
        duct_release(allocator, found);
        return duct_fail_memory(error);
    }
    size_t size = 0, capacity = 1;
    bool failed = false;
    DIR *folder = opendir(path);
    for (struct dirent *entry; folder != NULL && !failed && (entry = readdir(folder)) != NULL;) {
        if (!duct_path_ends(entry->d_name, "myb")) {
            continue;
        }
        void *memory = found;
        failed = !duct_reserve(allocator, &memory, &capacity, size + 1, sizeof *found);
        found = memory;
        if (!failed) {
            found[size] = bare_name(allocator, entry->d_name);
            failed = found[size] == NULL;
            size += failed ? 0 : 1;
        }
    }
    if (folder != NULL) {
        closedir(folder);
    }
    duct_release(allocator, path);
    if (failed) {
        free_names(allocator, found, size);
        return duct_fail_memory(error);
    }
    qsort(found, size, sizeof *found, compare_names);
    *names = found;
    *count = size;
    return DUCT_OK;
}

static duct_status fail_unknown(const duct_context *context, const char *name, duct_error *error)
{
    char **names = NULL;
    size_t count = 0;
    duct_status status = duct_brush_list(context, &names, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_text list;
    duct_text_init(&list, duct_allocator_of(context));
    for (size_t i = 0; i < count; i++) {
        duct_text_add(&list, i > 0 ? ", " : "");
        duct_text_add(&list, names[i]);
    }
    free_names(duct_allocator_of(context), names, count);
    status = list.failed ? duct_fail_memory(error)
                         : duct_fail(error, DUCT_NOT_FOUND,
                                     "there is no brush \"%s\"; there are: %s (or give a .myb file)", name,
                                     count > 0 ? list.data : "none");
    duct_text_free(&list);
    return status;
}

/* The path of the brush of that name, or a copy of the path given. */
static duct_status find_file(const duct_context *context, const char *name, char **path, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    if (strchr(name, '/') != NULL || duct_path_ends(name, "myb")) {
        *path = duct_strdup(allocator, name);
        return *path != NULL ? DUCT_OK : duct_fail_memory(error);
    }
    char *folder = brush_folder(context);
    duct_text file;
    duct_text_init(&file, allocator);
    if (folder != NULL) {
        duct_text_addf(&file, "%s/%s.myb", folder, name);
    }
    bool failed = folder == NULL || file.failed;
    duct_release(allocator, folder);
    if (failed) {
        duct_text_free(&file);
        return duct_fail_memory(error);
    }
    if (!duct_file_exists(file.data)) {
        duct_text_free(&file);
        return fail_unknown(context, name, error);
    }
    *path = duct_text_take(&file, NULL);
    return DUCT_OK;
}

static duct_status load(const duct_context *context, const char *path, duct_brush *brush, duct_error *error)
{
    enum { largest_file = 1 << 22 };
    char *data = NULL;
    size_t size = 0;
    brush->name = bare_name(brush->allocator, path);
    if (brush->name == NULL) {
        return duct_fail_memory(error);
    }
    duct_status status = duct_file_read(duct_allocator_of(context), path, largest_file, &data, &size, error);
    if (status != DUCT_OK) {
        return status;
    }
    if (strlen(data) != size) {
        status = duct_fail(error, DUCT_BAD_FORMAT, "is not a MyPaint brush: it is not text");
    } else {
        status = duct_brush_parse(brush, data, error);
    }
    duct_release(duct_allocator_of(context), data);
    if (status != DUCT_OK && status != DUCT_NO_MEMORY) {
        duct_error_prefix(error, path);
    }
    return status;
}

duct_status duct_brush_load(const duct_context *context, const char *name_or_path, duct_brush **brush,
                            duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    char *path = NULL;
    duct_status status = find_file(context, name_or_path, &path, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_brush *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        status = duct_fail_memory(error);
    } else {
        made->allocator = allocator;
        status = load(context, path, made, error);
    }
    duct_release(allocator, path);
    if (status != DUCT_OK) {
        duct_brush_free(made);
        return status;
    }
    *brush = made;
    return DUCT_OK;
}

void duct_brush_free(duct_brush *brush)
{
    if (brush != NULL) {
        duct_release(brush->allocator, brush->curves);
        duct_release(brush->allocator, brush->name);
        duct_release(brush->allocator, brush);
    }
}

const char *duct_brush_name(const duct_brush *brush)
{
    return brush->name;
}
