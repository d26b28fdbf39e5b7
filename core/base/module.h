/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_MODULE_H
#define DUCTUS_BASE_MODULE_H

#include <ductus/context.h>
#include <ductus/status.h>

/* Parts of Ductus that drag in large libraries are modules: shared objects beside libductus that are loaded
 * when they are first needed, so that starting stays light. */
typedef struct duct_module_place {
    const char *file;    /* "ductus-image.so" */
    const char *name;    /* "image", for sentences */
    const char *purpose; /* what needs it, for sentences: "image files need" */
    const char *entry;   /* the symbol to find */
} duct_module_place;

/* Opens the module in $DUCTUS_MODULE_FOLDER, or beside libductus, or where it was installed, and finds its
 * symbol. It stays loaded until the process ends, so calling it again costs little. Errors: DUCT_UNSUPPORTED
 * (not there, or cannot be loaded), DUCT_NO_MEMORY. */
duct_status duct_module_open(const duct_context *context, const duct_module_place *place, void **symbol,
                             duct_error *error);

/* The sentence for a module that is there and cannot be used. */
duct_status duct_module_fail(const duct_module_place *place, const char *reason, duct_error *error);

#endif
