/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include <ductus/format.h>
#include <ductus/render.h>

#include "base/file.h"
#include "brush/brush_private.h"

#include <unistd.h>

static duct_error error;

static duct_status parse(const char *text)
{
    duct_brush brush = {.allocator = duct_allocator_of(NULL)};
    duct_status status = duct_brush_parse(&brush, text, &error);
    duct_release(brush.allocator, brush.curves);
    return status;
}

static void own_brushes_load(void **state)
{
    (void)state;
    char **names = NULL;
    size_t count = 0;
    assert_ok(duct_brush_list(NULL, &names, &count, &error));
    assert_true(count >= 3);
    for (size_t i = 0; i < count; i++) {
        duct_brush *brush = NULL;
        assert_ok(duct_brush_load(NULL, names[i], &brush, &error));
        assert_string_equal(duct_brush_name(brush), names[i]);
        assert_true(i == 0 || strcmp(names[i - 1], names[i]) < 0);
        duct_brush_free(brush);
    }
    for (size_t i = 0; i < count; i++) {
        duct_memory_free(NULL, names[i]);
    }
    duct_memory_free(NULL, names);
}

static void unknown_name_lists_what_there_is(void **state)
{
    (void)state;
    duct_brush *brush = NULL;
    assert_int_equal(duct_brush_load(NULL, "no-such-brush", &brush, &error), DUCT_NOT_FOUND);
    assert_non_null(strstr(error.message, "no-such-brush"));
    assert_non_null(strstr(error.message, "bristle"));
    assert_non_null(strstr(error.message, "flat-nib"));
    assert_null(brush);
    assert_int_equal(duct_brush_load(NULL, "./nowhere.myb", &brush, &error), DUCT_NOT_FOUND);
    assert_non_null(strstr(error.message, "nowhere.myb"));
}

static void reject_malformed(void **state)
{
    (void)state;
    static const char *const bad[] = {
        "",
        "not json",
        "[]",
        "{}",
        "{\"version\": 3}",
        "{\"version\": 2, \"settings\": {}}",
        "{\"version\": \"3\", \"settings\": {}}",
        "{\"version\": 3, \"settings\": []}",
        "{\"version\": 3, \"settings\": {\"opaque\": 1}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": \"1\"}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1e300}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": NaN}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1, \"inputs\": 7}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1, \"inputs\": {\"pressure\": 7}}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1, \"inputs\": {\"pressure\": [[0, "
        "1]]}}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1, \"inputs\": {\"pressure\": [[0, 1], "
        "[1]]}}}}",
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1, \"inputs\": {\"pressure\": [[1, 0], "
        "[0, "
        "1]]}}}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": 5}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"bristles\": -1}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"bristles\": 1000000000}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"spread\": \"much\"}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"ratio\": 0}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"grain\": 9}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"grain_size\": 0}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"side\": -1}}",
        "{\"version\": 3, \"settings\": {}, \"ductus\": {\"cover\": 2}}",
        "{\"version\": 3, \"settings\": {}",
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        error.message[0] = '\0';
        if (parse(bad[i]) != DUCT_BAD_FORMAT || error.message[0] == '\0') {
            fail_msg("taken: %s", bad[i]);
        }
    }
}

static void too_many_points_and_deep_nesting_are_refused(void **state)
{
    (void)state;
    char text[8192];
    int length = snprintf(
        text, sizeof text,
        "{\"version\": 3, \"settings\": {\"opaque\": {\"base_value\": 1, \"inputs\": {\"pressure\": [");
    for (int i = 0; i < 65; i++) {
        length += snprintf(text + length, sizeof text - (size_t)length, "%s[%d, 0]", i > 0 ? ", " : "", i);
    }
    snprintf(text + length, sizeof text - (size_t)length, "]}}}}");
    assert_int_equal(parse(text), DUCT_BAD_FORMAT);
    memset(text, '[', sizeof text - 1);
    text[sizeof text - 1] = '\0';
    assert_int_equal(parse(text), DUCT_BAD_FORMAT);
}

static void unknown_settings_and_inputs_are_passed_over(void **state)
{
    (void)state;
    assert_ok(parse(
        "{\"version\": 3, \"settings\": {\"glitter\": {\"base_value\": 1}, \"opaque\": {\"base_value\": 1, "
        "\"inputs\": {\"wind\": [[0, 0], [1, 1]], \"pressure\": []}}}, \"more\": 1}"));
}

static void settings_replace_defaults(void **state)
{
    (void)state;
    duct_brush brush = {.allocator = duct_allocator_of(NULL)};
    assert_ok(duct_brush_parse(
        &brush,
        "{\"version\": 3, \"settings\": {\"opaque_multiply\": {\"base_value\": 1, \"inputs\": "
        "{}}, \"hardness\": {\"base_value\": 0.25}}}",
        &error));
    assert_int_equal(brush.curve_count, 0);
    assert_float_equal(brush.base[MYPAINT_BRUSH_SETTING_HARDNESS], 0.25f, 1e-6f);
    assert_float_equal(brush.base[MYPAINT_BRUSH_SETTING_OPAQUE], 1, 1e-6f);
    assert_int_equal(brush.tuft.bristles, 0);
    duct_release(brush.allocator, brush.curves);
}

static void empty_and_binary_files_are_refused(void **state)
{
    (void)state;
    char path[] = "/tmp/ductus-brush-XXXXXX.myb";
    int file = mkstemps(path, 4);
    assert_true(file >= 0);
    duct_brush *brush = NULL;
    assert_int_equal(duct_brush_load(NULL, path, &brush, &error), DUCT_BAD_FORMAT);
    assert_non_null(strstr(error.message, path));
    assert_int_equal(write(file, "{\"version\"\0: 3}", 15), 15);
    assert_int_equal(duct_brush_load(NULL, path, &brush, &error), DUCT_BAD_FORMAT);
    close(file);
    unlink(path);
    assert_int_not_equal(duct_brush_load(NULL, "/tmp/", &brush, &error), DUCT_OK);
    assert_null(brush);
}

static void every_allocation_may_fail(void **state)
{
    (void)state;
    for (int what = 0; what < 3; what++) {
        for (long n = 1;; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            duct_context context = duct_context_default();
            context.allocator = &failing.allocator;
            duct_brush *brush = NULL;
            char **names = NULL;
            size_t count = 0;
            duct_status status = what == 0   ? duct_brush_load(&context, "bristle", &brush, &error)
                                 : what == 1 ? duct_brush_list(&context, &names, &count, &error)
                                             : duct_brush_load(&context, "none", &brush, &error);
            duct_brush_free(brush);
            for (size_t i = 0; i < count; i++) {
                duct_memory_free(&context, names[i]);
            }
            duct_memory_free(&context, names);
            assert_int_equal(failing.held, 0);
            if (failing.calls < n) {
                assert_int_equal(status, what == 2 ? DUCT_NOT_FOUND : DUCT_OK);
                break;
            }
            assert_int_equal(status, DUCT_NO_MEMORY);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(own_brushes_load),
        cmocka_unit_test(unknown_name_lists_what_there_is),
        cmocka_unit_test(reject_malformed),
        cmocka_unit_test(too_many_points_and_deep_nesting_are_refused),
        cmocka_unit_test(unknown_settings_and_inputs_are_passed_over),
        cmocka_unit_test(settings_replace_defaults),
        cmocka_unit_test(empty_and_binary_files_are_refused),
        cmocka_unit_test(every_allocation_may_fail),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
