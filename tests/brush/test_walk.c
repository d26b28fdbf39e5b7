/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/marks.h"

#include "brush/walk.h"

#include <time.h>

static const double wide[4] = {-1e6, -1e6, 1e6, 1e6};

static duct_stroke *line(duct_drawing *drawing, size_t size, const double *x, const double *y)
{
    duct_stroke *stroke = NULL;
    assert_int_equal(duct_drawing_add_stroke(drawing, "", size, &stroke, NULL), DUCT_OK);
    for (size_t i = 0; i < size; i++) {
        duct_stroke_edit(stroke, DUCT_X)[i] = x[i];
        duct_stroke_edit(stroke, DUCT_Y)[i] = y[i];
    }
    return stroke;
}

static size_t walk_all(const duct_stroke *stroke, const double box[4], double step, duct_pose *poses,
                       size_t most)
{
    duct_paint_options options = duct_paint_options_default();
    duct_walk walk;
    duct_walk_begin(&walk, stroke, &options, box, step);
    duct_pose pose;
    size_t count = 0;
    while (duct_walk_next(&walk, &pose)) {
        assert_true(isfinite(pose.x) && isfinite(pose.y) && isfinite(pose.time) && pose.time >= 0);
        if (count < most) {
            poses[count] = pose;
        }
        count++;
    }
    return count;
}

static void places_are_equally_far_apart(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    const double x[] = {0, 10, 10, 3.3}, y[] = {0, 0, 7.25, 7.25};
    duct_stroke *stroke = line(drawing, 4, x, y);
    double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE);
    pressure[1] = 1;
    duct_pose poses[100];
    size_t count = walk_all(stroke, wide, 0.5, poses, 100);
    assert_int_equal(count, 49); /* 23.95 long: 0, 0.5, ... 23.5 and the end */
    assert_true(poses[0].jump);
    for (size_t i = 1; i + 1 < count; i++) {
        assert_near(poses[i].distance, 0.5 * (double)i, 1e-9);
        assert_false(poses[i].jump);
    }
    assert_near(poses[10].x, 5, 1e-9);
    assert_near(poses[10].pressure, 0.5, 1e-9);
    assert_near(poses[count - 1].x, 3.3, 1e-9);
    duct_drawing_free(drawing);
}

static void box_changes_no_place(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    const double x[] = {-50, 60, -50, 40}, y[] = {3, 4, 8, 30};
    duct_stroke *stroke = line(drawing, 4, x, y);
    static duct_pose all[4000], some[4000];
    const double box[4] = {0, 0, 10, 10};
    size_t all_count = walk_all(stroke, wide, 0.25, all, 4000),
           some_count = walk_all(stroke, box, 0.25, some, 4000);
    size_t inside = 0;
    for (size_t i = 0; i < all_count; i++) {
        if (all[i].x >= 0 && all[i].x <= 10 && all[i].y >= 0 && all[i].y <= 10) {
            assert_true(inside < some_count);
            assert_near(all[i].x, some[inside].x, 1e-9);
            assert_near(all[i].y, some[inside].y, 1e-9);
            assert_near(all[i].distance, some[inside].distance, 1e-9);
            inside++;
        }
    }
    assert_int_equal(inside, some_count);
    assert_true(some_count > 60);
    duct_drawing_free(drawing);
}

static void far_away_costs_nothing(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    const double x[] = {5, 1e12, 1e300, -1e300, 5, -1e12}, y[] = {5, 1e12, 1e300, 1e300, 5, 5};
    duct_stroke *stroke = line(drawing, 6, x, y);
    const double box[4] = {0, 0, 10, 10};
    duct_pose poses[8];
    clock_t begin = clock();
    size_t count = walk_all(stroke, box, 0.1, poses, 8);
    assert_true((double)(clock() - begin) / CLOCKS_PER_SEC < 0.5);
    assert_true(count > 50 && count < 2000);
    duct_drawing_free(drawing);
}

static void degenerate_strokes_end(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    duct_pose poses[8];
    const double one[] = {3}, same[] = {3, 3, 3, 3}, bad[] = {NAN, 1, INFINITY, 4, NAN, -INFINITY};
    assert_int_equal(walk_all(line(drawing, 0, NULL, NULL), wide, 1, poses, 8), 0);
    assert_int_equal(walk_all(line(drawing, 1, one, one), wide, 1, poses, 8), 1);
    assert_int_equal(walk_all(line(drawing, 4, same, same), wide, 1, poses, 8), 1);
    duct_stroke *stroke = line(drawing, 6, bad, bad);
    double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE), *time = duct_stroke_edit(stroke, DUCT_T);
    double *tilt = duct_stroke_edit(stroke, DUCT_TILT_X), *twist = duct_stroke_edit(stroke, DUCT_TWIST);
    for (int i = 0; i < 6; i++) {
        pressure[i] = time[i] = tilt[i] = twist[i] = i % 2 == 0 ? NAN : -INFINITY;
    }
    assert_int_equal(walk_all(stroke, wide, 1, poses, 8), 6);
    assert_near(poses[5].x, 4, 1e-9);
    assert_near(poses[3].pressure, 0.5, 1e-9);
    duct_drawing_free(drawing);
}

static void closed_stroke_returns(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    const double x[] = {0, 10, 10}, y[] = {0, 0, 10};
    duct_stroke *stroke = line(drawing, 3, x, y);
    duct_stroke_set_closed(stroke, true);
    duct_pose poses[60];
    size_t count = walk_all(stroke, wide, 1, poses, 60);
    assert_int_equal(count, 36); /* 34.14 long */
    assert_near(poses[count - 1].x, 0, 1e-9);
    assert_near(poses[count - 1].y, 0, 1e-9);
    duct_drawing_free(drawing);
}

static void million_samples_become_few_places(void **state)
{
    (void)state;
    enum { million = 1000000 };
    duct_drawing *drawing = new_drawing();
    duct_stroke *stroke = NULL;
    assert_int_equal(duct_drawing_add_stroke(drawing, "", million, &stroke, NULL), DUCT_OK);
    double *x = duct_stroke_edit(stroke, DUCT_X);
    for (int i = 0; i < million; i++) {
        x[i] = i * 1e-4;
    }
    duct_pose poses[1];
    size_t count = walk_all(stroke, wide, 1, poses, 1);
    assert_true(count >= 100 && count <= 102);
    duct_drawing_free(drawing);
}

static void time_follows_the_clock_or_a_steady_speed(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    const double x[] = {0, 10, 30}, y[] = {0, 0, 0};
    duct_stroke *stroke = line(drawing, 3, x, y);
    duct_pose poses[40];
    walk_all(stroke, wide, 1, poses, 40);
    assert_true(poses[5].time > 0);
    assert_near(poses[5].time, poses[25].time, 1e-12);
    double *time = duct_stroke_edit(stroke, DUCT_T);
    walk_all(stroke, wide, 1, poses, 40); /* all times equal: as good as none */
    assert_near(poses[5].time, poses[25].time, 1e-12);
    time[1] = 1;
    time[2] = 1.5;
    walk_all(stroke, wide, 1, poses, 40);
    assert_near(poses[5].time, 0.1, 1e-9);
    assert_near(poses[25].time, 0.025, 1e-9);
    duct_drawing_free(drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(places_are_equally_far_apart),
        cmocka_unit_test(box_changes_no_place),
        cmocka_unit_test(far_away_costs_nothing),
        cmocka_unit_test(degenerate_strokes_end),
        cmocka_unit_test(closed_stroke_returns),
        cmocka_unit_test(million_samples_become_few_places),
        cmocka_unit_test(time_follows_the_clock_or_a_steady_speed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
