/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_STATISTICS_H
#define DUCTUS_GEOMETRY_STATISTICS_H

#include <stddef.h>

/* The median; sorts the values. 0 for none. */
double duct_median(double *values, size_t count);

/* The value that the share `share` of the values is below; sorts them. 0 for none. */
double duct_quantile(double *values, size_t count, double share);

#endif
