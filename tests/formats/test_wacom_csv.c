/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables with the column names of Wacom's Universal Ink, and with units of position. */
#include "recordings.h"

#define SMALL                                                                                 \
    "idx,SPLINE_X,SPLINE_Y,SENSOR_TIMESTAMP,SENSOR_PRESSURE,SENSOR_ALTITUDE,SENSOR_AZIMUTH\n" \
    "0,1.5,2,1722443386312.5,0.07,0.6,0\n"                                                    \
    "0,1.75,2,1722443386312.75,0.11,0.6,0\n"                                                  \
    "1,10,2,1722443388312.25,0.2,0.6,1.5707963267948966\n"

static void universal_ink_names_are_known(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_near(value_of(drawing, 0, DUCT_X, 1), 1.75, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.11, 0);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 1.5707963267948966 - 0.6, 1e-12);
    assert_near(value_of(drawing, 1, DUCT_TILT_Y, 0), 1.5707963267948966 - 0.6, 1e-12);
    duct_drawing_free(drawing);
}

static void timestamps_are_whole_milliseconds_plus_seconds(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_near(value_of(drawing, 0, DUCT_T, 0), 0.5, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0.75, 0);
    assert_near(value_of(drawing, 1, DUCT_T, 0), 2.25, 0);
    duct_drawing_free(drawing);
}

static void positions_may_have_units(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("x_px,y_mm\n5,25.4\n");
    assert_near(value_of(drawing, 0, DUCT_X, 0), 5, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 96, 1e-12);
    duct_drawing_free(drawing);
}

static void a_column_idx_of_other_tables_is_ignored(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("idx,x,y,idx\n0,1,1,a\n1,2,2,b\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_drawing_free(drawing);
}

static void truncated_changed_and_starved_files_end_well(void **state)
{
    (void)state;
    read_all_beginnings(SMALL, strlen(SMALL), "csv");
    read_all_mutations(SMALL, strlen(SMALL), "csv", 20000);
    fail_read_allocations(SMALL, strlen(SMALL), "csv");
}

static void reads_real_pages(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        size_t strokes, samples;
    } files[] = {{"hello_world", 623, 15208}, {"digital_ink", 283, 3631}, {"ink", 4, 880}};
    for (size_t i = 0; i < sizeof files / sizeof files[0]; i++) {
        char name[100];
        snprintf(name, sizeof name, "wacom_digital_ink/%s.csv", files[i].name);
        duct_drawing *drawing = read_shared(name);
        if (drawing == NULL) {
            return;
        }
        assert_int_equal(duct_drawing_stroke_count(drawing), files[i].strokes);
        assert_int_equal(sample_count(drawing), files[i].samples);
        assert_true(duct_drawing_has(drawing, DUCT_TILT_X) && duct_drawing_has(drawing, DUCT_PRESSURE));
        duct_drawing_free(drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(universal_ink_names_are_known),
        cmocka_unit_test(timestamps_are_whole_milliseconds_plus_seconds),
        cmocka_unit_test(positions_may_have_units),
        cmocka_unit_test(a_column_idx_of_other_tables_is_ignored),
        cmocka_unit_test(truncated_changed_and_starved_files_end_well),
        cmocka_unit_test(reads_real_pages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
