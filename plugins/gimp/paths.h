/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_PATHS_H
#define PLUG_PATHS_H

#include <ductus/drawing.h>
#include <ductus/path.h>

#include <libgimp/gimp.h>

/* Appends the lines of a GIMP path to a drawing; ids and groups of the strokes are its name, or `name` where
 * that is not NULL. Errors: those of duct_path_flatten(). */
duct_status plug_paths_read(gint32 vectors, const char *name, duct_drawing *drawing, duct_error *error);

/* Makes GIMP paths of a drawing's strokes, one for each group of strokes, named after it and `suffix`, fitted
 * within `tolerance` pixels. They are not in the image yet. `*made` gets their ids, of type gint32. Where it
 * fails, there are none. */
duct_status plug_paths_make(gint32 image, const duct_drawing *drawing, const char *suffix, double tolerance,
                            GArray **made, duct_error *error);

#endif
