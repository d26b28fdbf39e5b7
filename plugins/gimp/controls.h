/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_CONTROLS_H
#define PLUG_CONTROLS_H

#include "job.h"

#include <gtk/gtk.h>

/* The controls of a job's settings, made from the tables. */
struct controls;

/* Called when the user has changed a value; the job has it already. */
typedef void (*plug_changed)(void *user);

/* The job must outlive them. Free with plug_controls_free() when the widget is gone. */
struct controls *plug_controls_new(struct job *job, plug_changed changed, void *user);
void plug_controls_free(struct controls *controls);

/* A notebook: everyday parameters on its first page, the others on a page for each of their groups. */
GtkWidget *plug_controls_widget(struct controls *controls);

/* Shows the job's values, without telling of changes. */
void plug_controls_show(struct controls *controls);

#endif
