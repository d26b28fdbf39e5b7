/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_PICTURES_H
#define PLUG_PICTURES_H

#include <gdk-pixbuf/gdk-pixbuf.h>

/* Small pictures for lists. The caller unrefs them. */

/* White, of the size of the others. */
GdkPixbuf *plug_picture_blank(void);

/* The first strokes of a recording, as wide as they were pressed; NULL where it cannot be read. */
GdkPixbuf *plug_picture_of_hand(const char *file, const char *name);

/* A brush's own picture file where it has one, or else a mark of it; NULL where there is neither. */
GdkPixbuf *plug_picture_of_brush(const char *file, const char *name);

#endif
