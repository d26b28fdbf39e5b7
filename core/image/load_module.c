/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "image/image_private.h"

#include "base/module.h"

#include <string.h>

static const duct_module_place place = {"ductus-image.so", "image", "image files need",
                                        DUCT_IMAGE_MODULE_ENTRY};

duct_status duct_image_module_load(const duct_context *context, const duct_image_module **module,
                                   duct_error *error)
{
    void *symbol;
    duct_status status = duct_module_open(context, &place, &symbol, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_image_module_entry entry;
    memcpy(&entry, &symbol, sizeof entry); /* ISO C has no cast from data to function pointers */
    const duct_image_module *loaded = entry();
    if (loaded == NULL || loaded->version != DUCT_IMAGE_MODULE_VERSION) {
        return duct_module_fail(&place, "it belongs to another version of Ductus", error);
    }
    *module = loaded;
    return DUCT_OK;
}
