/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_BASIS_H
#define DUCTUS_ANALOGY_BASIS_H

#include "analogy/cost.h"

/* Lower bounds for the matching term, for the fast search.
 *
 * A full neighbourhood, with its samples centred and all features times the roots of their weights, is a
 * complex vector, and the matching term of two of them is |a|^2 + |b|^2 - 2 |<a, b>| with a free rotation.
 * Split along an orthonormal basis of a few directions, a = Pa + a', |<a, b>| is at most |<Pa, Pb>| + |a'|
 * |b'|. The basis is chosen from the example's own vectors, greedily. */
typedef struct duct_basis duct_basis;

/* Errors: DUCT_NO_MEMORY. */
duct_status duct_basis_new(const duct_allocator *allocator, const duct_example_set *set, duct_basis **basis,
                           duct_error *error);
void duct_basis_free(const duct_allocator *allocator, duct_basis *basis);

/* Values of scratch memory that duct_basis_bounds() needs beside the bounds. */
size_t duct_basis_scratch(const duct_example_set *set);

/* Fills bounds[j] with no more than the matching term of each position, and estimates[j] with what it is
 * likely to be; 0 where the position lacks samples.
 * The query must be full in every slot that costs. */
void duct_basis_bounds(const duct_example_set *set, const duct_query *query, double *scratch, float *bounds,
                       float *estimates);

#endif
