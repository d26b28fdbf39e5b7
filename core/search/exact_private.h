/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_SEARCH_EXACT_PRIVATE_H
#define DUCTUS_SEARCH_EXACT_PRIVATE_H

#include "search/search_private.h"

#include <float.h>

/* The exact search's index: what exact_build.c makes and exact.c walks.
 *
 * Coordinates are few numbers for a row whose Euclidean distance never exceeds that of the feature vectors:
 * the row's shares along the directions in which the rows spread most (principal axes), and the length of
 * what these leave over. Rows are put into leaves that are small in these coordinates, leaves into groups of
 * eight, groups into groups, each with a box around it. */
enum {
    DUCT_EXACT_LANES = 8, /* boxes a group */
    DUCT_EXACT_LEAF = 16, /* rows a leaf */
    DUCT_EXACT_LEVELS = 12,
    DUCT_EXACT_MOST_DIMENSIONS = 256,
    DUCT_EXACT_MOST_COORDINATES = 24 /* a multiple of 8 */
};

typedef struct duct_exact_level {
    size_t groups;
    float *boxes; /* [group][coordinate][middle, half width][lane] */
} duct_exact_level;

typedef struct duct_exact {
    duct_search base;
    bool plain;         /* rows that are not finite, or too large, have no coordinates: scan them all */
    size_t coordinates; /* a multiple of 8 */
    double *axes;       /* [dimension][coordinate]; that of the last coordinate is 0 */
    double *centre;     /* [dimension] */
    double largest;     /* of all rows' coordinates */
    size_t leaves;
    uint32_t *order; /* [leaf][DUCT_EXACT_LEAF]: row numbers */
    float *places;   /* [leaf][coordinate][DUCT_EXACT_LEAF]; infinite where a leaf has fewer rows */
    size_t level_count;
    duct_exact_level levels[DUCT_EXACT_LEVELS]; /* the first one's boxes are leaves, the last has one group */
} duct_exact;

/* The coordinates of a row. False where they are not finite or too large to be of use. */
bool duct_exact_place(const duct_exact *self, const float *row, float *place);

/* Fills everything beyond `base`, whose fields are set. Errors: DUCT_NO_MEMORY; what was made by then is
 * released by duct_exact_release(). */
duct_status duct_exact_build(duct_exact *self, duct_error *error);
void duct_exact_release(duct_exact *self);

#endif
