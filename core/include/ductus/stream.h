/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_STREAM_H
#define DUCTUS_STREAM_H

#include <ductus/library.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Pose for a stroke while it is being drawn: "HelpingHand" section 6, the weighted average of section 4.2.2
 * "on-the-fly". Each sample is compared by the line that led to it; what the pen will do next is unknown and
 * not compared, and the end of the stroke is taken to be far away (x+ of section 4.1 is 1) until
 * duct_stream_flush(). The finished stroke restyled with `select` optimal looks better; this is for the eye
 * during drawing.
 *
 * The same samples give the same poses on every run. A push takes the same time whatever the stroke's length,
 * and allocates nothing. docs/streaming.md tells the rest. */
typedef struct duct_stream duct_stream;

typedef struct duct_stream_options {
    double unit; /* drawing pixels a sampling unit; 0: the library's, as if drawn where it was recorded */
    const char *features; /* "velocities" or "contexts", as the parameter of `restyle` */
    int neighbours;       /* how many similar places are averaged: 1..100 */
    double reach;         /* how far behind a sample its line is compared, in units: 7..500 */
    double weight;        /* how much shape counts beside the closeness to the stroke's start: 0..100 */
    double smoothing;     /* poses follow the average with this lag, in units of arc length: 0..100 */
} duct_stream_options;

/* unit 0, "velocities", neighbours 20, reach 40, weight 0.3, smoothing 2. */
DUCT_API duct_stream_options duct_stream_options_default(void);

/* What the hand does at a sample, in the units of duct_channel. A channel that duct_library_has() not is 0.
 */
typedef struct duct_stream_pose {
    double pressure, tilt_x, tilt_y;
    double twist; /* unwrapped along a stroke */
} duct_stream_pose;

/* A stream with no stroke begun. `library` must outlive it; several streams may share one. `options` may be
 * NULL. The caller frees it. Errors: DUCT_UNSUPPORTED (the library has no pose channel), DUCT_BAD_ARGUMENT
 * (an option outside its range), DUCT_NO_MEMORY. */
DUCT_API duct_status duct_stream_new(const duct_context *context, const duct_library *library,
                                     const duct_stream_options *options, duct_stream **stream,
                                     duct_error *error);
DUCT_API void duct_stream_free(duct_stream *stream); /* NULL is allowed */

/* Takes the next sample of the stroke, (x, y) in drawing pixels at `t` seconds, and gives the pose for it.
 * The first sample after duct_stream_new() or duct_stream_flush() begins a stroke. Samples may come as dense
 * as they like, or in place. After an error the stream is as it was. Errors: DUCT_BAD_ARGUMENT (a number that
 * is not finite, or time that goes back), DUCT_LIMIT (a coordinate above 1e9 sampling units). */
DUCT_API duct_status duct_stream_push(duct_stream *stream, double x, double y, double t,
                                      duct_stream_pose *pose, duct_error *error);

/* Ends the stroke and makes the stream ready for another. True where there was a stroke; `pose` (which may be
 * NULL) is then the pose of its last sample again, now that it is known to be the end: as the hand leaves the
 * paper, and not smoothed. */
DUCT_API bool duct_stream_flush(duct_stream *stream, duct_stream_pose *pose);

#ifdef __cplusplus
}
#endif

#endif
