/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_ANALOGY_NEIGHBOURHOOD_H
#define DUCTUS_ANALOGY_NEIGHBOURHOOD_H

#include "analogy/curve.h"

/* The samples of a curve around one of its places, spaced evenly in arc length ("Curve analogies" section
 * 3.1): 2 `reach` + 1 of them, of which `low` .. `high` (offsets from the centre) are there; beyond the ends
 * of an open curve, and ahead of what is made in a causal pass, there are none (low > high: none at all). */
typedef struct duct_neighbourhood {
    int low, high;
    double centre[2];
    double *x, *y; /* by offset + reach; relative to the centre */
    double *u, *v; /* the tangent features: unit vectors from the sample before; 0 at `low` */
    double *extra; /* the extra feature, or NULL */
} duct_neighbourhood;

/* Values a neighbourhood of that reach takes in one block. */
#define DUCT_NEIGHBOURHOOD_ROOM(reach) (5 * (2 * (size_t)(reach) + 1))

/* Lays the arrays into a block of DUCT_NEIGHBOURHOOD_ROOM values. */
void duct_neighbourhood_lay(duct_neighbourhood *samples, double *block, int reach, bool extra);

/* Samples around a place of the curve. */
void duct_neighbourhood_around(const duct_curve *curve, duct_place place, double spacing, int reach,
                               duct_neighbourhood *samples);

/* The causal neighbourhood of a control point that is still to come, `gap` behind the curve's last one, which
 * is number `made` - 1: samples before it only. Relative to that last one. */
void duct_neighbourhood_before(const duct_curve *curve, size_t made, double gap, double spacing, int reach,
                               duct_neighbourhood *samples);

/* w_k: a binomial, 1 in the middle (section 3.6). `neighbourhood` is odd; fills 2 reach + 1 of them. */
void duct_neighbourhood_weights(int neighbourhood, int reach, double *weights);

/* What two neighbourhoods have to do with each other: weighted sums over the samples that both have. */
typedef struct duct_alignment {
    double mass;       /* sum of the weights */
    double a[2], b[2]; /* centres of mass, each relative to its centre */
    double squares;    /* sum w (|a - mean|^2 + |b - mean|^2), and of the tangents with their weight */
    double product[2]; /* sum w conj(a) b as a complex number, centred, and that of the tangents */
    double extra;      /* sum w (a - b)^2 of the extra features, where both have them */
} duct_alignment;

/* sum w (a - b)^2 of the extra features of two that lack no sample. */
double duct_align_extra(const duct_neighbourhood *a, const duct_neighbourhood *b, int reach,
                        const double *weights);

/* For a neighbourhood that lacks no sample: its centre of mass and what it adds to `squares`, once for all it
 * is compared with, and its features times the weights, in one block of DUCT_WEIGHTED_ROOM values. */
typedef struct duct_full_sums {
    double mean[2], squares;
} duct_full_sums;

#define DUCT_WEIGHTED_ROOM(reach) (4 * (2 * (size_t)(reach) + 1))

void duct_align_prepare(const duct_neighbourhood *samples, int reach, const double *weights, double tangent,
                        duct_full_sums *sums, double *weighted /* or NULL */);

/* The same as duct_align() for two that lack no sample, but for the extra feature, from what was prepared. */
void duct_align_full(const duct_neighbourhood *a, const duct_full_sums *a_sums, const double *b_weighted,
                     const duct_full_sums *b_sums, int reach, double mass, duct_alignment *sums);

/* Both must have the same reach. With weights w_k and tangents weighing `tangent` times as much. For a
 * rotation R as a complex number, sum w (|R a + t - b|^2 + tangent |R a' - b'|^2) with the best t is squares
 * - 2 Re(conj(R) product); the best R is product / |product|. */
void duct_align(const duct_neighbourhood *a, const duct_neighbourhood *b, int reach, const double *weights,
                double tangent, duct_alignment *sums);

#endif
