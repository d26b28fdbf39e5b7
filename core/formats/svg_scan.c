/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_scan.h"

#include "base/number.h"

#include <math.h>
#include <string.h>
#include <strings.h>

duct_slice duct_slice_of(const char *text)
{
    return (duct_slice){text, text != NULL ? strlen(text) : 0};
}

bool duct_is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f';
}

duct_slice duct_slice_trim(duct_slice slice)
{
    while (slice.size > 0 && duct_is_space(slice.text[0])) {
        slice.text++;
        slice.size--;
    }
    while (slice.size > 0 && duct_is_space(slice.text[slice.size - 1])) {
        slice.size--;
    }
    return slice;
}

/* ASCII only: tolower() would ask the locale. */
static char lower(char c)
{
    return c >= 'A' && c <= 'Z' ? (char)(c - 'A' + 'a') : c;
}

bool duct_slice_begins(duct_slice slice, const char *word)
{
    size_t i = 0;
    for (; word[i] != '\0'; i++) {
        if (i >= slice.size || lower(slice.text[i]) != word[i]) {
            return false;
        }
    }
    return true;
}

bool duct_slice_is(duct_slice slice, const char *word)
{
    return slice.size == strlen(word) && duct_slice_begins(slice, word);
}

bool duct_slice_equal(duct_slice slice, const char *text)
{
    return text != NULL && strlen(text) == slice.size && memcmp(slice.text, text, slice.size) == 0;
}

bool duct_slice_word(duct_slice *rest, duct_slice *word)
{
    duct_slice trimmed = duct_slice_trim(*rest);
    size_t size = 0;
    while (size < trimmed.size && !duct_is_space(trimmed.text[size])) {
        size++;
    }
    *word = (duct_slice){trimmed.text, size};
    *rest = (duct_slice){trimmed.text + size, trimmed.size - size};
    return size > 0;
}

bool duct_slice_number(duct_slice *rest, double *number)
{
    duct_slice trimmed = duct_slice_trim(*rest);
    const char *end;
    double value;
    if (trimmed.size == 0 || !duct_number_scan(trimmed.text, &end, &value) || !isfinite(value) ||
        end > trimmed.text + trimmed.size) {
        return false;
    }
    *number = value;
    *rest = (duct_slice){end, trimmed.size - (size_t)(end - trimmed.text)};
    return true;
}

void duct_skip_space(const char **s)
{
    while (duct_is_space(**s)) {
        (*s)++;
    }
}

bool duct_skip_comma(const char **s)
{
    duct_skip_space(s);
    if (**s != ',') {
        return false;
    }
    (*s)++;
    duct_skip_space(s);
    return true;
}
