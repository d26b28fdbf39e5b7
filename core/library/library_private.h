/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_PRIVATE_H
#define DUCTUS_LIBRARY_PRIVATE_H

#include "base/memory.h"

#include <ductus/library.h>

#include <pthread.h>
#include <stdint.h>

/* What is computed from a library once and kept with it: features, search indices. Each kind of thing has a
 * key of its own; the first who asks makes it, others wait for him. */
typedef struct duct_library_part duct_library_part;
struct duct_library_part {
    duct_library_part *next;
    char *key;
    void *data;
    void (*destroy)(void *data, const duct_allocator *allocator);
};

struct duct_library {
    duct_allocator allocator;
    char *name, *artist, *licence;
    double unit;          /* recording pixels a sampling unit */
    double width, height; /* the recording's page, recording pixels */
    size_t stroke_count, sample_count;
    uint32_t *starts; /* stroke s has samples starts[s] .. starts[s + 1] - 1 */
    double *weights;  /* by stroke: what its candidates' feature distances are divided by; NULL: all 1 */
    /* All strokes' samples one after the other; X and Y in sampling units; NULL where the library lacks a
     * channel. */
    double *channels[DUCT_CHANNEL_COUNT];
    double mean[DUCT_CHANNEL_COUNT]; /* of the pose channels; twist's on the circle */
    double
        deviation[DUCT_CHANNEL_COUNT]; /* standard deviations of the pose channels; twist's on the circle */
    double median_size;                /* the median stroke's arc length in sampling units */
    uint64_t fingerprint;              /* of everything above: says whether an index file belongs to it */
    char *index_path;                  /* where an index file would lie; NULL: nowhere */
    pthread_mutex_t lock;
    duct_library_part *parts;
};

/* The stroke that holds sample `sample`. */
uint32_t duct_library_stroke_of(const duct_library *library, uint32_t sample);

/* Finds a part by its key, or makes it by `make` and keeps it: made once, whoever asks. `make` must not ask
 * for another part. Errors: those of `make`, DUCT_NO_MEMORY. */
duct_status duct_library_get_part(const duct_library *library, const char *key,
                                  duct_status (*make)(const duct_library *library, const void *arg,
                                                      void **data, duct_error *error),
                                  const void *arg,
                                  void (*destroy)(void *data, const duct_allocator *allocator),
                                  const void **data, duct_error *error);

/* Fills name, artist, licence, statistics and fingerprint in once the samples are there. */
duct_status duct_library_finish(duct_library *library, duct_error *error);

/* The index file: features of a library as bytes, by key. `rows` has `count` * `dimensions` floats. Reading
 * gives false where there is none that fits the library and the key; it never trusts the file's content. */
bool duct_index_read(const duct_library *library, const char *key, float *rows, size_t count,
                     size_t dimensions);
duct_status duct_index_write(const duct_library *library, const char *path, const char *key,
                             const float *rows, size_t count, size_t dimensions, duct_error *error);

#endif
