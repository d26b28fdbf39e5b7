/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What restyle's trace holds: enough to compute every cost again. */
#include "operations/curls.h"

#include <json-c/json.h>

static double number_at(struct json_object *object, const char *key)
{
    struct json_object *value = NULL;
    assert_true(json_object_object_get_ex(object, key, &value));
    return json_object_get_double(value);
}

/* Anyone can recompute the costs from the trace alone: the features' sum, the jumps' distances, segments,
 * ends. */
static void check_pass(struct json_object *pass, struct json_object *lengths)
{
    struct json_object *samples = NULL, *costs = NULL, *name = NULL;
    assert_true(json_object_object_get_ex(pass, "samples", &samples));
    assert_true(json_object_object_get_ex(pass, "costs", &costs));
    assert_true(json_object_object_get_ex(pass, "pass", &name));
    bool pose = strcmp(json_object_get_string(name), "pose") == 0;
    double twist = number_at(pass, "twist_deviation"), feature = 0, transition = 0, brief = 0, end = 0;
    size_t count = json_object_array_length(samples), length = 1;
    double vector[4] = {0}, last_vector[4] = {0};
    int stroke = 0, sample = 0, last_stroke = 0, last_sample = 0, before = -1;
    for (size_t i = 0; i < count; i++) {
        struct json_object *entry = json_object_array_get_idx(samples, i), *chosen = NULL, *candidates = NULL,
                           *vectors = NULL;
        json_object_object_get_ex(entry, "chosen", &chosen);
        json_object_object_get_ex(entry, "candidates", &candidates);
        json_object_object_get_ex(entry, "vectors", &vectors);
        stroke = json_object_get_int(json_object_array_get_idx(chosen, 0));
        sample = json_object_get_int(json_object_array_get_idx(chosen, 1));
        bool found = false;
        for (size_t n = 0; n < json_object_array_length(candidates); n++) {
            struct json_object *row = json_object_array_get_idx(candidates, n);
            if (json_object_equal(row, chosen)) {
                struct json_object *numbers = json_object_array_get_idx(vectors, n);
                for (size_t k = 0; k < json_object_array_length(numbers); k++) {
                    vector[k] = json_object_get_double(json_object_array_get_idx(numbers, k));
                }
                found = true;
            }
        }
        assert_true(found);
        feature += json_object_get_double(json_object_array_get_idx(chosen, 2));
        int own = json_object_get_int(json_object_array_get_idx(lengths, (size_t)stroke));
        if (i == 0) {
            end += 3 * sample;
        } else {
            bool same = stroke == last_stroke, jump = false;
            if (same && sample == last_sample + 1) {
                ;
            } else if (same && sample == last_sample && before != 1) {
                transition += 3;
            } else if (same && sample == last_sample + 2) {
                transition += 3;
            } else {
                jump = true;
                double distance;
                if (pose) {
                    double turn = twist > 0 ? remainder(vector[3] - last_vector[3], 2 * M_PI) / twist : 0;
                    distance = sqrt(pow(vector[0] - last_vector[0], 2) + pow(vector[1] - last_vector[1], 2) +
                                    pow(vector[2] - last_vector[2], 2) + turn * turn);
                } else {
                    distance = 1 - (vector[0] * last_vector[0] + vector[1] * last_vector[1]);
                }
                transition += 50 + 10 * distance;
            }
            before = same && sample == last_sample;
            if (jump) {
                brief += length < 12 ? pow(3 + 12 - (double)length, 2) : 0;
            }
            length = jump ? 1 : length + 1;
        }
        if (i + 1 == count) {
            brief += length < 12 ? pow(3 + 12 - (double)length, 2) : 0;
            end += 3 * (own - 1 - sample);
        }
        last_stroke = stroke;
        last_sample = sample;
        memcpy(last_vector, vector, sizeof vector);
    }
    assert_true(fabs(feature - number_at(costs, "feature")) < 1e-6 * (1 + feature));
    assert_true(fabs(transition - number_at(costs, "transition")) < 1e-6 * (1 + transition));
    assert_true(fabs(brief - number_at(costs, "short")) < 1e-6 * (1 + brief));
    assert_true(fabs(end - number_at(costs, "endpoint")) < 1e-6 * (1 + end));
    assert_true(fabs(feature + transition + brief + end - number_at(costs, "total")) < 1e-5 * (1 + feature));
}

static void the_trace_says_what_was_chosen_and_why(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(7, 0, 0, 1), *output;
    duct_settings *settings;
    assert_ok(duct_settings_new(NULL, duct_operation_at(0), &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", hand, &error));
    traced first = {NULL, 0}, second = {NULL, 0};
    duct_context context = duct_context_default();
    for (int threads = 1; threads <= 4; threads += 3) {
        context.threads = threads;
        duct_run_options options = {keep_trace, threads == 1 ? &first : &second};
        assert_ok(duct_operation_run(&context, settings, input, &options, &output, &error));
        duct_drawing_free(output);
    }
    assert_int_equal(first.size, second.size);
    assert_memory_equal(first.text, second.text, first.size);
    struct json_object *root = json_tokener_parse(first.text), *strokes = NULL, *library = NULL,
                       *lengths = NULL;
    assert_non_null(root);
    assert_true(json_object_object_get_ex(root, "strokes", &strokes));
    assert_true(json_object_object_get_ex(root, "library", &library));
    assert_true(json_object_object_get_ex(library, "stroke_samples", &lengths));
    assert_int_equal(json_object_array_length(strokes), 7);
    for (size_t s = 0; s < 7; s++) {
        struct json_object *passes = NULL;
        assert_true(json_object_object_get_ex(json_object_array_get_idx(strokes, s), "passes", &passes));
        assert_int_equal(json_object_array_length(passes), 2);
        check_pass(json_object_array_get_idx(passes, 0), lengths);
        check_pass(json_object_array_get_idx(passes, 1), lengths);
    }
    json_object_put(root);
    free(first.text);
    free(second.text);
    duct_settings_free(settings);
    duct_drawing_free(input);
    duct_library_free(hand);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_trace_says_what_was_chosen_and_why),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
