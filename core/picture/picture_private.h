/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_PICTURE_PRIVATE_H
#define DUCTUS_PICTURE_PRIVATE_H

#include "picture/picture.h"

typedef enum duct_shape_kind {
    DUCT_SHAPE_LINE,    /* through points */
    DUCT_SHAPE_POLYGON, /* around points, filled */
    DUCT_SHAPE_CIRCLE,  /* filled; one point, `size` is the radius */
    DUCT_SHAPE_TEXT     /* one point, `size` is the font's */
} duct_shape_kind;

typedef struct duct_shape {
    duct_shape_kind kind;
    duct_ink ink;
    double size;         /* line width, radius, font size */
    size_t start, count; /* points */
    size_t text;         /* where its text begins */
    duct_text_anchor anchor;
    double angle;
} duct_shape;

typedef struct duct_picture_point {
    double x, y;
} duct_picture_point;

struct duct_picture {
    duct_allocator allocator;
    double width, height;
    duct_shape *shapes;
    size_t shape_count, shape_capacity;
    duct_picture_point *points;
    size_t point_count, point_capacity;
    char *texts; /* each terminated */
    size_t text_size, text_capacity;
    bool failed; /* an allocation did */
};

/* The sides of a picture and of its PNG: what cairo's images can have. */
enum { DUCT_PICTURE_LARGEST = 32767 };

/* Writes a PNG file at `path`, which exists already. `shown` is its name in sentences. */
duct_status duct_picture_png(const duct_context *context, const duct_picture *picture, double scale,
                             const char *path, const char *shown, duct_error *error);

#endif
