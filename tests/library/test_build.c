/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What libraries are made with: position removed from pose, sizes, weights. */
#include "testing.h"

#include "base/memory.h"
#include "helpinghand/candidates.h"
#include "library/library_private.h"
#include "library/position.h"
#include "library/weights.h"

#include <ductus/ductus.h>

#include <math.h>
#include <unistd.h>

/* Short waves all over a page of 1000 x 1000. What the pose is made of depends on the test. */
static duct_drawing *make_recording(double (*pose)(duct_channel channel, double x, double y, double wave))
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    duct_drawing_set_page(drawing, 1000, 1000);
    for (size_t s = 0; s < 49; s++) {
        duct_stroke *stroke;
        assert_ok(duct_drawing_add_stroke(drawing, "s", 40, &stroke, &error));
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        for (size_t i = 0; i < 40; i++) {
            x[i] = 20 + 140 * (double)(s % 7) + 2 * (double)i;
            y[i] = 60 + 140 * (double)(s / 7) + 20 * sin(0.3 * (double)i);
        }
        for (int c = DUCT_PRESSURE; pose != NULL && c <= DUCT_TWIST; c++) {
            double *values = duct_stroke_edit(stroke, (duct_channel)c);
            for (size_t i = 0; i < 40; i++) {
                values[i] = pose((duct_channel)c, x[i], y[i], sin(2 * M_PI * (double)i / 39));
            }
        }
    }
    return drawing;
}

static duct_library *build(const duct_drawing *recording, const duct_library_options *options)
{
    duct_error error;
    const duct_drawing *list[] = {recording};
    duct_library *library = NULL;
    assert_ok(duct_library_build(NULL, list, 1, options, &library, &error));
    return library;
}

/* A quadratic of the position in all attributes, and a wave of the stroke's own. Twist lies on the circle's
 * cut. */
static double placed(duct_channel channel, double x, double y, double wave)
{
    double u = x / 1000 - 0.5, v = y / 1000 - 0.5;
    double place = 0.2 * u - 0.3 * v + 0.2 * u * u + 0.1 * u * v - 0.1 * v * v;
    double turn = channel == DUCT_TWIST ? M_PI : 0.5;
    return turn + place + 0.05 * wave;
}

static double spread(const duct_library *library, duct_channel channel)
{
    double low = INFINITY, high = -INFINITY;
    for (size_t i = 0; i < library->sample_count; i++) {
        low = fmin(low, library->channels[channel][i]);
        high = fmax(high, library->channels[channel][i]);
    }
    return high - low;
}

static void position_goes_and_the_strokes_own_pose_stays(void **state)
{
    (void)state;
    duct_drawing *recording = make_recording(placed);
    const duct_library_options options = {.remove_position = true};
    duct_library *plain = build(recording, NULL), *flat = build(recording, &options);
    for (int c = DUCT_PRESSURE; c <= DUCT_TWIST; c++) {
        assert_true(spread(plain, (duct_channel)c) > 0.3);
        /* What is left is the wave of 0.05 up and down. */
        assert_true(spread(flat, (duct_channel)c) < 0.11);
        assert_true(spread(flat, (duct_channel)c) > 0.09);
        assert_true(fabs(remainder(plain->mean[c] - flat->mean[c], 2 * M_PI)) < 1e-3);
    }
    for (int c = DUCT_X; c <= DUCT_Y; c++) {
        assert_memory_equal(plain->channels[c], flat->channels[c], plain->sample_count * sizeof(double));
    }
    duct_library_free(plain);
    duct_library_free(flat);
    duct_drawing_free(recording);
}

static double steep(duct_channel channel, double x, double y, double wave)
{
    (void)y;
    return channel == DUCT_PRESSURE ? fmax(0, fmin(1, x / 1000 + 0.5 * wave)) : 0.25;
}

static void pressure_stays_in_its_range_and_constants_stay(void **state)
{
    (void)state;
    duct_drawing *recording = make_recording(steep);
    const duct_library_options options = {.remove_position = true};
    duct_library *flat = build(recording, &options);
    for (size_t i = 0; i < flat->sample_count; i++) {
        double pressure = flat->channels[DUCT_PRESSURE][i];
        assert_true(pressure >= 0 && pressure <= 1);
        assert_true(fabs(flat->channels[DUCT_TILT_X][i] - 0.25) < 1e-9);
        assert_true(fabs(flat->channels[DUCT_TWIST][i] - 0.25) < 1e-9);
    }
    duct_library_free(flat);
    duct_drawing_free(recording);
}

/* All on one line, or at one place: the polynomial is not determined, and nothing may blow up. */
static void degenerate_positions_are_harmless(void **state)
{
    (void)state;
    double x[] = {1, 2, 3, 4, 5, 6, 7, 8}, y[8] = {0}, p[] = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8},
           same[8];
    duct_samples line = {
        .count = 8, .step = 1, .channels = {[DUCT_X] = x, [DUCT_Y] = y, [DUCT_PRESSURE] = p}};
    duct_position_remove(&line, 1);
    for (size_t i = 0; i < 8; i++) {
        assert_true(fabs(p[i] - 0.45) < 1e-9);
        same[i] = 3;
        p[i] = 0.1 * (double)i;
    }
    duct_samples point = {
        .count = 8, .step = 1, .channels = {[DUCT_X] = same, [DUCT_Y] = same, [DUCT_PRESSURE] = p}};
    duct_position_remove(&point, 1);
    for (size_t i = 0; i < 8; i++) {
        assert_true(fabs(p[i] - 0.1 * (double)i) < 1e-9);
    }
    duct_position_remove(NULL, 0);
}

static void sizes_enrich_the_library(void **state)
{
    (void)state;
    duct_drawing *recording = make_recording(placed);
    const double scales[] = {0.5, 1, 1.5};
    const duct_library_options options = {.scales = scales, .scale_count = 3};
    duct_library *plain = build(recording, NULL), *rich = build(recording, &options);
    size_t strokes = plain->stroke_count;
    assert_int_equal(rich->stroke_count, 3 * strokes);
    assert_true(rich->unit == plain->unit);
    for (size_t k = 0; k < 3; k++) {
        for (size_t s = 0; s < strokes; s++) {
            double before = (double)duct_library_stroke_samples(plain, s) - 1;
            double after = (double)duct_library_stroke_samples(rich, k * strokes + s) - 1;
            assert_true(fabs(after - scales[k] * before) <= 1);
        }
    }
    assert_int_equal(rich->starts[2 * strokes] - rich->starts[strokes], plain->sample_count);
    assert_memory_equal(rich->channels[DUCT_X] + rich->starts[strokes], plain->channels[DUCT_X],
                        plain->sample_count * sizeof(double));
    assert_true(rich->fingerprint != plain->fingerprint);
    assert_true(rich->width == 1500);
    /* The last sample of the first stroke in the largest size lies 1.5 times as far out. */
    double end = rich->channels[DUCT_X][rich->starts[2 * strokes + 1] - 1] * rich->unit;
    assert_true(fabs(end - 1.5 * 98) < 1e-6);
    duct_library_free(plain);
    duct_library_free(rich);
    duct_drawing_free(recording);
}

static void weights_and_sizes_are_kept_in_the_file(void **state)
{
    (void)state;
    duct_error error;
    char folder[] = "/tmp/ductus-build-XXXXXX", path[64], index[80];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/lib.inkml", folder);
    snprintf(index, sizeof index, "%s.index", path);
    duct_drawing *recording = make_recording(placed);
    const duct_drawing *list[] = {recording, recording};
    const double weights[] = {2, 0.5}, scales[] = {1, 2};
    const duct_library_options options = {
        .name = "both", .weights = weights, .scales = scales, .scale_count = 2};
    duct_library *library, *again;
    assert_ok(duct_library_build(NULL, list, 2, &options, &library, &error));
    assert_ok(duct_library_save(NULL, library, path, &error));
    assert_ok(duct_library_open(NULL, path, &again, &error));
    assert_int_equal(again->stroke_count, library->stroke_count);
    assert_int_equal(again->sample_count, library->sample_count);
    for (size_t s = 0; s < library->stroke_count; s++) {
        assert_true(duct_library_weight(library, s) == (s / 49 % 2 == 0 ? 2 : 0.5));
        assert_true(duct_library_weight(again, s) == duct_library_weight(library, s));
    }
    assert_true(duct_library_weight(again, again->stroke_count) == 0);
    duct_library_free(library);
    /* Without weights nothing about them is written, and all are 1. */
    library = build(recording, NULL);
    assert_true(duct_library_weight(library, 0) == 1);
    assert_null(library->weights);
    duct_library_free(library);
    duct_library_free(again);
    duct_drawing_free(recording);
    unlink(path);
    unlink(index);
    assert_int_equal(rmdir(folder), 0);
}

static void stated_weights_that_do_not_fit_are_ignored(void **state)
{
    (void)state;
    duct_error error;
    static const char *const texts[] = {"2*48",     "2*50",        "2*49 ",  "",       "x",        "2",
                                        "2*0 1*49", "-1*49",       "0*49",   "nan*49", "1e9*49",   "2*49 1",
                                        "2*1e300",  "2*24.5 1*25", "2 * 49", "2*-3",   "2*48 1*-1"};
    duct_drawing *recording = make_recording(NULL);
    double weights[49];
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        assert_ok(duct_drawing_annotate(recording, "ductus-weights", texts[i], &error));
        bool any = duct_weights_read(recording, weights);
        for (size_t s = 0; s < 49; s++) {
            assert_true(weights[s] == 1 || (any && strcmp(texts[i], "2*49 ") == 0));
        }
    }
    assert_ok(duct_drawing_annotate(recording, "ductus-weights", "2*40 0.25*9", &error));
    assert_true(duct_weights_read(recording, weights));
    assert_true(weights[39] == 2 && weights[40] == 0.25 && weights[48] == 0.25);
    duct_drawing_free(recording);
}

static void a_heavier_recording_is_nearer_in_matching(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *recording = make_recording(placed);
    const duct_drawing *list[] = {recording, recording};
    const double weights[] = {1, 4};
    const duct_library_options options = {.weights = weights};
    duct_library *library;
    assert_ok(duct_library_build(NULL, list, 2, &options, &library, &error));
    /* All of them: among the nearest few there are only samples of the heavy one. */
    duct_candidate_options wanted = {.features = duct_feature_options_default(),
                                     .neighbours = library->sample_count};
    duct_feature_index index;
    assert_ok(duct_library_features(library, &wanted.features, DUCT_SEARCH_EXACT, &index, &error));
    double x[50], y[50];
    for (size_t i = 0; i < 50; i++) {
        x[i] = 0.9 * (double)i;
        y[i] = 0.002 * (double)(i * i);
    }
    duct_columns columns;
    assert_ok(
        duct_candidates_find(duct_allocator_of(NULL), library, &index, &wanted, x, y, 50, &columns, &error));
    size_t compared = 0, own = library->sample_count / 2;
    for (size_t c = 0; c < columns.count; c++) {
        for (size_t a = columns.starts[c]; a < columns.starts[c] + 20; a++) {
            for (size_t b = columns.starts[c]; b < columns.starts[c + 1]; b++) {
                if (columns.items[b].sample == columns.items[a].sample + own) {
                    /* The same sample of the same recording, once with weight 1, once with 4. */
                    assert_true(fabs((double)columns.items[a].distance / (double)columns.items[b].distance -
                                     4) < 1e-3);
                    compared++;
                }
            }
        }
    }
    assert_true(compared > 0);
    duct_columns_free(duct_allocator_of(NULL), &columns);
    duct_library_free(library);
    duct_drawing_free(recording);
}

static void options_out_of_range_are_refused(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *recording = make_recording(placed);
    const duct_drawing *list[] = {recording};
    static const double bad[] = {0, -1, NAN, INFINITY, 1e6, 1e-9};
    double many[20];
    duct_library *library = NULL;
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const duct_library_options scales = {.scales = &bad[i], .scale_count = 1},
                                   weights = {.weights = &bad[i]};
        assert_int_equal(duct_library_build(NULL, list, 1, &scales, &library, &error), DUCT_BAD_ARGUMENT);
        assert_int_equal(duct_library_build(NULL, list, 1, &weights, &library, &error), DUCT_BAD_ARGUMENT);
    }
    for (size_t i = 0; i < 20; i++) {
        many[i] = 1;
    }
    const duct_library_options options = {.scales = many, .scale_count = 20};
    assert_int_equal(duct_library_build(NULL, list, 1, &options, &library, &error), DUCT_BAD_ARGUMENT);
    assert_null(library);
    duct_drawing_free(recording);
}

static void every_failing_allocation_is_reported_and_leaves_nothing(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *recording = make_recording(placed);
    const duct_drawing *list[] = {recording, recording};
    const double weights[] = {2, 1}, scales[] = {0.5, 1};
    const duct_library_options options = {
        .weights = weights, .scales = scales, .scale_count = 2, .remove_position = true};
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_library *library = NULL;
        duct_drawing *drawing = NULL;
        status = duct_library_build(&context, list, 2, &options, &library, &error);
        if (status == DUCT_OK) {
            status = duct_library_drawing(&context, library, &drawing, &error);
        }
        duct_drawing_free(drawing);
        duct_library_free(library);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 10000);
    }
    duct_drawing_free(recording);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(position_goes_and_the_strokes_own_pose_stays),
        cmocka_unit_test(pressure_stays_in_its_range_and_constants_stay),
        cmocka_unit_test(degenerate_positions_are_harmless),
        cmocka_unit_test(sizes_enrich_the_library),
        cmocka_unit_test(weights_and_sizes_are_kept_in_the_file),
        cmocka_unit_test(stated_weights_that_do_not_fit_are_ignored),
        cmocka_unit_test(a_heavier_recording_is_nearer_in_matching),
        cmocka_unit_test(options_out_of_range_are_refused),
        cmocka_unit_test(every_failing_allocation_is_reported_and_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
