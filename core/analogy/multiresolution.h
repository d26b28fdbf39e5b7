/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_MULTIRESOLUTION_H
#define DUCTUS_ANALOGY_MULTIRESOLUTION_H

#include "analogy/pyramid.h"
#include "analogy/single_scale.h"

/* Multiresolution synthesis ("Curve analogies" sections 3.4 and 3.5), over pyramids whose level 0 is the
 * finest. */
struct duct_analogy {
    duct_allocator allocator;
    duct_analogy_options options;
    size_t pair_count;
    bool has_a;
    bool extra;               /* all A' have the extra feature */
    size_t levels;            /* of each pyramid */
    duct_pyramid *a, *b;      /* by pair; a is empty without A */
    duct_example_set *refine; /* by level but the coarsest: { A, A' of the coarser level } : A' */
    size_t refine_count;
};

/* The example set for the first passes at a level: A : A' alone, or A' alone. `causal`: positions are A's
 * control points, so that one of B's is one of them. Errors: DUCT_NO_MEMORY, DUCT_LIMIT. */
duct_status duct_multiresolution_first_set(const duct_analogy *analogy, size_t level, bool causal,
                                           duct_example_set *set, duct_error *error);

/* The set of level `level` for refinement from the level above it. */
duct_status duct_multiresolution_refine_set(const duct_analogy *analogy, size_t level, duct_example_set *set,
                                            duct_error *error);

/* The level to start at for a curve of that length. */
size_t duct_multiresolution_start(const duct_analogy *analogy, double length);

#endif
