/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "glyphs.h"
#include "manner.h"
#include "motion.h"
#include "shapes.h"
#include "style.h"

#include <math.h>

static const glyph_place place = {100, 500, 50, 0.1};

static trajectory *perform(const motor_style *style, const action_plan *plan, double jitter, uint64_t stroke)
{
    trajectory *way = malloc(sizeof *way);
    assert_non_null(way);
    memset(way, 0xff, sizeof *way);
    motion_perform(style, plan, jitter, 7, stroke, way);
    for (size_t k = 0; k < way->size; k++) {
        assert_true(isfinite(way->x[k]) && isfinite(way->y[k]) && isfinite(way->t[k]));
    }
    return way;
}

static motor_style calm_style(void)
{
    motor_style style = hand_styles[0]->writing;
    style.bend_jitter = style.time_jitter = style.tremor = 0;
    style.accuracy = 1;
    return style;
}

static double nearest(const trajectory *way, double x, double y)
{
    double best = INFINITY;
    for (size_t k = 0; k < way->size; k++) {
        best = fmin(best, hypot(way->x[k] - x, way->y[k] - y));
    }
    return best;
}

static void empty_and_single_plans_give_no_samples(void **state)
{
    (void)state;
    action_plan plan = {.count = 0};
    const motor_style style = calm_style();
    trajectory *way = perform(&style, &plan, 1, 1);
    assert_int_equal(way->size, 0);
    free(way);
    assert_true(plan_add(&plan, 5, 5, false, false));
    way = perform(&style, &plan, 1, 1);
    assert_int_equal(way->size, 0);
    free(way);
}

static void degenerate_targets_stay_finite(void **state)
{
    (void)state;
    action_plan plan = {.count = 0};
    for (int i = 0; i < 6; i++) {
        assert_true(plan_add(&plan, 5, 5, i % 2 == 0, false));
    }
    const motor_style style = calm_style();
    trajectory *way = perform(&style, &plan, 0, 1);
    assert_true(way->size >= 2);
    free(way);
}

static void full_plans_refuse_targets(void **state)
{
    (void)state;
    action_plan plan = {.count = 0};
    for (int i = 0; i < PLAN_TARGETS; i++) {
        assert_true(plan_add(&plan, i, i % 7, false, false));
    }
    assert_false(plan_add(&plan, 0, 0, false, false));
    assert_int_equal(plan.count, PLAN_TARGETS);
    assert_false(glyph_write(alphabet_find(&alphabet_running, 'a'), 0, &place, &plan));
    const motor_style style = calm_style();
    trajectory *way = perform(&style, &plan, 0, 1);
    assert_int_equal(way->size <= MOTION_SAMPLES, 1);
    free(way);
}

static void straight_movement_has_one_bell_of_speed(void **state)
{
    (void)state;
    action_plan plan = {.count = 0};
    plan_add(&plan, 0, 0, false, false);
    plan_add(&plan, 200, 0, false, false);
    const motor_style style = calm_style();
    trajectory *way = perform(&style, &plan, 0, 1);
    int turns = 0;
    double before = 0;
    size_t fastest = 0;
    double top = 0;
    for (size_t k = 1; k < way->size; k++) {
        const double step = way->x[k] - way->x[k - 1];
        assert_true(step > 0);
        assert_true(fabs(way->y[k] - (0)) <= 1e-9);
        assert_true(fabs(way->t[k] - way->t[k - 1] - (1.0 / MOTION_RATE)) <= 1e-12);
        turns += k > 2 && (step - before > 0) != (k <= fastest + 1);
        if (step > top) {
            top = step;
            fastest = k;
        }
        before = step;
    }
    assert_true(turns <= 1);
    /* A lognormal rises faster than it falls. */
    assert_true(fastest < way->size / 2);
    free(way);
}

static void pen_passes_the_targets(void **state)
{
    (void)state;
    const motor_style style = calm_style();
    for (size_t s = 0; s < hand_style_count; s++) {
        const alphabet *letters = hand_styles[s]->letters;
        for (size_t i = 0; i < letters->count; i++) {
            action_plan plan = {.count = 0};
            assert_true(glyph_write(&letters->glyphs[i], 0, &place, &plan));
            trajectory *way = perform(&style, &plan, 0, 1);
            for (size_t k = 0; k < plan.count; k++) {
                /* A fifth of an x-height keeps every letter legible. */
                assert_true(nearest(way, plan.targets[k].x, plan.targets[k].y) < 10);
            }
            free(way);
        }
    }
}

static void same_stroke_is_the_same_and_another_differs_a_little(void **state)
{
    (void)state;
    action_plan plan = {.count = 0};
    assert_true(glyph_write(alphabet_find(&alphabet_running, 'm'), 0, &place, &plan));
    const motor_style *style = &hand_styles[0]->writing;
    trajectory *a = perform(style, &plan, 1.5, 1);
    trajectory *b = perform(style, &plan, 1.5, 1);
    trajectory *c = perform(style, &plan, 1.5, 2);
    assert_int_equal(a->size, b->size);
    assert_memory_equal(a->x, b->x, a->size * sizeof(double));
    assert_true(a->size != c->size || memcmp(a->x, c->x, a->size * sizeof(double)) != 0);
    for (size_t k = 0; k < a->size; k++) {
        assert_true(nearest(c, a->x[k], a->y[k]) < 12);
    }
    free(a);
    free(b);
    free(c);
}

static void circles_are_round(void **state)
{
    (void)state;
    const shape circle = {SHAPE_ARC, 300, 300, 80, 80, 0, -70, 385};
    action_plan plan = {.count = 0};
    assert_true(shape_write(&circle, &plan));
    motor_style style = hand_styles[0]->drawing;
    style.bend_jitter = style.time_jitter = style.tremor = 0;
    trajectory *way = perform(&style, &plan, 0, 1);
    for (size_t k = 0; k < way->size; k++) {
        assert_true(fabs(hypot(way->x[k] - 300, way->y[k] - 300) - (80)) <= 4);
    }
    free(way);
}

static void hooks_come_before_the_stroke(void **state)
{
    (void)state;
    const stroke_manner manner = {.hook = 10, .hook_turn = M_PI / 2};
    action_plan plan = {.count = 0};
    manner_hook(&manner, &plan);
    assert_int_equal(plan.count, 0);
    plan_add(&plan, 100, 100, false, false);
    manner_hook(&manner, &plan);
    assert_int_equal(plan.count, 1);
    plan_add(&plan, 200, 100, false, false);
    manner_hook(&manner, &plan);
    assert_int_equal(plan.count, 3);
    assert_true(hypot(plan.targets[0].x - 100, plan.targets[0].y - 110) < 1e-9);
    assert_true(plan.targets[1].corner && plan.targets[1].x == 100 && plan.targets[2].x == 200);
    /* A tick gets no hook longer than itself, and a full plan none. */
    action_plan tick = {.count = 0};
    plan_add(&tick, 0, 0, false, false);
    plan_add(&tick, 10, 0, false, false);
    manner_hook(&manner, &tick);
    assert_true(fabs(tick.targets[0].y - 3) < 1e-9);
    while (plan_add(&plan, 0, 0, false, false)) {
    }
    manner_hook(&manner, &plan);
    assert_int_equal(plan.count, PLAN_TARGETS);
}

static void pieces_cover_the_line_and_overlap(void **state)
{
    (void)state;
    const stroke_manner manner = {.piece = 100, .overlap = 0.3, .rounds = 2};
    const shape line = {SHAPE_LINE, 50, 60, 390, 0, 90, 0, 0};
    const size_t count = manner_pieces(&manner, &line);
    assert_int_equal(count, 4);
    double covered = 60;
    for (size_t i = 0; i < count; i++) {
        const shape piece = manner_piece(&manner, &line, i);
        assert_true(fabs(piece.x - 50) < 1e-9);
        assert_true(i == 0 ? piece.y == 60 : piece.y < covered - 20);
        covered = piece.y + piece.a;
    }
    assert_true(fabs(covered - 450) < 1e-9);
    const shape round = {SHAPE_ARC, 0, 0, 80, 80, 0, 10, -380}, arc = {SHAPE_ARC, 0, 0, 300, 300, 0, 0, 90};
    assert_int_equal(manner_pieces(&manner, &round), 1);
    assert_true(manner_piece(&manner, &round, 0).amount == -760);
    assert_int_equal(manner_pieces(&manner, &arc), 5);
    const shape last = manner_piece(&manner, &arc, 4);
    assert_true(fabs(last.from + last.amount - 90) < 1e-9);
    const stroke_manner plain = {.rounds = 1};
    assert_int_equal(manner_pieces(&plain, &line), 1);
    assert_true(manner_piece(&plain, &line, 0).a == 390);
}

static void malformed_forms_are_rejected(void **state)
{
    (void)state;
    static const char *const bad[] = {"1", "1,",  ",2",      "1 2",     "1,2 x",
                                      "=", "!!1", "99999,1", "1,2 / 3", "--1,2"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const glyph letter = {'a', 50, false, false, bad[i]};
        action_plan plan = {.count = 0};
        bool written = true;
        for (size_t k = 0; k < glyph_strokes(&letter); k++) {
            written = written && glyph_write(&letter, k, &place, &plan);
        }
        assert_false(written);
    }
    const glyph good = {'a', 50, false, false, "1,2 !=3,-4 / 5,6 7,8"};
    action_plan plan = {.count = 0};
    assert_true(glyph_write(&good, 0, &place, &plan));
    assert_int_equal(plan.count, 2);
    assert_true(plan.targets[1].corner && plan.targets[1].straight);
    assert_true(glyph_write(&good, 1, &place, &plan));
    assert_int_equal(plan.count, 4);
    assert_false(glyph_write(&good, 2, &place, &plan));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_and_single_plans_give_no_samples),
        cmocka_unit_test(degenerate_targets_stay_finite),
        cmocka_unit_test(full_plans_refuse_targets),
        cmocka_unit_test(straight_movement_has_one_bell_of_speed),
        cmocka_unit_test(pen_passes_the_targets),
        cmocka_unit_test(same_stroke_is_the_same_and_another_differs_a_little),
        cmocka_unit_test(circles_are_round),
        cmocka_unit_test(hooks_come_before_the_stroke),
        cmocka_unit_test(pieces_cover_the_line_and_overlap),
        cmocka_unit_test(malformed_forms_are_rejected),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
