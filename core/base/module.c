/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/module.h"

#include "base/error.h"
#include "base/file.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

enum { REASON_SIZE = 256 };

/* Takes the symbol out of an opened file. dlopen() counts its openings and keeps the file loaded, so calling
 * it again costs nothing and no handle has to be remembered. */
static void *symbol_in(const char *path, const char *entry, char reason[REASON_SIZE])
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == NULL) {
        const char *text = dlerror();
        strncpy(reason, text != NULL ? text : "", REASON_SIZE - 1);
        return NULL;
    }
    void *symbol = dlsym(library, entry);
    if (symbol == NULL) {
        strncpy(reason, "it belongs to another version of Ductus", REASON_SIZE - 1);
    }
    dlclose(library); /* RTLD_NODELETE: it stays */
    return symbol;
}

typedef struct {
    const duct_allocator *allocator;
    const duct_module_place *place;
    bool found; /* the module is there, though it may not load */
    void *symbol;
    char reason[REASON_SIZE];
} finder;

/* Tries one folder. False without memory. */
static bool try_folder(finder *self, const char *folder)
{
    if (self->found) {
        return true;
    }
    char *path = duct_path_join(self->allocator, folder, self->place->file);
    if (path == NULL) {
        return false;
    }
    if (duct_file_exists(path)) {
        self->found = true;
        self->symbol = symbol_in(path, self->place->entry, self->reason);
    }
    duct_release(self->allocator, path);
    return true;
}

static bool try_all(finder *self)
{
    const char *given = getenv("DUCTUS_MODULE_FOLDER");
    if (given != NULL && *given != '\0') {
        return try_folder(self, given);
    }
    static const char *const places[] = {"ductus", "../lib/ductus", ".", "../ductus"};
    char *own = duct_module_folder(self->allocator);
    /* The own place is unknown where there is no memory for it, hardly ever otherwise. */
    bool own_known = own != NULL, memory = true;
    for (size_t i = 0; own != NULL && memory && i < sizeof places / sizeof places[0]; i++) {
        char *folder = duct_path_join(self->allocator, own, places[i]);
        memory = folder != NULL && try_folder(self, folder);
        duct_release(self->allocator, folder);
    }
    duct_release(self->allocator, own);
    memory = memory && try_folder(self, DUCTUS_INSTALLED_MODULES);
    return memory && (own_known || self->found);
}

duct_status duct_module_open(const duct_context *context, const duct_module_place *place, void **symbol,
                             duct_error *error)
{
    finder self = {.allocator = duct_allocator_of(context), .place = place};
    if (!try_all(&self)) {
        return duct_fail_memory(error);
    }
    if (!self.found) {
        return duct_fail(error, DUCT_UNSUPPORTED,
                         "%s Ductus's %s module (%s), which is not installed; install it or set "
                         "DUCTUS_MODULE_FOLDER to its folder",
                         place->purpose, place->name, place->file);
    }
    if (self.symbol == NULL) {
        return duct_module_fail(place, self.reason, error);
    }
    *symbol = self.symbol;
    return DUCT_OK;
}

duct_status duct_module_fail(const duct_module_place *place, const char *reason, duct_error *error)
{
    return duct_fail(error, DUCT_UNSUPPORTED, "Ductus's %s module cannot be loaded: %s", place->name, reason);
}
