/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "HelpingHand" section 4.3.2, equations (2) to (4). As printed, (4) compares with the query's curvature; the
 * text says that of the synthesized velocities, which is what keeps a join smooth, and which is done here. */
#include "helpinghand/shape.h"

#include "base/error.h"
#include "geometry/banded.h"

#include <math.h>

typedef struct {
    const duct_shape_options *options;
    const double *x, *y;
    const duct_gesture *gestures;
    size_t count;
    const bool *marks;
    duct_pentadiagonal matrix;
    double *right_x, *right_y;
} problem;

static void add_curvature(problem *self, size_t anchor)
{
    static const double second_difference[3] = {1, -2, 1};
    size_t reach = self->options->curvature_reach;
    size_t first = anchor > reach + 1 ? anchor - reach : 1;
    size_t last = anchor + reach + 2 <= self->count ? anchor + reach : self->count - 2;
    for (size_t j = first; j <= last && j + 1 < self->count; j++) {
        const duct_gesture *g = self->gestures;
        duct_pentadiagonal_add(&self->matrix, self->right_x, self->right_y, j - 1, second_difference, 3,
                               self->options->curvature_weight, g[j + 1].vx - g[j].vx, g[j + 1].vy - g[j].vy);
    }
}

/* Sets the equations up, with the two ends held by `end_weight`, and solves them. */
static bool solve(problem *self, double end_weight)
{
    static const double difference[2] = {-1, 1}, one[1] = {1};
    for (size_t i = 0; i < self->count; i++) {
        self->matrix.main[i] = self->matrix.first[i] = self->matrix.second[i] = 0;
        self->right_x[i] = self->right_y[i] = 0;
    }
    for (size_t i = 1; i < self->count; i++) {
        duct_pentadiagonal_add(&self->matrix, self->right_x, self->right_y, i - 1, difference, 2, 1,
                               self->gestures[i].vx, self->gestures[i].vy);
    }
    for (size_t i = 0; i < self->count; i++) {
        bool end = i == 0 || i + 1 == self->count;
        double weight = (self->marks[i] ? self->options->anchor_weight : 0) + (end ? end_weight : 0);
        if (weight > 0) {
            duct_pentadiagonal_add(&self->matrix, self->right_x, self->right_y, i, one, 1, weight, self->x[i],
                                   self->y[i]);
        }
        if (self->marks[i] && self->count >= 3) {
            add_curvature(self, i);
        }
    }
    return duct_pentadiagonal_solve(&self->matrix, self->right_x, self->right_y);
}

/* How far the farther of the two ends is from the query's. */
static double end_error(const problem *self)
{
    size_t last = self->count - 1;
    double first = hypot(self->right_x[0] - self->x[0], self->right_y[0] - self->y[0]);
    return fmax(first, hypot(self->right_x[last] - self->x[last], self->right_y[last] - self->y[last]));
}

static void integrate(const double *x, const double *y, const duct_gesture *gestures, size_t count,
                      bool closed, double *out_x, double *out_y)
{
    out_x[0] = x[0];
    out_y[0] = y[0];
    for (size_t i = 1; i < count; i++) {
        out_x[i] = out_x[i - 1] + gestures[i].vx;
        out_y[i] = out_y[i - 1] + gestures[i].vy;
    }
    if (closed) {
        double gap_x = out_x[count - 1] - out_x[0], gap_y = out_y[count - 1] - out_y[0];
        for (size_t i = 1; i < count; i++) {
            double share = (double)i / (double)(count - 1);
            out_x[i] -= share * gap_x;
            out_y[i] -= share * gap_y;
        }
    }
}

duct_status duct_shape_solve(const duct_allocator *allocator, const duct_shape_options *options,
                             const double *x, const double *y, const duct_gesture *gestures, size_t count,
                             bool closed, double *out_x, double *out_y, duct_error *error)
{
    if (options->anchors == DUCT_ANCHORS_OFF || options->anchor_weight <= 0) {
        integrate(x, y, gestures, count, closed, out_x, out_y);
        return DUCT_OK;
    }
    bool *marks = duct_alloc(allocator, count, sizeof *marks);
    double *bands = duct_alloc(allocator, 3 * count, sizeof *bands);
    duct_status status;
    if (marks == NULL || bands == NULL) {
        status = duct_fail_memory(error);
    } else {
        status = duct_anchors_find(allocator, options, x, y, count, marks, error);
    }
    if (status == DUCT_OK) {
        problem self = {
            .options = options, .x = x, .y = y, .gestures = gestures, .count = count, .marks = marks};
        self.matrix = (duct_pentadiagonal){count, bands, bands + count, bands + 2 * count};
        self.right_x = out_x;
        self.right_y = out_y;
        /* A closed stroke's ends are one point: held so firmly that what is left of a gap is rounding. */
        const double firm = 1e9;
        bool solved = solve(&self, closed ? firm : 0);
        for (double weight = options->anchor_weight;
             solved && !closed && options->anchors == DUCT_ANCHORS_ON && weight < firm &&
             end_error(&self) > 1;
             weight *= 4) {
            solved = solve(&self, weight);
        }
        if (!solved) {
            integrate(x, y, gestures, count, closed, out_x, out_y);
        }
        if (closed) {
            out_x[count - 1] = out_x[0];
            out_y[count - 1] = out_y[0];
        }
    }
    duct_release(allocator, marks);
    duct_release(allocator, bands);
    return status;
}
