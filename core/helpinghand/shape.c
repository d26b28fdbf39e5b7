/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "HelpingHand" section 4.3.2, equations (2) to (4). As printed, (4) compares with the query's curvature; the
 * text says that of the synthesized velocities, which is what keeps a join smooth, and which is done here. */
#include "helpinghand/shape.h"

#include "base/error.h"
#include "geometry/banded.h"

#include <math.h>

enum {
    CORNER_WEIGHT = 8, /* a corner is this much firmer than another anchor */
    MOST_ROUNDS = 16   /* of solving again with firmer anchors */
};

typedef struct {
    const duct_shape_options *options;
    const double *x, *y;
    const duct_gesture *gestures;
    size_t count;
    bool *marks;         /* anchors */
    const bool *corners; /* those of them that are corners to be kept */
    double *weights;     /* of the positions */
    duct_pentadiagonal matrix;
    double *right_x, *right_y;
} problem;

/* Equation (4) at one anchor; not across a corner, which the hand's curvature would round. */
static void add_curvature(problem *self, size_t anchor)
{
    static const double second_difference[3] = {1, -2, 1};
    size_t reach = self->options->curvature_reach;
    size_t first = anchor > reach + 1 ? anchor - reach : 1;
    size_t last = anchor + reach + 2 <= self->count ? anchor + reach : self->count - 2;
    const duct_gesture *g = self->gestures;
    for (size_t j = first; j <= last && j + 1 < self->count; j++) {
        if (!self->corners[j - 1] && !self->corners[j] && !self->corners[j + 1]) {
            duct_pentadiagonal_add(&self->matrix, self->right_x, self->right_y, j - 1, second_difference, 3,
                                   self->options->curvature_weight, g[j + 1].vx - g[j].vx,
                                   g[j + 1].vy - g[j].vy);
        }
    }
}

static bool solve(problem *self)
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
        if (self->weights[i] > 0) {
            duct_pentadiagonal_add(&self->matrix, self->right_x, self->right_y, i, one, 1, self->weights[i],
                                   self->x[i], self->y[i]);
        }
        if (self->marks[i] && self->count >= 3) {
            add_curvature(self, i);
        }
    }
    return duct_pentadiagonal_solve(&self->matrix, self->right_x, self->right_y);
}

/* How far the result is from the query at sample i. */
static double stray(const problem *self, size_t i)
{
    return hypot(self->right_x[i] - self->x[i], self->right_y[i] - self->y[i]);
}

static void firm_up(problem *self, size_t i)
{
    double least = self->options->anchor_weight;
    self->weights[i] = 4 * (self->weights[i] > least ? self->weights[i] : least);
}

/* Firms up the ends that are more than a unit off, and sets an anchor wherever the line strays most beyond
 * the leeway. False where there is nothing to do. */
static bool tighten(problem *self)
{
    bool tightened = false;
    size_t last = self->count - 1;
    for (size_t i = 0; i <= last; i += last) {
        if (stray(self, i) > 1) {
            firm_up(self, i);
            tightened = true;
        }
    }
    for (size_t i = 1; i < last; i++) {
        size_t worst = i;
        double most = 0;
        for (; i < last && stray(self, i) > self->options->leeway; i++) {
            double off = stray(self, i);
            worst = off > most ? i : worst;
            most = off > most ? off : most;
        }
        if (most > 0) {
            self->marks[worst] = true;
            firm_up(self, worst);
            tightened = true;
        }
    }
    return tightened;
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
    bool *marks = duct_alloc(allocator, 2 * count, sizeof *marks),
         *corners = marks != NULL ? marks + count : NULL;
    double *bands = duct_alloc(allocator, 4 * count, sizeof *bands);
    duct_status status;
    if (marks == NULL || bands == NULL) {
        status = duct_fail_memory(error);
    } else {
        bool *kept = options->anchors == DUCT_ANCHORS_ON ? corners : NULL;
        status = duct_anchors_find(allocator, options, x, y, count, marks, kept, error);
    }
    if (status == DUCT_OK) {
        problem self = {.options = options, .x = x, .y = y, .gestures = gestures, .count = count};
        self.marks = marks;
        self.corners = corners;
        self.matrix = (duct_pentadiagonal){count, bands, bands + count, bands + 2 * count};
        self.weights = bands + 3 * count;
        self.right_x = out_x;
        self.right_y = out_y;
        for (size_t i = 0; i < count; i++) {
            self.weights[i] = marks[i] ? options->anchor_weight * (corners[i] ? CORNER_WEIGHT : 1) : 0;
        }
        if (closed) {
            /* The ends are one point: held so firmly that what is left of a gap is rounding. */
            self.weights[0] = self.weights[count - 1] = 1e9;
        }
        bool solved = solve(&self);
        for (int round = 0; solved && options->anchors == DUCT_ANCHORS_ON && round < MOST_ROUNDS; round++) {
            if (!tighten(&self)) {
                break;
            }
            solved = solve(&self);
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
