/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_SEARCH_ABREAST_H
#define DUCTUS_SEARCH_ABREAST_H

#include "base/wide.h"

#include <stddef.h>
#include <stdint.h>
#include <string.h>

/* Full feature distances of several rows side by side. */
enum { DUCT_ABREAST = 8 };

typedef float duct_fours __attribute__((vector_size(4 * sizeof(float))));
typedef float duct_loose_fours __attribute__((vector_size(4 * sizeof(float)), aligned(sizeof(float))));

/* Four dimensions of four rows each come in, and are turned so that a row's squares lie in one lane. */
WIDE_PART void duct_add_squares(duct_fours values, const float *const *rows, size_t at, duct_fours *sum)
{
    duct_fours a = values - *(const duct_loose_fours *)(rows[0] + at),
               b = values - *(const duct_loose_fours *)(rows[1] + at);
    duct_fours c = values - *(const duct_loose_fours *)(rows[2] + at),
               d = values - *(const duct_loose_fours *)(rows[3] + at);
    a *= a;
    b *= b;
    c *= c;
    d *= d;
    duct_fours ab = __builtin_shufflevector(a, b, 0, 4, 1, 5);
    duct_fours cd = __builtin_shufflevector(c, d, 0, 4, 1, 5);
    *sum += __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    *sum += __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    ab = __builtin_shufflevector(a, b, 2, 6, 3, 7);
    cd = __builtin_shufflevector(c, d, 2, 6, 3, 7);
    *sum += __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    *sum += __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/* Squared distances of DUCT_ABREAST rows, each summed up in the order of the dimensions. */
WIDE_PART void duct_squares_abreast(const float *query, const float *const *rows, size_t dimensions,
                                    float *squares)
{
    duct_fours low = {0}, high = {0};
    size_t d = 0;
    for (; d + 4 <= dimensions; d += 4) {
        duct_fours values = *(const duct_loose_fours *)(query + d);
        duct_add_squares(values, rows, d, &low);
        duct_add_squares(values, rows + 4, d, &high);
    }
    memcpy(squares, &low, sizeof low);
    memcpy(squares + 4, &high, sizeof high);
    for (; d < dimensions; d++) {
        for (size_t i = 0; i < DUCT_ABREAST; i++) {
            float difference = query[d] - rows[i][d];
            squares[i] += difference * difference;
        }
    }
}

#endif
