/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "features/velocities.h"

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
