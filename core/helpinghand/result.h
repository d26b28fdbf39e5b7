/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_RESULT_H
#define DUCTUS_HELPINGHAND_RESULT_H

#include "helpinghand/gesture.h"
#include "helpinghand/helpinghand.h"

/* What was synthesized for the uniform samples of a query stroke: positions in sampling units, and gestures
 * for pose. */
typedef struct duct_result {
    size_t count;
    double unit;      /* drawing pixels a sampling unit */
    double step;      /* drawing pixels of arc length between the uniform samples */
    const double *at; /* arc length at each of the stroke's own samples, drawing pixels */
    bool closed;      /* the last uniform sample is the first one again */
    double *x, *y;
    duct_gesture *gestures;
} duct_result;

/* False where the options leave nothing of this stroke to synthesize. */
bool duct_result_wanted(const duct_helpinghand *hand, const duct_stroke *stroke);

/* Between two gestures, at `share` of the way. */
duct_gesture duct_gesture_between(const duct_gesture *a, const duct_gesture *b, double share);

/* Brings a result back into the stroke it was made for: at the stroke's own samples, and at more between
 * those that are far apart; mixed with what was there by the options' amount. Errors: DUCT_NO_MEMORY,
 * DUCT_LIMIT; the stroke is then as it was. */
duct_status duct_result_apply(const duct_helpinghand *hand, const duct_result *result, duct_stroke *stroke,
                              duct_error *error);

/* A stroke without length has no shape to compare: it gets the library's mean pose. Errors: DUCT_NO_MEMORY.
 */
duct_status duct_result_apply_dot(const duct_helpinghand *hand, duct_stroke *stroke, duct_error *error);

#endif
