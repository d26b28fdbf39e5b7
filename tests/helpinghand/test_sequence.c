/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The dynamic program against brute force over all sequences, with the cost straight from its definition. */
#include "testing.h"

#include "base/memory.h"
#include "helpinghand/sequence.h"

#include <ductus/random.h>

#include <math.h>

enum { MOST_SAMPLES = 7, MOST_CANDIDATES = 5, LIBRARY_STROKES = 4, LIBRARY_SAMPLES = 40 };

typedef struct {
    uint32_t starts[LIBRARY_STROKES + 1];
    duct_jump_vector vectors[LIBRARY_SAMPLES];
    duct_jump_space space;
    duct_sequence_costs costs;
    duct_columns columns;
    size_t column_starts[MOST_SAMPLES + 1];
    duct_candidate items[MOST_SAMPLES * MOST_CANDIDATES];
} problem;

static double uniform(uint64_t seed, uint64_t a, uint64_t b)
{
    return duct_random_uniform(seed, a, b, 99);
}

/* Candidates crowd together, so that consecutive, repeated and skipped samples are common. */
static void make_problem(problem *p, uint64_t seed, size_t shortest, bool direction)
{
    memset(p, 0, sizeof *p);
    static const uint32_t starts[LIBRARY_STROKES + 1] = {0, 9, 12, 30, LIBRARY_SAMPLES};
    memcpy(p->starts, starts, sizeof starts);
    for (size_t i = 0; i < LIBRARY_SAMPLES; i++) {
        double angle = 6.28 * uniform(seed, 1, i);
        duct_jump_vector pose = {{uniform(seed, 2, i), uniform(seed, 3, i), uniform(seed, 4, i)},
                                 angle - 3.1};
        duct_jump_vector velocity = {{cos(angle), sin(angle), 0}, 0};
        p->vectors[i] = direction ? velocity : pose;
    }
    p->space = (duct_jump_space){p->vectors, direction, uniform(seed, 5, 0) < 0.5 ? 0 : 0.7};
    /* Now and then it costs more to stretch than to jump. */
    p->costs = (duct_sequence_costs){.stretch = (seed % 5 == 0 ? 20 : 3) * uniform(seed, 6, 0),
                                     .shrink = 3 * uniform(seed, 6, 1),
                                     .jump = 8 * uniform(seed, 6, 2),
                                     .distance = 4 * uniform(seed, 6, 3),
                                     .brief = 2 * uniform(seed, 6, 4),
                                     .shortest = shortest,
                                     .end = uniform(seed, 6, 5)};
    size_t samples = 1 + (size_t)(MOST_SAMPLES * uniform(seed, 7, 0)), at = 0;
    for (size_t i = 0; i < samples; i++) {
        p->column_starts[i] = at;
        size_t wanted = 1 + (size_t)(MOST_CANDIDATES * uniform(seed, 8, i));
        uint32_t near = (uint32_t)(10 * uniform(seed, 9, 0)) + (uint32_t)i / 2;
        for (uint32_t sample = near; sample < LIBRARY_SAMPLES && at - p->column_starts[i] < wanted;
             sample++) {
            bool last = sample + 1 == LIBRARY_SAMPLES;
            if (uniform(seed, 10 + i, sample) < 0.5 || (last && at == p->column_starts[i])) {
                uint32_t stroke = 0;
                while (p->starts[stroke + 1] <= sample) {
                    stroke++;
                }
                p->items[at++] = (duct_candidate){
                    sample, stroke, (float)((seed % 5 == 0 ? 40 : 4) * uniform(seed, 20 + i, sample))};
            }
        }
    }
    p->column_starts[samples] = at;
    p->columns = (duct_columns){samples, p->column_starts, p->items};
}

static double brute_force(const problem *p, size_t *best)
{
    size_t place[MOST_SAMPLES], chosen[MOST_SAMPLES], count = p->columns.count;
    memset(place, 0, sizeof place);
    double lowest = INFINITY;
    for (;;) {
        for (size_t i = 0; i < count; i++) {
            chosen[i] = p->column_starts[i] + place[i];
        }
        double total =
            duct_sequence_evaluate(&p->columns, p->starts, &p->space, &p->costs, chosen, NULL).total;
        if (total < lowest) {
            lowest = total;
            memcpy(best, chosen, sizeof chosen);
        }
        size_t i = 0;
        while (i < count && ++place[i] == p->column_starts[i + 1] - p->column_starts[i]) {
            place[i++] = 0;
        }
        if (i == count) {
            return lowest;
        }
    }
}

static void agrees_with_brute_force(void **state)
{
    (void)state;
    duct_error error;
    for (uint64_t seed = 0; seed < 6000; seed++) {
        problem p;
        make_problem(&p, seed, 1 + seed % 6, seed % 3 == 0);
        size_t best[MOST_SAMPLES], chosen[MOST_SAMPLES];
        double lowest = brute_force(&p, best);
        assert_ok(duct_sequence_solve(duct_allocator_of(NULL), &p.columns, p.starts, &p.space, &p.costs,
                                      chosen, &error));
        double total = duct_sequence_evaluate(&p.columns, p.starts, &p.space, &p.costs, chosen, NULL).total;
        if (fabs(total - lowest) > 1e-9 * (1 + lowest)) {
            print_error("seed %d: %.12g, brute force %.12g\n", (int)seed, total, lowest);
        }
        assert_true(fabs(total - lowest) <= 1e-9 * (1 + lowest));
    }
}

/* The evaluation itself, on a case reckoned by hand: L_min 3, segments of 2, 1 and 3 samples. */
static void terms_are_those_of_the_paper(void **state)
{
    (void)state;
    static const uint32_t starts[] = {0, 10, 20};
    duct_jump_vector vectors[20];
    memset(vectors, 0, sizeof vectors);
    vectors[4].linear[0] = 3; /* a jump from sample 4 to any other pose costs 3 units */
    duct_candidate items[] = {{3, 0, 1}, {4, 0, 1}, {12, 1, 1}, {15, 1, 1}, {15, 1, 1}, {17, 1, 1}};
    size_t columns_at[] = {0, 1, 2, 3, 4, 5, 6}, chosen[] = {0, 1, 2, 3, 4, 5};
    duct_columns columns = {6, columns_at, items};
    duct_jump_space space = {vectors, false, 0};
    duct_sequence_costs costs = {
        .stretch = 5, .shrink = 7, .jump = 100, .distance = 10, .brief = 2, .shortest = 3, .end = 1};
    duct_sequence_terms terms = duct_sequence_evaluate(&columns, starts, &space, &costs, chosen, NULL);
    assert_true(terms.feature == 6);
    assert_true(terms.transition == (100 + 30) + 100 + 5 + 7);
    assert_true(terms.brief == (2 + 1) * (2 + 1) + (2 + 2) * (2 + 2));
    assert_true(terms.end == 3 + 2);
    assert_true(terms.total == terms.feature + terms.transition + terms.brief + terms.end);
}

static void a_sample_repeats_only_once(void **state)
{
    (void)state;
    duct_candidate five = {5, 0, 0}, six = {6, 0, 0}, other = {6, 1, 0};
    assert_int_equal(duct_transition_of(&five, &five, false), DUCT_TRANSITION_STRETCH);
    assert_int_equal(duct_transition_of(&five, &five, true), DUCT_TRANSITION_JUMP);
    assert_int_equal(duct_transition_of(&five, &six, true), DUCT_TRANSITION_CONSECUTIVE);
    assert_int_equal(duct_transition_of(&five, &other, false), DUCT_TRANSITION_JUMP);
    assert_int_equal(duct_transition_of(&six, &five, false), DUCT_TRANSITION_JUMP);
}

static void twist_is_compared_on_the_circle(void **state)
{
    (void)state;
    duct_jump_vector vectors[] = {{{0, 0, 0}, 3.1}, {{0, 0, 0}, -3.1}};
    duct_jump_space space = {vectors, false, 0.5};
    assert_true(fabs(duct_jump_distance(&space, 0, 1) - (2 * M_PI - 6.2) / 0.5) < 1e-12);
}

/* More columns than one stride: the way back is walked in pieces and must be the same. A library that is one
 * long stroke, with candidates around its diagonal, has an optimum that is known: straight along it. */
static void long_strokes_are_solved_in_pieces(void **state)
{
    (void)state;
    duct_error error;
    enum { COUNT = 3000, WIDE = 3 };
    uint32_t starts[] = {0, COUNT + 10};
    duct_jump_vector *vectors = calloc(COUNT + 10, sizeof *vectors);
    duct_candidate *items = calloc(COUNT * WIDE, sizeof *items);
    size_t *at = calloc(COUNT + 1, sizeof *at), *chosen = calloc(COUNT, sizeof *chosen);
    for (uint32_t i = 0; i < COUNT; i++) {
        for (uint32_t n = 0; n < WIDE; n++) {
            items[i * WIDE + n] = (duct_candidate){i + n, 0, n == 1 ? 0.0f : 0.5f};
        }
        at[i + 1] = (i + 1) * WIDE;
    }
    duct_columns columns = {COUNT, at, items};
    duct_jump_space space = {vectors, false, 0};
    duct_sequence_costs costs = {3, 3, 50, 10, 3, 12, 0};
    assert_ok(duct_sequence_solve(duct_allocator_of(NULL), &columns, starts, &space, &costs, chosen, &error));
    for (size_t i = 0; i < COUNT; i++) {
        assert_int_equal(chosen[i], i * WIDE + 1);
    }
    free(vectors);
    free(items);
    free(at);
    free(chosen);
}

static void ties_go_to_the_lower_stroke_and_sample(void **state)
{
    (void)state;
    duct_error error;
    static const uint32_t starts[] = {0, 5, 10};
    duct_jump_vector vectors[10];
    memset(vectors, 0, sizeof vectors);
    duct_candidate items[] = {{2, 0, 1}, {7, 1, 1}, {3, 0, 1}, {8, 1, 1}};
    size_t at[] = {0, 2, 4}, chosen[2];
    duct_columns columns = {2, at, items};
    duct_jump_space space = {vectors, false, 0};
    duct_sequence_costs costs = {3, 3, 50, 10, 3, 2, 0};
    assert_ok(duct_sequence_solve(duct_allocator_of(NULL), &columns, starts, &space, &costs, chosen, &error));
    assert_int_equal(chosen[0], 0);
    assert_int_equal(chosen[1], 2);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    problem p;
    make_problem(&p, 7, 3, false);
    size_t chosen[MOST_SAMPLES];
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        status =
            duct_sequence_solve(&failing.allocator, &p.columns, p.starts, &p.space, &p.costs, chosen, &error);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 100);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_brute_force),
        cmocka_unit_test(terms_are_those_of_the_paper),
        cmocka_unit_test(a_sample_repeats_only_once),
        cmocka_unit_test(twist_is_compared_on_the_circle),
        cmocka_unit_test(long_strokes_are_solved_in_pieces),
        cmocka_unit_test(ties_go_to_the_lower_stroke_and_sample),
        cmocka_unit_test(survives_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
