/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "recordings.h"

#define SMALL                                    \
    "# time x y pressure\n"                      \
    "5.000000000000000000e+00 1.5e+01 20 0.0\n"  \
    "5.008000000000000000e+00 1.6e+01 20 0.25\n" \
    "5.016 17 21 0.5\n"                          \
    "5.024 18 22 0\n"                            \
    "\n"                                         \
    "5.032 19 23 0.75\n"

static void zero_pressure_separates_strokes(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(sample_count(drawing), 3);
    assert_near(value_of(drawing, 0, DUCT_X, 0), 16, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 1), 21, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 0), 0, 0);
    assert_near(value_of(drawing, 1, DUCT_T, 0), 0.024, 1e-12);
    assert_near(value_of(drawing, 1, DUCT_PRESSURE, 0), 0.75, 0);
    assert_false(duct_drawing_has(drawing, DUCT_TILT_X));
    duct_drawing_free(drawing);
}

static void six_columns_have_tilt(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("0 1 2 0.5 0.5 -1\n0.01 1 2 0.5 0 0\n");
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 3.141592653589793 / 6, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), -3.141592653589793 / 3, 1e-12);
    duct_drawing_free(drawing);
}

static void other_columns_of_numbers_are_not_taken_for_events(void **state)
{
    (void)state;
    assert_refused("3 1 2 0.5\n2 1 2 0.5\n", NULL, DUCT_BAD_FORMAT, "none of the formats");
    assert_refused("0 1 2 7\n", NULL, DUCT_BAD_FORMAT, "none of the formats");
    assert_refused("0 1 2\n", NULL, DUCT_BAD_FORMAT, "none of the formats");
}

static void empty_files_are_empty_drawings(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text_as("# nothing\n", 10, "mypaint");
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing_free(drawing);
}

static void refuses_malformed_files_by_line(void **state)
{
    (void)state;
    assert_refused("0 1 2 0.5\n1 1 2\n", "mypaint", DUCT_BAD_FORMAT, "line 2");
    assert_refused("0 1 2 0.5 1\n", "mypaint", DUCT_BAD_FORMAT, "line 1");
    assert_refused("0 1 2 nan\n", "mypaint", DUCT_BAD_FORMAT, "line 1");
    assert_refused("0 inf 2 1\n", "mypaint", DUCT_BAD_FORMAT, "line 1");
    assert_refused("0 1e999 2 1\n", "mypaint", DUCT_BAD_FORMAT, "line 1");
    assert_refused("-1e308 1 2 1\n1e308 1 2 1\n", "mypaint", DUCT_BAD_FORMAT, "out of range");
}

static void truncated_changed_and_starved_files_end_well(void **state)
{
    (void)state;
    assert_true(read_all_beginnings(SMALL, strlen(SMALL), "mypaint") > 50);
    read_all_mutations(SMALL, strlen(SMALL), "mypaint", 20000);
    fail_read_allocations(SMALL, strlen(SMALL), "mypaint");
}

static void a_million_samples_in_a_stroke(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    static const char row[] = "0 1 2 0.5\n";
    char *text = malloc(COUNT * (sizeof row - 1));
    assert_non_null(text);
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(text + i * (sizeof row - 1), row, sizeof row - 1);
    }
    duct_drawing *drawing = read_text_as(text, COUNT * (sizeof row - 1), NULL);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), COUNT);
    duct_drawing_free(drawing);
    free(text);
}

static void reads_a_real_recording(void **state)
{
    (void)state;
    duct_drawing *drawing = read_shared("mypaint_events/painting30sec.dat");
    if (drawing != NULL) {
        assert_int_equal(duct_drawing_stroke_count(drawing), 30);
        assert_true(mean_of(drawing, DUCT_PRESSURE) > 0.05 && mean_of(drawing, DUCT_PRESSURE) < 0.546);
        duct_drawing_free(drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zero_pressure_separates_strokes),
        cmocka_unit_test(six_columns_have_tilt),
        cmocka_unit_test(other_columns_of_numbers_are_not_taken_for_events),
        cmocka_unit_test(empty_files_are_empty_drawings),
        cmocka_unit_test(refuses_malformed_files_by_line),
        cmocka_unit_test(truncated_changed_and_starved_files_end_well),
        cmocka_unit_test(a_million_samples_in_a_stroke),
        cmocka_unit_test(reads_a_real_recording),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
