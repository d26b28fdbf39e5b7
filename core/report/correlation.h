/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_REPORT_CORRELATION_H
#define DUCTUS_REPORT_CORRELATION_H

#include <stdbool.h>
#include <stddef.h>

/* Pearson's correlation coefficient of two runs of `count` values. False where a run is constant, to within
 * what a tablet can tell. `angle`: the values are radians and are unwrapped along each run; else they are
 * pressures. */
bool duct_correlate(const double *a, const double *b, size_t count, bool angle, double *coefficient);

/* An average of coefficients as Fisher's z = atanh r (Silver and Dunlap 1987). Zeroed at first. */
typedef struct duct_fisher {
    double sum;
    size_t count;
} duct_fisher;

void duct_fisher_add(duct_fisher *fisher, double coefficient);

/* Adds the other average as one coefficient, where it has any. */
void duct_fisher_add_mean(duct_fisher *fisher, const duct_fisher *other);

/* The average as a coefficient; a NaN where there is none. */
double duct_fisher_mean(const duct_fisher *fisher);

#endif
