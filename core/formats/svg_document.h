/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_DOCUMENT_H
#define DUCTUS_FORMATS_SVG_DOCUMENT_H

#include "formats/svg_css.h"
#include "formats/svg_style.h"
#include "geometry/affine.h"
#include "geometry/path.h"

#include <ductus/status.h>

/* A parsed SVG document with what is needed to find out what it draws: style sheets, ids, page. */
struct duct_svg_document {
    const duct_allocator *allocator;
    xmlDoc *xml;
    xmlNode *root;
    duct_css_sheet *sheet;
    struct duct_svg_id *ids; /* sorted */
    size_t id_count;
    double width, height; /* of the page in pixels; 0 x 0 where the document states none */
};

/* Parses the text (UTF-8 or what its XML declaration says). The caller frees the document with
 * duct_svg_document_close(). Errors: DUCT_BAD_FORMAT, DUCT_LIMIT, DUCT_NO_MEMORY. */
duct_status duct_svg_document_open(const duct_allocator *allocator, const char *data, size_t size,
                                   duct_svg_document *document, duct_error *error);
void duct_svg_document_close(duct_svg_document *document);

const duct_css_sheet *duct_svg_document_sheet(const duct_svg_document *document);

/* The element of that id, or NULL. */
const xmlNode *duct_svg_document_find(const duct_svg_document *document, duct_slice id);

/* True for elements of SVG's namespace, and of none: files without any declaration are common. */
bool duct_svg_is_element(const xmlNode *node);

/* The value of href or xlink:href, or NULL. */
const char *duct_svg_reference(const xmlNode *element);

/* The next element in document order, as an XML parser meets them; NULL at the end. */
xmlNode *duct_svg_next_element(xmlNode *element);

/* The elements that draw or hold what draws. */
typedef enum duct_svg_kind {
    DUCT_SVG_G,
    DUCT_SVG_SVG,
    DUCT_SVG_A,
    DUCT_SVG_SWITCH,
    DUCT_SVG_PATH,
    DUCT_SVG_RECT,
    DUCT_SVG_CIRCLE,
    DUCT_SVG_ELLIPSE,
    DUCT_SVG_LINE,
    DUCT_SVG_POLYLINE,
    DUCT_SVG_POLYGON,
    DUCT_SVG_TEXT, /* this and images are visited, but are no strokes */
    DUCT_SVG_IMAGE,
    DUCT_SVG_OTHER /* everything else: not drawn, with all that it holds */
} duct_svg_kind;

/* A shape that is displayed and visible. All pointers are valid during the visit. */
typedef struct duct_svg_shape {
    xmlNode *node;
    duct_svg_kind kind;
    duct_svg_style style;
    duct_svg_viewport viewport;
    duct_affine matrix; /* from the element's coordinates to drawing pixels; invertible */
    const char *name;   /* the id, or "group/path[3]" from the element's position */
    const char *group;  /* labels or ids of the groups around it, joined by '/' */
    bool has_id;
} duct_svg_shape;

/* Called for each shape in document order; anything but DUCT_OK ends the walk and is returned by it. */
typedef duct_status (*duct_svg_visitor)(void *user, const duct_svg_shape *shape, duct_error *error);

duct_status duct_svg_walk(const duct_svg_document *document, duct_svg_visitor visitor, void *user,
                          duct_error *error);

/* The map from the root element's inner coordinates to drawing pixels. */
duct_affine duct_svg_root_map(const duct_svg_document *document);

/* Adds the shape's geometry in its own coordinates. What SVG says is in error or not drawn adds nothing. */
void duct_svg_shape_path(const duct_svg_shape *shape, duct_path *path);

/* True where the attribute holds the geometry of that kind of element, so that it goes when the element
 * becomes a <path>. */
bool duct_svg_is_geometry(duct_svg_kind kind, duct_slice attribute);

#endif
