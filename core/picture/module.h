/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_PICTURE_MODULE_H
#define DUCTUS_PICTURE_MODULE_H

#include "picture/picture_private.h"

/* What libductus asks of the picture module, ductus-picture.so, which hides cairo and the dozen libraries
 * that it brings. */
enum { DUCT_PICTURE_MODULE_VERSION = 1 };

typedef struct duct_picture_module {
    int version;
    /* Draws the picture and writes it as PNG. NULL where that worked, otherwise the reason, in static
     * storage. */
    const char *(*write_png)(const duct_picture *picture, double scale, const char *path);
} duct_picture_module;

/* The module's only symbol. */
typedef const duct_picture_module *(*duct_picture_module_entry)(void);
#define DUCT_PICTURE_MODULE_ENTRY "duct_picture_module_get"

#endif
