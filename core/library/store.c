/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Libraries as files: opening by path or by hand's name, saving. */
#include "library/library_private.h"

#include "base/error.h"
#include "base/file.h"
#include "base/number.h"
#include "base/text.h"
#include "library/annotations.h"
#include "library/feature_index.h"
#include "library/weights.h"

#include <ductus/format.h>

#include <dirent.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Recordings read so far. */
typedef struct {
    duct_drawing **items;
    size_t count, capacity;
} recordings;

static void free_recordings(const duct_allocator *allocator, recordings *all)
{
    for (size_t i = 0; i < all->count; i++) {
        duct_drawing_free(all->items[i]);
    }
    duct_release(allocator, all->items);
}

static duct_status read_one(const duct_context *context, const char *path, recordings *all, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    void *items = all->items;
    if (!duct_reserve(allocator, &items, &all->capacity, all->count + 1, sizeof(duct_drawing *))) {
        return duct_fail_memory(error);
    }
    all->items = items;
    duct_status status = duct_drawing_read(context, path, NULL, &all->items[all->count], error);
    if (status == DUCT_OK) {
        all->count++;
    }
    return status;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

/* True where a format says that it reads files with this ending. */
static bool is_recording(const char *path)
{
    const char *ending = duct_path_ending(path);
    size_t length = strlen(ending);
    for (size_t i = 0; length > 0 && duct_format_at(i) != NULL; i++) {
        const char *list = duct_format_at(i)->extensions;
        for (const char *at = list; duct_format_at(i)->reads && at != NULL && *at != '\0';) {
            size_t word = strcspn(at, " ");
            if (word == length && strncasecmp(at, ending, word) == 0) {
                return true;
            }
            at += word + (at[word] == ' ');
        }
    }
    return false;
}

static duct_status read_folder(const duct_context *context, const char *folder, recordings *all,
                               duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    DIR *listing = opendir(folder);
    if (listing == NULL) {
        return duct_fail(error, DUCT_IO, "%s: the folder cannot be read", folder);
    }
    char **paths = NULL;
    size_t count = 0, capacity = 0;
    duct_status status = DUCT_OK;
    for (struct dirent *entry; status == DUCT_OK && (entry = readdir(listing)) != NULL;) {
        if (entry->d_name[0] == '.' || !is_recording(entry->d_name)) {
            continue;
        }
        void *grown = paths;
        bool room = duct_reserve(allocator, &grown, &capacity, count + 1, sizeof *paths);
        paths = grown;
        char *path = room ? duct_path_join(allocator, folder, entry->d_name) : NULL;
        if (path == NULL) {
            status = duct_fail_memory(error);
        } else {
            paths[count++] = path;
        }
    }
    closedir(listing);
    if (count > 0) {
        qsort(paths, count, sizeof *paths, by_name);
    }
    for (size_t i = 0; i < count; i++) {
        if (status == DUCT_OK) {
            status = read_one(context, paths[i], all, error);
        }
        duct_release(allocator, paths[i]);
    }
    duct_release(allocator, paths);
    if (status == DUCT_OK && count == 0) {
        status = duct_fail(error, DUCT_NOT_FOUND, "%s: the folder holds no recordings", folder);
    }
    return status;
}

/* The file's name without its ending, for a recording that states no name. */
static char *plain_name(const duct_allocator *allocator, const char *path)
{
    char *name = duct_strdup(allocator, duct_path_name(path));
    if (name != NULL) {
        const char *ending = duct_path_ending(name);
        if (*ending != '\0') {
            name[strlen(name) - strlen(ending) - 1] = '\0';
        }
    }
    return name;
}

static duct_status open_path(const duct_context *context, const char *path, duct_library **library,
                             duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    recordings all = {NULL, 0, 0};
    bool folder = duct_file_is_folder(path);
    duct_status status =
        folder ? read_folder(context, path, &all, error) : read_one(context, path, &all, error);
    duct_library *made = NULL;
    if (status == DUCT_OK) {
        const duct_drawing *const *list = (const duct_drawing *const *)all.items;
        status = duct_library_build(context, list, all.count, NULL, &made, error);
        if (status != DUCT_OK) {
            duct_error_prefix(error, path);
        }
    }
    free_recordings(allocator, &all);
    if (status == DUCT_OK && *made->name == '\0') {
        duct_release(&made->allocator, made->name);
        made->name = plain_name(&made->allocator, path);
        status = made->name != NULL ? DUCT_OK : duct_fail_memory(error);
    }
    if (status == DUCT_OK && !folder) {
        size_t size = strlen(path) + sizeof ".index";
        made->index_path = duct_alloc(&made->allocator, size, 1);
        if (made->index_path != NULL) {
            snprintf(made->index_path, size, "%s.index", path);
        }
    }
    if (status != DUCT_OK) {
        duct_library_free(made);
        return status;
    }
    *library = made;
    return DUCT_OK;
}

static duct_status fail_hand(const duct_context *context, const char *name, duct_error *error)
{
    duct_hand *hands;
    size_t count;
    duct_status status = duct_library_list(context, &hands, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    char names[384] = "";
    for (size_t i = 0; i < count; i++) {
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "", hands[i].name);
    }
    duct_hands_free(context, hands, count);
    return duct_fail(error, DUCT_NOT_FOUND,
                     "%s: there is no hand or file of that name; the hands here are: %s", name,
                     count > 0 ? names : "none");
}

duct_status duct_library_open(const duct_context *context, const char *name_or_path, duct_library **library,
                              duct_error *error)
{
    if (*name_or_path == '\0') {
        return fail_hand(context, "''", error);
    }
    /* A folder that happens to have a hand's name does not hide the hand; with a '/' it is surely meant. */
    bool word = strchr(name_or_path, '/') == NULL && duct_file_is_folder(name_or_path);
    if (duct_file_exists(name_or_path) && !word) {
        return open_path(context, name_or_path, library, error);
    }
    duct_hand *hands;
    size_t count;
    duct_status status = duct_library_list(context, &hands, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    const char *path = NULL;
    for (size_t i = 0; i < count; i++) {
        path = strcmp(hands[i].name, name_or_path) == 0 ? hands[i].path : path;
    }
    status =
        path != NULL ? open_path(context, path, library, error) : fail_hand(context, name_or_path, error);
    duct_hands_free(context, hands, count);
    return status;
}

static duct_status annotate_weights(duct_drawing *drawing, const duct_library *library, duct_error *error)
{
    duct_text text;
    duct_text_init(&text, &library->allocator);
    duct_weights_print(&text, library->weights, library->stroke_count);
    duct_status status = text.failed
                             ? duct_fail_memory(error)
                             : duct_drawing_annotate(drawing, DUCT_ANNOTATION_WEIGHTS, text.data, error);
    duct_text_free(&text);
    return status;
}

duct_status duct_library_drawing(const duct_context *context, const duct_library *library,
                                 duct_drawing **drawing, duct_error *error)
{
    duct_drawing *made;
    duct_status status = duct_drawing_new(context, &made, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_drawing_set_page(made, library->width, library->height);
    char unit[DUCT_NUMBER_SIZE];
    duct_number_print(unit, library->unit, 0);
    const char *facts[][2] = {{DUCT_ANNOTATION_NAME, library->name},
                              {DUCT_ANNOTATION_ARTIST, library->artist},
                              {DUCT_ANNOTATION_LICENCE, library->licence},
                              {DUCT_ANNOTATION_UNIT, unit}};
    for (size_t i = 0; status == DUCT_OK && i < sizeof facts / sizeof facts[0]; i++) {
        if (*facts[i][1] != '\0') {
            status = duct_drawing_annotate(made, facts[i][0], facts[i][1], error);
        }
    }
    if (status == DUCT_OK && library->weights != NULL) {
        status = annotate_weights(made, library, error);
    }
    for (size_t s = 0; status == DUCT_OK && s < library->stroke_count; s++) {
        size_t start = library->starts[s], count = library->starts[s + 1] - start;
        char id[32];
        snprintf(id, sizeof id, "%zu", s);
        duct_stroke *stroke;
        status = duct_drawing_add_stroke(made, id, count, &stroke, error);
        for (int c = 0; status == DUCT_OK && c < DUCT_CHANNEL_COUNT; c++) {
            if (library->channels[c] == NULL) {
                continue;
            }
            double *values = duct_stroke_edit(stroke, (duct_channel)c);
            if (values == NULL) {
                status = duct_fail_memory(error);
                break;
            }
            double scale = c == DUCT_X || c == DUCT_Y ? library->unit : 1;
            for (size_t i = 0; i < count; i++) {
                values[i] = library->channels[c][start + i] * scale;
            }
        }
    }
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    *drawing = made;
    return DUCT_OK;
}

/* Digits beyond these are below what a tablet tells, and would double the file. */
static void round_off(duct_drawing *drawing)
{
    static const double steps[DUCT_CHANNEL_COUNT] = {1e4, 1e4, 1e6, 1e5, 1e5, 1e5, 1e5};
    for (size_t s = 0; s < duct_drawing_stroke_count(drawing); s++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, s);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            double *values = duct_stroke_values(stroke, (duct_channel)c) != NULL
                                 ? duct_stroke_edit(stroke, (duct_channel)c)
                                 : NULL;
            for (size_t i = 0; values != NULL && i < duct_stroke_size(stroke); i++) {
                values[i] = rint(values[i] * steps[c]) / steps[c];
            }
        }
    }
}

duct_status duct_library_save(const duct_context *context, const duct_library *library, const char *path,
                              duct_error *error)
{
    if (!duct_path_ends(path, "inkml")) {
        return duct_fail(error, DUCT_UNSUPPORTED,
                         "%s: a library is an InkML file; let its name end in .inkml", path);
    }
    duct_drawing *drawing;
    duct_status status = duct_library_drawing(context, library, &drawing, error);
    if (status != DUCT_OK) {
        return status;
    }
    round_off(drawing);
    status = duct_drawing_write(context, drawing, path, NULL, error);
    duct_drawing_free(drawing);
    if (status != DUCT_OK) {
        return status;
    }
    /* The index must fit what a reader of the file gets, to the last bit: so it is made from the file. It
     * only saves time, so a folder that refuses it is no failure. */
    duct_library *again;
    duct_error ignored;
    if (open_path(context, path, &again, &ignored) == DUCT_OK) {
        duct_library_save_features(again, &ignored);
        duct_library_free(again);
    }
    return DUCT_OK;
}
