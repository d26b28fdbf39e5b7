/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_H
#define DUCTUS_HELPINGHAND_H

#include "base/text.h"
#include "features/features.h"
#include "helpinghand/sequence.h"
#include "helpinghand/shape.h"
#include "library/feature_index.h"

#include <ductus/drawing.h>
#include <ductus/library.h>

/* "HelpingHand: example-based stroke stylization" (Lu, Yu, Finkelstein, DiVerdi 2012): pose and trajectory of
 * strokes after a library of recorded ones, stroke by stroke. */

typedef enum duct_stylization {
    DUCT_STYLIZE_POSE,       /* the trajectory stays, pose is synthesized for it */
    DUCT_STYLIZE_TRAJECTORY, /* the trajectory is synthesized, pose stays */
    DUCT_STYLIZE_ONE_PASS,   /* both from one sequence, section 4.4 */
    DUCT_STYLIZE_TWO_PASS    /* trajectory first, then pose for the new trajectory, section 4.4 */
} duct_stylization;

typedef enum duct_selection {
    DUCT_SELECT_OPTIMAL, /* section 4.2.3 */
    DUCT_SELECT_AVERAGE, /* section 4.2.2 */
    DUCT_SELECT_CLOSEST  /* section 4.2.1 */
} duct_selection;

/* What pose and trajectory synthesis have each of their own. */
typedef struct duct_pass_options {
    size_t neighbours; /* k */
    duct_sequence_costs costs;
    size_t blend; /* samples on each side of a jump, section 4.3.1 */
} duct_pass_options;

typedef struct duct_helpinghand_options {
    duct_stylization mode;
    duct_selection select;
    duct_feature_options features;
    duct_search_kind search;
    bool coherent;
    duct_pass_options pose, trajectory;
    duct_shape_options shape;
    bool keep;        /* recorded pose channels stay; only missing ones are filled */
    double amount;    /* 0: the input as it is, 1: the full effect */
    double variation; /* 0: the optimum itself */
    uint64_t seed;
} duct_helpinghand_options;

/* A library made ready for stylizing with certain options. Read-only once made; used from several threads at
 * once. */
typedef struct duct_helpinghand {
    duct_allocator allocator;
    const duct_library *library;
    duct_helpinghand_options options;
    double unit; /* drawing pixels a sampling unit */
    bool refine; /* vector strokes that the unit is too coarse for get one of their own */
    duct_feature_index index;
    duct_jump_vector *poses;      /* by library sample */
    duct_jump_vector *directions; /* by library sample */
} duct_helpinghand;

/* The sampling unit, in drawing pixels, at which a drawing's sizes meet the library's: the median strokes of
 * both are equally long, or, where that is finer, their curves are equally large (arc length for each radian
 * of turning), so that a word written in one stroke is not taken for a letter. Errors: DUCT_NO_MEMORY. */
duct_status duct_helpinghand_auto_unit(const duct_allocator *allocator, const duct_library *library,
                                       const duct_drawing *drawing, double *unit, duct_error *error);

/* Checks that the library has what the options ask for, and makes it ready. `library` must outlive it. Freed
 * by duct_helpinghand_done(). Errors: DUCT_UNSUPPORTED (names the missing channel), DUCT_NO_MEMORY. */
duct_status duct_helpinghand_init(const duct_allocator *allocator, const duct_library *library,
                                  const duct_helpinghand_options *options, double unit, bool refine,
                                  duct_helpinghand *hand, duct_error *error);
void duct_helpinghand_done(duct_helpinghand *hand);

/* Stylizes a stroke in place. Its samples are kept, and more come between those that are farther apart than
 * the hand's detail needs (not in a recorded stroke whose trajectory stays). With amount 0 nothing changes.
 * Where `trace` is not NULL, a JSON object that describes the passes is added to it. Errors: DUCT_NO_MEMORY,
 * DUCT_LIMIT; the stroke is then as it was. */
duct_status duct_helpinghand_stylize(const duct_helpinghand *hand, duct_stroke *stroke, duct_text *trace,
                                     duct_error *error);

#endif
