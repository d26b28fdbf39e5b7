/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_RUN_H
#define PLUG_RUN_H

#include "result.h"

/* Sets up a work for the job's image: brush, place and size of what is painted, at `scale` times the image's
 * size.
 * `*brush` is the caller's to free after the work, and NULL where nothing is painted. */
duct_status plug_run_prepare(const struct job *job, struct work *work, duct_brush **brush, duct_error *error);

/* The whole job, with GIMP's own progress bar. */
duct_status plug_run(const struct job *job, struct result *result, duct_error *error);

#endif
