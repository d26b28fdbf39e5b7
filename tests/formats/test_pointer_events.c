/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "recordings.h"

#define ID "pointer-events"
#define DEGREE (3.141592653589793 / 180)

#define EVENT(type, x, y, t, more) \
    "{\"type\":\"pointer" type "\",\"clientX\":" x ",\"clientY\":" y ",\"timeStamp\":" t more "}"
#define SMALL                                                                                                                                                                           \
    "[" EVENT("move", "1", "2", "90", ",\"buttons\":0,\"pressure\":0") "," EVENT("down", "10", "20", "100", ",\"pressure\":0.25,\"tiltX\":30,\"tiltY\":-45,\"twist\":350") ",\n" EVENT( \
        "move", "11", "21", "108.5",                                                                                                                                                    \
        ",\"pressure\":0.5,\"tiltX\":30,\"tiltY\":-45,\"twist\":10") "," EVENT("up", "11", "21", "120",                                                                                 \
                                                                               ",\"pressure\":0") "," EVENT("move",                                                                     \
                                                                                                            "15",                                                                       \
                                                                                                            "25",                                                                       \
                                                                                                            "130",                                                                      \
                                                                                                            "") "," EVENT("down",                                                       \
                                                                                                                          "30",                                                         \
                                                                                                                          "40",                                                         \
                                                                                                                          "200",                                                        \
                                                                                                                          ",\"pressure\":0.75,\"tiltX\":0,\"tiltY\":0,\"twist\":0") "]"

static void types_begin_and_end_strokes(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(sample_count(drawing), 3);
    assert_near(value_of(drawing, 0, DUCT_X, 1), 11, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 20, 0);
    assert_near(value_of(drawing, 0, DUCT_T, 1), 0.0085, 1e-12);
    assert_near(value_of(drawing, 1, DUCT_T, 0), 0.1, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.5, 0);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 30 * DEGREE, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), -45 * DEGREE, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TWIST, 1) - value_of(drawing, 0, DUCT_TWIST, 0), 20 * DEGREE,
                1e-12);
    duct_drawing_free(drawing);
}

static void lines_of_events_are_the_same_as_a_list(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(
        EVENT("down", "1", "1", "0", ",\"pressure\":0.1") "\n" EVENT("move", "2", "2", "8", "") "\r\n" EVENT(
            "up", "2", "2", "9", "") "\n[" EVENT("down", "5", "5", "20",
                                                 "") "]\n[" EVENT("move", "6", "6", "28",
                                                                  ",\"pressure\":0.3") "]");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(sample_count(drawing), 4);
    /* Gaps are filled within a stroke. */
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.1, 0);
    assert_near(value_of(drawing, 1, DUCT_PRESSURE, 0), 0.3, 0);
    duct_drawing_free(drawing);
}

static void columns_of_numbers_are_events(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("{\"id\": 7, \"x\":[1,2,3,4,5],\"y\":[1,1,1,1,1],\"time\":[0,8,16,24,32],"
                  "\"buttons\":[1,1,0,1,1],\"pressure\":[0.5,null,0,0.5,0.5],\"pointerType\":\"pen\"}");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_near(value_of(drawing, 1, DUCT_X, 1), 5, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.5, 0);
    duct_drawing_free(drawing);
}

static void lists_of_points_are_strokes(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("{\"name\":\"a\",\"strokes\":[{\"points\":[{\"x\":1,\"y\":1,\"pressure\":0.5},"
                  "{\"x\":2,\"y\":1,\"pressure\":0.5}]},{\"points\":[{\"x\":3,\"y\":1,\"pressure\":1}]}]}");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 2);
    duct_drawing_free(drawing);
}

static void altitude_and_azimuth_are_preferred_to_rounded_tilt(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("[" EVENT("down", "1", "1", "0",
                            ",\"pressure\":1,\"tiltX\":0,\"tiltY\":29,\"altitudeAngle\":"
                            "1.0471975511965976,\"azimuthAngle\":1.5707963267948966") "]");
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 0, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 30 * DEGREE, 1e-12);
    duct_drawing_free(drawing);
}

static void two_pointers_draw_two_strokes_at_once(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(EVENT("down", "1", "1", "0", ",\"pointerId\":1") EVENT(
        "down", "100", "1", "1", ",\"pointerId\":2") EVENT("move", "2", "1", "8", ",\"pointerId\":1")
                                          EVENT("move", "101", "1", "9", ",\"pointerId\":2")
                                              EVENT("up", "2", "1", "10", ",\"pointerId\":1")
                                                  EVENT("move", "102", "1", "16", ",\"pointerId\":2"));
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 2);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 1)), 3);
    assert_near(value_of(drawing, 1, DUCT_X, 2), 102, 0);
    duct_drawing_free(drawing);
}

static void coalesced_events_stand_for_their_event(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("[" EVENT("down", "1", "1", "0", ",\"pressure\":0.5") "," EVENT(
        "move", "4", "1", "9",
        ",\"pressure\":0.5,\"coalescedEvents\":[" EVENT("move", "3", "1", "6", ",\"pressure\":0.5") "," EVENT(
            "move", "4", "1", "9",
            ",\"pressure\":0.5") "],\"predictedEvents\":[" EVENT("move", "9", "9", "99",
                                                                 ",\"pressure\":0.5") "]") "]");
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    assert_int_equal(sample_count(drawing), 3);
    duct_drawing_free(drawing);
}

static void channels_that_no_device_measured_are_absent(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text("[" EVENT("down", "1", "1", "0",
                            ",\"pointerType\":\"mouse\",\"pressure\":0.5,\"tiltX\":0,\"tiltY\":0,"
                            "\"twist\":0") "]");
    assert_false(duct_drawing_has(drawing, DUCT_PRESSURE));
    assert_false(duct_drawing_has(drawing, DUCT_TILT_X));
    duct_drawing_free(drawing);
    drawing = read_text("[" EVENT("down", "1", "1", "0",
                                  ",\"pressure\":0.5,\"altitudeAngle\":1.5707963267948966,\"azimuthAngle\":0,"
                                  "\"tiltX\":0,\"tiltY\":0,\"twist\":0") "]");
    assert_true(duct_drawing_has(drawing, DUCT_PRESSURE));
    assert_false(duct_drawing_has(drawing, DUCT_TILT_X));
    assert_false(duct_drawing_has(drawing, DUCT_TWIST));
    duct_drawing_free(drawing);
}

static void other_json_is_not_taken_for_events(void **state)
{
    (void)state;
    assert_refused("{\"a\": [1, 2]}", NULL, DUCT_BAD_FORMAT, "none of the formats");
    assert_refused("[1, 2]", ID, DUCT_BAD_FORMAT, "no pointer events");
    assert_refused("[]", ID, DUCT_BAD_FORMAT, "no pointer events");
    assert_refused("", ID, DUCT_BAD_FORMAT, "no pointer events");
    assert_refused("[{\"x\":1,\"y\":2}]", ID, DUCT_BAD_FORMAT, "no pointer events");
    assert_refused("{\"type\":\"excalidraw\",\"elements\":[{\"type\":\"freedraw\",\"x\":1,\"y\":2,"
                   "\"pressures\":[0.5]}]}",
                   ID, DUCT_BAD_FORMAT, "no pointer events");
    assert_refused("{\"settings\":{\"opaque\":{\"inputs\":{\"pressure\":[[0,0],[1,1]]}}}}", NULL,
                   DUCT_BAD_FORMAT, "none of the formats");
}

static void refuses_malformed_json_by_line(void **state)
{
    (void)state;
    assert_refused("[\n{\"x\":1,\n\"y\" 2}]", ID, DUCT_BAD_FORMAT, "line 3: is no well-formed JSON");
    assert_refused("[{\"x\":1}", ID, DUCT_BAD_FORMAT, "ends within");
    assert_refused("[{\"x\":1]}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("{\"x\":nan}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("{\"x\":1e999}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("{\"x\":-Infinity}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("{\"x\":[1,2],\"y\":[1],\"t\":[0,1]}", ID, DUCT_BAD_FORMAT, "equally many");
    assert_refused("{\"x\":[1,\"a\"],\"y\":[1],\"t\":[0,1]}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("{\"a\":\"\n\"}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("{\"a\":\"\\", ID, DUCT_BAD_FORMAT, "ends within");
    assert_refused("{,}", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("]", ID, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("[{\"x\":1,\"y\":2,\"time\":-1e308,\"pressure\":1},{\"x\":1,\"y\":2,\"time\":1.7e308,"
                   "\"pressure\":1}]",
                   ID, DUCT_BAD_FORMAT, "out of range");
}

static void deep_nesting_ends_in_a_sentence(void **state)
{
    (void)state;
    enum { DEPTH = 1000000 };
    static const char *const units[] = {"[", "{\"a\":", "{\"x\":", "[{\"predictedX\":"};
    for (size_t u = 0; u < sizeof units / sizeof units[0]; u++) {
        size_t length = strlen(units[u]);
        char *text = malloc(length * DEPTH + 1);
        assert_non_null(text);
        for (size_t i = 0; i < DEPTH; i++) {
            memcpy(text + i * length, units[u], length + 1);
        }
        assert_refused(text, ID, u == 3 ? DUCT_BAD_FORMAT : DUCT_LIMIT, "line 1");
        free(text);
    }
}

static void truncated_changed_and_starved_files_end_well(void **state)
{
    (void)state;
    static const char columns[] =
        "{\"x\":[1,2],\"y\":[1,1],\"t\":[0,8],\"pressure\":[1,0.5],\"note\":{\"a\":[true,null]}}";
    assert_int_equal(read_all_beginnings(SMALL, strlen(SMALL), ID), strlen(SMALL));
    assert_int_equal(read_all_beginnings(columns, strlen(columns), ID), strlen(columns));
    read_all_mutations(SMALL, strlen(SMALL), ID, 20000);
    read_all_mutations(columns, strlen(columns), ID, 20000);
    fail_read_allocations(SMALL, strlen(SMALL), ID);
    fail_read_allocations(columns, strlen(columns), ID);
}

static void a_million_events_in_a_stroke(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    static const char row[] = "{\"x\":1,\"y\":2,\"pressure\":0.5},";
    char *text = malloc(2 + COUNT * (sizeof row - 1));
    assert_non_null(text);
    text[0] = '[';
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(text + 1 + i * (sizeof row - 1), row, sizeof row - 1);
    }
    text[COUNT * (sizeof row - 1)] = ']';
    duct_drawing *drawing = read_text_as(text, 1 + COUNT * (sizeof row - 1), NULL);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), COUNT);
    duct_drawing_free(drawing);
    free(text);
}

static void reads_a_real_recording(void **state)
{
    (void)state;
    duct_drawing *drawing = read_shared("bdalab_pen_samples/html5_pointer_events/signal.json");
    if (drawing != NULL) {
        assert_true(sample_count(drawing) > 100 && sample_count(drawing) < 233);
        assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 30 * DEGREE, 1e-12);
        assert_true(duct_drawing_has(drawing, DUCT_PRESSURE));
        assert_false(duct_drawing_has(drawing, DUCT_TWIST));
        duct_drawing_free(drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(types_begin_and_end_strokes),
        cmocka_unit_test(lines_of_events_are_the_same_as_a_list),
        cmocka_unit_test(columns_of_numbers_are_events),
        cmocka_unit_test(lists_of_points_are_strokes),
        cmocka_unit_test(altitude_and_azimuth_are_preferred_to_rounded_tilt),
        cmocka_unit_test(two_pointers_draw_two_strokes_at_once),
        cmocka_unit_test(coalesced_events_stand_for_their_event),
        cmocka_unit_test(channels_that_no_device_measured_are_absent),
        cmocka_unit_test(other_json_is_not_taken_for_events),
        cmocka_unit_test(refuses_malformed_json_by_line),
        cmocka_unit_test(deep_nesting_ends_in_a_sentence),
        cmocka_unit_test(truncated_changed_and_starved_files_end_well),
        cmocka_unit_test(a_million_events_in_a_stroke),
        cmocka_unit_test(reads_a_real_recording),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
