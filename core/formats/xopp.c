/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The notes of Xournal++ (`.xopp`) and Xournal (`.xoj`): XML, usually packed by gzip, of pages, layers and
 * strokes. A stroke is its points in 1/72 inch, a colour, and one width, or, where the pen had pressure, the
 * nominal width and the width at each point (Xournal: of each of the segments between them). The widths over
 * the nominal one are the pressure; Xournal makes full pressure 1.25 times as wide as the nominal width.
 * Pages are laid below each other. What is not a stroke (text, pictures, backgrounds) is not read. */
#include "base/error.h"
#include "base/number.h"
#include "drawing/drawing_private.h"
#include "formats/format_private.h"
#include "formats/gzip.h"
#include "formats/recording.h"
#include "formats/xml.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define PIXELS_PER_POINT (96.0 / 72)
#define XOURNAL_FULL_WIDTH 1.25
#define HIGHLIGHTER_OPACITY 0.5f

enum { PEEK = 1024 };

typedef struct {
    const duct_allocator *allocator;
    duct_drawing *drawing;
    double full_width; /* at full pressure, in nominal widths */
    double width, top; /* of the pages so far, in points */
    duct_text group;   /* of the layer that is read */
    double *numbers;   /* of the stroke that is read: its points, or its widths */
    size_t capacity;
} reader;

static bool sniff(const char *data, size_t size)
{
    char head[PEEK + 1];
    if (duct_gzip_is(data, size)) {
        size = duct_gzip_peek(data, size, head, PEEK);
        head[size] = '\0';
        data = head;
    }
    return duct_xml_root_is(data, size, "xournal");
}

static bool is_element(const xmlNode *node, const char *name)
{
    return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0;
}

/* The attribute's text, or NULL. Attributes are one text node unless they hold entities, which these never
 * do. */
static const char *attribute(const xmlNode *node, const char *name)
{
    for (const xmlAttr *a = node->properties; a != NULL; a = a->next) {
        if (strcmp((const char *)a->name, name) == 0) {
            const xmlNode *text = a->children;
            return text != NULL && text->content != NULL ? (const char *)text->content : "";
        }
    }
    return NULL;
}

static const char *skip_space(const char *text)
{
    return text + strspn(text, " \t\r\n");
}

/* Appends the text's numbers to those of the reader, from `*count` on; stops at its end or at what is no
 * finite number, where `*text` then points. */
static duct_status scan_numbers(reader *r, const char **text, size_t *count, duct_error *error)
{
    const char *end;
    double number;
    for (*text = skip_space(*text); duct_number_scan(*text, &end, &number) && isfinite(number);
         *text = skip_space(end)) {
        void *numbers = r->numbers;
        if (*end != '\0' && skip_space(end) == end) {
            break;
        }
        if (*count >= 2 * (size_t)DUCT_MAX_SAMPLES) {
            return duct_fail(error, DUCT_LIMIT, "a stroke has more than %d points", DUCT_MAX_SAMPLES);
        }
        if (!duct_reserve(r->allocator, &numbers, &r->capacity, *count + 1, sizeof *r->numbers)) {
            return duct_fail_memory(error);
        }
        r->numbers = numbers;
        r->numbers[(*count)++] = number;
    }
    return DUCT_OK;
}

/* ---- colours ---- */

static int hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

static bool parse_hexadecimal(const char *text, duct_stroke_style *style)
{
    size_t length = strspn(text, "0123456789abcdefABCDEF");
    if (text[length] != '\0' || (length != 6 && length != 8)) {
        return false;
    }
    float parts[4] = {0, 0, 0, 1};
    for (size_t i = 0; i < length / 2; i++) {
        parts[i] = (float)(16 * hex_digit(text[2 * i]) + hex_digit(text[2 * i + 1])) / 255;
    }
    style->red = parts[0];
    style->green = parts[1];
    style->blue = parts[2];
    style->opacity = parts[3];
    return true;
}

/* The colours that Xournal writes by name. */
static bool parse_name(const char *text, duct_stroke_style *style)
{
    static const struct {
        const char *name, *color;
    } names[] = {
        {"black", "000000"},  {"blue", "3333cc"},      {"red", "ff0000"},        {"green", "008000"},
        {"gray", "808080"},   {"lightblue", "00c0ff"}, {"lightgreen", "00ff00"}, {"magenta", "ff00ff"},
        {"orange", "ff8000"}, {"yellow", "ffff00"},    {"white", "ffffff"},
    };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(names[i].name, text) == 0) {
            return parse_hexadecimal(names[i].color, style);
        }
    }
    return false;
}

static duct_status read_style(const xmlNode *node, duct_stroke_style *style, duct_error *error)
{
    const char *color = attribute(node, "color"), *tool = attribute(node, "tool");
    if (color == NULL) {
        return DUCT_OK;
    }
    if (*color == '#' ? parse_hexadecimal(color + 1, style) : parse_name(color, style)) {
        if (*color != '#' && tool != NULL && strcmp(tool, "highlighter") == 0) {
            style->opacity = HIGHLIGHTER_OPACITY;
        }
        return DUCT_OK;
    }
    return duct_fail(error, DUCT_BAD_FORMAT,
                     "line %ld: a stroke's colour is \"%.40s\", which is neither a name nor #rrggbbaa",
                     xmlGetLineNo(node), color);
}

/* ---- strokes ---- */

/* The stroke's text in one piece: comments may stand within it. */
static duct_status scan_points(reader *r, const xmlNode *node, size_t *count, duct_error *error)
{
    *count = 0;
    for (const xmlNode *child = node->children; child != NULL; child = child->next) {
        if (child->type != XML_TEXT_NODE && child->type != XML_CDATA_SECTION_NODE) {
            continue;
        }
        const char *text = child->content != NULL ? (const char *)child->content : "";
        duct_status status = scan_numbers(r, &text, count, error);
        if (status != DUCT_OK) {
            return status;
        }
        if (*text != '\0') {
            return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: stroke %zu: \"%.20s\" is no number",
                             xmlGetLineNo(node), duct_drawing_stroke_count(r->drawing), text);
        }
    }
    if (*count % 2 != 0) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: stroke %zu: the last point's y is missing",
                         xmlGetLineNo(node), duct_drawing_stroke_count(r->drawing));
    }
    return DUCT_OK;
}

static duct_status add_stroke(reader *r, size_t size, duct_stroke **stroke, duct_error *error)
{
    duct_status status = duct_recording_add_stroke(r->drawing, size, stroke, error);
    if (status != DUCT_OK) {
        return status;
    }
    double *x = duct_stroke_edit(*stroke, DUCT_X), *y = duct_stroke_edit(*stroke, DUCT_Y);
    for (size_t i = 0; i < size; i++) {
        x[i] = r->numbers[2 * i] * PIXELS_PER_POINT;
        y[i] = (r->numbers[2 * i + 1] + r->top) * PIXELS_PER_POINT;
        if (!isfinite(x[i]) || !isfinite(y[i])) {
            return duct_fail(error, DUCT_BAD_FORMAT, "stroke %zu: point %zu is out of range",
                             duct_drawing_stroke_count(r->drawing) - 1, i);
        }
    }
    return duct_stroke_set_group(*stroke, r->group.data, error);
}

/* Too few widths say nothing (Xournal++ passes over them too); where there is one a segment, the last point
 * has the last segment's. */
static duct_status read_widths(reader *r, const xmlNode *node, duct_stroke *stroke, double *nominal,
                               duct_error *error)
{
    const char *text = attribute(node, "width");
    size_t count = 0, size = duct_stroke_size(stroke);
    if (text == NULL) {
        return DUCT_OK;
    }
    duct_status status = scan_numbers(r, &text, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    if (count == 0 || r->numbers[0] < 0) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: a stroke's width is \"%.20s\", which is no width",
                         xmlGetLineNo(node), attribute(node, "width"));
    }
    *nominal = r->numbers[0];
    if (count < 2 || count < size || !(*nominal > 0)) {
        return DUCT_OK;
    }
    double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE);
    if (pressure == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < size; i++) {
        size_t at = i + 1 < count ? i + 1 : count - 1;
        pressure[i] = fmin(r->numbers[at] / (*nominal * r->full_width), 1);
    }
    return DUCT_OK;
}

static duct_status read_stroke(reader *r, const xmlNode *node, duct_error *error)
{
    size_t count;
    duct_stroke *stroke = NULL;
    double nominal = 0;
    duct_status status = scan_points(r, node, &count, error);
    if (status == DUCT_OK) {
        status = add_stroke(r, count / 2, &stroke, error);
    }
    if (status == DUCT_OK) {
        status = read_widths(r, node, stroke, &nominal, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    duct_stroke_style style = duct_stroke_get_style(stroke);
    status = read_style(node, &style, error);
    style.width = nominal * PIXELS_PER_POINT;
    if (status == DUCT_OK && !isfinite(style.width)) {
        status = duct_fail(error, DUCT_BAD_FORMAT, "line %ld: a stroke's width is out of range",
                           xmlGetLineNo(node));
    }
    duct_stroke_set_style(stroke, style);
    duct_recording_tidy(stroke);
    return status;
}

/* ---- pages ---- */

static duct_status read_layer(reader *r, const xmlNode *layer, size_t page, size_t number, duct_error *error)
{
    const char *name = attribute(layer, "name");
    duct_text_free(&r->group);
    duct_text_init(&r->group, r->allocator);
    duct_text_addf(&r->group, "page %zu/", page);
    if (name != NULL && *name != '\0') {
        duct_text_add(&r->group, name);
    } else {
        duct_text_addf(&r->group, "layer %zu", number);
    }
    duct_status status = r->group.failed ? duct_fail_memory(error) : DUCT_OK;
    for (const xmlNode *node = layer->children; status == DUCT_OK && node != NULL; node = node->next) {
        if (is_element(node, "stroke")) {
            status = read_stroke(r, node, error);
        }
    }
    return status;
}

static duct_status read_page(reader *r, const xmlNode *page, size_t number, duct_error *error)
{
    static const char *const names[2] = {"width", "height"};
    double size[2];
    for (int i = 0; i < 2; i++) {
        const char *text = attribute(page, names[i]);
        if (text == NULL || !duct_number_parse(text, &size[i]) || size[i] < 0) {
            return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: page %zu: its %s is missing or is no length",
                             xmlGetLineNo(page), number, names[i]);
        }
    }
    duct_status status = DUCT_OK;
    size_t layers = 0;
    for (const xmlNode *node = page->children; status == DUCT_OK && node != NULL; node = node->next) {
        if (is_element(node, "layer")) {
            status = read_layer(r, node, number, ++layers, error);
        }
    }
    r->width = fmax(r->width, size[0]);
    r->top += size[1];
    if (status == DUCT_OK &&
        (!isfinite(r->width * PIXELS_PER_POINT) || !isfinite(r->top * PIXELS_PER_POINT))) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: page %zu is too large", xmlGetLineNo(page),
                         number);
    }
    return status;
}

static duct_status read_document(const duct_context *context, const char *data, size_t size,
                                 duct_drawing *drawing, duct_error *error)
{
    xmlDoc *document = NULL;
    duct_status status = duct_xml_parse(data, size, &document, error);
    if (status != DUCT_OK) {
        return status;
    }
    reader r = {.allocator = duct_allocator_of(context), .drawing = drawing, .full_width = 1};
    duct_text_init(&r.group, r.allocator);
    const xmlNode *root = xmlDocGetRootElement(document);
    if (!is_element(root, "xournal")) {
        status =
            duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the root element is <%.40s> instead of <xournal>",
                      xmlGetLineNo(root), (const char *)root->name);
    } else if (attribute(root, "creator") == NULL) {
        r.full_width = XOURNAL_FULL_WIDTH; /* only Xournal++ and its kin name themselves */
    }
    size_t pages = 0;
    for (const xmlNode *node = root->children; status == DUCT_OK && node != NULL; node = node->next) {
        if (is_element(node, "page")) {
            status = read_page(&r, node, ++pages, error);
        }
    }
    if (status == DUCT_OK) {
        duct_drawing_set_page(drawing, r.width * PIXELS_PER_POINT, r.top * PIXELS_PER_POINT);
    }
    duct_text_free(&r.group);
    duct_release(r.allocator, r.numbers);
    xmlFreeDoc(document);
    return status;
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)options;
    if (!duct_gzip_is(data, size)) {
        return read_document(context, data, size, drawing, error);
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    char *unpacked = NULL;
    duct_status status =
        duct_gzip_unpack(allocator, data, size, DUCT_MAX_FILE_BYTES, &unpacked, &size, error);
    if (status == DUCT_OK) {
        status = read_document(context, unpacked, size, drawing, error);
        duct_release(allocator, unpacked);
    }
    return status;
}

const duct_format_impl duct_format_xopp = {
    {"xopp", "Xournal++ notes", "xopp xoj", true, false},
    sniff,
    read,
    NULL,
};
