/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "recordings.h"

#define DEGREE (3.141592653589793 / 180)
#define UNIT (96 / 25.4 / 20)

/* Two strokes with the pen in the air between them; it leans to the right, 60 degrees above the page. */
#define SMALL                        \
    "5\n"                            \
    "100 200 1000 1 900 600 512\n"   \
    "110 220 1008 1 900 600 1000\n"  \
    "120 220 1015 0 900 600 0\n"     \
    "130 240 1023 1 900 600 700\r\n" \
    "140 240 1030 1 900 600 800\n"

static void pen_up_samples_separate_strokes(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(sample_count(drawing), 4);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 1)), "1");
    duct_drawing_free(drawing);
}

static void integers_are_device_units_with_y_up(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_near(value_of(drawing, 0, DUCT_X, 0), 0, 0);
    assert_near(value_of(drawing, 1, DUCT_X, 1), 40 * UNIT, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 40 * UNIT, 1e-12);
    assert_near(value_of(drawing, 1, DUCT_Y, 1), 0, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0.008, 1e-12);
    assert_near(value_of(drawing, 1, DUCT_T, 0), 0.023, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 0.5, 0);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 30 * DEGREE, 1e-9);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 0, 1e-9);
    duct_drawing_free(drawing);
    /* Fine units: 200 a mm. */
    drawing = read_text("2\n0 0 0 1 900 600 5\n20000 0 8 1 900 600 5\n");
    assert_near(value_of(drawing, 0, DUCT_X, 1), 100 * 96 / 25.4, 1e-9);
    duct_drawing_free(drawing);
}

static void fractions_are_millimetres_seconds_and_unit_pressure(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("2\n1.5 2.5 0.000 1 1800.0 450.0 0.25\n2.5 2.5 0.007 1 1800.0 450.0 1\n");
    assert_near(value_of(drawing, 0, DUCT_X, 1), 96 / 25.4, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0.007, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 0.25, 0);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 0, 1e-9);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 45 * DEGREE, 1e-9); /* azimuth 180: towards the user */
    duct_drawing_free(drawing);
}

static void degrees_and_turned_pens_are_angles_too(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("1\n0 0 0 1 90 -60 0.5\n");
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 30 * DEGREE, 1e-9);
    duct_drawing_free(drawing);
}

/* A pen at azimuth 310 leans away from the writer unless the columns are y and x. */
static void exchanged_columns_are_told_by_the_lean(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("2\n10 100 0 1 3100 450 1\n10 200 8 1 3100 450 1\n");
    assert_near(value_of(drawing, 0, DUCT_X, 1), 100 * UNIT, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_Y, 1), 0, 0);
    assert_true(value_of(drawing, 0, DUCT_TILT_X, 0) > 0 && value_of(drawing, 0, DUCT_TILT_Y, 0) > 0);
    duct_drawing_free(drawing);
}

static void channels_that_are_0_throughout_are_absent(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("1\n0 0 0 1 0 0 0\n");
    assert_false(duct_drawing_has(drawing, DUCT_PRESSURE));
    assert_false(duct_drawing_has(drawing, DUCT_TILT_X));
    assert_true(duct_drawing_has(drawing, DUCT_T));
    duct_drawing_free(drawing);
    drawing = read_text("2\n0 0 0 1\n5 5 10 1\n"); /* four columns */
    assert_false(duct_drawing_has(drawing, DUCT_PRESSURE));
    assert_int_equal(sample_count(drawing), 2);
    duct_drawing_free(drawing);
}

static void the_count_may_be_missing_or_too_small(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("0 0 0 1 900 600 5\n1 1 8 1 900 600 5\n");
    assert_int_equal(sample_count(drawing), 2);
    duct_drawing_free(drawing);
    drawing = read_text("1\n0 0 0 1 900 600 5\n1 1 8 1 900 600 5\n");
    assert_int_equal(sample_count(drawing), 2);
    duct_drawing_free(drawing);
    drawing = read_text_as("0\n", 2, "svc");
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing_free(drawing);
    drawing = read_text("1\n0 0 0 0 900 600 5\n"); /* only in the air */
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing_free(drawing);
}

static void time_that_runs_backwards_stands_still(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("3\n0 0 100 1 900 600 5\n1 1 80 1 900 600 5\n1 1 120 1 900 600 5\n");
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 2), 0.02, 1e-12);
    duct_drawing_free(drawing);
}

static void refuses_malformed_recordings_by_line(void **state)
{
    (void)state;
    assert_refused("", "svc", DUCT_BAD_FORMAT, "number of samples");
    assert_refused("x\n", "svc", DUCT_BAD_FORMAT, "line 1");
    assert_refused("2\n0 0 0 1 900 600 5\n1 1 8 1 900 600\n", "svc", DUCT_BAD_FORMAT, "line 3: sample 1");
    assert_refused("1\n0 0 0 1 900 600 5 6\n", "svc", DUCT_BAD_FORMAT, "line 2");
    assert_refused("1\n0 0 0 2 900 600 5\n", "svc", DUCT_BAD_FORMAT, "button");
    assert_refused("1\n0 0 0 1 nan 600 5\n", "svc", DUCT_BAD_FORMAT, "line 2");
    assert_refused("1\n0 0 0 1 inf 600 5\n", "svc", DUCT_BAD_FORMAT, "line 2");
    assert_refused("1\n0 0 0 1 1e999 600 5\n", "svc", DUCT_BAD_FORMAT, "line 2");
    assert_refused("2\n1e308 0 0 1 900 600 5\n-1e308 0 8 1 900 600 5\n", "svc", DUCT_BAD_FORMAT,
                   "out of range");
    assert_refused("1000000000000000000\n0 0 0 1 900 600 5\n", "svc", DUCT_BAD_FORMAT, "announced");
    assert_refused("1e300\n0 0 0 1 900 600 5\n", "svc", DUCT_BAD_FORMAT, "announced");
}

static void truncated_changed_and_starved_files_end_well(void **state)
{
    (void)state;
    size_t refused = read_all_beginnings(SMALL, strlen(SMALL), "svc");
    assert_true(refused >=
                strlen(SMALL) - 4); /* the last number's digits and the line break may be missing */
    read_all_mutations(SMALL, strlen(SMALL), "svc", 20000);
    fail_read_allocations(SMALL, strlen(SMALL), "svc");
}

static void a_million_samples_in_a_stroke(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    static const char row[] = "100 100 0 1 900 600 512\n";
    char *text = malloc(64 + COUNT * (sizeof row - 1));
    assert_non_null(text);
    size_t size = (size_t)sprintf(text, "%d\n", COUNT);
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(text + size, row, sizeof row - 1);
        size += sizeof row - 1;
    }
    duct_drawing *drawing = read_text_as(text, size, NULL);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), COUNT);
    duct_drawing_free(drawing);
    free(text);
}

static void reads_real_recordings(void **state)
{
    (void)state;
    duct_drawing *drawing = read_shared("bdalab_pen_samples/svc/jack_18-07-2014_M_0006_Doe_12-10-2020.svc");
    if (drawing == NULL) {
        return;
    }
    assert_int_equal(duct_drawing_stroke_count(drawing), 3);
    double box[4];
    assert_true(duct_drawing_bounds(drawing, box));
    assert_near(box[2], 514, 1); /* 136 mm */
    assert_true(mean_of(drawing, DUCT_TILT_X) > 0.1);
    duct_drawing_free(drawing);
    drawing = read_shared("bdalab_pen_samples/svc/signal.svc");
    assert_int_equal(duct_drawing_stroke_count(drawing), 5);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0.007, 1e-9);
    duct_drawing_free(drawing);
    /* A sentence on one line, written by a right hand: wide, and the pen leans to the right and to the user.
     */
    drawing = read_shared("pahaw_subset/HC-female/00026_w.cz.fnusa.9_1.svc");
    assert_true(duct_drawing_bounds(drawing, box));
    assert_true(box[2] > 4 * box[3]);
    assert_true(mean_of(drawing, DUCT_TILT_X) > 0.2 && mean_of(drawing, DUCT_TILT_Y) > 0.2);
    assert_near(mean_of(drawing, DUCT_PRESSURE), 0.5, 0.3);
    duct_drawing_free(drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pen_up_samples_separate_strokes),
        cmocka_unit_test(integers_are_device_units_with_y_up),
        cmocka_unit_test(fractions_are_millimetres_seconds_and_unit_pressure),
        cmocka_unit_test(degrees_and_turned_pens_are_angles_too),
        cmocka_unit_test(exchanged_columns_are_told_by_the_lean),
        cmocka_unit_test(channels_that_are_0_throughout_are_absent),
        cmocka_unit_test(the_count_may_be_missing_or_too_small),
        cmocka_unit_test(time_that_runs_backwards_stands_still),
        cmocka_unit_test(refuses_malformed_recordings_by_line),
        cmocka_unit_test(truncated_changed_and_starved_files_end_well),
        cmocka_unit_test(a_million_samples_in_a_stroke),
        cmocka_unit_test(reads_real_recordings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
