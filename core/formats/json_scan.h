/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_JSON_SCAN_H
#define DUCTUS_FORMATS_JSON_SCAN_H

/* Reading JSON (RFC 8259) piece by piece, without a tree of it: recordings may have millions of numbers,
 * which json-c keeps at some hundred bytes each. */

#include <stdbool.h>
#include <stddef.h>

typedef struct duct_json_scan {
    const char *at, *end; /* the text ends in a 0 byte at `end` */
    long line;            /* from 1 */
} duct_json_scan;

/* Skips a byte order mark. */
void duct_json_scan_init(duct_json_scan *scan, const char *data, size_t size);

/* The next character that is no white space, which is not taken; '\0' at the end of the text. */
char duct_json_scan_peek(duct_json_scan *scan);

/* Takes the next character if it is `c`. */
bool duct_json_scan_take(duct_json_scan *scan, char c);

/* Takes a string; false where there is none. `text` gets it, cut to its room and terminated; an escaped
 * character becomes '?'. */
bool duct_json_scan_string(duct_json_scan *scan, char *text, size_t room);

/* Takes a number, or `null`, which becomes NAN; false where there is neither, or it is not finite. */
bool duct_json_scan_number(duct_json_scan *scan, double *number);

/* Takes any value, with all that is in it; false where there is none that is whole, or where values are
 * nested more than DUCT_MAX_GROUP_DEPTH deep. */
bool duct_json_scan_skip(duct_json_scan *scan);

#endif
