/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operation as its users call it: whole drawings, from the table's settings to the result. */
#include "operations/curls.h"

#include "drawing/drawing_private.h"

#include <ductus/ductus.h>

#include <math.h>

static void assert_same_bytes(const duct_drawing *a, const duct_drawing *b)
{
    assert_int_equal(duct_drawing_stroke_count(a), duct_drawing_stroke_count(b));
    for (size_t s = 0; s < duct_drawing_stroke_count(a); s++) {
        const duct_stroke *x = duct_drawing_stroke(a, s), *y = duct_drawing_stroke(b, s);
        assert_int_equal(duct_stroke_size(x), duct_stroke_size(y));
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            const double *u = duct_stroke_values(x, (duct_channel)c),
                         *v = duct_stroke_values(y, (duct_channel)c);
            assert_true((u == NULL) == (v == NULL));
            if (u != NULL) {
                assert_memory_equal(u, v, duct_stroke_size(x) * sizeof *u);
            }
        }
    }
}

static bool any_difference(const duct_drawing *a, const duct_drawing *b, duct_channel channel)
{
    for (size_t s = 0; s < duct_drawing_stroke_count(a); s++) {
        const duct_stroke *x = duct_drawing_stroke(a, s), *y = duct_drawing_stroke(b, s);
        size_t size = duct_stroke_size(x);
        if (size != duct_stroke_size(y) ||
            memcmp(duct_stroke_values(x, channel), duct_stroke_values(y, channel), size * sizeof(double)) !=
                0) {
            return true;
        }
    }
    return false;
}

static void all_channels_come_and_stay_in_range(void **state)
{
    (void)state;
    static const char *const modes[] = {"pose", "trajectory", "one-pass", "two-pass"};
    static const char *const selections[] = {"optimal", "average", "closest"};
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(5, 0, 0, 1);
    for (size_t m = 0; m < 4; m++) {
        for (size_t n = 0; n < 3; n++) {
            duct_drawing *output = run(NULL, hand, input, "mode", modes[m], "select", selections[n], NULL);
            assert_int_equal(duct_drawing_stroke_count(output), 5);
            for (size_t s = 0; s < 5; s++) {
                const duct_stroke *stroke = duct_drawing_stroke(output, s);
                const duct_stroke *old = duct_drawing_stroke(input, s);
                assert_string_equal(duct_stroke_id(stroke), duct_stroke_id(old));
                assert_true(duct_stroke_size(stroke) >= duct_stroke_size(old));
                const double *p = duct_stroke_values(stroke, DUCT_PRESSURE);
                assert_true((p != NULL) == (m != 1));
                for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
                    const double *values = duct_stroke_values(stroke, (duct_channel)c);
                    for (size_t i = 0; values != NULL && i < duct_stroke_size(stroke); i++) {
                        assert_true(isfinite(values[i]));
                        if (c == DUCT_PRESSURE) {
                            assert_true(values[i] >= 0 && values[i] <= 1);
                        }
                        if (c == DUCT_TWIST && i > 0) {
                            assert_true(fabs(values[i] - values[i - 1]) <= M_PI);
                        }
                    }
                }
            }
            duct_drawing_free(output);
        }
    }
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void pose_mode_keeps_every_point(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(3, 0, 0, 1);
    duct_drawing *output = run(NULL, hand, input, "mode", "pose", NULL);
    for (size_t s = 0; s < 3; s++) {
        const duct_stroke *old = duct_drawing_stroke(input, s), *made = duct_drawing_stroke(output, s);
        size_t k = 0;
        for (size_t i = 0; i < duct_stroke_size(made) && k < duct_stroke_size(old); i++) {
            k += duct_stroke_values(made, DUCT_X)[i] == duct_stroke_values(old, DUCT_X)[k] &&
                 duct_stroke_values(made, DUCT_Y)[i] == duct_stroke_values(old, DUCT_Y)[k];
        }
        assert_int_equal(k, duct_stroke_size(old));
    }
    duct_drawing_free(output);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void a_recorded_stroke_keeps_its_samples_in_pose_mode(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(2, 0, 0, 1);
    for (size_t s = 0; s < 2; s++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(input, s);
        double *t = duct_stroke_edit(stroke, DUCT_T);
        for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
            t[i] = 0.007 * (double)i;
        }
    }
    duct_drawing *output = run(NULL, hand, input, "mode", "pose", NULL);
    assert_false(any_difference(input, output, DUCT_X));
    assert_false(any_difference(input, output, DUCT_T));
    assert_non_null(duct_stroke_values(duct_drawing_stroke(output, 0), DUCT_TWIST));
    duct_drawing_free(output);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void recorded_channels_are_kept_unless_asked(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(2, 0, 0, 1);
    for (size_t s = 0; s < 2; s++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(input, s);
        double *p = duct_stroke_edit(stroke, DUCT_PRESSURE), *t = duct_stroke_edit(stroke, DUCT_T);
        for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
            p[i] = 0.9;
            t[i] = 0.007 * (double)i;
        }
    }
    /* In place: pressure is the pen's own, the channels that it lacked are the hand's. */
    duct_drawing *kept = run(NULL, hand, input, "mode", "pose", NULL);
    assert_false(any_difference(input, kept, DUCT_PRESSURE));
    assert_non_null(duct_stroke_values(duct_drawing_stroke(kept, 0), DUCT_TWIST));
    duct_drawing *replaced = run(NULL, hand, input, "mode", "pose", "channels", "all", NULL);
    assert_true(any_difference(input, replaced, DUCT_PRESSURE));
    /* Redrawn: the old pressure belonged to the old line. */
    duct_drawing *redrawn = run(NULL, hand, input, NULL);
    const double *p = duct_stroke_values(duct_drawing_stroke(redrawn, 0), DUCT_PRESSURE);
    assert_true(fabs(p[duct_stroke_size(duct_drawing_stroke(redrawn, 0)) / 2] - 0.9) > 0.05);
    duct_drawing *filled = run(NULL, hand, input, "channels", "missing", NULL);
    p = duct_stroke_values(duct_drawing_stroke(filled, 0), DUCT_PRESSURE);
    for (size_t i = 0; i < duct_stroke_size(duct_drawing_stroke(filled, 0)); i++) {
        assert_true(p[i] == 0.9);
    }
    /* Nothing is missing any more: nothing changes. */
    duct_drawing *again = run(NULL, hand, kept, "mode", "pose", NULL);
    assert_same_bytes(kept, again);
    duct_drawing *all[] = {input, kept, replaced, redrawn, filled, again};
    for (size_t i = 0; i < 6; i++) {
        duct_drawing_free(all[i]);
    }
    duct_library_free(hand);
}

static void amount_zero_is_the_input(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(3, 0, 0, 1);
    duct_drawing *none = run(NULL, hand, input, "amount", "0", NULL);
    assert_same_bytes(input, none);
    duct_drawing *little = run(NULL, hand, input, "amount", "0.001", NULL),
                 *full = run(NULL, hand, input, NULL);
    /* The effect grows with the amount and starts at the input's first point. */
    const duct_stroke *a = duct_drawing_stroke(little, 1), *b = duct_drawing_stroke(full, 1);
    const duct_stroke *old = duct_drawing_stroke(input, 1);
    assert_int_equal(duct_stroke_size(a), duct_stroke_size(b));
    double most = 0, first = fabs(duct_stroke_values(a, DUCT_X)[0] - duct_stroke_values(old, DUCT_X)[0]);
    for (size_t i = 0; i < duct_stroke_size(a); i++) {
        most = fmax(most, fabs(duct_stroke_values(b, DUCT_X)[i] - duct_stroke_values(a, DUCT_X)[i]));
    }
    assert_true(most > 0.5 && first < 0.01);
    duct_drawing_free(none);
    duct_drawing_free(little);
    duct_drawing_free(full);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void threads_do_not_change_a_byte(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(23, 0, 0, 1), *first = NULL;
    static const int threads[] = {1, 2, 7};
    for (size_t i = 0; i < 3; i++) {
        duct_context context = duct_context_default();
        context.threads = threads[i];
        duct_drawing *output = run(&context, hand, input, "variation", "1", "seed", "5", NULL);
        if (first == NULL) {
            first = output;
        } else {
            assert_same_bytes(first, output);
            duct_drawing_free(output);
        }
    }
    duct_drawing_free(first);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void exact_search_and_flann_agree(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(4, 0, 0, 1);
    duct_drawing *exact = run(NULL, hand, input, "search", "exact", NULL);
    duct_drawing *flann = run(NULL, hand, input, "search", "flann", NULL);
    assert_same_bytes(exact, flann);
    duct_drawing_free(exact);
    duct_drawing_free(flann);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void place_and_size_of_a_drawing_do_not_matter(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *here = make_drawing(3, 0, 0, 1), *there = make_drawing(3, 4096, -512, 1);
    duct_drawing *large = make_drawing(3, 0, 0, 8);
    duct_drawing *a = run(NULL, hand, here, NULL), *b = run(NULL, hand, there, NULL),
                 *c = run(NULL, hand, large, NULL);
    for (size_t s = 0; s < 3; s++) {
        const duct_stroke *x = duct_drawing_stroke(a, s), *y = duct_drawing_stroke(b, s),
                          *z = duct_drawing_stroke(c, s);
        assert_int_equal(duct_stroke_size(x), duct_stroke_size(y));
        assert_int_equal(duct_stroke_size(x), duct_stroke_size(z));
        for (size_t i = 0; i < duct_stroke_size(x); i++) {
            double u = duct_stroke_values(x, DUCT_X)[i], v = duct_stroke_values(y, DUCT_X)[i] - 4096;
            double w = duct_stroke_values(z, DUCT_X)[i] / 8;
            assert_true(fabs(u - v) < 1e-6 && fabs(u - w) < 1e-6);
            assert_true(fabs(duct_stroke_values(x, DUCT_PRESSURE)[i] -
                             duct_stroke_values(z, DUCT_PRESSURE)[i]) < 1e-6);
        }
    }
    duct_drawing *all[] = {here, there, large, a, b, c};
    for (size_t i = 0; i < 6; i++) {
        duct_drawing_free(all[i]);
    }
    duct_library_free(hand);
}

static void seeds_vary_and_repeat(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(6, 0, 0, 1);
    duct_drawing *one = run(NULL, hand, input, "variation", "3", "seed", "1", NULL);
    duct_drawing *again = run(NULL, hand, input, "variation", "3", "seed", "1", NULL);
    duct_drawing *two = run(NULL, hand, input, "variation", "3", "seed", "2", NULL);
    assert_same_bytes(one, again);
    assert_true(any_difference(one, two, DUCT_PRESSURE));
    /* The other strokes of a drawing do not matter: the same stroke alone has the same result. */
    duct_drawing *alone;
    duct_error error;
    assert_ok(duct_drawing_new(NULL, &alone, &error));
    assert_ok(duct_drawing_add_copy(alone, duct_drawing_stroke(input, 4), NULL, &error));
    duct_drawing *fixed = run(NULL, hand, input, "variation", "3", "scale", "1", NULL);
    duct_drawing *single = run(NULL, hand, alone, "variation", "3", "scale", "1", NULL);
    const duct_stroke *x = duct_drawing_stroke(fixed, 4), *y = duct_drawing_stroke(single, 0);
    assert_int_equal(duct_stroke_size(x), duct_stroke_size(y));
    assert_memory_equal(duct_stroke_values(x, DUCT_PRESSURE), duct_stroke_values(y, DUCT_PRESSURE),
                        duct_stroke_size(x) * sizeof(double));
    duct_drawing *all[] = {one, again, two, alone, fixed, single, input};
    for (size_t i = 0; i < 7; i++) {
        duct_drawing_free(all[i]);
    }
    duct_library_free(hand);
}

static void a_hand_restyled_by_itself_copies_itself(void **state)
{
    (void)state;
    duct_library *hand = make_hand(true);
    duct_drawing *recording, *bare;
    duct_error error;
    assert_ok(duct_library_drawing(NULL, hand, &recording, &error));
    assert_ok(duct_drawing_copy(NULL, recording, &bare, &error));
    for (size_t s = 0; s < duct_drawing_stroke_count(bare); s++) {
        for (int c = DUCT_T; c < DUCT_CHANNEL_COUNT; c++) {
            duct_stroke_drop(duct_drawing_edit_stroke(bare, s), (duct_channel)c);
        }
    }
    duct_drawing *output = run(NULL, hand, bare, "mode", "pose", "scale", "1", NULL);
    for (size_t s = 0; s < duct_drawing_stroke_count(output); s++) {
        const duct_stroke *old = duct_drawing_stroke(recording, s), *made = duct_drawing_stroke(output, s);
        size_t step = (duct_stroke_size(made) - 1) / (duct_stroke_size(old) - 1);
        for (size_t i = 0; i < duct_stroke_size(old); i++) {
            assert_true(fabs(duct_stroke_values(old, DUCT_PRESSURE)[i] -
                             duct_stroke_values(made, DUCT_PRESSURE)[i * step]) < 0.02);
        }
    }
    duct_drawing_free(output);
    duct_drawing_free(bare);
    duct_drawing_free(recording);
    duct_library_free(hand);
}

static void a_hand_without_pose_can_only_redraw(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(false);
    duct_drawing *input = make_drawing(2, 0, 0, 1), *output = NULL;
    duct_drawing *redrawn = run(NULL, hand, input, "mode", "trajectory", NULL);
    assert_null(duct_stroke_values(duct_drawing_stroke(redrawn, 0), DUCT_PRESSURE));
    duct_settings *settings;
    assert_ok(duct_settings_new(NULL, duct_operation_at(0), &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", hand, &error));
    assert_int_equal(duct_operation_run(NULL, settings, input, NULL, &output, &error), DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "pressure"));
    assert_null(output);
    assert_ok(duct_settings_library(settings, "hand", NULL, &error));
    assert_int_equal(duct_operation_run(NULL, settings, input, NULL, &output, &error), DUCT_BAD_SETTING);
    duct_settings_free(settings);
    duct_drawing_free(redrawn);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void odd_strokes_come_through(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(true);
    duct_drawing *input;
    assert_ok(duct_drawing_new(NULL, &input, &error));
    duct_stroke *stroke;
    assert_ok(duct_drawing_add_stroke(input, "empty", 0, NULL, &error));
    assert_ok(duct_drawing_add_stroke(input, "dot", 1, NULL, &error));
    assert_ok(duct_drawing_add_stroke(input, "still", 9, NULL, &error));
    assert_ok(duct_drawing_add_stroke(input, "two", 2, &stroke, &error));
    duct_stroke_edit(stroke, DUCT_X)[1] = 100;
    assert_ok(duct_drawing_add_stroke(input, "tiny", 2, &stroke, &error));
    duct_stroke_edit(stroke, DUCT_X)[1] = 1e-9;
    assert_ok(duct_drawing_add_stroke(input, "back", 3, &stroke, &error));
    duct_stroke_edit(stroke, DUCT_X)[1] = 80;
    assert_ok(duct_drawing_add_stroke(input, "closed dot", 3, &stroke, &error));
    duct_stroke_set_closed(stroke, true);
    assert_ok(duct_drawing_add_stroke(input, "closed", 3, &stroke, &error));
    duct_stroke_edit(stroke, DUCT_X)[1] = 90;
    duct_stroke_edit(stroke, DUCT_Y)[2] = 90;
    duct_stroke_set_closed(stroke, true);
    static const char *const modes[] = {"pose", "trajectory", "one-pass", "two-pass"};
    for (size_t m = 0; m < 4; m++) {
        duct_drawing *output = run(NULL, hand, input, "mode", modes[m], NULL);
        assert_int_equal(duct_drawing_stroke_count(output), 8);
        assert_int_equal(duct_stroke_size(duct_drawing_stroke(output, 0)), 0);
        assert_int_equal(duct_stroke_size(duct_drawing_stroke(output, 1)), 1);
        assert_true(duct_stroke_size(duct_drawing_stroke(output, 3)) > 10);
        assert_true(duct_stroke_closed(duct_drawing_stroke(output, 7)));
        for (size_t s = 0; s < 8; s++) {
            const duct_stroke *made = duct_drawing_stroke(output, s);
            for (size_t i = 0; i < duct_stroke_size(made); i++) {
                assert_true(isfinite(duct_stroke_values(made, DUCT_X)[i]));
            }
        }
        /* A closed line meets itself: its last sample lies no farther from its first than samples do. */
        const duct_stroke *loop = duct_drawing_stroke(output, 7);
        const double *x = duct_stroke_values(loop, DUCT_X), *y = duct_stroke_values(loop, DUCT_Y);
        size_t last = duct_stroke_size(loop) - 1;
        assert_true(hypot(x[last] - x[0], y[last] - y[0]) < 15);
        duct_drawing_free(output);
    }
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void a_million_samples_are_one_stroke(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(true);
    duct_drawing *input;
    duct_stroke *stroke;
    enum { MANY = 1000000 };
    assert_ok(duct_drawing_new(NULL, &input, &error));
    assert_ok(duct_drawing_add_stroke(input, "long", MANY, &stroke, &error));
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    for (size_t i = 0; i < MANY; i++) {
        x[i] = 1e-3 * (double)i;
        y[i] = 100 * sin(1e-4 * (double)i);
    }
    duct_drawing *output = run(NULL, hand, input, NULL);
    assert_true(duct_stroke_size(duct_drawing_stroke(output, 0)) >= MANY);
    duct_drawing_free(output);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void an_absurd_scale_is_a_limit(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(1, 0, 0, 1e7), *output = NULL;
    duct_settings *settings;
    assert_ok(duct_settings_new(NULL, duct_operation_at(0), &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", hand, &error));
    assert_ok(duct_settings_set(settings, "scale", "0.001", &error));
    assert_int_equal(duct_operation_run(NULL, settings, input, NULL, &output, &error), DUCT_LIMIT);
    assert_null(output);
    duct_settings_free(settings);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static bool stop_soon(void *user, double fraction)
{
    int *calls = user;
    (void)fraction;
    return ++*calls < 2;
}

static void cancelling_gives_nothing(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(4, 0, 0, 1), *output = NULL;
    duct_settings *settings;
    assert_ok(duct_settings_new(NULL, duct_operation_at(0), &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", hand, &error));
    int calls = 0;
    duct_context context = duct_context_default();
    context.progress = stop_soon;
    context.progress_user = &calls;
    assert_int_equal(duct_operation_run(&context, settings, input, NULL, &output, &error), DUCT_CANCELLED);
    assert_null(output);
    duct_settings_free(settings);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    duct_library *hand = make_hand(true);
    duct_drawing *input = make_drawing(2, 0, 0, 1);
    /* Once without failures, so that the library's own caches are filled and every run asks alike. */
    duct_drawing_free(run(NULL, hand, input, NULL));
    duct_settings *settings;
    assert_ok(duct_settings_new(NULL, duct_operation_at(0), &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", hand, &error));
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        context.threads = 1;
        traced trace = {NULL, 0};
        duct_run_options options = {keep_trace, &trace};
        duct_drawing *output = NULL;
        status = duct_operation_run(&context, settings, input, &options, &output, &error);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_true((output != NULL) == (status == DUCT_OK));
        duct_drawing_free(output);
        free(trace.text);
        assert_int_equal(failing.held, 0);
        assert_true(n < 5000);
    }
    duct_settings_free(settings);
    duct_drawing_free(input);
    duct_library_free(hand);
}

static void real_hands_restyle_real_pages(void **state)
{
    (void)state;
    const char *data = shared_data();
    if (data == NULL) {
        skip();
    }
    duct_error error;
    char steve[4200], brenda[4200];
    snprintf(steve, sizeof steve, "%s/helpinghand/SteveEnglish1.cyn", data);
    snprintf(brenda, sizeof brenda, "%s/helpinghand/BrendaEnglish2.cyn", data);
    duct_library *hand;
    duct_drawing *page;
    assert_ok(duct_library_open(NULL, steve, &hand, &error));
    assert_int_equal(duct_library_stroke_count(hand), 138);
    assert_ok(duct_drawing_read(NULL, brenda, NULL, &page, &error));
    duct_drawing *output = run(NULL, hand, page, NULL);
    /* The new page's pressure has the hand's mean and not the page's own, which are far apart. */
    double sums[3] = {0}, counts[3] = {0};
    duct_drawing *recording;
    assert_ok(duct_library_drawing(NULL, hand, &recording, &error));
    const duct_drawing *all[] = {recording, page, output};
    for (size_t d = 0; d < 3; d++) {
        for (size_t s = 0; s < duct_drawing_stroke_count(all[d]); s++) {
            const duct_stroke *stroke = duct_drawing_stroke(all[d], s);
            for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
                sums[d] += duct_stroke_values(stroke, DUCT_PRESSURE)[i];
                counts[d]++;
            }
        }
    }
    double hand_mean = sums[0] / counts[0], page_mean = sums[1] / counts[1], made_mean = sums[2] / counts[2];
    assert_true(fabs(hand_mean - page_mean) > 0.1);
    assert_true(fabs(made_mean - hand_mean) < 0.05);
    duct_drawing_free(recording);
    duct_drawing_free(output);
    duct_drawing_free(page);
    duct_library_free(hand);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_channels_come_and_stay_in_range),
        cmocka_unit_test(pose_mode_keeps_every_point),
        cmocka_unit_test(a_recorded_stroke_keeps_its_samples_in_pose_mode),
        cmocka_unit_test(recorded_channels_are_kept_unless_asked),
        cmocka_unit_test(amount_zero_is_the_input),
        cmocka_unit_test(threads_do_not_change_a_byte),
        cmocka_unit_test(exact_search_and_flann_agree),
        cmocka_unit_test(place_and_size_of_a_drawing_do_not_matter),
        cmocka_unit_test(seeds_vary_and_repeat),
        cmocka_unit_test(a_hand_restyled_by_itself_copies_itself),
        cmocka_unit_test(a_hand_without_pose_can_only_redraw),
        cmocka_unit_test(odd_strokes_come_through),
        cmocka_unit_test(a_million_samples_are_one_stroke),
        cmocka_unit_test(an_absurd_scale_is_a_limit),
        cmocka_unit_test(cancelling_gives_nothing),
        cmocka_unit_test(survives_failing_allocations),
        cmocka_unit_test(real_hands_restyle_real_pages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
