/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "glyphs.h"

#include <string.h>

const glyph *alphabet_find(const alphabet *letters, char letter)
{
    for (size_t i = 0; i < letters->count; i++) {
        if (letters->glyphs[i].letter == letter) {
            return &letters->glyphs[i];
        }
    }
    return NULL;
}

size_t glyph_strokes(const glyph *letter)
{
    size_t count = 1;
    for (const char *c = letter->form; *c != '\0'; c++) {
        count += *c == '/';
    }
    return count;
}

static const char *skip_spaces(const char *text)
{
    return text + strspn(text, " ");
}

/* A whole number; NULL where there is none. */
static const char *scan_integer(const char *text, int *number)
{
    const bool negative = *text == '-';
    text += negative;
    const size_t digits = strspn(text, "0123456789");
    if (digits == 0 || digits > 4) {
        return NULL;
    }
    *number = 0;
    for (size_t i = 0; i < digits; i++) {
        *number = 10 * *number + (text[i] - '0');
    }
    if (negative) {
        *number = -*number;
    }
    return text + digits;
}

bool glyph_write(const glyph *letter, size_t stroke, const glyph_place *place, action_plan *plan)
{
    const char *text = letter->form;
    for (; stroke > 0; stroke--) {
        text = strchr(text, '/');
        if (text == NULL) {
            return false;
        }
        text++;
    }
    for (text = skip_spaces(text); *text != '\0' && *text != '/'; text = skip_spaces(text)) {
        const size_t marks = strspn(text, "!=");
        const bool corner = memchr(text, '!', marks) != NULL;
        const bool straight = memchr(text, '=', marks) != NULL;
        int x, y;
        text = scan_integer(text + marks, &x);
        if (text == NULL || *text != ',') {
            return false;
        }
        text = scan_integer(text + 1, &y);
        if (text == NULL) {
            return false;
        }
        const double scale = place->size / 100;
        if (!plan_add(plan, place->left + scale * (x + place->slant * y), place->baseline - scale * y, corner,
                      straight)) {
            return false;
        }
    }
    return true;
}
