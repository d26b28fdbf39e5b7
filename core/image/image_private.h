/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_IMAGE_PRIVATE_H
#define DUCTUS_IMAGE_PRIVATE_H

#include "base/memory.h"
#include "image/module.h"

#include <ductus/image.h>

#include <math.h>

/* Opens the image module and gives its functions. It stays loaded until the process ends. Errors:
 * DUCT_UNSUPPORTED, DUCT_NO_MEMORY. */
duct_status duct_image_module_load(const duct_context *context, const duct_image_module **module,
                                   duct_error *error);

/* True where the data is a JPEG or PNG file that lacks its end. */
bool duct_image_truncated(const unsigned char *data, size_t size);

/* The transfer function of sRGB (IEC 61966-2-1), mirrored for negative values. */
static inline float duct_srgb_from_linear(float value)
{
    float v = fabsf(value);
    float encoded = v <= 0.0031308f ? 12.92f * v : 1.055f * powf(v, 1 / 2.4f) - 0.055f;
    return value < 0 ? -encoded : encoded;
}

static inline float duct_linear_from_srgb(float value)
{
    float v = fabsf(value);
    float linear = v <= 0.04045f ? v / 12.92f : powf((v + 0.055f) / 1.055f, 2.4f);
    return value < 0 ? -linear : linear;
}

#endif
