/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Unpacks the input as gzip data: as it is, and as the deflated body between a good head and a good tail,
 * which few changed files would get past. What is unpacked keeps the limit, and its beginning is what a peek
 * gives. */
#include "fuzz.h"

#include "formats/gzip.h"

#include <ductus/ductus.h>

#include <string.h>

enum { LIMIT = 1 << 20, PEEK = 512 };

static void unpack(const char *data, size_t size)
{
    duct_error error = {DUCT_OK, ""};
    char *unpacked = NULL, peeked[PEEK];
    size_t length = 0, seen = duct_gzip_peek(data, size, peeked, sizeof peeked);
    fuzz_require(seen <= sizeof peeked, "");
    duct_status status =
        duct_gzip_unpack(duct_allocator_of(NULL), data, size, LIMIT, &unpacked, &length, &error);
    fuzz_require((status == DUCT_OK) == (unpacked != NULL), error.message);
    if (unpacked == NULL) {
        fuzz_require(error.message[0] != '\0', "");
        return;
    }
    fuzz_require(length <= LIMIT && unpacked[length] == '\0', "");
    fuzz_require(seen <= length && memcmp(peeked, unpacked, seen) == 0, "");
    duct_release(duct_allocator_of(NULL), unpacked);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static const char head[] = {'\x1f', '\x8b', 8, 0, 0, 0, 0, 0, 0, 3};
    unpack((const char *)data, size);
    char *whole = malloc(sizeof head + size);
    if (whole != NULL) {
        memcpy(whole, head, sizeof head);
        if (size > 0) {
            memcpy(whole + sizeof head, data, size);
        }
        unpack(whole, sizeof head + size);
        free(whole);
    }
    return 0;
}
