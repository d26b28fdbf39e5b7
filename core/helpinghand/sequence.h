/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_HELPINGHAND_SEQUENCE_H
#define DUCTUS_HELPINGHAND_SEQUENCE_H

#include "base/memory.h"

#include <ductus/status.h>

#include <stdint.h>

/* The optimal sequence of library samples for a query stroke: "HelpingHand" section 4.2.3, solved exactly. */

/* A library sample that may stand for a query sample. */
typedef struct duct_candidate {
    uint32_t sample; /* among all of the library's samples */
    uint32_t stroke;
    float distance; /* in feature space, from the query sample */
} duct_candidate;

/* The candidates of each query sample: column i is items[starts[i]] .. items[starts[i + 1] - 1], without
 * repetition and in ascending order of `sample`, which is that of (stroke, sample in it). No column is empty.
 */
typedef struct duct_columns {
    size_t count;
    size_t *starts;
    duct_candidate *items;
} duct_columns;

/* What a jump costs beyond its constant is a distance between vectors of the two library samples: for pose,
 * channels over their standard deviations and the twist, which is an angle; for trajectory, unit velocities.
 */
enum { DUCT_JUMP_LINEAR = 3 };
typedef struct duct_jump_vector {
    double linear[DUCT_JUMP_LINEAR]; /* pose: pressure, tilt_x, tilt_y over their deviations; trajectory: vx,
                                        vy, 0 */
    double twist;                    /* pose: radians */
} duct_jump_vector;

typedef struct duct_jump_space {
    const duct_jump_vector *vectors; /* by library sample */
    bool direction;                  /* trajectory: 1 - v . v'; otherwise the Euclidean distance of poses */
    double twist_deviation;          /* 0: the library has no twist */
} duct_jump_space;

/* The distance that C_p multiplies. */
double duct_jump_distance(const duct_jump_space *space, uint32_t from, uint32_t to);

/* The largest shortest segment L_min. */
enum { DUCT_MOST_SHORTEST = 32 };

typedef struct duct_sequence_costs {
    double stretch;  /* C_r: using a library sample twice */
    double shrink;   /* C_s: leaving one out */
    double jump;     /* C_t */
    double distance; /* C_p */
    double brief;    /* C_l: for each segment below the shortest */
    size_t shortest; /* L_min in samples, 1..DUCT_MOST_SHORTEST */
    double end;      /* C_e: for each sample that an end is off the library stroke's end */
} duct_sequence_costs;

/* How one goes from a library sample to the next query sample's. */
typedef enum duct_transition {
    DUCT_TRANSITION_CONSECUTIVE,
    DUCT_TRANSITION_STRETCH,
    DUCT_TRANSITION_SHRINK,
    DUCT_TRANSITION_JUMP
} duct_transition;

/* The kind of the transition from column i to i + 1; `repeated` says whether `from` itself is a repetition of
 * the sample before it, which allows no second one. */
duct_transition duct_transition_of(const duct_candidate *from, const duct_candidate *to, bool repeated);

/* The four terms e_f, e_t, e_s, e_m and their sum. */
typedef struct duct_sequence_terms {
    double feature, transition, brief, end, total;
} duct_sequence_terms;

/* The terms of a given sequence, straight from their definition: chosen[i] is a place in columns->items.
 * `by_sample` may be NULL, or has room for the share of each query sample: the transition that leads away
 * from it, the short segment that ends with it, the ends on the first and last. */
duct_sequence_terms duct_sequence_evaluate(const duct_columns *columns, const uint32_t *starts,
                                           const duct_jump_space *space, const duct_sequence_costs *costs,
                                           const size_t *chosen, duct_sequence_terms *by_sample);

/* Finds the sequence with the lowest total. `starts` are the library's stroke starts, of `starts[s + 1] -
 * starts[s]` samples each. The dynamic program's state is a candidate, the length of its segment so far (up
 * to L_min) and whether it repeats the one before, so the result is exact; among equals the lower library
 * stroke, then sample, wins, looking from the end. Memory grows with the square root of the stroke's length.
 * Errors: DUCT_NO_MEMORY. */
duct_status duct_sequence_solve(const duct_allocator *allocator, const duct_columns *columns,
                                const uint32_t *starts, const duct_jump_space *space,
                                const duct_sequence_costs *costs, size_t *chosen, duct_error *error);

#endif
