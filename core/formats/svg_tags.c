/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_tags.h"

#include "formats/svg_document.h"

#include <string.h>

typedef struct {
    const char *data;
    size_t size, at;
    duct_svg_tag *tags;
    size_t count, capacity;
    size_t *open; /* indices of the elements that are open here */
    size_t depth, open_capacity;
    const duct_allocator *allocator;
    bool failed;
} scanner;

static bool here(const scanner *s, const char *word)
{
    size_t length = strlen(word);
    return s->size - s->at >= length && memcmp(s->data + s->at, word, length) == 0;
}

static bool skip_behind(scanner *s, const char *word)
{
    const char *found = memmem(s->data + s->at, s->size - s->at, word, strlen(word));
    if (found == NULL) {
        return false;
    }
    s->at = (size_t)(found - s->data) + strlen(word);
    return true;
}

/* To the '>' that is not in quotes. */
static bool skip_tag(scanner *s)
{
    char quote = '\0';
    for (; s->at < s->size; s->at++) {
        char c = s->data[s->at];
        if (quote != '\0') {
            quote = c == quote ? '\0' : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '>') {
            s->at++;
            return true;
        }
    }
    return false;
}

static bool skip_doctype(scanner *s)
{
    bool subset = false;
    while (s->at < s->size) {
        char c = s->data[s->at];
        if (here(s, "<!--")) {
            if (!skip_behind(s, "-->")) {
                return false;
            }
        } else if (here(s, "<?")) {
            if (!skip_behind(s, "?>")) {
                return false;
            }
        } else if (c == '"' || c == '\'') {
            s->at++;
            if (!skip_behind(s, c == '"' ? "\"" : "'")) {
                return false;
            }
        } else if (c == '>' && !subset) {
            s->at++;
            return true;
        } else {
            subset = c == '[' ? true : c == ']' ? false : subset;
            s->at++;
        }
    }
    return false;
}

static bool start_tag(scanner *s)
{
    void *tags = s->tags, *open = s->open;
    bool room = duct_reserve(s->allocator, &tags, &s->capacity, s->count + 1, sizeof(duct_svg_tag)) &&
                duct_reserve(s->allocator, &open, &s->open_capacity, s->depth + 1, sizeof(size_t));
    s->tags = tags;
    s->open = open;
    if (!room) {
        s->failed = true;
        return false;
    }
    duct_svg_tag tag = {.begin = s->at, .name_end = s->at + 1};
    while (tag.name_end < s->size && strchr(" \t\r\n/>", s->data[tag.name_end]) == NULL) {
        tag.name_end++;
    }
    if (!skip_tag(s)) {
        return false;
    }
    tag.end = tag.close_begin = tag.close_end = s->at;
    tag.empty = s->data[s->at - 2] == '/';
    if (!tag.empty) {
        s->open[s->depth++] = s->count;
    }
    s->tags[s->count++] = tag;
    return true;
}

static bool end_tag(scanner *s)
{
    if (s->depth == 0) {
        return false;
    }
    duct_svg_tag *tag = &s->tags[s->open[--s->depth]];
    tag->close_begin = s->at;
    bool found = skip_behind(s, ">");
    tag->close_end = s->at;
    return found;
}

static bool scan(scanner *s)
{
    for (;;) {
        const char *next = memchr(s->data + s->at, '<', s->size - s->at);
        if (next == NULL) {
            return s->depth == 0;
        }
        s->at = (size_t)(next - s->data);
        bool understood = here(s, "<!--")        ? skip_behind(s, "-->")
                          : here(s, "<![CDATA[") ? skip_behind(s, "]]>")
                          : here(s, "<?")        ? skip_behind(s, "?>")
                          : here(s, "<!DOCTYPE") ? skip_doctype(s)
                          : here(s, "</")        ? end_tag(s)
                                                 : start_tag(s);
        if (!understood) {
            return false;
        }
    }
}

bool duct_svg_tags_scan(const duct_allocator *allocator, const char *data, size_t size, duct_svg_tag **tags,
                        size_t *count, bool *failed)
{
    scanner s = {.data = data, .size = size, .allocator = allocator};
    bool understood = scan(&s);
    duct_release(allocator, s.open);
    *failed = s.failed;
    if (!understood) {
        duct_release(allocator, s.tags);
        return false;
    }
    *tags = s.tags;
    *count = s.count;
    return true;
}

/* "prefix:name" or "name", as the tree has it. */
static bool has_name(const char *data, const duct_svg_tag *tag, const xmlNode *node)
{
    duct_slice written = {data + tag->begin + 1, tag->name_end - tag->begin - 1};
    if (node->ns != NULL && node->ns->prefix != NULL) {
        size_t prefix = strlen((const char *)node->ns->prefix);
        if (written.size <= prefix + 1 || memcmp(written.text, node->ns->prefix, prefix) != 0 ||
            written.text[prefix] != ':') {
            return false;
        }
        written = (duct_slice){written.text + prefix + 1, written.size - prefix - 1};
    }
    return duct_slice_equal(written, (const char *)node->name);
}

bool duct_svg_tags_match(const char *data, duct_svg_tag *tags, size_t count, xmlNode *root)
{
    size_t index = 0;
    for (xmlNode *node = root; node != NULL; node = duct_svg_next_element(node)) {
        if (index >= count || !has_name(data, &tags[index], node)) {
            return false;
        }
        node->_private = &tags[index++];
    }
    return index == count;
}

bool duct_svg_tag_attribute(const char *data, const duct_svg_tag *tag, size_t *begin, duct_slice *whole,
                            duct_slice *name)
{
    size_t at = *begin;
    while (duct_is_space(data[at])) {
        at++;
    }
    if (at >= tag->end || data[at] == '/' || data[at] == '>') {
        return false;
    }
    size_t name_begin = at;
    while (at < tag->end && data[at] != '=' && !duct_is_space(data[at])) {
        at++;
    }
    *name = (duct_slice){data + name_begin, at - name_begin};
    while (at < tag->end && data[at] != '"' && data[at] != '\'') {
        at++;
    }
    char quote = data[at++];
    while (at < tag->end && data[at] != quote) {
        at++;
    }
    at = at < tag->end ? at + 1 : tag->end;
    *whole = (duct_slice){data + *begin, at - *begin};
    *begin = at;
    return true;
}
