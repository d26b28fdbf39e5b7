/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_BRUSHES_H
#define PLUG_BRUSHES_H

#include <ductus/render.h>

#include <glib.h>

/* A brush that can be chosen. */
typedef struct plug_brush {
    char *value;   /* what the option `brush` holds: a name of Ductus, or folder/name of a MyPaint brush */
    char *group;   /* "Ductus", or the MyPaint brush's folder */
    char *label;   /* the name to show */
    char *picture; /* a picture file of it; NULL: none */
} plug_brush;

/* The brushes of Ductus, then the MyPaint brushes of GIMP's brush folders, each sorted; of type plug_brush.
 * Free with g_array_free(): the entries clear themselves. */
GArray *plug_brushes_list(void);

/* Loads a brush by its value, or by a .myb file's path. The caller frees it. Errors: those of
 * duct_brush_load(). */
duct_status plug_brush_load(const char *value, duct_brush **brush, duct_error *error);

#endif
