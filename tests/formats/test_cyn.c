/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawings.h"

#define HEADER "#\r\nVersion 0.0\r\n#\r\n\r\nphotoshop 5\r\n1\r\nunrelated\r\n\r\n"
#define SMALL                                          \
    HEADER "2\r\nstroke 0\r\n2\r\n"                    \
           "0 0 0.25 0.5 0.5 350 0.5 -0.25\r\n"        \
           "1 0.007 0.26 0.5 0.6 10 0.5 -0.25\r\n\r\n" \
           "stroke 1\r\n1\r\n0 0 0.1 1.1 0.7 20 1 -1\r\n\r\n"

static void reads_units_of_the_recorder(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_near(duct_drawing_width(drawing), 2000, 0);
    assert_near(duct_drawing_height(drawing), 2000, 0);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 1)), "1");
    assert_near(value_of(drawing, 0, DUCT_X, 0), 500, 0);
    assert_near(value_of(drawing, 1, DUCT_Y, 0), 2200, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0.007, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.6, 0);
    assert_near(value_of(drawing, 1, DUCT_TILT_X, 0), 60 * 3.14159265358979 / 180, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 15 * 3.14159265358979 / 180, 1e-12);
    duct_drawing_free(drawing);
}

static void unwraps_twist_across_360_degrees(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    double step = value_of(drawing, 0, DUCT_TWIST, 1) - value_of(drawing, 0, DUCT_TWIST, 0);
    assert_near(step, -20 * 3.14159265358979 / 180, 1e-12);
    duct_drawing_free(drawing);
}

static void reads_the_form_without_header(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("1\nstroke 0\n1\n0 0 0.5 0.5 0.1 0 0 0.5\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    assert_true(duct_drawing_has(drawing, DUCT_TILT_X));
    duct_drawing_free(drawing);
}

static void channels_that_are_0_throughout_are_absent(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("2\nstroke 0\n1\n0 0 0 0 0 0 0 0\nstroke 1\n1\n0 0 1 1 0 0 0 0\n");
    assert_true(duct_drawing_has(drawing, DUCT_T));
    assert_false(duct_drawing_has(drawing, DUCT_PRESSURE));
    assert_false(duct_drawing_has(drawing, DUCT_TWIST));
    assert_false(duct_drawing_has(drawing, DUCT_TILT_X));
    assert_false(duct_drawing_has(drawing, DUCT_TILT_Y));
    duct_drawing_free(drawing);
}

static void empty_recordings_are_drawings(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(HEADER "0\r\n");
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    duct_drawing *back = write_and_read(drawing, "cyn");
    assert_int_equal(duct_drawing_stroke_count(back), 0);
    duct_drawing_free(back);
    duct_drawing_free(drawing);
    drawing = read_text("2\nstroke 0\n0\nstroke 1\n0\n");
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 1)), 0);
    duct_drawing_free(drawing);
}

static void measured_values_are_brought_into_range(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("1\nstroke 0\n3\n0 1 0 0 1.5 0 9 0\n1 0.5 0 0 -1 0 0 0\n2 2 0 0 0.5 0 0 0\n");
    assert_near(value_of(drawing, 0, DUCT_T, 1), 1, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 2), 2, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 1, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0, 0);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 1.5707963267948966, 0);
    duct_drawing_free(drawing);
}

static void refuses_malformed_recordings_by_line(void **state)
{
    (void)state;
    assert_refused("1\nstroke 0\n2\n0 0 0 0 0 0 0 0\n1 0 0 0 x 0 0 0\n", NULL, DUCT_BAD_FORMAT,
                   "line 5: stroke 0");
    assert_refused("1\nstroke 0\n1\n0 0 0 0 0 0 0\nxxxxxx\n", NULL, DUCT_BAD_FORMAT, "number 8");
    assert_refused("1\nstroke 0\n1\n0 0 0 0 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "more than 8");
    assert_refused("1\nstroke 0\n1\n0 0 nan 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "number 3");
    assert_refused("1\nstroke 0\n1\n0 0 inf 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "number 3");
    assert_refused("1\nstroke 0\n1\n0 0 1e999 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "number 3");
    assert_refused("1\nstroke 0\n1\n0 0 1e308 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "out of range");
    assert_refused("1\nstroke 0\n-1\n0 0 0 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "number of samples");
    assert_refused("-1\nstroke 0\n", "cyn", DUCT_BAD_FORMAT, "number of strokes");
    assert_refused("2\nstroke 0\n1\n0 0 0 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "line 4");
    assert_refused("1\nstroke 0\n0\nstroke 1\n0\n", NULL, DUCT_BAD_FORMAT, "nothing is expected");
    assert_refused("#\nVersion 0.0\nphotoshop 5\n", NULL, DUCT_BAD_FORMAT, "number of strokes");
    assert_refused("", "cyn", DUCT_BAD_FORMAT, "number of strokes");
}

static void refuses_huge_counts_before_taking_memory(void **state)
{
    (void)state;
    failing_allocator failing;
    failing_init(&failing, 0);
    assert_refused("1000000000000000000\nstroke 0\n0\n", "cyn", DUCT_BAD_FORMAT, "fewer follow");
    assert_refused("4000000\nstroke 0\n0\n", "cyn", DUCT_BAD_FORMAT, "fewer follow");
    assert_refused("1\nstroke 0\n1000000000000000000\n0 0 0 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT,
                   "line 3: stroke 0");
    assert_refused("1\nstroke 0\n1000000000000000000000\n", NULL, DUCT_BAD_FORMAT, "number of samples");
    assert_refused("1\nstroke 0\n50000000\n0 0 0 0 0 0 0 0\n", NULL, DUCT_BAD_FORMAT, "fewer follow");
}

static void truncated_recordings_are_refused(void **state)
{
    (void)state;
    size_t refused = read_truncated(SMALL, "cyn");
    /* Only the last sample's digits and the line breaks behind it may be missing. */
    assert_true(refused >= strlen(SMALL) - 6);
}

static void round_trip_keeps_the_printed_digits(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 20; seed++) {
        duct_drawing *drawing = random_drawing(seed, 9, true);
        duct_drawing *back = write_and_read(drawing, "cyn");
        assert_int_equal(duct_drawing_stroke_count(back), 9);
        for (size_t i = 0; i < 9; i++) {
            duct_stroke *a = duct_drawing_edit_stroke(drawing, i);
            const duct_stroke *b = duct_drawing_stroke(back, i);
            /* Twist comes back wrapped: whole turns off, the same for the whole stroke. */
            double *twist = duct_stroke_edit(a, DUCT_TWIST);
            double turns = 6.283185307179586 *
                           round((twist[0] - duct_stroke_values(b, DUCT_TWIST)[0]) / 6.283185307179586);
            for (size_t k = 0; k < duct_stroke_size(a); k++) {
                twist[k] -= turns;
            }
            assert_same_values(a, b, 2e-6);
        }
        duct_drawing_free(back);
        duct_drawing_free(drawing);
    }
}

static void missing_channels_are_written_as_0_and_nominal_time(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing;
    duct_stroke *stroke;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    duct_drawing_set_page(drawing, 400, 800);
    assert_ok(duct_drawing_add_stroke(drawing, "a", 2, &stroke, &error));
    duct_stroke_edit(stroke, DUCT_X)[1] = 400;
    duct_stroke_edit(stroke, DUCT_Y)[1] = 800;
    duct_drawing *back = write_and_read(drawing, "cyn");
    assert_near(value_of(back, 0, DUCT_X, 1), 1000, 0); /* scaled by the longer side */
    assert_near(value_of(back, 0, DUCT_Y, 1), 2000, 0);
    assert_near(value_of(back, 0, DUCT_T, 1), 0.007, 0);
    assert_false(duct_drawing_has(back, DUCT_PRESSURE));
    duct_drawing_free(back);
    duct_drawing_set_page(drawing, 0, 0);
    back = write_and_read(drawing, "cyn");
    assert_near(value_of(back, 0, DUCT_Y, 1), 2000, 0); /* without page: by the strokes' box */
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

static void twist_just_below_a_turn_is_not_printed_as_360(void **state)
{
    (void)state;
    duct_drawing *drawing = random_drawing(1, 1, true);
    duct_stroke *stroke = duct_drawing_edit_stroke(drawing, 0);
    assert_true(duct_stroke_size(stroke) > 0);
    duct_stroke_edit(stroke, DUCT_TWIST)[0] = 1e-14;
    duct_error error;
    char *data;
    size_t size;
    assert_ok(duct_drawing_write_memory(NULL, drawing, "cyn", NULL, &data, &size, &error));
    assert_null(strstr(data, " 360 "));
    duct_memory_free(NULL, data);
    duct_drawing_free(drawing);
}

static void a_million_samples_in_a_stroke(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    static const char row[] = "0 0 0.5 0.5 0.5 0 0 0\n";
    char *text = malloc(64 + COUNT * (sizeof row - 1));
    assert_non_null(text);
    size_t size = (size_t)sprintf(text, "1\nstroke 0\n%d\n", COUNT);
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(text + size, row, sizeof row - 1);
        size += sizeof row - 1;
    }
    duct_drawing *drawing = read_text_as(text, size, NULL);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), COUNT);
    duct_drawing_free(drawing);
    free(text);
}

static void mutated_recordings_never_give_values_that_are_not_finite(void **state)
{
    (void)state;
    read_mutated(SMALL, "cyn", 20000);
}

static void failing_allocations_leave_nothing(void **state)
{
    (void)state;
    fail_allocations(SMALL, "cyn");
}

/* Reading and writing a real recording gives its own lines again, but for the header's path and trailing
 * spaces. */
static void real_recordings_are_written_as_they_were(void **state)
{
    (void)state;
    static const char *const names[] = {"SteveEnglish1", "BrendaFlower", "ChikaEnglish1", "LinjieChinese1"};
    const char *folder = shared_data();
    for (size_t n = 0; folder != NULL && n < sizeof names / sizeof names[0]; n++) {
        char path[5000];
        snprintf(path, sizeof path, "%s/helpinghand/%s.cyn", folder, names[n]);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        char *original = calloc(1, 2000000);
        assert_non_null(original);
        assert_true(fread(original, 1, 1999999, file) > 0);
        fclose(file);
        duct_error error;
        duct_drawing *drawing;
        char *data;
        size_t size;
        assert_ok(duct_drawing_read(NULL, path, NULL, &drawing, &error));
        assert_ok(duct_drawing_write_memory(NULL, drawing, "cyn", NULL, &data, &size, &error));
        const char *a = strstr(original, "stroke 0"), *b = strstr(data, "stroke 0");
        assert_non_null(a);
        assert_string_equal(a, b);
        duct_memory_free(NULL, data);
        duct_drawing_free(drawing);
        free(original);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_units_of_the_recorder),
        cmocka_unit_test(unwraps_twist_across_360_degrees),
        cmocka_unit_test(reads_the_form_without_header),
        cmocka_unit_test(channels_that_are_0_throughout_are_absent),
        cmocka_unit_test(empty_recordings_are_drawings),
        cmocka_unit_test(measured_values_are_brought_into_range),
        cmocka_unit_test(refuses_malformed_recordings_by_line),
        cmocka_unit_test(refuses_huge_counts_before_taking_memory),
        cmocka_unit_test(truncated_recordings_are_refused),
        cmocka_unit_test(round_trip_keeps_the_printed_digits),
        cmocka_unit_test(missing_channels_are_written_as_0_and_nominal_time),
        cmocka_unit_test(twist_just_below_a_turn_is_not_printed_as_360),
        cmocka_unit_test(a_million_samples_in_a_stroke),
        cmocka_unit_test(mutated_recordings_never_give_values_that_are_not_finite),
        cmocka_unit_test(failing_allocations_leave_nothing),
        cmocka_unit_test(real_recordings_are_written_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
