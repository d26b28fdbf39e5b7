/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/text.h"

#include "base/number.h"

#include <math.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

void duct_text_init(duct_text *text, const duct_allocator *allocator)
{
    memset(text, 0, sizeof *text);
    text->allocator = allocator;
}

void duct_text_free(duct_text *text)
{
    duct_release(text->allocator, text->data);
    duct_text_init(text, text->allocator);
}

static bool reserve(duct_text *text, size_t more)
{
    if (text->failed) {
        return false;
    }
    void *data = text->data;
    if (more > SIZE_MAX / 4 ||
        !duct_reserve(text->allocator, &data, &text->capacity, text->size + more + 1, 1)) {
        text->failed = true;
        return false;
    }
    text->data = data;
    return true;
}

void duct_text_add_bytes(duct_text *text, const void *bytes, size_t size)
{
    if (reserve(text, size)) {
        memcpy(text->data + text->size, bytes, size);
        text->size += size;
        text->data[text->size] = '\0';
    }
}

void duct_text_add(duct_text *text, const char *string)
{
    duct_text_add_bytes(text, string, strlen(string));
}

void duct_text_addf(duct_text *text, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(NULL, 0, format, arguments);
    va_end(arguments);
    if (length < 0) {
        text->failed = true;
    }
    if (length < 0 || !reserve(text, (size_t)length)) {
        return;
    }
    va_start(arguments, format);
    vsnprintf(text->data + text->size, (size_t)length + 1, format, arguments);
    va_end(arguments);
    text->size += (size_t)length;
}

void duct_text_add_number(duct_text *text, double number, int digits)
{
    char buffer[DUCT_NUMBER_SIZE];
    duct_number_print(buffer, number, digits);
    duct_text_add(text, buffer);
}

void duct_text_add_fixed(duct_text *text, double number, int decimals)
{
    char buffer[DUCT_NUMBER_SIZE];
    duct_number_print_fixed(buffer, number, decimals);
    duct_text_add(text, buffer);
}

size_t duct_utf8_character(const char *string)
{
    const unsigned char *u = (const unsigned char *)string;
    if (u[0] == 0) {
        return 0;
    }
    size_t size = u[0] < 0x80 ? 1 : u[0] < 0xc2 ? 0 : u[0] < 0xe0 ? 2 : u[0] < 0xf0 ? 3 : u[0] < 0xf5 ? 4 : 0;
    for (size_t i = 1; i < size; i++) {
        if ((u[i] & 0xc0) != 0x80) {
            return 0;
        }
    }
    bool overlong = (u[0] == 0xe0 && u[1] < 0xa0) || (u[0] == 0xf0 && u[1] < 0x90);
    bool surrogate = u[0] == 0xed && u[1] >= 0xa0;
    bool beyond = u[0] == 0xf4 && u[1] >= 0x90;
    return overlong || surrogate || beyond ? 0 : size;
}

/* The same for the characters that XML allows. */
static size_t xml_character(const char *s)
{
    const unsigned char *u = (const unsigned char *)s;
    size_t size = duct_utf8_character(s);
    bool control = u[0] < 0x20 && u[0] != '\t' && u[0] != '\n';
    bool none = size == 3 && u[0] == 0xef && u[1] == 0xbf && u[2] >= 0xbe;
    return control || none ? 0 : size;
}

void duct_text_add_xml(duct_text *text, const char *string)
{
    for (const char *s = string; *s != '\0'; s++) {
        switch (*s) {
        case '&':
            duct_text_add(text, "&amp;");
            break;
        case '<':
            duct_text_add(text, "&lt;");
            break;
        case '>':
            duct_text_add(text, "&gt;");
            break;
        case '"':
            duct_text_add(text, "&quot;");
            break;
        case '\'':
            duct_text_add(text, "&apos;");
            break;
        default:
            if (xml_character(s) > 0) {
                size_t size = xml_character(s);
                duct_text_add_bytes(text, s, size);
                s += size - 1;
            }
        }
    }
}

void duct_text_add_json(duct_text *text, const char *string)
{
    duct_text_add(text, "\"");
    for (const char *s = string; *s != '\0';) {
        size_t size = duct_utf8_character(s);
        if (size == 0) {
            duct_text_add(text, "\xef\xbf\xbd");
        } else if ((unsigned char)*s < 0x20) {
            duct_text_addf(text, "\\u%04x", (unsigned)*s);
        } else {
            if (*s == '"' || *s == '\\') {
                duct_text_add(text, "\\");
            }
            duct_text_add_bytes(text, s, size);
        }
        s += size > 0 ? size : 1;
    }
    duct_text_add(text, "\"");
}

char *duct_text_take(duct_text *text, size_t *size)
{
    duct_text_add_bytes(text, "", 0);
    if (text->failed) {
        duct_text_free(text);
        return NULL;
    }
    char *data = text->data;
    if (size != NULL) {
        *size = text->size;
    }
    duct_text_init(text, text->allocator);
    return data;
}
