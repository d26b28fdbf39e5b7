/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Code that is compiled for wide vectors as well gives the same bytes as without them, and as plain code. */
#include "testing.h"

#include "base/memory.h"
#include "features/velocities.h"
#include "helpinghand/leaves.h"
#include "search/search.h"

#include "rows.h"

#include <ductus/format.h>
#include <ductus/library.h>

#include <stdio.h>

duct_status narrow_search_new(const duct_allocator *allocator, duct_search_kind kind, const float *rows,
                              size_t count, size_t dimensions, const uint32_t *starts, duct_search **search,
                              duct_error *error);
void narrow_search_free(duct_search *search);
duct_status narrow_search_sequence(const duct_search *search, const duct_allocator *allocator,
                                   const duct_search_query *query, uint32_t *rows, float *distances,
                                   size_t *found, duct_error *error);
duct_status narrow_velocity_taps_of_all(const duct_allocator *allocator, const duct_velocity_filter *filter,
                                        const double *x, const double *y, size_t count, double weight,
                                        float *taps, size_t dimensions, duct_error *error);
size_t narrow_leaves_best(const duct_leaves *leaves, const duct_jump_space *space,
                          const duct_sequence_costs *costs, const duct_candidate *before,
                          const duct_candidate *here, double *best);
void narrow_feature_distances(const float *query, const float *rows, size_t dimensions, const uint32_t *which,
                              size_t count, float *distances);

typedef struct {
    float square;
    uint32_t row;
} scored;

static int by_square(const void *a, const void *b)
{
    const scored *x = a, *y = b;
    return x->square != y->square ? (x->square > y->square) - (x->square < y->square)
                                  : (x->row > y->row) - (x->row < y->row);
}

/* Compares both builds with each other, and every tenth query with a scan of all rows. */
static void compare_searches(const float *rows, size_t count, size_t dimensions, const float *queries,
                             size_t asked, size_t k)
{
    duct_error error;
    duct_search *wide, *narrow;
    const duct_allocator *allocator = duct_allocator_of(NULL);
    assert_ok(duct_search_new(allocator, DUCT_SEARCH_EXACT, rows, count, dimensions, NULL, &wide, &error));
    assert_ok(
        narrow_search_new(allocator, DUCT_SEARCH_EXACT, rows, count, dimensions, NULL, &narrow, &error));
    uint32_t *a = calloc(asked * k, sizeof *a), *b = calloc(asked * k, sizeof *b);
    float *x = calloc(asked * k, sizeof *x), *y = calloc(asked * k, sizeof *y);
    size_t *m = calloc(asked, sizeof *m), *n = calloc(asked, sizeof *n);
    scored *all = calloc(count, sizeof *all);
    const duct_search_query query = {queries, asked, k, 0, 0, 0};
    assert_ok(duct_search_sequence(wide, allocator, &query, a, x, m, &error));
    assert_ok(narrow_search_sequence(narrow, allocator, &query, b, y, n, &error));
    assert_memory_equal(m, n, asked * sizeof *m);
    assert_memory_equal(a, b, asked * k * sizeof *a);
    assert_memory_equal(x, y, asked * k * sizeof *x);
    for (size_t q = 0; q < asked; q += 10) {
        for (size_t row = 0; row < count; row++) {
            float square = 0;
            for (size_t d = 0; d < dimensions; d++) {
                float difference = queries[q * dimensions + d] - rows[row * dimensions + d];
                square += difference * difference;
            }
            all[row] = (scored){square, (uint32_t)row};
        }
        qsort(all, count, sizeof *all, by_square);
        assert_int_equal(m[q], k < count ? k : count);
        for (size_t i = 0; i < m[q]; i++) {
            assert_int_equal(a[q * k + i], all[i].row);
            assert_true(x[q * k + i] == sqrtf(all[i].square));
        }
    }
    duct_search_free(wide);
    narrow_search_free(narrow);
    free(a);
    free(b);
    free(x);
    free(y);
    free(m);
    free(n);
    free(all);
}

static void searches_of_random_rows_agree(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 15, 16, 17, 127, 128, 129, 2049, 5000}, ks[] = {1, 20, 100, 200};
    float *rows = make_rows(5000, 11), *queries = make_rows(60, 12);
    for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
        for (size_t i = 0; i < sizeof ks / sizeof *ks; i++) {
            compare_searches(rows, counts[c], DIMENSIONS, queries, 60, ks[i]);
        }
    }
    /* Odd dimensions, rows that are all equal, and rows far away from 0. */
    compare_searches(rows, 5000, 29, queries, 60, 20);
    compare_searches(rows, 20000, 7, queries, 60, 20);
    for (size_t i = 0; i < 5000 * DIMENSIONS; i++) {
        rows[i] += 1e6f;
    }
    for (size_t i = 0; i < 60 * DIMENSIONS; i++) {
        queries[i] += 1e6f;
    }
    compare_searches(rows, 5000, DIMENSIONS, queries, 60, 20);
    for (size_t i = 0; i < 5000 * DIMENSIONS; i++) {
        rows[i] = 3;
    }
    compare_searches(rows, 5000, DIMENSIONS, queries, 60, 20);
    free(rows);
    free(queries);
}

/* A page's features; NULL where there are no recordings. */
static float *read_features(const char *name, size_t *count, bool narrow)
{
    const char *data = getenv("DUCTUS_DATA"), *source = getenv("DUCTUS_SOURCE");
    char path[4096];
    duct_error error;
    duct_drawing *drawing;
    duct_library *library;
    if (data != NULL) {
        snprintf(path, sizeof path, "%s/helpinghand/%s", data, name);
    } else {
        snprintf(path, sizeof path, "%s/../shared/data/helpinghand/%s", source != NULL ? source : ".", name);
    }
    if (duct_drawing_read(NULL, path, NULL, &drawing, &error) != DUCT_OK) {
        return NULL;
    }
    const duct_drawing *list[] = {drawing};
    assert_ok(duct_library_build(NULL, list, 1, NULL, &library, &error));
    duct_drawing *sampled;
    assert_ok(duct_library_drawing(NULL, library, &sampled, &error));
    duct_velocity_filter filter;
    duct_velocity_filter_init(&filter, 40);
    *count = duct_library_sample_count(library);
    float *rows = calloc(*count * DIMENSIONS, sizeof *rows);
    size_t at = 0;
    for (size_t s = 0; s < duct_drawing_stroke_count(sampled); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(sampled, s);
        size_t size = duct_stroke_size(stroke);
        assert_ok((narrow ? narrow_velocity_taps_of_all : duct_velocity_taps_of_all)(
            duct_allocator_of(NULL), &filter, duct_stroke_values(stroke, DUCT_X),
            duct_stroke_values(stroke, DUCT_Y), size, 0.3, rows + at * DIMENSIONS + 2, DIMENSIONS, &error));
        at += size;
    }
    assert_true(at <= *count);
    *count = at;
    duct_drawing_free(sampled);
    duct_drawing_free(drawing);
    duct_library_free(library);
    return rows;
}

static void features_and_searches_of_recordings_agree(void **state)
{
    (void)state;
    size_t count, same, asked;
    float *rows = read_features("SteveEnglish1.cyn", &count, false);
    float *again = read_features("SteveEnglish1.cyn", &same, true);
    float *queries = read_features("BrendaEnglish2.cyn", &asked, false);
    if (rows == NULL || again == NULL || queries == NULL) {
        print_message("skipped: no recordings in $DUCTUS_DATA/helpinghand\n");
        free(rows);
        free(again);
        free(queries);
        skip();
    }
    assert_int_equal(count, same);
    assert_memory_equal(rows, again, count * DIMENSIONS * sizeof *rows);
    compare_searches(rows, count, DIMENSIONS, queries, asked < 600 ? asked : 600, 20);
    free(rows);
    free(again);
    free(queries);
}

static void distances_side_by_side_are_the_distances(void **state)
{
    (void)state;
    float *rows = make_rows(100, 21), *query = make_rows(1, 22), wide[100], narrow[100];
    uint32_t which[100];
    for (uint32_t i = 0; i < 100; i++) {
        which[i] = i * 37 % 100;
    }
    for (size_t dimensions = 1; dimensions <= DIMENSIONS; dimensions++) {
        for (size_t count = 0; count <= 100; count += 7) {
            duct_feature_distances(query, rows, dimensions, which, count, wide);
            narrow_feature_distances(query, rows, dimensions, which, count, narrow);
            for (size_t i = 0; i < count; i++) {
                float expected = duct_feature_distance(query, rows + which[i] * dimensions, dimensions);
                assert_true(wide[i] == expected && narrow[i] == expected);
            }
        }
    }
    free(rows);
    free(query);
}

/* The jump as section 4.2.3 has it: every candidate weighed, the first of equals taken. */
static size_t plain_best(const duct_leaves *leaves, const duct_jump_space *space,
                         const duct_sequence_costs *costs, const duct_candidate *before,
                         const duct_candidate *here, double *best)
{
    size_t chosen = leaves->count;
    for (size_t p = 0; p < leaves->count; p++) {
        if (before[p].stroke == here->stroke && here->sample - before[p].sample <= 2) {
            continue;
        }
        double total =
            leaves->costs[p] + costs->distance * duct_jump_distance(space, before[p].sample, here->sample);
        if (total < *best) {
            *best = total;
            chosen = p;
        }
    }
    return chosen;
}

static void jumps_agree(void **state)
{
    (void)state;
    enum { SAMPLES = 400, MOST = 90 };
    duct_jump_vector poses[SAMPLES], directions[SAMPLES];
    duct_candidate before[MOST];
    const duct_sequence_costs costs = {3, 3, 50, 10, 3, 12, 3};
    duct_leaves leaves;
    assert_true(duct_leaves_make(&leaves, duct_allocator_of(NULL), MOST));
    size_t found = 0;
    for (uint64_t round = 0; round < 6000; round++) {
        bool direction = round % 3 == 0;
        duct_jump_space space = {direction ? directions : poses, direction, round % 3 == 1 ? 0.4 : 0};
        /* Coarse values, so that there are equals. */
        for (size_t i = 0; round % 100 == 0 && i < SAMPLES; i++) {
            for (size_t d = 0; d < DUCT_JUMP_LINEAR; d++) {
                poses[i].linear[d] = floor(8 * duct_random_uniform(round, i, d, 0)) / 8;
            }
            poses[i].twist = floor(9 * duct_random_uniform(round, i, 5, 0) - 4) * M_PI / 4;
            double angle = floor(16 * duct_random_uniform(round, i, 6, 0)) * M_PI / 8;
            directions[i] = (duct_jump_vector){{cos(angle), sin(angle), 0}, 0};
        }
        size_t count = (size_t)(MOST * duct_random_uniform(round, 0, 0, 1)) + 1;
        duct_leaves_clear(&leaves);
        for (size_t p = 0; p < count; p++) {
            uint32_t sample = (uint32_t)(4 * p + round % 4);
            before[p] = (duct_candidate){sample, sample / 50, 0};
            double cost = floor(40 * duct_random_uniform(round, p, 1, 1)) / 4;
            duct_leaves_add(&leaves, &space, sample, p % 17 == 3 ? (double)INFINITY : cost, 0);
        }
        duct_leaves_finish(&leaves, &costs);
        uint32_t at = (uint32_t)(SAMPLES * duct_random_uniform(round, 0, 2, 1));
        const duct_candidate here = {at, at / 50, 0};
        double limit = round % 2 == 0 ? (double)INFINITY : 55 + 10 * duct_random_uniform(round, 0, 3, 1);
        double plain = limit, wide = limit, narrow = limit;
        size_t expected = plain_best(&leaves, &space, &costs, before, &here, &plain);
        assert_int_equal(duct_leaves_best(&leaves, &space, &costs, before, &here, &wide), expected);
        assert_int_equal(narrow_leaves_best(&leaves, &space, &costs, before, &here, &narrow), expected);
        assert_true(wide == plain && narrow == plain);
        found += expected < count;
    }
    assert_true(found > 3000);
    duct_leaves_free(&leaves, duct_allocator_of(NULL));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(searches_of_random_rows_agree),
        cmocka_unit_test(features_and_searches_of_recordings_agree),
        cmocka_unit_test(distances_side_by_side_are_the_distances),
        cmocka_unit_test(jumps_agree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
