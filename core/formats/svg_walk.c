/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_document.h"

#include "base/error.h"
#include "formats/svg_transform.h"

#include <ductus/drawing.h>
#include <string.h>

/* An element that is being walked through: what its children inherit, and where the walk is among them. */
typedef struct {
    const xmlNode *node;
    xmlNode *next;
    duct_svg_style style;
    duct_svg_viewport viewport;
    duct_affine matrix;
    size_t counts[DUCT_SVG_OTHER]; /* children of each kind so far */
    size_t group_size;             /* of the group text outside of this element */
    size_t name_begin;             /* of this element's name in the name text */
    bool one_child;                /* a <switch>: only the first child that suits is drawn */
} frame;

typedef struct {
    const duct_svg_document *document;
    duct_svg_visitor visitor;
    void *user;
    frame *frames; /* a stack of ours rather than the machine's */
    size_t depth, capacity;
    duct_text group, names;
} walker;

static const char *const kind_names[DUCT_SVG_OTHER] = {"g",       "svg",    "a",       "switch", "path",
                                                       "rect",    "circle", "ellipse", "line",   "polyline",
                                                       "polygon", "text",   "image"};

static duct_svg_kind kind_of(const xmlNode *node)
{
    int kind = duct_svg_is_element(node) ? 0 : DUCT_SVG_OTHER;
    while (kind < DUCT_SVG_OTHER && strcmp(kind_names[kind], (const char *)node->name) != 0) {
        kind++;
    }
    return (duct_svg_kind)kind;
}

static void cut(duct_text *text, size_t size)
{
    if (text->data != NULL && size < text->size) {
        text->size = size;
        text->data[size] = '\0';
    }
}

static const char *data_of(const duct_text *text)
{
    return text->data != NULL ? text->data : "";
}

static const char *label_of(const xmlNode *node)
{
    for (const xmlAttr *attribute = node->properties; attribute != NULL; attribute = attribute->next) {
        if (attribute->ns != NULL && strcmp((const char *)attribute->name, "label") == 0 &&
            strcmp((const char *)attribute->ns->href, "http://www.inkscape.org/namespaces/inkscape") == 0 &&
            attribute->children != NULL) {
            return (const char *)attribute->children->content;
        }
    }
    return duct_svg_attribute(node, "id");
}

/* Puts the element's name behind the names of the elements around it: its id, or its place in the parent. */
static void add_name(walker *w, const xmlNode *node, duct_svg_kind kind)
{
    const char *id = duct_svg_attribute(node, "id");
    if (id != NULL && *id != '\0') {
        duct_text_add(&w->names, id);
        return;
    }
    const frame *parent = w->depth > 0 ? &w->frames[w->depth - 1] : NULL;
    if (parent == NULL) {
        return;
    }
    size_t begin = parent->name_begin, size = w->names.size - begin;
    if (size > 0 && !w->names.failed) {
        /* The buffer may move while it grows, so it cannot be copied from straight away. */
        char *prefix = duct_strdup(w->names.allocator, w->names.data + begin);
        w->names.failed = w->names.failed || prefix == NULL;
        duct_text_add(&w->names, prefix != NULL ? prefix : "");
        duct_text_add(&w->names, "/");
        duct_release(w->names.allocator, prefix);
    }
    duct_text_addf(&w->names, "%s[%zu]", kind_names[kind], parent->counts[kind]);
}

/* The map that an inner <svg> element puts between its content and its parent, and its own viewport. */
static duct_affine viewport_map(const xmlNode *node, duct_svg_viewport *viewport)
{
    double x = 0, y = 0, width = viewport->width, height = viewport->height, box[4];
    duct_svg_length(duct_slice_of(duct_svg_attribute(node, "x")), DUCT_SVG_HORIZONTAL, viewport, &x);
    duct_svg_length(duct_slice_of(duct_svg_attribute(node, "y")), DUCT_SVG_VERTICAL, viewport, &y);
    duct_svg_length(duct_slice_of(duct_svg_attribute(node, "width")), DUCT_SVG_HORIZONTAL, viewport, &width);
    duct_svg_length(duct_slice_of(duct_svg_attribute(node, "height")), DUCT_SVG_VERTICAL, viewport, &height);
    duct_affine map = {1, 0, 0, 1, x, y};
    viewport->width = width;
    viewport->height = height;
    if (duct_svg_viewbox(duct_svg_attribute(node, "viewBox"), box)) {
        map = duct_affine_multiply(
            map, duct_svg_viewbox_map(box, duct_svg_attribute(node, "preserveAspectRatio"), width, height));
        viewport->width = box[2];
        viewport->height = box[3];
    }
    return map;
}

/* What stands on the page around the root element. */
static frame outermost(const duct_svg_document *document)
{
    frame outer = {.style = duct_svg_style_initial(), .matrix = duct_affine_identity()};
    bool has_page = document->width > 0;
    outer.viewport.width = has_page ? document->width : 300; /* CSS 2, section 10.3.2 */
    outer.viewport.height = has_page ? document->height : 150;
    return outer;
}

/* The element's style, matrix and viewport inside of `parent`. */
static frame enter(const walker *w, const frame *parent, xmlNode *node, duct_svg_kind kind)
{
    frame made = {.node = node, .next = node->children, .one_child = kind == DUCT_SVG_SWITCH};
    duct_css_values values;
    duct_affine transform;
    duct_css_resolve(w->document->sheet, node, &values);
    made.viewport = parent->viewport;
    made.style = duct_svg_style_compute(w->document, &parent->style, &values, &parent->viewport);
    made.viewport.font_size = made.style.font_size;
    made.matrix = parent->matrix;
    if (duct_svg_transform(values.value[DUCT_SVG_TRANSFORM], &transform)) {
        made.matrix = duct_affine_multiply(made.matrix, transform);
    }
    if (node == w->document->root) {
        double box[4];
        made.matrix = duct_affine_multiply(made.matrix, duct_svg_root_map(w->document));
        if (duct_svg_viewbox(duct_svg_attribute(node, "viewBox"), box)) {
            made.viewport.width = box[2];
            made.viewport.height = box[3];
        }
    } else if (kind == DUCT_SVG_SVG) {
        made.matrix = duct_affine_multiply(made.matrix, viewport_map(node, &made.viewport));
    }
    return made;
}

static duct_status push(walker *w, const frame *made, duct_svg_kind kind, duct_error *error)
{
    if (w->depth >= DUCT_MAX_GROUP_DEPTH) {
        return duct_fail(error, DUCT_LIMIT, "line %ld: groups are nested more than %d deep",
                         xmlGetLineNo(made->node), DUCT_MAX_GROUP_DEPTH);
    }
    void *frames = w->frames;
    if (!duct_reserve(w->document->allocator, &frames, &w->capacity, w->depth + 1, sizeof(frame))) {
        return duct_fail_memory(error);
    }
    w->frames = frames;
    size_t name_begin = w->names.size;
    add_name(w, made->node, kind);
    frame *top = &w->frames[w->depth++];
    *top = *made;
    top->group_size = w->group.size;
    top->name_begin = name_begin;
    const char *label = made->node != w->document->root ? label_of(made->node) : NULL;
    if (label != NULL && *label != '\0') {
        duct_text_add(&w->group, w->group.size > 0 ? "/" : "");
        for (const char *s = label; *s != '\0'; s++) {
            duct_text_add_bytes(&w->group, *s == '/' ? "_" : s, 1);
        }
    }
    return DUCT_OK;
}

static void pop(walker *w)
{
    const frame *top = &w->frames[--w->depth];
    cut(&w->group, top->group_size);
    cut(&w->names, top->name_begin);
}

static duct_status visit(walker *w, const frame *made, xmlNode *node, duct_svg_kind kind, duct_error *error)
{
    duct_affine inverse;
    if (!made->style.visible || !duct_affine_invert(made->matrix, &inverse)) {
        return DUCT_OK;
    }
    size_t begin = w->names.size;
    add_name(w, node, kind);
    if (w->names.failed || w->group.failed) {
        return duct_fail_memory(error);
    }
    const char *id = duct_svg_attribute(node, "id");
    duct_svg_shape shape = {.node = node,
                            .kind = kind,
                            .style = made->style,
                            .viewport = made->viewport,
                            .matrix = made->matrix,
                            .name = data_of(&w->names) + begin,
                            .group = data_of(&w->group),
                            .has_id = id != NULL && *id != '\0'};
    duct_status status = w->visitor(w->user, &shape, error);
    cut(&w->names, begin);
    return status;
}

/* Whether a child of <switch> suits: no extension is known, and the language is taken as English. */
static bool suits(const xmlNode *node)
{
    const char *language = duct_svg_attribute(node, "systemLanguage");
    return duct_svg_attribute(node, "requiredExtensions") == NULL &&
           (language == NULL || strncmp(language, "en", 2) == 0);
}

static duct_status step(walker *w, duct_error *error)
{
    frame *top = &w->frames[w->depth - 1];
    xmlNode *node = top->next;
    if (node == NULL) {
        pop(w);
        return DUCT_OK;
    }
    top->next = node->next;
    if (node->type != XML_ELEMENT_NODE) {
        return DUCT_OK;
    }
    duct_svg_kind kind = kind_of(node);
    if (kind != DUCT_SVG_OTHER) {
        top->counts[kind]++;
    }
    if (top->one_child) {
        if (!suits(node)) {
            return DUCT_OK;
        }
        top->next = NULL;
    }
    if (kind == DUCT_SVG_OTHER) {
        return DUCT_OK;
    }
    frame made = enter(w, top, node, kind);
    if (!made.style.displayed) {
        return DUCT_OK;
    }
    return kind < DUCT_SVG_PATH ? push(w, &made, kind, error) : visit(w, &made, node, kind, error);
}

duct_status duct_svg_walk(const duct_svg_document *document, duct_svg_visitor visitor, void *user,
                          duct_error *error)
{
    walker w = {.document = document, .visitor = visitor, .user = user};
    duct_text_init(&w.group, document->allocator);
    duct_text_init(&w.names, document->allocator);
    frame outer = outermost(document);
    frame root = enter(&w, &outer, document->root, DUCT_SVG_SVG);
    duct_status status = DUCT_OK;
    if (root.style.displayed) {
        status = push(&w, &root, DUCT_SVG_SVG, error);
        if (status == DUCT_OK) {
            cut(&w.names, 0); /* names of elements without id do not tell the root's */
        }
    }
    while (status == DUCT_OK && w.depth > 0) {
        status = step(&w, error);
    }
    if (status == DUCT_OK && (w.group.failed || w.names.failed)) {
        status = duct_fail_memory(error);
    }
    duct_text_free(&w.group);
    duct_text_free(&w.names);
    duct_release(document->allocator, w.frames);
    return status;
}
