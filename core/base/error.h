/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_ERROR_H
#define DUCTUS_BASE_ERROR_H

#include <ductus/status.h>

/* Fills `error` (which may be NULL) with a sentence and returns `status`, so that a failing function can say
 * `return duct_fail(error, DUCT_IO, "...")`. Control characters in the result become '?': text from hostile
 * files may be quoted. */
duct_status duct_fail(duct_error *error, duct_status status, const char *format, ...) DUCT_PRINTF(3, 4);

/* The sentence for an allocator that returned NULL. */
duct_status duct_fail_memory(duct_error *error);

/* Puts "prefix: " before the sentence that `error` holds; keeps its status. */
void duct_error_prefix(duct_error *error, const char *prefix);

#endif
