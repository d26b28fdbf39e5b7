/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_STROKE_PRIVATE_H
#define DUCTUS_STROKE_PRIVATE_H

#include "base/memory.h"

#include <ductus/stroke.h>

/* Strokes are made and freed by their drawing only. */
duct_status duct_stroke_new(const duct_allocator *allocator, const char *id, size_t size,
                            duct_stroke **stroke, duct_error *error);
duct_status duct_stroke_copy(const duct_allocator *allocator, const duct_stroke *stroke, duct_stroke **copy,
                             duct_error *error);
void duct_stroke_free(duct_stroke *stroke); /* NULL is allowed */

#endif
