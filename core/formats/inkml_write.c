/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writing InkML. X and Y are written in drawing pixels, as "dev" units whose `resolution` (pixels an inch) is
 * stated: every reader gets the true lengths, and no digit is lost. Time is in seconds, angles in radians,
 * force is 0..1; OR turns counter-clockwise, so that it is the negative of twist. Each set of channels that
 * occurs is a context, each style a brush. What InkML has no words for (stroke ids that are no XML ids,
 * closed strokes, the page, colours finer than 8 bit) is written in our own namespace, where other readers
 * pass it by. */
#include "base/error.h"
#include "base/number.h"
#include "formats/inkml_private.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CHANNEL_SETS = 1 << DUCT_CHANNEL_COUNT, DEEPEST_GROUP = 200 };

typedef struct {
    const duct_drawing *drawing;
    duct_text *out;
    duct_stroke_style *styles; /* those that occur, sorted, each once */
    size_t style_count;
} writer;

/* Text for an attribute or an element. The characters that an XML parser would turn into others are written
 * as references. */
static void add_escaped(duct_text *out, const char *text)
{
    while (*text != '\0') {
        size_t plain = strcspn(text, "\t\n\r");
        char part[256];
        size_t size = plain < sizeof part - 1 ? plain : sizeof part - 1;
        /* Not in the middle of a character. */
        while (size > 0 && size < plain && ((unsigned char)text[size] & 0xc0) == 0x80) {
            size--;
        }
        size = size == 0 && plain > 0 ? (plain < sizeof part - 1 ? plain : sizeof part - 1) : size;
        memcpy(part, text, size);
        part[size] = '\0';
        duct_text_add_xml(out, part);
        text += size;
        if (size == plain && *text != '\0') {
            duct_text_addf(out, "&#%d;", *text);
            text++;
        }
    }
}

static unsigned channel_set(const duct_stroke *stroke)
{
    unsigned set = 0;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        set |= duct_stroke_values(stroke, (duct_channel)c) != NULL ? 1u << c : 0;
    }
    return set;
}

static int compare_floats(double a, double b)
{
    return (a > b) - (a < b);
}

static int compare_styles(const void *a, const void *b)
{
    const duct_stroke_style *l = a, *r = b;
    int order = compare_floats(l->red, r->red);
    order = order != 0 ? order : compare_floats(l->green, r->green);
    order = order != 0 ? order : compare_floats(l->blue, r->blue);
    order = order != 0 ? order : compare_floats(l->opacity, r->opacity);
    return order != 0 ? order : compare_floats(l->width, r->width);
}

/* ---- definitions ---- */

static void add_channel(duct_text *out, duct_channel channel)
{
    static const char *const attributes[DUCT_CHANNEL_COUNT] = {
        "name=\"X\" type=\"double\" units=\"dev\"",
        "name=\"Y\" type=\"double\" units=\"dev\"",
        "name=\"T\" type=\"double\" units=\"s\"",
        "name=\"F\" type=\"double\" min=\"0\" max=\"1\" units=\"dev\"",
        "name=\"OTx\" type=\"double\" units=\"rad\"",
        "name=\"OTy\" type=\"double\" units=\"rad\"",
        "name=\"OR\" type=\"double\" units=\"rad\"",
    };
    duct_text_addf(out, "          <channel %s/>\n", attributes[channel]);
}

static void add_context(const writer *w, unsigned set)
{
    duct_text_addf(w->out, "    <context xml:id=\"context%u\">\n      <inkSource xml:id=\"source%u\">\n", set,
                   set);
    duct_text_addf(w->out, "        <traceFormat xml:id=\"format%u\">\n", set);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        if (set & 1u << c) {
            add_channel(w->out, (duct_channel)c);
        }
    }
    duct_text_add(w->out, "        </traceFormat>\n        <channelProperties>\n");
    for (int axis = 0; axis < 2; axis++) {
        duct_text_addf(w->out, "          <channelProperty channel=\"%s\" name=\"resolution\" value=\"",
                       axis == 0 ? "X" : "Y");
        duct_text_add_number(w->out, duct_drawing_resolution(w->drawing), 0);
        duct_text_add(w->out, "\" units=\"1/in\"/>\n");
    }
    duct_text_add(w->out, "        </channelProperties>\n      </inkSource>\n    </context>\n");
}

/* Adds ` ductus:NAME="VALUE"`. */
static void add_own_number(duct_text *out, const char *name, double value)
{
    duct_text_addf(out, " ductus:%s=\"", name);
    duct_text_add_number(out, value, 0);
    duct_text_add(out, "\"");
}

static int byte_of(double value)
{
    return (int)lround(fmin(fmax(value, 0), 1) * 255);
}

static void add_brush(const writer *w, size_t index)
{
    const duct_stroke_style *style = &w->styles[index];
    const float parts[3] = {style->red, style->green, style->blue};
    int color[3], transparency = byte_of(1 - (double)style->opacity);
    bool exact = true;
    for (int i = 0; i < 3; i++) {
        color[i] = byte_of(parts[i]);
        exact = exact && (float)(color[i] / 255.0) == parts[i];
    }
    duct_text_addf(w->out, "    <brush xml:id=\"brush%zu\"", index);
    if (!exact) {
        duct_text_add(w->out, " ductus:color=\"");
        for (int i = 0; i < 3; i++) {
            duct_text_add(w->out, i > 0 ? " " : "");
            duct_text_add_number(w->out, parts[i], 9);
        }
        duct_text_add(w->out, "\"");
    }
    if ((float)(1 - transparency / 255.0) != style->opacity) {
        duct_text_add(w->out, " ductus:opacity=\"");
        duct_text_add_number(w->out, style->opacity, 9);
        duct_text_add(w->out, "\"");
    }
    double unit = duct_inkml_length_unit("cm", duct_drawing_resolution(w->drawing)),
           width = style->width / unit;
    if (width * unit != style->width) {
        add_own_number(w->out, "width", style->width);
    }
    duct_text_addf(w->out, ">\n      <brushProperty name=\"color\" value=\"#%02X%02X%02X\"/>\n",
                   (unsigned)color[0], (unsigned)color[1], (unsigned)color[2]);
    duct_text_addf(w->out, "      <brushProperty name=\"transparency\" value=\"%d\"/>\n", transparency);
    for (int axis = 0; axis < 2 && style->width > 0; axis++) {
        duct_text_addf(w->out, "      <brushProperty name=\"%s\" value=\"", axis == 0 ? "width" : "height");
        duct_text_add_number(w->out, width, 0);
        duct_text_add(w->out, "\" units=\"cm\"/>\n");
    }
    duct_text_add(w->out, "    </brush>\n");
}

/* Collects the styles that occur. False when there is no memory. */
static bool collect_styles(writer *w, const duct_allocator *allocator)
{
    size_t count = duct_drawing_stroke_count(w->drawing), kept = 0;
    w->styles = duct_alloc(allocator, count, sizeof *w->styles);
    if (w->styles == NULL) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        w->styles[i] = duct_stroke_get_style(duct_drawing_stroke(w->drawing, i));
    }
    if (count > 0) {
        qsort(w->styles, count, sizeof *w->styles, compare_styles);
    }
    for (size_t i = 0; i < count; i++) {
        if (kept == 0 || compare_styles(&w->styles[i], &w->styles[kept - 1]) != 0) {
            w->styles[kept++] = w->styles[i];
        }
    }
    w->style_count = kept;
    return true;
}

static void add_definitions(const writer *w)
{
    bool used[CHANNEL_SETS] = {false};
    for (size_t i = 0; i < duct_drawing_stroke_count(w->drawing); i++) {
        used[channel_set(duct_drawing_stroke(w->drawing, i))] = true;
    }
    duct_text_add(w->out, "  <definitions>\n");
    for (unsigned set = 0; set < CHANNEL_SETS; set++) {
        if (used[set]) {
            add_context(w, set);
        }
    }
    for (size_t i = 0; i < w->style_count; i++) {
        add_brush(w, i);
    }
    duct_text_add(w->out, "  </definitions>\n");
}

static void add_annotations(const writer *w)
{
    const char *key, *value;
    for (size_t i = 0; duct_drawing_annotation_at(w->drawing, i, &key, &value); i++) {
        duct_text_add(w->out, "  <annotation type=\"");
        add_escaped(w->out, key);
        duct_text_add(w->out, "\">");
        add_escaped(w->out, value);
        duct_text_add(w->out, "</annotation>\n");
    }
    duct_text_add(w->out,
                  "  <annotationXML type=\"" DUCT_INKML_OWN_NAMESPACE "\">\n    <ductus:page width=\"");
    duct_text_add_number(w->out, duct_drawing_width(w->drawing), 0);
    duct_text_add(w->out, "\" height=\"");
    duct_text_add_number(w->out, duct_drawing_height(w->drawing), 0);
    duct_text_add(w->out, "\" resolution=\"");
    duct_text_add_number(w->out, duct_drawing_resolution(w->drawing), 0);
    duct_text_add(w->out, "\"/>\n  </annotationXML>\n");
}

/* ---- groups and traces ---- */

/* The length of the path's first `depth` parts, and how many there are of them. */
static size_t path_prefix(const char *path, size_t depth, size_t *found)
{
    size_t length = 0;
    *found = 0;
    if (*path == '\0') {
        return 0;
    }
    while (*found < depth) {
        length += strcspn(path + length, "/");
        ++*found;
        if (path[length] == '\0' || *found == depth) {
            break;
        }
        length++;
    }
    return length;
}

/* How many outer groups two paths share. */
static size_t shared_depth(const char *a, const char *b)
{
    size_t depth = 0;
    for (;;) {
        size_t in_a, in_b;
        size_t length_a = path_prefix(a, depth + 1, &in_a), length_b = path_prefix(b, depth + 1, &in_b);
        if (in_a != depth + 1 || in_b != depth + 1 || length_a != length_b || memcmp(a, b, length_a) != 0) {
            return depth;
        }
        depth++;
    }
}

/* Closes the groups of one path and opens those of another, as far as they differ. Beyond DEEPEST_GROUP the
 * rest of the path is one name with slashes in it, which reads back as the same path. */
static void change_group(duct_text *out, const char *from, const char *to)
{
    size_t open, wanted, shared = shared_depth(from, to);
    path_prefix(from, DEEPEST_GROUP, &open);
    path_prefix(to, DEEPEST_GROUP, &wanted);
    if (shared >= DEEPEST_GROUP) {
        shared = strcmp(from, to) == 0 ? DEEPEST_GROUP : DEEPEST_GROUP - 1;
    }
    for (size_t i = shared; i < open; i++) {
        duct_text_add(out, "  </traceGroup>\n");
    }
    for (size_t depth = shared; depth < wanted; depth++) {
        size_t found, begin = depth > 0 ? path_prefix(to, depth, &found) + 1 : 0;
        size_t end = depth + 1 == DEEPEST_GROUP ? strlen(to) : path_prefix(to, depth + 1, &found);
        duct_text_add(out, "  <traceGroup>\n    <annotation type=\"label\">");
        duct_text name;
        duct_text_init(&name, out->allocator);
        duct_text_add_bytes(&name, to + begin, end - begin);
        if (name.failed) {
            out->failed = true;
        } else {
            add_escaped(out, name.data);
        }
        duct_text_free(&name);
        duct_text_add(out, "</annotation>\n");
    }
}

static void add_samples(duct_text *out, const duct_stroke *stroke)
{
    const double *values[DUCT_CHANNEL_COUNT];
    int channels[DUCT_CHANNEL_COUNT], count = 0;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        values[count] = duct_stroke_values(stroke, (duct_channel)c);
        channels[count] = c;
        count += values[count] != NULL;
    }
    for (size_t i = 0; i < duct_stroke_size(stroke) && !out->failed; i++) {
        for (int c = 0; c < count; c++) {
            double value = channels[c] == DUCT_TWIST ? 0 - values[c][i] : values[c][i];
            duct_text_add_bytes(out, c > 0 ? " " : i > 0 ? ",\n" : "", c > 0 ? 1 : i > 0 ? 2 : 0);
            duct_text_add_number(out, value, 0);
        }
    }
}

static void add_trace(const writer *w, const duct_stroke *stroke)
{
    duct_stroke_style style = duct_stroke_get_style(stroke);
    const duct_stroke_style *found =
        bsearch(&style, w->styles, w->style_count, sizeof *w->styles, compare_styles);
    size_t brush = found != NULL ? (size_t)(found - w->styles) : 0;
    duct_text_addf(w->out, "  <trace contextRef=\"#context%u\" brushRef=\"#brush%zu\" ductus:id=\"",
                   channel_set(stroke), brush);
    add_escaped(w->out, duct_stroke_id(stroke));
    duct_text_add(w->out, duct_stroke_closed(stroke) ? "\" ductus:closed=\"true\">" : "\">");
    add_samples(w->out, stroke);
    duct_text_add(w->out, "</trace>\n");
}

duct_status duct_inkml_write(const duct_context *context, const duct_drawing *drawing, duct_text *out,
                             duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    writer w = {drawing, out, NULL, 0};
    if (!collect_styles(&w, allocator)) {
        return duct_fail_memory(error);
    }
    duct_text_add(out, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ink xmlns=\"" DUCT_INKML_NAMESPACE
                       "\" xmlns:ductus=\"" DUCT_INKML_OWN_NAMESPACE "\">\n");
    add_annotations(&w);
    add_definitions(&w);
    const char *group = "";
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing) && !out->failed; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        if (strcmp(group, duct_stroke_group(stroke)) != 0) {
            change_group(out, group, duct_stroke_group(stroke));
            group = duct_stroke_group(stroke);
        }
        add_trace(&w, stroke);
    }
    change_group(out, group, "");
    duct_text_add(out, "</ink>\n");
    duct_release(allocator, w.styles);
    return out->failed ? duct_fail_memory(error) : DUCT_OK;
}
