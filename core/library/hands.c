/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What can be opened by name: the files of a kind that ship with Ductus and those in the user's folder. */
#include "library/hands.h"

#include "base/error.h"
#include "base/file.h"

#include <dirent.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
    const duct_allocator *allocator;
    const char *endings; /* separated by spaces */
    duct_hand *items;
    size_t count, capacity;
} hand_list;

static bool add_hand(hand_list *list, const char *folder, const char *file, bool builtin)
{
    void *items = list->items;
    if (!duct_reserve(list->allocator, &items, &list->capacity, list->count + 1, sizeof *list->items)) {
        return false;
    }
    list->items = items;
    char *name = duct_strdup(list->allocator, file);
    char *path = duct_path_join(list->allocator, folder, file);
    if (name == NULL || path == NULL) {
        duct_release(list->allocator, name);
        duct_release(list->allocator, path);
        return false;
    }
    name[strlen(name) - strlen(duct_path_ending(name)) - 1] = '\0';
    for (size_t i = 0; i < list->count; i++) {
        if (strcmp(list->items[i].name, name) == 0) {
            duct_release(list->allocator, name);
            duct_release(list->allocator, path);
            return true;
        }
    }
    list->items[list->count++] = (duct_hand){name, path, builtin};
    return true;
}

static bool is_wanted(const char *endings, const char *file)
{
    const char *ending = duct_path_ending(file);
    size_t size = strlen(ending);
    for (const char *at = endings; size > 0 && file[0] != '.' && (at = strstr(at, ending)) != NULL; at++) {
        if ((at == endings || at[-1] == ' ') && (at[size] == ' ' || at[size] == '\0')) {
            return true;
        }
    }
    return false;
}

/* Takes over `folder`, which may be NULL or not there. */
static bool add_folder(hand_list *list, char *folder, bool builtin)
{
    DIR *listing = folder != NULL ? opendir(folder) : NULL;
    bool good = true;
    if (listing != NULL) {
        for (struct dirent *entry; good && (entry = readdir(listing)) != NULL;) {
            const char *file = entry->d_name;
            if (is_wanted(list->endings, file)) {
                good = add_hand(list, folder, file, builtin);
            }
        }
        closedir(listing);
    }
    duct_release(list->allocator, folder);
    return good;
}

static char *user_folder(const duct_allocator *allocator, const char *kind)
{
    const char *data = getenv("XDG_DATA_HOME"), *home = getenv("HOME");
    bool given = data != NULL && *data == '/';
    if (!given && home == NULL) {
        return NULL;
    }
    char *own = duct_path_join(allocator, given ? "ductus" : ".local/share/ductus", kind);
    char *folder = own != NULL ? duct_path_join(allocator, given ? data : home, own) : NULL;
    duct_release(allocator, own);
    return folder;
}

static int by_name(const void *a, const void *b)
{
    return strcmp(((const duct_hand *)a)->name, ((const duct_hand *)b)->name);
}

duct_status duct_named_list(const duct_context *context, const char *kind, const char *endings,
                            duct_hand **items, size_t *count, duct_error *error)
{
    hand_list list = {duct_allocator_of(context), endings, NULL, 0, 0};
    bool good = add_folder(&list, user_folder(list.allocator, kind), false);
    char *data = duct_data_folder(context);
    good = good && data != NULL && add_folder(&list, duct_path_join(list.allocator, data, kind), true);
    duct_release(list.allocator, data);
    if (!good) {
        duct_hands_free(context, list.items, list.count);
        return duct_fail_memory(error);
    }
    if (list.count > 0) {
        qsort(list.items, list.count, sizeof *list.items, by_name);
    }
    *items = list.items;
    *count = list.count;
    return DUCT_OK;
}

duct_status duct_library_list(const duct_context *context, duct_hand **hands, size_t *count,
                              duct_error *error)
{
    return duct_named_list(context, "hands", "inkml", hands, count, error);
}

void duct_hands_free(const duct_context *context, duct_hand *hands, size_t count)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    for (size_t i = 0; i < count; i++) {
        duct_release(allocator, hands[i].name);
        duct_release(allocator, hands[i].path);
    }
    duct_release(allocator, hands);
}
