/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_IMAGE_H
#define DUCTUS_IMAGE_H

#include <ductus/render.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Image files, all of them through OpenImageIO, which is loaded only when one is read or written. */

/* Red, green, blue, alpha: not premultiplied, sRGB-encoded, 0..1, row by row from the upper left. */
typedef struct duct_image {
    int width, height;
    float *pixels;     /* width * height * 4 values, owned by the image */
    double resolution; /* pixels an inch; 0: the file does not say */
} duct_image;

/* Reads an image file: PNG, TIFF, EXR, JPEG and whatever else OpenImageIO reads; grey, palettes and CMYK
 * become red, green and blue. Sizes are checked before memory is taken (at most 134 million pixels); a
 * truncated file is an error, JPEG included. The caller frees it with duct_image_free(). Errors: DUCT_IO,
 * DUCT_BAD_FORMAT, DUCT_LIMIT, DUCT_NO_MEMORY, DUCT_UNSUPPORTED (the image module is not installed). */
DUCT_API duct_status duct_image_read(const duct_context *context, const char *path, duct_image *image,
                                     duct_error *error);
DUCT_API void duct_image_free(const duct_context *context, duct_image *image);

typedef struct duct_image_options {
    float background[4]; /* as duct_render_options; alpha 0 leaves the image transparent */
    double resolution;   /* pixels an inch, written into the file; 0: none */
    int bits;            /* 8 or 16 for PNG and TIFF, 16 or 32 (float) for EXR; 0: the format's usual */
} duct_image_options;

/* True where the path's ending is that of an image format that can be written: png, tif, tiff, exr. */
DUCT_API bool duct_image_writable(const char *path);

/* Writes a canvas over a background. PNG and TIFF are written sRGB-encoded with alpha not premultiplied, EXR
 * linear and premultiplied, each tagged so. The rows are made as they are written; memory is that of the
 * canvas and some rows. The file appears whole or not at all. `options` may be NULL: opaque white, no
 * resolution. Errors: DUCT_IO, DUCT_UNSUPPORTED, DUCT_NO_MEMORY. */
DUCT_API duct_status duct_image_write(const duct_context *context, const duct_canvas *canvas,
                                      const char *path, const duct_image_options *options, duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
