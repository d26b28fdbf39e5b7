/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/gzip.h"

#include "base/error.h"

#include <limits.h>
#include <string.h>
#include <zlib.h>

enum { GZIP_WINDOW = 15 + 16, CHUNK = 65536 };

bool duct_gzip_is(const char *data, size_t size)
{
    return size >= 2 && memcmp(data, "\x1f\x8b", 2) == 0;
}

static void *take(void *user, unsigned count, unsigned size)
{
    return duct_alloc(user, count, size);
}

static void give_back(void *user, void *memory)
{
    duct_release(user, memory);
}

/* The input is not written to, but without ZLIB_CONST zlib's struct does not say so. */
static void set_input(z_stream *stream, const char *data, size_t size)
{
    union {
        const char *constant;
        Bytef *plain;
    } input = {.constant = data};
    stream->next_in = input.plain;
    stream->avail_in = size > UINT_MAX ? UINT_MAX : (uInt)size;
}

size_t duct_gzip_peek(const char *data, size_t size, char *buffer, size_t room)
{
    z_stream stream = {0};
    if (!duct_gzip_is(data, size) || inflateInit2(&stream, GZIP_WINDOW) != Z_OK) {
        return 0;
    }
    set_input(&stream, data, size);
    stream.next_out = (Bytef *)buffer;
    stream.avail_out = (uInt)room;
    int result;
    do {
        result = inflate(&stream, Z_SYNC_FLUSH);
    } while (result == Z_OK && stream.avail_out > 0 && stream.avail_in > 0);
    inflateEnd(&stream);
    return room - stream.avail_out;
}

static duct_status fail_unpack(int result, duct_error *error)
{
    return result == Z_MEM_ERROR
               ? duct_fail_memory(error)
               : duct_fail(error, DUCT_BAD_FORMAT,
                           result == Z_BUF_ERROR || result == Z_OK ? "the compressed data ends too early"
                                                                   : "the compressed data (gzip) is damaged");
}

/* Fills a growing buffer; on failure the caller frees it. */
static duct_status unpack(z_stream *stream, const duct_allocator *allocator, size_t limit, char **buffer,
                          size_t *length, duct_error *error)
{
    size_t capacity = 0;
    for (;;) {
        void *grown = *buffer;
        if (!duct_reserve(allocator, &grown, &capacity, *length + CHUNK, 1)) {
            return duct_fail_memory(error);
        }
        *buffer = grown;
        /* One byte more than allowed tells that there is more. */
        size_t wanted = capacity - *length - 1, allowed = limit + 1 - *length;
        wanted = wanted < allowed ? wanted : allowed;
        uInt room = (uInt)(wanted > INT_MAX ? INT_MAX : wanted);
        stream->next_out = (Bytef *)*buffer + *length;
        stream->avail_out = room;
        int result = inflate(stream, Z_NO_FLUSH);
        *length += room - stream->avail_out;
        (*buffer)[*length] = '\0';
        if (*length > limit) {
            return duct_fail(error, DUCT_LIMIT, "is larger than the limit of %zu MiB when unpacked",
                             limit >> 20);
        }
        if (result == Z_STREAM_END) {
            bool more = stream->avail_in > 0 && duct_gzip_is((const char *)stream->next_in, stream->avail_in);
            if (!more) {
                return DUCT_OK;
            }
            result = inflateReset(stream);
        }
        if (result != Z_OK || (stream->avail_in == 0 && stream->avail_out > 0)) {
            return fail_unpack(result, error);
        }
    }
}

duct_status duct_gzip_unpack(const duct_allocator *allocator, const char *data, size_t size, size_t limit,
                             char **unpacked, size_t *unpacked_size, duct_error *error)
{
    if (size > UINT_MAX) {
        return duct_fail(error, DUCT_LIMIT, "is too large to be unpacked");
    }
    /* zlib wants a pointer that may be written through; it only hands it back to the functions above. */
    duct_allocator hook = *allocator;
    z_stream stream = {.zalloc = take, .zfree = give_back, .opaque = &hook};
    int result = inflateInit2(&stream, GZIP_WINDOW);
    if (result != Z_OK) {
        return fail_unpack(result, error);
    }
    set_input(&stream, data, size);
    char *buffer = NULL;
    size_t length = 0;
    duct_status status = unpack(&stream, allocator, limit, &buffer, &length, error);
    inflateEnd(&stream);
    if (status != DUCT_OK) {
        duct_release(allocator, buffer);
        return status;
    }
    *unpacked = buffer;
    *unpacked_size = length;
    return DUCT_OK;
}
