/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_VALUES_H
#define PLUG_VALUES_H

#include "job.h"

/* The values that were last used, a set for each procedure: kept by GIMP while it runs, and in the user's
 * GIMP folder from one run of GIMP to the next. */

/* Sets what was kept; values that no longer fit the table stay at their defaults. */
void plug_values_load(struct job *job);
void plug_values_keep(const struct job *job);

/* Gives a job the values that a user starts from: parameters that have to be given get the first there is. */
void plug_values_first(struct job *job);

#endif
