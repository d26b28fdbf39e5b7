/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "image/image_private.h"

/* Start, a segment that holds a whole thumbnail, a scan with a stuffed byte and a restart marker, a table, a
 * second scan, the end, and something behind it. */
static const unsigned char file[] = {
    0xff, 0xd8, 0xff, 0xe1, 0,    8, 0xff, 0xd8, 0xff, 0xd9, 1, 2, 0xff, 0xda, 0,    3,    9, 5, 0xff, 0, 6,
    0xff, 0xd0, 7,    0xff, 0xc4, 0, 2,    0xff, 0xff, 0xda, 0, 2, 8,    9,    0xff, 0xd9, 1, 2};
enum { END = 37 };

static void whole_file_is_whole(void **state)
{
    (void)state;
    assert_false(duct_image_truncated(file, sizeof file));
    assert_false(duct_image_truncated(file, END));
}

static void every_cut_is_seen(void **state)
{
    (void)state;
    for (size_t size = 3; size < END; size++) {
        unsigned char *copy = malloc(size); /* reading behind the end would be caught */
        assert_non_null(copy);
        memcpy(copy, file, size);
        assert_true(duct_image_truncated(copy, size));
        free(copy);
    }
}

static void every_cut_png_is_seen(void **state)
{
    (void)state;
    static const unsigned char png[] = "\x89PNG\r\n\x1a\n\0\0\0\2IHDRab\1\2\3\4\0\0\0\0IEND\5\6\7\10 more";
    enum { whole = 8 + 14 + 12 };
    assert_false(duct_image_truncated(png, whole));
    assert_false(duct_image_truncated(png, sizeof png));
    for (size_t size = 8; size < whole; size++) {
        unsigned char *copy = malloc(size);
        assert_non_null(copy);
        memcpy(copy, png, size);
        assert_true(duct_image_truncated(copy, size));
        free(copy);
    }
}

static void other_files_are_not_its_business(void **state)
{
    (void)state;
    assert_false(duct_image_truncated((const unsigned char *)"", 0));
    assert_false(duct_image_truncated((const unsigned char *)"\x89PNG\r\n\x1b\n", 8));
    assert_false(duct_image_truncated((const unsigned char *)"\xff\xd8", 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(whole_file_is_whole),
        cmocka_unit_test(every_cut_is_seen),
        cmocka_unit_test(every_cut_png_is_seen),
        cmocka_unit_test(other_files_are_not_its_business),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
