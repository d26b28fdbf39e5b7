/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_REPORT_PATCHES_H
#define DUCTUS_REPORT_PATCHES_H

#include "library/library_private.h"
#include "search/search.h"

/* The patches of a library, "HelpingHand" section 3.1: 2 n + 1 neighbouring samples of a stroke around each
 * sample that has n on both sides, in the order of the samples. */
typedef struct duct_patches {
    size_t count;
    size_t radius;       /* n */
    size_t dimensions;   /* of a feature vector: 2 (2 n + 1) tangents, x-, x+ */
    float *features;     /* by patch */
    uint32_t *centres;   /* by patch: the library's sample */
    uint32_t *strokes;   /* by patch */
    uint32_t *starts;    /* stroke s has patches starts[s] .. starts[s + 1] - 1 */
    duct_search *search; /* NULL where there is no patch */
    const duct_library *library;
} duct_patches;

/* The caller frees the patches; the library must outlive them. Errors: DUCT_NO_MEMORY. */
duct_status duct_patches_make(const duct_allocator *allocator, const duct_library *library, size_t radius,
                              duct_patches *patches, duct_error *error);
void duct_patches_free(const duct_allocator *allocator, duct_patches *patches);

/* What stands for a patch that has no partner. */
#define DUCT_PATCH_NONE UINT32_MAX

/* For each patch of `from` the most similar one of `to`, of another stroke where both are the same:
 * `partners` and `distances` have room for from->count. Ties go to the lower patch. Reports progress from
 * `begin` to `end`. Errors: DUCT_NO_MEMORY, DUCT_CANCELLED. */
duct_status duct_patches_pair(const duct_context *context, const duct_patches *from, const duct_patches *to,
                              double begin, double end, uint32_t *partners, float *distances,
                              duct_error *error);

#endif
