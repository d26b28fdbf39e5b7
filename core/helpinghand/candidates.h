/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_CANDIDATES_H
#define DUCTUS_HELPINGHAND_CANDIDATES_H

#include "helpinghand/sequence.h"
#include "library/feature_index.h"

/* The candidates of a query stroke's samples: "HelpingHand" section 4.2. */
typedef struct duct_candidate_options {
    duct_feature_options features;
    size_t neighbours; /* k */
    bool coherent;     /* add the successors of the previous column's candidates */
    double variation;  /* 0: none; else each library stroke is made up to this much farther, by chance */
    uint64_t seed;
    uint64_t stroke_id; /* duct_random_id() of the query stroke */
} duct_candidate_options;

/* Fills columns for a query of `count` samples (x, y in sampling units, about one unit apart). The k nearest
 * of column i are
 * `*nearest` + i * k, by distance, where `nearest` is not NULL (fewer where the library is smaller: `*found`
 * a column). The caller releases both. Errors: DUCT_NO_MEMORY. */
duct_status duct_candidates_find(const duct_allocator *allocator, const duct_library *library,
                                 const duct_feature_index *index, const duct_candidate_options *options,
                                 const double *x, const double *y, size_t count, duct_columns *columns,
                                 duct_error *error);

void duct_columns_free(const duct_allocator *allocator, duct_columns *columns);

#endif
