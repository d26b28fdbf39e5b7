/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_RUN_H
#define PLUG_RUN_H

#include "result.h"

/* Sets up a work for the whole of the job's image. `*brush` is the caller's to free after the work, and NULL
 * where nothing is painted. */
duct_status plug_run_prepare(const struct job *job, struct work *work, duct_brush **brush, duct_error *error);

/* How the job's strokes are painted on a canvas that shows the image at `scale` from (x, y), in image pixels,
 * on. */
duct_paint_options plug_run_paint_options(const struct job *job, double scale, double x, double y);

/* The whole job, with GIMP's own progress bar. */
duct_status plug_run(const struct job *job, struct result *result, duct_error *error);

#endif
