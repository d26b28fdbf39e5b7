/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operations `analogy` and `synthesize-curve` on drawings. */
#include "testing.h"

#include <ductus/ductus.h>

#include <math.h>

static void add_line(duct_drawing *drawing, const char *id, const char *group, const double *points,
                     size_t count)
{
    duct_error error;
    duct_stroke *stroke;
    assert_ok(duct_drawing_add_stroke(drawing, id, count, &stroke, &error));
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    for (size_t i = 0; i < count; i++) {
        x[i] = points[2 * i];
        y[i] = points[2 * i + 1];
    }
    assert_ok(duct_stroke_set_group(stroke, group, &error));
}

/* A plain line and a wave on it, and three lines that meet as a triangle, with a dot above the first. */
static duct_drawing *make_scene(void)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    double plain[2 * 101], wave[2 * 101];
    for (size_t i = 0; i <= 100; i++) {
        plain[2 * i] = wave[2 * i] = 1.5 * (double)i;
        plain[2 * i + 1] = 20;
        wave[2 * i + 1] = 20 + 5 * sin(0.35 * (double)i);
    }
    add_line(drawing, "plain", "A", plain, 101);
    add_line(drawing, "wave", "A'", wave, 101);
    add_line(drawing, "one", "work", (const double[]){20, 180, 140, 180}, 2);
    add_line(drawing, "two", "work", (const double[]){140, 180, 80, 80}, 2);
    add_line(drawing, "three", "work", (const double[]){80, 80, 20, 180}, 2);
    add_line(drawing, "dot", "marks", (const double[]){80, 170}, 1);
    return drawing;
}

/* Runs an operation with pairs of parameter and value, ended by NULL. */
static duct_status run(const char *id, const duct_context *context, const duct_drawing *input,
                       const char *const *pairs, duct_drawing **output, duct_error *error)
{
    const duct_operation *operation;
    duct_settings *settings;
    *error = (duct_error){DUCT_OK, ""};
    duct_status status = duct_operation_find(id, &operation, error);
    status = status == DUCT_OK ? duct_settings_new(context, operation, &settings, error) : status;
    if (status != DUCT_OK) {
        return status;
    }
    for (; *pairs != NULL && status == DUCT_OK; pairs += 2) {
        status = duct_settings_set(settings, pairs[0], pairs[1], error);
    }
    status = status == DUCT_OK ? duct_operation_run(context, settings, input, NULL, output, error) : status;
    duct_settings_free(settings);
    return status;
}

#define RUN(input, output, ...) \
    run("analogy", NULL, input, (const char *const[]){__VA_ARGS__, NULL}, output, &error)

static void same_stroke(const duct_stroke *a, const duct_stroke *b)
{
    assert_int_equal(duct_stroke_size(a), duct_stroke_size(b));
    size_t bytes = duct_stroke_size(a) * sizeof(double);
    assert_memory_equal(duct_stroke_values(a, DUCT_X), duct_stroke_values(b, DUCT_X), bytes);
    assert_memory_equal(duct_stroke_values(a, DUCT_Y), duct_stroke_values(b, DUCT_Y), bytes);
}

static void examples_stay_and_corners_meet(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *scene = make_scene(), *made;
    assert_ok(RUN(scene, &made, "example-from", "plain", "example-to", "wave", "pins", "marks"));
    assert_int_equal(duct_drawing_stroke_count(made), 6);
    same_stroke(duct_drawing_stroke(scene, 0), duct_drawing_stroke(made, 0));
    same_stroke(duct_drawing_stroke(scene, 1), duct_drawing_stroke(made, 1));
    same_stroke(duct_drawing_stroke(scene, 5), duct_drawing_stroke(made, 5));
    double nearest = INFINITY;
    for (size_t s = 2; s < 5; s++) {
        const duct_stroke *line = duct_drawing_stroke(made, s),
                          *next = duct_drawing_stroke(made, s < 4 ? s + 1 : 2);
        const double *x = duct_stroke_values(line, DUCT_X), *y = duct_stroke_values(line, DUCT_Y);
        size_t last = duct_stroke_size(line) - 1;
        assert_true(last > 10);
        assert_true(hypot(x[last] - duct_stroke_values(next, DUCT_X)[0],
                          y[last] - duct_stroke_values(next, DUCT_Y)[0]) < 1e-6);
        for (size_t i = 0; s == 2 && i <= last; i++) {
            nearest = fmin(nearest, hypot(x[i] - 80, y[i] - 170));
        }
    }
    /* The pin: points are thinned by no more than 0.05 pixels. */
    assert_true(nearest < 0.1);
    duct_drawing_free(made);
    duct_drawing_free(scene);
}

static void results_are_the_same_on_any_number_of_threads(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *scene = make_scene(), *first;
    assert_ok(RUN(scene, &first, "style", "work=loops", "seed", "5"));
    for (int threads = 1; threads < 4; threads++) {
        duct_context context = duct_context_default();
        duct_drawing *again;
        context.threads = threads;
        assert_ok(run("analogy", &context, scene,
                      (const char *const[]){"style", "work=loops", "seed", "5", NULL}, &again, &error));
        for (size_t s = 0; s < duct_drawing_stroke_count(first); s++) {
            same_stroke(duct_drawing_stroke(first, s), duct_drawing_stroke(again, s));
        }
        duct_drawing_free(again);
    }
    duct_drawing_free(first);
    duct_drawing_free(scene);
}

static void amount_zero_changes_nothing(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *scene = make_scene(), *made;
    assert_ok(RUN(scene, &made, "style", "sketchy", "amount", "0"));
    assert_int_equal(duct_drawing_stroke_count(made), duct_drawing_stroke_count(scene));
    for (size_t s = 0; s < duct_drawing_stroke_count(scene); s++) {
        same_stroke(duct_drawing_stroke(scene, s), duct_drawing_stroke(made, s));
    }
    duct_drawing_free(made);
    duct_drawing_free(scene);
}

static void a_style_of_several_passes_draws_lines_over(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *scene = make_scene(), *made;
    assert_ok(RUN(scene, &made, "style", "one=sketchy"));
    assert_int_equal(duct_drawing_stroke_count(made), 8);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(made, 4)), "one-3");
    assert_string_equal(duct_stroke_group(duct_drawing_stroke(made, 4)), "work");
    assert_non_null(duct_stroke_values(duct_drawing_stroke(made, 4), DUCT_PRESSURE));
    duct_drawing_free(made);
    duct_drawing_free(scene);
}

static void new_curves_are_added(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *scene = make_scene(), *made;
    assert_ok(run("synthesize-curve", NULL, scene,
                  (const char *const[]){"example", "wave", "count", "2", "length", "300", NULL}, &made,
                  &error));
    assert_int_equal(duct_drawing_stroke_count(made), 8);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(made, 7)), "curve-2");
    duct_drawing_free(made);
    assert_ok(run("synthesize-curve", NULL, scene,
                  (const char *const[]){"example", "wave", "through", "two", "fit", "0", NULL}, &made,
                  &error));
    const duct_stroke *curve = duct_drawing_stroke(made, 6);
    size_t last = duct_stroke_size(curve) - 1;
    const double *x = duct_stroke_values(curve, DUCT_X), *y = duct_stroke_values(curve, DUCT_Y);
    assert_true(hypot(x[0] - 140, y[0] - 180) < 1e-6 && hypot(x[last] - 80, y[last] - 80) < 1e-6);
    duct_drawing_free(made);
    duct_drawing_free(scene);
}

static void bad_input_ends_in_one_sentence(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *scene = make_scene(), *made = NULL;
    const struct {
        const char *param, *value, *other, *other_value, *word;
        duct_status status;
    } bad[] = {
        {"style", "no-such-style", "seed", "0", "no-such-style", DUCT_NOT_FOUND},
        {"style", "nowhere=waves", "seed", "0", "nowhere", DUCT_BAD_SETTING},
        {"style", "work=", "seed", "0", "style", DUCT_NOT_FOUND},
        {"example-from", "plain", "example-to", "", "as many of both", DUCT_BAD_SETTING},
        {"example-from", "plain", "example-to", "dot", "no length", DUCT_UNSUPPORTED},
        {"example-from", "@99", "example-to", "wave", "@99", DUCT_BAD_SETTING},
        {"pins", "#123456", "seed", "0", "#123456", DUCT_BAD_SETTING},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        duct_status status = RUN(scene, &made, bad[i].param, bad[i].value, bad[i].other, bad[i].other_value);
        assert_int_equal(status, bad[i].status);
        assert_non_null(strstr(error.message, bad[i].word));
        assert_null(made);
    }
    duct_stroke_edit(duct_drawing_edit_stroke(scene, 3), DUCT_X)[1] = NAN;
    assert_int_equal(RUN(scene, &made, "style", "waves"), DUCT_BAD_ARGUMENT);
    duct_drawing_free(scene);
}

static void the_nth_allocation_failing_is_survived(void **state)
{
    (void)state;
    duct_drawing *scene = make_scene();
    long calls = 1;
    for (long n = 0; n <= calls; n += n < 60 ? 1 : 13) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        duct_error error;
        duct_drawing *made = NULL;
        context.allocator = &failing.allocator;
        context.threads = 1;
        duct_status status = run("analogy", &context, scene,
                                 (const char *const[]){"example-from", "plain", "example-to", "wave", "pins",
                                                       "dot", "spacing", "4", NULL},
                                 &made, &error);
        if (n == 0) {
            assert_int_equal(status, DUCT_OK);
            calls = failing.calls;
        } else {
            assert_int_equal(status, DUCT_NO_MEMORY);
            assert_null(made);
        }
        duct_drawing_free(made);
        assert_int_equal(failing.held, 0);
    }
    assert_true(calls > 60);
    duct_drawing_free(scene);
}

static void styles_are_listed_for_the_parameter(void **state)
{
    (void)state;
    duct_error error;
    const duct_operation *operation;
    assert_ok(duct_operation_find("analogy", &operation, &error));
    for (size_t i = 0; i < operation->param_count; i++) {
        char **names;
        size_t count;
        assert_ok(duct_param_names(NULL, &operation->params[i], &names, &count, &error));
        assert_true(operation->params[i].type == DUCT_PARAM_STYLE ? count >= 10 : count == 0);
        for (size_t n = 0; n < count; n++) {
            duct_memory_free(NULL, names[n]);
        }
        duct_memory_free(NULL, names);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_stay_and_corners_meet),
        cmocka_unit_test(results_are_the_same_on_any_number_of_threads),
        cmocka_unit_test(amount_zero_changes_nothing),
        cmocka_unit_test(a_style_of_several_passes_draws_lines_over),
        cmocka_unit_test(new_curves_are_added),
        cmocka_unit_test(bad_input_ends_in_one_sentence),
        cmocka_unit_test(the_nth_allocation_failing_is_survived),
        cmocka_unit_test(styles_are_listed_for_the_parameter),
    };
    return cmocka_run_group_tests_name("analogy_operation", tests, NULL, NULL);
}
