/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_SCAN_H
#define DUCTUS_FORMATS_SVG_SCAN_H

#include <stdbool.h>
#include <stddef.h>

/* The small grammar parts that SVG's attributes and CSS share. All texts end with a 0 byte; a slice is a part
 * of such a text. */
typedef struct duct_slice {
    const char *text; /* NULL: no value at all */
    size_t size;
} duct_slice;

duct_slice duct_slice_of(const char *text); /* NULL gives the slice that is no value */
/* Without the white space around it. */
duct_slice duct_slice_trim(duct_slice slice);
/* Equal to a lower-case ASCII word, whatever the slice's own case. */
bool duct_slice_is(duct_slice slice, const char *word);
/* Begins with the lower-case ASCII word, whatever the slice's own case. */
bool duct_slice_begins(duct_slice slice, const char *word);
/* Equal byte for byte. */
bool duct_slice_equal(duct_slice slice, const char *text);
/* The next word in a list separated by white space, cut off the slice's front; false at the end. */
bool duct_slice_word(duct_slice *rest, duct_slice *word);
/* A finite number at the front, cut off; false, with nothing cut, where there is none. */
bool duct_slice_number(duct_slice *rest, double *number);

bool duct_is_space(char c);
/* Skips white space, and one comma with the white space behind it. True where there was a comma. */
bool duct_skip_comma(const char **s);
void duct_skip_space(const char **s);

#endif
