/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DIAGRAM_PANEL_H
#define DUCTUS_DIAGRAM_PANEL_H

#include "diagram/segments.h"
#include "diagram/shown.h"
#include "picture/picture.h"

/* A part of the picture, pixels. */
typedef struct duct_cell {
    double x, y, width, height;
} duct_cell;

/* Where a drawing lies in the picture: picture = offset + scale * drawing. */
typedef struct duct_placing {
    double scale, x, y;
} duct_placing;

/* Greys for what is not the subject. */
extern const duct_ink duct_ink_text, duct_ink_quiet, duct_ink_missing;

/* Fits a box of the drawing into a cell, centred. A box without size becomes a point. */
duct_placing duct_placing_fit(const double box[4], const duct_cell *cell);

/* Draws a panel's strokes and the marks of pose along them. `low` and `high` are the palette's ends. Errors:
 * DUCT_NO_MEMORY. */
duct_status duct_panel_draw(const duct_allocator *allocator, duct_picture *picture,
                            const duct_diagram_panel *panel, const duct_shown *shown,
                            const duct_diagram_options *options, const duct_placing *placing, double low,
                            double high, duct_error *error);

/* Draws the library strokes whose parts the panel's segments are, each part in its segment's colour, in a
 * grid. Errors: DUCT_NO_MEMORY. */
duct_status duct_beside_draw(const duct_context *context, duct_picture *picture,
                             const duct_diagram_panel *panel, const duct_diagram_options *options,
                             const duct_cell *cell, duct_error *error);

/* The number of the first segment of each traced stroke, so that a segment's colour is that of its number. */
size_t duct_segment_number(const duct_segments *segments, const duct_segmented *stroke, size_t segment);

#endif
