/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_selector.h"

#include "formats/svg_css.h"

#include <ductus/drawing.h>
#include <string.h>

static bool is_name(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || (unsigned char)c >= 0x80;
}

/* The next simple selector of a compound, cut off its front: its mark ('.', '#', '*' or 0 for a type) and
 * name. */
static bool next_simple(duct_slice *rest, char *mark, duct_slice *name)
{
    if (rest->size == 0) {
        return false;
    }
    char c = rest->text[0];
    *mark = c == '.' || c == '#' || c == '*' ? c : '\0';
    size_t begin = *mark != '\0' ? 1 : 0, end = begin;
    while (*mark != '*' && end < rest->size && is_name(rest->text[end])) {
        end++;
    }
    *name = (duct_slice){rest->text + begin, end - begin};
    *rest = (duct_slice){rest->text + end, rest->size - end};
    return true;
}

/* Adds the compound's specificity; false where it is malformed or not supported. */
static bool weigh(duct_slice compound, unsigned counts[3])
{
    char mark;
    duct_slice name;
    while (next_simple(&compound, &mark, &name)) {
        if (mark != '*' && name.size == 0) {
            return false;
        }
        if (mark != '*') {
            unsigned *count = &counts[mark == '#' ? 0 : mark == '.' ? 1 : 2];
            *count += *count < 255 ? 1 : 0;
        }
    }
    return true;
}

bool duct_css_selector_parse(duct_slice text, duct_css_selector *selector)
{
    *selector = (duct_css_selector){.count = 0};
    unsigned counts[3] = {0, 0, 0};
    bool child = false;
    text = duct_slice_trim(text);
    while (text.size > 0) {
        if (text.text[0] == '>') {
            if (child || selector->count == 0) {
                return false;
            }
            child = true;
            text = duct_slice_trim((duct_slice){text.text + 1, text.size - 1});
            continue;
        }
        size_t size = 0;
        while (size < text.size && !duct_is_space(text.text[size]) && text.text[size] != '>') {
            size++;
        }
        duct_slice compound = {text.text, size};
        if (selector->count == DUCT_CSS_COMPOUNDS || !weigh(compound, counts)) {
            return false;
        }
        selector->compound[selector->count] = compound;
        selector->child[selector->count++] = child;
        child = false;
        text = duct_slice_trim((duct_slice){text.text + size, text.size - size});
    }
    selector->specificity = counts[0] << 16 | counts[1] << 8 | counts[2];
    return selector->count > 0 && !child;
}

static bool has_class(const xmlNode *element, duct_slice name)
{
    duct_slice rest = duct_slice_of(duct_svg_attribute(element, "class")), word;
    while (rest.size > 0 && duct_slice_word(&rest, &word)) {
        if (word.size == name.size && memcmp(word.text, name.text, name.size) == 0) {
            return true;
        }
    }
    return false;
}

static bool compound_matches(duct_slice compound, const xmlNode *element)
{
    char mark;
    duct_slice name;
    while (next_simple(&compound, &mark, &name)) {
        bool matches = mark == '*'   ? true
                       : mark == '#' ? duct_slice_equal(name, duct_svg_attribute(element, "id"))
                       : mark == '.' ? has_class(element, name)
                                     : duct_slice_equal(name, (const char *)element->name);
        if (!matches) {
            return false;
        }
    }
    return true;
}

bool duct_css_selector_matches(const duct_css_selector *selector, const xmlNode *element)
{
    int last = selector->count - 1;
    if (!compound_matches(selector->compound[last], element)) {
        return false;
    }
    if (last == 0) {
        return true;
    }
    const xmlNode *chain[DUCT_MAX_GROUP_DEPTH + 1];
    int depth = 0;
    for (const xmlNode *node = element; node != NULL && node->type == XML_ELEMENT_NODE; node = node->parent) {
        if (depth > DUCT_MAX_GROUP_DEPTH) {
            return false;
        }
        chain[depth++] = node;
    }
    /* From the root down: bit i says that compounds 0..i match a chain that ends at the parent (`parent`) or
     * at any ancestor (`above`). One pass, whatever the mix of combinators. */
    unsigned above = 0, parent = 0;
    for (int d = depth - 1; d >= 0; d--) {
        unsigned here = 0;
        for (int i = 0; i <= last; i++) {
            bool reached = i == 0 || ((selector->child[i] ? parent : above) >> (i - 1) & 1U) != 0;
            if (reached && compound_matches(selector->compound[i], chain[d])) {
                here |= 1U << i;
            }
        }
        above |= here;
        parent = here;
    }
    return (parent >> last & 1U) != 0;
}
