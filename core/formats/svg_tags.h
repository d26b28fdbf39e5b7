/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_TAGS_H
#define DUCTUS_FORMATS_SVG_TAGS_H

#include "base/text.h"
#include "formats/svg_scan.h"

#include <ductus/status.h>
#include <libxml/tree.h>

/* Where an element stands in the bytes of its file. */
typedef struct duct_svg_tag {
    size_t begin;       /* of '<' */
    size_t name_end;    /* behind the name */
    size_t end;         /* behind the start tag's '>' */
    size_t close_begin; /* of the end tag; `end` where there is none because of "/>" */
    size_t close_end;   /* behind the element */
    bool empty;         /* "/>" */
} duct_svg_tag;

/* The elements of a file that an XML parser has found to be well-formed, in document order, with texts in an
 * encoding that agrees with ASCII. The caller releases the array. False, with nothing to release, where the
 * scan finds what it does not understand (`*failed`: where there is no memory). */
bool duct_svg_tags_scan(const duct_allocator *allocator, const char *data, size_t size, duct_svg_tag **tags,
                        size_t *count, bool *failed);

/* True where the tags are those of the tree, name by name; then each element's _private holds its tag. */
bool duct_svg_tags_match(const char *data, duct_svg_tag *tags, size_t count, xmlNode *root);

/* The next attribute of a start tag as it is written: `begin` is behind the name or the attribute before and
 * is moved on; `whole` runs from the white space before the attribute to its closing quote. False at the
 * tag's end. */
bool duct_svg_tag_attribute(const char *data, const duct_svg_tag *tag, size_t *begin, duct_slice *whole,
                            duct_slice *name);

#endif
