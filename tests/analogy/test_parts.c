/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The closed forms against direct numerical minimisation, and the parts of curve analogies one by one. */
#include "curves.h"

#include "analogy/constraints.h"
#include "analogy/correspondence.h"
#include "analogy/cost.h"
#include "analogy/multiresolution.h"
#include "analogy/pyramid.h"

#include <ductus/random.h>

enum { REACH = 12 };

/* cmocka's own compares floats. */
#define assert_near(a, b, within) assert_true(fabs((a) - (b)) <= (within))

typedef struct {
    duct_neighbourhood samples;
    double block[DUCT_NEIGHBOURHOOD_ROOM(REACH)];
} patch;

/* Samples at random, `low` .. `high` of them there. */
static void random_patch(patch *made, unsigned seed, int low, int high)
{
    duct_neighbourhood *samples = &made->samples;
    duct_neighbourhood_lay(samples, made->block, REACH, false);
    samples->low = low;
    samples->high = high;
    samples->centre[0] = 10 * duct_random_normal(seed, 1, 0, 0);
    samples->centre[1] = 10 * duct_random_normal(seed, 2, 0, 0);
    for (int k = low; k <= high; k++) {
        int i = k + REACH;
        samples->x[i] = k == 0 ? 0 : k + duct_random_normal(seed, 3, (uint64_t)i, 0);
        samples->y[i] = k == 0 ? 0 : duct_random_normal(seed, 4, (uint64_t)i, 0);
        double angle = 6 * duct_random_uniform(seed, 5, (uint64_t)i, 0);
        samples->u[i] = k == low ? 0 : cos(angle);
        samples->v[i] = k == low ? 0 : sin(angle);
    }
}

/* The distance of two patches as the paper writes it, for one rotation and translation. */
static double direct(const patch *a, const patch *b, const double *weights, double tangent, double angle,
                     double tx, double ty)
{
    const duct_neighbourhood *p = &a->samples, *q = &b->samples;
    int low = p->low > q->low ? p->low : q->low, high = p->high < q->high ? p->high : q->high;
    double sum = 0, c = cos(angle), s = sin(angle);
    for (int k = low; k <= high; k++) {
        int i = k + REACH;
        double dx = c * p->x[i] - s * p->y[i] + tx - q->x[i], dy = s * p->x[i] + c * p->y[i] + ty - q->y[i];
        sum += weights[i] * (dx * dx + dy * dy);
        if (k > low) {
            double du = c * p->u[i] - s * p->v[i] - q->u[i], dv = s * p->u[i] + c * p->v[i] - q->v[i];
            sum += weights[i] * tangent * (du * du + dv * dv);
        }
    }
    return sum;
}

/* Coordinate descent with shrinking steps from the best of many angles: knows nothing of the closed form. */
static double minimise(const patch *a, const patch *b, const double *weights, double tangent, bool turn)
{
    double best = INFINITY, at[3] = {0, 0, 0};
    for (int start = 0; start < (turn ? 24 : 1); start++) {
        double now[3] = {start * M_PI / 12, 0, 0}, step[3] = {0.2, 1, 1};
        double cost = direct(a, b, weights, tangent, now[0], now[1], now[2]);
        for (int round = 0; round < 4000 && step[1] > 1e-9; round++) {
            bool moved = false;
            for (int d = turn ? 0 : 1; d < 3; d++) {
                for (int way = -1; way <= 1; way += 2) {
                    now[d] += way * step[d];
                    double other = direct(a, b, weights, tangent, now[0], now[1], now[2]);
                    if (other < cost) {
                        cost = other;
                        moved = true;
                    } else {
                        now[d] -= way * step[d];
                    }
                }
            }
            for (int d = 0; d < 3 && !moved; d++) {
                step[d] *= 0.5;
            }
        }
        if (cost < best) {
            best = cost;
            memcpy(at, now, sizeof at);
        }
    }
    return best;
}

static void alignment_is_the_minimum_over_rotations_and_translations(void **state)
{
    (void)state;
    double weights[2 * REACH + 1];
    duct_neighbourhood_weights(25, REACH, weights);
    for (unsigned seed = 0; seed < 12; seed++) {
        patch a, b;
        int low = seed % 3 == 1 ? -4 : -REACH, high = seed % 3 == 2 ? 5 : REACH;
        random_patch(&a, seed, -REACH, REACH);
        random_patch(&b, 100 + seed, low, high);
        for (double tangent = 0; tangent <= 100; tangent += 50) {
            duct_alignment sums;
            duct_align(&a.samples, &b.samples, REACH, weights, tangent, &sums);
            double turned = sums.squares - 2 * hypot(sums.product[0], sums.product[1]);
            double moved = sums.squares - 2 * sums.product[0];
            assert_near(turned, minimise(&a, &b, weights, tangent, true), 1e-5 * (1 + turned));
            assert_near(moved, minimise(&a, &b, weights, tangent, false), 1e-5 * (1 + moved));
        }
    }
}

static void weights_are_binomial(void **state)
{
    (void)state;
    double weights[81];
    duct_neighbourhood_weights(81, 40, weights);
    assert_true(weights[40] == 1);
    assert_near(weights[41], 40.0 / 41, 1e-15);
    assert_near(weights[38], 40.0 / 41 * 39 / 42, 1e-15);
    assert_near(weights[0], 1 / 1.07507208733336e23, 1e-34); /* 1 / C(80, 40) */
}

static void pulls_meet_where_their_energy_is_least(void **state)
{
    (void)state;
    const duct_pull pulls[] = {{1, 2, 1}, {5, -3, 0.25}, {-2, 7, 3.8}};
    double x, y, cost = duct_pulls_solve(pulls, 3, &x, &y);
    for (int i = 0; i < 16; i++) {
        double dx = 0.01 * cos(i), dy = 0.01 * sin(i), other = 0;
        for (size_t p = 0; p < 3; p++) {
            double ax = x + dx - pulls[p].x, ay = y + dy - pulls[p].y;
            other += pulls[p].weight * (ax * ax + ay * ay);
        }
        assert_true(other > cost);
    }
    const duct_pull hard[] = {{1, 2, 1}, {5, -3, INFINITY}};
    cost = duct_pulls_solve(hard, 2, &x, &y);
    assert_true(x == 5 && y == -3);
    assert_near(cost, 16 + 25, 1e-12);
}

static void constraints_soften_as_gaussians_that_spread(void **state)
{
    (void)state;
    assert_true(isinf(duct_constraint_soften(INFINITY, 0)));
    assert_near(duct_constraint_soften(INFINITY, 4), 0.25, 1e-15);
    assert_near(duct_constraint_soften(2, 0), 2, 0);
    assert_near(duct_constraint_soften(2, 3), 1 / 3.5, 1e-15);
}

/* A set with one position and two slots, to look into the cost of. */
static duct_example_set tiny_set(duct_neighbourhood around[2], double *weights, double *shares,
                                 size_t *numbers, bool *wraps, const duct_analogy_options *options)
{
    static bool full[1] = {false};
    duct_example_set set = {
        .full = full, .count = 1, .slots = 2, .reach = REACH, .step = 1, .gap = 1, .spacing = 0.25};
    set.weights = set.own_weights = weights;
    for (int k = 0; k < 2 * REACH + 1; k++) {
        set.mass += weights[k];
    }
    set.own_mass = set.mass;
    set.penalty = 1;
    set.slot[0] = (duct_slot_weights){1, 1, 0};
    set.slot[1] = (duct_slot_weights){2, 2, 3.8};
    set.options = options;
    set.around = around;
    set.before = shares;
    set.after = shares + 1;
    set.piece = numbers;
    set.place = numbers + 1;
    set.sizes = numbers + 2;
    set.wraps = wraps;
    return set;
}

/* The energy of placing the new point at (x, y), as equation (6) has it: the point's own term, and the offset
 * of the centres of mass, in which the point has its share. */
static double placed(const duct_query *query, const duct_example_set *set, double x, double y, double re,
                     double im, const duct_alignment sums[2])
{
    const duct_neighbourhood *a = set->around, *b = query->around;
    double ax = b[0].centre[0] + sums[0].b[0] - (re * sums[0].a[0] - im * sums[0].a[1]);
    double ay = b[0].centre[1] + sums[0].b[1] - (im * sums[0].a[0] + re * sums[0].a[1]);
    double energy = (x - ax) * (x - ax) + (y - ay) * (y - ay);
    /* The centres of mass, sample by sample: the middle one is the new point. */
    double mass = 0, own[2] = {0, 0}, example[2] = {0, 0};
    for (int k = -REACH; k <= REACH; k++) {
        double w = set->weights[k + REACH];
        mass += w;
        own[0] += w * (k == 0 ? x : b[0].centre[0] + b[0].x[k + REACH]);
        own[1] += w * (k == 0 ? y : b[0].centre[1] + b[0].y[k + REACH]);
        example[0] += w * (a[0].centre[0] + a[0].x[k + REACH]);
        example[1] += w * (a[0].centre[1] + a[0].y[k + REACH]);
    }
    double off_a[2] = {example[0] / mass - a[1].centre[0] - sums[1].a[0],
                       example[1] / mass - a[1].centre[1] - sums[1].a[1]};
    double off_b[2] = {own[0] / mass - b[1].centre[0] - sums[1].b[0],
                       own[1] / mass - b[1].centre[1] - sums[1].b[1]};
    double dx = re * off_a[0] - im * off_a[1] - off_b[0], dy = im * off_a[0] + re * off_a[1] - off_b[1];
    energy += set->slot[1].offset * (dx * dx + dy * dy);
    for (size_t i = 0; i < query->pin_count; i++) {
        const duct_pull *pull = &query->pins[i].pull;
        energy += pull->weight * ((x - pull->x) * (x - pull->x) + (y - pull->y) * (y - pull->y));
    }
    return energy;
}

static void the_new_point_minimises_point_offset_and_constraints(void **state)
{
    (void)state;
    double weights[2 * REACH + 1], shares[2] = {0.5, 0.5};
    size_t numbers[3] = {0, 0, 1};
    bool wraps[1] = {false};
    duct_analogy_options options = duct_analogy_options_default();
    duct_neighbourhood_weights(25, REACH, weights);
    for (unsigned seed = 0; seed < 10; seed++) {
        options.rotation = seed % 2 == 0;
        patch a[2], b[2];
        duct_neighbourhood around[2];
        duct_query query = {.previous = DUCT_NOWHERE, .before = 0.5, .after = 0.5};
        duct_pin pin = {0, {3, -4, 0.7}, {0, 0}};
        query.pins = &pin;
        query.pin_count = seed % 3 == 0;
        for (unsigned s = 0; s < 2; s++) {
            random_patch(&a[s], 10 * seed + s, -REACH, REACH);
            random_patch(&b[s], 10 * seed + 5 + s, -REACH, REACH);
            around[s] = a[s].samples;
            query.around[s] = b[s].samples;
        }
        duct_example_set set = tiny_set(around, weights, shares, numbers, wraps, &options);
        duct_alignment sums[2];
        duct_candidate candidate;
        for (unsigned s = 0; s < 2; s++) {
            duct_align(&around[s], &query.around[s], REACH, weights, options.tangent_weight, &sums[s]);
        }
        double re = sums[0].product[0] + 2 * sums[1].product[0];
        double im = sums[0].product[1] + 2 * sums[1].product[1], size = hypot(re, im);
        re = options.rotation ? re / size : 1;
        im = options.rotation ? im / size : 0;
        duct_cost_of(&set, &query, 0, &candidate);
        double least = placed(&query, &set, candidate.x, candidate.y, re, im, sums);
        for (int i = 0; i < 16; i++) {
            double reach = i < 8 ? 1e-3 : 1;
            assert_true(placed(&query, &set, candidate.x + reach * cos(i), candidate.y + reach * sin(i), re,
                               im, sums) > least);
        }
        /* And the whole cost is the matching terms and that energy. */
        double match = 0;
        for (unsigned s = 0; s < 2; s++) {
            double weight = s == 0 ? 1 : 2;
            match += weight * (sums[s].squares - 2 * (re * sums[s].product[0] + im * sums[s].product[1]));
        }
        assert_near(candidate.cost, match + least, 1e-8 * (1 + match + least));
    }
}

/* Without anything made yet, the first point lies where b + R (a' - a) says. */
static void the_first_point_lies_where_the_offset_says(void **state)
{
    (void)state;
    double weights[2 * REACH + 1], shares[2] = {0.5, 0.5};
    size_t numbers[3] = {0, 0, 1};
    bool wraps[1] = {false};
    duct_analogy_options options = duct_analogy_options_default();
    options.rotation = false;
    duct_neighbourhood_weights(25, REACH, weights);
    patch a[2], b[2];
    duct_neighbourhood around[2];
    duct_query query = {.previous = DUCT_NOWHERE, .causal = true, .before = 0.5, .after = 0.5};
    for (unsigned s = 0; s < 2; s++) {
        random_patch(&a[s], 1 + s, -REACH, REACH);
        random_patch(&b[s], 5 + s, -REACH, REACH);
        around[s] = a[s].samples;
        query.around[s] = b[s].samples;
    }
    query.around[0].low = 1;
    query.around[0].high = 0;
    duct_example_set set = tiny_set(around, weights, shares, numbers, wraps, &options);
    duct_alignment sums;
    duct_align(&around[1], &query.around[1], REACH, weights, options.tangent_weight, &sums);
    duct_candidate candidate;
    duct_cost_of(&set, &query, 0, &candidate);
    double x = query.around[1].centre[0] + sums.b[0] + around[0].centre[0] - around[1].centre[0] - sums.a[0];
    double y = query.around[1].centre[1] + sums.b[1] + around[0].centre[1] - around[1].centre[1] - sums.a[1];
    assert_near(candidate.x, x, 1e-9);
    assert_near(candidate.y, y, 1e-9);
}

static void neighbourhoods_are_spaced_in_arc_length_and_stop_at_ends(void **state)
{
    (void)state;
    duct_curve curve = make_course(60, 100, 0.5);
    patch made;
    duct_neighbourhood_lay(&made.samples, made.block, REACH, false);
    duct_neighbourhood_around(&curve, (duct_place){1, 0.5}, 0.5, REACH, &made.samples);
    double before = duct_curve_length(&curve) / 59 * 1.5;
    assert_int_equal(made.samples.high, REACH);
    assert_int_equal(made.samples.low, -(int)floor(before / 0.5));
    for (int k = made.samples.low + 1; k <= made.samples.high; k++) {
        int i = k + REACH;
        double step =
            hypot(made.samples.x[i] - made.samples.x[i - 1], made.samples.y[i] - made.samples.y[i - 1]);
        assert_in_range((int)(1000 * step), 480, 500); /* a chord is no longer than its arc */
        assert_near(hypot(made.samples.u[i], made.samples.v[i]), 1, 1e-12);
    }
    curve.closed = true;
    duct_neighbourhood_around(&curve, (duct_place){0, 0}, 0.5, REACH, &made.samples);
    assert_int_equal(made.samples.low, -REACH);
    free_curve(&curve);
}

static void pyramids_keep_ends_and_lose_detail(void **state)
{
    (void)state;
    duct_error error;
    duct_curve_pair pair = make_waves(300, true);
    duct_pyramid pyramid;
    assert_ok(duct_pyramid_make(duct_allocator_of(NULL), &pair.b, 0.5, 18, &pyramid, &error));
    for (size_t l = 0; l < 18; l++) {
        const duct_curve *level = &pyramid.levels[l];
        size_t last = level->count - 1;
        assert_near(level->x[0], pair.b.x[0], 1e-9);
        assert_near(level->y[last], pair.b.y[pair.b.count - 1], 1e-9);
        assert_true(level->t[0] == 0 && level->t[last] == 1);
        double spacing = duct_curve_length(level) / (double)last;
        assert_true(fabs(spacing / duct_pyramid_spacing(0.5, l) - 1) < 0.05);
        if (l > 0) {
            assert_true(duct_curve_length(level) < duct_curve_length(&pyramid.levels[l - 1]));
        }
    }
    assert_true(duct_curve_length(&pyramid.levels[17]) < 320);
    duct_pyramid_done(duct_allocator_of(NULL), &pyramid);
    free_pair(&pair);
}

static void warping_finds_what_lies_together(void **state)
{
    (void)state;
    duct_error error;
    duct_curve_pair pair = make_waves(200, false);
    /* The same shape, but A' lingers in the first quarter: by length alone it would be out of step. */
    size_t count = pair.a.count;
    for (size_t i = 0; i < count; i++) {
        double at = (double)i;
        pair.b.x[i] = at;
        pair.b.y[i] = 5 + (at < 50 ? 8 * sin(at * 1.2) : 0);
    }
    pair.b.count = count - 1; /* not as many points: by number is not possible */
    pair.b.x[count - 2] = 200;
    double by_length = 0, by_place = 0;
    for (int round = 0; round < 2; round++) {
        assert_ok(duct_correspond(duct_allocator_of(NULL),
                                  round == 0 ? DUCT_CORRESPOND_LENGTH : DUCT_CORRESPOND_WARP, &pair.a,
                                  &pair.b, &error));
        double *sum = round == 0 ? &by_length : &by_place;
        for (size_t i = 0; i < pair.b.count; i++) {
            *sum += fabs(200 * pair.b.t[i] - pair.b.x[i]) / (double)pair.b.count;
            assert_true(i == 0 || pair.b.t[i] > pair.b.t[i - 1]);
        }
    }
    assert_true(by_length > 20);
    print_message("out of step by %.3g, warped %.3g\n", by_length, by_place);
    assert_true(by_place < 6);
    free_pair(&pair);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(alignment_is_the_minimum_over_rotations_and_translations),
        cmocka_unit_test(weights_are_binomial),
        cmocka_unit_test(pulls_meet_where_their_energy_is_least),
        cmocka_unit_test(constraints_soften_as_gaussians_that_spread),
        cmocka_unit_test(the_new_point_minimises_point_offset_and_constraints),
        cmocka_unit_test(the_first_point_lies_where_the_offset_says),
        cmocka_unit_test(neighbourhoods_are_spaced_in_arc_length_and_stop_at_ends),
        cmocka_unit_test(pyramids_keep_ends_and_lose_detail),
        cmocka_unit_test(warping_finds_what_lies_together),
    };
    return cmocka_run_group_tests_name("analogy_parts", tests, NULL, NULL);
}
