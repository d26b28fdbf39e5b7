/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_WEIGHTS_H
#define DUCTUS_LIBRARY_WEIGHTS_H

#include "base/text.h"

#include <ductus/drawing.h>

/* The smallest weight and the largest. */
#define DUCT_WEIGHT_LEAST 0.001
#define DUCT_WEIGHT_MOST 1000.0

bool duct_weight_valid(double weight);

/* A library's file keeps its strokes' weights as an annotation: runs of equal weights in the strokes' order,
 * each as WEIGHT*COUNT, e.g. "2*138 1*120". */
void duct_weights_print(duct_text *out, const double *weights, size_t count);

/* The weights of a recording's strokes that its annotation states; all 1 where there is none, or one that
 * does not fit. `weights` has room for them. True where any differs from 1. */
bool duct_weights_read(const duct_drawing *recording, double *weights);

#endif
