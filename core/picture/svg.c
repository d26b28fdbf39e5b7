/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures as SVG text. */
#include "picture/picture_private.h"

#include "base/error.h"

#include <math.h>

static void add_number(duct_text *out, const char *before, double value)
{
    duct_text_add(out, before);
    duct_text_add_fixed(out, value, 2);
}

static unsigned part(float value)
{
    return (unsigned)(fminf(fmaxf(value, 0), 1) * 255 + 0.5f);
}

static void add_ink(duct_text *out, const char *attribute, duct_ink ink)
{
    duct_text_addf(out, " %s=\"#%02x%02x%02x\"", attribute, part(ink.red), part(ink.green), part(ink.blue));
    if (ink.opacity < 1) {
        duct_text_addf(out, " %s-opacity=\"", attribute);
        duct_text_add_fixed(out, (double)fmaxf(ink.opacity, 0), 3);
        duct_text_add(out, "\"");
    }
}

static void add_points(duct_text *out, const duct_picture *picture, const duct_shape *shape)
{
    duct_text_add(out, " points=\"");
    for (size_t i = 0; i < shape->count; i++) {
        const duct_picture_point *point = &picture->points[shape->start + i];
        add_number(out, i > 0 ? " " : "", point->x);
        add_number(out, ",", point->y);
    }
    /* A lone point twice: a line of no length that has caps is a dot. */
    if (shape->kind == DUCT_SHAPE_LINE && shape->count == 1) {
        add_number(out, " ", picture->points[shape->start].x);
        add_number(out, ",", picture->points[shape->start].y);
    }
    duct_text_add(out, "\"");
}

static void add_text(duct_text *out, const duct_picture *picture, const duct_shape *shape)
{
    static const char *const anchors[] = {"start", "middle", "end"};
    const duct_picture_point *at = &picture->points[shape->start];
    add_number(out, "<text x=\"", at->x);
    add_number(out, "\" y=\"", at->y);
    add_number(out, "\" font-size=\"", shape->size);
    duct_text_add(out, "\"");
    if (shape->anchor != DUCT_TEXT_START) {
        duct_text_addf(out, " text-anchor=\"%s\"", anchors[shape->anchor]);
    }
    if (shape->angle != 0) {
        add_number(out, " transform=\"rotate(", shape->angle * 180 / acos(-1));
        add_number(out, " ", at->x);
        add_number(out, " ", at->y);
        duct_text_add(out, ")\"");
    }
    add_ink(out, "fill", shape->ink);
    duct_text_add(out, ">");
    duct_text_add_xml(out, picture->texts + shape->text);
    duct_text_add(out, "</text>\n");
}

static void add_shape(duct_text *out, const duct_picture *picture, const duct_shape *shape)
{
    switch (shape->kind) {
    case DUCT_SHAPE_LINE:
        duct_text_add(out, "<polyline fill=\"none\"");
        add_points(out, picture, shape);
        add_ink(out, "stroke", shape->ink);
        add_number(out, " stroke-width=\"", shape->size);
        duct_text_add(out, "\"/>\n");
        break;
    case DUCT_SHAPE_POLYGON:
        duct_text_add(out, "<polygon");
        add_points(out, picture, shape);
        add_ink(out, "fill", shape->ink);
        duct_text_add(out, "/>\n");
        break;
    case DUCT_SHAPE_CIRCLE:
        add_number(out, "<circle cx=\"", picture->points[shape->start].x);
        add_number(out, "\" cy=\"", picture->points[shape->start].y);
        add_number(out, "\" r=\"", shape->size);
        duct_text_add(out, "\"");
        add_ink(out, "fill", shape->ink);
        duct_text_add(out, "/>\n");
        break;
    case DUCT_SHAPE_TEXT:
        add_text(out, picture, shape);
        break;
    }
}

duct_status duct_picture_svg(const duct_picture *picture, double scale, duct_text *out, duct_error *error)
{
    duct_text_add(out,
                  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"");
    add_number(out, " width=\"", picture->width * scale);
    add_number(out, "\" height=\"", picture->height * scale);
    add_number(out, "\" viewBox=\"0 0 ", picture->width);
    add_number(out, " ", picture->height);
    duct_text_add(out, "\" font-family=\"sans-serif\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n");
    for (size_t i = 0; i < picture->shape_count; i++) {
        add_shape(out, picture, &picture->shapes[i]);
    }
    duct_text_add(out, "</svg>\n");
    return out->failed || picture->failed ? duct_fail_memory(error) : DUCT_OK;
}
