/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_TASK_H
#define PLUG_TASK_H

#include "lines.h"
#include "work.h"

#include <cairo.h>

/* A part of the image as it is looked at: its upper left corner in image pixels, and pixels shown an image
 * pixel. */
struct view {
    double x, y, scale;
    int width, height; /* pixels shown */
};

/* Work on another thread, so that a dialog goes on answering. The thread asks nothing of GIMP. What it is
 * given must stay until it has ended. */
struct task {
    struct lines *lines; /* taken into memory; it finds them where `found` is not set */
    bool found;
    duct_settings *settings; /* its own copy */
    struct work work;        /* brush, canvas and what is known already, filled in by who starts it */
    bool picture;            /* make a picture of the view */
    bool paths;              /* with the lines themselves in it */
    struct view view;
    float *mask; /* how much paint each pixel of the view takes; NULL: all. Its own */

    GSourceFunc ended; /* called by the main loop with the task, unless it was waited for */
    void *user;        /* for who started it */

    duct_status status;
    duct_error error;
    cairo_surface_t *result; /* the picture, premultiplied */

    GThread *thread;
    int stop, percent; /* atomic */
};

/* A copy of settings with all their values. */
duct_settings *plug_settings_copy(const duct_settings *settings);

void plug_task_start(struct task *task);

/* Asks it to stop soon; it ends with DUCT_CANCELLED. */
void plug_task_stop(struct task *task);

/* Waits for its end. */
void plug_task_wait(struct task *task);

double plug_task_progress(const struct task *task);

/* Frees what it made and was given for its own; it has ended. */
void plug_task_free(struct task *task);

#endif
