/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_PREVIEW_H
#define PLUG_PREVIEW_H

#include "job.h"

#include <gtk/gtk.h>

/* The image with the job's result laid over it. It is worked out on another thread; a change of values stops
 * what is going on and begins anew after a moment. */
struct preview;

/* The job must outlive it. */
struct preview *plug_preview_new(const struct job *job);

/* Stops and waits for what is going on. */
void plug_preview_free(struct preview *preview);

GtkWidget *plug_preview_widget(struct preview *preview);

/* The job's values have changed. */
void plug_preview_update(struct preview *preview);

/* Stops what is going on, and begins nothing new until the next update. */
void plug_preview_pause(struct preview *preview);

#endif
