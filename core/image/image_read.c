/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "image/image_private.h"

#include "base/error.h"
#include "base/file.h"

#include <stdint.h>
#include <string.h>

enum {
    MAX_SIDE = 1 << 17,
    MAX_PIXELS = 1 << 27 /* 2 GiB of floats */
};

/* The file's own troubles, told before OpenImageIO sees it, whose decoders overlook some. */
static duct_status check_file(const duct_context *context, const char *path, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    char *data = NULL;
    size_t size = 0;
    duct_status status = duct_file_read(allocator, path, DUCT_MAX_FILE_BYTES, &data, &size, error);
    if (status != DUCT_OK) {
        return status;
    }
    if (size == 0) {
        status = duct_fail(error, DUCT_BAD_FORMAT, "%s: the file is empty", path);
    } else if (duct_image_truncated((const unsigned char *)data, size)) {
        status = duct_fail(error, DUCT_BAD_FORMAT, "%s: the image file is cut off before its end", path);
    }
    duct_release(allocator, data);
    return status;
}

static duct_status check_size(const char *path, const duct_image_facts *facts, duct_error *error)
{
    if (facts->width < 1 || facts->height < 1 || facts->width > MAX_SIDE || facts->height > MAX_SIDE ||
        (int64_t)facts->width * facts->height > MAX_PIXELS) {
        return duct_fail(error, DUCT_LIMIT,
                         "%s: an image of %d x %d pixels is larger than the limit of %d million", path,
                         facts->width, facts->height, MAX_PIXELS / 1000000);
    }
    return DUCT_OK;
}

/* Makes the values what duct_image promises. */
static void normalise(const duct_image_facts *facts, float *pixels)
{
    size_t count = (size_t)facts->width * (size_t)facts->height;
    for (size_t i = 0; i < count; i++, pixels += 4) {
        float alpha = isfinite(pixels[3]) ? fminf(fmaxf(pixels[3], 0), 1) : 1;
        pixels[3] = alpha;
        for (size_t k = 0; k < 3; k++) {
            float value = isfinite(pixels[k]) ? pixels[k] : 0;
            if (facts->premultiplied) {
                value = alpha > 0 ? value / alpha : 0;
            }
            if (facts->encoding == DUCT_IMAGE_LINEAR) {
                value = duct_srgb_from_linear(value);
            }
            pixels[k] = fminf(fmaxf(value, 0), 1);
        }
    }
}

static duct_status fail_decoder(const char *path, const char *reason, duct_error *error)
{
    /* OpenImageIO often names the file itself, and several lines of reasons; the first is enough. */
    size_t length = strcspn(reason, "\n");
    while (length > 0 && (reason[length - 1] == '.' || reason[length - 1] == ' ')) {
        length--;
    }
    return duct_fail(error, DUCT_BAD_FORMAT, "%s: cannot be read as an image: %.*s", path, (int)length,
                     reason);
}

static duct_status read_opened(const duct_context *context, const char *path, const duct_image_module *module,
                               void *handle, const duct_image_facts *facts, duct_image *image,
                               duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_status status = check_size(path, facts, error);
    if (status != DUCT_OK) {
        return status;
    }
    size_t values = (size_t)facts->width * (size_t)facts->height * 4;
    float *pixels = duct_alloc(allocator, values, sizeof *pixels);
    if (pixels == NULL) {
        return duct_fail_memory(error);
    }
    char reason[DUCT_IMAGE_REASON_SIZE] = "";
    if (module->read(handle, pixels, reason) == 0) {
        duct_release(allocator, pixels);
        return fail_decoder(path, reason, error);
    }
    normalise(facts, pixels);
    *image = (duct_image){facts->width, facts->height, pixels, facts->resolution};
    return DUCT_OK;
}

duct_status duct_image_read(const duct_context *context, const char *path, duct_image *image,
                            duct_error *error)
{
    const duct_image_module *module = NULL;
    duct_status status = check_file(context, path, error);
    if (status == DUCT_OK) {
        status = duct_image_module_load(context, &module, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    duct_image_facts facts = {0};
    char reason[DUCT_IMAGE_REASON_SIZE] = "";
    void *handle = module->open_read(path, &facts, reason);
    if (handle == NULL) {
        return fail_decoder(path, reason, error);
    }
    status = read_opened(context, path, module, handle, &facts, image, error);
    module->close_read(handle);
    return status;
}

void duct_image_free(const duct_context *context, duct_image *image)
{
    if (image != NULL) {
        duct_release(duct_allocator_of(context), image->pixels);
        *image = (duct_image){0};
    }
}
