/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_CSS_H
#define DUCTUS_FORMATS_SVG_CSS_H

#include "base/text.h"
#include "formats/svg_scan.h"

#include <ductus/status.h>
#include <libxml/tree.h>
#include <stdint.h>

/* The properties that decide what is drawn. */
typedef enum duct_svg_property {
    DUCT_SVG_COLOR,
    DUCT_SVG_DISPLAY,
    DUCT_SVG_FILL,
    DUCT_SVG_FILL_OPACITY,
    DUCT_SVG_FONT_SIZE,
    DUCT_SVG_OPACITY,
    DUCT_SVG_STOP_COLOR,
    DUCT_SVG_STROKE,
    DUCT_SVG_STROKE_OPACITY,
    DUCT_SVG_STROKE_WIDTH,
    DUCT_SVG_TRANSFORM,
    DUCT_SVG_VECTOR_EFFECT,
    DUCT_SVG_VISIBILITY,
    DUCT_SVG_PROPERTY_COUNT
} duct_svg_property;

/* The property of that name; DUCT_SVG_PROPERTY_COUNT where it is none of them. */
duct_svg_property duct_svg_property_of(duct_slice name);
const char *duct_svg_property_name(duct_svg_property property);

/* One "name: value" of a style text, cut off its front. */
typedef struct duct_css_declaration {
    duct_slice name, value;
    bool important;
} duct_css_declaration;
/* False at the text's end. Malformed declarations are left out, as CSS says. */
bool duct_css_next(duct_slice *rest, duct_css_declaration *declaration);

/* The document's <style> elements: rules with type, universal, class and id selectors and descendant and
 * child combinators. Selectors with anything else never match; of the at-rules, @media for all or screen is
 * read. */
typedef struct duct_css_sheet duct_css_sheet;

/* Adds the text of one more <style> element. Errors: DUCT_NO_MEMORY, DUCT_LIMIT (more than 20000 selectors).
 */
duct_status duct_css_sheet_new(const duct_allocator *allocator, duct_css_sheet **sheet, duct_error *error);
duct_status duct_css_sheet_add(duct_css_sheet *sheet, const char *text, duct_error *error);
void duct_css_sheet_free(duct_css_sheet *sheet); /* NULL is allowed */

/* True where some rule says !important: it would win against a plain style attribute. */
bool duct_css_sheet_important(const duct_css_sheet *sheet);

/* The winning value of each property for one element, by the cascade of CSS 2, section 6.4: presentation
 * attributes, then rules by specificity and order, then the style attribute; !important ones after all
 * others. The slices point into the sheet and the document. */
typedef struct duct_css_values {
    duct_slice value[DUCT_SVG_PROPERTY_COUNT];
    uint64_t weight[DUCT_SVG_PROPERTY_COUNT];
} duct_css_values;
void duct_css_resolve(const duct_css_sheet *sheet, const xmlNode *element, duct_css_values *values);

/* The value of an element's attribute without namespace, or NULL. Owned by the document, whose attributes
 * must have been made plain with duct_svg_document_open(). */
const char *duct_svg_attribute(const xmlNode *element, const char *name);

#endif
