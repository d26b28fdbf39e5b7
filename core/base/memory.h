/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_MEMORY_H
#define DUCTUS_BASE_MEMORY_H

#include <ductus/context.h>

/* The allocator of a context: malloc's where the context or its hook is NULL. Never NULL. */
const duct_allocator *duct_allocator_of(const duct_context *context);

/* `count` zeroed elements of `size` bytes; NULL when there is no memory or the product overflows. A count of
 * 0 gives memory that may be released and not touched. */
void *duct_alloc(const duct_allocator *allocator, size_t count, size_t size);

/* The same without zeroing, for large memory of which only what was written is read. */
void *duct_alloc_raw(const duct_allocator *allocator, size_t count, size_t size);

/* Grows or shrinks; the new part is not zeroed. NULL leaves the old memory as it was. */
void *duct_realloc(const duct_allocator *allocator, void *memory, size_t count, size_t size);

/* NULL is allowed. */
void duct_release(const duct_allocator *allocator, void *memory);

/* A copy of a text; NULL stays NULL and is then no failure. */
char *duct_strdup(const duct_allocator *allocator, const char *text);

/* Makes room for `needed` elements in a growing array, doubling; false when there is no memory. */
bool duct_reserve(const duct_allocator *allocator, void **memory, size_t *capacity, size_t needed,
                  size_t size);

#endif
