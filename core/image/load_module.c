/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "image/image_private.h"

#include "base/error.h"
#include "base/file.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

static const char module_name[] = "ductus-image.so";

/* Takes the module out of an opened file. dlopen() counts its openings and keeps the file loaded, so calling
 * it again costs nothing and no handle has to be remembered. */
static const duct_image_module *module_in(const char *path, char reason[DUCT_IMAGE_REASON_SIZE])
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == NULL) {
        const char *text = dlerror();
        strncpy(reason, text != NULL ? text : "", DUCT_IMAGE_REASON_SIZE - 1);
        return NULL;
    }
    duct_image_module_entry entry = NULL;
    void *symbol = dlsym(library, DUCT_IMAGE_MODULE_ENTRY);
    memcpy(&entry, &symbol, sizeof entry); /* ISO C has no cast from data to function pointers */
    const duct_image_module *module = entry != NULL ? entry() : NULL;
    if (module != NULL && module->version != DUCT_IMAGE_MODULE_VERSION) {
        strncpy(reason, "it belongs to another version of Ductus", DUCT_IMAGE_REASON_SIZE - 1);
        module = NULL;
    }
    dlclose(library); /* RTLD_NODELETE: it stays */
    return module;
}

/* Tries one folder. `found` tells that the module is there, though it may not load. False without memory. */
static bool try_folder(const duct_allocator *allocator, const char *folder, bool *found,
                       const duct_image_module **module, char reason[DUCT_IMAGE_REASON_SIZE])
{
    if (*found) {
        return true;
    }
    char *path = duct_path_join(allocator, folder, module_name);
    if (path == NULL) {
        return false;
    }
    if (duct_file_exists(path)) {
        *found = true;
        *module = module_in(path, reason);
    }
    duct_release(allocator, path);
    return true;
}

duct_status duct_image_module_load(const duct_context *context, const duct_image_module **module,
                                   duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    char reason[DUCT_IMAGE_REASON_SIZE] = "";
    bool found = false, memory = true;
    const duct_image_module *loaded = NULL;
    const char *given = getenv("DUCTUS_MODULE_FOLDER");
    if (given != NULL && *given != '\0') {
        memory = try_folder(allocator, given, &found, &loaded, reason);
    } else {
        char *own = duct_module_folder(allocator);
        static const char *const places[] = {"ductus", "../lib/ductus", ".", "../ductus"};
        for (size_t i = 0; own != NULL && memory && i < sizeof places / sizeof places[0]; i++) {
            char *folder = duct_path_join(allocator, own, places[i]);
            memory = folder != NULL && try_folder(allocator, folder, &found, &loaded, reason);
            duct_release(allocator, folder);
        }
        duct_release(allocator, own);
        memory = memory && try_folder(allocator, DUCTUS_INSTALLED_MODULES, &found, &loaded, reason);
    }
    if (!memory) {
        return duct_fail_memory(error);
    }
    if (!found) {
        return duct_fail(
            error, DUCT_UNSUPPORTED,
            "image files need Ductus's image module (%s), which is not installed; install it or set "
            "DUCTUS_MODULE_FOLDER to its folder",
            module_name);
    }
    if (loaded == NULL) {
        return duct_fail(error, DUCT_UNSUPPORTED, "Ductus's image module cannot be loaded: %s", reason);
    }
    *module = loaded;
    return DUCT_OK;
}
