/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_private.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

typedef struct {
    duct_drawing *drawing;
    const duct_allocator *allocator;
    duct_points points;
    duct_text id;
    double tolerance;
    bool fills;
    size_t parts;
    int unpainted;
} reader;

bool duct_svg_takes(const duct_svg_shape *shape, bool fills)
{
    if (shape->kind >= DUCT_SVG_TEXT) {
        return false;
    }
    return fills ? duct_svg_style_fills(&shape->style) : duct_svg_style_strokes(&shape->style);
}

duct_status duct_svg_drawing_path(const duct_svg_shape *shape, duct_path *path, duct_error *error)
{
    duct_svg_shape_path(shape, path);
    if (path->failed) {
        return duct_fail_memory(error);
    }
    duct_path_transform(path, shape->matrix);
    return DUCT_OK;
}

bool duct_svg_drawable(const duct_path *path, const duct_subpath *subpath)
{
    for (size_t i = 2 * subpath->point; i < 2 * subpath->point_end; i++) {
        if (!(fabs(path->points[i]) <= 1e9)) {
            return false;
        }
    }
    return subpath->verb_end - subpath->verb > 1;
}

/* The element's name, and "/2", "/3" ... for its further subpaths. */
static const char *stroke_id(reader *r, const duct_svg_shape *shape, size_t number)
{
    if (number <= 1) {
        return shape->name;
    }
    r->id.size = 0;
    duct_text_addf(&r->id, "%s/%zu", shape->name, number);
    return r->id.failed ? NULL : r->id.data;
}

static duct_status add_stroke(reader *r, const duct_svg_shape *shape, const duct_subpath *subpath,
                              size_t number, duct_error *error)
{
    const char *id = stroke_id(r, shape, number);
    if (r->points.failed || id == NULL) {
        return duct_fail_memory(error);
    }
    if (r->points.full) {
        return duct_fail(error, DUCT_LIMIT, "line %ld: the curves have more than %d points when flattened",
                         xmlGetLineNo(shape->node), DUCT_MAX_SAMPLES);
    }
    duct_stroke *stroke;
    duct_status status = duct_drawing_add_stroke(r->drawing, id, r->points.count, &stroke, error);
    if (status == DUCT_OK) {
        status = duct_stroke_set_group(stroke, shape->group, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    memcpy(duct_stroke_edit(stroke, DUCT_X), r->points.x, r->points.count * sizeof(double));
    memcpy(duct_stroke_edit(stroke, DUCT_Y), r->points.y, r->points.count * sizeof(double));
    duct_stroke_set_closed(stroke, subpath->closed);
    duct_stroke_set_style(stroke,
                          r->fills ? duct_svg_fill_style(&shape->style)
                                   : duct_svg_stroke_style(&shape->style, duct_affine_scale(shape->matrix)));
    duct_stroke_set_part(stroke, (long)r->parts);
    duct_stroke_set_changed(stroke, false);
    r->points.limit -= r->points.count;
    return DUCT_OK;
}

/* What of the element nobody sees who sees its strokes only. */
static int unpainted(const duct_svg_shape *shape)
{
    switch (shape->kind) {
    case DUCT_SVG_TEXT:
        return DUCT_UNPAINTED_TEXT;
    case DUCT_SVG_IMAGE:
        return DUCT_UNPAINTED_IMAGES;
    case DUCT_SVG_LINE:
        return 0;
    default:
        return duct_svg_style_fills(&shape->style) ? DUCT_UNPAINTED_FILLS : 0;
    }
}

static duct_status visit(void *user, const duct_svg_shape *shape, duct_error *error)
{
    reader *r = user;
    r->unpainted |= unpainted(shape);
    if (!duct_svg_takes(shape, r->fills)) {
        return DUCT_OK;
    }
    duct_path path;
    duct_path_init(&path, r->allocator);
    duct_status status = duct_svg_drawing_path(shape, &path, error);
    duct_subpath subpath = {0};
    for (size_t number = 1; status == DUCT_OK && duct_path_next(&path, &subpath); number++) {
        if (duct_svg_drawable(&path, &subpath)) {
            duct_flatten_subpath(&r->points, &path, &subpath, r->tolerance);
            status = add_stroke(r, shape, &subpath, number, error);
        }
        r->parts++;
    }
    duct_path_done(&path);
    return status;
}

/* The text of a child element such as <title>, if it is plain. */
static const char *child_text(const xmlNode *parent, const char *name)
{
    for (const xmlNode *child = parent->children; child != NULL; child = child->next) {
        if (duct_svg_is_element(child) && strcmp((const char *)child->name, name) == 0 &&
            child->children != NULL) {
            return (const char *)child->children->content;
        }
    }
    return NULL;
}

/* <title> and <desc> of the document, and what duct_svg_write_fresh() put into <metadata>. */
static duct_status read_annotations(const duct_svg_document *document, duct_drawing *drawing,
                                    duct_error *error)
{
    duct_status status = DUCT_OK;
    static const char *const pairs[][2] = {{"title", "title"}, {"desc", "description"}};
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs && status == DUCT_OK; i++) {
        const char *text = child_text(document->root, pairs[i][0]);
        if (text != NULL) {
            status = duct_drawing_annotate(drawing, pairs[i][1], text, error);
        }
    }
    for (const xmlNode *child = document->root->children; child != NULL; child = child->next) {
        if (!duct_svg_is_element(child) || strcmp((const char *)child->name, "metadata") != 0) {
            continue;
        }
        for (const xmlNode *node = child->children; node != NULL && status == DUCT_OK; node = node->next) {
            bool is_ours = node->type == XML_ELEMENT_NODE && node->ns != NULL && node->children != NULL &&
                           strcmp((const char *)node->name, "annotation") == 0 &&
                           strcmp((const char *)node->ns->href, "http://www.w3.org/2003/InkML") == 0;
            const char *key = is_ours ? duct_svg_attribute(node, "type") : NULL;
            if (key != NULL && node->children->content != NULL) {
                status = duct_drawing_annotate(drawing, key, (const char *)node->children->content, error);
            }
        }
    }
    return status;
}

static void destroy(duct_origin *base)
{
    duct_svg_origin *origin = (duct_svg_origin *)base;
    const duct_allocator allocator = origin->allocator;
    duct_release(&allocator, origin->data);
    duct_release(&allocator, origin);
}

/* Keeps the bytes with the drawing. */
static duct_status set_origin(const reader *r, const char *data, size_t size, duct_error *error)
{
    duct_svg_origin *origin = duct_alloc(r->allocator, 1, sizeof *origin);
    char *copy = duct_alloc(r->allocator, size + 1, 1);
    if (origin == NULL || copy == NULL) {
        duct_release(r->allocator, origin);
        duct_release(r->allocator, copy);
        return duct_fail_memory(error);
    }
    memcpy(copy, data, size);
    atomic_init(&origin->base.references, 1);
    origin->base.format = "svg";
    origin->base.unpainted = r->unpainted;
    origin->base.destroy = destroy;
    origin->allocator = *r->allocator;
    origin->data = copy;
    origin->size = size;
    origin->fills = r->fills;
    origin->stroke_count = duct_drawing_stroke_count(r->drawing);
    origin->part_count = r->parts;
    duct_drawing_set_origin(r->drawing, &origin->base);
    return DUCT_OK;
}

duct_status duct_svg_read(const duct_context *context, const char *data, size_t size,
                          const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    if (size >= 2 && memcmp(data, "\x1f\x8b", 2) == 0) {
        return duct_fail(
            error, DUCT_UNSUPPORTED,
            "is compressed (SVGZ); unpack it first, for example with: gunzip -c FILE.svgz > FILE.svg");
    }
    duct_svg_document document;
    duct_status status = duct_svg_document_open(allocator, data, size, &document, error);
    if (status != DUCT_OK) {
        return status;
    }
    double tolerance = options != NULL ? options->flatten_tolerance : 0;
    if (!(tolerance > 0)) {
        tolerance = duct_format_options_default().flatten_tolerance;
    }
    reader r = {.drawing = drawing, .allocator = allocator, .tolerance = tolerance};
    duct_points_init(&r.points, allocator, DUCT_MAX_SAMPLES);
    duct_text_init(&r.id, allocator);
    duct_drawing_set_page(drawing, document.width, document.height);
    duct_drawing_set_resolution(drawing, 96);
    status = read_annotations(&document, drawing, error);
    if (status == DUCT_OK) {
        status = duct_svg_walk(&document, visit, &r, error);
    }
    if (status == DUCT_OK && duct_drawing_stroke_count(drawing) == 0) {
        r.fills = true;
        r.parts = 0;
        status = duct_svg_walk(&document, visit, &r, error);
    }
    if (status == DUCT_OK) {
        status = set_origin(&r, data, size, error);
    }
    duct_points_free(&r.points);
    duct_text_free(&r.id);
    duct_svg_document_close(&document);
    return status;
}
