/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_STATUS_H
#define DUCTUS_STATUS_H

#include <ductus/export.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Every call that can fail returns a duct_status and fills an optional duct_error.
 *
 * On failure all output parameters and all handles passed in are as they were before the call, unless a
 * function says otherwise. Nothing in the library prints, aborts or exits. */

typedef enum duct_status {
    DUCT_OK = 0,
    DUCT_BAD_ARGUMENT, /* the caller broke a rule of the function's docstring */
    DUCT_BAD_SETTING,  /* a parameter has no such name, or its value is out of range */
    DUCT_NOT_FOUND,    /* a file, hand, brush or operation of that name does not exist */
    DUCT_IO,           /* the file system refused to read or write */
    DUCT_BAD_FORMAT,   /* the file's content is not what its format promises */
    DUCT_UNSUPPORTED,  /* valid, but Ductus cannot do it, e.g. a hand without the channel asked for */
    DUCT_LIMIT,        /* larger than the stated limits */
    DUCT_NO_MEMORY,    /* the allocator returned NULL */
    DUCT_CANCELLED     /* the progress callback asked to stop */
} duct_status;

enum { DUCT_ERROR_SIZE = 512 };

/* A failure, as a sentence that a user can act on: what, where, what to do.
 * The message is UTF-8, has no line break, no final full stop, and is always terminated; a longer one is cut.
 */
typedef struct duct_error {
    duct_status status;
    char message[DUCT_ERROR_SIZE];
} duct_error;

/* The status's name in a few English words, e.g. "out of memory". Never NULL; static storage. */
DUCT_API const char *duct_status_text(duct_status status);

#ifdef __cplusplus
}
#endif

#endif
