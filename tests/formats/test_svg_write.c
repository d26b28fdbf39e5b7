/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is written as SVG: unchanged things stay, changed ones are shown. */
#include "testing.h"

#include "drawings.h"
#include "formats/xml.h"

#include <dirent.h>

#define SVG \
    "<svg xmlns='http://www.w3.org/2000/svg' xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' "

static char *write_text(const duct_drawing *drawing, duct_line_style line)
{
    duct_error error;
    char *data;
    size_t size;
    duct_format_options options = duct_format_options_default();
    options.line_style = line;
    assert_ok(duct_drawing_write_memory(NULL, drawing, "svg", &options, &data, &size, &error));
    xmlDoc *document;
    assert_ok(duct_xml_parse(data, size, &document, &error));
    xmlFreeDoc(document);
    return data;
}

static void press(duct_stroke *stroke)
{
    double *pressure = duct_stroke_edit(stroke, DUCT_PRESSURE);
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        pressure[i] = 0.7;
    }
}

/* Reads, changes stroke `index` (moves it by (1, 2); with pressure where asked), writes. */
static char *change(const char *svg, size_t index, bool pressure, duct_line_style line)
{
    duct_drawing *drawing = read_text(svg);
    duct_stroke *stroke = duct_drawing_edit_stroke(drawing, index);
    assert_non_null(stroke);
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        x[i] += 1;
        y[i] += 2;
    }
    if (pressure) {
        press(stroke);
    }
    char *text = write_text(drawing, line);
    duct_drawing_free(drawing);
    return text;
}

static void assert_change(const char *svg, size_t index, const char *expected)
{
    char *text = change(svg, index, false, DUCT_LINE_PATH);
    assert_string_equal(text, expected);
    duct_memory_free(NULL, text);
}

static void assert_holds(const char *text, const char *part)
{
    if (strstr(text, part) == NULL) {
        fail_msg("\"%s\" is not in:\n%s", part, text);
    }
}

static void assert_lacks(const char *text, const char *part)
{
    if (strstr(text, part) != NULL) {
        fail_msg("\"%s\" is in:\n%s", part, text);
    }
}

static const char *const rich =
    "\xef\xbb\xbf<?xml version='1.0' standalone=\"no\" ?>\r\n<!DOCTYPE svg [ <!-- ' > --> <!ENTITY e \"]>\"> "
    "]>\n"
    "<?pi > <path?>\n" SVG
    " width = '10'\n\theight='10'><!-- <path> --><metadata><x:y xmlns:x='u'>&e;&#65;</x:y></metadata>"
    "<style><![CDATA[ <path> ]]></style><text>a  b</text>\n"
    "  <path  id='a'\n  d='M0 0L5 0' stroke='red' ><title>t</title></path >\n"
    "  <path id='b' d='M0 1L5 1' stroke='red'/>\n</svg>\n<!-- end -->";

static void unchanged_drawings_come_back_byte_for_byte(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(rich);
    duct_drawing *copy;
    duct_error error;
    assert_ok(duct_drawing_copy(NULL, drawing, &copy, &error));
    duct_drawing_free(drawing);
    char *text = write_text(copy, DUCT_LINE_OUTLINE);
    assert_string_equal(text, rich);
    duct_memory_free(NULL, text);
    duct_drawing_free(copy);
}

static void only_the_changed_element_changes(void **state)
{
    (void)state;
    char expected[2000];
    const char *old = "d='M0 0L5 0'", *at = strstr(rich, old);
    snprintf(expected, sizeof expected, "%.*sd=\"M 1,2 L 6,2\"%s", (int)(at - rich), rich, at + strlen(old));
    /* The white space before `d` is normalised together with it. */
    char *found = strstr(expected, "\n  d=\"");
    memmove(found, found + 2, strlen(found + 2) + 1);
    assert_change(rich, 0, expected);
}

static void shapes_become_paths_and_keep_the_rest(void **state)
{
    (void)state;
    assert_change(SVG "><line x1='0' id='l' y1=\"0\" x2='4' y2='0' stroke='red' class='c' data-x='1'/></svg>",
                  0, SVG "><path id='l' stroke='red' class='c' data-x='1' d=\"M 1,2 L 5,2\"/></svg>");
    assert_change(SVG "><polyline points='0,0 4,0' stroke='red'><title>x</title></polyline></svg>", 0,
                  SVG "><path stroke='red' d=\"M 1,2 L 5,2\"><title>x</title></path></svg>");
    assert_change(SVG "><rect width='4' height='3' stroke='red' rx='0'/></svg>", 0,
                  SVG "><path stroke='red' d=\"M 1,2 L 5,2 L 5,5 L 1,5 Z\"/></svg>");
    char *text = change(SVG "><circle cx='5' cy='5' r='4' stroke='red'/></svg>", 0, false, DUCT_LINE_PATH);
    assert_lacks(text, "cx=");
    duct_drawing *back = read_text(text);
    assert_true(duct_stroke_closed(duct_drawing_stroke(back, 0)));
    for (size_t k = 0; k < duct_stroke_size(duct_drawing_stroke(back, 0)); k++) {
        assert_near(hypot(value_of(back, 0, DUCT_X, k) - 6, value_of(back, 0, DUCT_Y, k) - 7), 4, 0.2);
    }
    duct_drawing_free(back);
    duct_memory_free(NULL, text);
}

static void coordinates_are_the_elements_own(void **state)
{
    (void)state;
    assert_change(SVG "width='100' height='100' viewBox='0 0 10 10'><g transform='translate(5)'><path "
                      "transform='rotate(90)' d='M0 0L1 0' stroke='red'/></g></svg>",
                  0,
                  SVG "width='100' height='100' viewBox='0 0 10 10'><g transform='translate(5)'><path "
                      "transform='rotate(90)' d=\"M 0.2,-0.1 L 1.2,-0.1\" stroke='red'/></g></svg>");
}

static void unchanged_subpaths_keep_their_curves(void **state)
{
    (void)state;
    assert_change(SVG "><path d='M0 0C1 1 2 1 3 0zM5 5L9 5' stroke='red'/></svg>", 1,
                  SVG "><path d=\"M 0,0 C 1,1 2,1 3,0 Z M 6,7 L 10,7\" stroke='red'/></svg>");
}

static void what_would_compute_the_path_again_goes(void **state)
{
    (void)state;
    assert_change(SVG
                  "xmlns:sodipodi='s'><path sodipodi:type='arc' sodipodi:cx='1' inkscape:path-effect='#x' "
                  "inkscape:original-d='M0 0' d='M0 0L5 0' sodipodi:nodetypes='cc' inkscape:label='a' "
                  "stroke='red'/></svg>",
                  0,
                  SVG "xmlns:sodipodi='s'><path sodipodi:cx='1' d=\"M 1,2 L 6,2\" inkscape:label='a' "
                      "stroke='red'/></svg>");
}

static void prefixes_are_kept(void **state)
{
    (void)state;
    assert_change(
        "<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:line x2='5' stroke='red'></s:line></s:svg>", 0,
        "<s:svg xmlns:s='http://www.w3.org/2000/svg'><s:path stroke='red' d=\"M 1,2 L 6,2\"></s:path>"
        "</s:svg>");
}

static void other_encodings_are_written_as_utf8(void **state)
{
    (void)state;
    char *text =
        change("<?xml version='1.0' encoding='ISO-8859-1'?><svg xmlns='http://www.w3.org/2000/svg'><path "
               "id='\xe4' d='M0 0L5 0' stroke='red'/></svg>",
               0, false, DUCT_LINE_PATH);
    assert_holds(text, "encoding=\"UTF-8\"");
    assert_holds(text, "id=\"\xc3\xa4\"");
    assert_holds(text, "d=\"M 1,2 L 6,2\"");
    duct_memory_free(NULL, text);
}

static void changed_styles_are_written(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(SVG "><g transform='scale(2)' opacity='.5'><path style='stroke:red;fill:none' "
                      "d='M0 0L5 0'/></g></svg>");
    duct_stroke *stroke = duct_drawing_edit_stroke(drawing, 0);
    duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 1, 0.25f, 6});
    char *text = write_text(drawing, DUCT_LINE_PATH);
    assert_holds(text, "style=\"fill:none;stroke:#0000ff;stroke-opacity:0.5;stroke-width:3\"");
    duct_memory_free(NULL, text);
    duct_drawing_free(drawing);
}

static void pressure_becomes_a_filled_outline(void **state)
{
    (void)state;
    char *text =
        change(SVG "><style>path{stroke:red !important;stroke-dasharray:1}</style><path id='a' class='c' "
                   "style='fill:none;stroke-width:2;marker-end:url(#m);stroke-opacity:.5' d='M0 0L50 "
                   "0'/></svg>",
               0, true, DUCT_LINE_OUTLINE);
    assert_holds(text, "id='a' class='c' style=\"fill:#ff0000 !important;fill-opacity:0.5 !important;"
                       "stroke:none !important;marker:none !important\"");
    assert_holds(text, "Z\"");
    assert_lacks(text, "stroke-width");
    /* The outline is as wide as the stroke and lies where the stroke is. */
    duct_drawing *back = read_text(text);
    double box[4];
    assert_true(duct_drawing_bounds(back, box));
    assert_true(box[0] < 1 && box[0] > -3 && box[2] > 51 && box[2] < 55);
    assert_true(box[1] < 2 && box[1] > -2 && box[3] > 2 && box[3] < 6);
    duct_drawing_free(back);
    duct_memory_free(NULL, text);
}

static void gradients_paint_the_outline(void **state)
{
    (void)state;
    char *text =
        change(SVG "><linearGradient id='g'><stop stop-color='red'/></linearGradient><path fill='none' "
                   "stroke='url(#g)' d='M0 0L50 0'/></svg>",
               0, true, DUCT_LINE_OUTLINE);
    assert_holds(text, "style=\"fill:url(#g);");
    duct_memory_free(NULL, text);
}

static void filled_shapes_keep_their_fill_below_the_outline(void **state)
{
    (void)state;
    char *text = change(
        SVG ">\n  <rect id='a' width='50' height='50' fill='lime' stroke='red'><title>t</title></rect>\n"
            "  <g id='a-line'/></svg>",
        0, true, DUCT_LINE_OUTLINE);
    assert_holds(text, "<path id='a' fill='lime' stroke='red' d=\"M ");
    assert_holds(
        text,
        " style=\"stroke:none;marker:none\"><title>t</title></path>\n  <path id=\"a-line-2\" fill='lime'");
    assert_holds(text, "style=\"fill:#ff0000;fill-opacity:1;stroke:none;marker:none\"/>\n  <g id='a-line'/>");
    duct_memory_free(NULL, text);
    text = change(SVG "><rect id='a' width='50' height='50' stroke='red'/></svg>", 0, true, DUCT_LINE_PATH);
    assert_lacks(text, "-line");
    duct_memory_free(NULL, text);
}

static void outlines_of_fills_are_restyled_as_fills(void **state)
{
    (void)state;
    char *text = change(SVG "><path fill='lime' d='M0 0H50V50Z'/></svg>", 0, true, DUCT_LINE_OUTLINE);
    assert_holds(text, "<path fill='lime' d=\"M 1,2 L 51,2 L 51,52 Z\"/>");
    duct_memory_free(NULL, text);
}

/* A drawing like `from` with some of its strokes. */
static duct_drawing *choose(const duct_drawing *from, const size_t *indices, size_t count)
{
    duct_error error;
    duct_drawing *made;
    assert_ok(duct_drawing_like(NULL, from, &made, &error));
    for (size_t i = 0; i < count; i++) {
        assert_ok(duct_drawing_add_copy(made, duct_drawing_stroke(from, indices[i]), NULL, &error));
    }
    return made;
}

static void removed_strokes_remove_their_subpaths(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(SVG "stroke='red'>\n<path d='M0 0H1M0 1H1M0 2H1'/>\n<path d='M0 3H1'/>\n"
                      "<rect width='1' height='1'/>\n</svg>");
    duct_drawing *some = choose(drawing, (size_t[]){0, 2, 4}, 3);
    char *text = write_text(some, DUCT_LINE_PATH);
    assert_string_equal(text, SVG "stroke='red'>\n<path d=\"M 0,0 L 1,0 M 0,2 L 1,2\"/>\n"
                                  "<rect width='1' height='1'/>\n</svg>");
    duct_memory_free(NULL, text);
    duct_drawing_free(some);
    some = choose(drawing, NULL, 0);
    text = write_text(some, DUCT_LINE_PATH);
    assert_string_equal(text, SVG "stroke='red'>\n</svg>");
    duct_memory_free(NULL, text);
    duct_drawing_free(some);
    duct_drawing_free(drawing);
}

static void several_strokes_of_one_part_share_its_element(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SVG "><path stroke='red' d='M0 0H5'/></svg>");
    duct_drawing *twice = choose(drawing, (size_t[]){0, 0}, 2);
    duct_stroke_edit(duct_drawing_edit_stroke(twice, 1), DUCT_Y)[0] = 7;
    char *text = write_text(twice, DUCT_LINE_PATH);
    assert_string_equal(text, SVG "><path stroke='red' d=\"M 0,0 L 5,0 M 0,7 L 5,0\"/></svg>");
    duct_memory_free(NULL, text);
    duct_drawing_free(twice);
    duct_drawing_free(drawing);
}

static void add_line(duct_drawing *drawing, const char *id, const char *group, double y)
{
    duct_error error;
    duct_stroke *stroke;
    assert_ok(duct_drawing_add_stroke(drawing, id, 2, &stroke, &error));
    assert_ok(duct_stroke_set_group(stroke, group, &error));
    duct_stroke_edit(stroke, DUCT_X)[1] = 10;
    duct_stroke_edit(stroke, DUCT_Y)[0] = y;
    duct_stroke_edit(stroke, DUCT_Y)[1] = y;
    duct_stroke_set_style(stroke, (duct_stroke_style){1, 0, 0, 0.5f, 2});
}

static void new_strokes_come_last_in_the_page_s_coordinates(void **state)
{
    (void)state;
    const char *svg =
        SVG "width='100' height='100' viewBox='0 0 10 10'>\n<path id='a' stroke='red' d='M0 0H5'/>\n</svg>";
    duct_drawing *drawing = read_text(svg);
    add_line(drawing, "a", "", 20);
    char *text = write_text(drawing, DUCT_LINE_PATH);
    assert_string_equal(text, SVG
                        "width='100' height='100' viewBox='0 0 10 10'>\n<path id='a' stroke='red' d='M0 "
                        "0H5'/>\n<path id=\"a-2\" style=\"fill:none;stroke:#ff0000;stroke-opacity:0.5;"
                        "stroke-width:0.2;stroke-linecap:round;stroke-linejoin:round\" d=\"M 0,2 L 1,2\"/>\n"
                        "</svg>");
    duct_memory_free(NULL, text);
    duct_drawing_free(drawing);
    drawing = read_text("<s:svg xmlns:s='http://www.w3.org/2000/svg' />");
    add_line(drawing, "x", "", 2);
    text = write_text(drawing, DUCT_LINE_PATH);
    assert_holds(text, "<s:svg xmlns:s='http://www.w3.org/2000/svg' >\n<s:path id=\"x\"");
    assert_holds(text, "</s:svg>");
    duct_memory_free(NULL, text);
    duct_drawing_free(drawing);
}

static void fresh_documents_hold_everything(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    duct_drawing_set_page(drawing, 200, 100);
    assert_ok(duct_drawing_annotate(drawing, "title", "A & <B>", &error));
    assert_ok(duct_drawing_annotate(drawing, "artist", "M\"e", &error));
    add_line(drawing, "one", "", 1);
    add_line(drawing, "two", "layer/inner", 2);
    add_line(drawing, "two", "layer", 3);
    add_line(drawing, "", "other", 4);
    add_line(drawing, "five", "layer/inner", 5);
    char *text = write_text(drawing, DUCT_LINE_OUTLINE);
    assert_holds(text, "width=\"200\" height=\"100\" viewBox=\"0 0 200 100\"");
    duct_drawing *back = read_text(text);
    static const char *const expected[][2] = {{"one", ""},
                                              {"two", "layer/inner"},
                                              {"two-2", "layer"},
                                              {"other/path[1]", "other"},
                                              {"five", "layer-2/inner-2"}};
    assert_int_equal(duct_drawing_stroke_count(back), 5);
    for (size_t i = 0; i < 5; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(back, i);
        assert_string_equal(duct_stroke_id(stroke), expected[i][0]);
        assert_string_equal(duct_stroke_group(stroke), expected[i][1]);
        assert_near(value_of(back, i, DUCT_Y, 1), (double)i + 1, 1e-3);
        duct_stroke_style style = duct_stroke_get_style(stroke);
        assert_near((double)style.red + (double)style.opacity + style.width, 3.5, 1e-6);
    }
    assert_string_equal(duct_drawing_annotation(back, "title"), "A & <B>");
    assert_string_equal(duct_drawing_annotation(back, "artist"), "M\"e");
    duct_drawing_free(back);
    duct_memory_free(NULL, text);
    duct_drawing_free(drawing);
}

static void fresh_documents_without_page_show_all_strokes(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    char *text = write_text(drawing, DUCT_LINE_OUTLINE);
    duct_memory_free(NULL, text);
    add_line(drawing, "one", "/odd//group/", -50);
    duct_drawing_set_resolution(drawing, 192);
    text = write_text(drawing, DUCT_LINE_OUTLINE);
    assert_holds(text, "width=\"9\" height=\"4\" viewBox=\"-4 -54 18 8\"");
    duct_memory_free(NULL, text);
    duct_drawing_free(drawing);
}

static void dots_stay_dots(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing;
    duct_stroke *stroke;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    assert_ok(duct_drawing_add_stroke(drawing, "dot", 1, &stroke, &error));
    assert_ok(duct_drawing_add_stroke(drawing, "nothing", 0, &stroke, &error));
    duct_drawing *back = write_and_read(drawing, "svg");
    assert_int_equal(duct_drawing_stroke_count(back), 1);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(back, 0)), 1);
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

/* The largest distance of a sample of one stroke from the other's polyline. */
static double farthest(const duct_drawing *a, const duct_drawing *b, size_t index)
{
    double most = 0;
    size_t size = duct_stroke_size(duct_drawing_stroke(b, index));
    bool closed = duct_stroke_closed(duct_drawing_stroke(b, index));
    for (size_t k = 0; k < duct_stroke_size(duct_drawing_stroke(a, index)); k++) {
        double x = value_of(a, index, DUCT_X, k), y = value_of(a, index, DUCT_Y, k), least = INFINITY;
        for (size_t i = 0; i < size; i++) {
            size_t next = i + 1 < size ? i + 1 : closed ? 0 : i;
            double x0 = value_of(b, index, DUCT_X, i), y0 = value_of(b, index, DUCT_Y, i);
            double dx = value_of(b, index, DUCT_X, next) - x0, dy = value_of(b, index, DUCT_Y, next) - y0;
            double square = dx * dx + dy * dy, t = square > 0 ? ((x - x0) * dx + (y - y0) * dy) / square : 0;
            t = fmin(fmax(t, 0), 1);
            least = fmin(least, hypot(x0 + t * dx - x, y0 + t * dy - y));
        }
        most = fmax(most, least);
    }
    return most;
}

static void refitted_lineart_stays_in_place(void **state)
{
    (void)state;
    const char *data = shared_data();
    if (data == NULL) {
        skip();
    }
    char folder[5000], path[6000];
    snprintf(folder, sizeof folder, "%s/svg_lineart", data);
    DIR *list = opendir(folder);
    assert_non_null(list);
    size_t files = 0;
    for (struct dirent *entry = readdir(list); entry != NULL; entry = readdir(list)) {
        size_t length = strlen(entry->d_name);
        if (length < 4 || strcmp(entry->d_name + length - 4, ".svg") != 0) {
            continue;
        }
        files++;
        duct_error error;
        duct_drawing *drawing;
        snprintf(path, sizeof path, "%s/%s", folder, entry->d_name);
        assert_ok(duct_drawing_read(NULL, path, NULL, &drawing, &error));
        size_t count = duct_drawing_stroke_count(drawing);
        assert_true(count > 10);
        for (size_t i = 0; i < count; i++) {
            duct_drawing_edit_stroke(drawing, i);
        }
        char *text = write_text(drawing, DUCT_LINE_PATH);
        duct_drawing *back = read_text(text);
        assert_int_equal(duct_drawing_stroke_count(back), count);
        for (size_t i = 0; i < count; i++) {
            const duct_stroke *a = duct_drawing_stroke(drawing, i), *b = duct_drawing_stroke(back, i);
            assert_string_equal(duct_stroke_id(a), duct_stroke_id(b));
            assert_int_equal(duct_stroke_closed(a), duct_stroke_closed(b));
            double distance = fmax(farthest(drawing, back, i), farthest(back, drawing, i));
            if (distance > 0.3) {
                fail_msg("%s: %s: %g pixels off", entry->d_name, duct_stroke_id(a), distance);
            }
        }
        duct_drawing_free(back);
        duct_memory_free(NULL, text);
        duct_drawing_free(drawing);
    }
    closedir(list);
    assert_true(files > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(unchanged_drawings_come_back_byte_for_byte),
        cmocka_unit_test(only_the_changed_element_changes),
        cmocka_unit_test(shapes_become_paths_and_keep_the_rest),
        cmocka_unit_test(coordinates_are_the_elements_own),
        cmocka_unit_test(unchanged_subpaths_keep_their_curves),
        cmocka_unit_test(what_would_compute_the_path_again_goes),
        cmocka_unit_test(prefixes_are_kept),
        cmocka_unit_test(other_encodings_are_written_as_utf8),
        cmocka_unit_test(changed_styles_are_written),
        cmocka_unit_test(pressure_becomes_a_filled_outline),
        cmocka_unit_test(gradients_paint_the_outline),
        cmocka_unit_test(filled_shapes_keep_their_fill_below_the_outline),
        cmocka_unit_test(outlines_of_fills_are_restyled_as_fills),
        cmocka_unit_test(removed_strokes_remove_their_subpaths),
        cmocka_unit_test(several_strokes_of_one_part_share_its_element),
        cmocka_unit_test(new_strokes_come_last_in_the_page_s_coordinates),
        cmocka_unit_test(fresh_documents_hold_everything),
        cmocka_unit_test(fresh_documents_without_page_show_all_strokes),
        cmocka_unit_test(dots_stay_dots),
        cmocka_unit_test(refitted_lineart_stays_in_place),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
