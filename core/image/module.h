/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_IMAGE_MODULE_H
#define DUCTUS_IMAGE_MODULE_H

/* What libductus asks of the image module, ductus-image.so: a plain C interface behind which OpenImageIO
 * hides with its exceptions and its 262 libraries. libductus opens it with dlopen() when an image is read or
 * written. */

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { DUCT_IMAGE_MODULE_VERSION = 1, DUCT_IMAGE_REASON_SIZE = 256 };

typedef enum duct_image_encoding {
    DUCT_IMAGE_SRGB,  /* values are sRGB-encoded */
    DUCT_IMAGE_LINEAR /* values are linear light with the primaries of sRGB */
} duct_image_encoding;

typedef struct duct_image_facts {
    int width, height;
    int channels; /* 3: no alpha; 4 */
    int premultiplied;
    duct_image_encoding encoding;
    double resolution; /* pixels an inch; 0: none */
    int bits;          /* writing: 8, 16 or 32 a value; 32, and 16 in EXR, are floats */
} duct_image_facts;

/* Every call fills `reason` and returns 0 (or NULL) on failure. Rows are floats, `channels` a pixel. */
typedef struct duct_image_module {
    int version;
    void *(*open_read)(const char *path, duct_image_facts *facts, char reason[DUCT_IMAGE_REASON_SIZE]);
    /* All pixels, four values each whatever the file holds: grey is repeated, no alpha is 1. */
    int (*read)(void *handle, float *pixels, char reason[DUCT_IMAGE_REASON_SIZE]);
    void (*close_read)(void *handle);
    void *(*open_write)(const char *path, const duct_image_facts *facts, char reason[DUCT_IMAGE_REASON_SIZE]);
    int (*write_row)(void *handle, int y, const float *row, char reason[DUCT_IMAGE_REASON_SIZE]);
    /* Ends the file; frees the handle in any case. `keep` 0: the file will be thrown away. */
    int (*close_write)(void *handle, int keep, char reason[DUCT_IMAGE_REASON_SIZE]);
} duct_image_module;

/* The module's only symbol. */
typedef const duct_image_module *(*duct_image_module_entry)(void);
#define DUCT_IMAGE_MODULE_ENTRY "duct_image_module_get"

#ifdef __cplusplus
}
#endif

#endif
