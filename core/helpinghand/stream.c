/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Weighted average while the stroke is drawn. The line behind the pen is kept as a trail of points; at each
 * sample it is sampled backwards from the pen, one unit of arc length apart, so that features change steadily
 * with the pen wherever its samples fall. */
#include <ductus/stream.h>

#include "base/error.h"
#include "helpinghand/gesture.h"
#include "helpinghand/result.h"
#include "library/feature_index.h"
#include "library/library_private.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Points of the trail are at least this far apart, in units: the trembling of a pen that stays in place is no
 * way made, and so a trail of a given length has a bounded number of points. */
static const double finest = 0.125;

/* Arc lengths this much short of a whole number of units count as one, so that rounding drops no sample. */
static const double slack = 1e-6;

/* Differences of larger coordinates would lose the trail's detail. */
static const double farthest = 1e9;

enum { MOST_NEIGHBOURS = 100 };

typedef struct {
    double x, y; /* sampling units */
} point;

struct duct_stream {
    duct_allocator allocator;
    const duct_library *library;
    const duct_search *search; /* over the history's half of the library's features */
    duct_feature_maker maker;
    double unit, smoothing;
    size_t neighbours, span;

    /* The trail: a ring whose newest point is at `newest`. */
    point *trail;
    size_t trail_size, trail_count, newest;
    double length; /* arc length of the whole stroke up to the newest point */

    double *x, *y; /* room for span + 1: the query's samples, oldest first */
    duct_candidate items[MOST_NEIGHBOURS];
    uint32_t hints[2 * MOST_NEIGHBOURS];
    size_t hint_count;

    bool begun;
    point pen; /* the last sample */
    double t, twist;
    duct_gesture settled; /* the smoothed gesture at the newest point of the trail */
};

/* ---- what is made once for a library ---- */

typedef struct {
    float *rows;
    duct_search *search;
} history;

typedef struct {
    const duct_feature_index *index;
    size_t dimensions;
} history_arg;

static void free_history(void *data, const duct_allocator *allocator)
{
    history *made = data;
    duct_search_free(made->search);
    duct_release(allocator, made->rows);
    duct_release(allocator, made);
}

/* An index over the beginnings of the feature vectors, which hold what came before a sample. To compare the
 * futures of the library's samples with an unknown one would favour samples that have none. */
static duct_status make_history(const duct_library *library, const void *arg, void **data, duct_error *error)
{
    const history_arg *self = arg;
    size_t count = library->sample_count, all = self->index->dimensions;
    history *made = duct_alloc(&library->allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    duct_status status;
    made->rows = duct_alloc(&library->allocator, count * self->dimensions, sizeof *made->rows);
    if (made->rows == NULL) {
        status = duct_fail_memory(error);
    } else {
        for (size_t i = 0; i < count; i++) {
            memcpy(made->rows + i * self->dimensions, self->index->rows + i * all,
                   self->dimensions * sizeof *made->rows);
        }
        status = duct_search_new(&library->allocator, DUCT_SEARCH_EXACT, made->rows, count, self->dimensions,
                                 library->starts, &made->search, error);
    }
    if (status != DUCT_OK) {
        free_history(made, &library->allocator);
        return status;
    }
    *data = made;
    return DUCT_OK;
}

static duct_status find_history(const duct_library *library, const duct_feature_options *options,
                                const duct_search **search, duct_error *error)
{
    duct_feature_index index;
    duct_status status = duct_library_features(library, options, DUCT_SEARCH_EXACT, &index, error);
    if (status != DUCT_OK) {
        return status;
    }
    char key[96];
    snprintf(key, sizeof key, "history %d reach %a weight %a", (int)options->kind, options->reach,
             options->weight);
    history_arg arg = {&index, duct_feature_past_dimensions(options)};
    const void *made;
    status = duct_library_get_part(library, key, make_history, &arg, free_history, &made, error);
    if (status == DUCT_OK) {
        *search = ((const history *)made)->search;
    }
    return status;
}

/* ---- making a stream ---- */

duct_stream_options duct_stream_options_default(void)
{
    duct_feature_options features = duct_feature_options_default();
    return (duct_stream_options){0, "velocities", 20, features.reach, features.weight, 2};
}

static bool within(double value, double low, double high)
{
    return value >= low && value <= high;
}

static duct_status check_options(const duct_library *library, const duct_stream_options *options,
                                 duct_error *error)
{
    bool any = false;
    for (int c = DUCT_PRESSURE; c < DUCT_CHANNEL_COUNT; c++) {
        any = any || library->channels[c] != NULL;
    }
    if (!any) {
        return duct_fail(
            error, DUCT_UNSUPPORTED,
            "the hand '%s' has no pressure channel, nor tilt or twist, so it cannot give pose; use "
            "another hand",
            library->name);
    }
    const char *wrong = NULL;
    if (!(options->unit >= 0) || !isfinite(options->unit)) {
        wrong = "unit must be a positive number of pixels, or 0";
    } else if (options->features == NULL ||
               (strcmp(options->features, "velocities") != 0 && strcmp(options->features, "contexts") != 0)) {
        wrong = "features must be \"velocities\" or \"contexts\"";
    } else if (options->neighbours < 1 || options->neighbours > MOST_NEIGHBOURS) {
        wrong = "neighbours must be 1 to 100";
    } else if (!within(options->reach, 7, 500)) {
        wrong = "reach must be 7 to 500 units";
    } else if (!within(options->weight, 0, 100)) {
        wrong = "weight must be 0 to 100";
    } else if (!within(options->smoothing, 0, 100)) {
        wrong = "smoothing must be 0 to 100 units";
    }
    return wrong != NULL ? duct_fail(error, DUCT_BAD_ARGUMENT, "a stream's %s", wrong) : DUCT_OK;
}

duct_status duct_stream_new(const duct_context *context, const duct_library *library,
                            const duct_stream_options *options, duct_stream **stream, duct_error *error)
{
    const duct_stream_options defaults = duct_stream_options_default();
    options = options != NULL ? options : &defaults;
    duct_status status = check_options(library, options, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_feature_options features = {
        strcmp(options->features, "contexts") == 0 ? DUCT_FEATURE_CONTEXTS : DUCT_FEATURE_VELOCITIES,
        options->reach, options->weight};
    const duct_search *search;
    status = find_history(library, &features, &search, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_stream *self = duct_alloc(allocator, 1, sizeof *self);
    if (self == NULL) {
        return duct_fail_memory(error);
    }
    self->allocator = *allocator;
    self->library = library;
    self->search = search;
    self->unit = options->unit > 0 ? options->unit : library->unit;
    self->smoothing = options->smoothing;
    self->neighbours = (size_t)options->neighbours;
    duct_feature_maker_init(&self->maker, &features);
    self->span = duct_feature_span(&self->maker);
    /* One point more than fit into the span on either side of it. */
    self->trail_size = (size_t)ceil((double)(self->span + 1) / finest) + 2;
    self->trail = duct_alloc(allocator, self->trail_size, sizeof *self->trail);
    self->x = duct_alloc(allocator, 2 * (self->span + 1), sizeof *self->x);
    if (self->trail == NULL || self->x == NULL) {
        duct_stream_free(self);
        return duct_fail_memory(error);
    }
    self->y = self->x + self->span + 1;
    *stream = self;
    return DUCT_OK;
}

void duct_stream_free(duct_stream *stream)
{
    if (stream != NULL) {
        const duct_allocator allocator = stream->allocator;
        duct_release(&allocator, stream->trail);
        duct_release(&allocator, stream->x);
        duct_release(&allocator, stream);
    }
}

/* ---- drawing ---- */

static void extend_trail(duct_stream *self, point to)
{
    self->newest = self->newest + 1 < self->trail_size ? self->newest + 1 : 0;
    self->trail[self->newest] = to;
    self->trail_count += self->trail_count < self->trail_size ? 1 : 0;
}

/* Samples the trail backwards from the pen, `length` from the stroke's start, as far as features look.
 * Returns how many samples there are; the pen is the last one. */
static size_t look_back(duct_stream *self, point pen, double length)
{
    size_t steps = length + slack < (double)self->span ? (size_t)(length + slack) : self->span;
    size_t at = steps, node = self->newest;
    self->x[at] = pen.x;
    self->y[at] = pen.y;
    point from = pen;
    double wanted = 1; /* from `from` to the next sample */
    for (size_t seen = 0; at > 0 && seen < self->trail_count; seen++) {
        point to = self->trail[node];
        double gap = hypot(to.x - from.x, to.y - from.y);
        for (; at > 0 && wanted <= gap + slack; wanted += 1) {
            double share = wanted < gap ? wanted / gap : 1;
            at--;
            self->x[at] = from.x + share * (to.x - from.x);
            self->y[at] = from.y + share * (to.y - from.y);
        }
        wanted -= gap;
        from = to;
        node = node > 0 ? node - 1 : self->trail_size - 1;
    }
    /* Rounding may have left the oldest one out. */
    memmove(self->x, self->x + at, (steps + 1 - at) * sizeof *self->x);
    memmove(self->y, self->y + at, (steps + 1 - at) * sizeof *self->y);
    return steps + 1 - at;
}

/* The weighted average for the pen's place; `after` is how far away the stroke's end is. */
static duct_gesture average_at(duct_stream *self, point pen, double length, double after)
{
    float row[DUCT_FEATURE_MOST_DIMENSIONS], distances[MOST_NEIGHBOURS];
    uint32_t near[MOST_NEIGHBOURS];
    size_t count = look_back(self, pen, length);
    duct_feature_row(&self->maker, self->x, self->y, count, count - 1, length, after, row);
    size_t found = duct_search_nearest(self->search, row, self->neighbours, self->hints, self->hint_count,
                                       near, distances);
    self->hint_count = 0;
    for (size_t n = 0; n < found; n++) {
        self->items[n] =
            (duct_candidate){near[n], duct_library_stroke_of(self->library, near[n]), distances[n]};
        self->hints[self->hint_count++] = near[n] + 1;
    }
    memcpy(self->hints + found, near, found * sizeof *near);
    self->hint_count = 2 * found;
    size_t starts[2] = {0, found};
    const duct_columns columns = {1, starts, self->items};
    duct_gesture gesture;
    duct_gestures_average(self->library, &columns, &gesture);
    return gesture;
}

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

static duct_stream_pose pose_of(duct_stream *self, const duct_gesture *gesture)
{
    double twist = atan2(gesture->twist_sin, gesture->twist_cos);
    self->twist = self->begun ? self->twist + remainder(twist - self->twist, 2 * M_PI) : twist;
    bool has_twist = self->library->channels[DUCT_TWIST] != NULL;
    return (duct_stream_pose){clamp(gesture->pressure, 0, 1), clamp(gesture->tilt_x, -M_PI / 2, M_PI / 2),
                              clamp(gesture->tilt_y, -M_PI / 2, M_PI / 2), has_twist ? self->twist : 0};
}

static duct_status check_sample(const duct_stream *self, double x, double y, double t, duct_error *error)
{
    if (!isfinite(x) || !isfinite(y) || !isfinite(t)) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a sample of a stream is not finite: x %g, y %g, t %g", x,
                         y, t);
    }
    if (self->begun && t < self->t) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a sample of a stream is older than the one before: %g s",
                         t);
    }
    if (!(fabs(x / self->unit) <= farthest && fabs(y / self->unit) <= farthest)) {
        return duct_fail(error, DUCT_LIMIT,
                         "a sample of a stream is too far away for its scale: x %g, y %g at %g pixels a unit",
                         x, y, self->unit);
    }
    return DUCT_OK;
}

duct_status duct_stream_push(duct_stream *stream, double x, double y, double t, duct_stream_pose *pose,
                             duct_error *error)
{
    duct_status status = check_sample(stream, x, y, t, error);
    if (status != DUCT_OK) {
        return status;
    }
    point pen = {x / stream->unit, y / stream->unit};
    duct_gesture gesture;
    if (!stream->begun) {
        stream->trail_count = stream->hint_count = 0;
        stream->length = 0;
        extend_trail(stream, pen);
        gesture = stream->settled = average_at(stream, pen, 0, INFINITY);
    } else {
        const point *last = &stream->trail[stream->newest];
        double step = hypot(pen.x - last->x, pen.y - last->y);
        gesture = average_at(stream, pen, stream->length + step, INFINITY);
        /* By the way made and not by the number of samples, so that a faster tablet gives the same poses. */
        double share = stream->smoothing > 0 ? -expm1(-step / stream->smoothing) : 1;
        gesture = duct_gesture_between(&stream->settled, &gesture, share);
        if (step >= finest) {
            extend_trail(stream, pen);
            stream->length += step;
            stream->settled = gesture;
        }
    }
    *pose = pose_of(stream, &gesture);
    stream->begun = true;
    stream->pen = pen;
    stream->t = t;
    return DUCT_OK;
}

bool duct_stream_flush(duct_stream *stream, duct_stream_pose *pose)
{
    if (!stream->begun) {
        return false;
    }
    if (pose != NULL) {
        const point *last = &stream->trail[stream->newest];
        double step = hypot(stream->pen.x - last->x, stream->pen.y - last->y);
        duct_gesture gesture = average_at(stream, stream->pen, stream->length + step, 0);
        *pose = pose_of(stream, &gesture);
    }
    stream->begun = false;
    return true;
}
