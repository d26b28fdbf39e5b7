/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DIAGRAM_PALETTE_H
#define DUCTUS_DIAGRAM_PALETTE_H

#include "picture/picture.h"

#include <ductus/diagram.h>

/* How many colours a palette is cut into, so that lines of nearly one value become one line in the file. */
enum { DUCT_PALETTE_STEPS = 48 };

/* The colour for `share` of the way from the lowest value to the highest; cut off outside 0..1. */
duct_ink duct_palette_ink(duct_diagram_palette palette, double share);

/* A colour for thing number `index`: ten that differ in hue and, from one to the next, in lightness. */
duct_ink duct_palette_category(size_t index);

#endif
