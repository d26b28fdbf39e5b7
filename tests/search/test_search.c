/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"
#include "search/search.h"

#include "rows.h"

enum { ROWS = 3001 };

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

static void scan(const float *rows, size_t count, const float *query, scored *all)
{
    for (size_t i = 0; i < count; i++) {
        float square = 0;
        for (size_t d = 0; d < DIMENSIONS; d++) {
            float difference = query[d] - rows[i * DIMENSIONS + d];
            square += difference * difference;
        }
        all[i] = (scored){square, (uint32_t)i};
    }
    qsort(all, count, sizeof *all, by_square);
}

static void finds_what_a_scan_finds(duct_search_kind kind, size_t count)
{
    duct_error error;
    float *rows = make_rows(count, 1), *queries = make_rows(60, 2);
    scored *all = calloc(count, sizeof *all);
    duct_search *search;
    assert_ok(duct_search_new(duct_allocator_of(NULL), kind, rows, count, DIMENSIONS, NULL, &search, &error));
    for (size_t q = 0; q < 60; q++) {
        const float *query = q % 10 == 0 ? rows + (q % count) * DIMENSIONS : queries + q * DIMENSIONS;
        uint32_t near[K], hinted[K], hints[2 * K];
        float distances[K], hinted_distances[K];
        size_t found = duct_search_nearest(search, query, K, NULL, 0, near, distances);
        assert_int_equal(found, count < K ? count : K);
        scan(rows, count, query, all);
        for (size_t n = 0; n < found; n++) {
            assert_int_equal(near[n], all[n].row);
            assert_true(distances[n] == sqrtf(all[n].square));
        }
        /* Hints save time and change nothing, however bad they are. */
        for (size_t n = 0; n < 2 * K; n++) {
            hints[n] = q % 2 == 0 ? near[n % found] : (uint32_t)(97 * n);
        }
        assert_int_equal(duct_search_nearest(search, query, K, hints, 2 * K, hinted, hinted_distances),
                         found);
        assert_memory_equal(hinted, near, found * sizeof *near);
        assert_memory_equal(hinted_distances, distances, found * sizeof *distances);
    }
    duct_search_free(search);
    free(rows);
    free(queries);
    free(all);
}

static void exact_search_finds_what_a_scan_finds(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 7, 8, 9, 19, 20, 64, 65, ROWS};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        finds_what_a_scan_finds(DUCT_SEARCH_EXACT, counts[i]);
    }
}

static void flann_has_full_recall(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 5, 20, 100, ROWS};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        finds_what_a_scan_finds(DUCT_SEARCH_FLANN, counts[i]);
    }
}

/* A single query has nothing to spread: it is compared with all rows. */
static void patchmatch_is_exact_for_one_query(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 5, 20, 100, ROWS};
    for (size_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        finds_what_a_scan_finds(DUCT_SEARCH_PATCHMATCH, counts[i]);
    }
}

static void flann_gives_the_same_each_time(void **state)
{
    (void)state;
    duct_error error;
    float *rows = make_rows(ROWS, 3);
    uint32_t first[K], again[K];
    float distances[K];
    for (int run = 0; run < 3; run++) {
        duct_search *search;
        srand((unsigned)run); /* the host program's generator must not matter */
        assert_ok(duct_search_new(duct_allocator_of(NULL), DUCT_SEARCH_FLANN, rows, ROWS, DIMENSIONS, NULL,
                                  &search, &error));
        duct_search_nearest(search, rows + 500, K, NULL, 0, run == 0 ? first : again, distances);
        duct_search_free(search);
        if (run > 0) {
            assert_memory_equal(first, again, sizeof first);
        }
    }
    free(rows);
}

static void equal_rows_come_in_order(void **state)
{
    (void)state;
    duct_error error;
    float *rows = calloc(100 * DIMENSIONS, sizeof *rows);
    duct_search *search;
    assert_ok(duct_search_new(duct_allocator_of(NULL), DUCT_SEARCH_EXACT, rows, 100, DIMENSIONS, NULL,
                              &search, &error));
    uint32_t near[K], hint = 99;
    float distances[K];
    duct_search_nearest(search, rows, K, &hint, 1, near, distances);
    for (uint32_t n = 0; n < K; n++) {
        assert_int_equal(near[n], n);
    }
    duct_search_free(search);
    free(rows);
}

static void nan_queries_do_no_harm(void **state)
{
    (void)state;
    duct_error error;
    float *rows = make_rows(200, 4), query[DIMENSIONS];
    for (size_t d = 0; d < DIMENSIONS; d++) {
        query[d] = NAN;
    }
    static const duct_search_kind kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_FLANN, DUCT_SEARCH_PATCHMATCH};
    for (size_t i = 0; i < 3; i++) {
        duct_search *search;
        assert_ok(
            duct_search_new(duct_allocator_of(NULL), kinds[i], rows, 200, DIMENSIONS, NULL, &search, &error));
        uint32_t near[K];
        float distances[K];
        size_t found = duct_search_nearest(search, query, K, NULL, 0, near, distances);
        assert_true(found <= K);
        for (size_t n = 0; n < found; n++) {
            assert_true(near[n] < 200);
        }
        duct_search_free(search);
    }
    free(rows);
}

static void no_rows_are_refused(void **state)
{
    (void)state;
    duct_error error;
    float row = 0;
    duct_search *search = NULL;
    assert_int_equal(
        duct_search_new(duct_allocator_of(NULL), DUCT_SEARCH_FLANN, &row, 0, 1, NULL, &search, &error),
        DUCT_UNSUPPORTED);
    assert_null(search);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    static const duct_search_kind kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_PATCHMATCH};
    duct_error error;
    float *rows = make_rows(50, 5);
    for (size_t i = 0; i < 2; i++) {
        duct_status status = DUCT_NO_MEMORY;
        for (long n = 1; status != DUCT_OK; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            duct_search *search;
            status =
                duct_search_new(&failing.allocator, kinds[i], rows, 50, DIMENSIONS, NULL, &search, &error);
            if (status == DUCT_OK) {
                duct_search_free(search);
            } else {
                assert_int_equal(status, DUCT_NO_MEMORY);
            }
            assert_int_equal(failing.held, 0);
            assert_true(n < 50);
        }
    }
    free(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_search_finds_what_a_scan_finds),
        cmocka_unit_test(flann_has_full_recall),
        cmocka_unit_test(patchmatch_is_exact_for_one_query),
        cmocka_unit_test(flann_gives_the_same_each_time),
        cmocka_unit_test(equal_rows_come_in_order),
        cmocka_unit_test(nan_queries_do_no_harm),
        cmocka_unit_test(no_rows_are_refused),
        cmocka_unit_test(survives_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
