/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape optimization against a dense least-squares solve by LAPACK, and what it promises about ends and
 * closing. */
#include "testing.h"

#include "base/memory.h"
#include "geometry/banded.h"
#include "helpinghand/shape.h"

#include <ductus/random.h>

#include <lapacke.h>
#include <math.h>

enum { COUNT = 60 };

static const duct_shape_options paper = {DUCT_ANCHORS_PAPER, M_PI / 3, 30, 200, 1e6, 0.25, 2, 2};

typedef struct {
    double x[COUNT], y[COUNT];
    duct_gesture gestures[COUNT];
} query;

/* A wavy query with a corner, and gestures that run alike but not the same. */
static void make_query(query *q, uint64_t seed)
{
    memset(q, 0, sizeof *q);
    double x = 100, y = 50;
    for (size_t i = 0; i < COUNT; i++) {
        double angle = 0.13 * (double)i + (i > 30 ? 2 : 0);
        x += i > 0 ? cos(angle) : 0;
        y += i > 0 ? sin(angle) : 0;
        q->x[i] = x;
        q->y[i] = y;
        double off = angle + 0.4 * duct_random_normal(seed, i, 0, 0);
        q->gestures[i].vx = cos(off);
        q->gestures[i].vy = sin(off);
    }
}

/* Solves equations (2) to (4) by their definition: one row an equation, least squares by QR. */
static void solve_densely(const query *q, const duct_shape_options *options, const bool *marks, double *out_x,
                          double *out_y)
{
    size_t most = COUNT + COUNT + COUNT * (2 * options->curvature_reach + 1), rows = 0;
    double *a = calloc(most * COUNT, sizeof *a), *b = calloc(most * 2, sizeof *b);
    for (size_t i = 1; i < COUNT; i++, rows++) {
        a[rows * COUNT + i] = 1;
        a[rows * COUNT + i - 1] = -1;
        b[2 * rows] = q->gestures[i].vx;
        b[2 * rows + 1] = q->gestures[i].vy;
    }
    for (size_t i = 0; i < COUNT; i++) {
        if (!marks[i]) {
            continue;
        }
        double root = sqrt(options->anchor_weight);
        a[rows * COUNT + i] = root;
        b[2 * rows] = root * q->x[i];
        b[2 * rows + 1] = root * q->y[i];
        rows++;
        root = sqrt(options->curvature_weight);
        for (long j = (long)i - (long)options->curvature_reach; j <= (long)(i + options->curvature_reach);
             j++) {
            if (j < 1 || j + 1 >= COUNT) {
                continue;
            }
            a[rows * COUNT + (size_t)j - 1] = root;
            a[rows * COUNT + (size_t)j] = -2 * root;
            a[rows * COUNT + (size_t)j + 1] = root;
            b[2 * rows] = root * (q->gestures[j + 1].vx - q->gestures[j].vx);
            b[2 * rows + 1] = root * (q->gestures[j + 1].vy - q->gestures[j].vy);
            rows++;
        }
    }
    assert_int_equal(LAPACKE_dgels(LAPACK_ROW_MAJOR, 'N', (lapack_int)rows, COUNT, 2, a, COUNT, b, 2), 0);
    for (size_t i = 0; i < COUNT; i++) {
        out_x[i] = b[2 * i];
        out_y[i] = b[2 * i + 1];
    }
    free(a);
    free(b);
}

static void agrees_with_dense_least_squares(void **state)
{
    (void)state;
    duct_error error;
    for (uint64_t seed = 0; seed < 20; seed++) {
        query q;
        make_query(&q, seed);
        bool marks[COUNT];
        double x[COUNT], y[COUNT], dense_x[COUNT], dense_y[COUNT];
        assert_ok(duct_anchors_find(duct_allocator_of(NULL), &paper, q.x, q.y, COUNT, marks, NULL, &error));
        assert_ok(duct_shape_solve(duct_allocator_of(NULL), &paper, q.x, q.y, q.gestures, COUNT, false, x, y,
                                   &error));
        solve_densely(&q, &paper, marks, dense_x, dense_y);
        for (size_t i = 0; i < COUNT; i++) {
            assert_true(fabs(x[i] - dense_x[i]) < 1e-8 && fabs(y[i] - dense_y[i]) < 1e-8);
        }
    }
}

static void pentadiagonal_solve_agrees_with_lapack(void **state)
{
    (void)state;
    for (lapack_int n = 1; n < 30; n++) {
        size_t count = (size_t)n;
        double *bands = calloc(3 * count, sizeof *bands), *lapack = calloc(3 * count, sizeof *lapack);
        double *right = calloc(2 * count, sizeof *right), *expected = calloc(2 * count, sizeof *expected);
        duct_pentadiagonal matrix = {count, bands, bands + count, bands + 2 * count};
        for (size_t i = 0; i < count; i++) {
            matrix.main[i] = 6 + duct_random_uniform(1, (uint64_t)n, i, 0);
            matrix.first[i] = 2 * duct_random_uniform(2, (uint64_t)n, i, 0) - 1;
            matrix.second[i] = 2 * duct_random_uniform(3, (uint64_t)n, i, 0) - 1;
            right[i] = expected[i] = duct_random_normal(4, (uint64_t)n, i, 0);
            right[count + i] = expected[count + i] = duct_random_normal(5, (uint64_t)n, i, 0);
            /* Column-major upper band storage: ab[2 + i - j][j]. */
            lapack[3 * i + 2] = matrix.main[i];
            if (i + 1 < count) {
                lapack[3 * (i + 1) + 1] = matrix.first[i];
            }
            if (i + 2 < count) {
                lapack[3 * (i + 2)] = matrix.second[i];
            }
        }
        assert_int_equal(LAPACKE_dpbsv(LAPACK_COL_MAJOR, 'U', n, 2, 2, lapack, 3, expected, n), 0);
        assert_true(duct_pentadiagonal_solve(&matrix, right, right + count));
        for (size_t i = 0; i < 2 * count; i++) {
            assert_true(fabs(right[i] - expected[i]) < 1e-12);
        }
        free(bands);
        free(lapack);
        free(right);
        free(expected);
    }
}

static void rejects_indefinite_matrices(void **state)
{
    (void)state;
    double main_diagonal[2] = {1, 1}, first[2] = {5, 0}, second[2] = {0, 0}, x[2] = {1, 1}, y[2] = {1, 1};
    duct_pentadiagonal matrix = {2, main_diagonal, first, second};
    assert_false(duct_pentadiagonal_solve(&matrix, x, y));
}

static void ends_stay_within_a_unit(void **state)
{
    (void)state;
    duct_error error;
    duct_shape_options on = paper;
    on.anchors = DUCT_ANCHORS_ON;
    double worst_paper = 0;
    for (uint64_t seed = 0; seed < 50; seed++) {
        query q;
        make_query(&q, seed);
        for (size_t i = 0; i < 8; i++) { /* gestures that swing far out at the start */
            q.gestures[i].vx = -2;
            q.gestures[i].vy = 2;
        }
        double x[COUNT], y[COUNT];
        assert_ok(
            duct_shape_solve(duct_allocator_of(NULL), &on, q.x, q.y, q.gestures, COUNT, false, x, y, &error));
        assert_true(hypot(x[0] - q.x[0], y[0] - q.y[0]) <= 1);
        assert_true(hypot(x[COUNT - 1] - q.x[COUNT - 1], y[COUNT - 1] - q.y[COUNT - 1]) <= 1);
        assert_ok(duct_shape_solve(duct_allocator_of(NULL), &paper, q.x, q.y, q.gestures, COUNT, false, x, y,
                                   &error));
        worst_paper = fmax(worst_paper, hypot(x[0] - q.x[0], y[0] - q.y[0]));
    }
    assert_true(worst_paper > 1); /* otherwise the above shows nothing */
}

static void the_line_stays_within_its_leeway_and_keeps_corners(void **state)
{
    (void)state;
    duct_error error;
    query q;
    make_query(&q, 5);
    for (size_t i = 0; i < COUNT; i++) { /* an L, drawn by gestures that run a wide curve */
        q.x[i] = i < 30 ? (double)i : 29;
        q.y[i] = i < 30 ? 0 : (double)i - 29;
        q.gestures[i].vx = cos(0.05 * (double)i);
        q.gestures[i].vy = sin(0.05 * (double)i);
    }
    double farthest[2] = {0}, corner[2];
    for (int on = 0; on < 2; on++) {
        duct_shape_options options = paper;
        options.anchors = on ? DUCT_ANCHORS_ON : DUCT_ANCHORS_PAPER;
        options.leeway = 1.5;
        double x[COUNT], y[COUNT];
        assert_ok(duct_shape_solve(duct_allocator_of(NULL), &options, q.x, q.y, q.gestures, COUNT, false, x,
                                   y, &error));
        for (size_t i = 0; i < COUNT; i++) {
            farthest[on] = fmax(farthest[on], hypot(x[i] - q.x[i], y[i] - q.y[i]));
        }
        corner[on] = hypot(x[29] - 29, y[29]);
    }
    assert_true(farthest[0] > 3 && farthest[1] < 1.7);
    assert_true(corner[1] < 0.8 && corner[1] < corner[0]);
}

static void closed_strokes_stay_closed(void **state)
{
    (void)state;
    duct_error error;
    query q;
    make_query(&q, 3);
    for (size_t i = 0; i < COUNT; i++) {
        double angle = 2 * M_PI * (double)i / (COUNT - 1);
        q.x[i] = 10 * cos(angle);
        q.y[i] = 10 * sin(angle);
    }
    static const duct_anchors kinds[] = {DUCT_ANCHORS_OFF, DUCT_ANCHORS_PAPER, DUCT_ANCHORS_ON};
    for (size_t k = 0; k < 3; k++) {
        duct_shape_options options = paper;
        options.anchors = kinds[k];
        double x[COUNT], y[COUNT];
        assert_ok(duct_shape_solve(duct_allocator_of(NULL), &options, q.x, q.y, q.gestures, COUNT, true, x, y,
                                   &error));
        assert_true(hypot(x[COUNT - 1] - x[0], y[COUNT - 1] - y[0]) < 1e-9);
        double largest = 0;
        for (size_t i = 1; i < COUNT; i++) {
            largest = fmax(largest, hypot(x[i] - x[i - 1], y[i] - y[i - 1]));
        }
        assert_true(largest < 3); /* closed by the whole curve, not by one long step */
    }
}

static void corners_and_ends_are_anchors(void **state)
{
    (void)state;
    duct_error error;
    double x[COUNT], y[COUNT];
    for (size_t i = 0; i < COUNT; i++) { /* an L: right, then down */
        x[i] = i < 30 ? (double)i : 29;
        y[i] = i < 30 ? 0 : (double)i - 29;
    }
    bool marks[COUNT];
    assert_ok(duct_anchors_find(duct_allocator_of(NULL), &paper, x, y, COUNT, marks, NULL, &error));
    assert_true(marks[3] && marks[COUNT - 4] && marks[29]);
    size_t count = 0;
    for (size_t i = 0; i < COUNT; i++) {
        count += marks[i];
    }
    assert_int_equal(count, 3);          /* straight arms need no vertices */
    for (size_t i = 0; i < COUNT; i++) { /* a circle has no corner: polyline vertices hold it */
        x[i] = 20 * cos(0.1 * (double)i);
        y[i] = 20 * sin(0.1 * (double)i);
    }
    assert_ok(duct_anchors_find(duct_allocator_of(NULL), &paper, x, y, COUNT, marks, NULL, &error));
    count = 0;
    for (size_t i = 0; i < COUNT; i++) {
        count += marks[i];
    }
    assert_in_range(count, 5, 12);
    for (size_t i = 0; i < COUNT; i++) { /* a straight line, with no more than ten samples between anchors */
        x[i] = (double)i;
        y[i] = 0;
    }
    duct_shape_options close = paper;
    close.longest = 10;
    assert_ok(duct_anchors_find(duct_allocator_of(NULL), &close, x, y, COUNT, marks, NULL, &error));
    for (size_t i = 3, last = 3; i < COUNT - 3; i++) {
        last = marks[i] ? i : last;
        assert_true(i - last < 10);
    }
}

static void tiny_strokes_work(void **state)
{
    (void)state;
    duct_error error;
    query q;
    make_query(&q, 1);
    for (size_t count = 2; count < 16; count++) {
        double x[COUNT], y[COUNT];
        assert_ok(duct_shape_solve(duct_allocator_of(NULL), &paper, q.x, q.y, q.gestures, count, false, x, y,
                                   &error));
        for (size_t i = 0; i < count; i++) {
            assert_true(isfinite(x[i]) && isfinite(y[i]));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(agrees_with_dense_least_squares),
        cmocka_unit_test(pentadiagonal_solve_agrees_with_lapack),
        cmocka_unit_test(rejects_indefinite_matrices),
        cmocka_unit_test(ends_stay_within_a_unit),
        cmocka_unit_test(the_line_stays_within_its_leeway_and_keeps_corners),
        cmocka_unit_test(closed_strokes_stay_closed),
        cmocka_unit_test(corners_and_ends_are_anchors),
        cmocka_unit_test(tiny_strokes_work),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
