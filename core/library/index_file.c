/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The index file beside a library: features that took time to compute. A header of fixed fields, the key, the
 * rows as little-endian floats, and a checksum over all of it. Whatever does not fit exactly is as good as
 * not there. */
#include "library/library_private.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"

#include <string.h>

typedef struct {
    char magic[8];
    uint64_t fingerprint; /* of the library */
    uint64_t count, dimensions, key_size;
} header;

static const char magic[8] = {'D', 'U', 'C', 'T', 'I', 'D', 'X', '1'};

/* FNV-1a over eight bytes at a time: it only has to notice damage. */
static uint64_t checksum(const char *data, size_t size)
{
    uint64_t hash = 0xcbf29ce484222325u;
    size_t i = 0;
    for (; i + 8 <= size; i += 8) {
        uint64_t word;
        memcpy(&word, data + i, 8);
        hash = (hash ^ word) * 0x100000001b3u;
        hash ^= hash >> 29;
    }
    for (; i < size; i++) {
        hash = (hash ^ (unsigned char)data[i]) * 0x100000001b3u;
    }
    return hash;
}

bool duct_index_read(const duct_library *library, const char *key, float *rows, size_t count,
                     size_t dimensions)
{
    char *data;
    size_t size;
    if (library->index_path == NULL || !duct_file_exists(library->index_path) ||
        duct_file_read(&library->allocator, library->index_path, DUCT_MAX_FILE_BYTES, &data, &size, NULL) !=
            DUCT_OK) {
        return false;
    }
    size_t key_size = strlen(key), bytes = count * dimensions * sizeof(float);
    header head;
    uint64_t stated;
    bool good = size == sizeof head + key_size + bytes + sizeof stated;
    if (good) {
        memcpy(&head, data, sizeof head);
        memcpy(&stated, data + size - sizeof stated, sizeof stated);
        good = memcmp(head.magic, magic, sizeof magic) == 0 && head.fingerprint == library->fingerprint &&
               head.count == count && head.dimensions == dimensions && head.key_size == key_size &&
               memcmp(data + sizeof head, key, key_size) == 0 &&
               stated == checksum(data, size - sizeof stated);
    }
    if (good) {
        memcpy(rows, data + sizeof head + key_size, bytes);
    }
    duct_release(&library->allocator, data);
    return good;
}

duct_status duct_index_write(const duct_library *library, const char *path, const char *key,
                             const float *rows, size_t count, size_t dimensions, duct_error *error)
{
    header head;
    memset(&head, 0, sizeof head);
    memcpy(head.magic, magic, sizeof magic);
    head.fingerprint = library->fingerprint;
    head.count = count;
    head.dimensions = dimensions;
    head.key_size = strlen(key);
    duct_text file;
    duct_text_init(&file, &library->allocator);
    duct_text_add_bytes(&file, &head, sizeof head);
    duct_text_add_bytes(&file, key, strlen(key));
    duct_text_add_bytes(&file, rows, count * dimensions * sizeof *rows);
    if (!file.failed) {
        uint64_t sum = checksum(file.data, file.size);
        duct_text_add_bytes(&file, &sum, sizeof sum);
    }
    duct_status status = file.failed
                             ? duct_fail_memory(error)
                             : duct_file_write(&library->allocator, path, file.data, file.size, error);
    duct_text_free(&file);
    return status;
}
