/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/json_scan.h"

#include "base/number.h"

#include <ductus/drawing.h>

#include <math.h>
#include <string.h>

void duct_json_scan_init(duct_json_scan *scan, const char *data, size_t size)
{
    bool mark = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0;
    *scan = (duct_json_scan){mark ? data + 3 : data, data + size, 1};
}

char duct_json_scan_peek(duct_json_scan *scan)
{
    while (scan->at < scan->end && strchr(" \t\r\n", *scan->at) != NULL && *scan->at != '\0') {
        scan->line += *scan->at == '\n';
        scan->at++;
    }
    return scan->at < scan->end ? *scan->at : '\0';
}

bool duct_json_scan_take(duct_json_scan *scan, char c)
{
    if (c == '\0' || duct_json_scan_peek(scan) != c) {
        return false;
    }
    scan->at++;
    return true;
}

bool duct_json_scan_string(duct_json_scan *scan, char *text, size_t room)
{
    if (!duct_json_scan_take(scan, '"')) {
        return false;
    }
    size_t length = 0;
    while (scan->at < scan->end && *scan->at != '"') {
        char c = *scan->at;
        if ((unsigned char)c < ' ') {
            return false;
        }
        if (c == '\\') {
            scan->at++; /* the escape's further letters, if any, are as good as its own */
            c = '?';
            if (scan->at >= scan->end || (unsigned char)*scan->at < ' ') {
                return false;
            }
        }
        if (length + 1 < room) {
            text[length++] = c;
        }
        scan->at++;
    }
    if (room > 0) {
        text[length] = '\0';
    }
    return duct_json_scan_take(scan, '"');
}

static bool take_word(duct_json_scan *scan, const char *word)
{
    size_t length = strlen(word);
    if (duct_json_scan_peek(scan) != *word || (size_t)(scan->end - scan->at) < length ||
        memcmp(scan->at, word, length) != 0) {
        return false;
    }
    scan->at += length;
    return true;
}

bool duct_json_scan_number(duct_json_scan *scan, double *number)
{
    if (take_word(scan, "null")) {
        *number = NAN;
        return true;
    }
    char c = duct_json_scan_peek(scan);
    return (c == '-' || (c >= '0' && c <= '9')) && duct_number_scan(scan->at, &scan->at, number) &&
           isfinite(*number);
}

/* A value that holds no others. */
static bool skip_plain(duct_json_scan *scan)
{
    double number;
    if (duct_json_scan_peek(scan) == '"') {
        return duct_json_scan_string(scan, NULL, 0);
    }
    return take_word(scan, "true") || take_word(scan, "false") || duct_json_scan_number(scan, &number);
}

bool duct_json_scan_skip(duct_json_scan *scan)
{
    char closing[DUCT_MAX_GROUP_DEPTH];
    size_t depth = 0;
    do {
        char open = duct_json_scan_peek(scan);
        bool whole = open != '{' && open != '[';
        if (!whole) {
            scan->at++;
            if (depth == DUCT_MAX_GROUP_DEPTH) {
                return false;
            }
            closing[depth++] = open == '{' ? '}' : ']';
            whole = duct_json_scan_take(scan, closing[depth - 1]);
            depth -= whole;
        } else if (!skip_plain(scan)) {
            return false;
        }
        while (whole && depth > 0 && !duct_json_scan_take(scan, ',')) {
            if (!duct_json_scan_take(scan, closing[depth - 1])) {
                return false;
            }
            depth--;
        }
        if (depth > 0 && closing[depth - 1] == '}' &&
            (!duct_json_scan_string(scan, NULL, 0) || !duct_json_scan_take(scan, ':'))) {
            return false;
        }
    } while (depth > 0);
    return true;
}
