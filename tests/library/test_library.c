/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/memory.h"
#include "library/feature_index.h"
#include "library/library_private.h"

#include <ductus/ductus.h>

#include <math.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/ductus-library-XXXXXX";
static char path[256];

static const char *file(const char *name)
{
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) == NULL;
}

static int remove_folder(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", folder);
    return system(command);
}

/* Some curly strokes with full pose; stroke s is about 100 + 10 s pixels long. */
static duct_drawing *make_recording(size_t strokes, bool twist)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    duct_drawing_set_page(drawing, 2000, 2000);
    assert_ok(duct_drawing_annotate(drawing, "artist", "Nobody", &error));
    for (size_t s = 0; s < strokes; s++) {
        duct_stroke *stroke;
        size_t count = 50;
        assert_ok(duct_drawing_add_stroke(drawing, "s", count, &stroke, &error));
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        double *t = duct_stroke_edit(stroke, DUCT_T), *p = duct_stroke_edit(stroke, DUCT_PRESSURE);
        double *tilt = duct_stroke_edit(stroke, DUCT_TILT_X),
               *turn = twist ? duct_stroke_edit(stroke, DUCT_TWIST) : NULL;
        double step = (100 + 10 * (double)s) / (double)(count - 1), angle = (double)s;
        for (size_t i = 0; i < count; i++) {
            angle += 0.1 * sin(0.3 * (double)(i + s));
            x[i] = i == 0 ? 200 : x[i - 1] + step * cos(angle);
            y[i] = i == 0 ? 20 * (double)s : y[i - 1] + step * sin(angle);
            t[i] = (double)i / 140;
            p[i] = 0.5 + 0.3 * sin(0.2 * (double)i);
            tilt[i] = 0.3 + 0.1 * cos(angle);
            if (twist) {
                turn[i] = 3.1 + 0.2 * sin(0.1 * (double)i);
            }
        }
    }
    return drawing;
}

static duct_library *make_library(bool twist)
{
    duct_error error;
    duct_drawing *recording = make_recording(9, twist);
    const duct_drawing *list[] = {recording};
    duct_library *library;
    assert_ok(duct_library_build(NULL, list, 1, NULL, &library, &error));
    duct_drawing_free(recording);
    return library;
}

static void the_median_stroke_has_sixty_units(void **state)
{
    (void)state;
    duct_library *library = make_library(true);
    assert_int_equal(duct_library_stroke_count(library), 9);
    assert_true(fabs(duct_library_unit(library) - 140.0 / 60) < 0.02);
    assert_true(fabs(library->median_size - 60) <= 1);
    for (size_t s = 0; s < 9; s++) {
        for (size_t i = library->starts[s] + 1; i < library->starts[s + 1]; i++) {
            double step = hypot(library->channels[DUCT_X][i] - library->channels[DUCT_X][i - 1],
                                library->channels[DUCT_Y][i] - library->channels[DUCT_Y][i - 1]);
            assert_true(fabs(step - 1) < 0.02);
        }
    }
    assert_string_equal(duct_library_artist(library), "Nobody");
    assert_true(duct_library_has(library, DUCT_PRESSURE) && !duct_library_has(library, DUCT_TILT_Y));
    /* The twist lies across the cut of the circle: its mean and spread must not notice. */
    assert_true(fabs(remainder(library->mean[DUCT_TWIST] - 3.1, 2 * M_PI)) < 0.2);
    assert_true(library->deviation[DUCT_TWIST] < 0.2);
    duct_library_free(library);
}

static void a_channel_must_be_in_all_strokes(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *with = make_recording(3, true), *without = make_recording(3, false);
    const duct_drawing *list[] = {with, without};
    duct_library *library;
    assert_ok(duct_library_build(NULL, list, 2, NULL, &library, &error));
    assert_int_equal(duct_library_stroke_count(library), 6);
    assert_true(duct_library_has(library, DUCT_PRESSURE) && !duct_library_has(library, DUCT_TWIST));
    duct_library_free(library);
    duct_drawing_free(with);
    duct_drawing_free(without);
}

static void strokes_without_length_are_left_out(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing;
    duct_library *library = NULL;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    const duct_drawing *list[] = {drawing};
    assert_int_equal(duct_library_build(NULL, list, 1, NULL, &library, &error), DUCT_UNSUPPORTED);
    assert_ok(duct_drawing_add_stroke(drawing, "dot", 5, NULL, &error));
    assert_ok(duct_drawing_add_stroke(drawing, "empty", 0, NULL, &error));
    assert_int_equal(duct_library_build(NULL, list, 1, NULL, &library, &error), DUCT_UNSUPPORTED);
    assert_null(library);
    duct_drawing_free(drawing);
}

static void what_is_saved_opens_the_same(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(true), *again;
    assert_ok(duct_library_save(NULL, library, file("hand.inkml"), &error));
    assert_int_equal(access(file("hand.inkml.index"), R_OK), 0);
    assert_ok(duct_library_open(NULL, file("hand.inkml"), &again, &error));
    assert_string_equal(duct_library_name(again), "hand");
    assert_string_equal(duct_library_artist(again), "Nobody");
    assert_int_equal(again->sample_count, library->sample_count);
    assert_memory_equal(again->starts, library->starts, 10 * sizeof *library->starts);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        assert_true((again->channels[c] == NULL) == (library->channels[c] == NULL));
        for (size_t i = 0; again->channels[c] != NULL && i < again->sample_count; i++) {
            /* Resampling what is already uniform moves nothing that could be seen. */
            assert_true(fabs(again->channels[c][i] - library->channels[c][i]) < 0.02);
        }
    }
    duct_library_free(again);
    duct_library_free(library);
}

static duct_feature_index features_of(duct_library *library)
{
    duct_error error;
    duct_feature_options options = duct_feature_options_default();
    duct_feature_index index;
    assert_ok(duct_library_features(library, &options, DUCT_SEARCH_EXACT, &index, &error));
    return index;
}

static void damaged_index_files_are_ignored(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(true), *fresh, *damaged;
    assert_ok(duct_library_save(NULL, library, file("hand.inkml"), &error));
    assert_ok(duct_library_open(NULL, file("hand.inkml"), &fresh, &error));
    size_t size = fresh->sample_count * 32 * sizeof(float);
    duct_feature_index true_index = features_of(fresh);
    for (int kind = 0; kind < 5; kind++) {
        FILE *stream = fopen(file("hand.inkml.index"), "r+b");
        assert_non_null(stream);
        if (kind == 0) {
            assert_int_equal(ftruncate(fileno(stream), 1000), 0);
        } else if (kind == 1) {
            assert_int_equal(ftruncate(fileno(stream), 0), 0);
        } else {
            fseek(stream, kind == 2 ? 16 : kind == 3 ? 3000 : 8, SEEK_SET);
            fwrite("\377\377\377\377\377\377\377\177", 1, 8, stream);
        }
        fclose(stream);
        assert_ok(duct_library_open(NULL, file("hand.inkml"), &damaged, &error));
        duct_feature_index index = features_of(damaged);
        assert_memory_equal(index.rows, true_index.rows, size);
        duct_library_free(damaged);
        assert_ok(duct_library_save(NULL, library, file("hand.inkml"), &error));
    }
    duct_library_free(fresh);
    duct_library_free(library);
}

static void the_index_file_is_used(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(true), *again;
    assert_ok(duct_library_save(NULL, library, file("used.inkml"), &error));
    assert_ok(duct_library_open(NULL, file("used.inkml"), &again, &error));
    duct_feature_options options = duct_feature_options_default();
    float *rows = calloc(again->sample_count * 32, sizeof *rows);
    char key[96];
    snprintf(key, sizeof key, "features %d reach %a weight %a", 0, options.reach, options.weight);
    assert_true(duct_index_read(again, key, rows, again->sample_count, 32));
    assert_memory_equal(rows, features_of(again).rows, again->sample_count * 32 * sizeof *rows);
    assert_false(duct_index_read(again, "another key", rows, again->sample_count, 32));
    assert_false(duct_index_read(again, key, rows, again->sample_count - 1, 32));
    free(rows);
    duct_library_free(again);
    duct_library_free(library);
}

static void a_hand_that_is_not_there_lists_those_that_are(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library(true), *none = NULL;
    char hands[256];
    snprintf(hands, sizeof hands, "%s/data/hands", folder);
    char command[400];
    snprintf(command, sizeof command, "mkdir -p '%s'", hands);
    assert_int_equal(system(command), 0);
    assert_ok(duct_library_save(NULL, library, file("data/hands/maria.inkml"), &error));
    char data[256];
    snprintf(data, sizeof data, "%s/data", folder);
    duct_context context = duct_context_default();
    context.data_folder = data;
    setenv("XDG_DATA_HOME", "/nowhere", 1);
    assert_int_equal(duct_library_open(&context, "mario", &none, &error), DUCT_NOT_FOUND);
    assert_non_null(strstr(error.message, "maria"));
    assert_non_null(strstr(error.message, "mario"));
    duct_library *found;
    assert_ok(duct_library_open(&context, "maria", &found, &error));
    assert_string_equal(duct_library_name(found), "maria");
    duct_library_free(found);
    duct_library_free(library);
}

static void files_that_are_no_libraries_are_refused(void **state)
{
    (void)state;
    duct_error error;
    static const char *const contents[] = {"", "hello", "<svg xmlns='http://www.w3.org/2000/svg'/>",
                                           "\x89PNG\r\n\x1a\n",
                                           "<ink xmlns='http://www.w3.org/2003/InkML'></ink>"};
    for (size_t i = 0; i < sizeof contents / sizeof contents[0]; i++) {
        FILE *stream = fopen(file("other.inkml"), "wb");
        fwrite(contents[i], 1, strlen(contents[i]), stream);
        fclose(stream);
        duct_library *library = NULL;
        duct_status status = duct_library_open(NULL, file("other.inkml"), &library, &error);
        assert_true(status == DUCT_BAD_FORMAT || status == DUCT_UNSUPPORTED);
        assert_non_null(strstr(error.message, "other.inkml"));
        assert_null(library);
    }
}

static void a_folder_is_a_library(void **state)
{
    (void)state;
    duct_error error;
    char command[400];
    snprintf(command, sizeof command, "mkdir -p '%s/pages'", folder);
    assert_int_equal(system(command), 0);
    duct_drawing *one = make_recording(3, true), *two = make_recording(4, true);
    assert_ok(duct_drawing_write(NULL, one, file("pages/a.inkml"), NULL, &error));
    assert_ok(duct_drawing_write(NULL, two, file("pages/b.csv"), NULL, &error));
    duct_library *library;
    assert_ok(duct_library_open(NULL, file("pages"), &library, &error));
    assert_int_equal(duct_library_stroke_count(library), 7);
    duct_library_free(library);
    duct_drawing_free(one);
    duct_drawing_free(two);
}

static void survives_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *recording = make_recording(3, true);
    const duct_drawing *list[] = {recording};
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_library *library = NULL;
        status = duct_library_build(&context, list, 1, NULL, &library, &error);
        if (status == DUCT_OK) {
            duct_feature_options options = duct_feature_options_default();
            duct_feature_index index;
            status = duct_library_features(library, &options, DUCT_SEARCH_EXACT, &index, &error);
            duct_library_free(library);
        }
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 1000);
    }
    duct_drawing_free(recording);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_median_stroke_has_sixty_units),
        cmocka_unit_test(a_channel_must_be_in_all_strokes),
        cmocka_unit_test(strokes_without_length_are_left_out),
        cmocka_unit_test(what_is_saved_opens_the_same),
        cmocka_unit_test(damaged_index_files_are_ignored),
        cmocka_unit_test(the_index_file_is_used),
        cmocka_unit_test(a_hand_that_is_not_there_lists_those_that_are),
        cmocka_unit_test(files_that_are_no_libraries_are_refused),
        cmocka_unit_test(a_folder_is_a_library),
        cmocka_unit_test(survives_failing_allocations),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
