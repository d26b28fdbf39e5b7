/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the library's own files lie, whether it is installed, moved as a whole, or run from its build folder.
 */
#include "base/file.h"

#include <dlfcn.h>
#include <stdlib.h>
#include <string.h>

#ifndef DUCTUS_INSTALLED_DATA
#define DUCTUS_INSTALLED_DATA "/usr/local/share/ductus"
#endif

char *duct_module_folder(const duct_allocator *allocator)
{
    Dl_info facts;
    /* Any address inside the library tells which file it came from. */
    static const char here;
    if (dladdr(&here, &facts) == 0 || facts.dli_fname == NULL) {
        return NULL;
    }
    char *real = realpath(facts.dli_fname, NULL);
    if (real == NULL) {
        return NULL;
    }
    char *slash = strrchr(real, '/');
    if (slash != NULL) {
        *slash = '\0';
    }
    char *folder = duct_strdup(allocator, real);
    free(real);
    return folder;
}

char *duct_data_folder(const duct_context *context)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    if (context != NULL && context->data_folder != NULL) {
        return duct_strdup(allocator, context->data_folder);
    }
    const char *given = getenv("DUCTUS_DATA_FOLDER");
    if (given != NULL && *given != '\0') {
        return duct_strdup(allocator, given);
    }
    char *module = duct_module_folder(allocator);
    if (module != NULL) {
        /* lib/, lib/<architecture>/ and the build's lib/ or bin/ all have share/ductus one or two folders up.
         */
        static const char *const tries[] = {"share/ductus", "../share/ductus", "../../share/ductus"};
        for (size_t i = 0; i < sizeof tries / sizeof tries[0]; i++) {
            char *path = duct_path_join(allocator, module, tries[i]);
            if (path != NULL && duct_file_is_folder(path)) {
                duct_release(allocator, module);
                return path;
            }
            duct_release(allocator, path);
        }
        duct_release(allocator, module);
    }
    return duct_strdup(allocator, DUCTUS_INSTALLED_DATA);
}
