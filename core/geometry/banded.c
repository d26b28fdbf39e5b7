/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/banded.h"

void duct_pentadiagonal_add(duct_pentadiagonal *matrix, double *right_x, double *right_y, size_t start,
                            const double *coefficients, size_t terms, double weight, double target_x,
                            double target_y)
{
    for (size_t k = 0; k < terms; k++) {
        size_t row = start + k;
        double scaled = weight * coefficients[k];
        matrix->main[row] += scaled * coefficients[k];
        if (k + 1 < terms) {
            matrix->first[row] += scaled * coefficients[k + 1];
        }
        if (k + 2 < terms) {
            matrix->second[row] += scaled * coefficients[k + 2];
        }
        right_x[row] += scaled * target_x;
        right_y[row] += scaled * target_y;
    }
}

bool duct_pentadiagonal_solve(duct_pentadiagonal *matrix, double *right_x, double *right_y)
{
    size_t n = matrix->count;
    double *d = matrix->main, *e = matrix->first, *f = matrix->second;
    /* Factor: d becomes the diagonal of D; e and f the two subdiagonals of L. */
    for (size_t i = 0; i < n; i++) {
        if (!(d[i] > 0)) {
            return false;
        }
        double e_over = i + 1 < n ? e[i] / d[i] : 0, f_over = i + 2 < n ? f[i] / d[i] : 0;
        if (i + 1 < n) {
            d[i + 1] -= e_over * e[i];
            if (i + 2 < n) {
                e[i + 1] -= e_over * f[i];
                d[i + 2] -= f_over * f[i];
                f[i] = f_over;
            }
            e[i] = e_over;
        }
    }
    for (size_t i = 0; i < n; i++) {
        if (i >= 1) {
            right_x[i] -= e[i - 1] * right_x[i - 1];
            right_y[i] -= e[i - 1] * right_y[i - 1];
        }
        if (i >= 2) {
            right_x[i] -= f[i - 2] * right_x[i - 2];
            right_y[i] -= f[i - 2] * right_y[i - 2];
        }
    }
    for (size_t i = n; i-- > 0;) {
        right_x[i] /= d[i];
        right_y[i] /= d[i];
        if (i + 1 < n) {
            right_x[i] -= e[i] * right_x[i + 1];
            right_y[i] -= e[i] * right_y[i + 1];
        }
        if (i + 2 < n) {
            right_x[i] -= f[i] * right_x[i + 2];
            right_y[i] -= f[i] * right_y[i + 2];
        }
    }
    return true;
}
