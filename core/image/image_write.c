/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "image/image_private.h"

#include "base/error.h"
#include "base/file.h"

#include <string.h>
#include <unistd.h>

enum { FIX_ONE = 1 << 15 };

typedef struct target {
    const char *ending;
    bool linear; /* linear and premultiplied, in floats */
    int bits[2]; /* that can be written; the first is the usual one */
} target;

static const target targets[] = {
    {"png", false, {8, 16}}, {"tif", false, {8, 16}}, {"tiff", false, {8, 16}}, {"exr", true, {16, 32}}};

static const target *target_of(const char *path)
{
    for (size_t i = 0; i < sizeof targets / sizeof targets[0]; i++) {
        if (duct_path_ends(path, targets[i].ending)) {
            return &targets[i];
        }
    }
    return NULL;
}

bool duct_image_writable(const char *path)
{
    return target_of(path) != NULL;
}

/* A pixel of the canvas over the background: premultiplied, sRGB-encoded, which is the space libmypaint
 * blends in. */
static void blend_background(const uint16_t *pixel, const float background[4], float out[4])
{
    float rest = pixel != NULL ? 1 - (float)pixel[3] / FIX_ONE : 1;
    for (size_t k = 0; k < 4; k++) {
        float below = k < 3 ? background[k] * background[3] : background[3];
        out[k] = (pixel != NULL ? (float)pixel[k] / FIX_ONE : 0) + rest * below;
    }
}

/* One row of the file from the canvas's tiles. */
static void make_row(const duct_canvas *canvas, int y, const target *kind, const float background[4],
                     size_t channels, float *row)
{
    int width = duct_canvas_width(canvas);
    const uint16_t *line = NULL;
    for (int x = 0; x < width; x++, row += channels) {
        if (x % DUCT_TILE_SIZE == 0) {
            const uint16_t *tile = duct_canvas_tile(canvas, x / DUCT_TILE_SIZE, y / DUCT_TILE_SIZE);
            line = tile != NULL ? tile + (size_t)(y % DUCT_TILE_SIZE) * DUCT_TILE_SIZE * 4 : NULL;
        }
        float mixed[4];
        blend_background(line != NULL ? line + (size_t)(x % DUCT_TILE_SIZE) * 4 : NULL, background, mixed);
        for (size_t k = 0; k < 3; k++) {
            float value = mixed[3] > 0 ? fminf(mixed[k] / mixed[3], 1) : 0;
            row[k] = kind->linear ? duct_linear_from_srgb(value) * mixed[3] : value;
        }
        if (channels == 4) {
            row[3] = mixed[3];
        }
    }
}

static duct_status fail_writing(const char *path, const char *reason, duct_error *error)
{
    return duct_fail(error, DUCT_IO, "%s: cannot be written: %.*s", path, (int)strcspn(reason, "\n"), reason);
}

/* Writes the file under a temporary name, which has the ending that tells the format. */
static duct_status write_rows(const duct_canvas *canvas, const char *path, const char *beside,
                              const target *kind, const duct_image_options *options,
                              const duct_image_module *module, float *row, duct_error *error)
{
    bool opaque = options->background[3] >= 1;
    const duct_image_facts facts = {duct_canvas_width(canvas),
                                    duct_canvas_height(canvas),
                                    opaque ? 3 : 4,
                                    kind->linear,
                                    kind->linear ? DUCT_IMAGE_LINEAR : DUCT_IMAGE_SRGB,
                                    options->resolution,
                                    options->bits};
    char reason[DUCT_IMAGE_REASON_SIZE] = "";
    void *handle = module->open_write(beside, &facts, reason);
    if (handle == NULL) {
        return fail_writing(path, reason, error);
    }
    bool done = true;
    for (int y = 0; y < facts.height && done; y++) {
        make_row(canvas, y, kind, options->background, (size_t)facts.channels, row);
        done = module->write_row(handle, y, row, reason) != 0;
    }
    char last[DUCT_IMAGE_REASON_SIZE] = "";
    bool closed = module->close_write(handle, done, last) != 0;
    return done && closed ? DUCT_OK : fail_writing(path, done ? last : reason, error);
}

/* Options with all choices made. */
static duct_status settle(const char *path, const target *kind, const duct_image_options *options,
                          duct_image_options *settled, duct_error *error)
{
    *settled = options != NULL ? *options : (duct_image_options){.background = {1, 1, 1, 1}};
    if (settled->bits == 0) {
        settled->bits = kind->bits[0];
    }
    if (settled->bits != kind->bits[0] && settled->bits != kind->bits[1]) {
        return duct_fail(error, DUCT_UNSUPPORTED,
                         "%s: %s files are written with %d or %d bits a value, not %d", path, kind->ending,
                         kind->bits[0], kind->bits[1], settled->bits);
    }
    for (size_t k = 0; k < 4; k++) {
        float value = settled->background[k];
        settled->background[k] = value > 0 ? fminf(value, 1) : 0; /* not a number counts as 0 */
    }
    if (!(settled->resolution > 0) || !isfinite(settled->resolution)) {
        settled->resolution = 0;
    }
    return DUCT_OK;
}

duct_status duct_image_write(const duct_context *context, const duct_canvas *canvas, const char *path,
                             const duct_image_options *options, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    const target *kind = target_of(path);
    if (kind == NULL) {
        return duct_fail(error, DUCT_UNSUPPORTED, "%s: images are written as .png, .tif, .tiff or .exr",
                         path);
    }
    if (duct_file_is_folder(path)) {
        return duct_fail(error, DUCT_IO, "%s: is a folder; give the name of a file", path);
    }
    duct_image_options settled;
    const duct_image_module *module = NULL;
    duct_status status = settle(path, kind, options, &settled, error);
    if (status == DUCT_OK) {
        status = duct_image_module_load(context, &module, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    char *beside = NULL;
    float *row = duct_alloc(allocator, (size_t)duct_canvas_width(canvas) * 4, sizeof *row);
    status = row != NULL ? duct_file_beside(allocator, path, &beside, error) : duct_fail_memory(error);
    if (status == DUCT_OK) {
        status = write_rows(canvas, path, beside, kind, &settled, module, row, error);
        if (status == DUCT_OK) {
            status = duct_file_commit(beside, path, error);
        } else {
            unlink(beside);
        }
    }
    duct_release(allocator, beside);
    duct_release(allocator, row);
    return status;
}
