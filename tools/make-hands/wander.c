/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "wander.h"

#include <ductus/random.h>

#include <math.h>

double wander(uint64_t seed, uint64_t stroke, uint64_t purpose, double u)
{
    const double knot = floor(u);
    const double f = u - knot;
    const double g = 1 - f;
    const double weights[4] = {g * g * g / 6, (3 * f * f * f - 6 * f * f + 4) / 6,
                               (3 * g * g * g - 6 * g * g + 4) / 6, f * f * f / 6};
    double sum = 0;
    for (uint64_t k = 0; k < 4; k++) {
        sum += weights[k] * duct_random_normal(seed, stroke, (uint64_t)knot + k, purpose);
    }
    /* The mean of the weights' sum of squares over a unit is 0.479. */
    return sum / sqrt(0.479);
}
