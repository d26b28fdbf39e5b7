/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_PATH_H
#define DUCTUS_FORMATS_SVG_PATH_H

#include "geometry/path.h"

/* Adds the path that the value of a `d` attribute describes, by the grammar of SVG 1.1, section 8.3.9. An
 * error in it ends the path: what stands before the error is kept (section 8.3.9 and F.2). A move that
 * nothing is drawn from adds nothing. Every subpath begins with a move and ends at the next move or behind
 * its first close. */
void duct_svg_path_data(const char *data, duct_path *path);

/* Adds the polyline of a `points` attribute, with the same rule for errors. */
void duct_svg_points(const char *data, bool closed, duct_path *path);

#endif
