/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_private.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

static void add_style(const duct_stroke *stroke, bool outline, double scale, duct_text *out)
{
    duct_stroke_style style = duct_stroke_get_style(stroke);
    duct_text_add(out, outline ? " style=\"fill:" : " style=\"fill:none;stroke:");
    duct_svg_add_color(out, (double)style.red, (double)style.green, (double)style.blue);
    if (style.opacity < 1) {
        duct_text_add(out, outline ? ";fill-opacity:" : ";stroke-opacity:");
        duct_text_add_number(out, (double)style.opacity, 6);
    }
    if (outline) {
        duct_text_add(out, ";stroke:none");
    } else {
        duct_text_add(out, ";stroke-width:");
        duct_text_add_number(out, (style.width > 0 ? style.width : 1) * scale, 6);
        duct_text_add(out, ";stroke-linecap:round;stroke-linejoin:round");
    }
    duct_text_add(out, "\"");
}

static duct_status add_stroke(const duct_svg_new_strokes *strokes, const duct_stroke *stroke, duct_text *out,
                              duct_error *error)
{
    bool outline = duct_svg_shows_outline(stroke, strokes->options);
    duct_status status = DUCT_OK;
    duct_path path;
    duct_path_init(&path, out->allocator);
    if (outline) {
        const duct_nib_options nib = duct_svg_nib(strokes->options);
        status = duct_path_outline(&path, stroke, &nib, error);
    } else {
        status = duct_path_fit(&path, stroke, strokes->options->fit_tolerance, error);
    }
    duct_path_transform(&path, strokes->inverse);
    duct_text_add(out, "<");
    duct_text_add(out, strokes->prefix);
    duct_text_add(out, "path");
    const char *id = duct_stroke_id(stroke);
    if (*id != '\0') {
        duct_text_add(out, " id=\"");
        duct_svg_ids_add_new(strokes->ids, id, "", out);
        duct_text_add(out, "\"");
    }
    add_style(stroke, outline, duct_affine_scale(strokes->inverse), out);
    duct_text_add(out, " d=\"");
    duct_path_text(&path, duct_svg_decimals(1 / duct_affine_scale(strokes->inverse)), out);
    duct_text_add(out, "\"/>\n");
    if (status == DUCT_OK && (path.failed || out->failed)) {
        status = duct_fail_memory(error);
    }
    duct_path_done(&path);
    return status;
}

/* How much of two group paths is the same, in whole names. */
static size_t common_groups(const char *left, const char *right)
{
    size_t common = 0;
    for (size_t i = 0;; i++) {
        bool left_ends = left[i] == '\0' || left[i] == '/', right_ends = right[i] == '\0' || right[i] == '/';
        if (left_ends && right_ends) {
            common = i;
        }
        if (left[i] == '\0' || left[i] != right[i]) {
            return common;
        }
    }
}

/* How many groups a path opens: a name that is empty is a group without id, but nothing behind the last '/'
 * is none. */
static size_t group_depth(const char *group, size_t size)
{
    size_t depth = size > 0 ? 1 : 0;
    for (size_t i = 0; i + 1 < size; i++) {
        depth += group[i] == '/';
    }
    return depth;
}

/* Closes the groups of `old` and opens those of `group`, as far as they differ. */
static void change_group(const duct_svg_new_strokes *strokes, const char *old, const char *group,
                         duct_text *out)
{
    size_t common = common_groups(old, group);
    for (size_t depth = group_depth(old, strlen(old)); depth > group_depth(old, common); depth--) {
        duct_text_addf(out, "</%sg>\n", strokes->prefix);
    }
    const char *name = group + common + (common > 0 && group[common] == '/');
    while (*name != '\0') {
        size_t size = strcspn(name, "/");
        duct_text_addf(out, "<%sg", strokes->prefix);
        if (size > 0) {
            duct_text id;
            duct_text_init(&id, out->allocator);
            duct_text_add_bytes(&id, name, size);
            out->failed = out->failed || id.failed;
            duct_text_add(out, " id=\"");
            duct_svg_ids_add_new(strokes->ids, id.data != NULL ? id.data : "", "", out);
            duct_text_add(out, "\"");
            duct_text_free(&id);
        }
        duct_text_add(out, ">\n");
        name += size;
        name += *name == '/';
    }
}

duct_status duct_svg_write_strokes(const duct_svg_new_strokes *strokes, duct_text *out, duct_error *error)
{
    duct_status status = DUCT_OK;
    const char *group = "";
    for (size_t i = 0; i < strokes->count && status == DUCT_OK; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(strokes->drawing, strokes->indices[i]);
        if (duct_stroke_size(stroke) == 0) {
            continue;
        }
        change_group(strokes, group, duct_stroke_group(stroke), out);
        group = duct_stroke_group(stroke);
        status = add_stroke(strokes, stroke, out, error);
    }
    change_group(strokes, group, "", out);
    return status;
}

/* The page, or the box of the strokes with room for their widths. */
static void page_of(const duct_drawing *drawing, double page[4])
{
    page[0] = page[1] = 0;
    page[2] = duct_drawing_width(drawing);
    page[3] = duct_drawing_height(drawing);
    double box[4], width = 1;
    if ((page[2] > 0 && page[3] > 0) || !duct_drawing_bounds(drawing, box)) {
        return;
    }
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        width = fmax(width, duct_stroke_get_style(duct_drawing_stroke(drawing, i)).width);
    }
    double margin = ceil(2 * width);
    page[0] = floor(box[0] - margin);
    page[1] = floor(box[1] - margin);
    page[2] = ceil(box[2] + margin) - page[0];
    page[3] = ceil(box[3] + margin) - page[1];
}

static void add_root(const duct_drawing *drawing, duct_text *out)
{
    double page[4], resolution = duct_drawing_resolution(drawing);
    double scale = resolution > 0 ? 96 / resolution : 1;
    page_of(drawing, page);
    duct_text_add(out,
                  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\"");
    if (page[2] > 0 && page[3] > 0) {
        duct_text_add(out, " width=\"");
        duct_text_add_fixed(out, page[2] * scale, 6);
        duct_text_add(out, "\" height=\"");
        duct_text_add_fixed(out, page[3] * scale, 6);
        duct_text_add(out, "\" viewBox=\"");
        for (int i = 0; i < 4; i++) {
            duct_text_add(out, i > 0 ? " " : "");
            duct_text_add_fixed(out, page[i], 6);
        }
        duct_text_add(out, "\"");
    }
    duct_text_add(out, ">\n");
}

static void add_annotation(const char *begin, const char *text, const char *end, duct_text *out)
{
    if (text != NULL) {
        duct_text_add(out, begin);
        duct_text_add_xml(out, text);
        duct_text_add(out, end);
    }
}

/* Title and description are SVG's own; all others are InkML's annotations within <metadata>. */
static void add_annotations(const duct_drawing *drawing, duct_text *out)
{
    const char *key, *value;
    bool open = false;
    add_annotation("<title>", duct_drawing_annotation(drawing, "title"), "</title>\n", out);
    add_annotation("<desc>", duct_drawing_annotation(drawing, "description"), "</desc>\n", out);
    for (size_t i = 0; duct_drawing_annotation_at(drawing, i, &key, &value); i++) {
        if (strcmp(key, "title") == 0 || strcmp(key, "description") == 0) {
            continue;
        }
        duct_text_add(out, open ? "" : "<metadata>\n");
        open = true;
        duct_text_add(out, "<annotation xmlns=\"http://www.w3.org/2003/InkML\" type=\"");
        duct_text_add_xml(out, key);
        add_annotation("\">", value, "</annotation>\n", out);
    }
    duct_text_add(out, open ? "</metadata>\n" : "");
}

duct_status duct_svg_write_fresh(const duct_drawing *drawing, const duct_format_options *options,
                                 duct_text *out, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing);
    size_t *indices = duct_alloc(out->allocator, count, sizeof *indices);
    if (indices == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        indices[i] = i;
    }
    duct_svg_ids ids;
    duct_svg_ids_init(&ids, out->allocator);
    duct_svg_new_strokes strokes = {drawing, indices, count, options, duct_affine_identity(), "", &ids};
    add_root(drawing, out);
    add_annotations(drawing, out);
    duct_status status = duct_svg_write_strokes(&strokes, out, error);
    duct_text_add(out, "</svg>\n");
    duct_release(out->allocator, indices);
    duct_svg_ids_free(&ids);
    return status;
}
