/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_GESTURE_H
#define DUCTUS_HELPINGHAND_GESTURE_H

#include "helpinghand/sequence.h"
#include "library/library_private.h"

/* What a library sample gives to a query sample: its pose and its velocity. The twist is kept as a point on
 * the circle, so that sums of gestures average it circularly. */
typedef struct duct_gesture {
    double pressure, tilt_x, tilt_y, twist_cos, twist_sin;
    double vx, vy; /* sampling units a sample: from the sample before (from itself to the next one at a
                      stroke's start) */
} duct_gesture;

/* Channels that the library lacks are 0. */
duct_gesture duct_gesture_of(const duct_library *library, uint32_t sample, uint32_t stroke);

/* The gestures of a query's samples by the closest neighbour (section 4.2.1). */
void duct_gestures_closest(const duct_library *library, const duct_columns *columns, duct_gesture *gestures);

/* By the average of all candidates with weights 1/distance (section 4.2.2). */
void duct_gestures_average(const duct_library *library, const duct_columns *columns, duct_gesture *gestures);

/* Along a chosen sequence, cross-faded at its jumps over up to `blend` samples on each side (section 4.3.1):
 * as far as the library strokes on both sides go on, and no farther than half of a segment, so that two fades
 * never meet. */
void duct_gestures_sequence(const duct_library *library, const duct_columns *columns, const size_t *chosen,
                            size_t blend, duct_gesture *gestures);

/* True where the transition from column i to i + 1 is a jump. */
bool duct_is_jump(const duct_columns *columns, const size_t *chosen, size_t i);

#endif
