/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether an image file has its end. Decoders fill up a cut JPEG without a word, and libpng prints. */
#include "image/image_private.h"

#include <string.h>

/* Behind a scan's header: the place of the next marker that is no restart marker, or `size`. */
static size_t skip_scan(const unsigned char *data, size_t size, size_t at)
{
    while (at + 1 < size) {
        unsigned char next = data[at + 1];
        if (data[at] == 0xff && next != 0x00 && next != 0xff && !(next >= 0xd0 && next <= 0xd7)) {
            return at;
        }
        at++;
    }
    return size;
}

/* ITU-T T.81, annex B: a walk from marker to marker, because a thumbnail inside has an end marker too and
 * there may be anything behind the real one. */
static bool jpeg_truncated(const unsigned char *data, size_t size)
{
    size_t at = 2;
    while (at + 1 < size) {
        if (data[at] != 0xff) {
            return true; /* not what the marker before promised */
        }
        unsigned char marker = data[at + 1];
        if (marker == 0xff) {
            at++; /* fill byte */
            continue;
        }
        if (marker == 0xd9) {
            return false;
        }
        at += 2;
        if (marker == 0x01 || (marker >= 0xd0 && marker <= 0xd8)) {
            continue; /* stands alone */
        }
        if (at + 2 > size) {
            return true;
        }
        size_t length = (size_t)data[at] * 256 + data[at + 1];
        if (length < 2 || length > size - at) {
            return true;
        }
        at += length;
        if (marker == 0xda) {
            at = skip_scan(data, size, at);
        }
    }
    return true;
}

/* Chunks of length, name, data and checksum, up to the one called IEND. */
static bool png_truncated(const unsigned char *data, size_t size)
{
    size_t at = 8;
    while (size - at >= 12) {
        size_t length = ((size_t)data[at] << 24) + ((size_t)data[at + 1] << 16) +
                        ((size_t)data[at + 2] << 8) + data[at + 3];
        if (memcmp(data + at + 4, "IEND", 4) == 0) {
            return false;
        }
        if (length > size - at - 12) {
            return true;
        }
        at += length + 12;
    }
    return true;
}

bool duct_image_truncated(const unsigned char *data, size_t size)
{
    if (size >= 3 && memcmp(data, "\xff\xd8\xff", 3) == 0) {
        return jpeg_truncated(data, size);
    }
    if (size >= 8 && memcmp(data, "\x89PNG\r\n\x1a\n", 8) == 0) {
        return png_truncated(data, size);
    }
    return false;
}
