/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/position.h"

#include <math.h>
#include <string.h>

enum { TERMS = 6 };

/* Normal equations of the polynomial's coefficients. Positions are mapped to -1..1, which keeps them well
 * conditioned. */
typedef struct {
    double x, y, scale; /* the page's middle, and what maps it to -1..1 */
    double matrix[TERMS][TERMS], right[TERMS];
    double coefficients[TERMS];
    double circular_mean; /* twist: what its values are taken from */
    double mean;          /* of the values */
    size_t samples;
} fit;

static void terms_at(const fit *self, double x, double y, double terms[TERMS])
{
    double u = (x - self->x) * self->scale, v = (y - self->y) * self->scale;
    const double all[TERMS] = {1, u, v, u * u, u * v, v * v};
    memcpy(terms, all, sizeof all);
}

static void find_page(fit *self, const duct_samples *strokes, size_t count)
{
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t s = 0; s < count; s++) {
        for (size_t i = 0; i < strokes[s].count; i++) {
            for (size_t axis = 0; axis < 2; axis++) {
                double value = strokes[s].channels[axis == 0 ? DUCT_X : DUCT_Y][i];
                low[axis] = fmin(low[axis], value);
                high[axis] = fmax(high[axis], value);
            }
        }
    }
    double side = fmax(high[0] - low[0], high[1] - low[1]);
    self->x = (low[0] + high[0]) / 2;
    self->y = (low[1] + high[1]) / 2;
    self->scale = side > 0 ? 2 / side : 0;
}

static double value_at(const fit *self, const duct_samples *stroke, duct_channel channel, size_t i)
{
    double value = stroke->channels[channel][i];
    return channel == DUCT_TWIST ? remainder(value - self->circular_mean, 2 * M_PI) : value;
}

static void gather(fit *self, const duct_samples *strokes, size_t count, duct_channel channel)
{
    double sine = 0, cosine = 0;
    for (size_t s = 0; channel == DUCT_TWIST && s < count; s++) {
        for (size_t i = 0; i < strokes[s].count; i++) {
            sine += sin(strokes[s].channels[channel][i]);
            cosine += cos(strokes[s].channels[channel][i]);
        }
    }
    self->circular_mean = atan2(sine, cosine);
    for (size_t s = 0; s < count; s++) {
        for (size_t i = 0; i < strokes[s].count; i++) {
            double terms[TERMS], value = value_at(self, &strokes[s], channel, i);
            terms_at(self, strokes[s].channels[DUCT_X][i], strokes[s].channels[DUCT_Y][i], terms);
            self->samples++;
            self->mean += (value - self->mean) / (double)self->samples;
            for (size_t row = 0; row < TERMS; row++) {
                self->right[row] += terms[row] * value;
                for (size_t column = 0; column < TERMS; column++) {
                    self->matrix[row][column] += terms[row] * terms[column];
                }
            }
        }
    }
}

/* Gauss-Jordan elimination with the largest diagonal element as the next pivot, which is stable for a matrix
 * of normal equations. Terms that the positions do not determine get a coefficient of 0. */
static void solve(fit *self)
{
    bool used[TERMS] = {false};
    double start[TERMS];
    for (size_t i = 0; i < TERMS; i++) {
        start[i] = self->matrix[i][i];
    }
    for (size_t step = 0; step < TERMS; step++) {
        size_t pivot = TERMS;
        for (size_t i = 0; i < TERMS; i++) {
            bool determined = !used[i] && self->matrix[i][i] > 1e-9 * start[i] && start[i] > 0;
            if (determined && (pivot == TERMS || self->matrix[i][i] > self->matrix[pivot][pivot])) {
                pivot = i;
            }
        }
        if (pivot == TERMS) {
            break;
        }
        used[pivot] = true;
        for (size_t row = 0; row < TERMS; row++) {
            double factor = self->matrix[row][pivot] / self->matrix[pivot][pivot];
            for (size_t column = 0; row != pivot && column < TERMS; column++) {
                self->matrix[row][column] -= factor * self->matrix[pivot][column];
            }
            self->right[row] -= row != pivot ? factor * self->right[pivot] : 0;
        }
    }
    for (size_t i = 0; i < TERMS; i++) {
        self->coefficients[i] = used[i] ? self->right[i] / self->matrix[i][i] : 0;
    }
}

static void subtract(const fit *self, duct_samples *strokes, size_t count, duct_channel channel)
{
    for (size_t s = 0; s < count; s++) {
        for (size_t i = 0; i < strokes[s].count; i++) {
            double terms[TERMS], influence = -self->mean;
            terms_at(self, strokes[s].channels[DUCT_X][i], strokes[s].channels[DUCT_Y][i], terms);
            for (size_t k = 0; k < TERMS; k++) {
                influence += self->coefficients[k] * terms[k];
            }
            double value = strokes[s].channels[channel][i] - influence;
            strokes[s].channels[channel][i] = channel == DUCT_PRESSURE ? fmax(0, fmin(1, value)) : value;
        }
    }
}

static bool all_have(const duct_samples *strokes, size_t count, duct_channel channel)
{
    for (size_t s = 0; s < count; s++) {
        if (strokes[s].channels[channel] == NULL) {
            return false;
        }
    }
    return count > 0;
}

void duct_position_remove(duct_samples *strokes, size_t count)
{
    static const duct_channel attributes[] = {DUCT_PRESSURE, DUCT_TILT_X, DUCT_TILT_Y, DUCT_TWIST};
    fit page = {.samples = 0};
    find_page(&page, strokes, count);
    for (size_t a = 0; a < sizeof attributes / sizeof attributes[0]; a++) {
        if (all_have(strokes, count, attributes[a])) {
            fit self = page;
            gather(&self, strokes, count, attributes[a]);
            solve(&self);
            subtract(&self, strokes, count, attributes[a]);
        }
    }
}
