/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_GLYPHS_H
#define MAKE_HANDS_GLYPHS_H

#include "plan.h"

/* Letterforms as action plans, designed for Ductus: no font was copied.
 *
 * Units are hundredths of the x-height, x to the right, y up, upright, the baseline at 0. A form is written
 * as targets "x,y" separated by spaces, strokes separated by "/". Before a target, "!" makes it a corner and
 * "=" makes the movement towards it straight. Where letters are joined, the pen goes on from the first
 * stroke's last target to the next letter's first one, and the other strokes (dots, bars) are written when
 * the joined run ends. */
typedef struct glyph {
    char letter;
    int advance;    /* to the next letter's 0 */
    bool joins_in;  /* may be reached from the letter before without lifting the pen */
    bool joins_out; /* may go on to the next letter without lifting the pen */
    const char *form;
} glyph;

typedef struct alphabet {
    const glyph *glyphs;
    size_t count;
} alphabet;

/* A round, slightly running hand. */
extern const alphabet alphabet_running;
/* A brisk print without curves where a corner will do. */
extern const alphabet alphabet_angular;
/* A looped, joined hand for a strong slant. */
extern const alphabet alphabet_copperplate;

/* The letter's glyph, or NULL. */
const glyph *alphabet_find(const alphabet *letters, char letter);

/* Where a form lies on the page: x = left + size/100 (gx + slant gy), y = baseline - size/100 gy. */
typedef struct glyph_place {
    double left, baseline; /* pixels */
    double size;           /* x-height in pixels */
    double slant;          /* dx for one dy */
} glyph_place;

/* The number of strokes in a form. */
size_t glyph_strokes(const glyph *letter);

/* Appends the targets of stroke `stroke` (from 0) to the plan. The first is a corner where the plan already
 * holds targets and the form says so. False where the form is malformed or the plan is full. */
bool glyph_write(const glyph *letter, size_t stroke, const glyph_place *place, action_plan *plan);

#endif
