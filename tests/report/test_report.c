/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/file.h"
#include "report/patches.h"

#include <ductus/ductus.h>
#include <ductus/random.h>

#include <json-c/json.h>
#include <math.h>
#include <unistd.h>

/* What the hand of a made recording does. */
typedef enum {
    SHAPED,  /* pressure is the same function of the shape in all strokes */
    RANDOM,  /* pressure is another wave in each stroke */
    POSELESS /* no pressure */
} manner;

/* Curves of several shapes, drawn again and again; neighbouring samples are one pixel apart. */
static duct_library *make_library(const char *name, size_t strokes, size_t samples, manner kind)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    for (size_t s = 0; s < strokes; s++) {
        duct_stroke *stroke;
        assert_ok(duct_drawing_add_stroke(drawing, "s", samples, &stroke, &error));
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        double *p = kind == POSELESS ? NULL : duct_stroke_edit(stroke, DUCT_PRESSURE);
        double angle = (double)(s % 3), own = duct_random_uniform(1, s, 0, 0);
        double whim = duct_random_uniform(2, s, 0, 0);
        for (size_t i = 0; i < samples; i++) {
            x[i] = i == 0 ? 0 : x[i - 1] + cos(angle);
            y[i] = i == 0 ? (double)s * 10 : y[i - 1] + sin(angle);
            angle += 0.15 * sin(0.2 * (double)i + (double)(s % 3)) + 0.01 * own;
            if (p != NULL) {
                p[i] = kind == SHAPED ? 0.5 + 0.2 * sin(angle) + 0.01 * own
                                      : 0.5 + 0.2 * sin((0.1 + 0.3 * whim) * (double)i + 20 * whim);
            }
        }
    }
    const duct_drawing *list[] = {drawing};
    const duct_library_options options = {.unit = 1, .name = name};
    duct_library *library;
    assert_ok(duct_library_build(NULL, list, 1, &options, &library, &error));
    duct_drawing_free(drawing);
    return library;
}

static duct_report *report_of(const duct_library *const *libraries, size_t count, const duct_context *context)
{
    duct_error error;
    duct_report *report = NULL;
    assert_ok(duct_library_report(context, libraries, count, NULL, &report, &error));
    return report;
}

static void shaped_pose_is_told_from_arbitrary_pose(void **state)
{
    (void)state;
    duct_library *shaped = make_library("shaped", 30, 60, SHAPED);
    duct_library *arbitrary = make_library("arbitrary", 30, 60, RANDOM);
    const duct_library *both[] = {shaped, arbitrary};
    duct_report *report = report_of(both, 2, NULL);
    const duct_report_entry *first = duct_report_between(report, 0, 0);
    const duct_report_entry *second = duct_report_between(report, 1, 1);
    const duct_report_entry *between = duct_report_between(report, 0, 1);
    assert_true(first->together.similar > 0.9);
    assert_true(first->together.random < 0.5);
    assert_int_equal(first->verdict, DUCT_VERDICT_CONSISTENT);
    assert_non_null(strstr(first->sentence, "consistent"));
    assert_true(second->together.similar < 0.4);
    assert_int_equal(second->verdict, DUCT_VERDICT_LOOSE);
    assert_true(between->together.similar < 0.4);
    assert_int_equal(first->patches, 30 * (60 - 24));
    assert_int_equal(between->patches, 2 * 30 * (60 - 24));
    assert_ptr_equal(between, duct_report_between(report, 1, 0));
    assert_null(duct_report_between(report, 0, 2));
    assert_null(duct_report_library_name(report, 2));
    assert_string_equal(duct_report_library_name(report, 1), "arbitrary");
    assert_int_equal(duct_report_library_count(report), 2);
    duct_report_free(report);
    duct_library_free(shaped);
    duct_library_free(arbitrary);
}

/* Against a plain search through all pairs. */
static void partners_are_the_most_similar_patches_of_other_strokes(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library("a", 12, 70, SHAPED), *other = make_library("b", 5, 55, SHAPED);
    const duct_allocator *allocator = duct_allocator_of(NULL);
    duct_patches own, foreign;
    assert_ok(duct_patches_make(allocator, library, 12, &own, &error));
    assert_ok(duct_patches_make(allocator, other, 12, &foreign, &error));
    const duct_patches *targets[] = {&own, &foreign};
    uint32_t partners[12 * 70];
    float distances[12 * 70];
    for (size_t k = 0; k < 2; k++) {
        const duct_patches *to = targets[k];
        assert_ok(duct_patches_pair(NULL, &own, to, 0, 1, partners, distances, &error));
        for (size_t i = 0; i < own.count; i++) {
            float best = INFINITY;
            for (size_t j = 0; j < to->count; j++) {
                if (to != &own || own.strokes[i] != own.strokes[j]) {
                    best =
                        fminf(best, duct_feature_distance(own.features + i * own.dimensions,
                                                          to->features + j * to->dimensions, own.dimensions));
                }
            }
            assert_true(to != &own || own.strokes[i] != own.strokes[partners[i]]);
            assert_float_equal(distances[i], best, 1e-6f);
        }
    }
    duct_patches_free(allocator, &own);
    duct_patches_free(allocator, &foreign);
    duct_library_free(library);
    duct_library_free(other);
}

static void too_little_is_said_to_be_too_little(void **state)
{
    (void)state;
    duct_library *one = make_library("one", 1, 200, SHAPED);   /* no other stroke */
    duct_library *tiny = make_library("tiny", 20, 20, SHAPED); /* no patch */
    duct_library *few = make_library("few", 2, 26, SHAPED);    /* four patches */
    duct_library *two = make_library("two", 2, 2, SHAPED);     /* two samples a stroke */
    const duct_library *all[] = {one, tiny, few, two};
    duct_report *report = report_of(all, 4, NULL);
    for (size_t a = 0; a < 4; a++) {
        for (size_t b = 0; b < 4; b++) {
            if (a == b || a == 1 || b == 1 || a == 3 || b == 3) {
                assert_int_equal(duct_report_between(report, a, b)->verdict, DUCT_VERDICT_TOO_SMALL);
            }
        }
    }
    assert_true(isnan(duct_report_between(report, 0, 0)->together.similar));
    assert_int_equal(duct_report_between(report, 1, 1)->together.pairs, 0);
    assert_int_equal(duct_report_between(report, 1, 1)->patches, 0);
    duct_report_free(report);
    duct_library_free(one);
    duct_library_free(tiny);
    duct_library_free(few);
    duct_library_free(two);
}

static void channels_that_one_lacks_drop_out(void **state)
{
    (void)state;
    duct_library *with = make_library("with", 20, 60, SHAPED);
    duct_library *without = make_library("without", 20, 60, POSELESS);
    const duct_library *both[] = {with, without};
    duct_report *report = report_of(both, 2, NULL);
    assert_true(duct_report_between(report, 0, 0)->present[DUCT_PRESSURE]);
    assert_false(duct_report_between(report, 0, 1)->present[DUCT_PRESSURE]);
    assert_int_equal(duct_report_between(report, 0, 1)->verdict, DUCT_VERDICT_NO_POSE);
    assert_int_equal(duct_report_between(report, 1, 1)->verdict, DUCT_VERDICT_NO_POSE);
    assert_true(isnan(duct_report_between(report, 1, 1)->together.similar));
    assert_true(duct_report_between(report, 1, 1)->together.pairs > 0);
    duct_report_free(report);
    duct_library_free(with);
    duct_library_free(without);
}

static void threads_and_runs_do_not_matter(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library("a", 30, 60, RANDOM);
    const duct_library *list[] = {library};
    char *texts[3];
    for (int i = 0; i < 3; i++) {
        duct_context context = duct_context_default();
        context.threads = i == 0 ? 1 : 4;
        duct_report *report = report_of(list, 1, &context);
        assert_ok(duct_report_json(NULL, report, &texts[i], &error));
        duct_report_free(report);
    }
    assert_string_equal(texts[0], texts[1]);
    assert_string_equal(texts[0], texts[2]);
    duct_report_options options = duct_report_options_default();
    options.seed = 5;
    duct_report *first = report_of(list, 1, NULL), *other;
    assert_ok(duct_library_report(NULL, list, 1, &options, &other, &error));
    const duct_report_entry *a = duct_report_between(first, 0, 0), *b = duct_report_between(other, 0, 0);
    assert_true(a->together.similar == b->together.similar);
    assert_true(a->together.random != b->together.random);
    for (int i = 0; i < 3; i++) {
        duct_memory_free(NULL, texts[i]);
    }
    duct_report_free(first);
    duct_report_free(other);
    duct_library_free(library);
}

static void json_can_be_read_and_names_are_escaped(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library("a \"b\"\n\xc3\xbc", 20, 60, SHAPED);
    duct_library *tiny = make_library("tiny", 2, 3, SHAPED);
    const duct_library *list[] = {library, tiny};
    duct_report *report = report_of(list, 2, NULL);
    char *text;
    assert_ok(duct_report_json(NULL, report, &text, &error));
    struct json_object *root = json_tokener_parse(text), *entries, *value;
    assert_non_null(root);
    assert_true(json_object_object_get_ex(root, "libraries", &entries));
    assert_int_equal(json_object_array_length(entries), 2);
    struct json_object *first = json_object_array_get_idx(entries, 0);
    assert_true(json_object_object_get_ex(first, "name", &value));
    assert_string_equal(json_object_get_string(value), "a \"b\"\n\xc3\xbc");
    assert_true(json_object_object_get_ex(first, "similar", &value));
    assert_true(json_object_get_double(value) > 0.9);
    assert_true(json_object_object_get_ex(first, "channels", &value));
    assert_true(json_object_object_get_ex(value, "pressure", &value));
    assert_true(json_object_object_get_ex(value, "pairs", &value));
    assert_true(json_object_get_int(value) > 0);
    /* No coefficient is null, not a word that JSON does not know. */
    assert_true(json_object_object_get_ex(json_object_array_get_idx(entries, 1), "similar", &value));
    assert_null(value);
    assert_true(json_object_object_get_ex(root, "between", &entries));
    assert_int_equal(json_object_array_length(entries), 1);
    json_object_put(root);
    duct_memory_free(NULL, text);
    duct_report_free(report);
    duct_library_free(library);
    duct_library_free(tiny);
}

static void pictures_appear_whole_or_not_at_all(void **state)
{
    (void)state;
    duct_error error;
    char folder[] = "/tmp/ductus-report-XXXXXX", path[64];
    assert_non_null(mkdtemp(folder));
    duct_library *library = make_library("<wave> & co", 20, 60, SHAPED);
    duct_library *tiny = make_library("tiny", 2, 3, SHAPED);
    const duct_library *list[] = {library, tiny};
    static const char *const names[] = {"a.svg", "a.png"};
    for (size_t count = 1; count <= 2; count++) {
        duct_report *report = report_of(list, count, NULL);
        for (size_t i = 0; i < 2; i++) {
            snprintf(path, sizeof path, "%s/%s", folder, names[i]);
            assert_ok(duct_report_draw(NULL, report, path, &error));
            char *data;
            size_t size;
            assert_ok(duct_file_read(duct_allocator_of(NULL), path, 1 << 24, &data, &size, &error));
            assert_true(size > 500);
            assert_true(i == 1 || strstr(data, "&lt;wave&gt; &amp; co") != NULL);
            assert_true(i == 1 || strstr(data, "nan") == NULL);
            duct_memory_free(NULL, data);
            unlink(path);
        }
        snprintf(path, sizeof path, "%s/a.gif", folder);
        assert_int_equal(duct_report_draw(NULL, report, path, &error), DUCT_UNSUPPORTED);
        assert_false(duct_file_exists(path));
        duct_report_free(report);
    }
    duct_library_free(library);
    duct_library_free(tiny);
    assert_int_equal(rmdir(folder), 0);
}

static void wrong_arguments_are_refused(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library("a", 3, 40, SHAPED);
    const duct_library *list[] = {library};
    duct_report *report = NULL;
    static const int radii[] = {-1, 0, 1, 1001, INT32_MAX};
    for (size_t i = 0; i < sizeof radii / sizeof radii[0]; i++) {
        duct_report_options options = {.radius = radii[i]};
        assert_int_equal(duct_library_report(NULL, list, 1, &options, &report, &error), DUCT_BAD_ARGUMENT);
    }
    assert_int_equal(duct_library_report(NULL, list, 0, NULL, &report, &error), DUCT_BAD_ARGUMENT);
    assert_int_equal(duct_library_report(NULL, list, 5000, NULL, &report, &error), DUCT_LIMIT);
    assert_null(report);
    duct_report_free(NULL);
    duct_library_free(library);
}

static bool stop(void *user, double fraction)
{
    (void)fraction;
    return ++*(int *)user < 3;
}

static void a_user_can_stop_it(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library("a", 60, 80, SHAPED);
    const duct_library *list[] = {library, library, library};
    int calls = 0;
    duct_context context = duct_context_default();
    context.progress = stop;
    context.progress_user = &calls;
    duct_report *report = NULL;
    assert_int_equal(duct_library_report(&context, list, 3, NULL, &report, &error), DUCT_CANCELLED);
    assert_null(report);
    duct_library_free(library);
}

static void every_failing_allocation_is_reported_and_leaves_nothing(void **state)
{
    (void)state;
    duct_error error;
    duct_library *library = make_library("a", 6, 40, SHAPED), *other = make_library("b", 5, 40, SHAPED);
    const duct_library *list[] = {library, other};
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        context.threads = 1;
        duct_report *report = NULL;
        char *text = NULL;
        status = duct_library_report(&context, list, 2, NULL, &report, &error);
        if (status == DUCT_OK) {
            status = duct_report_json(&context, report, &text, &error);
        }
        if (status == DUCT_OK) {
            status = duct_report_draw(&context, report, "/no-such-folder/a.svg", &error);
            status = status == DUCT_NO_MEMORY ? status : DUCT_OK; /* nobody may write there */
        }
        duct_memory_free(&context, text);
        duct_report_free(report);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 2000);
    }
    duct_library_free(library);
    duct_library_free(other);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shaped_pose_is_told_from_arbitrary_pose),
        cmocka_unit_test(partners_are_the_most_similar_patches_of_other_strokes),
        cmocka_unit_test(too_little_is_said_to_be_too_little),
        cmocka_unit_test(channels_that_one_lacks_drop_out),
        cmocka_unit_test(threads_and_runs_do_not_matter),
        cmocka_unit_test(json_can_be_read_and_names_are_escaped),
        cmocka_unit_test(pictures_appear_whole_or_not_at_all),
        cmocka_unit_test(wrong_arguments_are_refused),
        cmocka_unit_test(a_user_can_stop_it),
        cmocka_unit_test(every_failing_allocation_is_reported_and_leaves_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
