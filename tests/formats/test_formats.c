/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawings.h"

#include "drawing/drawing_private.h"

#include <sys/stat.h>
#include <unistd.h>

static void the_list_of_formats_is_complete(void **state)
{
    (void)state;
    bool inkml = false, cyn = false, csv = false;
    for (size_t i = 0; duct_format_at(i) != NULL; i++) {
        const duct_format *format = duct_format_at(i);
        assert_true(*format->label != '\0' && *format->extensions != '\0');
        inkml = inkml || strcmp(format->id, "inkml") == 0;
        cyn = cyn || strcmp(format->id, "cyn") == 0;
        csv = csv || strcmp(format->id, "csv") == 0;
    }
    assert_true(inkml && cyn && csv);
    assert_null(duct_format_at(1000));
    duct_format_options options = duct_format_options_default();
    assert_near(options.flatten_tolerance, 0.05, 0);
    assert_near(options.fit_tolerance, 0.1, 0);
    assert_int_equal(options.line_style, DUCT_LINE_OUTLINE);
}

static void content_counts_more_than_the_name(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_read_memory(NULL, "x,y\n1,2\n", 8, "wrong.inkml", NULL, NULL, &drawing, &error));
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_drawing_free(drawing);
    /* Where the content says nothing, the name does. */
    duct_drawing *none = NULL;
    assert_int_equal(duct_drawing_read_memory(NULL, "a,b\n", 4, "t.CSV", NULL, NULL, &none, &error),
                     DUCT_BAD_FORMAT);
    assert_non_null(strstr(error.message, "t.CSV: line 1: the columns x and y"));
    assert_null(none);
}

static void unknown_content_is_refused_with_what_can_be_read(void **state)
{
    (void)state;
    assert_refused("", NULL, DUCT_BAD_FORMAT, "is empty");
    assert_refused("hello", NULL, DUCT_BAD_FORMAT, "inkml, cyn, csv");
    assert_refused("\x89PNG\r\n\x1a\n", NULL, DUCT_BAD_FORMAT, "none of the formats");
    assert_refused("x,y\n", "docx", DUCT_UNSUPPORTED, "\"docx\"");
}

static void binary_garbage_is_refused_by_every_format(void **state)
{
    (void)state;
    char data[4096];
    for (uint64_t round = 0; round < 200; round++) {
        for (size_t i = 0; i < sizeof data; i++) {
            data[i] = (char)duct_random_bits(round, i, 0, 0);
        }
        for (size_t f = 0; duct_format_at(f) != NULL; f++) {
            duct_drawing *drawing = NULL;
            duct_error error = {DUCT_OK, ""};
            assert_int_not_equal(duct_drawing_read_memory(NULL, data, sizeof data, "garbage",
                                                          duct_format_at(f)->id, NULL, &drawing, &error),
                                 DUCT_OK);
            assert_null(drawing);
        }
    }
}

static void strokes_that_were_read_count_as_unchanged(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("x,y\n1,2\n");
    assert_false(duct_stroke_changed(duct_drawing_stroke(drawing, 0)));
    duct_drawing_edit_stroke(drawing, 0);
    assert_true(duct_stroke_changed(duct_drawing_stroke(drawing, 0)));
    duct_drawing_free(drawing);
}

static void files_appear_whole_or_not_at_all(void **state)
{
    (void)state;
    char folder[] = "/tmp/ductus-formats-XXXXXX";
    assert_non_null(mkdtemp(folder));
    char path[100], missing[100];
    duct_error error;
    duct_drawing *drawing = random_drawing(1, 3, true);
    for (size_t f = 0; duct_format_at(f) != NULL; f++) {
        const duct_format *format = duct_format_at(f);
        if (!format->writes || !format->reads || strcmp(format->id, "svg") == 0) {
            continue;
        }
        snprintf(path, sizeof path, "%s/a.%s", folder, format->id);
        assert_ok(duct_drawing_write(NULL, drawing, path, NULL, &error));
        duct_drawing *back;
        assert_ok(duct_drawing_read(NULL, path, NULL, &back, &error));
        assert_int_equal(duct_drawing_stroke_count(back), 3);
        duct_drawing_free(back);
        /* Values that are not finite are refused before the file is touched. */
        double *x = duct_stroke_edit(duct_drawing_edit_stroke(drawing, 1), DUCT_X), old = x[0];
        x[0] = NAN;
        struct stat before, after;
        assert_int_equal(stat(path, &before), 0);
        assert_int_equal(duct_drawing_write(NULL, drawing, path, NULL, &error), DUCT_BAD_ARGUMENT);
        assert_int_equal(stat(path, &after), 0);
        assert_true(before.st_ino == after.st_ino && before.st_size == after.st_size);
        x[0] = old;
        assert_int_equal(unlink(path), 0);
    }
    snprintf(missing, sizeof missing, "%s/none/a.csv", folder);
    assert_int_not_equal(duct_drawing_write(NULL, drawing, missing, NULL, &error), DUCT_OK);
    assert_int_equal(strncmp(error.message, missing, strlen(missing)), 0);
    snprintf(missing, sizeof missing, "%s/a.csv", folder);
    duct_drawing *none = NULL;
    assert_int_equal(duct_drawing_read(NULL, missing, NULL, &none, &error), DUCT_NOT_FOUND);
    assert_null(none);
    assert_int_equal(rmdir(folder), 0); /* nothing is left over */
    duct_drawing_free(drawing);
}

static void unknown_endings_are_refused_with_what_can_be_written(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = random_drawing(1, 1, true);
    assert_int_equal(duct_drawing_write(NULL, drawing, "/tmp/a.docx", NULL, &error), DUCT_UNSUPPORTED);
    assert_non_null(strstr(error.message, "inkml"));
    assert_int_equal(duct_drawing_write(NULL, drawing, "/tmp/csv", NULL, &error), DUCT_UNSUPPORTED);
    char *data = NULL;
    size_t size = 0;
    assert_int_equal(duct_drawing_write_memory(NULL, drawing, "docx", NULL, &data, &size, &error),
                     DUCT_UNSUPPORTED);
    assert_int_equal(duct_drawing_write_memory(NULL, drawing, NULL, NULL, &data, &size, &error),
                     DUCT_UNSUPPORTED);
    assert_null(data);
    duct_drawing_free(drawing);
}

/* From format to format, what all of them can hold stays. */
static void drawings_survive_a_chain_of_formats(void **state)
{
    (void)state;
    duct_drawing *drawing = random_drawing(9, 12, true);
    duct_drawing *ink = write_and_read(drawing, "inkml"), *table = write_and_read(ink, "csv");
    for (size_t i = 0; i < 12; i++) {
        assert_same_values(duct_drawing_stroke(drawing, i), duct_drawing_stroke(table, i), 0);
    }
    duct_drawing_free(table);
    duct_drawing_free(ink);
    duct_drawing_free(drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_list_of_formats_is_complete),
        cmocka_unit_test(content_counts_more_than_the_name),
        cmocka_unit_test(unknown_content_is_refused_with_what_can_be_read),
        cmocka_unit_test(binary_garbage_is_refused_by_every_format),
        cmocka_unit_test(strokes_that_were_read_count_as_unchanged),
        cmocka_unit_test(files_appear_whole_or_not_at_all),
        cmocka_unit_test(unknown_endings_are_refused_with_what_can_be_written),
        cmocka_unit_test(drawings_survive_a_chain_of_formats),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
