/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_BANDED_H
#define DUCTUS_GEOMETRY_BANDED_H

#include <stdbool.h>
#include <stddef.h>

/* A symmetric positive definite matrix with two diagonals on each side of the main one, and its solution by
 * LDL^T without pivoting: O(n) time, no memory of its own. LAPACK's dpbsv does the same four times as slowly
 * at these sizes. */
typedef struct duct_pentadiagonal {
    size_t count;
    double *main;   /* a[i][i] */
    double *first;  /* a[i][i + 1], count - 1 used */
    double *second; /* a[i][i + 2], count - 2 used */
} duct_pentadiagonal;

/* Adds weight * (sum of coefficients[k] x[start + k] - target)^2 to a least-squares problem in `terms` <= 3
 * neighbouring unknowns, for two right-hand sides at once (x and y of a curve). */
void duct_pentadiagonal_add(duct_pentadiagonal *matrix, double *right_x, double *right_y, size_t start,
                            const double *coefficients, size_t terms, double weight, double target_x,
                            double target_y);

/* Replaces the matrix by its factors and the right-hand sides by the solutions. False where the matrix is not
 * positive definite; then all of them are spoilt. */
bool duct_pentadiagonal_solve(duct_pentadiagonal *matrix, double *right_x, double *right_y);

#endif
