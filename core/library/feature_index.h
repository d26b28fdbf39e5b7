/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_FEATURE_INDEX_H
#define DUCTUS_LIBRARY_FEATURE_INDEX_H

#include "features/features.h"
#include "search/search.h"

#include <ductus/library.h>

/* The features of all samples of a library, and a search index over them: made when first asked for, then
 * kept with the library; read from the library's index file where that fits. */
typedef struct duct_feature_index {
    size_t dimensions;
    const float *rows; /* by sample */
    const duct_search *search;
} duct_feature_index;

/* `index` is owned by the library. Safe from several threads. Errors: DUCT_NO_MEMORY, and those of
 * duct_search_new(). */
duct_status duct_library_features(const duct_library *library, const duct_feature_options *options,
                                  duct_search_kind search, duct_feature_index *index, duct_error *error);

/* Writes the index file beside the library's file: the features for the default options. */
duct_status duct_library_save_features(const duct_library *library, duct_error *error);

/* What `restyle` uses unless told otherwise, and index files hold. */
duct_feature_options duct_feature_options_default(void);

#endif
