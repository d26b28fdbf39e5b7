/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/file.h"
#include "picture/picture.h"

#include <ductus/format.h>
#include <ductus/image.h>

#include <math.h>
#include <unistd.h>

static char folder[] = "/tmp/ductus-picture-XXXXXX";

static const char *place(const char *name)
{
    static char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) != NULL ? 0 : -1;
}

static int remove_folder(void **state)
{
    (void)state;
    static const char *const names[] = {"a.svg", "a.png", "b.png"};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        unlink(place(names[i]));
    }
    return rmdir(folder);
}

static const duct_ink red = {1, 0, 0, 1}, green = {0, 1, 0, 1}, blue = {0, 0, 1, 1}, faint = {0, 0, 0, 0.5f};

/* One of each shape on white, 100 x 80. */
static void draw_all(duct_picture *picture)
{
    duct_picture_rectangle(picture, 0, 0, 100, 80, (duct_ink){1, 1, 1, 1});
    duct_picture_rectangle(picture, 10, 10, 20, 20, red);
    duct_picture_polygon(picture, (double[]){40, 60, 50}, (double[]){10, 10, 30}, 3, green);
    duct_picture_line(picture, 10, 50, 90, 50, 6, blue);
    duct_picture_circle(picture, 80, 20, 8, faint);
    duct_picture_segments(picture, (double[]){10, 30, 50, 70}, (double[]){65, 65, 65, 65}, 4,
                          (double[]){4, 4, 8}, 0, (duct_ink[]){red, red, green});
    duct_picture_text(picture, 95, 78, 8, DUCT_TEXT_END, 0, blue, "a < b & \"c\"");
}

static duct_picture *new_picture(double width, double height)
{
    duct_error error;
    duct_picture *picture = NULL;
    assert_ok(duct_picture_new(NULL, width, height, &picture, &error));
    return picture;
}

static char *svg_of(const duct_picture *picture)
{
    duct_error error;
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    assert_ok(duct_picture_svg(picture, 1, &text, &error));
    return duct_text_take(&text, NULL);
}

static void svg_holds_every_shape_and_escapes_text(void **state)
{
    (void)state;
    duct_picture *picture = new_picture(100, 80);
    draw_all(picture);
    char *svg = svg_of(picture), *again = svg_of(picture);
    assert_string_equal(svg, again);
    assert_non_null(strstr(svg, "viewBox=\"0 0 100 80\""));
    assert_non_null(strstr(svg, "<polygon points=\"10,10 30,10 30,30 10,30\" fill=\"#ff0000\"/>"));
    assert_non_null(
        strstr(svg, "<circle cx=\"80\" cy=\"20\" r=\"8\" fill=\"#000000\" fill-opacity=\"0.5\"/>"));
    assert_non_null(strstr(svg, ">a &lt; b &amp; &quot;c&quot;</text>"));
    duct_memory_free(NULL, svg);
    duct_memory_free(NULL, again);
    duct_picture_free(picture);
}

static void neighbouring_segments_that_are_alike_become_one_line(void **state)
{
    (void)state;
    duct_picture *picture = new_picture(100, 80);
    draw_all(picture);
    char *svg = svg_of(picture);
    assert_non_null(strstr(svg, "points=\"10,65 30,65 50,65\" stroke=\"#ff0000\" stroke-width=\"4\""));
    assert_non_null(strstr(svg, "points=\"50,65 70,65\" stroke=\"#00ff00\" stroke-width=\"8\""));
    duct_memory_free(NULL, svg);
    duct_picture_free(picture);
}

static void empty_and_degenerate_shapes_leave_nothing_behind(void **state)
{
    (void)state;
    double bad[] = {NAN, INFINITY, -INFINITY};
    duct_picture *picture = new_picture(10, 10);
    char *empty = svg_of(picture);
    duct_picture_polyline(picture, bad, bad, 3, 1, red);
    duct_picture_polyline(picture, bad, bad, 0, 1, red);
    duct_picture_polyline(picture, (double[]){1, 2}, (double[]){1, 2}, 2, 0, red);
    duct_picture_polyline(picture, (double[]){1, 2}, (double[]){1, 2}, 2, NAN, red);
    duct_picture_polygon(picture, (double[]){1, 2}, (double[]){1, 2}, 2, red);
    duct_picture_circle(picture, 1, 1, -1, red);
    duct_picture_circle(picture, NAN, 1, 1, red);
    duct_picture_text(picture, 1, 1, 0, DUCT_TEXT_START, 0, red, "x");
    duct_picture_text(picture, 1, 1, 9, DUCT_TEXT_START, NAN, red, "x");
    duct_picture_segments(picture, bad, bad, 1, NULL, 1, NULL);
    duct_picture_segments(picture, bad, bad, 0, NULL, 1, NULL);
    char *svg = svg_of(picture);
    assert_string_equal(svg, empty);
    duct_memory_free(NULL, svg);
    duct_memory_free(NULL, empty);
    duct_picture_free(picture);
}

static void assert_pixel(const duct_image *image, int x, int y, float r, float g, float b)
{
    const float *pixel = image->pixels + ((size_t)y * (size_t)image->width + (size_t)x) * 4;
    assert_float_equal(pixel[0], r, 0.02);
    assert_float_equal(pixel[1], g, 0.02);
    assert_float_equal(pixel[2], b, 0.02);
    assert_float_equal(pixel[3], 1, 0.001);
}

static void png_has_the_shapes_where_they_were_drawn(void **state)
{
    (void)state;
    duct_error error;
    duct_picture *picture = new_picture(100, 80);
    draw_all(picture);
    assert_ok(duct_picture_write(NULL, picture, place("a.png"), 2, &error));
    duct_image image;
    assert_ok(duct_image_read(NULL, place("a.png"), &image, &error));
    assert_int_equal(image.width, 200);
    assert_int_equal(image.height, 160);
    assert_pixel(&image, 2, 2, 1, 1, 1);
    assert_pixel(&image, 40, 40, 1, 0, 0);
    assert_pixel(&image, 100, 30, 0, 1, 0);
    assert_pixel(&image, 100, 100, 0, 0, 1);
    assert_pixel(&image, 160, 40, 0.5f, 0.5f, 0.5f);
    assert_pixel(&image, 60, 130, 1, 0, 0);
    assert_pixel(&image, 130, 136, 0, 1, 0);
    duct_image_free(NULL, &image);
    duct_picture_free(picture);
}

static void same_picture_gives_the_same_png(void **state)
{
    (void)state;
    duct_error error;
    duct_picture *picture = new_picture(100, 80);
    draw_all(picture);
    char *data[2];
    size_t size[2];
    static const char *const names[] = {"a.png", "b.png"};
    for (size_t i = 0; i < 2; i++) {
        assert_ok(duct_picture_write(NULL, picture, place(names[i]), 1, &error));
        assert_ok(
            duct_file_read(duct_allocator_of(NULL), place(names[i]), 1 << 20, &data[i], &size[i], &error));
    }
    assert_int_equal(size[0], size[1]);
    assert_memory_equal(data[0], data[1], size[0]);
    duct_memory_free(NULL, data[0]);
    duct_memory_free(NULL, data[1]);
    duct_picture_free(picture);
}

static void svg_file_is_written_whole(void **state)
{
    (void)state;
    duct_error error;
    duct_picture *picture = new_picture(100, 80);
    draw_all(picture);
    assert_ok(duct_picture_write(NULL, picture, place("a.svg"), 1, &error));
    char *svg = svg_of(picture), *data;
    size_t size;
    assert_ok(duct_file_read(duct_allocator_of(NULL), place("a.svg"), 1 << 20, &data, &size, &error));
    assert_string_equal(data, svg);
    duct_memory_free(NULL, data);
    duct_memory_free(NULL, svg);
    duct_picture_free(picture);
}

static void impossible_pictures_are_refused_with_a_sentence(void **state)
{
    (void)state;
    duct_error error;
    duct_picture *picture = NULL;
    static const double sides[] = {0, -1, NAN, INFINITY, 40000};
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        assert_int_equal(duct_picture_new(NULL, sides[i], 10, &picture, &error), DUCT_LIMIT);
        assert_null(picture);
    }
    picture = new_picture(1000, 10);
    assert_int_equal(duct_picture_write(NULL, picture, place("c.png"), 100, &error), DUCT_LIMIT);
    assert_non_null(strstr(error.message, "100000 pixels"));
    assert_false(duct_file_exists(place("c.png")));
    assert_int_equal(duct_picture_write(NULL, picture, place("c.png"), NAN, &error), DUCT_BAD_ARGUMENT);
    assert_int_equal(duct_picture_write(NULL, picture, place("c.gif"), 1, &error), DUCT_UNSUPPORTED);
    assert_int_equal(duct_picture_write(NULL, picture, folder, 1, &error), DUCT_UNSUPPORTED);
    assert_int_equal(duct_picture_write(NULL, picture, "/nowhere/a.png", 1, &error), DUCT_NOT_FOUND);
    duct_picture_free(picture);
    duct_picture_free(NULL);
}

static void missing_module_is_named(void **state)
{
    (void)state;
    duct_error error;
    duct_picture *picture = new_picture(10, 10);
    setenv("DUCTUS_MODULE_FOLDER", folder, 1);
    duct_status status = duct_picture_write(NULL, picture, place("c.png"), 1, &error);
    unsetenv("DUCTUS_MODULE_FOLDER");
    assert_int_equal(status, DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "ductus-picture.so"));
    assert_false(duct_file_exists(place("c.png")));
    duct_picture_free(picture);
}

static void every_failing_allocation_is_reported_and_leaves_nothing(void **state)
{
    (void)state;
    duct_error error;
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK && n < 1000; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_picture *picture = NULL;
        status = duct_picture_new(&context, 100, 80, &picture, &error);
        if (status == DUCT_OK) {
            draw_all(picture);
            status = duct_picture_write(&context, picture, place("a.svg"), 1, &error);
        }
        if (status == DUCT_OK) {
            status = duct_picture_write(&context, picture, place("a.png"), 1, &error);
        }
        duct_picture_free(picture);
        assert_int_equal(failing.held, 0);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
    }
    assert_int_equal(status, DUCT_OK);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(svg_holds_every_shape_and_escapes_text),
        cmocka_unit_test(neighbouring_segments_that_are_alike_become_one_line),
        cmocka_unit_test(empty_and_degenerate_shapes_leave_nothing_behind),
        cmocka_unit_test(png_has_the_shapes_where_they_were_drawn),
        cmocka_unit_test(same_picture_gives_the_same_png),
        cmocka_unit_test(svg_file_is_written_whole),
        cmocka_unit_test(impossible_pictures_are_refused_with_a_sentence),
        cmocka_unit_test(missing_module_is_named),
        cmocka_unit_test(every_failing_allocation_is_reported_and_leaves_nothing),
    };
    return cmocka_run_group_tests_name("picture", tests, make_folder, remove_folder);
}
