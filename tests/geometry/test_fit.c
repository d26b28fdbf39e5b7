/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"
#include "geometry/fit.h"

#include <math.h>

static const double pi = 3.14159265358979323846;

typedef struct {
    double *x, *y;
    size_t count;
} points;

static points points_new(size_t count)
{
    return (points){calloc(count, sizeof(double)), calloc(count, sizeof(double)), count};
}

static void points_free(points *p)
{
    free(p->x);
    free(p->y);
}

static duct_path fit(const points *p, bool closed, double tolerance)
{
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    duct_fit_curve(p->x, p->y, p->count, closed, tolerance, &path);
    assert_false(path.failed);
    for (size_t i = 0; i < 2 * path.point_count; i++) {
        assert_true(isfinite(path.points[i]));
    }
    return path;
}

static uint64_t random_state;

static double uniform(double least, double most)
{
    random_state = random_state * 6364136223846793005u + 1442695040888963407u;
    return least + (most - least) * (double)(random_state >> 40) / (double)(1 << 24);
}

static double segment_distance(double px, double py, double ax, double ay, double bx, double by)
{
    double dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
    double t = square > 0 ? ((px - ax) * dx + (py - ay) * dy) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return hypot(px - ax - t * dx, py - ay - t * dy);
}

/* The path as a dense polyline. */
static points flatten(const duct_path *path, size_t steps)
{
    points flat = points_new(path->verb_count * steps + 2);
    size_t count = 0, start = 0;
    const double *p = path->points, *from = p;
    for (size_t i = 0; i < path->verb_count; i++) {
        if (path->verbs[i] == DUCT_PATH_CUBIC) {
            for (size_t k = 1; k <= steps; k++, count++) {
                double u = (double)k / (double)steps, v = 1 - u;
                double b0 = v * v * v, b1 = 3 * v * v * u, b2 = 3 * v * u * u, b3 = u * u * u;
                flat.x[count] = b0 * from[0] + b1 * p[0] + b2 * p[2] + b3 * p[4];
                flat.y[count] = b0 * from[1] + b1 * p[1] + b2 * p[3] + b3 * p[5];
            }
            from = p + 4;
            p += 6;
        } else if (path->verbs[i] == DUCT_PATH_CLOSE) {
            flat.x[count] = flat.x[start];
            flat.y[count++] = flat.y[start];
        } else {
            start = path->verbs[i] == DUCT_PATH_MOVE ? count : start;
            flat.x[count] = p[0];
            flat.y[count++] = p[1];
            from = p;
            p += 2;
        }
    }
    flat.count = count;
    return flat;
}

/* The largest distance of a point from the path, by brute force. */
static double worst_distance(const points *p, const duct_path *path)
{
    points flat = flatten(path, 200);
    double worst = 0;
    for (size_t i = 0; i < p->count; i++) {
        double least = INFINITY;
        for (size_t k = 0; k + 1 < flat.count; k++) {
            least = fmin(least, segment_distance(p->x[i], p->y[i], flat.x[k], flat.y[k], flat.x[k + 1],
                                                 flat.y[k + 1]));
        }
        worst = fmax(worst, least);
    }
    points_free(&flat);
    return worst;
}

/* A smooth path of random cubics, sampled. */
static points random_path(size_t segments, size_t samples)
{
    points p = points_new(segments * samples + 1);
    double x = 0, y = 0, angle = 0;
    size_t count = 0;
    for (size_t k = 0; k < segments; k++) {
        double next = angle + uniform(-1.5, 1.5), length = uniform(50, 200);
        double dx = length * cos(next), dy = length * sin(next);
        double a = uniform(0.2, 0.6) * length, b = uniform(0.2, 0.6) * length;
        double end = next + uniform(-1, 1);
        double cx[4] = {x, x + a * cos(angle), x + dx - b * cos(end), x + dx};
        double cy[4] = {y, y + a * sin(angle), y + dy - b * sin(end), y + dy};
        for (size_t i = 0; i < samples; i++) {
            double u = (double)i / (double)samples, v = 1 - u;
            p.x[count] =
                v * v * v * cx[0] + 3 * v * v * u * cx[1] + 3 * v * u * u * cx[2] + u * u * u * cx[3];
            p.y[count++] =
                v * v * v * cy[0] + 3 * v * v * u * cy[1] + 3 * v * u * u * cy[2] + u * u * u * cy[3];
        }
        x += dx;
        y += dy;
        angle = end;
    }
    p.x[count] = x;
    p.y[count] = y;
    return p;
}

static void empty_input_adds_nothing(void **state)
{
    (void)state;
    points p = {NULL, NULL, 0};
    duct_path path = fit(&p, false, 0.1);
    assert_int_equal(path.verb_count, 0);
    duct_path_done(&path);
}

static void degenerate_input_gives_short_paths(void **state)
{
    (void)state;
    points p = points_new(5);
    for (size_t count = 1; count <= 5; count++) {
        for (int closed = 0; closed <= 1; closed++) {
            p.count = count;
            duct_path path = fit(&p, closed, 0.1);
            assert_int_equal(path.verbs[0], DUCT_PATH_MOVE);
            assert_true(duct_path_nodes(&path) <= 2);
            duct_path_done(&path);
        }
    }
    p.count = 2;
    p.x[1] = 3;
    duct_path path = fit(&p, false, 0.1);
    assert_int_equal(path.verb_count, 2);
    assert_int_equal(path.verbs[1], DUCT_PATH_LINE);
    duct_path_done(&path);
    points_free(&p);
}

static void samples_of_n_cubics_give_about_n_cubics(void **state)
{
    (void)state;
    random_state = 7;
    size_t segments = 0, nodes = 0;
    for (size_t n = 1; n <= 12; n++) {
        points p = random_path(n, 100);
        duct_path path = fit(&p, false, 0.2);
        segments += n;
        nodes += duct_path_nodes(&path) - 1;
        assert_true(worst_distance(&p, &path) <= 0.2 + 1e-3);
        duct_path_done(&path);
        points_free(&p);
    }
    assert_true((double)nodes <= 1.5 * (double)segments);
}

static void every_sample_is_within_the_tolerance(void **state)
{
    (void)state;
    random_state = 11;
    static const double tolerances[] = {0.01, 0.1, 1, 10};
    for (size_t k = 0; k < 4; k++) {
        points p = random_path(6, 60);
        for (size_t i = 0; i < p.count; i++) {
            p.x[i] += uniform(-0.05, 0.05);
            p.y[i] += uniform(-0.05, 0.05);
        }
        for (int closed = 0; closed <= 1; closed++) {
            duct_path path = fit(&p, closed, tolerances[k]);
            assert_true(worst_distance(&p, &path) <= 1.001 * tolerances[k] + 1e-3);
            duct_path_done(&path);
        }
        points_free(&p);
    }
}

static void curves_do_not_bulge_between_samples(void **state)
{
    (void)state;
    random_state = 5;
    points p = points_new(80);
    for (size_t i = 0; i < p.count; i++) {
        p.x[i] = uniform(0, 100);
        p.y[i] = uniform(0, 100);
    }
    duct_path path = fit(&p, false, 0.1);
    points flat = flatten(&path, 50);
    double worst = 0;
    for (size_t k = 0; k < flat.count; k++) {
        double least = INFINITY;
        for (size_t i = 0; i + 1 < p.count; i++) {
            least =
                fmin(least, segment_distance(flat.x[k], flat.y[k], p.x[i], p.y[i], p.x[i + 1], p.y[i + 1]));
        }
        worst = fmax(worst, least);
    }
    assert_true(worst < 10);
    points_free(&flat);
    duct_path_done(&path);
    points_free(&p);
}

static void circles_are_smooth_at_the_seam(void **state)
{
    (void)state;
    for (size_t count = 12; count <= 3000; count *= 5) {
        points p = points_new(count);
        for (size_t i = 0; i < count; i++) {
            p.x[i] = 40 * cos(2 * pi * (double)i / (double)count);
            p.y[i] = 40 * sin(2 * pi * (double)i / (double)count);
        }
        duct_path path = fit(&p, true, 0.1);
        assert_true(duct_path_nodes(&path) <= 4);
        assert_int_equal(path.verbs[path.verb_count - 1], DUCT_PATH_CLOSE);
        const double *first = path.points, *last = path.points + 2 * (path.point_count - 1);
        assert_true(hypot(first[0] - last[0], first[1] - last[1]) < 1e-12);
        double ax = first[2] - first[0], ay = first[3] - first[1], bx = last[0] - last[-2],
               by = last[1] - last[-1];
        assert_true(fabs(ax * by - ay * bx) < 1e-6 * hypot(ax, ay) * hypot(bx, by));
        assert_true(ax * bx + ay * by > 0);
        duct_path_done(&path);
        points_free(&p);
    }
}

/* A square's outline, `side` samples a side, with noise. */
static points square(size_t side, double noise)
{
    static const double corner[5][2] = {{0, 0}, {50, 0}, {50, 50}, {0, 50}, {0, 0}};
    points p = points_new(4 * side);
    for (size_t i = 0; i < p.count; i++) {
        double t = (double)(i % side) / (double)side;
        const double *a = corner[i / side], *b = corner[i / side + 1];
        p.x[i] = a[0] + t * (b[0] - a[0]) + uniform(-noise, noise);
        p.y[i] = a[1] + t * (b[1] - a[1]) + uniform(-noise, noise);
    }
    return p;
}

static void corners_and_straight_runs_are_kept(void **state)
{
    (void)state;
    random_state = 3;
    for (size_t side = 1; side <= 1000; side *= 10) {
        for (int noisy = 0; noisy <= 1; noisy++) {
            points p = square(side, noisy ? 0.02 : 0);
            duct_path path = fit(&p, true, 0.1);
            assert_int_equal(duct_path_nodes(&path), 4);
            for (size_t i = 1; i + 1 < path.verb_count; i++) {
                assert_int_equal(path.verbs[i], DUCT_PATH_LINE);
            }
            duct_path_done(&path);
            points_free(&p);
        }
    }
}

static void collinear_back_and_forth_keeps_its_ends(void **state)
{
    (void)state;
    points p = points_new(301);
    for (size_t i = 0; i < p.count; i++) {
        p.x[i] = 100 - fabs(100 - (double)(i % 200));
    }
    duct_path path = fit(&p, false, 0.1);
    double most = 0;
    for (size_t i = 0; i < path.point_count; i++) {
        most = fmax(most, path.points[2 * i]);
        assert_true(path.points[2 * i] > -0.2 && path.points[2 * i] < 100.2);
    }
    assert_true(fabs(most - 100) <= 0.1);
    assert_true(duct_path_nodes(&path) <= 6);
    duct_path_done(&path);
    points_free(&p);
}

static void dense_noise_below_the_tolerance_adds_no_nodes(void **state)
{
    (void)state;
    random_state = 9;
    points p = points_new(20000);
    for (size_t i = 0; i < p.count; i++) {
        double t = 100 * (double)i / (double)p.count;
        p.x[i] = t + uniform(-0.02, 0.02);
        p.y[i] = 20 * sin(t / 10) + uniform(-0.02, 0.02);
    }
    duct_path path = fit(&p, false, 0.1);
    assert_true(duct_path_nodes(&path) <= 30);
    duct_path_done(&path);
    points_free(&p);
}

static void a_million_samples_take_no_quadratic_time(void **state)
{
    (void)state;
    random_state = 1;
    points p = points_new(1000000);
    for (size_t i = 0; i < p.count; i++) {
        double t = (double)i / (double)p.count;
        p.x[i] = (50 + 400 * t) * cos(60 * t);
        p.y[i] = (50 + 400 * t) * sin(60 * t);
    }
    duct_path path = fit(&p, false, 0.1);
    assert_true(duct_path_nodes(&path) < 80);
    duct_path_done(&path);
    for (size_t i = 1; i < p.count; i++) {
        p.x[i] = p.x[i - 1] + uniform(-1, 1);
        p.y[i] = p.y[i - 1] + uniform(-1, 1);
    }
    path = fit(&p, true, 0.1);
    duct_path_done(&path);
    points_free(&p);
}

static void hostile_values_do_no_harm(void **state)
{
    (void)state;
    static const double bad[] = {NAN, INFINITY, -INFINITY, 1e308, -1e308, 1e60, 1e-320, -0.0};
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        for (int closed = 0; closed <= 1; closed++) {
            points p = square(5, 0);
            duct_path path = fit(&p, closed, bad[k]);
            duct_path_done(&path);
            p.x[3] = bad[k];
            p.y[7] = bad[k];
            path = fit(&p, closed, 0.1);
            duct_path_done(&path);
            for (size_t i = 0; i < p.count; i++) {
                p.x[i] = bad[k];
            }
            path = fit(&p, closed, 0.1);
            duct_path_done(&path);
            points_free(&p);
        }
    }
}

static void failed_allocations_are_told(void **state)
{
    (void)state;
    random_state = 2;
    points p = random_path(20, 30);
    bool done = false;
    for (long n = 1; !done; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_path path;
        duct_path_init(&path, &failing.allocator);
        duct_fit_curve(p.x, p.y, p.count, false, 0.05, &path);
        done = failing.calls < n;
        assert_int_equal(path.failed, !done);
        duct_path_done(&path);
        assert_int_equal(failing.held, 0);
    }
    points_free(&p);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_input_adds_nothing),
        cmocka_unit_test(degenerate_input_gives_short_paths),
        cmocka_unit_test(samples_of_n_cubics_give_about_n_cubics),
        cmocka_unit_test(every_sample_is_within_the_tolerance),
        cmocka_unit_test(curves_do_not_bulge_between_samples),
        cmocka_unit_test(circles_are_smooth_at_the_seam),
        cmocka_unit_test(corners_and_straight_runs_are_kept),
        cmocka_unit_test(collinear_back_and_forth_keeps_its_ends),
        cmocka_unit_test(dense_noise_below_the_tolerance_adds_no_nodes),
        cmocka_unit_test(a_million_samples_take_no_quadratic_time),
        cmocka_unit_test(hostile_values_do_no_harm),
        cmocka_unit_test(failed_allocations_are_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
