/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_PASS_H
#define DUCTUS_HELPINGHAND_PASS_H

#include "base/json.h"
#include "helpinghand/gesture.h"
#include "helpinghand/helpinghand.h"

/* One pass over a query stroke of `count` uniform samples (x, y in sampling units): candidates, selection,
 * blending. Gives a gesture for each sample. `direction`: for trajectory, with its options and jump costs,
 * rather than pose. Where `trace` is not NULL, the pass is described in it as an object. Errors:
 * DUCT_NO_MEMORY, DUCT_UNSUPPORTED. */
duct_status duct_pass_run(const duct_helpinghand *hand, bool direction, const char *stroke_id,
                          const double *x, const double *y, size_t count, duct_gesture *gestures,
                          duct_json *trace, duct_error *error);

#endif
