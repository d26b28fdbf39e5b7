/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Making libraries of recordings, "HelpingHand" section 3. */
#include "library/library_private.h"

#include "base/error.h"
#include "base/number.h"
#include "geometry/resample.h"
#include "geometry/statistics.h"
#include "library/annotations.h"
#include "library/position.h"
#include "library/weights.h"

#include <math.h>

/* Where the median stroke has this many samples, the paper's patches, costs and windows have the sizes it
 * gives. */
enum { MEDIAN_SAMPLES = 60, MOST_SCALES = 16 };

static const double SMALLEST_SCALE = 0.01, LARGEST_SCALE = 100;

static size_t count_strokes(const duct_drawing *const *recordings, size_t count)
{
    size_t strokes = 0;
    for (size_t r = 0; r < count; r++) {
        strokes += duct_drawing_stroke_count(recordings[r]);
    }
    return strokes;
}

/* The median arc length of all strokes that have one, in recording pixels; 0 where none has. */
static duct_status median_length(const duct_allocator *allocator, const duct_drawing *const *recordings,
                                 size_t count, double *median, duct_error *error)
{
    size_t used = 0;
    double *lengths = duct_alloc(allocator, count_strokes(recordings, count), sizeof *lengths);
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

/* The recordings' strokes as samples, kept until all are there and their number is known. */
typedef struct {
    duct_samples *items;
    double *weights; /* by item */
    double *units;   /* by item: recording pixels that become one unit of the library */
    size_t count;
    size_t samples;
    double *stated; /* room for the weights of a recording's strokes */
} sampled;

static void free_sampled(const duct_allocator *allocator, sampled *all)
{
    for (size_t i = 0; i < all->count; i++) {
        duct_samples_free(allocator, &all->items[i]);
    }
    duct_release(allocator, all->items);
    duct_release(allocator, all->weights);
    duct_release(allocator, all->units);
    duct_release(allocator, all->stated);
}

/* Samples a recording. The strokes of a scale are those that have so many times the size: sampled with as
 * many times smaller a unit. */
static duct_status sample_one(const duct_allocator *allocator, const duct_drawing *recording, double unit,
                              double weight, sampled *all, duct_error *error)
{
    duct_weights_read(recording, all->stated);
    for (size_t s = 0; s < duct_drawing_stroke_count(recording); s++) {
        duct_samples *item = &all->items[all->count];
        duct_status status =
            duct_samples_make(allocator, duct_drawing_stroke(recording, s), unit, item, error);
        if (status != DUCT_OK) {
            return status;
        }
        if (item->count == 0) {
            continue;
        }
        double product = weight * all->stated[s];
        all->weights[all->count] = fmax(DUCT_WEIGHT_LEAST, fmin(DUCT_WEIGHT_MOST, product));
        all->units[all->count] = unit;
        all->count++;
        all->samples += item->count;
        if (all->samples > DUCT_MAX_SAMPLES) {
            return duct_fail(error, DUCT_LIMIT,
                             "a library may have %d samples at most; use a larger unit or fewer scales",
                             DUCT_MAX_SAMPLES);
        }
    }
    return DUCT_OK;
}

static duct_status sample_all(const duct_allocator *allocator, const duct_drawing *const *recordings,
                              size_t count, double unit, const duct_library_options *options, sampled *all,
                              duct_error *error)
{
    static const double plain[] = {1};
    bool scaled = options != NULL && options->scale_count > 0;
    const double *scales = scaled ? options->scales : plain;
    size_t scale_count = scaled ? options->scale_count : 1, strokes = count_strokes(recordings, count);
    all->items = duct_alloc(allocator, strokes * scale_count, sizeof *all->items);
    all->weights = duct_alloc(allocator, strokes * scale_count, sizeof *all->weights);
    all->units = duct_alloc(allocator, strokes * scale_count, sizeof *all->units);
    all->stated = duct_alloc(allocator, strokes, sizeof *all->stated);
    if (all->items == NULL || all->weights == NULL || all->units == NULL || all->stated == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t k = 0; k < scale_count; k++) {
        for (size_t r = 0; r < count; r++) {
            double weight = options != NULL && options->weights != NULL ? options->weights[r] : 1;
            size_t first = all->count;
            duct_status status = sample_one(allocator, recordings[r], unit / scales[k], weight, all, error);
            if (status != DUCT_OK) {
                return status;
            }
            if (options != NULL && options->remove_position) {
                duct_position_remove(all->items + first, all->count - first);
            }
        }
    }
    return DUCT_OK;
}

static duct_status gather_channel(duct_library *library, const sampled *all, duct_channel channel,
                                  duct_error *error)
{
    for (size_t i = 0; i < all->count; i++) {
        if (all->items[i].channels[channel] == NULL) {
            return DUCT_OK;
        }
    }
    double *to = duct_alloc(&library->allocator, all->samples, sizeof *to);
    library->channels[channel] = to;
    if (to == NULL) {
        return duct_fail_memory(error);
    }
    size_t at = 0;
    for (size_t i = 0; i < all->count; i++) {
        const duct_samples *item = &all->items[i];
        double scale = channel == DUCT_X || channel == DUCT_Y ? 1 / all->units[i] : 1;
        for (size_t k = 0; k < item->count; k++) {
            to[at++] = item->channels[channel][k] * scale;
        }
    }
    return DUCT_OK;
}

/* Puts the samples one after the other into the library, X and Y in sampling units. */
static duct_status gather(duct_library *library, sampled *all, duct_error *error)
{
    library->stroke_count = all->count;
    library->sample_count = all->samples;
    library->starts = duct_alloc(&library->allocator, all->count + 1, sizeof *library->starts);
    duct_status status = library->starts != NULL ? DUCT_OK : duct_fail_memory(error);
    for (int c = 0; c < DUCT_CHANNEL_COUNT && status == DUCT_OK; c++) {
        status = gather_channel(library, all, (duct_channel)c, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    size_t at = 0;
    bool weighted = false;
    for (size_t i = 0; i < all->count; i++) {
        library->starts[i] = (uint32_t)at;
        at += all->items[i].count;
        weighted = weighted || all->weights[i] != 1;
    }
    library->starts[all->count] = (uint32_t)at;
    if (weighted) {
        library->weights = all->weights;
        all->weights = NULL;
    }
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
    double largest = 1;
    for (size_t k = 0; options != NULL && k < options->scale_count; k++) {
        largest = fmax(largest, options->scales[k]);
    }
    for (size_t r = 0; r < count; r++) {
        library->width = fmax(library->width, largest * duct_drawing_width(recordings[r]));
        library->height = fmax(library->height, largest * duct_drawing_height(recordings[r]));
    }
    return DUCT_OK;
}

static duct_status check_options(const duct_library_options *options, size_t count, duct_error *error)
{
    if (options->unit != 0 && (!(options->unit > 0) || !isfinite(options->unit))) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "the sampling unit must be a positive number of pixels");
    }
    if (options->scale_count > MOST_SCALES) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a library may have %d scales at most", MOST_SCALES);
    }
    for (size_t k = 0; k < options->scale_count; k++) {
        if (!(options->scales[k] >= SMALLEST_SCALE && options->scales[k] <= LARGEST_SCALE)) {
            return duct_fail(error, DUCT_BAD_ARGUMENT, "a scale must lie within %g and %g", SMALLEST_SCALE,
                             LARGEST_SCALE);
        }
    }
    for (size_t r = 0; options->weights != NULL && r < count; r++) {
        if (!duct_weight_valid(options->weights[r])) {
            return duct_fail(error, DUCT_BAD_ARGUMENT, "a recording's weight must lie within %g and %g",
                             DUCT_WEIGHT_LEAST, DUCT_WEIGHT_MOST);
        }
    }
    return DUCT_OK;
}

/* The unit: what the options say, or what the recording says it was sampled with, or by the median stroke. */
static duct_status choose_unit(const duct_allocator *allocator, const duct_drawing *const *recordings,
                               size_t count, const duct_library_options *options, double *unit,
                               duct_error *error)
{
    if (options != NULL && options->unit != 0) {
        *unit = options->unit;
        return DUCT_OK;
    }
    /* Libraries say what they were sampled with. Where they disagree, the strokes decide. */
    double stated = 0;
    bool agreed = true;
    for (size_t r = 0; agreed && r < count; r++) {
        const char *text = duct_drawing_annotation(recordings[r], DUCT_ANNOTATION_UNIT);
        double own = 0;
        agreed = text != NULL && duct_number_parse(text, &own) && own > 0 && (r == 0 || own == stated);
        stated = own;
    }
    if (agreed) {
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

static duct_status fill(duct_library *library, const duct_drawing *const *recordings, size_t count,
                        const duct_library_options *options, duct_error *error)
{
    sampled all = {.count = 0};
    duct_status status =
        sample_all(&library->allocator, recordings, count, library->unit, options, &all, error);
    if (status == DUCT_OK && all.count == 0) {
        status =
            duct_fail(error, DUCT_UNSUPPORTED, "no stroke has a length, so there is nothing to learn from");
    }
    if (status == DUCT_OK) {
        status = gather(library, &all, error);
    }
    free_sampled(&library->allocator, &all);
    return status;
}

duct_status duct_library_build(const duct_context *context, const duct_drawing *const *recordings,
                               size_t count, const duct_library_options *options, duct_library **library,
                               duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    double unit = 0;
    duct_status status = options != NULL ? check_options(options, count, error) : DUCT_OK;
    if (status == DUCT_OK) {
        status = choose_unit(allocator, recordings, count, options, &unit, error);
    }
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
    status = fill(made, recordings, count, options, error);
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
