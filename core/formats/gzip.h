/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_GZIP_H
#define DUCTUS_FORMATS_GZIP_H

#include "base/memory.h"

#include <ductus/status.h>

/* True where the data begins as gzip (RFC 1952) does. */
bool duct_gzip_is(const char *data, size_t size);

/* Unpacks the beginning of gzip data into a buffer, whose rest is left as it is: how many bytes there are.
 * Takes memory of zlib's own. */
size_t duct_gzip_peek(const char *data, size_t size, char *buffer, size_t room);

/* Unpacks gzip data, all its members, to at most `limit` bytes. `*unpacked` is terminated by a 0 byte that
 * `*unpacked_size` does not count; the caller releases it. Errors: DUCT_BAD_FORMAT, DUCT_LIMIT,
 * DUCT_NO_MEMORY. */
duct_status duct_gzip_unpack(const duct_allocator *allocator, const char *data, size_t size, size_t limit,
                             char **unpacked, size_t *unpacked_size, duct_error *error);

#endif
