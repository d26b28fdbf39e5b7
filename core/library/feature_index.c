/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/feature_index.h"

#include "base/error.h"
#include "library/library_private.h"

#include <stdio.h>

duct_feature_options duct_feature_options_default(void)
{
    return (duct_feature_options){DUCT_FEATURE_VELOCITIES, 40, 0.3};
}

static void feature_key(char key[96], const duct_feature_options *options)
{
    /* Hexadecimal, so that the key is exact and the same in every locale. */
    snprintf(key, 96, "features %d reach %a weight %a", (int)options->kind, options->reach, options->weight);
}

typedef struct {
    const duct_feature_options *options;
    const char *key;
} features_arg;

static duct_status make_rows(const duct_library *library, const void *arg, void **data, duct_error *error)
{
    const features_arg *self = arg;
    size_t dimensions = duct_feature_dimensions(self->options), count = library->sample_count;
    float *rows = duct_alloc(&library->allocator, count * dimensions, sizeof *rows);
    if (rows == NULL) {
        return duct_fail_memory(error);
    }
    if (!duct_index_read(library, self->key, rows, count, dimensions)) {
        for (size_t s = 0; s < library->stroke_count; s++) {
            size_t start = library->starts[s], size = library->starts[s + 1] - start;
            duct_status status = duct_features_compute(
                &library->allocator, self->options, library->channels[DUCT_X] + start,
                library->channels[DUCT_Y] + start, size, rows + start * dimensions, error);
            if (status != DUCT_OK) {
                duct_release(&library->allocator, rows);
                return status;
            }
        }
    }
    *data = rows;
    return DUCT_OK;
}

static void free_rows(void *data, const duct_allocator *allocator)
{
    duct_release(allocator, data);
}

typedef struct {
    duct_search_kind kind;
    const float *rows;
    size_t dimensions;
} search_arg;

static duct_status make_search(const duct_library *library, const void *arg, void **data, duct_error *error)
{
    const search_arg *self = arg;
    duct_search *search;
    duct_status status = duct_search_new(&library->allocator, self->kind, self->rows, library->sample_count,
                                         self->dimensions, library->starts, &search, error);
    if (status == DUCT_OK) {
        *data = search;
    }
    return status;
}

static void free_search(void *data, const duct_allocator *allocator)
{
    (void)allocator;
    duct_search_free(data);
}

duct_status duct_library_features(const duct_library *library, const duct_feature_options *options,
                                  duct_search_kind search, duct_feature_index *index, duct_error *error)
{
    char key[96], search_key[128];
    feature_key(key, options);
    snprintf(search_key, sizeof search_key, "search %d over %s", (int)search, key);
    features_arg arg = {options, key};
    const void *rows, *made;
    duct_status status = duct_library_get_part(library, key, make_rows, &arg, free_rows, &rows, error);
    if (status != DUCT_OK) {
        return status;
    }
    search_arg question = {search, rows, duct_feature_dimensions(options)};
    status = duct_library_get_part(library, search_key, make_search, &question, free_search, &made, error);
    if (status == DUCT_OK) {
        *index = (duct_feature_index){question.dimensions, rows, made};
    }
    return status;
}

duct_status duct_library_save_features(const duct_library *library, duct_error *error)
{
    duct_feature_options options = duct_feature_options_default();
    char key[96];
    feature_key(key, &options);
    features_arg arg = {&options, key};
    const void *rows;
    duct_status status = duct_library_get_part(library, key, make_rows, &arg, free_rows, &rows, error);
    if (status != DUCT_OK || library->index_path == NULL) {
        return status;
    }
    return duct_index_write(library, library->index_path, key, rows, library->sample_count,
                            duct_feature_dimensions(&options), error);
}
