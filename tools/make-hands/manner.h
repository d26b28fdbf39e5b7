/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_MANNER_H
#define MAKE_HANDS_MANNER_H

#include "shapes.h"

/* What a person does to a stroke that is planned: how it begins, and whether a long line is one stroke. */
typedef struct stroke_manner {
    double hook; /* pixels: how far from its start a stroke begins, before it turns into its way; 0: none */
    double hook_turn; /* radians from the stroke's first direction to the hook's beginning */
    double bow;       /* how far a straight line swings out, as a share of its length */
    double rounds;    /* how often closed rounds are gone round */
    double piece;   /* pixels: longer lines and arcs are drawn in pieces of about this length; 0: in one go */
    double overlap; /* of the pieces, as a share of their length */
} stroke_manner;

/* Puts the hook before the plan's first target. A plan that is full or has fewer than two targets stays. */
void manner_hook(const stroke_manner *manner, action_plan *plan);

/* How many strokes the person makes of a shape: at least 1. */
size_t manner_pieces(const stroke_manner *manner, const shape *form);

/* Stroke `index` of them. */
shape manner_piece(const stroke_manner *manner, const shape *form, size_t index);

#endif
