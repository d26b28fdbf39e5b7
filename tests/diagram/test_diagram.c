/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/file.h"
#include "trace_text.h"

#include <ductus/ductus.h>

#include <math.h>
#include <unistd.h>

static const char OUT[] = "diagram-test.svg";

/* Adds a wavy stroke of `size` samples with a pressure that rises from `low` to `high` and a steady twist. */
static duct_stroke *add_wave(duct_drawing *drawing, const char *id, size_t size, double y, double low,
                             double high, double twist)
{
    duct_error error;
    duct_stroke *stroke = NULL;
    assert_ok(duct_drawing_add_stroke(drawing, id, size, &stroke, &error));
    double *xs = duct_stroke_edit(stroke, DUCT_X), *ys = duct_stroke_edit(stroke, DUCT_Y);
    double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE), *turn = duct_stroke_edit(stroke, DUCT_TWIST);
    for (size_t i = 0; i < size; i++) {
        double u = size > 1 ? (double)i / (double)(size - 1) : 0;
        xs[i] = 10 + 200 * u;
        ys[i] = y + 5 * sin(7 * u);
        pressure[i] = low + (high - low) * u;
        turn[i] = twist;
    }
    return stroke;
}

static duct_drawing *new_drawing(void)
{
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    duct_drawing_set_page(drawing, 220, 100);
    return drawing;
}

/* Draws one drawing and gives the SVG; NULL where it was refused with `wanted`. */
static char *draw(const duct_drawing *drawing, const duct_diagram_options *options, duct_status wanted)
{
    duct_error error = {DUCT_OK, ""};
    duct_diagram_panel panel = {.drawing = drawing};
    unlink(OUT);
    duct_status status = duct_diagram_write(NULL, &panel, 1, options, OUT, &error);
    if (status != wanted) {
        fail_msg("%s: %s", duct_status_text(status), error.message);
    }
    if (status != DUCT_OK) {
        assert_true(error.message[0] != '\0');
        assert_int_not_equal(access(OUT, F_OK), 0);
        return NULL;
    }
    char *text = NULL;
    size_t size;
    assert_ok(duct_file_read(duct_allocator_of(NULL), OUT, 1 << 28, &text, &size, &error));
    unlink(OUT);
    return text;
}

static size_t count_of(const char *text, const char *piece)
{
    size_t count = 0;
    for (const char *at = text; (at = strstr(at, piece)) != NULL; at += strlen(piece)) {
        count++;
    }
    return count;
}

static void free_text(char *text)
{
    duct_memory_free(NULL, text);
}

static void colours_run_from_low_to_high(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 60, 20, 0.2, 0.8, 0);
    duct_diagram_options options = duct_diagram_options_default();
    options.low = 0;
    options.high = 1;
    char *text = draw(drawing, &options, DUCT_OK);
    /* 0.6 of 48 colours, each a line of its own. */
    size_t lines = count_of(text, "<polyline");
    assert_true(lines >= 27 && lines <= 31);
    assert_non_null(strstr(text, ">pressure<"));
    assert_non_null(strstr(text, ">0<"));
    assert_non_null(strstr(text, ">1<"));
    options.palette = DUCT_PALETTE_BLUE_RED;
    char *other = draw(drawing, &options, DUCT_OK);
    assert_string_not_equal(text, other);
    free_text(text);
    free_text(other);
    duct_drawing_free(drawing);
}

static void the_range_leaves_out_the_outermost_values(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    duct_stroke *stroke = add_wave(drawing, "a", 500, 20, 0.25, 0.75, 0);
    duct_stroke_edit(stroke, DUCT_PRESSURE)[0] = 0;
    char *text = draw(drawing, NULL, DUCT_OK);
    assert_non_null(strstr(text, ">0.25<"));
    assert_non_null(strstr(text, ">0.74<"));
    free_text(text);
    duct_drawing_free(drawing);
}

static void whole_turns_of_the_barrel_make_no_difference(void **state)
{
    (void)state;
    char *texts[2];
    for (int turns = 0; turns < 2; turns++) {
        duct_drawing *drawing = new_drawing();
        add_wave(drawing, "a", 30, 20, 0.5, 0.5, 0.1);
        add_wave(drawing, "b", 30, 60, 0.5, 0.5, 0.4 + turns * 2 * M_PI);
        duct_diagram_options options = duct_diagram_options_default();
        options.by = DUCT_BY_TWIST;
        texts[turns] = draw(drawing, &options, DUCT_OK);
        duct_drawing_free(drawing);
    }
    assert_string_equal(texts[0], texts[1]);
    assert_non_null(strstr(texts[0], "\xc2\xb0<"));
    free_text(texts[0]);
    free_text(texts[1]);
}

static void a_channel_that_is_missing_is_a_sentence(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    duct_diagram_options options = duct_diagram_options_default();
    draw(drawing, NULL, DUCT_UNSUPPORTED);
    options.by = DUCT_BY_NOTHING;
    free_text(draw(drawing, &options, DUCT_OK));
    duct_stroke *stroke = add_wave(drawing, "a", 30, 20, 0, 1, 0);
    for (int by = DUCT_BY_TILT; by <= DUCT_BY_TILT_Y; by++) {
        options.by = (duct_diagram_by)by;
        draw(drawing, &options, DUCT_UNSUPPORTED);
    }
    options.by = DUCT_BY_SPEED;
    draw(drawing, &options, DUCT_UNSUPPORTED);
    /* Time that stands still is no speed either. */
    assert_non_null(duct_stroke_edit(stroke, DUCT_T));
    draw(drawing, &options, DUCT_UNSUPPORTED);
    options.by = DUCT_BY_SEGMENTS;
    draw(drawing, &options, DUCT_BAD_ARGUMENT);
    duct_drawing_free(drawing);
}

static void a_stroke_without_the_channel_is_grey_among_others(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 30, 20, 0.5, 0.5, 0);
    duct_stroke_drop(add_wave(drawing, "b", 30, 60, 0.5, 0.5, 0), DUCT_PRESSURE);
    char *text = draw(drawing, NULL, DUCT_OK);
    assert_int_equal(count_of(text, "stroke=\"#c7c9cf\""), 1);
    free_text(text);
    duct_drawing_free(drawing);
}

static void speed_is_way_over_time(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    duct_stroke *stroke = add_wave(drawing, "a", 201, 20, 0.5, 0.5, 0);
    double *y = duct_stroke_edit(stroke, DUCT_Y), *t = duct_stroke_edit(stroke, DUCT_T);
    for (size_t i = 0; i < 201; i++) {
        y[i] = 20;
        t[i] = 0.01 * (double)i; /* 200 pixels in 2 seconds */
    }
    duct_diagram_options options = duct_diagram_options_default();
    options.by = DUCT_BY_SPEED;
    char *text = draw(drawing, &options, DUCT_OK);
    assert_int_equal(count_of(text, ">100 pixels/s<"), 2);
    free_text(text);
    duct_drawing_free(drawing);
}

static void degenerate_strokes_are_drawn_as_what_they_are(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "none", 0, 20, 0, 1, 0);
    add_wave(drawing, "one", 1, 20, 0.5, 1, 0);
    duct_stroke *still = add_wave(drawing, "still", 5, 20, 0.5, 1, 0);
    for (int i = 0; i < 5; i++) {
        duct_stroke_edit(still, DUCT_X)[i] = 7;
        duct_stroke_edit(still, DUCT_Y)[i] = 9;
    }
    duct_diagram_options options = duct_diagram_options_default();
    options.nibs = options.needles = true;
    options.width_by_pressure = true;
    char *text = draw(drawing, &options, DUCT_OK);
    assert_int_equal(count_of(text, "<circle"), 2);
    assert_null(strstr(text, "nan"));
    assert_null(strstr(text, "inf"));
    free_text(text);
    duct_drawing_free(drawing);
}

static void hostile_sizes_are_drawn_or_refused(void **state)
{
    (void)state;
    static const double sizes[] = {1e-300, 1e-9, 1e9, 1e150, 1e300, 1.7e308};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        duct_drawing *drawing = new_drawing();
        duct_stroke *stroke = add_wave(drawing, "a", 40, 20, 0.1, 1, 0);
        for (int k = 0; k < 40; k++) {
            duct_stroke_edit(stroke, DUCT_X)[k] = (k % 2 ? -1 : 1) * sizes[i];
        }
        duct_error error = {DUCT_OK, ""};
        duct_diagram_panel panel = {.drawing = drawing};
        duct_status status = duct_diagram_write(NULL, &panel, 1, NULL, OUT, &error);
        assert_true(status == DUCT_OK || status == DUCT_LIMIT);
        unlink(OUT);
        duct_drawing_free(drawing);
    }
}

static void a_million_samples_make_a_small_picture(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 1000000, 20, 0, 1, 0);
    char *text = draw(drawing, NULL, DUCT_OK);
    assert_true(strlen(text) < 50000);
    free_text(text);
    /* A scribble that is a thousand times as long as the page is wide. */
    duct_stroke *stroke = add_wave(drawing, "b", 1000000, 20, 0, 1, 0);
    double *x = duct_stroke_edit(stroke, DUCT_X);
    for (size_t i = 0; i < 1000000; i++) {
        x[i] = 100 + 100 * sin(0.01 * (double)i);
    }
    text = draw(drawing, NULL, DUCT_OK);
    assert_true(strlen(text) < 64u << 20);
    free_text(text);
    duct_drawing_free(drawing);
}

static void options_out_of_range_are_refused(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 30, 20, 0, 1, 0);
    duct_diagram_options good = duct_diagram_options_default(), bad[9];
    for (int i = 0; i < 9; i++) {
        bad[i] = good;
    }
    bad[0].panel_width = 63;
    bad[1].panel_width = NAN;
    bad[2].line_width = 0;
    bad[3].low = NAN;
    bad[4].low = 2;
    bad[4].high = 1;
    bad[5].columns = -1;
    bad[6].scale = 0;
    bad[7].scale = INFINITY;
    bad[8].by = (duct_diagram_by)99;
    for (int i = 0; i < 9; i++) {
        draw(drawing, &bad[i], DUCT_BAD_ARGUMENT);
    }
    duct_diagram_panel panel = {.drawing = drawing};
    duct_error error;
    assert_int_equal(duct_diagram_write(NULL, &panel, 0, NULL, OUT, &error), DUCT_BAD_ARGUMENT);
    assert_int_equal(duct_diagram_write(NULL, &panel, 1, NULL, "x.gif", &error), DUCT_UNSUPPORTED);
    assert_int_equal(duct_diagram_write(NULL, &panel, 1, NULL, "/nonexistent/x.svg", &error), DUCT_NOT_FOUND);
    duct_drawing_free(drawing);
}

static duct_segments *read_trace(void)
{
    duct_error error;
    duct_segments *segments = NULL;
    assert_ok(duct_segments_read_memory(NULL, TRACE, strlen(TRACE), "t", "trajectory", &segments, &error));
    return segments;
}

static void segments_have_colours_of_their_own(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    /* In another order than the trace's, and one that it does not name. */
    add_wave(drawing, "b", 30, 20, 0, 1, 0);
    add_wave(drawing, "a", 30, 50, 0, 1, 0);
    add_wave(drawing, "z", 30, 80, 0, 1, 0);
    duct_segments *segments = read_trace();
    duct_diagram_panel panels[2] = {{.drawing = drawing, .segments = segments, .caption = "one <&> \"two\""},
                                    {.drawing = drawing}};
    duct_diagram_options options = duct_diagram_options_default();
    options.by = DUCT_BY_SEGMENTS;
    duct_error error;
    assert_ok(duct_diagram_write(NULL, panels, 2, &options, OUT, &error));
    char *text = NULL;
    size_t size;
    assert_ok(duct_file_read(duct_allocator_of(NULL), OUT, 1 << 28, &text, &size, &error));
    unlink(OUT);
    /* Three segments of "a", one of "b", grey "z"; and three grey strokes in the panel without a trace. */
    assert_int_equal(count_of(text, "<polyline"), 8);
    assert_int_equal(count_of(text, "stroke=\"#c7c9cf\""), 4);
    assert_non_null(strstr(text, "4 segments, 2 samples each"));
    assert_non_null(strstr(text, "one &lt;&amp;&gt; &quot;two&quot;"));
    free_text(text);
    duct_segments_free(segments);
    duct_drawing_free(drawing);
}

/* A library of two strokes with five and four samples, as the trace's. */
static duct_library *small_library(size_t first)
{
    duct_error error;
    duct_drawing *recording = new_drawing();
    duct_library *library = NULL;
    size_t sizes[] = {first, 4};
    for (int s = 0; s < 2; s++) {
        duct_stroke *stroke = NULL;
        assert_ok(duct_drawing_add_stroke(recording, s == 0 ? "0" : "1", sizes[s], &stroke, &error));
        for (size_t i = 0; i < sizes[s]; i++) {
            duct_stroke_edit(stroke, DUCT_X)[i] = 10 * (double)i;
        }
    }
    const duct_drawing *recordings[] = {recording};
    duct_library_options options = {.unit = 10};
    assert_ok(duct_library_build(NULL, recordings, 1, &options, &library, &error));
    duct_drawing_free(recording);
    return library;
}

static void the_library_is_drawn_beside_if_it_is_the_one(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 30, 20, 0, 1, 0);
    duct_segments *segments = read_trace();
    duct_library *library = small_library(5), *other = small_library(6);
    duct_diagram_options options = duct_diagram_options_default();
    options.by = DUCT_BY_SEGMENTS;
    duct_error error = {DUCT_OK, ""};
    duct_diagram_panel panel = {.drawing = drawing, .segments = segments, .library = other};
    assert_int_equal(duct_diagram_write(NULL, &panel, 1, &options, OUT, &error), DUCT_UNSUPPORTED);
    panel.library = library;
    assert_ok(duct_diagram_write(NULL, &panel, 1, &options, OUT, &error));
    char *text = NULL;
    size_t size;
    assert_ok(duct_file_read(duct_allocator_of(NULL), OUT, 1 << 28, &text, &size, &error));
    unlink(OUT);
    /* Three segments, two library strokes, their four used parts. */
    assert_int_equal(count_of(text, "<polyline"), 3 + 2 + 4);
    free_text(text);
    duct_library_free(library);
    duct_library_free(other);
    duct_segments_free(segments);
    duct_drawing_free(drawing);
}

static void the_same_drawing_gives_the_same_bytes(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 60, 20, 0.2, 0.8, 0);
    char *first = draw(drawing, NULL, DUCT_OK), *second = draw(drawing, NULL, DUCT_OK);
    assert_string_equal(first, second);
    free_text(first);
    free_text(second);
    duct_drawing_free(drawing);
}

static bool stop(void *user, double fraction)
{
    (void)user;
    (void)fraction;
    return false;
}

static void it_can_be_stopped(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 60, 20, 0.2, 0.8, 0);
    duct_context context = duct_context_default();
    context.progress = stop;
    duct_diagram_panel panel = {.drawing = drawing};
    unlink(OUT);
    assert_int_equal(duct_diagram_write(&context, &panel, 1, NULL, OUT, NULL), DUCT_CANCELLED);
    assert_int_not_equal(access(OUT, F_OK), 0);
    duct_drawing_free(drawing);
}

static void every_failed_allocation_is_survived(void **state)
{
    (void)state;
    duct_drawing *drawing = new_drawing();
    add_wave(drawing, "a", 30, 20, 0, 1, 0);
    add_wave(drawing, "b", 1, 20, 0, 1, 0);
    duct_segments *segments = read_trace();
    duct_library *library = small_library(5);
    duct_diagram_panel panel = {.drawing = drawing, .caption = "c", .segments = segments, .library = library};
    duct_diagram_options options = duct_diagram_options_default();
    for (int by = 0; by < 2; by++) {
        options.by = by == 0 ? DUCT_BY_SEGMENTS : DUCT_BY_TWIST;
        options.nibs = true;
        bool done = false;
        for (long n = 1; !done; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            duct_context context = duct_context_default();
            context.allocator = &failing.allocator;
            unlink(OUT);
            duct_status status = duct_diagram_write(&context, &panel, 1, &options, OUT, NULL);
            done = status == DUCT_OK;
            assert_true(done || status == DUCT_NO_MEMORY);
            assert_int_equal(failing.held, 0);
            assert_true(done == (access(OUT, F_OK) == 0));
        }
    }
    unlink(OUT);
    duct_library_free(library);
    duct_segments_free(segments);
    duct_drawing_free(drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(colours_run_from_low_to_high),
        cmocka_unit_test(the_range_leaves_out_the_outermost_values),
        cmocka_unit_test(whole_turns_of_the_barrel_make_no_difference),
        cmocka_unit_test(a_channel_that_is_missing_is_a_sentence),
        cmocka_unit_test(a_stroke_without_the_channel_is_grey_among_others),
        cmocka_unit_test(speed_is_way_over_time),
        cmocka_unit_test(degenerate_strokes_are_drawn_as_what_they_are),
        cmocka_unit_test(hostile_sizes_are_drawn_or_refused),
        cmocka_unit_test(a_million_samples_make_a_small_picture),
        cmocka_unit_test(options_out_of_range_are_refused),
        cmocka_unit_test(segments_have_colours_of_their_own),
        cmocka_unit_test(the_library_is_drawn_beside_if_it_is_the_one),
        cmocka_unit_test(the_same_drawing_gives_the_same_bytes),
        cmocka_unit_test(it_can_be_stopped),
        cmocka_unit_test(every_failed_allocation_is_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
