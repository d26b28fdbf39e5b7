/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_POSITION_H
#define DUCTUS_LIBRARY_POSITION_H

#include "geometry/resample.h"

/* Takes the influence of the position on the page out of the pose, "HelpingHand" section 3.2: fits a
 * quadratic polynomial in x and y to each pose attribute of all samples by least squares, subtracts it, and
 * adds the attribute's mean. Twist is taken on the circle; pressure stays in 0..1. Where the positions do not
 * determine the polynomial (all on a line), only what they determine is removed. An attribute that some of
 * the strokes lack is left alone. The strokes should be one recording's: each has a page of its own. */
void duct_position_remove(duct_samples *strokes, size_t count);

#endif
