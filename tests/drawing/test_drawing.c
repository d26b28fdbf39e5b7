/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "drawing/drawing_private.h"

#include <ductus/ductus.h>

static duct_drawing *make(void)
{
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    return drawing;
}

static duct_stroke *add(duct_drawing *drawing, const char *id, size_t size)
{
    duct_error error;
    duct_stroke *stroke = NULL;
    assert_ok(duct_drawing_add_stroke(drawing, id, size, &stroke, &error));
    return stroke;
}

static void a_new_drawing_is_empty(void **state)
{
    (void)state;
    duct_drawing *drawing = make();
    double box[4] = {9, 9, 9, 9};
    assert_int_equal(duct_drawing_stroke_count(drawing), 0);
    assert_true(duct_drawing_width(drawing) == 0 && duct_drawing_height(drawing) == 0);
    assert_true(duct_drawing_resolution(drawing) == 96);
    assert_null(duct_drawing_stroke(drawing, 0));
    assert_null(duct_drawing_edit_stroke(drawing, 0));
    assert_null(duct_drawing_annotation(drawing, "artist"));
    assert_false(duct_drawing_bounds(drawing, box));
    assert_true(box[0] == 0 && box[3] == 0);
    assert_false(duct_drawing_has(drawing, DUCT_T));
    assert_null(duct_drawing_origin(drawing));
    duct_drawing_free(drawing);
    duct_drawing_free(NULL);
}

static void a_new_stroke_is_black_and_has_x_and_y_only(void **state)
{
    (void)state;
    duct_drawing *drawing = make();
    duct_stroke *stroke = add(drawing, "a", 3);
    duct_stroke_style style = duct_stroke_get_style(stroke);
    assert_true(style.red == 0 && style.green == 0 && style.blue == 0 && style.opacity == 1 &&
                style.width == 0);
    assert_false(duct_stroke_closed(stroke));
    assert_string_equal(duct_stroke_id(stroke), "a");
    assert_string_equal(duct_stroke_group(stroke), "");
    assert_int_equal(duct_stroke_size(stroke), 3);
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        assert_int_equal(duct_stroke_values(stroke, (duct_channel)c) != NULL, c <= DUCT_Y);
    }
    assert_true(duct_stroke_values(stroke, DUCT_X)[2] == 0);
    assert_int_equal(duct_stroke_part(stroke), -1);
    assert_string_equal(duct_stroke_id(add(drawing, NULL, 0)), "");
    duct_drawing_free(drawing);
}

static void channels_come_and_go(void **state)
{
    (void)state;
    duct_drawing *drawing = make();
    duct_stroke *stroke = add(drawing, "a", 2);
    double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE);
    assert_true(pressure[0] == 0 && pressure[1] == 0);
    pressure[1] = 0.5;
    assert_true(duct_stroke_edit(stroke, DUCT_PRESSURE) == pressure);
    assert_true(duct_drawing_has(drawing, DUCT_PRESSURE));
    duct_stroke_drop(stroke, DUCT_PRESSURE);
    duct_stroke_drop(stroke, DUCT_X);
    assert_null(duct_stroke_values(stroke, DUCT_PRESSURE));
    assert_non_null(duct_stroke_values(stroke, DUCT_X));
    assert_null(duct_stroke_values(stroke, (duct_channel)99));
    assert_null(duct_stroke_edit(stroke, (duct_channel)99));
    duct_stroke_drop(stroke, (duct_channel)99);
    assert_string_equal(duct_channel_name((duct_channel)99), "unknown");
    duct_drawing_free(drawing);
}

static void resizing_keeps_values_and_zeroes_new_ones(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = make();
    duct_stroke *stroke = add(drawing, "a", 2);
    duct_stroke_edit(stroke, DUCT_T)[1] = 7;
    assert_ok(duct_stroke_resize(stroke, 4, &error));
    assert_true(duct_stroke_values(stroke, DUCT_T)[1] == 7 && duct_stroke_values(stroke, DUCT_T)[3] == 0);
    assert_ok(duct_stroke_resize(stroke, 0, &error));
    assert_int_equal(duct_stroke_size(stroke), 0);
    assert_non_null(duct_stroke_values(stroke, DUCT_T));
    assert_int_equal(duct_stroke_resize(stroke, (size_t)DUCT_MAX_SAMPLES + 1, &error), DUCT_LIMIT);
    assert_int_equal(duct_stroke_size(stroke), 0);
    duct_drawing_free(drawing);
}

static void too_many_samples_are_refused_before_memory_is_taken(void **state)
{
    (void)state;
    duct_error error;
    failing_allocator failing;
    failing_init(&failing, 0);
    duct_context context = duct_context_default();
    context.allocator = &failing.allocator;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(&context, &drawing, &error));
    long calls = failing.calls;
    duct_stroke *stroke = NULL;
    assert_int_equal(duct_drawing_add_stroke(drawing, "a", SIZE_MAX, &stroke, &error), DUCT_LIMIT);
    assert_int_equal(duct_drawing_add_stroke(drawing, "a", (size_t)DUCT_MAX_SAMPLES + 1, &stroke, &error),
                     DUCT_LIMIT);
    assert_null(stroke);
    assert_int_equal(failing.calls, calls);
    duct_drawing_free(drawing);
    assert_int_equal(failing.held, 0);
}

static void copies_are_equal_and_independent(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = make(), *copy, *like;
    duct_drawing_set_page(drawing, 10, 20);
    duct_drawing_set_resolution(drawing, 300);
    assert_ok(duct_drawing_annotate(drawing, "artist", "A", &error));
    duct_stroke *stroke = add(drawing, "a", 2);
    duct_stroke_edit(stroke, DUCT_TWIST)[1] = 3;
    duct_stroke_set_closed(stroke, true);
    duct_stroke_set_style(stroke, (duct_stroke_style){1, 0.5f, 0.25f, 0.75f, 2});
    assert_ok(duct_stroke_set_group(stroke, "g/h", &error));
    duct_stroke_set_part(stroke, 5);
    duct_stroke_set_changed(stroke, false);
    assert_ok(duct_drawing_copy(NULL, drawing, &copy, &error));
    assert_ok(duct_drawing_like(NULL, drawing, &like, &error));
    duct_stroke_edit(stroke, DUCT_TWIST)[1] = 4;
    assert_ok(duct_drawing_annotate(drawing, "artist", "B", &error));
    duct_drawing_free(drawing);
    const duct_stroke *other = duct_drawing_stroke(copy, 0);
    assert_true(duct_drawing_width(copy) == 10 && duct_drawing_height(copy) == 20);
    assert_true(duct_drawing_resolution(copy) == 300);
    assert_string_equal(duct_drawing_annotation(copy, "artist"), "A");
    assert_true(duct_stroke_values(other, DUCT_TWIST)[1] == 3);
    assert_null(duct_stroke_values(other, DUCT_T));
    assert_true(duct_stroke_closed(other) && duct_stroke_get_style(other).width == 2);
    assert_string_equal(duct_stroke_group(other), "g/h");
    assert_int_equal(duct_stroke_part(other), 5);
    assert_false(duct_stroke_changed(other));
    assert_int_equal(duct_drawing_stroke_count(like), 0);
    assert_true(duct_drawing_height(like) == 20);
    assert_string_equal(duct_drawing_annotation(like, "artist"), "A");
    duct_drawing_free(copy);
    duct_drawing_free(like);
}

static void a_drawing_can_add_a_copy_of_its_own_stroke(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = make();
    add(drawing, "a", 1);
    for (int i = 0; i < 100; i++) {
        assert_ok(duct_drawing_add_copy(drawing, duct_drawing_stroke(drawing, 0), NULL, &error));
    }
    assert_int_equal(duct_drawing_stroke_count(drawing), 101);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 100)), "a");
    duct_drawing_free(drawing);
}

static void annotations_are_set_replaced_and_removed_in_order(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = make();
    const char *key = NULL, *value = NULL;
    assert_ok(duct_drawing_annotate(drawing, "a", "1", &error));
    assert_ok(duct_drawing_annotate(drawing, "b", "2", &error));
    assert_ok(duct_drawing_annotate(drawing, "c", "3", &error));
    assert_ok(duct_drawing_annotate(drawing, "b", "4", &error));
    assert_ok(duct_drawing_annotate(drawing, "a", NULL, &error));
    assert_ok(duct_drawing_annotate(drawing, "none", NULL, &error));
    assert_true(duct_drawing_annotation_at(drawing, 0, &key, &value));
    assert_string_equal(key, "b");
    assert_string_equal(value, "4");
    assert_true(duct_drawing_annotation_at(drawing, 1, &key, &value));
    assert_string_equal(key, "c");
    assert_false(duct_drawing_annotation_at(drawing, 2, &key, &value));
    duct_drawing_free(drawing);
}

static void the_box_holds_all_samples(void **state)
{
    (void)state;
    duct_drawing *drawing = make();
    duct_stroke *a = add(drawing, "a", 2);
    add(drawing, "empty", 0);
    double *x = duct_stroke_edit(a, DUCT_X), *y = duct_stroke_edit(a, DUCT_Y), box[4];
    x[0] = 5;
    x[1] = -3;
    y[0] = 7;
    y[1] = 9;
    assert_true(duct_drawing_bounds(drawing, box));
    assert_true(box[0] == -3 && box[1] == 7 && box[2] == 5 && box[3] == 9);
    duct_drawing_free(drawing);
}

static void editing_marks_a_stroke_as_changed(void **state)
{
    (void)state;
    duct_drawing *drawing = make();
    duct_stroke *stroke = add(drawing, "a", 1);
    assert_true(duct_stroke_changed(stroke));
    for (int i = 0; i < 5; i++) {
        duct_stroke_set_changed(stroke, false);
        switch (i) {
        case 0:
            duct_drawing_edit_stroke(drawing, 0);
            break;
        case 1:
            duct_stroke_edit(stroke, DUCT_X);
            break;
        case 2:
            duct_stroke_set_closed(stroke, true);
            break;
        case 3:
            duct_stroke_resize(stroke, 2, NULL);
            break;
        default:
            duct_stroke_set_style(stroke, duct_stroke_get_style(stroke));
        }
        assert_true(duct_stroke_changed(stroke));
    }
    duct_drawing_free(drawing);
}

typedef struct {
    duct_origin origin;
    int *destroyed;
} counted_origin;

static void destroy(duct_origin *origin)
{
    counted_origin *counted = (counted_origin *)origin;
    ++*counted->destroyed;
    free(counted);
}

static void the_origin_lives_as_long_as_the_last_copy(void **state)
{
    (void)state;
    duct_error error;
    int destroyed = 0;
    duct_drawing *drawing = make(), *copy, *like;
    counted_origin *origin = calloc(1, sizeof *origin);
    assert_non_null(origin);
    atomic_init(&origin->origin.references, 1);
    origin->origin.format = "test";
    origin->origin.destroy = destroy;
    origin->destroyed = &destroyed;
    duct_drawing_set_origin(drawing, &origin->origin);
    assert_ok(duct_drawing_copy(NULL, drawing, &copy, &error));
    assert_ok(duct_drawing_like(NULL, copy, &like, &error));
    duct_drawing_free(drawing);
    duct_drawing_free(copy);
    assert_int_equal(destroyed, 0);
    assert_string_equal(duct_drawing_origin(like)->format, "test");
    duct_drawing_free(like);
    assert_int_equal(destroyed, 1);
}

/* Everything that allocates, once: the n-th allocation fails. */
static duct_status use_all(const duct_context *context)
{
    duct_drawing *drawing = NULL, *copy = NULL;
    duct_stroke *stroke = NULL;
    duct_status status = duct_drawing_new(context, &drawing, NULL);
    if (status == DUCT_OK) {
        status = duct_drawing_annotate(drawing, "k", "v", NULL);
    }
    if (status == DUCT_OK) {
        status = duct_drawing_annotate(drawing, "k", "w", NULL);
        assert_string_equal(duct_drawing_annotation(drawing, "k"), status == DUCT_OK ? "w" : "v");
    }
    if (status == DUCT_OK) {
        status = duct_drawing_add_stroke(drawing, "a", 4, &stroke, NULL);
        assert_int_equal(duct_drawing_stroke_count(drawing), status == DUCT_OK ? 1 : 0);
    }
    for (int c = 0; status == DUCT_OK && c < DUCT_CHANNEL_COUNT; c++) {
        status = duct_stroke_edit(stroke, (duct_channel)c) != NULL ? DUCT_OK : DUCT_NO_MEMORY;
    }
    if (status == DUCT_OK) {
        status = duct_stroke_set_group(stroke, "g", NULL);
        assert_string_equal(duct_stroke_group(stroke), status == DUCT_OK ? "g" : "");
    }
    if (status == DUCT_OK) {
        status = duct_stroke_set_id(stroke, "b", NULL);
        assert_string_equal(duct_stroke_id(stroke), status == DUCT_OK ? "b" : "a");
    }
    if (status == DUCT_OK) {
        status = duct_stroke_resize(stroke, 9, NULL);
        assert_int_equal(duct_stroke_size(stroke), status == DUCT_OK ? 9 : 4);
    }
    if (status == DUCT_OK) {
        status = duct_drawing_copy(context, drawing, &copy, NULL);
        assert_int_equal(copy != NULL, status == DUCT_OK);
    }
    duct_drawing_free(copy);
    duct_drawing_free(drawing);
    return status;
}

static void failing_allocations_leave_handles_as_they_were(void **state)
{
    (void)state;
    bool done = false;
    for (long n = 1; !done; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_status status = use_all(&context);
        done = failing.calls < n;
        assert_int_equal(status, done ? DUCT_OK : DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 1000);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_new_drawing_is_empty),
        cmocka_unit_test(a_new_stroke_is_black_and_has_x_and_y_only),
        cmocka_unit_test(channels_come_and_go),
        cmocka_unit_test(resizing_keeps_values_and_zeroes_new_ones),
        cmocka_unit_test(too_many_samples_are_refused_before_memory_is_taken),
        cmocka_unit_test(copies_are_equal_and_independent),
        cmocka_unit_test(a_drawing_can_add_a_copy_of_its_own_stroke),
        cmocka_unit_test(annotations_are_set_replaced_and_removed_in_order),
        cmocka_unit_test(the_box_holds_all_samples),
        cmocka_unit_test(editing_marks_a_stroke_as_changed),
        cmocka_unit_test(the_origin_lives_as_long_as_the_last_copy),
        cmocka_unit_test(failing_allocations_leave_handles_as_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
