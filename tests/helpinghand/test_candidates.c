/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The candidates of a whole query stroke, by every method of searching. */
#include "testing.h"

#include "base/memory.h"
#include "helpinghand/candidates.h"
#include "library/library_private.h"

#include <ductus/ductus.h>

#include <math.h>

enum { STROKES = 30, SAMPLES = 80, K = 8 };

static void wave(size_t count, double phase, double *x, double *y)
{
    x[0] = y[0] = 0;
    for (size_t i = 1; i < count; i++) {
        double angle = 1.5 * sin(0.06 * (double)i + phase) + 0.3 * phase;
        x[i] = x[i - 1] + cos(angle);
        y[i] = y[i - 1] + sin(angle);
    }
}

/* Waves in three recordings that weigh differently. */
static duct_library *make_weighted_library(void)
{
    duct_error error;
    duct_drawing *recordings[3];
    for (size_t r = 0; r < 3; r++) {
        assert_ok(duct_drawing_new(NULL, &recordings[r], &error));
        for (size_t s = 0; s < STROKES / 3; s++) {
            duct_stroke *stroke;
            assert_ok(duct_drawing_add_stroke(recordings[r], "", SAMPLES, &stroke, &error));
            wave(SAMPLES, 0.2 * (double)(3 * s + r), duct_stroke_edit(stroke, DUCT_X),
                 duct_stroke_edit(stroke, DUCT_Y));
        }
    }
    const double weights[] = {1, 20, 0.05};
    const duct_library_options options = {.unit = 1, .name = "waves", .weights = weights};
    duct_library *library;
    assert_ok(
        duct_library_build(NULL, (const duct_drawing *const *)recordings, 3, &options, &library, &error));
    for (size_t r = 0; r < 3; r++) {
        duct_drawing_free(recordings[r]);
    }
    return library;
}

static duct_library *make_library(void)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    for (size_t s = 0; s < STROKES; s++) {
        duct_stroke *stroke;
        assert_ok(duct_drawing_add_stroke(drawing, "", SAMPLES, &stroke, &error));
        wave(SAMPLES, 0.2 * (double)s, duct_stroke_edit(stroke, DUCT_X), duct_stroke_edit(stroke, DUCT_Y));
    }
    duct_library *library;
    const duct_library_options options = {.unit = 1, .name = "waves"};
    const duct_drawing *recordings[] = {drawing};
    assert_ok(duct_library_build(NULL, recordings, 1, &options, &library, &error));
    duct_drawing_free(drawing);
    return library;
}

static duct_candidate_options options_of(bool coherent)
{
    return (duct_candidate_options){
        .features = duct_feature_options_default(), .neighbours = K, .coherent = coherent, .seed = 1};
}

/* Longer than the piece that is searched at once: no column may differ from what its sample alone would get.
 */
static void columns_of_a_long_stroke_hold_the_nearest(void **state)
{
    (void)state;
    enum { LONG = 10000 };
    static const duct_search_kind kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_FLANN};
    duct_error error;
    duct_library *library = make_library();
    double *x = calloc(LONG, sizeof *x), *y = calloc(LONG, sizeof *y);
    wave(LONG, 0.5, x, y);
    duct_candidate_options options = options_of(false);
    for (size_t k = 0; k < 2; k++) {
        duct_feature_index index;
        assert_ok(duct_library_features(library, &options.features, kinds[k], &index, &error));
        float *rows = calloc(LONG * index.dimensions, sizeof *rows);
        assert_ok(
            duct_features_compute(duct_allocator_of(NULL), &options.features, x, y, LONG, rows, &error));
        duct_columns columns;
        assert_ok(duct_candidates_find(duct_allocator_of(NULL), library, &index, &options, x, y, LONG,
                                       &columns, &error));
        for (size_t i = 0; i < LONG; i++) {
            uint32_t near[K];
            float distances[K];
            assert_int_equal(
                duct_search_nearest(index.search, rows + i * index.dimensions, K, NULL, 0, near, distances),
                K);
            assert_int_equal(columns.starts[i + 1] - columns.starts[i], K);
            for (size_t n = 0; n < K; n++) {
                const duct_candidate *candidate = NULL;
                for (size_t c = columns.starts[i]; c < columns.starts[i + 1]; c++) {
                    candidate = columns.items[c].sample == near[n] ? &columns.items[c] : candidate;
                }
                assert_non_null(candidate);
                assert_true(candidate->distance == distances[n]);
                assert_int_equal(candidate->stroke, near[n] / (library->sample_count / STROKES));
            }
        }
        duct_columns_free(duct_allocator_of(NULL), &columns);
        free(rows);
    }
    free(x);
    free(y);
    duct_library_free(library);
}

/* How many of the library's samples are nearer by weighted distance, or as near and before it. */
static size_t rank_of(const duct_library *library, const duct_feature_index *index, const float *row,
                      const duct_candidate *candidate)
{
    size_t rank = 0;
    for (uint32_t i = 0; i < library->sample_count; i++) {
        double weight = library->weights[duct_library_stroke_of(library, i)];
        float distance = duct_feature_distance(row, index->rows + i * index->dimensions, index->dimensions);
        float weighted = (float)((double)distance / weight);
        rank += weighted < candidate->distance || (weighted == candidate->distance && i < candidate->sample);
    }
    return rank;
}

/* Not the weighted order of those that are nearest without weights. */
static void weights_find_what_is_nearest_by_them(void **state)
{
    (void)state;
    static const duct_search_kind kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_FLANN};
    duct_error error;
    duct_library *library = make_weighted_library();
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 0.5, x, y);
    for (size_t round = 0; round < 4; round++) {
        duct_candidate_options options = options_of(round >= 2);
        duct_feature_index index;
        duct_columns columns;
        assert_ok(duct_library_features(library, &options.features, kinds[round % 2], &index, &error));
        float *rows = calloc(SAMPLES * index.dimensions, sizeof *rows);
        assert_ok(
            duct_features_compute(duct_allocator_of(NULL), &options.features, x, y, SAMPLES, rows, &error));
        assert_ok(duct_candidates_find(duct_allocator_of(NULL), library, &index, &options, x, y, SAMPLES,
                                       &columns, &error));
        size_t unweighted = 0;
        for (size_t i = 0; i < SAMPLES; i++) {
            const float *row = rows + i * index.dimensions;
            uint32_t near[K];
            float distances[K];
            size_t best = 0;
            duct_search_nearest(index.search, row, K, NULL, 0, near, distances);
            for (size_t c = columns.starts[i]; c < columns.starts[i + 1]; c++) {
                best += rank_of(library, &index, row, &columns.items[c]) < K;
            }
            assert_int_equal(best, K);
            for (size_t n = 0; n < K; n++) {
                for (size_t c = columns.starts[i]; c < columns.starts[i + 1]; c++) {
                    unweighted += columns.items[c].sample == near[n];
                }
            }
        }
        /* Else the weights would have changed nothing here. */
        assert_true(options.coherent || unweighted < (SAMPLES * K) / 2);
        duct_columns_free(duct_allocator_of(NULL), &columns);
        free(rows);
    }
    duct_library_free(library);
}

/* Ascending and without repetition; with coherence, what follows the column before is there as well. */
static void every_method_gives_ordered_columns(void **state)
{
    (void)state;
    static const duct_search_kind kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_FLANN, DUCT_SEARCH_PATCHMATCH};
    duct_error error;
    duct_library *library = make_library();
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 0.5, x, y);
    for (size_t k = 0; k < 6; k++) {
        duct_candidate_options options = options_of(k >= 3);
        duct_feature_index index;
        duct_columns columns;
        assert_ok(duct_library_features(library, &options.features, kinds[k % 3], &index, &error));
        assert_ok(duct_candidates_find(duct_allocator_of(NULL), library, &index, &options, x, y, SAMPLES,
                                       &columns, &error));
        for (size_t i = 0; i < SAMPLES; i++) {
            size_t width = columns.starts[i + 1] - columns.starts[i];
            assert_true(k >= 3 ? width >= K && width <= 8 * K : width == K);
            for (size_t c = columns.starts[i] + 1; c < columns.starts[i + 1]; c++) {
                assert_true(columns.items[c - 1].sample < columns.items[c].sample);
            }
        }
        duct_columns_free(duct_allocator_of(NULL), &columns);
    }
    duct_library_free(library);
}

static duct_drawing *make_queries(void)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    for (size_t s = 0; s < 12; s++) {
        char id[16];
        duct_stroke *stroke;
        snprintf(id, sizeof id, "q%zu", s);
        assert_ok(duct_drawing_add_stroke(drawing, id, SAMPLES, &stroke, &error));
        wave(SAMPLES, 0.37 * (double)s, duct_stroke_edit(stroke, DUCT_X), duct_stroke_edit(stroke, DUCT_Y));
    }
    return drawing;
}

/* A drawing restyled with the settings given; its text is freed by duct_memory_free(). */
static char *restyled(const duct_library *library, const duct_drawing *drawing, int threads,
                      const char *search, const char *features, const char *seed)
{
    duct_error error;
    const duct_operation *operation;
    duct_settings *settings;
    duct_drawing *made;
    duct_context context = duct_context_default();
    context.threads = threads;
    assert_ok(duct_operation_find("restyle", &operation, &error));
    assert_ok(duct_settings_new(&context, operation, &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", library, &error));
    assert_ok(duct_settings_set(settings, "mode", "trajectory", &error));
    /* Small differences of distances show in the closest neighbour; one sequence may fit best by far. */
    assert_ok(duct_settings_set(settings, "select", "closest", &error));
    assert_ok(duct_settings_set(settings, "search", search, &error));
    assert_ok(duct_settings_set(settings, "features", features, &error));
    assert_ok(duct_settings_set(settings, "seed", seed, &error));
    assert_ok(duct_operation_run(&context, settings, drawing, NULL, &made, &error));
    char *text;
    size_t size;
    assert_ok(duct_drawing_write_memory(NULL, made, "inkml", NULL, &text, &size, &error));
    duct_drawing_free(made);
    duct_settings_free(settings);
    return text;
}

static void results_do_not_depend_on_threads(void **state)
{
    (void)state;
    static const char *const features[] = {"velocities", "contexts"};
    duct_library *library = make_library();
    duct_drawing *drawing = make_queries();
    for (size_t f = 0; f < 2; f++) {
        char *alone = restyled(library, drawing, 1, "patchmatch", features[f], "1");
        char *together = restyled(library, drawing, 4, "patchmatch", features[f], "1");
        assert_int_equal(strcmp(alone, together), 0);
        duct_memory_free(NULL, alone);
        duct_memory_free(NULL, together);
    }
    char *velocities = restyled(library, drawing, 1, "exact", "velocities", "1");
    char *contexts = restyled(library, drawing, 1, "exact", "contexts", "1");
    assert_int_not_equal(strcmp(velocities, contexts), 0);
    duct_memory_free(NULL, velocities);
    duct_memory_free(NULL, contexts);
    duct_drawing_free(drawing);
    duct_library_free(library);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library();
    double x[SAMPLES], y[SAMPLES];
    wave(SAMPLES, 0.5, x, y);
    duct_candidate_options options = options_of(true);
    static const duct_search_kind kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_PATCHMATCH};
    for (size_t k = 0; k < 2; k++) {
        duct_feature_index index;
        assert_ok(duct_library_features(library, &options.features, kinds[k], &index, &error));
        duct_status status = DUCT_NO_MEMORY;
        for (long n = 1; status != DUCT_OK; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            duct_columns columns;
            status = duct_candidates_find(&failing.allocator, library, &index, &options, x, y, SAMPLES,
                                          &columns, &error);
            if (status == DUCT_OK) {
                duct_columns_free(&failing.allocator, &columns);
            } else {
                assert_int_equal(status, DUCT_NO_MEMORY);
            }
            assert_int_equal(failing.held, 0);
            assert_true(n < 100);
        }
    }
    duct_library_free(library);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_of_a_long_stroke_hold_the_nearest),
        cmocka_unit_test(weights_find_what_is_nearest_by_them),
        cmocka_unit_test(every_method_gives_ordered_columns),
        cmocka_unit_test(results_do_not_depend_on_threads),
        cmocka_unit_test(survives_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
