/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How the exact search's index is made. Nothing here decides what is found, only how fast. */
#include "search/exact_private.h"

#include "base/error.h"
#include "base/wide.h"

#include <math.h>
#include <string.h>

enum {
    LEAF = DUCT_EXACT_LEAF,
    LANES = DUCT_EXACT_LANES,
    MOST_MEASURED = 8192, /* rows that the axes are found from */
    MOST_SWEEPS = 30
};

typedef double quads __attribute__((vector_size(4 * sizeof(double)), aligned(sizeof(double))));

/* Squares of larger numbers could overflow. */
static const double too_large = 1e15;

/* Static, because a function in several versions is exported from the library whatever its visibility. */
WIDE static bool find_place(const duct_exact *self, const float *row, float *place)
{
    size_t dimensions = self->base.dimensions, coordinates = self->coordinates;
    double off[DUCT_EXACT_MOST_DIMENSIONS], square = 0, held = 0;
    for (size_t d = 0; d < dimensions; d++) {
        off[d] = (double)row[d] - self->centre[d];
    }
    for (size_t first = 0; first < coordinates; first += 8) {
        const double *axes = self->axes + first;
        quads low = {0}, high = {0};
        for (size_t d = 0; d < dimensions; d++) {
            low += *(const quads *)(axes + d * coordinates) * off[d];
            high += *(const quads *)(axes + d * coordinates + 4) * off[d];
        }
        quads sum = low * low + high * high;
        held += (sum[0] + sum[1]) + (sum[2] + sum[3]);
        for (size_t c = 0; c < 4; c++) {
            place[first + c] = (float)low[c];
            place[first + 4 + c] = (float)high[c];
        }
    }
    for (size_t d = 0; d < dimensions; d++) {
        square += off[d] * off[d];
    }
    /* The last axis is 0: its place is for what the others leave over. */
    place[coordinates - 1] = square > held ? (float)sqrt(square - held) : 0;
    return square < too_large * too_large;
}

bool duct_exact_place(const duct_exact *self, const float *row, float *place)
{
    return find_place(self, row, place);
}

/* ---- principal axes ---- */

static bool measure(duct_exact *self, double *covariance)
{
    size_t dimensions = self->base.dimensions, count = self->base.count;
    size_t stride = count / MOST_MEASURED + 1, measured = (count - 1) / stride + 1;
    double off[DUCT_EXACT_MOST_DIMENSIONS];
    for (size_t row = 0; row < count; row++) {
        for (size_t d = 0; d < dimensions; d++) {
            if (!(fabs((double)self->base.rows[row * dimensions + d]) < too_large)) {
                return false;
            }
        }
    }
    for (size_t row = 0; row < count; row += stride) {
        for (size_t d = 0; d < dimensions; d++) {
            self->centre[d] += (double)self->base.rows[row * dimensions + d] / (double)measured;
        }
    }
    for (size_t row = 0; row < count; row += stride) {
        for (size_t d = 0; d < dimensions; d++) {
            off[d] = (double)self->base.rows[row * dimensions + d] - self->centre[d];
        }
        for (size_t d = 0; d < dimensions; d++) {
            for (size_t e = 0; e <= d; e++) {
                covariance[d * dimensions + e] += off[d] * off[e];
            }
        }
    }
    for (size_t d = 0; d < dimensions; d++) {
        for (size_t e = 0; e < d; e++) {
            covariance[e * dimensions + d] = covariance[d * dimensions + e];
        }
    }
    return true;
}

/* Jacobi's method: turns the symmetric matrix to a diagonal one; the columns of `vectors` are its axes. */
static void find_axes(double *matrix, double *vectors, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        vectors[i * n + i] = 1;
    }
    for (int sweep = 0; sweep < MOST_SWEEPS; sweep++) {
        double apart = 0, trace = 0;
        for (size_t p = 0; p < n; p++) {
            trace += matrix[p * n + p] * matrix[p * n + p];
            for (size_t q = p + 1; q < n; q++) {
                apart += matrix[p * n + q] * matrix[p * n + q];
            }
        }
        if (!(apart > 1e-12 * trace)) {
            return;
        }
        for (size_t p = 0; p < n; p++) {
            for (size_t q = p + 1; q < n; q++) {
                double between = matrix[p * n + q];
                if (between == 0) {
                    continue;
                }
                double theta = (matrix[q * n + q] - matrix[p * n + p]) / (2 * between);
                double tangent = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
                double cosine = 1 / sqrt(tangent * tangent + 1), sine = tangent * cosine;
                for (size_t k = 0; k < n; k++) {
                    double a = matrix[k * n + p], b = matrix[k * n + q];
                    matrix[k * n + p] = cosine * a - sine * b;
                    matrix[k * n + q] = sine * a + cosine * b;
                }
                for (size_t k = 0; k < n; k++) {
                    double a = matrix[p * n + k], b = matrix[q * n + k];
                    matrix[p * n + k] = cosine * a - sine * b;
                    matrix[q * n + k] = sine * a + cosine * b;
                    a = vectors[k * n + p];
                    b = vectors[k * n + q];
                    vectors[k * n + p] = cosine * a - sine * b;
                    vectors[k * n + q] = sine * a + cosine * b;
                }
            }
        }
    }
}

/* Takes the axes of the largest spread, as many as hold nearly all of it. */
static void take_axes(duct_exact *self, const double *matrix, const double *vectors)
{
    const double enough = 0.90;
    size_t n = self->base.dimensions, order[DUCT_EXACT_MOST_DIMENSIONS];
    double all = 0, held = 0;
    for (size_t i = 0; i < n; i++) {
        size_t at = i;
        for (; at > 0 && matrix[order[at - 1] * (n + 1)] < matrix[i * (n + 1)]; at--) {
            order[at] = order[at - 1];
        }
        order[at] = i;
        all += matrix[i * (n + 1)];
    }
    size_t taken = 0;
    while (taken < n && taken + 1 < DUCT_EXACT_MOST_COORDINATES && (held < enough * all || taken % 8 != 7)) {
        held += matrix[order[taken++] * (n + 1)];
    }
    self->coordinates = (taken + 1 + 7) / 8 * 8;
    for (size_t d = 0; d < n; d++) {
        for (size_t c = 0; c < self->coordinates; c++) {
            self->axes[d * self->coordinates + c] = c < taken ? vectors[d * n + order[c]] : 0;
        }
    }
}

static duct_status choose_axes(duct_exact *self, duct_error *error)
{
    const duct_allocator *allocator = &self->base.allocator;
    size_t n = self->base.dimensions;
    double *matrices = duct_alloc(allocator, 2 * n * n, sizeof *matrices);
    self->axes = duct_alloc(allocator, n * DUCT_EXACT_MOST_COORDINATES, sizeof *self->axes);
    self->centre = duct_alloc(allocator, n, sizeof *self->centre);
    duct_status status = DUCT_OK;
    if (matrices == NULL || self->axes == NULL || self->centre == NULL) {
        status = duct_fail_memory(error);
    } else if (measure(self, matrices)) {
        find_axes(matrices, matrices + n * n, n);
        take_axes(self, matrices, matrices + n * n);
    } else {
        self->plain = true;
    }
    duct_release(allocator, matrices);
    return status;
}

/* ---- leaves ---- */

typedef struct {
    const float *places; /* [row][coordinate] */
    size_t coordinates, along;
} axis;

static bool before(const axis *self, uint32_t a, uint32_t b)
{
    float x = self->places[a * self->coordinates + self->along],
          y = self->places[b * self->coordinates + self->along];
    return x < y || (x == y && a < b);
}

static void swap_rows(uint32_t *rows, size_t i, size_t j)
{
    uint32_t row = rows[i];
    rows[i] = rows[j];
    rows[j] = row;
}

/* Puts the `small` lowest rows along an axis first (Hoare's selection; no two rows are equal). */
static void select_lowest(const axis *self, uint32_t *rows, size_t count, size_t small)
{
    size_t low = 0, high = count;
    while (high - low > 2) {
        uint32_t a = rows[low], b = rows[low + (high - low) / 2], c = rows[high - 1];
        uint32_t middle = before(self, a, b) ? (before(self, b, c)   ? b
                                                : before(self, a, c) ? c
                                                                     : a)
                                             : (before(self, a, c)   ? a
                                                : before(self, b, c) ? c
                                                                     : b);
        size_t i = low, j = high - 1;
        for (;; i++, j--) {
            while (before(self, rows[i], middle)) {
                i++;
            }
            while (before(self, middle, rows[j])) {
                j--;
            }
            if (i >= j) {
                break;
            }
            swap_rows(rows, i, j);
        }
        /* Up to j none is above the middle one, behind it none below. */
        if (small == j + 1) {
            return;
        }
        if (small <= j) {
            high = j + 1;
        } else {
            low = j + 1;
        }
    }
    if (high - low == 2 && before(self, rows[low + 1], rows[low])) {
        swap_rows(rows, low, low + 1);
    }
}

static size_t widest(const axis *self, const uint32_t *rows, size_t count)
{
    size_t chosen = 0;
    float most = -1;
    for (size_t c = 0; c < self->coordinates; c++) {
        float low = INFINITY, high = -INFINITY;
        for (size_t i = 0; i < count; i++) {
            float value = self->places[rows[i] * self->coordinates + c];
            low = value < low ? value : low;
            high = value > high ? value : high;
        }
        if (high - low > most) {
            most = high - low;
            chosen = c;
        }
    }
    return chosen;
}

/* Orders rows so that leaves, and aligned groups of leaves, are small: halves along the widest coordinate,
 * the first half being a power of two of leaves. */
static void arrange(const float *places, size_t coordinates, uint32_t *rows, size_t count)
{
    while (count > LEAF) {
        size_t small = LEAF;
        while (2 * small < count) {
            small *= 2;
        }
        axis along = {places, coordinates, 0};
        along.along = widest(&along, rows, count);
        select_lowest(&along, rows, count, small);
        arrange(places, coordinates, rows, small);
        rows += small;
        count -= small;
    }
}

static void fill_leaves(duct_exact *self, const float *places, const uint32_t *rows)
{
    size_t count = self->base.count, coordinates = self->coordinates;
    for (size_t i = 0; i < self->leaves * LEAF; i++) {
        size_t leaf = i / LEAF, lane = i % LEAF;
        self->order[i] = i < count ? rows[i] : 0;
        for (size_t c = 0; c < coordinates; c++) {
            self->places[(leaf * coordinates + c) * LEAF + lane] =
                i < count ? places[rows[i] * coordinates + c] : INFINITY;
        }
    }
}

/* ---- boxes ---- */

/* The box around leaves first .. last - 1; around nothing, one that is infinitely far away. */
static void set_box(const duct_exact *self, size_t first, size_t last, float *boxes, size_t lane)
{
    for (size_t c = 0; c < self->coordinates; c++) {
        float low = INFINITY, high = -INFINITY;
        for (size_t leaf = first; leaf < last; leaf++) {
            const float *values = self->places + (leaf * self->coordinates + c) * LEAF;
            for (size_t i = 0; i < LEAF && values[i] < INFINITY; i++) {
                low = values[i] < low ? values[i] : low;
                high = values[i] > high ? values[i] : high;
            }
        }
        boxes[2 * c * LANES + lane] = low <= high ? 0.5f * (low + high) : 0;
        boxes[(2 * c + 1) * LANES + lane] = 0.5f * (high - low);
    }
}

static duct_status make_levels(duct_exact *self, duct_error *error)
{
    size_t nodes = self->leaves, size = self->coordinates * 2 * LANES, inside = 1;
    do {
        duct_exact_level *level = &self->levels[self->level_count];
        level->groups = (nodes + LANES - 1) / LANES;
        level->boxes = duct_alloc(&self->base.allocator, level->groups * size, sizeof(float));
        if (level->boxes == NULL) {
            return duct_fail_memory(error);
        }
        for (size_t node = 0; node < level->groups * LANES; node++) {
            size_t first = node * inside < self->leaves ? node * inside : self->leaves;
            size_t last = first + inside < self->leaves ? first + inside : self->leaves;
            set_box(self, first, last, level->boxes + node / LANES * size, node % LANES);
        }
        inside *= LANES;
        self->level_count++;
        nodes = level->groups;
    } while (nodes > 1);
    return DUCT_OK;
}

duct_status duct_exact_build(duct_exact *self, duct_error *error)
{
    const duct_allocator *allocator = &self->base.allocator;
    duct_status status = choose_axes(self, error);
    if (status != DUCT_OK || self->plain) {
        return status;
    }
    size_t count = self->base.count, coordinates = self->coordinates;
    self->leaves = (count + LEAF - 1) / LEAF;
    self->order = duct_alloc(allocator, self->leaves * LEAF, sizeof *self->order);
    self->places = duct_alloc(allocator, self->leaves * LEAF * coordinates, sizeof *self->places);
    float *places = duct_alloc(allocator, count * coordinates, sizeof *places);
    uint32_t *rows = duct_alloc(allocator, count, sizeof *rows);
    if (self->order == NULL || self->places == NULL || places == NULL || rows == NULL) {
        status = duct_fail_memory(error);
    }
    for (size_t row = 0; status == DUCT_OK && row < count; row++) {
        rows[row] = (uint32_t)row;
        if (!duct_exact_place(self, self->base.rows + row * self->base.dimensions,
                              places + row * coordinates)) {
            self->plain = true;
        }
        for (size_t c = 0; c < coordinates; c++) {
            self->largest = fmax(self->largest, fabs((double)places[row * coordinates + c]));
        }
    }
    if (status == DUCT_OK && !self->plain) {
        arrange(places, coordinates, rows, count);
        fill_leaves(self, places, rows);
        status = make_levels(self, error);
    }
    duct_release(allocator, places);
    duct_release(allocator, rows);
    return status;
}

void duct_exact_release(duct_exact *self)
{
    const duct_allocator *allocator = &self->base.allocator;
    for (size_t level = 0; level < DUCT_EXACT_LEVELS; level++) {
        duct_release(allocator, self->levels[level].boxes);
    }
    duct_release(allocator, self->axes);
    duct_release(allocator, self->centre);
    duct_release(allocator, self->order);
    duct_release(allocator, self->places);
}
