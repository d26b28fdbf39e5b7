/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_WORK_H
#define PLUG_WORK_H

#include <ductus/operation.h>
#include <ductus/render.h>

/* The part of a job that needs no GIMP, and so may run on another thread: the operation, and painting what it
 * gives on a canvas. */
struct work {
    const duct_settings *settings;
    const duct_drawing *input;
    const duct_brush *brush; /* NULL: nothing is painted */
    duct_paint_options paint;
    int width, height; /* of the canvas */
    duct_context context;
    const duct_drawing *known; /* what the operation gave before; NULL: it is run */

    duct_drawing *output; /* the results; NULL where it failed, or was known */
    duct_canvas *canvas;
    duct_error error;
    double brush_seconds; /* how long painting took */
};

/* Progress goes through the context from 0 to 1. */
duct_status plug_work_run(struct work *work);

/* Frees the results. */
void plug_work_done(struct work *work);

#endif
