/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_POLYLINE_H
#define DUCTUS_GEOMETRY_POLYLINE_H

#include "base/memory.h"

#include <ductus/status.h>

/* Marks the vertices of the best polyline through points first..last of a curve: the one that minimises the
 * sum of the squared distances of the points from their segment's line plus `cost` a segment (after McCrae
 * and Singh, "Sketching piecewise clothoid curves", 2009, as "HelpingHand" section 4.3.2 uses it), found by
 * dynamic programming. No segment is longer than `longest` points. Sets marks[i] = true for the inner
 * vertices. Errors: DUCT_NO_MEMORY. */
duct_status duct_polyline_vertices(const duct_allocator *allocator, const double *x, const double *y,
                                   size_t first, size_t last, double cost, size_t longest, bool *marks,
                                   duct_error *error);

#endif
