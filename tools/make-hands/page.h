/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_PAGE_H
#define MAKE_HANDS_PAGE_H

#include "style.h"

#include <ductus/drawing.h>

enum { PAGE_SIDE = 2000 };

/* Writes and draws a page with a hand: a recording of all channels, with annotations "name", "artist",
 * "licence" and "synthetic", the strokes grouped as "text" and "drawing". The caller frees it. Errors:
 * DUCT_NO_MEMORY; DUCT_BAD_ARGUMENT where a line holds a character that the hand's alphabet lacks. */
duct_status page_make(const duct_context *context, const hand_style *style, duct_drawing **page,
                      duct_error *error);

/* A page with one line of text in a hand, and no drawing strokes. Errors as above. */
duct_status page_write_line(const duct_context *context, const hand_style *style, const char *text,
                            duct_drawing **page, duct_error *error);

#endif
