/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scalable Vector Graphics: SVG 1.1 and the parts of SVG 2 that drawings use. What is read and written, and
 * how, is told in svg_private.h. */
#include "formats/svg_private.h"

#include <string.h>

/* The file's characters, as far as ASCII goes, in encodings of one or two bytes. */
typedef struct {
    const char *data;
    size_t size, stride, at;
} characters;

static char character(const characters *c, size_t ahead)
{
    size_t index = (c->at + ahead) * c->stride;
    return index < c->size ? c->data[index] : '\0';
}

static bool begins(const characters *c, const char *word)
{
    size_t i = 0;
    while (word[i] != '\0' && character(c, i) == word[i]) {
        i++;
    }
    return word[i] == '\0';
}

static void skip_behind(characters *c, const char *word)
{
    while (character(c, 0) != '\0' && !begins(c, word)) {
        c->at++;
    }
    c->at += character(c, 0) != '\0' ? strlen(word) : 0;
}

/* A document type with its internal subset, in which brackets may stand in quotes and comments. */
static void skip_doctype(characters *c)
{
    int depth = 0;
    for (char here = character(c, 0); here != '\0' && !(here == '>' && depth == 0); here = character(c, 0)) {
        if (begins(c, "<!--")) {
            skip_behind(c, "-->");
            continue;
        }
        depth += here == '[' ? 1 : here == ']' ? -1 : 0;
        c->at++;
        if (here == '"' || here == '\'') {
            skip_behind(c, here == '"' ? "\"" : "'");
        }
    }
    c->at += character(c, 0) != '\0';
}

/* True where the first element is <svg> or <prefix:svg>. */
static bool sniff(const char *data, size_t size)
{
    characters c = {data, size, 1, 0};
    if (size >= 2 && memcmp(data, "\x1f\x8b", 2) == 0) {
        return true; /* compressed: no other format is, and the reader says what to do */
    }
    if (size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0) {
        c.at = 3;
    } else if (size >= 4 && (memcmp(data, "\xff\xfe", 2) == 0 || (data[0] == '<' && data[1] == '\0'))) {
        c = (characters){data, size, 2, data[0] == '<' ? 0 : 1};
    } else if (size >= 4 && (memcmp(data, "\xfe\xff", 2) == 0 || (data[0] == '\0' && data[1] == '<'))) {
        c = (characters){data + 1, size - 1, 2, data[0] == '\0' ? 0 : 1};
    }
    for (;;) {
        while (duct_is_space(character(&c, 0))) {
            c.at++;
        }
        if (begins(&c, "<?")) {
            skip_behind(&c, "?>");
        } else if (begins(&c, "<!--")) {
            skip_behind(&c, "-->");
        } else if (begins(&c, "<!DOCTYPE")) {
            skip_doctype(&c);
        } else {
            break;
        }
    }
    if (character(&c, 0) != '<') {
        return false;
    }
    c.at++;
    size_t name = 0;
    while (strchr(" \t\r\n/>", character(&c, name)) == NULL) {
        name++;
        if (character(&c, name - 1) == ':') {
            c.at += name;
            name = 0;
        }
    }
    return name == 3 && begins(&c, "svg");
}

const duct_format_impl duct_format_svg = {
    {"svg", "Scalable Vector Graphics", "svg", true, true}, sniff, duct_svg_read, duct_svg_write};
