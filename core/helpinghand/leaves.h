/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_LEAVES_H
#define DUCTUS_HELPINGHAND_LEAVES_H

#include "helpinghand/sequence.h"

/* Where the optimal sequence can jump from: the best way to leave each candidate of a column. The same
 * numbers of all candidates lie side by side, so that several jumps are weighed at once. */
typedef struct duct_leaves {
    size_t count;
    double *costs;                    /* with the penalty of the segment that ends there, and C_t */
    double *linear[DUCT_JUMP_LINEAR]; /* the candidates' jump vectors */
    double *twist;
    unsigned *states;
    size_t first;    /* the cheapest one */
    double cheapest; /* without C_t */
} duct_leaves;

/* Room for `most` of them. False where there is no memory; freed by duct_leaves_free() even then. */
bool duct_leaves_make(duct_leaves *leaves, const duct_allocator *allocator, size_t most);
void duct_leaves_free(duct_leaves *leaves, const duct_allocator *allocator);

/* Fills them anew: clear, add each in order (cost infinite where none is), finish. */
void duct_leaves_clear(duct_leaves *leaves);
void duct_leaves_add(duct_leaves *leaves, const duct_jump_space *space, uint32_t sample, double cost,
                     unsigned state);
void duct_leaves_finish(duct_leaves *leaves, const duct_sequence_costs *costs);

/* From which candidate of `before` (that the leaves were made of) jumping to `here` costs least, and less
 * than
 * `*best`, which then becomes that cost; the first of equals. Their count where there is none. */
size_t duct_leaves_best(const duct_leaves *leaves, const duct_jump_space *space,
                        const duct_sequence_costs *costs, const duct_candidate *before,
                        const duct_candidate *here, double *best);

#endif
