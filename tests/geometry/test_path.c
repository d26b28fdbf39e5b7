/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"
#include "geometry/path.h"

static void draw(duct_path *path)
{
    duct_path_move(path, 1, 2.5);
    duct_path_line(path, -0.00001, 1e3);
    duct_path_cubic(path, 1, 2, 3, 4, 5, 6);
    duct_path_close(path);
}

static void assert_svg(const duct_path *path, int decimals, const char *expected)
{
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    duct_text_add(&text, "");
    duct_path_text(path, decimals, &text);
    assert_false(text.failed);
    assert_string_equal(text.data, expected);
    duct_text_free(&text);
}

static void empty_path_writes_nothing(void **state)
{
    (void)state;
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    assert_svg(&path, 3, "");
    assert_int_equal(duct_path_nodes(&path), 0);
    duct_path_done(&path);
}

static void svg_has_absolute_commands(void **state)
{
    (void)state;
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    draw(&path);
    assert_svg(&path, 3, "M 1,2.5 L 0,1000 C 1,2 3,4 5,6 Z");
    duct_path_done(&path);
}

static void nodes_count_what_an_editor_shows(void **state)
{
    (void)state;
    duct_path path;
    duct_path_init(&path, duct_allocator_of(NULL));
    draw(&path);
    assert_int_equal(duct_path_nodes(&path), 3);
    /* A last node on the first one is one with it. */
    duct_path_move(&path, 0, 0);
    duct_path_line(&path, 1, 0);
    duct_path_cubic(&path, 1, 1, 0, 1, 0, 0);
    duct_path_close(&path);
    assert_int_equal(duct_path_nodes(&path), 5);
    duct_path_close(&path);
    assert_int_equal(duct_path_nodes(&path), 5);
    duct_path_done(&path);
}

static void failed_allocation_sets_failed_and_nothing_else_happens(void **state)
{
    (void)state;
    for (long n = 1; n <= 2; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_path path;
        duct_path_init(&path, &failing.allocator);
        draw(&path);
        assert_true(path.failed);
        assert_int_equal(path.verb_count, 0);
        assert_int_equal(path.point_count, 0);
        duct_path_done(&path);
        assert_int_equal(failing.held, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_path_writes_nothing),
        cmocka_unit_test(svg_has_absolute_commands),
        cmocka_unit_test(nodes_count_what_an_editor_shows),
        cmocka_unit_test(failed_allocation_sets_failed_and_nothing_else_happens),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
