/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_TEXT_H
#define DUCTUS_BASE_TEXT_H

#include "base/memory.h"

#include <stdbool.h>
#include <stddef.h>

/* A growing text or byte buffer. A failed allocation sets `failed` and makes all further calls do nothing, so
 * that a writer checks once at its end. `data` is always terminated once something was added. */
typedef struct duct_text {
    const duct_allocator *allocator;
    char *data;
    size_t size; /* bytes, without the terminating 0 */
    size_t capacity;
    bool failed;
} duct_text;

void duct_text_init(duct_text *text, const duct_allocator *allocator);
void duct_text_free(duct_text *text);
void duct_text_add(duct_text *text, const char *string);
void duct_text_add_bytes(duct_text *text, const void *bytes, size_t size);
void duct_text_addf(duct_text *text, const char *format, ...) DUCT_PRINTF(2, 3);

/* A number with at most `digits` significant digits, always with a decimal point whatever the locale; 0
 * digits: as few as read back to the same number. */
void duct_text_add_number(duct_text *text, double number, int digits);

/* A number with at most `decimals` digits behind the point, no trailing zeros, "-0" as "0". */
void duct_text_add_fixed(duct_text *text, double number, int decimals);

/* The text with the five special characters of XML escaped, and characters that XML forbids left out. */
void duct_text_add_xml(duct_text *text, const char *string);

/* The text as a JSON string with its quotes; bytes that are no UTF-8 become U+FFFD. */
void duct_text_add_json(duct_text *text, const char *string);

/* The bytes of the UTF-8 character at `string`; 0 where there is none, or the end. */
size_t duct_utf8_character(const char *string);

/* Takes the data out: the caller owns it; NULL where an allocation failed. An empty text gives "". */
char *duct_text_take(duct_text *text, size_t *size);

#endif
