/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATIONS_ANALOGY_STROKES_H
#define DUCTUS_OPERATIONS_ANALOGY_STROKES_H

/* The strokes of a drawing as curves to be styled, and the constraints that hold them together. */

#include "analogy/analogy.h"
#include "operations/stroke_list.h"

/* A stroke, or a piece of one between two corners, in drawing pixels. */
typedef struct duct_piece {
    size_t stroke, part; /* the stroke's number; which of its pieces, from 0 */
    size_t style;
    duct_curve curve;                   /* its parameter is its own */
    double from, to;                    /* where it lies on its stroke, shares of the stroke's length */
    duct_curve_constraint *constraints; /* in drawing pixels */
    size_t constraint_count, constraint_capacity;
    bool join;
} duct_piece;

typedef struct duct_pieces {
    const duct_allocator *allocator;
    duct_piece *items;
    size_t count, capacity;
} duct_pieces;

void duct_pieces_done(duct_pieces *pieces);

/* Adds a stroke's pieces: one, or cut at its corners. A stroke without length gives none. Errors:
 * DUCT_NO_MEMORY. */
duct_status duct_pieces_add(duct_pieces *pieces, const duct_stroke *stroke, size_t number, size_t style,
                            bool split, bool join, duct_error *error);

/* Fixes ends of joining curves that lie within `reach` of each other at one place, and ends that lie on
 * another curve to it ("Curve analogies" section 4, Figure 10). Errors: DUCT_NO_MEMORY. */
duct_status duct_pieces_join(duct_pieces *pieces, double reach, duct_error *error);

/* Holds all open curves' ends that nothing holds yet where they are. Errors: DUCT_NO_MEMORY. */
duct_status duct_pieces_hold_ends(duct_pieces *pieces, double weight, duct_error *error);

/* Makes the nearest curve pass through each of the strokes of a list: a dot is its point, anything else the
 * centre of its box. Errors: DUCT_NO_MEMORY. */
duct_status duct_pieces_pin(duct_pieces *pieces, const duct_drawing *drawing, const duct_stroke_list *pins,
                            double weight, duct_error *error);

#endif
