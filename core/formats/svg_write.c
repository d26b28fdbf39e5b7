/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_private.h"

#include "base/error.h"
#include "formats/svg_element.h"
#include "formats/svg_tags.h"
#include "formats/svg_transform.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

static const size_t none = SIZE_MAX;

typedef struct {
    const duct_drawing *drawing;
    const duct_svg_origin *origin;
    duct_format_options options;
    const duct_allocator *allocator;
    size_t *first; /* of each part: its first stroke, or none */
    size_t *next;  /* of each stroke: the next one of the same part, or none */
    size_t *fresh; /* strokes that have no part */
    size_t fresh_count;
    duct_svg_document document;
    duct_svg_ids ids;
    const char *data; /* the text that is spliced into */
    size_t size, cursor;
    duct_svg_tag *tags;
    xmlChar *dump; /* the text in UTF-8 where the file's own cannot be spliced */
    size_t part;   /* of the next subpath */
    duct_text *out;
} writer;

int duct_svg_decimals(double scale)
{
    double digits = ceil(log10(scale) - 1e-6) + 3;
    return !(digits >= 0) ? 0 : digits > 15 ? 15 : (int)digits;
}

bool duct_svg_shows_outline(const duct_stroke *stroke, const duct_format_options *options)
{
    return options->line_style == DUCT_LINE_OUTLINE && duct_stroke_values(stroke, DUCT_PRESSURE) != NULL;
}

duct_nib_options duct_svg_nib(const duct_format_options *options)
{
    duct_nib_options nib = duct_nib_options_default();
    nib.fit_tolerance = options->fit_tolerance;
    return nib;
}

/* Sorts the drawing's strokes by the part that they came from. */
static duct_status sort_strokes(writer *w, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(w->drawing), parts = w->origin->part_count;
    w->first = duct_alloc(w->allocator, parts, sizeof(size_t));
    w->next = duct_alloc(w->allocator, count, sizeof(size_t));
    w->fresh = duct_alloc(w->allocator, count, sizeof(size_t));
    if (w->first == NULL || w->next == NULL || w->fresh == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < parts; i++) {
        w->first[i] = none;
    }
    /* From the last to the first, so that the lists come out in the drawing's order. */
    for (size_t i = count; i-- > 0;) {
        long part = duct_stroke_part(duct_drawing_stroke(w->drawing, i));
        if (part >= 0 && (size_t)part < parts) {
            w->next[i] = w->first[part];
            w->first[part] = i;
        }
    }
    for (size_t i = 0; i < count; i++) {
        long part = duct_stroke_part(duct_drawing_stroke(w->drawing, i));
        if (part < 0 || (size_t)part >= parts) {
            w->fresh[w->fresh_count++] = i;
        }
    }
    return DUCT_OK;
}

/* True where the part has exactly the stroke that was read. */
static bool part_unchanged(const writer *w, size_t part)
{
    size_t stroke = w->first[part];
    return stroke != none && w->next[stroke] == none &&
           !duct_stroke_changed(duct_drawing_stroke(w->drawing, stroke));
}

static bool drawing_unchanged(const writer *w)
{
    size_t count = duct_drawing_stroke_count(w->drawing);
    if (count != w->origin->stroke_count || w->fresh_count > 0) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        if (!part_unchanged(w, (size_t)duct_stroke_part(duct_drawing_stroke(w->drawing, i)))) {
            return false;
        }
    }
    return true;
}

/* Copies the text up to `end`, unless it was left out already, and goes on behind `resume`. */
static void copy_until(writer *w, size_t end, size_t resume)
{
    if (end > w->cursor) {
        duct_text_add_bytes(w->out, w->data + w->cursor, end - w->cursor);
    }
    w->cursor = resume > w->cursor ? resume : w->cursor;
}

/* What the drawing says of one element. */
typedef struct {
    const duct_svg_shape *shape;
    duct_path path; /* as it was read, in drawing pixels */
    size_t part;    /* of its first subpath */
    bool outlines;
    const duct_stroke *leader; /* the first changed stroke, or the first one: gives the style */
} element;

/* Fills in what is left of the element; false where it is as it was read. */
static bool examine(writer *w, element *e)
{
    bool changed = false, any = false;
    duct_subpath subpath = {0};
    for (size_t part = e->part; duct_path_next(&e->path, &subpath); part++) {
        w->part = part + 1;
        if (!duct_svg_drawable(&e->path, &subpath)) {
            continue;
        }
        any = true;
        changed = changed || !part_unchanged(w, part);
        for (size_t i = w->first[part]; i != none; i = w->next[i]) {
            const duct_stroke *stroke = duct_drawing_stroke(w->drawing, i);
            bool better =
                e->leader == NULL || (duct_stroke_changed(stroke) && !duct_stroke_changed(e->leader));
            e->leader = better ? stroke : e->leader;
            e->outlines = e->outlines || (!w->origin->fills && duct_svg_shows_outline(stroke, &w->options));
        }
    }
    return any && changed;
}

/* The element's new centre line: unchanged subpaths as they were, others fitted. In drawing pixels. */
static duct_status make_spine(const writer *w, const element *e, duct_path *spine, duct_error *error)
{
    duct_status status = DUCT_OK;
    duct_subpath subpath = {0};
    for (size_t part = e->part; duct_path_next(&e->path, &subpath); part++) {
        for (size_t i = w->first[part]; i != none && status == DUCT_OK; i = w->next[i]) {
            const duct_stroke *stroke = duct_drawing_stroke(w->drawing, i);
            if (duct_stroke_changed(stroke)) {
                status = duct_path_fit(spine, stroke, w->options.fit_tolerance, error);
            } else {
                duct_path_append(spine, &e->path, &subpath);
            }
        }
    }
    return status;
}

static duct_status make_outline(const writer *w, const element *e, duct_path *outline, duct_error *error)
{
    const duct_nib_options nib = duct_svg_nib(&w->options);
    duct_status status = DUCT_OK;
    duct_subpath subpath = {0};
    for (size_t part = e->part; duct_path_next(&e->path, &subpath); part++) {
        for (size_t i = w->first[part]; i != none && status == DUCT_OK; i = w->next[i]) {
            status = duct_path_outline(outline, duct_drawing_stroke(w->drawing, i), &nib, error);
        }
    }
    return status;
}

/* The path as the value of `d`, brought back into the element's coordinates. */
static void print_path(const duct_svg_shape *shape, duct_path *path, duct_text *d)
{
    duct_affine inverse = duct_affine_identity();
    duct_affine_invert(shape->matrix, &inverse);
    duct_path_transform(path, inverse);
    duct_text_add(d, "");
    duct_path_text(path, duct_svg_decimals(duct_affine_stretch(shape->matrix)), d);
    d->failed = d->failed || path->failed;
}

/* The line break and indentation before a tag. */
static duct_slice indentation(const writer *w, const duct_svg_tag *tag)
{
    size_t begin = tag->begin;
    while (begin > 0 && duct_is_space(w->data[begin - 1])) {
        begin--;
    }
    return (duct_slice){w->data + begin, tag->begin - begin};
}

static void write_tag(writer *w, const element *e, const char *d, const duct_svg_overrides *overrides)
{
    const duct_svg_tag *tag = e->shape->node->_private;
    copy_until(w, tag->begin, tag->end);
    duct_svg_add_start_tag(&w->ids, w->data, e->shape, d, overrides, NULL, w->out);
    if (tag->empty || e->shape->kind == DUCT_SVG_PATH) {
        return; /* there is no end tag, or it stays */
    }
    copy_until(w, tag->close_begin, tag->close_end);
    duct_slice close = {w->data + tag->close_begin, tag->close_end - tag->close_begin};
    const char *colon = memchr(close.text, ':', close.size);
    duct_text_add_bytes(w->out, close.text, colon != NULL ? (size_t)(colon - close.text) + 1 : 2);
    duct_text_add(w->out, "path>");
}

static void write_spine(writer *w, const element *e, const char *d)
{
    duct_svg_overrides overrides;
    duct_svg_overrides_init(&overrides, &w->document, w->allocator);
    if (e->outlines) {
        duct_svg_override_fill_only(&overrides);
    } else {
        duct_svg_override_changed(&overrides, e->shape, w->origin->fills, duct_stroke_get_style(e->leader));
    }
    write_tag(w, e, d, &overrides);
    duct_text_free(&overrides.css);
}

/* In the element's place, or behind it where its fill stays. */
static void write_outline(writer *w, const element *e, const char *d, bool behind)
{
    duct_svg_overrides overrides;
    duct_svg_overrides_init(&overrides, &w->document, w->allocator);
    duct_svg_override_outline(&overrides, e->shape, duct_stroke_get_style(e->leader));
    if (behind) {
        duct_slice indent = indentation(w, e->shape->node->_private);
        duct_text_add_bytes(w->out, indent.text, indent.size);
        duct_svg_add_start_tag(&w->ids, w->data, e->shape, d, &overrides, "-line", w->out);
    } else {
        write_tag(w, e, d, &overrides);
    }
    duct_text_free(&overrides.css);
}

static duct_status rewrite(writer *w, const element *e, duct_error *error)
{
    duct_status status = DUCT_OK;
    bool fills = duct_svg_style_fills(&e->shape->style);
    duct_path spine, outline;
    duct_text spine_d, outline_d;
    duct_path_init(&spine, w->allocator);
    duct_path_init(&outline, w->allocator);
    duct_text_init(&spine_d, w->allocator);
    duct_text_init(&outline_d, w->allocator);
    if (!e->outlines || fills) {
        status = make_spine(w, e, &spine, error);
        print_path(e->shape, &spine, &spine_d);
    }
    if (status == DUCT_OK && e->outlines) {
        status = make_outline(w, e, &outline, error);
        print_path(e->shape, &outline, &outline_d);
    }
    if (status == DUCT_OK && (spine_d.failed || outline_d.failed)) {
        status = duct_fail_memory(error);
    }
    if (status == DUCT_OK && (!e->outlines || fills)) {
        write_spine(w, e, spine_d.data);
    }
    if (status == DUCT_OK && e->outlines) {
        write_outline(w, e, outline_d.data, fills);
    }
    duct_path_done(&spine);
    duct_path_done(&outline);
    duct_text_free(&spine_d);
    duct_text_free(&outline_d);
    return status;
}

static duct_status visit(void *user, const duct_svg_shape *shape, duct_error *error)
{
    writer *w = user;
    if (!duct_svg_takes(shape, w->origin->fills)) {
        return DUCT_OK;
    }
    element e = {.shape = shape, .part = w->part};
    duct_path_init(&e.path, w->allocator);
    duct_status status = duct_svg_drawing_path(shape, &e.path, error);
    if (status == DUCT_OK && examine(w, &e)) {
        if (e.leader != NULL) {
            status = rewrite(w, &e, error);
        } else {
            const duct_svg_tag *tag = shape->node->_private;
            copy_until(w, tag->begin - indentation(w, tag).size, tag->close_end);
        }
    }
    duct_path_done(&e.path);
    return status;
}

/* New strokes come last in the root element. */
static duct_status write_new(writer *w, duct_error *error)
{
    const duct_svg_tag *root = w->document.root->_private;
    if (w->fresh_count == 0) {
        copy_until(w, w->size, w->size);
        return DUCT_OK;
    }
    duct_slice name = {w->data + root->begin + 1, root->name_end - root->begin - 1};
    const char *colon = memchr(name.text, ':', name.size);
    char prefix[64] = "";
    size_t length = colon != NULL ? (size_t)(colon - name.text) + 1 : 0;
    if (length < sizeof prefix) {
        memcpy(prefix, name.text, length);
        prefix[length] = '\0';
    }
    duct_svg_new_strokes strokes = {w->drawing, w->fresh, w->fresh_count, &w->options, duct_affine_identity(),
                                    prefix,     &w->ids};
    duct_affine transform = duct_affine_identity();
    duct_svg_transform(duct_slice_of(duct_svg_attribute(w->document.root, "transform")), &transform);
    duct_affine_invert(duct_affine_multiply(transform, duct_svg_root_map(&w->document)), &strokes.inverse);
    if (root->empty) {
        copy_until(w, root->end - 2, root->end);
        duct_text_add(w->out, ">\n");
    } else {
        copy_until(w, root->close_begin, root->close_begin);
    }
    duct_status status = duct_svg_write_strokes(&strokes, w->out, error);
    if (root->empty) {
        duct_text_add(w->out, "</");
        duct_text_add_bytes(w->out, name.text, name.size);
        duct_text_add(w->out, ">");
    }
    copy_until(w, w->size, w->size);
    return status;
}

static bool scan_text(writer *w, const char *data, size_t size, bool *failed)
{
    size_t count;
    duct_release(w->allocator, w->tags);
    w->tags = NULL;
    w->data = data;
    w->size = size;
    return duct_svg_tags_scan(w->allocator, data, size, &w->tags, &count, failed) &&
           duct_svg_tags_match(data, w->tags, count, w->document.root);
}

/* Finds each element's bytes: in the file's own text where that agrees with ASCII, otherwise in the same
 * document written anew in UTF-8. */
static duct_status find_tags(writer *w, duct_error *error)
{
    const char *encoding = (const char *)w->document.xml->encoding;
    bool failed = false;
    bool utf8 = encoding == NULL || duct_slice_is(duct_slice_of(encoding), "utf-8") ||
                duct_slice_is(duct_slice_of(encoding), "us-ascii");
    if (utf8 && scan_text(w, w->origin->data, w->origin->size, &failed)) {
        return DUCT_OK;
    }
    int size = 0;
    if (!failed) {
        xmlDocDumpMemoryEnc(w->document.xml, &w->dump, &size, "UTF-8");
    }
    if (failed || w->dump == NULL) {
        return duct_fail_memory(error);
    }
    if (scan_text(w, (const char *)w->dump, (size_t)size, &failed)) {
        return DUCT_OK;
    }
    return failed
               ? duct_fail_memory(error)
               : duct_fail(
                     error, DUCT_UNSUPPORTED,
                     "cannot write into this document, whose entities hold elements; save it with Inkscape "
                     "first");
}

static duct_status write_changed(writer *w, duct_error *error)
{
    duct_status status =
        duct_svg_document_open(w->allocator, w->origin->data, w->origin->size, &w->document, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_svg_ids_init(&w->ids, w->allocator);
    for (xmlNode *node = w->document.root; node != NULL; node = duct_svg_next_element(node)) {
        const char *id = duct_svg_attribute(node, "id");
        if (id != NULL) {
            duct_svg_ids_take(&w->ids, id);
        }
    }
    status = w->ids.failed ? duct_fail_memory(error) : find_tags(w, error);
    if (status == DUCT_OK) {
        status = duct_svg_walk(&w->document, visit, w, error);
    }
    if (status == DUCT_OK) {
        status = write_new(w, error);
    }
    duct_release(w->allocator, w->tags);
    duct_svg_ids_free(&w->ids);
    xmlFree(w->dump);
    duct_svg_document_close(&w->document);
    return status;
}

duct_status duct_svg_write(const duct_context *context, const duct_drawing *drawing,
                           const duct_format_options *options, duct_text *out, duct_error *error)
{
    const duct_origin *origin = duct_drawing_origin(drawing);
    duct_format_options chosen = options != NULL ? *options : duct_format_options_default();
    if (!(chosen.fit_tolerance > 0)) {
        chosen.fit_tolerance = duct_format_options_default().fit_tolerance;
    }
    duct_status status;
    if (origin == NULL || strcmp(origin->format, "svg") != 0) {
        status = duct_svg_write_fresh(drawing, &chosen, out, error);
    } else {
        writer w = {.drawing = drawing,
                    .origin = (const duct_svg_origin *)origin,
                    .options = chosen,
                    .allocator = duct_allocator_of(context),
                    .out = out};
        status = sort_strokes(&w, error);
        if (status == DUCT_OK && drawing_unchanged(&w)) {
            duct_text_add_bytes(out, w.origin->data, w.origin->size);
        } else if (status == DUCT_OK) {
            status = write_changed(&w, error);
        }
        duct_release(w.allocator, w.first);
        duct_release(w.allocator, w.next);
        duct_release(w.allocator, w.fresh);
    }
    return status == DUCT_OK && out->failed ? duct_fail_memory(error) : status;
}
