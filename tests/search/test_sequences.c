/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Searching for all samples of a query stroke at once. */
#include "testing.h"

#include "base/memory.h"
#include "library/feature_index.h"
#include "library/library_private.h"
#include "search/search.h"

#include "rows.h"

enum { ROWS = 6000, QUERIES = 120 };

typedef struct {
    uint32_t *rows;
    float *distances;
    size_t *found, count, k;
} answer;

static answer answer_new(size_t count, size_t k)
{
    return (answer){calloc(count * k, sizeof(uint32_t)), calloc(count * k, sizeof(float)),
                    calloc(count, sizeof(size_t)), count, k};
}

static void answer_free(answer *self)
{
    free(self->rows);
    free(self->distances);
    free(self->found);
}

static answer ask(const duct_search *search, const float *queries, size_t count, size_t k, uint64_t seed)
{
    duct_error error;
    answer made = answer_new(count, k);
    const duct_search_query query = {queries, count, k, 0, seed, 77};
    assert_ok(duct_search_sequence(search, duct_allocator_of(NULL), &query, made.rows, made.distances,
                                   made.found, &error));
    return made;
}

static bool same(const answer *a, const answer *b)
{
    return memcmp(a->found, b->found, a->count * sizeof *a->found) == 0 &&
           memcmp(a->rows, b->rows, a->count * a->k * sizeof *a->rows) == 0 &&
           memcmp(a->distances, b->distances, a->count * a->k * sizeof *a->distances) == 0;
}

/* Sample by sample: in order, without repetition, with the distances that every method gives. */
static void check_order(const answer *given, const float *queries, const float *rows, size_t count,
                        size_t dimensions)
{
    for (size_t i = 0; i < given->count; i++) {
        for (size_t n = 0; n < given->found[i]; n++) {
            const uint32_t *row = given->rows + i * given->k + n;
            const float *distance = given->distances + i * given->k + n;
            assert_true(*row < count);
            assert_true(*distance == duct_feature_distance(queries + i * dimensions, rows + *row * dimensions,
                                                           dimensions));
            assert_true(n == 0 || distance[-1] < *distance || (distance[-1] == *distance && row[-1] < *row));
        }
    }
}

/* The share of the true neighbours that were found. */
static double recall_of(const answer *exact, const answer *given)
{
    size_t hits = 0, all = 0;
    for (size_t i = 0; i < exact->count; i++) {
        for (size_t n = 0; n < exact->found[i]; n++, all++) {
            for (size_t m = 0; m < given->found[i]; m++) {
                hits += exact->rows[i * exact->k + n] == given->rows[i * given->k + m];
            }
        }
    }
    return (double)hits / (double)all;
}

typedef struct {
    float *rows, *queries;
    uint32_t starts[ROWS / STROKE + 1];
    duct_search *exact, *flann, *patchmatch;
} fixture;

static void setup(fixture *self)
{
    duct_error error;
    const duct_allocator *allocator = duct_allocator_of(NULL);
    self->rows = make_rows(ROWS, 1);
    self->queries = make_rows(QUERIES, 2);
    for (size_t s = 0; s <= ROWS / STROKE; s++) {
        self->starts[s] = (uint32_t)(s * STROKE);
    }
    assert_ok(duct_search_new(allocator, DUCT_SEARCH_EXACT, self->rows, ROWS, DIMENSIONS, self->starts,
                              &self->exact, &error));
    assert_ok(duct_search_new(allocator, DUCT_SEARCH_FLANN, self->rows, ROWS, DIMENSIONS, self->starts,
                              &self->flann, &error));
    assert_ok(duct_search_new(allocator, DUCT_SEARCH_PATCHMATCH, self->rows, ROWS, DIMENSIONS, self->starts,
                              &self->patchmatch, &error));
}

static void teardown(fixture *self)
{
    duct_search_free(self->exact);
    duct_search_free(self->flann);
    duct_search_free(self->patchmatch);
    free(self->rows);
    free(self->queries);
}

static void exact_and_flann_answer_as_query_by_query(void **state)
{
    (void)state;
    fixture self;
    setup(&self);
    const duct_search *searches[] = {self.exact, self.flann};
    for (size_t s = 0; s < 2; s++) {
        answer all = ask(searches[s], self.queries, QUERIES, K, 0);
        for (size_t i = 0; i < QUERIES; i++) {
            uint32_t rows[K];
            float distances[K];
            assert_int_equal(
                duct_search_nearest(searches[s], self.queries + i * DIMENSIONS, K, NULL, 0, rows, distances),
                all.found[i]);
            assert_memory_equal(rows, all.rows + i * K, sizeof rows);
            assert_memory_equal(distances, all.distances + i * K, sizeof distances);
        }
        answer_free(&all);
    }
    teardown(&self);
}

static void patchmatch_finds_most_neighbours(void **state)
{
    (void)state;
    fixture self;
    setup(&self);
    /* Queries that resemble the library's rows: its own paths, a little off. */
    for (size_t i = 0; i < QUERIES; i++) {
        for (size_t d = 0; d < DIMENSIONS; d++) {
            self.queries[i * DIMENSIONS + d] =
                self.rows[(i + 1000) * DIMENSIONS + d] + (float)(0.1 * duct_random_normal(9, i, d, 0));
        }
    }
    answer exact = ask(self.exact, self.queries, QUERIES, K, 0);
    answer given = ask(self.patchmatch, self.queries, QUERIES, K, 0);
    check_order(&given, self.queries, self.rows, ROWS, DIMENSIONS);
    double recall = recall_of(&exact, &given);
    print_message("recall at %d: %.3f\n", K, recall);
    assert_true(recall > 0.8);
    answer_free(&exact);
    answer_free(&given);
    teardown(&self);
}

static void open_recording(const char *folder, const char *name, duct_library **library)
{
    char path[4300];
    duct_error error;
    snprintf(path, sizeof path, "%s/helpinghand/%s", folder, name);
    assert_ok(duct_library_open(NULL, path, library, &error));
}

/* One writer's strokes among another's, by both kinds of features. */
static void patchmatch_finds_most_neighbours_in_recordings(void **state)
{
    (void)state;
    const char *folder = shared_data();
    if (folder == NULL) {
        skip();
    }
    duct_error error;
    duct_library *library, *other;
    open_recording(folder, "SteveEnglish1.cyn", &library);
    open_recording(folder, "BrendaEnglish2.cyn", &other);
    static const duct_feature_kind kinds[] = {DUCT_FEATURE_VELOCITIES, DUCT_FEATURE_CONTEXTS};
    for (size_t f = 0; f < 2; f++) {
        const duct_feature_options options = {kinds[f], 40, 0.3};
        duct_feature_index exact, patchmatch, queries;
        assert_ok(duct_library_features(library, &options, DUCT_SEARCH_EXACT, &exact, &error));
        assert_ok(duct_library_features(library, &options, DUCT_SEARCH_PATCHMATCH, &patchmatch, &error));
        assert_ok(duct_library_features(other, &options, DUCT_SEARCH_EXACT, &queries, &error));
        double recall = 0;
        size_t strokes = 0;
        for (size_t s = 0; s < other->stroke_count; s += 4, strokes++) {
            const float *rows = queries.rows + other->starts[s] * queries.dimensions;
            size_t count = other->starts[s + 1] - other->starts[s];
            answer truth = ask(exact.search, rows, count, K, 0);
            answer given = ask(patchmatch.search, rows, count, K, s);
            check_order(&given, rows, patchmatch.rows, library->sample_count, patchmatch.dimensions);
            recall += recall_of(&truth, &given);
            answer_free(&truth);
            answer_free(&given);
        }
        print_message("features %d: recall at %d: %.3f\n", (int)kinds[f], K, recall / (double)strokes);
        assert_true(recall / (double)strokes > 0.8);
    }
    duct_library_free(library);
    duct_library_free(other);
}

static void the_seed_alone_decides(void **state)
{
    (void)state;
    fixture self;
    setup(&self);
    answer first = ask(self.patchmatch, self.queries, QUERIES, K, 5);
    srand(99); /* nobody else's generator matters */
    answer again = ask(self.patchmatch, self.queries, QUERIES, K, 5);
    answer other = ask(self.patchmatch, self.queries, QUERIES, K, 6);
    assert_true(same(&first, &again));
    assert_false(same(&first, &other));
    answer_free(&first);
    answer_free(&again);
    answer_free(&other);
    teardown(&self);
}

/* Small libraries are compared whole, and have fewer than k rows to give. */
static void small_libraries_are_searched_whole(void **state)
{
    (void)state;
    static const size_t counts[] = {1, 2, 19, 20, 21, 160, 161};
    duct_error error;
    fixture self;
    setup(&self);
    for (size_t c = 0; c < sizeof counts / sizeof counts[0]; c++) {
        duct_search *small;
        assert_ok(duct_search_new(duct_allocator_of(NULL), DUCT_SEARCH_PATCHMATCH, self.rows, counts[c],
                                  DIMENSIONS, NULL, &small, &error));
        answer given = ask(small, self.queries, QUERIES, K, 0);
        check_order(&given, self.queries, self.rows, counts[c], DIMENSIONS);
        for (size_t i = 0; i < QUERIES; i++) {
            assert_int_equal(given.found[i], counts[c] < K ? counts[c] : K);
        }
        answer_free(&given);
        duct_search_free(small);
    }
    teardown(&self);
}

/* Equal rows, vectors that are no numbers, no queries at all, one query, k = 1. */
static void odd_questions_are_answered(void **state)
{
    (void)state;
    duct_error error;
    fixture self;
    setup(&self);
    answer none = ask(self.patchmatch, self.queries, 0, K, 0);
    answer one = ask(self.patchmatch, self.queries, 1, K, 0);
    assert_int_equal(one.found[0], K);
    answer single = ask(self.patchmatch, self.queries, QUERIES, 1, 0);
    assert_int_equal(single.found[QUERIES - 1], 1);
    for (size_t d = 0; d < 5 * DIMENSIONS; d++) {
        self.queries[d] = d % 2 == 0 ? NAN : INFINITY;
    }
    const duct_search *searches[] = {self.exact, self.flann, self.patchmatch};
    for (size_t s = 0; s < 3; s++) {
        answer odd = ask(searches[s], self.queries, QUERIES, K, 0);
        for (size_t i = 0; i < QUERIES; i++) {
            assert_true(odd.found[i] <= K);
            for (size_t n = 0; n < odd.found[i]; n++) {
                assert_true(odd.rows[i * K + n] < ROWS);
            }
        }
        answer_free(&odd);
    }
    memset(self.rows, 0, ROWS * DIMENSIONS * sizeof *self.rows);
    duct_search *equal;
    assert_ok(duct_search_new(duct_allocator_of(NULL), DUCT_SEARCH_PATCHMATCH, self.rows, ROWS, DIMENSIONS,
                              self.starts, &equal, &error));
    answer alike = ask(equal, self.rows, QUERIES, K, 0);
    check_order(&alike, self.rows, self.rows, ROWS, DIMENSIONS);
    duct_search_free(equal);
    answer_free(&none);
    answer_free(&one);
    answer_free(&single);
    answer_free(&alike);
    teardown(&self);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    fixture self;
    setup(&self);
    const duct_search *searches[] = {self.exact, self.flann, self.patchmatch};
    answer room = answer_new(QUERIES, K);
    const duct_search_query query = {self.queries, QUERIES, K, 0, 0, 0};
    for (size_t s = 0; s < 3; s++) {
        duct_status status = DUCT_NO_MEMORY;
        for (long n = 1; status != DUCT_OK; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            status = duct_search_sequence(searches[s], &failing.allocator, &query, room.rows, room.distances,
                                          room.found, &error);
            assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
            assert_int_equal(failing.held, 0);
            assert_true(n < 20);
        }
    }
    answer_free(&room);
    teardown(&self);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(exact_and_flann_answer_as_query_by_query),
        cmocka_unit_test(patchmatch_finds_most_neighbours),
        cmocka_unit_test(patchmatch_finds_most_neighbours_in_recordings),
        cmocka_unit_test(the_seed_alone_decides),
        cmocka_unit_test(small_libraries_are_searched_whole),
        cmocka_unit_test(odd_questions_are_answered),
        cmocka_unit_test(survives_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
