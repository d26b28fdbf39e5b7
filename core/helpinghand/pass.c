/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/pass.h"

#include "base/error.h"
#include "helpinghand/candidates.h"

#include <ductus/random.h>

static void trace_terms(duct_json *trace, const char *key, const duct_sequence_terms *terms)
{
    duct_json_row(trace, key, '{');
    duct_json_number(trace, "feature", terms->feature);
    duct_json_number(trace, "transition", terms->transition);
    duct_json_number(trace, "short", terms->brief);
    duct_json_number(trace, "endpoint", terms->end);
    duct_json_number(trace, "total", terms->total);
    duct_json_close(trace, '}');
}

static void trace_place(duct_json *trace, const char *key, const duct_library *library,
                        const duct_candidate *candidate)
{
    duct_json_row(trace, key, '[');
    duct_json_integer(trace, NULL, candidate->stroke);
    duct_json_integer(trace, NULL, candidate->sample - library->starts[candidate->stroke]);
    duct_json_number(trace, NULL, (double)candidate->distance);
    duct_json_close(trace, ']');
}

static void trace_vector(duct_json *trace, const duct_jump_space *space, uint32_t sample)
{
    const duct_jump_vector *vector = &space->vectors[sample];
    duct_json_row(trace, NULL, '[');
    for (int i = 0; i < (space->direction ? 2 : DUCT_JUMP_LINEAR); i++) {
        duct_json_number(trace, NULL, vector->linear[i]);
    }
    if (!space->direction) {
        duct_json_number(trace, NULL, vector->twist);
    }
    duct_json_close(trace, ']');
}

/* `chosen` and `terms` are NULL where no sequence was chosen. */
static void trace_pass(duct_json *trace, const duct_helpinghand *hand, const duct_columns *columns,
                       const duct_jump_space *space, const size_t *chosen,
                       const duct_sequence_terms *by_sample, const duct_sequence_terms *sum)
{
    static const char *const kinds[] = {"consecutive", "stretch", "shrink", "jump"};
    duct_json_object(trace, NULL);
    duct_json_string(trace, "pass", space->direction ? "trajectory" : "pose");
    duct_json_number(trace, "twist_deviation", space->twist_deviation);
    duct_json_array(trace, "samples");
    for (size_t i = 0; i < columns->count; i++) {
        duct_json_object(trace, NULL);
        duct_json_row(trace, "candidates", '[');
        for (size_t n = columns->starts[i]; n < columns->starts[i + 1]; n++) {
            trace_place(trace, NULL, hand->library, &columns->items[n]);
        }
        duct_json_close(trace, ']');
        duct_json_row(trace, "vectors", '[');
        for (size_t n = columns->starts[i]; n < columns->starts[i + 1]; n++) {
            trace_vector(trace, space, columns->items[n].sample);
        }
        duct_json_close(trace, ']');
        if (chosen == NULL && hand->options.select == DUCT_SELECT_CLOSEST) {
            trace_place(trace, "chosen", hand->library, &columns->items[columns->starts[i]]);
        }
        if (chosen != NULL) {
            trace_place(trace, "chosen", hand->library, &columns->items[chosen[i]]);
            if (i + 1 < columns->count) {
                bool repeated =
                    i > 0 && columns->items[chosen[i - 1]].sample == columns->items[chosen[i]].sample;
                duct_json_string(trace, "next",
                                 kinds[duct_transition_of(&columns->items[chosen[i]],
                                                          &columns->items[chosen[i + 1]], repeated)]);
            }
            trace_terms(trace, "costs", &by_sample[i]);
        }
        duct_json_close(trace, '}');
    }
    duct_json_close(trace, ']');
    if (chosen != NULL) {
        trace_terms(trace, "costs", sum);
    }
    duct_json_close(trace, '}');
}

static duct_status run_optimal(const duct_helpinghand *hand, const duct_pass_options *pass,
                               const duct_columns *columns, const duct_jump_space *space,
                               duct_gesture *gestures, duct_json *trace, duct_error *error)
{
    const duct_allocator *allocator = &hand->allocator;
    const uint32_t *starts = hand->library->starts;
    size_t *chosen = duct_alloc(allocator, columns->count, sizeof *chosen);
    duct_sequence_terms *by_sample =
        trace != NULL ? duct_alloc(allocator, columns->count, sizeof *by_sample) : NULL;
    duct_status status;
    if (chosen == NULL || (trace != NULL && by_sample == NULL)) {
        status = duct_fail_memory(error);
    } else {
        status = duct_sequence_solve(allocator, columns, starts, space, &pass->costs, chosen, error);
    }
    if (status == DUCT_OK) {
        duct_gestures_sequence(hand->library, columns, chosen, pass->blend, gestures);
    }
    if (status == DUCT_OK && trace != NULL) {
        duct_sequence_terms sum =
            duct_sequence_evaluate(columns, starts, space, &pass->costs, chosen, by_sample);
        trace_pass(trace, hand, columns, space, chosen, by_sample, &sum);
    }
    duct_release(allocator, chosen);
    duct_release(allocator, by_sample);
    return status;
}

duct_status duct_pass_run(const duct_helpinghand *hand, bool direction, const char *stroke_id,
                          const double *x, const double *y, size_t count, duct_gesture *gestures,
                          duct_json *trace, duct_error *error)
{
    const duct_helpinghand_options *options = &hand->options;
    const duct_pass_options *pass = direction ? &options->trajectory : &options->pose;
    duct_candidate_options wanted = {
        .features = options->features,
        .neighbours = options->select == DUCT_SELECT_CLOSEST ? 1 : pass->neighbours,
        .coherent = options->coherent && options->select == DUCT_SELECT_OPTIMAL,
        .variation = options->variation,
        .seed = options->seed,
        .stroke_id = duct_random_id(stroke_id),
    };
    duct_jump_space space = {
        direction ? hand->directions : hand->poses, direction,
        hand->library->channels[DUCT_TWIST] != NULL ? hand->library->deviation[DUCT_TWIST] : 0};
    duct_columns columns;
    duct_status status = duct_candidates_find(&hand->allocator, hand->library, &hand->index, &wanted, x, y,
                                              count, &columns, error);
    if (status != DUCT_OK) {
        return status;
    }
    if (options->select == DUCT_SELECT_OPTIMAL) {
        status = run_optimal(hand, pass, &columns, &space, gestures, trace, error);
    } else {
        if (options->select == DUCT_SELECT_AVERAGE) {
            duct_gestures_average(hand->library, &columns, gestures);
        } else {
            duct_gestures_closest(hand->library, &columns, gestures);
        }
        if (trace != NULL) {
            trace_pass(trace, hand, &columns, &space, NULL, NULL, NULL);
        }
    }
    duct_columns_free(&hand->allocator, &columns);
    return status;
}
