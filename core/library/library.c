/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/library_private.h"

#include "base/error.h"
#include "base/number.h"
#include "base/text.h"
#include "geometry/resample.h"
#include "geometry/statistics.h"
#include "library/annotations.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Where the median stroke has this many samples, the paper's patches, costs and windows have the sizes it
 * gives. */
enum { MEDIAN_SAMPLES = 60 };

static const duct_channel pose_channels[] = {DUCT_PRESSURE, DUCT_TILT_X, DUCT_TILT_Y, DUCT_TWIST};

/* The median arc length of all strokes that have one, in recording pixels; 0 where none has. */
static duct_status median_length(const duct_allocator *allocator, const duct_drawing *const *recordings,
                                 size_t count, double *median, duct_error *error)
{
    size_t strokes = 0, used = 0;
    for (size_t r = 0; r < count; r++) {
        strokes += duct_drawing_stroke_count(recordings[r]);
    }
    double *lengths = duct_alloc(allocator, strokes, sizeof *lengths);
    if (lengths == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t r = 0; r < count; r++) {
        for (size_t s = 0; s < duct_drawing_stroke_count(recordings[r]); s++) {
            double length = duct_stroke_length(duct_drawing_stroke(recordings[r], s));
            if (length > 0 && isfinite(length)) {
                lengths[used++] = length;
            }
        }
    }
    *median = duct_median(lengths, used);
    duct_release(allocator, lengths);
    return DUCT_OK;
}

/* Samples of one recording's stroke, kept until all are there and their number is known. */
typedef struct {
    duct_samples *items;
    size_t count;
    size_t samples;
} sampled;

static void free_sampled(const duct_allocator *allocator, sampled *all)
{
    for (size_t i = 0; i < all->count; i++) {
        duct_samples_free(allocator, &all->items[i]);
    }
    duct_release(allocator, all->items);
}

static duct_status sample_all(const duct_allocator *allocator, const duct_drawing *const *recordings,
                              size_t count, double unit, sampled *all, duct_error *error)
{
    size_t strokes = 0;
    for (size_t r = 0; r < count; r++) {
        strokes += duct_drawing_stroke_count(recordings[r]);
    }
    all->items = duct_alloc(allocator, strokes, sizeof *all->items);
    if (all->items == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t r = 0; r < count; r++) {
        for (size_t s = 0; s < duct_drawing_stroke_count(recordings[r]); s++) {
            duct_samples *item = &all->items[all->count];
            duct_status status =
                duct_samples_make(allocator, duct_drawing_stroke(recordings[r], s), unit, item, error);
            if (status != DUCT_OK) {
                return status;
            }
            if (item->count == 0) {
                continue;
            }
            all->count++;
            all->samples += item->count;
            if (all->samples > DUCT_MAX_SAMPLES) {
                return duct_fail(error, DUCT_LIMIT,
                                 "a library may have %d samples at most; use a larger unit",
                                 DUCT_MAX_SAMPLES);
            }
        }
    }
    return DUCT_OK;
}

/* Puts the samples one after the other into the library, X and Y in sampling units. */
static duct_status gather(duct_library *library, const sampled *all, duct_error *error)
{
    library->stroke_count = all->count;
    library->sample_count = all->samples;
    library->starts = duct_alloc(&library->allocator, all->count + 1, sizeof *library->starts);
    if (library->starts == NULL) {
        return duct_fail_memory(error);
    }
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        bool everywhere = true;
        for (size_t i = 0; i < all->count; i++) {
            everywhere = everywhere && all->items[i].channels[c] != NULL;
        }
        if (!everywhere) {
            continue;
        }
        double *to = duct_alloc(&library->allocator, all->samples, sizeof *to);
        library->channels[c] = to;
        if (to == NULL) {
            return duct_fail_memory(error);
        }
        size_t at = 0;
        for (size_t i = 0; i < all->count; i++) {
            const duct_samples *item = &all->items[i];
            double scale = c == DUCT_X || c == DUCT_Y ? 1 / library->unit : 1;
            for (size_t k = 0; k < item->count; k++) {
                to[at++] = item->channels[c][k] * scale;
            }
        }
    }
    size_t at = 0;
    for (size_t i = 0; i < all->count; i++) {
        library->starts[i] = (uint32_t)at;
        at += all->items[i].count;
    }
    library->starts[all->count] = (uint32_t)at;
    return DUCT_OK;
}

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

static const char *first_annotation(const duct_drawing *const *recordings, size_t count, const char *key)
{
    for (size_t r = 0; r < count; r++) {
        const char *value = duct_drawing_annotation(recordings[r], key);
        if (value != NULL) {
            return value;
        }
    }
    return "";
}

static duct_status set_facts(duct_library *library, const duct_drawing *const *recordings, size_t count,
                             const duct_library_options *options, duct_error *error)
{
    const char *name = options != NULL ? options->name : NULL;
    const char *artist = options != NULL ? options->artist : NULL;
    const char *licence = options != NULL ? options->licence : NULL;
    const duct_allocator *allocator = &library->allocator;
    library->name =
        duct_strdup(allocator, name ? name : first_annotation(recordings, count, DUCT_ANNOTATION_NAME));
    library->artist =
        duct_strdup(allocator, artist ? artist : first_annotation(recordings, count, DUCT_ANNOTATION_ARTIST));
    library->licence = duct_strdup(
        allocator, licence ? licence : first_annotation(recordings, count, DUCT_ANNOTATION_LICENCE));
    if (library->name == NULL || library->artist == NULL || library->licence == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t r = 0; r < count; r++) {
        library->width = fmax(library->width, duct_drawing_width(recordings[r]));
        library->height = fmax(library->height, duct_drawing_height(recordings[r]));
    }
    return DUCT_OK;
}

/* The unit: what the options say, or what the recording says it was sampled with, or by the median stroke. */
static duct_status choose_unit(const duct_allocator *allocator, const duct_drawing *const *recordings,
                               size_t count, const duct_library_options *options, double *unit,
                               duct_error *error)
{
    if (options != NULL && options->unit != 0) {
        if (!(options->unit > 0) || !isfinite(options->unit)) {
            return duct_fail(error, DUCT_BAD_ARGUMENT,
                             "the sampling unit must be a positive number of pixels");
        }
        *unit = options->unit;
        return DUCT_OK;
    }
    double stated;
    const char *text = first_annotation(recordings, count, DUCT_ANNOTATION_UNIT);
    if (duct_number_parse(text, &stated) && stated > 0) {
        *unit = stated;
        return DUCT_OK;
    }
    double median = 0;
    duct_status status = median_length(allocator, recordings, count, &median, error);
    if (status == DUCT_OK && !(median > 0)) {
        return duct_fail(error, DUCT_UNSUPPORTED,
                         "no stroke has a length, so there is nothing to learn from");
    }
    *unit = median / MEDIAN_SAMPLES;
    return status;
}

duct_status duct_library_build(const duct_context *context, const duct_drawing *const *recordings,
                               size_t count, const duct_library_options *options, duct_library **library,
                               duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    double unit = 0;
    duct_status status = choose_unit(allocator, recordings, count, options, &unit, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_library *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->unit = unit;
    pthread_mutex_init(&made->lock, NULL);
    sampled all = {NULL, 0, 0};
    status = sample_all(allocator, recordings, count, unit, &all, error);
    if (status == DUCT_OK && all.count == 0) {
        status =
            duct_fail(error, DUCT_UNSUPPORTED, "no stroke has a length, so there is nothing to learn from");
    }
    if (status == DUCT_OK) {
        status = gather(made, &all, error);
    }
    free_sampled(allocator, &all);
    if (status == DUCT_OK) {
        status = set_facts(made, recordings, count, options, error);
    }
    if (status == DUCT_OK) {
        status = duct_library_finish(made, error);
    }
    if (status != DUCT_OK) {
        duct_library_free(made);
        return status;
    }
    *library = made;
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

double duct_library_unit(const duct_library *library)
{
    return library->unit;
}

bool duct_library_has(const duct_library *library, duct_channel channel)
{
    return (unsigned)channel < DUCT_CHANNEL_COUNT && library->channels[channel] != NULL;
}
