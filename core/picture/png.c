/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/picture_private.h"

#include "base/error.h"
#include "base/module.h"
#include "picture/module.h"

#include <math.h>
#include <string.h>

static const duct_module_place place = {"ductus-picture.so", "picture", "PNG pictures need",
                                        DUCT_PICTURE_MODULE_ENTRY};

duct_status duct_picture_png(const duct_context *context, const duct_picture *picture, double scale,
                             const char *path, const char *shown, duct_error *error)
{
    double larger = ceil(fmax(picture->width, picture->height) * scale);
    if (!(larger <= DUCT_PICTURE_LARGEST)) {
        return duct_fail(error, DUCT_LIMIT,
                         "%s: the picture would have %.0f pixels a side; %d is the most, so make it smaller "
                         "or write SVG",
                         shown, larger, DUCT_PICTURE_LARGEST);
    }
    void *symbol;
    duct_status status = duct_module_open(context, &place, &symbol, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_picture_module_entry entry;
    memcpy(&entry, &symbol, sizeof entry); /* ISO C has no cast from data to function pointers */
    const duct_picture_module *module = entry();
    if (module->version != DUCT_PICTURE_MODULE_VERSION) {
        return duct_module_fail(&place, "it belongs to another version of Ductus", error);
    }
    const char *reason = module->write_png(picture, scale, path);
    return reason == NULL ? DUCT_OK : duct_fail(error, DUCT_IO, "%s: cannot be written: %s", shown, reason);
}
