/* SPDX-License-Identifier: GPL-3.0-or-later */
/* SVG that is broken, hostile or huge: a sentence or a sensible drawing, never a crash or a long wait. */
#include "testing.h"

#include "base/text.h"
#include "drawings.h"

#define SVG "<svg xmlns='http://www.w3.org/2000/svg' "

static const char *const sample =
    "<?xml version='1.0'?><!DOCTYPE svg [<!ENTITY st 'stroke:red'>]>" SVG
    "width='50mm' height='40mm' viewBox='0 0 50 40'><style>g>path{stroke:blue!important}</style>"
    "<defs><linearGradient id='g'><stop stop-color='#123456'/></linearGradient></defs>"
    "<g id='l' transform='translate(1,2)rotate(3)'><path id='a' d='M0 0c1 2 3 4 5 6s7 8 9 10a1 2 3 0 1 4 "
    "5zm1 1h5'/>"
    "<rect width='9' height='5' rx='1' style='&st;;fill:lime'/></g><circle r='4' stroke='url(#g)'/>"
    "<polygon points='1 2 3 4 5 0' stroke='rgb(1,2,3)'/></svg>";

static void truncated_files_are_refused(void **state)
{
    (void)state;
    assert_int_equal(read_truncated(sample, "svg"), strlen(sample));
}

static void mutated_files_do_no_harm(void **state)
{
    (void)state;
    read_mutated(sample, "svg", 3000);
}

/* Reads the text with every stroke changed and given pressure, writes it, and frees all. */
static duct_status churn(const duct_context *context, const char *text, bool pressure, duct_error *error)
{
    duct_drawing *drawing = NULL;
    duct_status status =
        duct_drawing_read_memory(context, text, strlen(text), "test.svg", "svg", NULL, &drawing, error);
    for (size_t i = 0; status == DUCT_OK && i < duct_drawing_stroke_count(drawing); i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
        if (pressure && duct_stroke_edit(stroke, DUCT_PRESSURE) == NULL) {
            status = DUCT_NO_MEMORY;
        }
    }
    if (status == DUCT_OK) {
        duct_stroke *stroke;
        status = duct_drawing_add_stroke(drawing, "new", 3, &stroke, error);
        status = status == DUCT_OK ? duct_stroke_set_group(stroke, "a/b", error) : status;
    }
    if (status == DUCT_OK) {
        char *data = NULL;
        size_t size;
        status = duct_drawing_write_memory(context, drawing, "svg", NULL, &data, &size, error);
        assert_int_equal(status == DUCT_OK, data != NULL);
        duct_memory_free(context, data);
    }
    duct_drawing_free(drawing);
    return status;
}

static void failed_allocations_leak_nothing(void **state)
{
    (void)state;
    fail_allocations(sample, "svg");
    for (int pressure = 0; pressure < 2; pressure++) {
        bool done = false;
        for (long n = 1; !done; n++) {
            failing_allocator failing;
            failing_init(&failing, n);
            duct_context context = duct_context_default();
            context.allocator = &failing.allocator;
            duct_error error = {DUCT_OK, ""};
            duct_status status = churn(&context, sample, pressure != 0, &error);
            done = failing.calls < n;
            if (status != (done ? DUCT_OK : DUCT_NO_MEMORY)) {
                fail_msg("allocation %ld, pressure %d: status %d", n, pressure, (int)status);
            }
            assert_int_equal(failing.held, 0);
        }
    }
}

static void refusals_say_what_and_where(void **state)
{
    (void)state;
    assert_refused("", "svg", DUCT_BAD_FORMAT, "");
    assert_refused("<svg", "svg", DUCT_BAD_FORMAT, "line 1");
    assert_refused("<html xmlns='x'>\n</html>", "svg", DUCT_BAD_FORMAT,
                   "line 1: the document is <html>, not <svg>");
    assert_refused("<svg xmlns='http://example.org/'/>", "svg", DUCT_BAD_FORMAT, "not <svg>");
    assert_refused("\x1f\x8b\x08 compressed", NULL, DUCT_UNSUPPORTED, "gunzip");
}

static void entities_cannot_grow_without_bound(void **state)
{
    (void)state;
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    duct_text_add(&text, "<!DOCTYPE svg [<!ENTITY a 'lollollollollollollol'>");
    for (char c = 'b'; c < 'm'; c++) {
        duct_text_addf(&text, "<!ENTITY %c '", c);
        for (int i = 0; i < 10; i++) {
            duct_text_addf(&text, "&%c;", c - 1);
        }
        duct_text_add(&text, "'>");
    }
    duct_text_addf(&text, "]>" SVG "id='&l;'><path d='&l;' stroke='red'/></svg>");
    duct_error error;
    duct_drawing *drawing = NULL;
    duct_status status =
        duct_drawing_read_memory(NULL, text.data, text.size, "bomb.svg", NULL, NULL, &drawing, &error);
    assert_true(status == DUCT_LIMIT || status == DUCT_BAD_FORMAT);
    duct_text_free(&text);
}

static void deep_groups_are_refused(void **state)
{
    (void)state;
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    duct_text_add(&text, SVG ">");
    for (int i = 0; i < 100000; i++) {
        duct_text_add(&text, "<g>");
    }
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_int_equal(
        duct_drawing_read_memory(NULL, text.data, text.size, "deep.svg", NULL, NULL, &drawing, &error),
        DUCT_LIMIT);
    /* As deep as is allowed, with ids and names of all of them. */
    text.size = 0;
    duct_text_add(&text, SVG ">");
    for (int i = 0; i < 250; i++) {
        duct_text_add(&text, "<g>");
    }
    duct_text_add(&text, "<path stroke='red' d='M0 0h1'/>");
    for (int i = 0; i < 250; i++) {
        duct_text_add(&text, "</g>");
    }
    duct_text_add(&text, "</svg>");
    drawing = read_text(text.data);
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_drawing_free(drawing);
    duct_text_free(&text);
}

static void a_million_points_are_read_and_written(void **state)
{
    (void)state;
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    duct_text_add(&text, SVG "><path fill='none' stroke='red' d='M0 0");
    for (int i = 1; i < 1000000; i++) {
        duct_text_addf(&text, " L%d.%d %d", i / 10, i % 10, i % 7);
    }
    duct_text_add(&text, "'/></svg>");
    duct_drawing *drawing = read_text_as(text.data, text.size, NULL);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 1000000);
    duct_drawing_edit_stroke(drawing, 0);
    duct_drawing *back = write_and_read(drawing, "svg");
    assert_int_equal(duct_drawing_stroke_count(back), 1);
    duct_drawing_free(back);
    duct_drawing_free(drawing);
    duct_text_free(&text);
}

static void many_elements_take_linear_time(void **state)
{
    (void)state;
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    duct_text_add(&text, SVG "><style>");
    for (int i = 0; i < 200; i++) {
        duct_text_addf(&text, "g .c%d > path#p%d{stroke:red}", i, i);
    }
    duct_text_add(&text, "</style>}}}}<g stroke='blue'>");
    for (int i = 0; i < 50000; i++) {
        duct_text_add(&text, "<path id='same' d='M0 0h1'/><path d='M0 0h1'/>");
    }
    duct_text_add(&text, "</g></svg>");
    duct_drawing *drawing = read_text_as(text.data, text.size, NULL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 100000);
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 99999)), "g[1]/path[100000]");
    duct_error error;
    duct_drawing *fresh;
    assert_ok(duct_drawing_new(NULL, &fresh, &error));
    for (size_t i = 0; i < 100000; i++) {
        assert_ok(duct_drawing_add_copy(fresh, duct_drawing_stroke(drawing, i), NULL, &error));
    }
    duct_drawing_free(write_and_read(fresh, "svg"));
    duct_drawing_free(fresh);
    duct_drawing_free(drawing);
    duct_text_free(&text);
}

static void curves_too_large_to_flatten_are_refused(void **state)
{
    (void)state;
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    duct_text_add(&text, SVG "><path stroke='red' d='M0 0");
    for (int i = 0; i < 2000; i++) {
        duct_text_add(&text, "C9e8 9e8 -9e8 9e8 0 0");
    }
    duct_text_add(&text, "'/></svg>");
    assert_refused(text.data, "svg", DUCT_LIMIT, "line 1: the curves have more than");
    duct_text_free(&text);
}

static void odd_numbers_give_finite_strokes(void **state)
{
    (void)state;
    static const char *const bodies[] = {
        "<g transform='scale(1e308)'><path stroke='red' d='M1 1L2 2M0 0h0'/></g>",
        "<g transform='translate(NaN)'><path stroke='red' d='M1 1L2 2'/></g>",
        "<g transform='rotate(1e308)'><path stroke='red' d='M1 1L2 2'/></g>",
        "<g transform='skewX(90)'><path stroke='red' d='M1 1L2 2'/></g>",
        "<path stroke='red' stroke-width='1e308' d='M1 1L2 2'/>",
        "<path stroke='red' stroke-width='nan' d='M1 1L2 2'/>",
        "<path stroke='red' d='M1 1A1e308 1e-308 1e300 1 1 3 3'/>",
        "<path stroke='red' d='M1e308 1e308A1 1 0 1 1 -1e308 3'/>",
        "<path stroke='red' opacity='inf' d='M1 1A1 1 0 1 1 3 3'/>",
        "<rect stroke='red' x='-1e308' width='1e308' height='1e308' rx='1e308'/>",
        "<circle stroke='red' r='1e308'/>",
        "<circle stroke='red' r='inf'/>",
        "<svg width='0' viewBox='0 0 1 1'><path stroke='red' d='M1 1L2 2'/></svg>",
        "<svg width='-1' viewBox='0 0 -1 1'><path stroke='red' d='M1 1L2 2'/></svg>",
        "<use id='u' href='#u' stroke='red'/>",
        "<g id='a'><use href='#b'/></g><g id='b'><use href='#a'/></g>",
        "<polyline stroke='red' points='1,2 3'/><polyline stroke='red' points=''/><polygon stroke='red' "
        "points=','/>",
        "<path stroke='rgb(' d='M1 1L2 2'/><path stroke='url(' d='M1 1L2 2'/><path stroke='#' d='M1 1L2 2'/>",
        "<path style='stroke' d='M1 1L2 2'/><path style=':;;:red;stroke:' d='M1 1L2 2'/>",
        "<path transform='' stroke='red' d='M1 1L2 2'/><path transform=')' stroke='red' d='M1 1L2 2'/>",
        "<style>{}{{}}}@media{a,,b>{stroke:red}> a{stroke:red}a > > b{stroke:red}#{stroke:red}.{}'</style>"
        "<path stroke='red' d='M1 1L2 2'/>",
        "<style>@</style><style>@media "
        "all</style><style>a{</style><style>a:b{c:\"</style><style/><style>/*</style>"};
    for (size_t i = 0; i < sizeof bodies / sizeof *bodies; i++) {
        char svg[600];
        snprintf(svg, sizeof svg, SVG "width='10' height='10'>%s</svg>", bodies[i]);
        duct_drawing *drawing = read_text(svg);
        double box[4];
        duct_drawing_bounds(drawing, box);
        for (size_t k = 0; k < 4; k++) {
            assert_true(fabs(box[k]) <= 1e9);
        }
        for (size_t k = 0; k < duct_drawing_stroke_count(drawing); k++) {
            duct_stroke_style style = duct_stroke_get_style(duct_drawing_stroke(drawing, k));
            assert_true(isfinite(style.width) && style.opacity >= 0 && style.opacity <= 1);
        }
        duct_drawing_free(drawing);
        duct_error error = {DUCT_OK, ""};
        assert_int_equal(churn(NULL, svg, false, &error), DUCT_OK);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(truncated_files_are_refused),
        cmocka_unit_test(mutated_files_do_no_harm),
        cmocka_unit_test(failed_allocations_leak_nothing),
        cmocka_unit_test(refusals_say_what_and_where),
        cmocka_unit_test(entities_cannot_grow_without_bound),
        cmocka_unit_test(deep_groups_are_refused),
        cmocka_unit_test(a_million_points_are_read_and_written),
        cmocka_unit_test(many_elements_take_linear_time),
        cmocka_unit_test(curves_too_large_to_flatten_are_refused),
        cmocka_unit_test(odd_numbers_give_finite_strokes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
