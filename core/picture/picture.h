/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_PICTURE_H
#define DUCTUS_PICTURE_H

#include "base/text.h"

#include <ductus/context.h>
#include <ductus/status.h>

/* Small vector pictures, for charts and diagrams: shapes one over the other, written as SVG by ourselves or
 * as PNG through cairo, which is loaded only then. Lengths are pixels of an unscaled picture, x to the right,
 * y down.
 *
 * Drawing calls return nothing: one that cannot get memory makes the picture fail when it is written. Points
 * that are not finite are left out. */
typedef struct duct_picture duct_picture;

/* Red, green, blue, opacity: 0..1, sRGB-encoded, not premultiplied. */
typedef struct duct_ink {
    float red, green, blue, opacity;
} duct_ink;

typedef enum duct_text_anchor { DUCT_TEXT_START, DUCT_TEXT_MIDDLE, DUCT_TEXT_END } duct_text_anchor;

/* An empty, transparent picture; draw a rectangle for a background. The caller frees it. Errors: DUCT_LIMIT
 * (a side that is not within 1..32767), DUCT_NO_MEMORY. */
duct_status duct_picture_new(const duct_context *context, double width, double height, duct_picture **picture,
                             duct_error *error);
void duct_picture_free(duct_picture *picture); /* NULL is allowed */

void duct_picture_line(duct_picture *picture, double x0, double y0, double x1, double y1, double width,
                       duct_ink ink);

/* A filled rectangle. */
void duct_picture_rectangle(duct_picture *picture, double x, double y, double width, double height,
                            duct_ink ink);

/* A filled polygon, by the nonzero rule. */
void duct_picture_polygon(duct_picture *picture, const double *x, const double *y, size_t count,
                          duct_ink ink);

void duct_picture_circle(duct_picture *picture, double x, double y, double radius, duct_ink ink);

/* A line through `count` points with round joins and ends. A single point gives a dot. */
void duct_picture_polyline(duct_picture *picture, const double *x, const double *y, size_t count,
                           double width, duct_ink ink);

/* The same with a width and a colour of its own for each of the `count` - 1 segments; `widths` NULL: all of
 * `width`. Neighbours that are alike become one line, so quantize colours where files should be small. */
void duct_picture_segments(duct_picture *picture, const double *x, const double *y, size_t count,
                           const double *widths, double width, const duct_ink *inks);

/* Sans-serif text whose baseline begins (or has its middle or end) at (x, y), turned clockwise by `angle`
 * radians about that point. `size` is the font's size in pixels. */
void duct_picture_text(duct_picture *picture, double x, double y, double size, duct_text_anchor anchor,
                       double angle, duct_ink ink, const char *text);

/* About how wide the text will be, for laying out: fonts differ. */
double duct_picture_text_width(double size, const char *text);

/* True where the path's ending is one that duct_picture_write() writes: svg, png. */
bool duct_picture_writable(const char *path);

/* Writes the picture by the path's ending, `scale` times as large. The file appears whole or not at all.
 * Errors: DUCT_UNSUPPORTED (another ending, or the picture module is not installed), DUCT_LIMIT (a PNG with a
 * side above 32767 pixels), DUCT_IO, DUCT_NO_MEMORY. */
duct_status duct_picture_write(const duct_context *context, const duct_picture *picture, const char *path,
                               double scale, duct_error *error);

/* Adds the picture as an SVG document. The same picture gives the same bytes. Errors: DUCT_NO_MEMORY. */
duct_status duct_picture_svg(const duct_picture *picture, double scale, duct_text *out, duct_error *error);

#endif
