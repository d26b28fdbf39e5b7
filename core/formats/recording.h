/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_RECORDING_H
#define DUCTUS_FORMATS_RECORDING_H

/* What the formats of pen recordings have in common. */

#include <ductus/drawing.h>

#include <stdbool.h>
#include <stddef.h>

#define DUCT_PI 3.141592653589793

/* The tilts of a pen whose tip points away from `azimuth` (0: the pen leans to the right, pi/2: towards the
 * user) and that stands `altitude` above the page, all in radians, by the formulas of W3C Pointer Events. */
void duct_recording_tilt(double azimuth, double altitude, double *tilt_x, double *tilt_y);

/* Turns measured values into those that duct_stroke promises: time that runs backwards stands still, pressure
 * is kept within 0..1 and tilt within -pi/2..pi/2, and twist (in radians, any turn) is unwrapped: no step is
 * longer than half a turn. Values have to be finite. */
void duct_recording_tidy(duct_stroke *stroke);

/* Replaces each NAN by the known value before it, or by the first known one; false where none is known. */
bool duct_recording_fill_gaps(double *values, size_t size);

/* Lines of a text, one by one. */
typedef struct duct_lines {
    const char *at, *end;
    long number; /* of the line that duct_lines_next() gave last, from 1 */
} duct_lines;

/* Skips a byte order mark. */
void duct_lines_init(duct_lines *lines, const char *data, size_t size);

/* The next line, without the spaces at both its ends and its line break; false at the end of the text. Line
 * breaks are LF, CR LF or CR. */
bool duct_lines_next(duct_lines *lines, const char **line, size_t *size);

/* The next line that is not empty. */
bool duct_lines_next_filled(duct_lines *lines, const char **line, size_t *size);

/* Makes a stroke's id of its index. Errors: DUCT_NO_MEMORY, DUCT_LIMIT. */
duct_status duct_recording_add_stroke(duct_drawing *drawing, size_t size, duct_stroke **stroke,
                                      duct_error *error);

#endif
