/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "recordings.h"

#include "formats/gzip.h"

#include <zlib.h>

#define HEAD \
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<xournal creator=\"Xournal++ 1.2\" fileversion=\"4\">\n"
#define PAGE \
    "<page width=\"600\" height=\"300\"><background type=\"solid\" color=\"#ffffffff\" style=\"plain\"/>"
#define TAIL "</layer></page></xournal>"
#define SMALL                                                                                             \
    HEAD "<title>notes</title>" PAGE "<layer name=\"sketch\">"                                            \
         "<stroke tool=\"pen\" color=\"#3333ccff\" width=\"2 1 0.5 2\" capStyle=\"round\">"               \
         "30 60 60 60 90 75</stroke><text font=\"Sans\" x=\"1\" y=\"2\">hello</text>"                     \
         "<stroke tool=\"highlighter\" color=\"#ffff007f\" width=\"8\">0 0 10 10</stroke></layer></page>" \
         "<page width=\"450\" height=\"150\"><layer/><layer>"                                             \
         "<stroke tool=\"pen\" color=\"red\" width=\"1.5\">3 3</stroke>" TAIL

static size_t pack(const char *data, size_t size, char *packed, size_t room)
{
    z_stream stream = {0};
    assert_int_equal(deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
    char *copy = malloc(size);
    assert_non_null(copy);
    memcpy(copy, data, size);
    stream.next_in = (Bytef *)copy;
    stream.avail_in = (uInt)size;
    stream.next_out = (Bytef *)packed;
    stream.avail_out = (uInt)room;
    assert_int_equal(deflate(&stream, Z_FINISH), Z_STREAM_END);
    size_t length = room - stream.avail_out;
    deflateEnd(&stream);
    free(copy);
    return length;
}

static void strokes_have_colour_width_pressure_and_page(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 3);
    assert_near(value_of(drawing, 0, DUCT_X, 1), 80, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_Y, 2), 100, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 0.5, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.25, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 2), 1, 0);
    duct_stroke_style style = duct_stroke_get_style(duct_drawing_stroke(drawing, 0));
    assert_near(style.width, 2 * 96.0 / 72, 1e-12);
    assert_near((double)style.blue, 0.8, 1e-6);
    assert_near((double)style.opacity, 1, 0);
    style = duct_stroke_get_style(duct_drawing_stroke(drawing, 1));
    assert_near((double)style.opacity, 127.0 / 255, 1e-6);
    assert_null(duct_stroke_values(duct_drawing_stroke(drawing, 1), DUCT_PRESSURE));
    assert_false(duct_drawing_has(drawing, DUCT_T));
    duct_drawing_free(drawing);
}

static void pages_lie_below_each_other_and_layers_are_groups(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SMALL);
    assert_near(duct_drawing_width(drawing), 800, 1e-9);
    assert_near(duct_drawing_height(drawing), 600, 1e-9);
    assert_near(value_of(drawing, 2, DUCT_Y, 0), 404, 1e-9);
    assert_string_equal(duct_stroke_group(duct_drawing_stroke(drawing, 0)), "page 1/sketch");
    assert_string_equal(duct_stroke_group(duct_drawing_stroke(drawing, 2)), "page 2/layer 2");
    duct_drawing_free(drawing);
}

static void xournal_has_a_width_a_segment_and_names_of_colours(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(
        "<xournal version=\"0.4.8\"><page width=\"612\" height=\"792\"><layer>"
        "<stroke tool=\"highlighter\" color=\"lightblue\" width=\"2 2.5 1\">1 1 2 2 3 3</stroke>" TAIL);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 1, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.4, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 2), 0.4, 1e-12);
    duct_stroke_style style = duct_stroke_get_style(duct_drawing_stroke(drawing, 0));
    assert_near((double)style.green, 192.0 / 255, 1e-6);
    assert_near((double)style.opacity, 0.5, 0);
    duct_drawing_free(drawing);
}

static void widths_that_do_not_fit_the_points_are_no_pressure(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(HEAD PAGE "<layer><stroke width=\"2 1\">1 1 2 2 3 3</stroke>"
                                                "<stroke width=\"2 nan nan\">1 1 2 2</stroke>"
                                                "<stroke width=\"0 1 1\">1 1 2 2</stroke>"
                                                "<stroke>1 1 2 2</stroke><stroke width=\"1\"></stroke>" TAIL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 5);
    assert_false(duct_drawing_has(drawing, DUCT_PRESSURE));
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 4)), 0);
    duct_drawing_free(drawing);
}

static void packed_notes_are_the_same_drawing(void **state)
{
    (void)state;
    char packed[4096];
    size_t size = pack(SMALL, strlen(SMALL), packed, sizeof packed / 2);
    duct_drawing *plain = read_text(SMALL), *unpacked = read_text_as(packed, size, NULL);
    assert_int_equal(duct_drawing_stroke_count(unpacked), 3);
    for (size_t i = 0; i < 3; i++) {
        assert_same_values(duct_drawing_stroke(plain, i), duct_drawing_stroke(unpacked, i), 0);
    }
    duct_drawing_free(unpacked);
    duct_drawing_free(plain);
    /* gzip allows several members one after the other. */
    size_t half = strlen(SMALL) / 2;
    size = pack(SMALL, half, packed, 2048);
    size += pack(SMALL + half, strlen(SMALL) - half, packed + size, sizeof packed - size);
    unpacked = read_text_as(packed, size, NULL);
    assert_int_equal(duct_drawing_stroke_count(unpacked), 3);
    duct_drawing_free(unpacked);
}

static void other_compressed_files_are_not_taken_for_notes(void **state)
{
    (void)state;
    static const char svg[] = "<svg xmlns=\"http://www.w3.org/2000/svg\"/>";
    char packed[1024];
    duct_error error;
    duct_drawing *drawing = NULL;
    size_t size = pack(svg, strlen(svg), packed, sizeof packed);
    assert_int_not_equal(duct_drawing_read_memory(NULL, packed, size, "a", NULL, NULL, &drawing, &error),
                         DUCT_OK);
    assert_non_null(strstr(error.message, "SVGZ"));
    assert_int_equal(duct_drawing_read_memory(NULL, packed, size, "a", "xopp", NULL, &drawing, &error),
                     DUCT_BAD_FORMAT);
    assert_non_null(strstr(error.message, "<svg> instead of <xournal>"));
}

static void refuses_malformed_notes_by_line(void **state)
{
    (void)state;
    assert_refused(HEAD "<page height=\"3\"/></xournal>", NULL, DUCT_BAD_FORMAT, "line 3: page 1: its width");
    assert_refused(HEAD "<page width=\"1\" height=\"-3\"/></xournal>", NULL, DUCT_BAD_FORMAT, "height");
    assert_refused(HEAD "<page width=\"1\" height=\"inf\"/></xournal>", NULL, DUCT_BAD_FORMAT, "height");
    assert_refused(HEAD "<page width=\"1.7e308\" height=\"1\"/></xournal>", NULL, DUCT_BAD_FORMAT,
                   "too large");
    assert_refused(HEAD PAGE "<layer><stroke width=\"1\">1 2 3</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "line 3: stroke 0: the last point's y");
    assert_refused(HEAD PAGE "<layer><stroke width=\"1\">1 nan</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "no number");
    assert_refused(HEAD PAGE "<layer><stroke width=\"1\">1 1e999</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "no number");
    assert_refused(HEAD PAGE "<layer><stroke width=\"1\">1 1.7e308</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "out of range");
    assert_refused(HEAD PAGE "<layer><stroke width=\"\">1 1</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "no width");
    assert_refused(HEAD PAGE "<layer><stroke width=\"-1\">1 1</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "no width");
    assert_refused(HEAD PAGE "<layer><stroke width=\"1.7e308\">1 1</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "out of range");
    assert_refused(HEAD PAGE "<layer><stroke color=\"#12\">1 1</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "colour");
    assert_refused(HEAD PAGE "<layer><stroke color=\"mauve\">1 1</stroke>" TAIL, NULL, DUCT_BAD_FORMAT,
                   "mauve");
    assert_refused(HEAD "<page", NULL, DUCT_BAD_FORMAT, "well-formed");
    assert_refused("<svg/>", "xopp", DUCT_BAD_FORMAT, "<svg> instead of <xournal>");
    assert_refused(
        "<!DOCTYPE xournal [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;&a;&a;\">"
        "<!ENTITY c \"&b;&b;&b;&b;&b;&b;&b;&b;&b;&b;\"><!ENTITY d \"&c;&c;&c;&c;&c;&c;&c;&c;&c;&c;\">]>"
        "<xournal><page width=\"&d;&d;\" height=\"1\"/></xournal>",
        NULL, DUCT_LIMIT, "entities");
}

static void deep_nesting_ends_in_a_sentence(void **state)
{
    (void)state;
    enum { DEPTH = 100000 };
    char *text = malloc(16 + 3 * DEPTH);
    assert_non_null(text);
    strcpy(text, "<xournal>");
    for (size_t i = 0; i < DEPTH; i++) {
        memcpy(text + 9 + 3 * i, "<a>", 4);
    }
    assert_refused(text, NULL, DUCT_LIMIT, "nested");
    free(text);
}

/* A megabyte that unpacks to a thousand of them. */
static void a_bomb_stops_at_the_limit(void **state)
{
    (void)state;
    enum { SIZE = 1 << 20 };
    char *zeros = calloc(1, SIZE), *packed = malloc(SIZE);
    assert_true(zeros != NULL && packed != NULL);
    size_t size = pack(zeros, SIZE, packed, SIZE);
    duct_allocator allocator = *duct_allocator_of(NULL);
    duct_error error;
    char *unpacked = NULL;
    size_t length = 0;
    assert_int_equal(duct_gzip_unpack(&allocator, packed, size, SIZE - 1, &unpacked, &length, &error),
                     DUCT_LIMIT);
    assert_null(unpacked);
    assert_ok(duct_gzip_unpack(&allocator, packed, size, SIZE, &unpacked, &length, &error));
    assert_int_equal(length, SIZE);
    assert_int_equal(unpacked[SIZE], 0);
    duct_release(&allocator, unpacked);
    /* 600 members of a mebibyte each, as a file. */
    char *bomb = malloc(600 * size);
    assert_non_null(bomb);
    for (size_t i = 0; i < 600; i++) {
        memcpy(bomb + i * size, packed, size);
    }
    duct_drawing *drawing = NULL;
    assert_int_equal(duct_drawing_read_memory(NULL, bomb, 600 * size, "bomb", "xopp", NULL, &drawing, &error),
                     DUCT_LIMIT);
    assert_non_null(strstr(error.message, "when unpacked"));
    free(bomb);
    free(packed);
    free(zeros);
}

static void truncated_changed_and_starved_files_end_well(void **state)
{
    (void)state;
    char packed[4096];
    size_t size = pack(SMALL, strlen(SMALL), packed, sizeof packed);
    assert_int_equal(read_all_beginnings(SMALL, strlen(SMALL), "xopp"), strlen(SMALL));
    assert_int_equal(read_all_beginnings(packed, size, "xopp"), size);
    read_all_mutations(SMALL, strlen(SMALL), "xopp", 5000);
    read_all_mutations(packed, size, "xopp", 5000);
    read_all_mutations(packed, size, NULL, 5000);
    fail_read_allocations(SMALL, strlen(SMALL), "xopp");
    fail_read_allocations(packed, size, "xopp");
}

static void a_million_points_in_a_stroke(void **state)
{
    (void)state;
    enum { COUNT = 1000000 };
    static const char head[] = HEAD PAGE "<layer><stroke color=\"black\" width=\"1\">";
    char *text = malloc(sizeof head + 4 * COUNT + 64);
    assert_non_null(text);
    strcpy(text, head);
    for (size_t i = 0; i < COUNT; i++) {
        memcpy(text + sizeof head - 1 + 4 * i, "1 2 ", 5);
    }
    strcpy(text + sizeof head - 1 + 4 * (size_t)COUNT, "</stroke>" TAIL);
    duct_drawing *drawing = read_text(text);
    assert_int_equal(sample_count(drawing), COUNT);
    duct_drawing_free(drawing);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(strokes_have_colour_width_pressure_and_page),
        cmocka_unit_test(pages_lie_below_each_other_and_layers_are_groups),
        cmocka_unit_test(xournal_has_a_width_a_segment_and_names_of_colours),
        cmocka_unit_test(widths_that_do_not_fit_the_points_are_no_pressure),
        cmocka_unit_test(packed_notes_are_the_same_drawing),
        cmocka_unit_test(other_compressed_files_are_not_taken_for_notes),
        cmocka_unit_test(refuses_malformed_notes_by_line),
        cmocka_unit_test(deep_nesting_ends_in_a_sentence),
        cmocka_unit_test(a_bomb_stops_at_the_limit),
        cmocka_unit_test(truncated_changed_and_starved_files_end_well),
        cmocka_unit_test(a_million_points_in_a_stroke),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
