/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_CHOOSERS_H
#define PLUG_CHOOSERS_H

#include <gtk/gtk.h>

/* A list of things with a picture and a name, and a button for a file instead. */
struct chooser;

typedef void (*plug_chosen)(const char *value, void *user);

/* The hands there are, each with some of its strokes. Pictures come while the user looks on. */
struct chooser *plug_hand_chooser_new(plug_chosen chosen, void *user);

/* The brushes there are. */
struct chooser *plug_brush_chooser_new(plug_chosen chosen, void *user);

void plug_chooser_free(struct chooser *chooser); /* NULL is allowed; the widget is its container's */
GtkWidget *plug_chooser_widget(struct chooser *chooser);

/* Shows a value; a file's path gets a row of its own. */
void plug_chooser_set(struct chooser *chooser, const char *value);

#endif
