/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_BACKDROP_H
#define PLUG_BACKDROP_H

#include "task.h"

/* The image as it is, for previews to be laid over. */
struct backdrop;

struct backdrop *plug_backdrop_new(gint32 image);
void plug_backdrop_free(struct backdrop *backdrop);

/* What a view shows of the image, transparent outside. The caller destroys it. */
cairo_surface_t *plug_backdrop_show(struct backdrop *backdrop, const struct view *view);

#endif
