/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_STROKE_H
#define DUCTUS_STROKE_H

#include <ductus/context.h>
#include <ductus/status.h>

#include <stdbool.h>
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A stroke: one line drawn without lifting the pen, as parallel arrays, one array a channel.
 *
 * A channel is present for all samples or for none. Absent is not zero: a pen that has no tilt sensor gives a
 * stroke without DUCT_TILT_X. X and Y are always present. All values are finite. A stroke belongs to its
 * drawing and is freed with it. */
typedef struct duct_stroke duct_stroke;

typedef enum duct_channel {
    DUCT_X,        /* drawing pixels (1/96 inch unless the page says otherwise), to the right */
    DUCT_Y,        /* drawing pixels, down */
    DUCT_T,        /* seconds, never decreasing along a stroke */
    DUCT_PRESSURE, /* 0..1 */
    DUCT_TILT_X,   /* radians, -pi/2..pi/2, as tiltX of W3C Pointer Events: positive leans to the right */
    DUCT_TILT_Y,   /* radians, -pi/2..pi/2, as tiltY: positive leans towards the user */
    DUCT_TWIST, /* radians, clockwise turn of the barrel as twist of Pointer Events; unwrapped along a stroke
                 */
    DUCT_CHANNEL_COUNT
} duct_channel;

/* How the host draws the stroke's line. */
typedef struct duct_stroke_style {
    float red, green, blue; /* 0..1, sRGB-encoded */
    float opacity;          /* 0..1 */
    double width;           /* full line width in drawing pixels; 0 where the source states none */
} duct_stroke_style;

/* The channel's English name in lower case, e.g. "pressure", "tilt_x". Static storage. */
DUCT_API const char *duct_channel_name(duct_channel channel);

/* The number of samples; 0 is possible. */
DUCT_API size_t duct_stroke_size(const duct_stroke *stroke);

/* The channel's duct_stroke_size() values, or NULL where the channel is absent. Owned by the stroke; valid
 * until the stroke is resized or the channel dropped. */
DUCT_API const double *duct_stroke_values(const duct_stroke *stroke, duct_channel channel);

/* The same for writing, adding the channel (all 0) where it is absent. NULL when there is no memory for it.
 */
DUCT_API double *duct_stroke_edit(duct_stroke *stroke, duct_channel channel);

/* Makes a channel absent. X and Y cannot be dropped: asking for it does nothing. */
DUCT_API void duct_stroke_drop(duct_stroke *stroke, duct_channel channel);

/* Sets the number of samples. New samples are 0 in every channel that is present.
 * Errors: DUCT_NO_MEMORY, DUCT_LIMIT (the stroke is as it was). */
DUCT_API duct_status duct_stroke_resize(duct_stroke *stroke, size_t size, duct_error *error);

/* The id that the host gave; seeds the stroke's randomness. Never NULL, possibly "". */
DUCT_API const char *duct_stroke_id(const duct_stroke *stroke);

/* Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_stroke_set_id(duct_stroke *stroke, const char *id, duct_error *error);

/* The path of groups (layers, InkML trace groups) that hold the stroke, outermost first, joined by '/', or
 * "". */
DUCT_API const char *duct_stroke_group(const duct_stroke *stroke);
DUCT_API duct_status duct_stroke_set_group(duct_stroke *stroke, const char *group, duct_error *error);

DUCT_API duct_stroke_style duct_stroke_get_style(const duct_stroke *stroke);
DUCT_API void duct_stroke_set_style(duct_stroke *stroke, duct_stroke_style style);

/* A closed stroke's last sample is joined to its first, which is not repeated. */
DUCT_API bool duct_stroke_closed(const duct_stroke *stroke);
DUCT_API void duct_stroke_set_closed(duct_stroke *stroke, bool closed);

#ifdef __cplusplus
}
#endif

#endif
