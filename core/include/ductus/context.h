/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CONTEXT_H
#define DUCTUS_CONTEXT_H

#include <ductus/export.h>

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The surroundings of a call: where memory comes from, how many threads may work, who hears of progress.
 *
 * The library holds no global mutable state, so whatever would be global elsewhere is a field here, and two
 * threads may use two contexts (or share one) freely. A NULL context means duct_context_default(). */

/* An allocation hook. All three functions must be safe to call from several threads at once. `allocate` and
 * `reallocate` return NULL when there is no memory, and the call in progress then fails with DUCT_NO_MEMORY.
 * Memory that third-party libraries (libxml2, FLANN, libmypaint, OpenImageIO) allocate for themselves does
 * not pass through the hook. */
typedef struct duct_allocator {
    void *(*allocate)(void *user, size_t size);
    void *(*reallocate)(void *user, void *memory, size_t size);
    void (*release)(void *user, void *memory);
    void *user;
} duct_allocator;

/* Called now and then during long work, always from the thread that called the library, with `fraction` in
 * 0..1 and never decreasing. Return false to cancel: the work frees everything, leaves its inputs as they
 * were and returns DUCT_CANCELLED. */
typedef bool (*duct_progress)(void *user, double fraction);

typedef struct duct_context {
    const duct_allocator
        *allocator;         /* NULL: malloc, realloc, free. Must outlive every handle made with it. */
    int threads;            /* threads for work over strokes; 0: one per processor */
    duct_progress progress; /* NULL: nobody listens */
    void *progress_user;
    const char *data_folder; /* folder that holds hands/ and brushes/; NULL: found beside the library */
} duct_context;

/* The default surroundings: malloc, one thread per processor, no progress, data found beside the library. */
DUCT_API duct_context duct_context_default(void);

/* Frees memory that the library handed out as plain bytes or text, with the same context. NULL is allowed. */
DUCT_API void duct_memory_free(const duct_context *context, void *memory);

#ifdef __cplusplus
}
#endif

#endif
