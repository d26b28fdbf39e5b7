/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_ELEMENT_H
#define DUCTUS_FORMATS_SVG_ELEMENT_H

#include "formats/svg_private.h"
#include "formats/svg_tags.h"

/* CSS declarations that an element gets into its style attribute, where they win against sheets and
 * attributes. */
typedef struct duct_svg_overrides {
    duct_text css;   /* "stroke:none;fill:#000000" */
    bool whole_line; /* markers and dashes go as well: they belong to the line that was there */
    bool important;  /* the sheets have !important rules, so these need it too */
} duct_svg_overrides;

void duct_svg_overrides_init(duct_svg_overrides *overrides, const duct_svg_document *document,
                             const duct_allocator *allocator);
void duct_svg_override(duct_svg_overrides *overrides, const char *property, const char *value);

/* Where a stroke's style was changed since it was read: its colour, opacity and width as the element's
 * stroke. */
void duct_svg_override_changed(duct_svg_overrides *overrides, const duct_svg_shape *shape, bool fills,
                               duct_stroke_style style);

/* No stroke, and the fill painted as the stroke was. */
void duct_svg_override_outline(duct_svg_overrides *overrides, const duct_svg_shape *shape,
                               duct_stroke_style style);

/* No stroke; the fill as it was. */
void duct_svg_override_fill_only(duct_svg_overrides *overrides);

/* Adds the shape's start tag as that of a <path> with this `d`: its other attributes stay as they are written
 * in `data`, but for those that would make a program compute `d` anew. A copy (`id_suffix` not NULL) gets
 * another id, and is closed at once. */
void duct_svg_add_start_tag(duct_svg_ids *ids, const char *data, const duct_svg_shape *shape, const char *d,
                            const duct_svg_overrides *overrides, const char *id_suffix, duct_text *out);

#endif
