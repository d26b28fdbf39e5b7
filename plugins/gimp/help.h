/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_HELP_H
#define PLUG_HELP_H

#include <glib.h>

/* Opens the page about the plug-in in the user's browser. It has the form of a GimpHelpFunc. */
void plug_help(const gchar *id, gpointer data);

#endif
