/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "geometry/bezier.h"
#include "outline/nib.h"

#include <math.h>
#include <string.h>

/* The width across a fitted line: each sample's nib, seen across the curve at the place nearest to the
 * sample, and of these places only those that a straight course of the width between its neighbours misses.
 */

/* A fitted subpath as a polyline that knows its places on the curves. */
typedef struct {
    const duct_allocator *allocator;
    double *x, *y, *at;
    size_t count;
} line;

static const double straight_steps = 1, curve_steps = 24;

static void line_free(line *l)
{
    duct_release(l->allocator, l->x);
    duct_release(l->allocator, l->y);
    duct_release(l->allocator, l->at);
}

static void line_add(line *l, double x, double y, double at)
{
    l->x[l->count] = x;
    l->y[l->count] = y;
    l->at[l->count++] = at;
}

static void line_add_curve(line *l, const double c[8], double node)
{
    for (double k = 1; k <= curve_steps; k++) {
        double t = k / curve_steps, s = 1 - t;
        double b0 = s * s * s, b1 = 3 * s * s * t, b2 = 3 * s * t * t, b3 = t * t * t;
        line_add(l, b0 * c[0] + b1 * c[2] + b2 * c[4] + b3 * c[6],
                 b0 * c[1] + b1 * c[3] + b2 * c[5] + b3 * c[7], node + t);
    }
}

/* False when there is no memory. */
static bool line_of(const duct_path *path, const duct_subpath *subpath, line *l)
{
    size_t most = (subpath->verb_end - subpath->verb + 1) * (size_t)curve_steps;
    *l = (line){.allocator = path->allocator};
    l->x = duct_alloc(l->allocator, most, sizeof(double));
    l->y = duct_alloc(l->allocator, most, sizeof(double));
    l->at = duct_alloc(l->allocator, most, sizeof(double));
    if (l->x == NULL || l->y == NULL || l->at == NULL) {
        line_free(l);
        return false;
    }
    const double *p = path->points + 2 * subpath->point, *start = p;
    double node = 0;
    for (size_t v = subpath->verb; v < subpath->verb_end; v++) {
        switch ((duct_path_verb)path->verbs[v]) {
        case DUCT_PATH_MOVE:
            line_add(l, p[0], p[1], node);
            p += 2;
            break;
        case DUCT_PATH_LINE:
            node += straight_steps;
            line_add(l, p[0], p[1], node);
            p += 2;
            break;
        case DUCT_PATH_CUBIC: {
            double c[8];
            memcpy(c, p - 2, sizeof c);
            line_add_curve(l, c, node);
            node += 1;
            p += 6;
            break;
        }
        case DUCT_PATH_CLOSE: {
            /* The closing line is a segment of its own where it has a length. */
            double dx = start[0] - l->x[l->count - 1], dy = start[1] - l->y[l->count - 1];
            if (dx * dx + dy * dy > 0) {
                line_add(l, start[0], start[1], node + straight_steps);
            }
            break;
        }
        }
    }
    return true;
}

/* The place on segment `s` nearest to a point: how far along (0..1), and the squared distance. */
static double nearest_on(const line *l, size_t s, double x, double y, double *share)
{
    double dx = l->x[s + 1] - l->x[s], dy = l->y[s + 1] - l->y[s];
    double square = dx * dx + dy * dy;
    double t = square > 0 ? ((x - l->x[s]) * dx + (y - l->y[s]) * dy) / square : 0;
    t = t > 0 ? t < 1 ? t : 1 : 0;
    double ex = l->x[s] + t * dx - x, ey = l->y[s] + t * dy - y;
    *share = t;
    return ex * ex + ey * ey;
}

static double segment_length(const line *l, size_t s)
{
    return hypot(l->x[s + 1] - l->x[s], l->y[s + 1] - l->y[s]);
}

/* The sample where the line begins: the first one, or of a closed stroke, whose fitted line begins at a
 * corner, the nearest one. */
static size_t first_sample(const line *l, const duct_stroke *stroke)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    size_t first = 0;
    double best = INFINITY;
    for (size_t i = 0; duct_stroke_closed(stroke) && i < duct_stroke_size(stroke); i++) {
        double distance = hypot(x[i] - l->x[0], y[i] - l->y[0]);
        if (distance < best) {
            best = distance;
            first = i;
        }
    }
    return first;
}

/* The samples' places on the line, never going back: each is looked for no farther ahead than the way from
 * the sample before, and something more, so that a line which meets itself is not taken for itself. */
static void place_samples(const line *l, const duct_stroke *stroke, size_t first, size_t *segment,
                          double *share)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    size_t at = 0, size = duct_stroke_size(stroke);
    double along = 0;
    for (size_t k = 0; k < size; k++) {
        size_t i = (first + k) % size, before = (i + size - 1) % size;
        double window = k > 0 ? 1.5 * hypot(x[i] - x[before], y[i] - y[before]) + 1 : 1;
        double ahead = -along * segment_length(l, at), best = INFINITY, best_share = along;
        size_t best_segment = at;
        for (size_t s = at; s + 1 < l->count && ahead <= window; s++) {
            double t, distance = nearest_on(l, s, x[i], y[i], &t);
            if (s == at && t < along) {
                t = along;
            }
            if (distance < best) {
                best = distance;
                best_segment = s;
                best_share = t;
            }
            ahead += segment_length(l, s);
        }
        segment[i] = at = best_segment;
        share[i] = along = best_share;
    }
}

/* Marks the places that are needed between the marked ones at both ends (Douglas and Peucker). */
static bool choose(const duct_allocator *allocator, const duct_width *all, size_t count, double tolerance,
                   bool *kept)
{
    /* The ranges on the stack share no more than their ends, so there are fewer of them than places. */
    size_t *ranges = duct_alloc(allocator, count + 1, 2 * sizeof *ranges);
    if (ranges == NULL) {
        return false;
    }
    size_t depth = 0;
    ranges[0] = 0;
    ranges[1] = count - 1;
    depth = 1;
    kept[0] = kept[count - 1] = true;
    while (depth > 0) {
        depth--;
        size_t from = ranges[2 * depth], to = ranges[2 * depth + 1], worst = from;
        double most = tolerance, span = all[to].at - all[from].at;
        for (size_t i = from + 1; i < to; i++) {
            double t = span > 0 ? (all[i].at - all[from].at) / span : 0;
            double miss = fabs(all[i].width - all[from].width - t * (all[to].width - all[from].width));
            if (miss > most) {
                most = miss;
                worst = i;
            }
        }
        if (worst > from) {
            kept[worst] = true;
            ranges[2 * depth] = from;
            ranges[2 * depth + 1] = worst;
            depth++;
            ranges[2 * depth] = worst;
            ranges[2 * depth + 1] = to;
            depth++;
        }
    }
    duct_release(allocator, ranges);
    return true;
}

/* All samples' widths, with the line's own ends as first and last place. `all` has room for two more than
 * there are samples. */
static size_t widths_of(const line *l, const duct_stroke *stroke, size_t first, const duct_nib *nibs,
                        const size_t *segment, const double *share, duct_width *all)
{
    size_t size = duct_stroke_size(stroke), count = 0;
    for (size_t k = 0; k < size; k++) {
        size_t i = (first + k) % size, s = segment[i];
        double length = segment_length(l, s);
        duct_normal normal = {0, 1};
        if (length > 0) {
            normal.x = (l->y[s] - l->y[s + 1]) / length;
            normal.y = (l->x[s + 1] - l->x[s]) / length;
        }
        double at = l->at[s] + share[i] * (l->at[s + 1] - l->at[s]);
        double width = 2 * duct_nib_support(&nibs[i], normal);
        if (k == 0) {
            all[count++] = (duct_width){l->at[0], width};
        }
        if (at > all[count - 1].at) {
            all[count++] = (duct_width){at, width};
        }
    }
    double end = l->at[l->count - 1];
    if (end > all[count - 1].at) {
        double width = duct_stroke_closed(stroke) ? all[0].width : all[count - 1].width;
        all[count++] = (duct_width){end, width};
    }
    return count;
}

static duct_status find_widths(const duct_allocator *allocator, const line *l, const duct_stroke *stroke,
                               const duct_nib_options *options, double tolerance, duct_width **widths,
                               size_t *count, duct_error *error)
{
    size_t size = duct_stroke_size(stroke), found = 0;
    duct_nib *nibs = duct_alloc(allocator, size, sizeof *nibs);
    size_t *segment = duct_alloc(allocator, size, sizeof *segment);
    double *share = duct_alloc(allocator, size, sizeof *share);
    duct_width *all = duct_alloc(allocator, size + 2, sizeof *all);
    bool *kept = duct_alloc(allocator, size + 2, sizeof *kept);
    bool ok = nibs != NULL && segment != NULL && share != NULL && all != NULL && kept != NULL;
    if (ok) {
        duct_nibs_of(stroke, options, nibs);
        size_t first = first_sample(l, stroke);
        place_samples(l, stroke, first, segment, share);
        found = widths_of(l, stroke, first, nibs, segment, share, all);
        ok = choose(allocator, all, found, tolerance, kept);
    }
    if (ok) {
        size_t n = 0;
        for (size_t i = 0; i < found; i++) {
            if (kept[i]) {
                all[n++] = all[i];
            }
        }
        *widths = all;
        *count = n;
    } else {
        duct_release(allocator, all);
    }
    duct_release(allocator, nibs);
    duct_release(allocator, segment);
    duct_release(allocator, share);
    duct_release(allocator, kept);
    return ok ? DUCT_OK : duct_fail_memory(error);
}

duct_status duct_path_widths(const duct_context *context, const duct_path *path, size_t subpath,
                             const duct_stroke *stroke, const duct_nib_options *options, double tolerance,
                             duct_width **widths, size_t *count, duct_error *error)
{
    duct_subpath at = {0};
    bool there = !path->failed && duct_path_next(path, &at);
    for (size_t i = 0; there && i < subpath; i++) {
        there = duct_path_next(path, &at);
    }
    if (!there || at.verb_end - at.verb < 2 || duct_stroke_size(stroke) == 0) {
        return path->failed
                   ? duct_fail_memory(error)
                   : duct_fail(error, DUCT_BAD_ARGUMENT,
                               "subpath %zu of the path is not there, or is not a stroke's line", subpath);
    }
    if (!(tolerance > 0)) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a tolerance of %g pixels was given; it has to be above 0",
                         tolerance);
    }
    duct_nib_options nib = options != NULL ? *options : duct_nib_options_default();
    line l;
    if (!line_of(path, &at, &l)) {
        return duct_fail_memory(error);
    }
    duct_status status =
        l.count < 2
            ? duct_fail(error, DUCT_BAD_ARGUMENT, "subpath %zu of the path has no curve", subpath)
            : find_widths(duct_allocator_of(context), &l, stroke, &nib, tolerance, widths, count, error);
    line_free(&l);
    return status;
}
