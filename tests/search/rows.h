/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_SEARCH_ROWS_H
#define DUCTUS_TESTS_SEARCH_ROWS_H

#include <ductus/random.h>

#include <math.h>
#include <stdlib.h>

enum { DIMENSIONS = 32, STROKE = 60, K = 20 };

/* Rows along smooth paths of STROKE rows each, as strokes' features are. Freed by free(). */
static inline float *make_rows(size_t count, uint64_t seed)
{
    float *rows = calloc(count * DIMENSIONS, sizeof *rows);
    for (size_t i = 0; rows != NULL && i < count; i++) {
        for (size_t d = 0; d < DIMENSIONS; d++) {
            double phase = 6.28 * duct_random_uniform(seed, i / STROKE, d, 0);
            double noise = 0.05 * duct_random_normal(seed, i, d, 1);
            rows[i * DIMENSIONS + d] = (float)(sin(phase + 0.05 * (double)i) + noise);
        }
    }
    return rows;
}

#endif
