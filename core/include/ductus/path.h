/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_PATH_H
#define DUCTUS_PATH_H

#include <ductus/drawing.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Vector paths, as the editors of all hosts have them: subpaths of straight lines and cubic Bezier curves.
 * A host makes a path of its own curves, flattens it to strokes for an operation, and fits the operation's
 * strokes back to a path with few nodes.
 *
 * Calls that append have no status: a failed allocation makes the path fail for good, all further calls on it
 * do nothing, and whoever reads it gets DUCT_NO_MEMORY or NULL. So a maker checks once at its end. */
typedef struct duct_path duct_path;

typedef enum duct_path_verb {
    DUCT_PATH_MOVE,  /* 1 point */
    DUCT_PATH_LINE,  /* 1 point */
    DUCT_PATH_CUBIC, /* 3 points: two controls and the end */
    DUCT_PATH_CLOSE  /* no point */
} duct_path_verb;

/* An empty path. The caller frees it with duct_path_free(). Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_path_new(const duct_context *context, duct_path **path, duct_error *error);
DUCT_API void duct_path_free(duct_path *path); /* NULL is allowed */

/* Takes everything out of the path, a failure too. */
DUCT_API void duct_path_clear(duct_path *path);

DUCT_API void duct_path_move(duct_path *path, double x, double y);
DUCT_API void duct_path_line(duct_path *path, double x, double y);
DUCT_API void duct_path_cubic(duct_path *path, double x1, double y1, double x2, double y2, double x,
                              double y);
DUCT_API void duct_path_close(duct_path *path);

/* Appends what the value of an SVG `d` attribute describes, arcs and quadratic curves as cubic ones. As SVG
 * has it, an error in the text ends the path: what stands before it is kept. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_path_add_svg(duct_path *path, const char *d, duct_error *error);

/* The path as the value of a `d` attribute: absolute commands, `decimals` (0..15) digits behind the point.
 * Free with duct_memory_free(). Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_path_svg(const duct_context *context, const duct_path *path, int decimals,
                                   char **text, duct_error *error);

/* The verbs, one byte each (duct_path_verb), and the points x, y, x, y ... that they take, `*count` of them.
 * Owned by the path; valid until it is changed. NULL where there are none, or the path has failed. */
DUCT_API const unsigned char *duct_path_verbs(const duct_path *path, size_t *count);
DUCT_API const double *duct_path_points(const duct_path *path, size_t *count);

/* How many nodes an editor shows: moves, line ends and curve ends. */
DUCT_API size_t duct_path_nodes(const duct_path *path);

/* Maps all points in place by SVG's matrix(a b c d e f). */
DUCT_API void duct_path_map(duct_path *path, const double matrix[6]);

/* Appends a stroke to the drawing for each subpath that draws something, flattened so that the polyline stays
 * within `tolerance` (drawing pixels, above 0) of the curves. Their ids are `id`, and `id`/2, `id`/3 ... for
 * the second subpath and on; a subpath that is only a move is counted and left out. Their channels are x and
 * y; their style is the default of duct_drawing_add_stroke(). On failure the drawing may have some of them.
 * Errors: DUCT_NO_MEMORY, DUCT_LIMIT (too many points, or one beyond 1e9 pixels), DUCT_BAD_ARGUMENT (a point
 * that is not finite, or a tolerance that is not positive). */
DUCT_API duct_status duct_path_flatten(const duct_path *path, const char *id, double tolerance,
                                       duct_drawing *drawing, duct_error *error);

/* Appends the stroke's line as one subpath of cubic curves and straight lines with few nodes, within
 * `tolerance` (drawing pixels) of the samples: least-squares fitting between corners, which are kept. Samples
 * without times are taken for the corners of a line that was flattened, those with times for places on a
 * smooth one. One sample gives a line of no length (a dot under round caps), none nothing. Errors:
 * DUCT_NO_MEMORY, DUCT_BAD_ARGUMENT (a value that is not finite, or a tolerance that is not positive). */
DUCT_API duct_status duct_path_fit(duct_path *path, const duct_stroke *stroke, double tolerance,
                                   duct_error *error);

/* The pen's width along a path that duct_path_fit() made of the stroke: a width at each of a few places
 * between which it changes evenly. */
typedef struct duct_width {
    double at;    /* place on the subpath: its nodes are 0, 1, 2 ..., and between two of them stands the
                     parameter t of their curve */
    double width; /* full width, drawing pixels */
} duct_width;

/* A nib that follows a stroke's pose: an ellipse whose size follows pressure, whose aspect follows tilt, and
 * whose angle follows twist (the lean's direction where there is no twist). */
typedef struct duct_nib_options {
    double width;         /* full line width at pressure 0.5, in drawing pixels; 0: the stroke's own, or 1 */
    double thinnest;      /* width at pressure 0, as a share of `width` */
    double thickest;      /* width at pressure 1, as a share of `width` */
    double aspect;        /* nib's long over short axis when the pen is upright; 1 is round */
    double fit_tolerance; /* largest distance of an outline from the true one, drawing pixels */
} duct_nib_options;

/* width 0, thinnest 0.3, thickest 1.7, aspect 1.5, fit_tolerance 0.1. */
DUCT_API duct_nib_options duct_nib_options_default(void);

/* Appends the outline of what the nib covers along the stroke: outer contours and holes as closed subpaths,
 * holes against the sense of the outer ones, to be filled with either rule. They do not cross, but where
 * edges come closer to each other than the tolerance, and then by no more. Without pressure the width is
 * constant; without twist and tilt the nib is round. One sample gives a dot; none gives nothing. `options`
 * may be NULL. On failure the path is as it was. Errors: DUCT_NO_MEMORY, DUCT_UNSUPPORTED (the geometry
 * library failed; the sentence says so). */
DUCT_API duct_status duct_path_outline(duct_path *path, const duct_stroke *stroke,
                                       const duct_nib_options *options, duct_error *error);

/* The widths across the stroke's line that the nib gives, as few places as keep every one within `tolerance`
 * (drawing pixels) of the true width, for subpath `subpath` (from 0) of `path`, which duct_path_fit() made of
 * the stroke. For editors that draw a line's width themselves. First and last place are the subpath's ends.
 * Free with duct_memory_free(). `options` may be NULL. Errors: DUCT_NO_MEMORY, DUCT_BAD_ARGUMENT (no such
 * subpath, or it has no curve). */
DUCT_API duct_status duct_path_widths(const duct_context *context, const duct_path *path, size_t subpath,
                                      const duct_stroke *stroke, const duct_nib_options *options,
                                      double tolerance, duct_width **widths, size_t *count,
                                      duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
