/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DIAGRAM_SHOWN_H
#define DUCTUS_DIAGRAM_SHOWN_H

#include "geometry/resample.h"

#include <ductus/diagram.h>

/* A drawing made ready to be shown: each stroke as uniform samples, fine enough for the picture, with the
 * value that its colour shows. */
typedef struct duct_shown_stroke {
    const duct_stroke *stroke;
    duct_samples samples; /* count 1: a dot; 0: a stroke without samples */
    double *values;       /* one a sample; NULL: the stroke has no such value */
} duct_shown_stroke;

typedef struct duct_shown {
    duct_shown_stroke *strokes;
    size_t count;
    double box[4]; /* of the samples, drawing pixels */
} duct_shown;

/* Samples every `step` drawing pixels, or wider where the drawing is too long for that. Errors:
 * DUCT_NO_MEMORY, DUCT_LIMIT. The caller frees it with duct_shown_free(). */
duct_status duct_shown_make(const duct_allocator *allocator, const duct_drawing *drawing, duct_diagram_by by,
                            double step, duct_shown *shown, duct_error *error);
void duct_shown_free(const duct_allocator *allocator, duct_shown *shown);

/* The range of colours for the values of all that is shown together: all but the outermost hundredths. Turns
 * angles of the barrel to within half a turn of their common mean first, in place. False where there are no
 * values. Errors by `status`: DUCT_NO_MEMORY. */
bool duct_shown_range(const duct_allocator *allocator, duct_shown *shown, size_t count, duct_diagram_by by,
                      double *low, double *high, duct_status *status, duct_error *error);

#endif
