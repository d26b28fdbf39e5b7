/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_element.h"

#include "base/number.h"

#include <math.h>
#include <string.h>

void duct_svg_overrides_init(duct_svg_overrides *overrides, const duct_svg_document *document,
                             const duct_allocator *allocator)
{
    *overrides = (duct_svg_overrides){.important = duct_css_sheet_important(document->sheet)};
    duct_text_init(&overrides->css, allocator);
}

void duct_svg_override(duct_svg_overrides *overrides, const char *property, const char *value)
{
    duct_text *css = &overrides->css;
    duct_text_addf(css, "%s%s:", css->size > 0 ? ";" : "", property);
    duct_text_add(css, value);
    duct_text_add(css, overrides->important ? " !important" : "");
}

static void override_number(duct_svg_overrides *overrides, const char *property, double value)
{
    char number[DUCT_NUMBER_SIZE];
    duct_number_print(number, value, 6);
    duct_svg_override(overrides, property, number);
}

static void override_color(duct_svg_overrides *overrides, const char *property, duct_stroke_style style)
{
    duct_text color;
    duct_text_init(&color, overrides->css.allocator);
    duct_svg_add_color(&color, (double)style.red, (double)style.green, (double)style.blue);
    overrides->css.failed = overrides->css.failed || color.failed;
    duct_svg_override(overrides, property, color.data != NULL ? color.data : "");
    duct_text_free(&color);
}

void duct_svg_add_color(duct_text *text, double red, double green, double blue)
{
    static const char digits[] = "0123456789abcdef";
    double values[3] = {red, green, blue};
    char color[8] = "#";
    for (int i = 0; i < 3; i++) {
        int byte = (int)lround(fmin(fmax(values[i], 0), 1) * 255);
        color[1 + 2 * i] = digits[byte >> 4];
        color[2 + 2 * i] = digits[byte & 15];
    }
    duct_text_add_bytes(text, color, 7);
}

static duct_stroke_style read_style(const duct_svg_shape *shape, bool fills)
{
    return fills ? duct_svg_fill_style(&shape->style)
                 : duct_svg_stroke_style(&shape->style, duct_affine_scale(shape->matrix));
}

static bool same_color(duct_stroke_style left, duct_stroke_style right)
{
    return left.red == right.red && left.green == right.green && left.blue == right.blue;
}

/* The share of the stroke's opacity that is the element's own, not its groups'. */
static double own_opacity(const duct_svg_shape *shape, duct_stroke_style style)
{
    return fmin((double)style.opacity / shape->style.opacity, 1);
}

void duct_svg_override_changed(duct_svg_overrides *overrides, const duct_svg_shape *shape, bool fills,
                               duct_stroke_style style)
{
    duct_stroke_style old = read_style(shape, fills);
    if (!same_color(style, old)) {
        override_color(overrides, fills ? "fill" : "stroke", style);
    }
    if (style.opacity != old.opacity || !same_color(style, old)) {
        override_number(overrides, fills ? "fill-opacity" : "stroke-opacity", own_opacity(shape, style));
    }
    if (!fills && style.width > 0 && fabs(style.width - old.width) > 1e-9 * old.width) {
        double scale = shape->style.non_scaling ? 1 : duct_affine_scale(shape->matrix);
        override_number(overrides, "stroke-width", style.width / scale);
    }
}

void duct_svg_override_outline(duct_svg_overrides *overrides, const duct_svg_shape *shape,
                               duct_stroke_style style)
{
    const duct_svg_paint *paint = &shape->style.stroke;
    if (paint->kind == DUCT_SVG_PAINT_SERVER && same_color(style, read_style(shape, false))) {
        duct_text server;
        duct_text_init(&server, overrides->css.allocator);
        duct_text_add_bytes(&server, paint->server.text, paint->server.size);
        overrides->css.failed = overrides->css.failed || server.failed;
        duct_svg_override(overrides, "fill", server.data != NULL ? server.data : "");
        duct_text_free(&server);
    } else {
        override_color(overrides, "fill", style);
    }
    override_number(overrides, "fill-opacity", own_opacity(shape, style));
    duct_svg_override_fill_only(overrides);
}

void duct_svg_override_fill_only(duct_svg_overrides *overrides)
{
    duct_svg_override(overrides, "stroke", "none");
    duct_svg_override(overrides, "marker", "none");
    overrides->whole_line = true;
}

static bool is_overridden(const duct_svg_overrides *overrides, duct_slice name)
{
    if (overrides->whole_line && (duct_slice_begins(name, "marker") || duct_slice_begins(name, "stroke"))) {
        return true;
    }
    duct_slice rest = {overrides->css.data, overrides->css.size};
    duct_css_declaration declaration;
    while (rest.size > 0 && duct_css_next(&rest, &declaration)) {
        if (declaration.name.size == name.size && memcmp(declaration.name.text, name.text, name.size) == 0) {
            return true;
        }
    }
    return false;
}

/* The old style attribute without what is overridden, and the overrides behind it. */
static void add_style(const duct_svg_shape *shape, const duct_svg_overrides *overrides, duct_text *out)
{
    duct_text css;
    duct_text_init(&css, out->allocator);
    duct_slice rest = duct_slice_of(duct_svg_attribute(shape->node, "style"));
    duct_css_declaration declaration;
    while (rest.size > 0 && duct_css_next(&rest, &declaration)) {
        if (!is_overridden(overrides, declaration.name)) {
            duct_text_add_bytes(&css, declaration.name.text, declaration.name.size);
            duct_text_add(&css, ":");
            duct_text_add_bytes(&css, declaration.value.text, declaration.value.size);
            duct_text_add(&css, declaration.important ? " !important;" : ";");
        }
    }
    duct_text_add(&css, overrides->css.data != NULL ? overrides->css.data : "");
    duct_text_add(out, " style=\"");
    duct_text_add_xml(out, css.data != NULL ? css.data : "");
    duct_text_add(out, "\"");
    out->failed = out->failed || css.failed;
    duct_text_free(&css);
}

/* Attributes from which Inkscape would compute `d` again. */
static bool recomputes(duct_slice name)
{
    static const char *const names[] = {"original-d", "path-effect", "nodetypes", "type"};
    const char *colon = memchr(name.text, ':', name.size);
    if (colon == NULL) {
        return false;
    }
    size_t prefix = (size_t)(colon - name.text) + 1;
    duct_slice local = {name.text + prefix, name.size - prefix};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (duct_slice_is(local, names[i])) {
            return duct_slice_begins(name, "sodipodi:") || duct_slice_begins(name, "inkscape:");
        }
    }
    return false;
}

static void add_d(const char *d, duct_text *out)
{
    duct_text_add(out, " d=\"");
    duct_text_add(out, d);
    duct_text_add(out, "\"");
}

void duct_svg_add_start_tag(duct_svg_ids *ids, const char *data, const duct_svg_shape *shape, const char *d,
                            const duct_svg_overrides *overrides, const char *id_suffix, duct_text *out)
{
    const duct_svg_tag *tag = shape->node->_private;
    duct_slice raw = {data + tag->begin, tag->name_end - tag->begin};
    const char *colon = memchr(raw.text, ':', raw.size);
    duct_text_add_bytes(out, raw.text, colon != NULL ? (size_t)(colon - raw.text) + 1 : 1);
    duct_text_add(out, "path");
    size_t at = tag->name_end;
    bool has_d = false, has_style = overrides->css.size == 0;
    duct_slice whole, name;
    while (duct_svg_tag_attribute(data, tag, &at, &whole, &name)) {
        if (duct_slice_is(name, "style") && overrides->css.size > 0) {
            add_style(shape, overrides, out);
            has_style = true;
        } else if (shape->kind == DUCT_SVG_PATH && duct_slice_is(name, "d")) {
            add_d(d, out);
            has_d = true;
        } else if (id_suffix != NULL && duct_slice_is(name, "id")) {
            duct_text_add(out, " id=\"");
            duct_svg_ids_add_new(ids, duct_svg_attribute(shape->node, "id"), id_suffix, out);
            duct_text_add(out, "\"");
        } else if (!duct_svg_is_geometry(shape->kind, name) && !recomputes(name)) {
            duct_text_add_bytes(out, whole.text, whole.size);
        }
    }
    if (!has_d) {
        add_d(d, out);
    }
    if (!has_style) {
        add_style(shape, overrides, out);
    }
    out->failed = out->failed || overrides->css.failed;
    /* What stands before the bracket stays, be it " /" or a line break. */
    bool close = id_suffix != NULL && !tag->empty;
    duct_text_add(out, close ? "/" : "");
    duct_text_add_bytes(out, data + at, tag->end - at);
}
