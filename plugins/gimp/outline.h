/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_OUTLINE_H
#define PLUG_OUTLINE_H

#include <ductus/drawing.h>

#include <libgimp/gimp.h>

/* Appends the outline of the image's selection, as GIMP's own "selection to path" finds it. The image is not
 * changed: GIMP works on a copy of the selection in an image of its own. Errors: DUCT_UNSUPPORTED (nothing is
 * selected, or GIMP failed). */
duct_status plug_outline_read(gint32 image, duct_drawing *drawing, duct_error *error);

#endif
