/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawings.h"

static void columns_come_in_any_order_with_units(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("pressure;Twist_deg;T_ms;y;x;colour;stroke;tilt_x_deg;tilty_rad\n"
                                      "0.5;350;1000;2;1;red;a;45;0.25\n"
                                      "0.6;10;1500;4;3;red;a;-45;0.5\n"
                                      "0.7;0;0;6;5;red;b;0;0\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 1)), "b");
    assert_near(value_of(drawing, 0, DUCT_X, 1), 3, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 1), 4, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 1.5, 0);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 0.7853981633974483, 1e-15);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 0.25, 0);
    assert_near(value_of(drawing, 0, DUCT_TWIST, 1) - value_of(drawing, 0, DUCT_TWIST, 0), 0.3490658503988659,
                1e-12);
    duct_drawing_free(drawing);
}

static void tabs_quotes_comments_and_crlf(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("# made by hand\r\n\"x\"\t\"stroke\"\ty\r\n1\t\"a \"\"b\"\"\tc\"\t2\r\n"
                                      "\"3\"\t\"a \"\"b\"\"\tc\"\t4\t\r\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 0)), "a \"b\"\tc");
    assert_near(value_of(drawing, 0, DUCT_X, 1), 3, 0);
    duct_drawing_free(drawing);
}

static void azimuth_and_altitude_become_tilt(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("x,y,azimuth_deg,altitude_deg\n0,0,0,45\n0,0,90,45\n0,0,180,0\n0,0,0,90\n");
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 0.7853981633974483, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 0, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 1), 0.7853981633974483, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 2), -1.5707963267948966, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 2), 0, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 3), 0, 1e-12);
    duct_drawing_free(drawing);
}

static void without_a_stroke_column_empty_lines_part_strokes(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("x,y\n1,2\n3,4\n\n5,6\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 1)), "1");
    assert_false(duct_drawing_has(drawing, DUCT_T));
    duct_drawing_free(drawing);
}

static void empty_cells_hold_the_value_before_and_absent_channels_stay_absent(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("stroke,x,y,pressure\n0,1,1,\n0,2,2,0.5\n0,3,3,\n0,,,0.9\n1,1,1,\n");
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 3);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 0.5, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 2), 0.5, 0);
    assert_null(duct_stroke_values(duct_drawing_stroke(drawing, 1), DUCT_PRESSURE));
    duct_drawing_free(drawing);
}

static void empty_tables_are_drawings(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("x,y\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing *back = write_and_read(drawing, "csv");
    assert_int_equal(duct_drawing_stroke_count(back), 0);
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

static void refuses_malformed_tables_by_line(void **state)
{
    (void)state;
    assert_refused("x,y\n1,2\n1,z\n", NULL, DUCT_BAD_FORMAT, "line 3: column 2");
    assert_refused("x,y\n1,nan\n", NULL, DUCT_BAD_FORMAT, "line 2: column 2");
    assert_refused("x,y\n1,inf\n", NULL, DUCT_BAD_FORMAT, "line 2: column 2");
    assert_refused("x,y\n1,1e999\n", NULL, DUCT_BAD_FORMAT, "line 2: column 2");
    assert_refused("x,y\n1,2,3\n", NULL, DUCT_BAD_FORMAT, "more cells");
    assert_refused("x,y\n1\n", NULL, DUCT_BAD_FORMAT, "one of x and y");
    assert_refused("x,y\n\"1,2\n", NULL, DUCT_BAD_FORMAT, "does not end");
    assert_refused("x,y,x\n", "csv", DUCT_BAD_FORMAT, "two columns");
    assert_refused("a,b\n1,2\n", "csv", DUCT_BAD_FORMAT, "columns x and y");
    assert_refused("", "csv", DUCT_BAD_FORMAT, "columns x and y");
}

static void round_trip_is_exact_for_all_channel_sets(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 40; seed++) {
        duct_drawing *drawing = random_drawing(seed, 20, false);
        duct_drawing *back = write_and_read(drawing, "csv");
        assert_int_equal(duct_drawing_stroke_count(back), 20);
        for (size_t i = 0; i < 20; i++) {
            const duct_stroke *a = duct_drawing_stroke(drawing, i), *b = duct_drawing_stroke(back, i);
            assert_same_values(a, b, 0);
            assert_string_equal(duct_stroke_id(a), duct_stroke_id(b));
        }
        duct_drawing_free(back);
        duct_drawing_free(drawing);
    }
}

static void ids_with_delimiters_survive_and_doubtful_ids_become_indices(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = random_drawing(3, 3, true);
    assert_ok(duct_stroke_set_id(duct_drawing_edit_stroke(drawing, 1), "a,\"b\"\n c", &error));
    duct_drawing *back = write_and_read(drawing, "csv");
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(back, 1)), "a,\"b\"\n c");
    duct_drawing_free(back);
    assert_ok(duct_stroke_set_id(duct_drawing_edit_stroke(drawing, 2), "a,\"b\"\n c", &error));
    back = write_and_read(drawing, "csv");
    assert_int_equal(duct_drawing_stroke_count(back), 3);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(back, 2)), "2");
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

static const char small[] = "stroke,x,y,t,pressure\n\"a\",1,2,0,0.5\na,3,4,1,0.25\nb,5,6,0,\n";

static void truncated_and_mutated_tables_do_no_harm(void **state)
{
    (void)state;
    assert_true(read_truncated(small, "csv") > 8);
    read_mutated(small, "csv", 20000);
}

static void failing_allocations_leave_nothing(void **state)
{
    (void)state;
    fail_allocations(small, "csv");
}

static void a_million_samples_in_a_stroke(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    char *text = malloc(16 + COUNT * 4);
    assert_non_null(text);
    strcpy(text, "x,y\n");
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(text + 4 + 4 * i, "1,2\n", 4);
    }
    duct_drawing *drawing = read_text_as(text, 4 + 4 * (size_t)COUNT, NULL);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), COUNT);
    duct_drawing_free(drawing);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_come_in_any_order_with_units),
        cmocka_unit_test(tabs_quotes_comments_and_crlf),
        cmocka_unit_test(azimuth_and_altitude_become_tilt),
        cmocka_unit_test(without_a_stroke_column_empty_lines_part_strokes),
        cmocka_unit_test(empty_cells_hold_the_value_before_and_absent_channels_stay_absent),
        cmocka_unit_test(empty_tables_are_drawings),
        cmocka_unit_test(refuses_malformed_tables_by_line),
        cmocka_unit_test(round_trip_is_exact_for_all_channel_sets),
        cmocka_unit_test(ids_with_delimiters_survive_and_doubtful_ids_become_indices),
        cmocka_unit_test(truncated_and_mutated_tables_do_no_harm),
        cmocka_unit_test(failing_allocations_leave_nothing),
        cmocka_unit_test(a_million_samples_in_a_stroke),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
