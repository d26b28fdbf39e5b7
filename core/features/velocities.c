/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "features/velocities.h"

#include "base/error.h"
#include "base/wide.h"

#include <math.h>

/* The reach of `taps` steps of which each is `growth` times the one before, the first being one sample. */
static double reach_of(double growth)
{
    double reach = 0, step = 1;
    for (int i = 0; i < DUCT_VELOCITY_TAPS; i++) {
        reach += step;
        step *= growth;
    }
    return reach;
}

void duct_velocity_filter_init(duct_velocity_filter *filter, double reach)
{
    double low = 1, high = 16;
    for (int i = 0; i < 60; i++) {
        double middle = 0.5 * (low + high);
        if (reach_of(middle) < reach) {
            low = middle;
        } else {
            high = middle;
        }
    }
    double centre = 0, step = 1;
    filter->centres[0] = 0;
    for (int i = 1; i < DUCT_VELOCITY_TAPS + 2; i++) {
        centre += step;
        step *= low;
        long rounded = (long)floor(centre + 0.5);
        filter->centres[i] = rounded > filter->centres[i - 1] ? rounded : filter->centres[i - 1] + 1;
    }
}

/* Tap `tap` >= 0 on the side `direction` (+1 future, -1 history). Velocity k is x[k] - x[k - 1]; that of the
 * first sample is 0 and inside the stroke, as the paper defines it. */
static void one_tap(const duct_velocity_filter *filter, const double *x, const double *y, size_t count,
                    size_t i, int tap, long direction, double weight, float *out)
{
    long centre = filter->centres[tap];
    long inner = tap > 0 ? filter->centres[tap - 1] : -1, outer = filter->centres[tap + 1];
    double sum_x = 0, sum_y = 0, sum = 0;
    for (long offset = inner + 1; offset < outer; offset++) {
        long k = (long)i + direction * offset;
        if (k < 0 || k >= (long)count || (tap == 0 && offset != 0)) {
            continue;
        }
        double share = offset <= centre ? (double)(offset - inner) / (double)(centre - inner)
                                        : (double)(outer - offset) / (double)(outer - centre);
        if (k > 0) {
            sum_x += share * (x[k] - x[k - 1]);
            sum_y += share * (y[k] - y[k - 1]);
        }
        sum += share;
    }
    out[0] = sum > 0 ? (float)(weight * sum_x / sum) : 0.0f;
    out[1] = sum > 0 ? (float)(weight * sum_y / sum) : 0.0f;
}

void duct_velocity_taps(const duct_velocity_filter *filter, const double *x, const double *y, size_t count,
                        size_t i, double weight, float taps[DUCT_VELOCITY_DIMENSIONS])
{
    for (int tap = -DUCT_VELOCITY_TAPS; tap <= DUCT_VELOCITY_TAPS; tap++) {
        one_tap(filter, x, y, count, i, tap < 0 ? -tap : tap, tap < 0 ? -1 : 1, weight,
                taps + 2 * (tap + DUCT_VELOCITY_TAPS));
    }
}

/* ---- all samples of a stroke ---- */

enum { ABREAST = 4 };
typedef double quads __attribute__((vector_size(ABREAST * sizeof(double)), aligned(sizeof(double))));

/* Velocities with zeros beyond both ends, and whether they are inside (1 or 0). Adding a zero changes no sum,
 * so that the samples near the ends need no care and all sums are those of one_tap(). */
typedef struct {
    size_t pad, count;
    double *vx, *vy, *inside, *shares;
} padded;

WIDE static void tap_of_all(const duct_velocity_filter *filter, const padded *line, int tap, long direction,
                            double weight, float *out, size_t dimensions)
{
    long centre = filter->centres[tap];
    long inner = tap > 0 ? filter->centres[tap - 1] : -1, outer = tap > 0 ? filter->centres[tap + 1] : 1;
    for (long offset = inner + 1; offset < outer; offset++) {
        line->shares[offset - inner - 1] = offset <= centre
                                               ? (double)(offset - inner) / (double)(centre - inner)
                                               : (double)(outer - offset) / (double)(outer - centre);
    }
    for (size_t i = 0; i < line->count; i += ABREAST) {
        quads sum_x = {0}, sum_y = {0}, sum = {0};
        for (long offset = inner + 1; offset < outer; offset++) {
            size_t k = (size_t)((long)(line->pad + i) + direction * offset);
            double share = line->shares[offset - inner - 1];
            sum_x += share * *(const quads *)(line->vx + k);
            sum_y += share * *(const quads *)(line->vy + k);
            sum += share * *(const quads *)(line->inside + k);
        }
        for (size_t lane = 0; lane < ABREAST && i + lane < line->count; lane++) {
            float *to = out + (i + lane) * dimensions;
            to[0] = sum[lane] > 0 ? (float)(weight * sum_x[lane] / sum[lane]) : 0.0f;
            to[1] = sum[lane] > 0 ? (float)(weight * sum_y[lane] / sum[lane]) : 0.0f;
        }
    }
}

duct_status duct_velocity_taps_of_all(const duct_allocator *allocator, const duct_velocity_filter *filter,
                                      const double *x, const double *y, size_t count, double weight,
                                      float *taps, size_t dimensions, duct_error *error)
{
    size_t pad = (size_t)filter->centres[DUCT_VELOCITY_TAPS + 1], room = count + 2 * pad + ABREAST;
    double *numbers = duct_alloc(allocator, 3 * room + pad + 1, sizeof *numbers);
    if (numbers == NULL) {
        return duct_fail_memory(error);
    }
    padded line = {pad, count, numbers, numbers + room, numbers + 2 * room, numbers + 3 * room};
    for (size_t k = 0; k < count; k++) {
        line.vx[pad + k] = k > 0 ? x[k] - x[k - 1] : 0;
        line.vy[pad + k] = k > 0 ? y[k] - y[k - 1] : 0;
        line.inside[pad + k] = 1;
    }
    for (int tap = -DUCT_VELOCITY_TAPS; tap <= DUCT_VELOCITY_TAPS; tap++) {
        tap_of_all(filter, &line, tap < 0 ? -tap : tap, tap < 0 ? -1 : 1, weight,
                   taps + 2 * (tap + DUCT_VELOCITY_TAPS), dimensions);
    }
    duct_release(allocator, numbers);
    return DUCT_OK;
}
