/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "picture/picture_private.h"

#include "base/error.h"
#include "base/file.h"

#include <math.h>
#include <string.h>
#include <unistd.h>

duct_status duct_picture_new(const duct_context *context, double width, double height, duct_picture **picture,
                             duct_error *error)
{
    if (!(width >= 1 && width <= DUCT_PICTURE_LARGEST && height >= 1 && height <= DUCT_PICTURE_LARGEST)) {
        return duct_fail(error, DUCT_LIMIT,
                         "a picture of %g x %g pixels cannot be made; its sides must lie "
                         "within 1 and %d",
                         width, height, DUCT_PICTURE_LARGEST);
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_picture *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->width = width;
    made->height = height;
    *picture = made;
    return DUCT_OK;
}

void duct_picture_free(duct_picture *picture)
{
    if (picture != NULL) {
        const duct_allocator allocator = picture->allocator;
        duct_release(&allocator, picture->shapes);
        duct_release(&allocator, picture->points);
        duct_release(&allocator, picture->texts);
        duct_release(&allocator, picture);
    }
}

/* Adds a point to those of the shape that is being made. */
static void add_point(duct_picture *picture, double x, double y)
{
    if (picture->failed || !isfinite(x) || !isfinite(y)) {
        return;
    }
    void *points = picture->points;
    if (!duct_reserve(&picture->allocator, &points, &picture->point_capacity, picture->point_count + 1,
                      sizeof *picture->points)) {
        picture->failed = true;
        return;
    }
    picture->points = points;
    picture->points[picture->point_count++] = (duct_picture_point){x, y};
}

/* Makes a shape of the points from `start` on, unless there are less than `least`. */
static void add_shape(duct_picture *picture, duct_shape shape, size_t start, size_t least)
{
    shape.start = start;
    shape.count = picture->point_count - start;
    if (picture->failed || shape.count < least || !isfinite(shape.size) || shape.size <= 0) {
        picture->point_count = start;
        return;
    }
    void *shapes = picture->shapes;
    if (!duct_reserve(&picture->allocator, &shapes, &picture->shape_capacity, picture->shape_count + 1,
                      sizeof *picture->shapes)) {
        picture->failed = true;
        return;
    }
    picture->shapes = shapes;
    picture->shapes[picture->shape_count++] = shape;
}

void duct_picture_polyline(duct_picture *picture, const double *x, const double *y, size_t count,
                           double width, duct_ink ink)
{
    size_t start = picture->point_count;
    for (size_t i = 0; i < count; i++) {
        add_point(picture, x[i], y[i]);
    }
    add_shape(picture, (duct_shape){.kind = DUCT_SHAPE_LINE, .ink = ink, .size = width}, start, 1);
}

void duct_picture_line(duct_picture *picture, double x0, double y0, double x1, double y1, double width,
                       duct_ink ink)
{
    duct_picture_polyline(picture, (double[]){x0, x1}, (double[]){y0, y1}, 2, width, ink);
}

static bool same_ink(duct_ink a, duct_ink b)
{
    return a.red == b.red && a.green == b.green && a.blue == b.blue && a.opacity == b.opacity;
}

void duct_picture_segments(duct_picture *picture, const double *x, const double *y, size_t count,
                           const double *widths, double width, const duct_ink *inks)
{
    for (size_t i = 0; i + 1 < count;) {
        double own = widths != NULL ? widths[i] : width;
        size_t end = i + 1;
        while (end + 1 < count && same_ink(inks[end], inks[i]) && (widths == NULL || widths[end] == own)) {
            end++;
        }
        duct_picture_polyline(picture, x + i, y + i, end - i + 1, own, inks[i]);
        i = end;
    }
}

void duct_picture_polygon(duct_picture *picture, const double *x, const double *y, size_t count, duct_ink ink)
{
    size_t start = picture->point_count;
    for (size_t i = 0; i < count; i++) {
        add_point(picture, x[i], y[i]);
    }
    add_shape(picture, (duct_shape){.kind = DUCT_SHAPE_POLYGON, .ink = ink, .size = 1}, start, 3);
}

void duct_picture_rectangle(duct_picture *picture, double x, double y, double width, double height,
                            duct_ink ink)
{
    duct_picture_polygon(picture, (double[]){x, x + width, x + width, x},
                         (double[]){y, y, y + height, y + height}, 4, ink);
}

void duct_picture_circle(duct_picture *picture, double x, double y, double radius, duct_ink ink)
{
    size_t start = picture->point_count;
    add_point(picture, x, y);
    add_shape(picture, (duct_shape){.kind = DUCT_SHAPE_CIRCLE, .ink = ink, .size = radius}, start, 1);
}

void duct_picture_text(duct_picture *picture, double x, double y, double size, duct_text_anchor anchor,
                       double angle, duct_ink ink, const char *text)
{
    void *texts = picture->texts;
    size_t start = picture->point_count, length = strlen(text) + 1;
    if (picture->failed || !isfinite(angle)) {
        return;
    }
    if (!duct_reserve(&picture->allocator, &texts, &picture->text_capacity, picture->text_size + length, 1)) {
        picture->failed = true;
        return;
    }
    picture->texts = texts;
    memcpy(picture->texts + picture->text_size, text, length);
    add_point(picture, x, y);
    add_shape(picture,
              (duct_shape){.kind = DUCT_SHAPE_TEXT,
                           .ink = ink,
                           .size = size,
                           .text = picture->text_size,
                           .anchor = anchor,
                           .angle = angle},
              start, 1);
    picture->text_size += length;
}

double duct_picture_text_width(double size, const char *text)
{
    size_t letters = 0;
    for (; *text != '\0'; text++) {
        letters += ((unsigned char)*text & 0xc0) != 0x80;
    }
    return 0.57 * size * (double)letters;
}

bool duct_picture_writable(const char *path)
{
    return duct_path_ends(path, "svg") || duct_path_ends(path, "png");
}

static duct_status write_svg(const duct_allocator *allocator, const duct_picture *picture, double scale,
                             const char *path, duct_error *error)
{
    duct_text text;
    duct_text_init(&text, allocator);
    duct_status status = duct_picture_svg(picture, scale, &text, error);
    if (status == DUCT_OK) {
        status = duct_file_write(allocator, path, text.data, text.size, error);
    }
    duct_text_free(&text);
    return status;
}

duct_status duct_picture_write(const duct_context *context, const duct_picture *picture, const char *path,
                               double scale, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    if (!duct_picture_writable(path)) {
        return duct_fail(error, DUCT_UNSUPPORTED, "%s: pictures are written as .svg or .png", path);
    }
    if (!(scale > 0) || !isfinite(scale)) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a picture's scale must be a positive number");
    }
    if (picture->failed) {
        return duct_fail_memory(error);
    }
    if (duct_file_is_folder(path)) {
        return duct_fail(error, DUCT_IO, "%s: is a folder; give the name of a file", path);
    }
    if (duct_path_ends(path, "svg")) {
        return write_svg(allocator, picture, scale, path, error);
    }
    char *beside;
    duct_status status = duct_file_beside(allocator, path, &beside, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = duct_picture_png(context, picture, scale, beside, path, error);
    if (status == DUCT_OK) {
        status = duct_file_commit(beside, path, error);
    } else {
        unlink(beside);
    }
    duct_release(allocator, beside);
    return status;
}
