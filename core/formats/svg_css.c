/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_css.h"

#include "base/error.h"
#include "formats/svg_selector.h"

#include <string.h>

enum { MOST_RULES = 20000 };

static const char *const property_names[DUCT_SVG_PROPERTY_COUNT] = {
    "color",  "display",        "fill",         "fill-opacity", "font-size",     "opacity",   "stop-color",
    "stroke", "stroke-opacity", "stroke-width", "transform",    "vector-effect", "visibility"};

/* A selector with the declarations that it governs. */
typedef struct {
    duct_css_selector selector;
    size_t first, count; /* declarations */
} rule;

typedef struct {
    duct_svg_property property;
    duct_slice value;
    bool important;
} setting;

struct duct_css_sheet {
    const duct_allocator *allocator;
    char **texts; /* copies of the sources, which the slices point into */
    size_t text_count, text_capacity;
    rule *rules;
    size_t rule_count, rule_capacity;
    setting *settings;
    size_t setting_count, setting_capacity;
    bool important;
};

duct_svg_property duct_svg_property_of(duct_slice name)
{
    int property = 0;
    while (property < DUCT_SVG_PROPERTY_COUNT && !duct_slice_is(name, property_names[property])) {
        property++;
    }
    return (duct_svg_property)property;
}

const char *duct_svg_property_name(duct_svg_property property)
{
    return property_names[property];
}

const char *duct_svg_attribute(const xmlNode *element, const char *name)
{
    for (const xmlAttr *attribute = element->properties; attribute != NULL; attribute = attribute->next) {
        if (attribute->ns == NULL && strcmp((const char *)attribute->name, name) == 0) {
            const xmlNode *text = attribute->children;
            return text != NULL && text->content != NULL ? (const char *)text->content : "";
        }
    }
    return NULL;
}

/* The size of the text up to `stop` (0: never) outside of quotes, brackets and comments. */
static size_t extent(duct_slice text, char stop)
{
    int depth = 0;
    char quote = '\0';
    for (size_t i = 0; i < text.size; i++) {
        char c = text.text[i];
        if (quote != '\0') {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == stop && depth == 0) {
            return i;
        } else if (c == '(' || c == '{' || c == '[') {
            depth++;
        } else if ((c == ')' || c == '}' || c == ']') && depth > 0) {
            depth--;
        }
    }
    return text.size;
}

static duct_slice behind(duct_slice text, size_t size)
{
    size = size < text.size ? size : text.size;
    return (duct_slice){text.text + size, text.size - size};
}

/* Cuts "!important" off the value's end. */
static bool cut_important(duct_slice *value)
{
    const char *mark = memrchr(value->text, '!', value->size);
    if (mark == NULL) {
        return false;
    }
    size_t size = (size_t)(mark - value->text);
    if (!duct_slice_is(duct_slice_trim(behind(*value, size + 1)), "important")) {
        return false;
    }
    *value = duct_slice_trim((duct_slice){value->text, size});
    return true;
}

bool duct_css_next(duct_slice *rest, duct_css_declaration *declaration)
{
    while (rest->size > 0) {
        size_t size = extent(*rest, ';');
        duct_slice one = {rest->text, size};
        *rest = behind(*rest, size + 1);
        const char *colon = memchr(one.text, ':', one.size);
        if (colon == NULL) {
            continue;
        }
        size_t name_size = (size_t)(colon - one.text);
        declaration->name = duct_slice_trim((duct_slice){one.text, name_size});
        declaration->value = duct_slice_trim(behind(one, name_size + 1));
        declaration->important = cut_important(&declaration->value);
        if (declaration->name.size > 0 && declaration->value.size > 0) {
            return true;
        }
    }
    return false;
}

duct_status duct_css_sheet_new(const duct_allocator *allocator, duct_css_sheet **sheet, duct_error *error)
{
    duct_css_sheet *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = allocator;
    *sheet = made;
    return DUCT_OK;
}

void duct_css_sheet_free(duct_css_sheet *sheet)
{
    if (sheet == NULL) {
        return;
    }
    for (size_t i = 0; i < sheet->text_count; i++) {
        duct_release(sheet->allocator, sheet->texts[i]);
    }
    duct_release(sheet->allocator, sheet->texts);
    duct_release(sheet->allocator, sheet->rules);
    duct_release(sheet->allocator, sheet->settings);
    duct_release(sheet->allocator, sheet);
}

bool duct_css_sheet_important(const duct_css_sheet *sheet)
{
    return sheet->important;
}

static duct_status add_settings(duct_css_sheet *sheet, duct_slice block, duct_error *error)
{
    duct_css_declaration declaration;
    while (duct_css_next(&block, &declaration)) {
        duct_svg_property property = duct_svg_property_of(declaration.name);
        if (property == DUCT_SVG_PROPERTY_COUNT) {
            continue;
        }
        void *settings = sheet->settings;
        if (!duct_reserve(sheet->allocator, &settings, &sheet->setting_capacity, sheet->setting_count + 1,
                          sizeof(setting))) {
            return duct_fail_memory(error);
        }
        sheet->settings = settings;
        sheet->settings[sheet->setting_count++] =
            (setting){property, declaration.value, declaration.important};
        sheet->important = sheet->important || declaration.important;
    }
    return DUCT_OK;
}

/* A rule for each selector of the comma list. */
static duct_status add_rules(duct_css_sheet *sheet, duct_slice selectors, duct_slice block, duct_error *error)
{
    size_t first = sheet->setting_count;
    duct_status status = add_settings(sheet, block, error);
    while (status == DUCT_OK && sheet->setting_count > first && selectors.size > 0) {
        size_t size = extent(selectors, ',');
        rule made = {.first = first, .count = sheet->setting_count - first};
        bool known = duct_css_selector_parse((duct_slice){selectors.text, size}, &made.selector);
        selectors = behind(selectors, size + 1);
        if (!known) {
            continue;
        }
        if (sheet->rule_count >= MOST_RULES) {
            return duct_fail(error, DUCT_LIMIT, "the style sheets have more than %d rules", MOST_RULES);
        }
        void *rules = sheet->rules;
        if (!duct_reserve(sheet->allocator, &rules, &sheet->rule_capacity, sheet->rule_count + 1,
                          sizeof(rule))) {
            return duct_fail_memory(error);
        }
        sheet->rules = rules;
        sheet->rules[sheet->rule_count++] = made;
    }
    return status;
}

static bool media_matches(duct_slice query)
{
    query = duct_slice_trim(query);
    return query.size == 0 || duct_slice_is(query, "all") || duct_slice_is(query, "screen");
}

/* Blanks comments and the marks of XML comments, so that nothing below has to know them. */
static void blank_comments(char *text)
{
    for (char *s = text; *s != '\0';) {
        size_t length = 0;
        if (strncmp(s, "/*", 2) == 0) {
            char *end = strstr(s + 2, "*/");
            length = end != NULL ? (size_t)(end - s) + 2 : strlen(s);
        } else if (strncmp(s, "<!--", 4) == 0) {
            length = 4;
        } else if (strncmp(s, "-->", 3) == 0) {
            length = 3;
        }
        memset(s, ' ', length);
        s += length > 0 ? length : 1;
    }
}

static duct_status parse_sheet(duct_css_sheet *sheet, duct_slice rest, duct_error *error)
{
    duct_status status = DUCT_OK;
    rest = duct_slice_trim(rest);
    while (status == DUCT_OK && rest.size > 0) {
        if (rest.text[0] == '}') { /* the end of a media block that was entered, or a stray one */
            rest = duct_slice_trim(behind(rest, 1));
            continue;
        }
        size_t open = extent(rest, '{');
        size_t statement = rest.text[0] == '@' ? extent(rest, ';') : rest.size;
        if (statement < open) { /* @charset, @import, @namespace */
            rest = duct_slice_trim(behind(rest, statement + 1));
            continue;
        }
        duct_slice prelude = {rest.text, open};
        rest = behind(rest, open + 1);
        if (duct_slice_begins(prelude, "@media") && media_matches(behind(prelude, 6))) {
            rest = duct_slice_trim(rest);
            continue;
        }
        size_t close = extent(rest, '}');
        if (prelude.text[0] != '@') {
            status = add_rules(sheet, prelude, (duct_slice){rest.text, close}, error);
        }
        rest = duct_slice_trim(behind(rest, close + 1));
    }
    return status;
}

duct_status duct_css_sheet_add(duct_css_sheet *sheet, const char *text, duct_error *error)
{
    void *texts = sheet->texts;
    char *copy = duct_strdup(sheet->allocator, text);
    if (copy == NULL || !duct_reserve(sheet->allocator, &texts, &sheet->text_capacity, sheet->text_count + 1,
                                      sizeof(char *))) {
        duct_release(sheet->allocator, copy);
        return duct_fail_memory(error);
    }
    sheet->texts = texts;
    sheet->texts[sheet->text_count++] = copy;
    blank_comments(copy);
    return parse_sheet(sheet, duct_slice_of(copy), error);
}

enum { WEIGHT_INLINE = 1, WEIGHT_IMPORTANT = 2 };

static uint64_t weight_of(bool important, bool is_inline, uint32_t specificity)
{
    unsigned level = (important ? WEIGHT_IMPORTANT : 0U) | (is_inline ? WEIGHT_INLINE : 0U);
    return (uint64_t)level << 32 | specificity;
}

static void set(duct_css_values *values, duct_svg_property property, duct_slice value, uint64_t weight)
{
    if (weight >= values->weight[property]) {
        values->value[property] = value;
        values->weight[property] = weight;
    }
}

void duct_css_resolve(const duct_css_sheet *sheet, const xmlNode *element, duct_css_values *values)
{
    memset(values, 0, sizeof *values);
    const char *style = NULL;
    for (const xmlAttr *attribute = element->properties; attribute != NULL; attribute = attribute->next) {
        const char *text = attribute->children != NULL ? (const char *)attribute->children->content : NULL;
        if (attribute->ns != NULL || text == NULL) {
            continue;
        }
        duct_svg_property property = duct_svg_property_of(duct_slice_of((const char *)attribute->name));
        if (property != DUCT_SVG_PROPERTY_COUNT) {
            set(values, property, duct_slice_trim(duct_slice_of(text)), 0);
        } else if (strcmp((const char *)attribute->name, "style") == 0) {
            style = text;
        }
    }
    for (size_t i = 0; i < sheet->rule_count; i++) {
        const rule *r = &sheet->rules[i];
        if (!duct_css_selector_matches(&r->selector, element)) {
            continue;
        }
        for (size_t k = r->first; k < r->first + r->count; k++) {
            const setting *s = &sheet->settings[k];
            set(values, s->property, s->value, weight_of(s->important, false, r->selector.specificity));
        }
    }
    duct_slice rest = duct_slice_of(style);
    duct_css_declaration declaration;
    while (rest.size > 0 && duct_css_next(&rest, &declaration)) {
        duct_svg_property property = duct_svg_property_of(declaration.name);
        if (property != DUCT_SVG_PROPERTY_COUNT) {
            set(values, property, declaration.value, weight_of(declaration.important, true, 0));
        }
    }
}
