/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_RESAMPLE_H
#define DUCTUS_GEOMETRY_RESAMPLE_H

#include "base/memory.h"

#include <ductus/status.h>
#include <ductus/stroke.h>

/* Arc length, and sampling by it ("HelpingHand" section 3). */

/* Fills `at` with the arc length of each of `count` points from the first one (at[0] = 0) and returns the
 * last. */
double duct_arc_lengths(const double *x, const double *y, size_t count, double *at);

/* The value at arc length `where` of a channel given at increasing arc lengths `at`, linear between samples.
 * `*hint` is the search's starting place, 0 at first; asking for increasing places costs O(1) each. count
 * >= 1. */
double duct_interpolate(const double *at, const double *values, size_t count, double where, size_t *hint);

/* A stroke as uniform samples: `count` >= 2 samples, neighbours `step` drawing pixels of arc length apart. */
typedef struct duct_samples {
    size_t count;
    double step;
    double *channels[DUCT_CHANNEL_COUNT]; /* NULL where the stroke lacks it; X and Y in drawing pixels */
    double *at; /* the arc length at each of the stroke's own samples, along the line that was sampled */
} duct_samples;

/* Samples a stroke with a step near `unit` drawing pixels, both ends included; a closed stroke ends where it
 * began. Recorded strokes (those with time) whose samples are further apart than the unit are rounded by
 * Catmull-Rom curves between the samples; vector strokes keep their corners. A stroke without length gives
 * count 0. The caller frees the samples. Errors: DUCT_NO_MEMORY, DUCT_LIMIT (more than DUCT_MAX_SAMPLES). */
duct_status duct_samples_make(const duct_allocator *allocator, const duct_stroke *stroke, double unit,
                              duct_samples *samples, duct_error *error);
void duct_samples_free(const duct_allocator *allocator, duct_samples *samples);

/* The arc length of a stroke in drawing pixels, the closing line of a closed one included. */
double duct_stroke_length(const duct_stroke *stroke);

#endif
