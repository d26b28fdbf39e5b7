/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATIONS_STROKE_LIST_H
#define DUCTUS_OPERATIONS_STROKE_LIST_H

#include "base/memory.h"

#include <ductus/drawing.h>

/* The value of a parameter of type DUCT_PARAM_STROKES: numbers of strokes, in the order in which the text
 * names them and each once. */
typedef struct duct_stroke_list {
    size_t *items;
    size_t count;
} duct_stroke_list;

/* Reads `size` bytes of text. `param` stands in sentences. Errors: DUCT_BAD_SETTING (the drawing has no such
 * stroke), DUCT_NO_MEMORY. The caller frees the list. */
duct_status duct_stroke_list_read(const duct_allocator *allocator, const duct_drawing *drawing,
                                  const char *text, size_t size, const char *param, duct_stroke_list *list,
                                  duct_error *error);
void duct_stroke_list_done(const duct_allocator *allocator, duct_stroke_list *list);

#endif
