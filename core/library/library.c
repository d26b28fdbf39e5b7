/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library_private.h"

#include "base/error.h"
#include "geometry/statistics.h"

#include <math.h>
#include <string.h>

static const duct_channel pose_channels[] = {DUCT_PRESSURE, DUCT_TILT_X, DUCT_TILT_Y, DUCT_TWIST};

static void measure_channel(duct_library *library, duct_channel channel)
{
    const double *values = library->channels[channel];
    size_t count = library->sample_count;
    if (values == NULL) {
        return;
    }
    double mean = 0, square = 0;
    if (channel == DUCT_TWIST) {
        double sine = 0, cosine = 0;
        for (size_t i = 0; i < count; i++) {
            sine += sin(values[i]);
            cosine += cos(values[i]);
        }
        mean = atan2(sine, cosine);
        for (size_t i = 0; i < count; i++) {
            double off = remainder(values[i] - mean, 2 * M_PI);
            square += off * off;
        }
    } else {
        for (size_t i = 0; i < count; i++) {
            mean += values[i];
        }
        mean /= (double)count;
        for (size_t i = 0; i < count; i++) {
            square += (values[i] - mean) * (values[i] - mean);
        }
    }
    library->mean[channel] = mean;
    library->deviation[channel] = sqrt(square / (double)count);
}

static uint64_t hash_bytes(uint64_t hash, const void *data, size_t size)
{
    const unsigned char *bytes = data;
    for (size_t i = 0; i < size; i++) {
        hash = (hash ^ bytes[i]) * 0x100000001b3u;
    }
    return hash;
}

duct_status duct_library_finish(duct_library *library, duct_error *error)
{
    for (size_t i = 0; i < sizeof pose_channels / sizeof pose_channels[0]; i++) {
        measure_channel(library, pose_channels[i]);
    }
    double *sizes = duct_alloc(&library->allocator, library->stroke_count, sizeof *sizes);
    if (sizes == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t s = 0; s < library->stroke_count; s++) {
        sizes[s] = (double)(library->starts[s + 1] - library->starts[s] - 1);
    }
    library->median_size = duct_median(sizes, library->stroke_count);
    duct_release(&library->allocator, sizes);
    /* Features depend on the positions alone. */
    uint64_t hash = 0xcbf29ce484222325u;
    hash = hash_bytes(hash, library->starts, (library->stroke_count + 1) * sizeof *library->starts);
    hash = hash_bytes(hash, library->channels[DUCT_X], library->sample_count * sizeof(double));
    library->fingerprint =
        hash_bytes(hash, library->channels[DUCT_Y], library->sample_count * sizeof(double));
    return DUCT_OK;
}

void duct_library_free(duct_library *library)
{
    if (library == NULL) {
        return;
    }
    const duct_allocator allocator = library->allocator;
    while (library->parts != NULL) {
        duct_library_part *part = library->parts;
        library->parts = part->next;
        part->destroy(part->data, &allocator);
        duct_release(&allocator, part->key);
        duct_release(&allocator, part);
    }
    pthread_mutex_destroy(&library->lock);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(&allocator, library->channels[c]);
    }
    duct_release(&allocator, library->starts);
    duct_release(&allocator, library->weights);
    duct_release(&allocator, library->name);
    duct_release(&allocator, library->artist);
    duct_release(&allocator, library->licence);
    duct_release(&allocator, library->index_path);
    duct_release(&allocator, library);
}

uint32_t duct_library_stroke_of(const duct_library *library, uint32_t sample)
{
    size_t low = 0, high = library->stroke_count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (library->starts[middle] <= sample) {
            low = middle;
        } else {
            high = middle;
        }
    }
    return (uint32_t)low;
}

duct_status duct_library_get_part(const duct_library *library, const char *key,
                                  duct_status (*make)(const duct_library *library, const void *arg,
                                                      void **data, duct_error *error),
                                  const void *arg,
                                  void (*destroy)(void *data, const duct_allocator *allocator),
                                  const void **data, duct_error *error)
{
    /* The parts are a cache: filling it does not change what the library is, so the handle stays const. */
    duct_library *owner = (duct_library *)(uintptr_t)library;
    duct_status status = DUCT_OK;
    pthread_mutex_lock(&owner->lock);
    duct_library_part *part = owner->parts;
    while (part != NULL && strcmp(part->key, key) != 0) {
        part = part->next;
    }
    if (part == NULL) {
        part = duct_alloc(&owner->allocator, 1, sizeof *part);
        char *name = duct_strdup(&owner->allocator, key);
        if (part == NULL || name == NULL) {
            status = duct_fail_memory(error);
        } else {
            part->key = name;
            part->destroy = destroy;
            status = make(library, arg, &part->data, error);
        }
        if (status == DUCT_OK) {
            part->next = owner->parts;
            owner->parts = part;
        } else {
            duct_release(&owner->allocator, name);
            duct_release(&owner->allocator, part);
        }
    }
    if (status == DUCT_OK) {
        *data = part->data;
    }
    pthread_mutex_unlock(&owner->lock);
    return status;
}

const char *duct_library_name(const duct_library *library)
{
    return library->name;
}

const char *duct_library_artist(const duct_library *library)
{
    return library->artist;
}

const char *duct_library_licence(const duct_library *library)
{
    return library->licence;
}

size_t duct_library_stroke_count(const duct_library *library)
{
    return library->stroke_count;
}

size_t duct_library_sample_count(const duct_library *library)
{
    return library->sample_count;
}

size_t duct_library_stroke_samples(const duct_library *library, size_t stroke)
{
    return stroke < library->stroke_count ? library->starts[stroke + 1] - library->starts[stroke] : 0;
}

double duct_library_weight(const duct_library *library, size_t stroke)
{
    if (stroke >= library->stroke_count) {
        return 0;
    }
    return library->weights != NULL ? library->weights[stroke] : 1;
}

double duct_library_unit(const duct_library *library)
{
    return library->unit;
}

bool duct_library_has(const duct_library *library, duct_channel channel)
{
    return (unsigned)channel < DUCT_CHANNEL_COUNT && library->channels[channel] != NULL;
}
