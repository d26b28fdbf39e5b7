/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_PRIVATE_H
#define DUCTUS_FORMATS_SVG_PRIVATE_H

#include "drawing/drawing_private.h"
#include "formats/format_private.h"
#include "formats/svg_document.h"
#include "formats/svg_ids.h"
#include "geometry/bezier.h"

/* How the parts of the SVG format fit together:
 *
 * Reading walks the document (svg_walk.c) and makes a stroke of each subpath of each stroked shape; a
 * stroke's part is the number of its subpath in the order of the walk. The drawing keeps the file's bytes as
 * its origin.
 *
 * Writing parses the same bytes again and walks them in the same way, so that each part is met again beside
 * its element. Changed elements are spliced into the file's bytes (svg_tags.c finds their tags), so
 * everything else stays byte for byte what it was. */
typedef struct duct_svg_origin {
    duct_origin base;
    duct_allocator allocator;
    char *data; /* the file's bytes, terminated by a 0 byte */
    size_t size;
    bool fills;          /* nothing was stroked, so the strokes are the outlines of what is filled */
    size_t stroke_count; /* as read */
    size_t part_count;   /* subpaths met */
} duct_svg_origin;

duct_status duct_svg_read(const duct_context *context, const char *data, size_t size,
                          const duct_format_options *options, duct_drawing *drawing, duct_error *error);
duct_status duct_svg_write(const duct_context *context, const duct_drawing *drawing,
                           const duct_format_options *options, duct_text *out, duct_error *error);

/* True where the shape's subpaths are parts: it is stroked, or filled where `fills`. */
bool duct_svg_takes(const duct_svg_shape *shape, bool fills);

/* The shape's path in drawing pixels. Errors: DUCT_NO_MEMORY; the caller frees the path in any case. */
duct_status duct_svg_drawing_path(const duct_svg_shape *shape, duct_path *path, duct_error *error);

/* True where the subpath becomes a stroke: it draws something, and its coordinates are finite and within 1e9
 * pixels, where no page reaches. */
bool duct_svg_drawable(const duct_path *path, const duct_subpath *subpath);

/* The digits behind the point that keep coordinates within 0.001 pixels; `scale` is the largest factor from
 * them to pixels. */
int duct_svg_decimals(double scale);

/* The nib by which outlines are drawn. */
duct_nib_options duct_svg_nib(const duct_format_options *options);

/* True where the stroke is shown as a filled outline. */
bool duct_svg_shows_outline(const duct_stroke *stroke, const duct_format_options *options);

/* "#rrggbb" */
void duct_svg_add_color(duct_text *text, double red, double green, double blue);

/* A new SVG document (svg_fresh.c). */
duct_status duct_svg_write_fresh(const duct_drawing *drawing, const duct_format_options *options,
                                 duct_text *out, duct_error *error);

/* New elements for strokes that no element stands for. */
typedef struct duct_svg_new_strokes {
    const duct_drawing *drawing;
    const size_t *indices; /* of the strokes, in order */
    size_t count;
    const duct_format_options *options;
    duct_affine inverse; /* from drawing pixels to the coordinates around the new elements */
    const char *prefix;  /* "" or "svg:" */
    duct_svg_ids *ids;   /* that are taken */
} duct_svg_new_strokes;
duct_status duct_svg_write_strokes(const duct_svg_new_strokes *strokes, duct_text *out, duct_error *error);

#endif
