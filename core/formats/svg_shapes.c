/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_document.h"

#include "formats/svg_path.h"
#include "geometry/bezier.h"

#include <math.h>

/* A length attribute; false, and `*length` 0, where it is absent or malformed. */
static bool length_of(const duct_svg_shape *shape, const char *name, duct_svg_axis axis, double *length)
{
    *length = 0;
    return duct_svg_length(duct_slice_of(duct_svg_attribute(shape->node, name)), axis, &shape->viewport,
                           length);
}

static void add_rect(const duct_svg_shape *shape, duct_path *path)
{
    double x, y, width, height, rx, ry;
    length_of(shape, "x", DUCT_SVG_HORIZONTAL, &x);
    length_of(shape, "y", DUCT_SVG_VERTICAL, &y);
    length_of(shape, "width", DUCT_SVG_HORIZONTAL, &width);
    length_of(shape, "height", DUCT_SVG_VERTICAL, &height);
    if (!(width > 0) || !(height > 0)) {
        return;
    }
    bool has_rx = length_of(shape, "rx", DUCT_SVG_HORIZONTAL, &rx) && rx >= 0;
    bool has_ry = length_of(shape, "ry", DUCT_SVG_VERTICAL, &ry) && ry >= 0;
    rx = fmin(has_rx ? rx : has_ry ? ry : 0, width / 2);
    ry = fmin(has_ry ? ry : rx, height / 2);
    double right = x + width, bottom = y + height;
    if (!(rx > 0) || !(ry > 0)) {
        rx = ry = 0;
    }
    duct_path_move(path, x + rx, y);
    duct_path_line(path, right - rx, y);
    duct_path_arc(path, right - rx, y, rx, ry, 0, false, true, right, y + ry);
    duct_path_line(path, right, bottom - ry);
    duct_path_arc(path, right, bottom - ry, rx, ry, 0, false, true, right - rx, bottom);
    duct_path_line(path, x + rx, bottom);
    duct_path_arc(path, x + rx, bottom, rx, ry, 0, false, true, x, bottom - ry);
    if (rx > 0) {
        duct_path_line(path, x, y + ry);
        duct_path_arc(path, x, y + ry, rx, ry, 0, false, true, x + rx, y);
    }
    duct_path_close(path);
}

/* From the rightmost point, clockwise, as SVG 1.1 has it in sections 9.3 and 9.4 of its second edition. */
static void add_ellipse(const duct_svg_shape *shape, duct_path *path)
{
    double x, y, rx, ry;
    length_of(shape, "cx", DUCT_SVG_HORIZONTAL, &x);
    length_of(shape, "cy", DUCT_SVG_VERTICAL, &y);
    if (shape->kind == DUCT_SVG_CIRCLE) {
        length_of(shape, "r", DUCT_SVG_DIAGONAL, &rx);
        ry = rx;
    } else {
        bool has_rx = length_of(shape, "rx", DUCT_SVG_HORIZONTAL, &rx);
        bool has_ry = length_of(shape, "ry", DUCT_SVG_VERTICAL, &ry);
        rx = has_rx ? rx : ry;
        ry = has_ry ? ry : rx;
    }
    if (!(rx > 0) || !(ry > 0)) {
        return;
    }
    duct_path_move(path, x + rx, y);
    duct_path_arc(path, x + rx, y, rx, ry, 0, false, true, x, y + ry);
    duct_path_arc(path, x, y + ry, rx, ry, 0, false, true, x - rx, y);
    duct_path_arc(path, x - rx, y, rx, ry, 0, false, true, x, y - ry);
    duct_path_arc(path, x, y - ry, rx, ry, 0, false, true, x + rx, y);
    duct_path_close(path);
}

static void add_line(const duct_svg_shape *shape, duct_path *path)
{
    double x1, y1, x2, y2;
    length_of(shape, "x1", DUCT_SVG_HORIZONTAL, &x1);
    length_of(shape, "y1", DUCT_SVG_VERTICAL, &y1);
    length_of(shape, "x2", DUCT_SVG_HORIZONTAL, &x2);
    length_of(shape, "y2", DUCT_SVG_VERTICAL, &y2);
    duct_path_move(path, x1, y1);
    duct_path_line(path, x2, y2);
}

void duct_svg_shape_path(const duct_svg_shape *shape, duct_path *path)
{
    const char *text;
    switch (shape->kind) {
    case DUCT_SVG_PATH:
        text = duct_svg_attribute(shape->node, "d");
        if (text != NULL) {
            duct_svg_path_data(text, path);
        }
        break;
    case DUCT_SVG_POLYLINE:
    case DUCT_SVG_POLYGON:
        text = duct_svg_attribute(shape->node, "points");
        if (text != NULL) {
            duct_svg_points(text, shape->kind == DUCT_SVG_POLYGON, path);
        }
        break;
    case DUCT_SVG_RECT:
        add_rect(shape, path);
        break;
    case DUCT_SVG_CIRCLE:
    case DUCT_SVG_ELLIPSE:
        add_ellipse(shape, path);
        break;
    case DUCT_SVG_LINE:
        add_line(shape, path);
        break;
    case DUCT_SVG_G:
    case DUCT_SVG_SVG:
    case DUCT_SVG_A:
    case DUCT_SVG_SWITCH:
    case DUCT_SVG_TEXT:
    case DUCT_SVG_IMAGE:
    case DUCT_SVG_OTHER:
        break;
    }
}

bool duct_svg_is_geometry(duct_svg_kind kind, duct_slice attribute)
{
    static const char *const lists[DUCT_SVG_OTHER] = {
        [DUCT_SVG_PATH] = "d pathlength",           [DUCT_SVG_RECT] = "x y width height rx ry pathlength",
        [DUCT_SVG_CIRCLE] = "cx cy r pathlength",   [DUCT_SVG_ELLIPSE] = "cx cy rx ry pathlength",
        [DUCT_SVG_LINE] = "x1 y1 x2 y2 pathlength", [DUCT_SVG_POLYLINE] = "points pathlength",
        [DUCT_SVG_POLYGON] = "points pathlength"};
    duct_slice rest = duct_slice_of(lists[kind]), word;
    while (rest.size > 0 && duct_slice_word(&rest, &word)) {
        char name[16] = {0};
        for (size_t i = 0; i < word.size && i + 1 < sizeof name; i++) {
            name[i] = word.text[i];
        }
        if (duct_slice_is(attribute, name)) {
            return true;
        }
    }
    return false;
}
