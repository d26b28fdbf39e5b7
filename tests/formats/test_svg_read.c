/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is read from SVG: geometry, coordinates, styles, what is drawn and what is not. */
#include "testing.h"

#include "drawings.h"

#define SVG "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' "
#define STROKED "fill='none' stroke='black' "

/* Reads one path and compares its stroke `index` with the points "x,y x,y ...". */
static void assert_points(const char *svg, size_t index, const char *expected)
{
    duct_drawing *drawing = read_text(svg);
    const duct_stroke *stroke = duct_drawing_stroke(drawing, index);
    assert_non_null(stroke);
    const char *s = expected;
    size_t count = 0;
    for (; *s != '\0'; count++) {
        char *end;
        double x = strtod(s, &end), y = strtod(end + 1, &end);
        assert_near(value_of(drawing, index, DUCT_X, count), x, 1e-6);
        assert_near(value_of(drawing, index, DUCT_Y, count), y, 1e-6);
        s = end + strspn(end, " ");
    }
    assert_int_equal(duct_stroke_size(stroke), count);
    duct_drawing_free(drawing);
}

static void assert_path(const char *d, size_t index, const char *expected)
{
    char svg[1000];
    snprintf(svg, sizeof svg, SVG "><path " STROKED "d='%s'/></svg>", d);
    assert_points(svg, index, expected);
}

static size_t count_strokes(const char *svg)
{
    duct_drawing *drawing = read_text(svg);
    size_t count = duct_drawing_stroke_count(drawing);
    duct_drawing_free(drawing);
    return count;
}

static size_t count_subpaths(const char *d)
{
    char svg[1000];
    snprintf(svg, sizeof svg, SVG "><path " STROKED "d='%s'/></svg>", d);
    return count_strokes(svg);
}

static void path_data_has_all_straight_commands(void **state)
{
    (void)state;
    assert_path("M1 2L3 4H5V6Z", 0, "1,2 3,4 5,4 5,6");
    assert_path("m1 2l3 4h5v6z", 0, "1,2 4,6 9,6 9,12");
    assert_path("M1,2 3,4 5,6", 0, "1,2 3,4 5,6");
    assert_path("m1,2 3,4 5,6", 0, "1,2 4,6 9,12");
    assert_path(" M 1-2.5.5-1e1 L+3 4 ", 0, "1,-2.5 0.5,-10 3,4");
    assert_path("M0 0H1 2 3V1 2", 0, "0,0 1,0 2,0 3,0 3,1 3,2");
}

static void path_data_goes_on_from_a_closed_subpath(void **state)
{
    (void)state;
    assert_path("M1 1h2v2z l5 5", 1, "1,1 6,6");
    assert_path("M1 1h2v2z m5 5h1", 1, "6,6 7,6");
    assert_int_equal(count_subpaths("M0 0h1 M5 5 M6 6h1 M7 7"), 2); /* bare moves draw nothing */
    assert_int_equal(count_subpaths("M0 0z"), 1);                   /* but a dot is drawn */
}

/* The curve's point at parameter 1/2 is on the line, to the tolerance: seen at the extreme of y. */
static double lowest(const char *d)
{
    char svg[1000];
    double box[4];
    snprintf(svg, sizeof svg, SVG "><path " STROKED "d='%s'/></svg>", d);
    duct_drawing *drawing = read_text(svg);
    assert_true(duct_drawing_bounds(drawing, box));
    duct_drawing_free(drawing);
    return box[3];
}

static void path_data_has_all_curves(void **state)
{
    (void)state;
    assert_near(lowest("M0 0C0 100 100 100 100 0"), 75, 0.1);
    assert_near(lowest("M10 10c0 100 100 100 100 0"), 85, 0.1);
    assert_near(lowest("M0 0Q50 100 100 0"), 50, 0.1);
    assert_near(lowest("M0 0q50 100 100 0"), 50, 0.1);
    /* Smooth ones mirror the control point: below becomes above, and below again. */
    assert_near(lowest("M0 0C0 -100 100 -100 100 0S200 100 200 0"), 75, 0.1);
    assert_near(lowest("M0 0c0 -100 100 -100 100 0s100 100 100 0"), 75, 0.1);
    assert_near(lowest("M0 0Q50 -100 100 0T200 0"), 50, 0.1);
    assert_near(lowest("M0 0q50 -100 100 0t100 0"), 50, 0.1);
    /* Without a curve of the same kind before it, the control point is the current point. */
    assert_near(lowest("M0 0L0 0S100 100 100 0"), 400.0 / 9, 0.1);
    assert_near(lowest("M0 0C0 -100 100 -100 100 0T200 0"), 0, 0.1);
}

static void arc_flags_may_be_glued(void **state)
{
    (void)state;
    assert_near(lowest("M0 0a50 50 0 0 0 100 0"), 50, 0.1);
    assert_near(lowest("M0 0a50 50 0 00100 0"), 50, 0.1);
    assert_near(lowest("M0 0a50 50 0 0 0100,0"), 50, 0.1);
    duct_drawing *drawing = read_text(SVG "><path " STROKED "d='M0 0a1 1 0 01.5.5'/></svg>");
    const duct_stroke *stroke = duct_drawing_stroke(drawing, 0);
    size_t last = duct_stroke_size(stroke) - 1;
    assert_near(value_of(drawing, 0, DUCT_X, last), 0.5, 1e-9);
    assert_near(value_of(drawing, 0, DUCT_Y, last), 0.5, 1e-9);
    duct_drawing_free(drawing);
}

static void errors_in_path_data_keep_what_came_before(void **state)
{
    (void)state;
    assert_path("M1 2L3 4L5", 0, "1,2 3,4");
    assert_path("M1 2L3 4X5 6L7 8", 0, "1,2 3,4");
    assert_path("M1 2L3 4L5,,6", 0, "1,2 3,4");
    assert_path("M1 2L3 4L1e999 0", 0, "1,2 3,4");
    assert_path("M1 2L3 4 nan 5", 0, "1,2 3,4");
    assert_path("M1 2L3 4A1 1 0 2 0 9 9", 0, "1,2 3,4");
    assert_path("M1 2 3 4,", 0, "1,2 3,4");
    assert_int_equal(count_subpaths("L1 2 3 4"), 0);
    assert_int_equal(count_subpaths(""), 0);
    assert_int_equal(count_subpaths("M1e308 0l1e308 0l1e308 0"), 0); /* farther than any page */
}

static void basic_shapes_are_strokes(void **state)
{
    (void)state;
    assert_points(SVG "><rect " STROKED "x='1' y='2' width='3' height='4'/></svg>", 0, "1,2 4,2 4,6 1,6");
    assert_points(SVG "><line " STROKED "x1='1' y1='2' x2='3'/></svg>", 0, "1,2 3,0");
    assert_points(SVG "><polyline " STROKED "points='1,2 3,4,5 6 7'/></svg>", 0, "1,2 3,4 5,6");
    assert_points(SVG "><polygon " STROKED "points='1,2 3,4 5,6 1,2'/></svg>", 0, "1,2 3,4 5,6");
    duct_drawing *drawing =
        read_text(SVG "width='200' height='200'><circle " STROKED "cx='50%' cy='100' r='50'/>"
                      "<ellipse " STROKED "cx='100' cy='100' rx='20' ry='10'/>"
                      "<rect " STROKED "width='100' height='50' rx='10'/></svg>");
    assert_int_equal(duct_drawing_stroke_count(drawing), 3);
    for (size_t i = 0; i < 3; i++) {
        assert_true(duct_stroke_closed(duct_drawing_stroke(drawing, i)));
    }
    for (size_t k = 0; k < duct_stroke_size(duct_drawing_stroke(drawing, 0)); k++) {
        double x = value_of(drawing, 0, DUCT_X, k) - 100, y = value_of(drawing, 0, DUCT_Y, k) - 100;
        assert_near(hypot(x, y), 50, 0.05);
        assert_true(k >= duct_stroke_size(duct_drawing_stroke(drawing, 1)) ||
                    fabs(hypot((value_of(drawing, 1, DUCT_X, k) - 100) / 20,
                               (value_of(drawing, 1, DUCT_Y, k) - 100) / 10) -
                         1) < 0.01);
    }
    assert_near(value_of(drawing, 2, DUCT_X, 0), 10, 1e-9); /* ry is rx */
    assert_near(value_of(drawing, 2, DUCT_Y, 0), 0, 1e-9);
    duct_drawing_free(drawing);
    assert_int_equal(count_strokes(SVG "><rect " STROKED "width='0' height='3'/><circle " STROKED
                                       "r='-1'/><ellipse " STROKED "/><rect " STROKED "/></svg>"),
                     0);
}

static void transforms_multiply_from_the_left(void **state)
{
    (void)state;
#define LINE "<path " STROKED "d='M1 0L2 0'/>"
    assert_points(SVG "><g transform='translate(10) scale(2,3)'>" LINE "</g></svg>", 0, "12,0 14,0");
    assert_points(SVG "><g transform='translate(10,5)'><g transform='rotate(90)'>" LINE "</g></g></svg>", 0,
                  "10,6 10,7");
    assert_points(SVG "><g transform='rotate(90, 1 0),translate(0 1)'>" LINE "</g></svg>", 0, "0,0 0,1");
    assert_points(SVG "><g transform='matrix(1 2 3 4 5 6)'>" LINE "</g></svg>", 0, "6,8 7,10");
    assert_points(SVG "><g transform='skewX(45)skewY(45)'>" LINE "</g></svg>", 0, "2,1 4,2");
    assert_points(SVG "><g style='transform:translate(3px,4px)' transform='scale(9)'>" LINE "</g></svg>", 0,
                  "4,4 5,4");
    /* A malformed list counts as none. */
    assert_points(SVG "><g transform='scale(2) wobble(3)'>" LINE "</g></svg>", 0, "1,0 2,0");
    assert_points(SVG "><g transform='scale(2'>" LINE "</g></svg>", 0, "1,0 2,0");
    /* A singular map draws nothing. */
    assert_int_equal(count_strokes(SVG "><g transform='scale(0)'>" LINE "</g></svg>"), 0);
    assert_int_equal(count_strokes(SVG "><g transform='matrix(1 2 2 4 0 0)'>" LINE "</g></svg>"), 0);
    assert_int_equal(
        count_strokes(SVG "><g transform='scale(1e308)'><g transform='scale(1e308)'>" LINE "</g></g></svg>"),
        0);
}

static void pages_come_in_all_units(void **state)
{
    (void)state;
    static const struct {
        const char *attributes;
        double width, height, x, y; /* of the page; where (1, 1) lands */
    } cases[] = {
        {"width='100' height='50'", 100, 50, 1, 1},
        {"width='1in' height='2.54cm'", 96, 96, 1, 1},
        {"width='25.4mm' height='72pt'", 96, 96, 1, 1},
        {"width='6pc' height='101.6Q'", 96, 96, 1, 1},
        {"width='1em' height='1ex'", 16, 8, 1, 1},
        {"viewBox='0 0 30 40'", 30, 40, 1, 1},
        {"viewBox='0 0 30 40' width='100%' height='100%'", 0, 0, 1, 1},
        {"viewBox='0 0 30 40' width='60'", 60, 80, 2, 2},
        {"viewBox='0,0,30,40' height='80'", 60, 80, 2, 2},
        {"viewBox='0 0 10 10' width='100' height='50'", 100, 50, 30, 5},
        {"viewBox='0 0 10 10' width='100' height='50' preserveAspectRatio='none'", 100, 50, 10, 5},
        {"viewBox='0 0 10 10' width='100' height='50' preserveAspectRatio='xMinYMin'", 100, 50, 5, 5},
        {"viewBox='0 0 10 10' width='100' height='50' preserveAspectRatio='xMaxYMax meet'", 100, 50, 55, 5},
        {"viewBox='0 0 10 10' width='100' height='50' preserveAspectRatio='xMidYMin slice'", 100, 50, 10, 10},
        {"viewBox='1 1 10 10' width='10' height='10'", 10, 10, 0, 0},
        {"", 0, 0, 1, 1},
        {"width='0' height='10'", 0, 0, 1, 1},
        {"width='-5' height='10'", 0, 0, 1, 1},
        {"width='5furlongs' height='10'", 0, 0, 1, 1},
        {"width='10' height='10' viewBox='0 0 -5 5'", 10, 10, 1, 1},
        {"width='10' height='10' viewBox='0 0 0 0'", 10, 10, 1, 1},
        {"width='10' height='10' viewBox='0 0 nan 5'", 10, 10, 1, 1},
        {"width='1e999' height='10'", 0, 0, 1, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        if (i == 6) {
            continue; /* percentages of a page of unknown size: see below */
        }
        char svg[600];
        snprintf(svg, sizeof svg, SVG "%s><path " STROKED "d='M1 1h1'/></svg>", cases[i].attributes);
        duct_drawing *drawing = read_text(svg);
        assert_near(duct_drawing_width(drawing), cases[i].width, 1e-9);
        assert_near(duct_drawing_height(drawing), cases[i].height, 1e-9);
        assert_near(value_of(drawing, 0, DUCT_X, 0), cases[i].x, 1e-9);
        assert_near(value_of(drawing, 0, DUCT_Y, 0), cases[i].y, 1e-9);
        duct_drawing_free(drawing);
    }
    duct_drawing *drawing =
        read_text(SVG "viewBox='0 0 30 40' width='100%' height='100%'><path " STROKED "d='M1 1h1'/></svg>");
    assert_near(duct_drawing_width(drawing), 30, 1e-9);
    assert_near(duct_drawing_height(drawing), 40, 1e-9);
    duct_drawing_free(drawing);
}

static void inner_viewports_have_their_own_coordinates(void **state)
{
    (void)state;
    assert_points(SVG
                  "width='100' height='100'><svg x='10' y='20' width='50' height='50' viewBox='0 0 10 10'>"
                  "<line " STROKED "x1='0' y1='0' x2='50%' y2='50%'/></svg></svg>",
                  0, "10,20 35,45");
}

/* Reads one stroke's style. */
static duct_stroke_style style_of(const char *svg)
{
    duct_drawing *drawing = read_text(svg);
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_stroke_style style = duct_stroke_get_style(duct_drawing_stroke(drawing, 0));
    duct_drawing_free(drawing);
    return style;
}

static void assert_color(const char *value, double red, double green, double blue, double opacity)
{
    char svg[400];
    snprintf(svg, sizeof svg, SVG "><path d='M0 0h1' color='lime' stroke='%s'/></svg>", value);
    duct_stroke_style style = style_of(svg);
    assert_near((double)style.red, red, 0.003);
    assert_near((double)style.green, green, 0.003);
    assert_near((double)style.blue, blue, 0.003);
    assert_near((double)style.opacity, opacity, 0.003);
}

static void colours_come_in_all_spellings(void **state)
{
    (void)state;
    assert_color("red", 1, 0, 0, 1);
    assert_color("RebeccaPurple", 0.4, 0.2, 0.6, 1);
    assert_color("#f80", 1, 0.533, 0, 1);
    assert_color("#f808", 1, 0.533, 0, 0.533);
    assert_color("#FF8000", 1, 0.502, 0, 1);
    assert_color("#ff800080", 1, 0.502, 0, 0.502);
    assert_color("rgb(255, 128,0)", 1, 0.502, 0, 1);
    assert_color("rgb(100%,50%,0%)", 1, 0.5, 0, 1);
    assert_color("rgb(300 0 -5)", 1, 0, 0, 1);
    assert_color("rgba(255,128,0,0.25)", 1, 0.502, 0, 0.25);
    assert_color("rgb(255 128 0 / 25%)", 1, 0.502, 0, 0.25);
    assert_color("hsl(120, 100%, 50%)", 0, 1, 0, 1);
    assert_color("hsl(-120deg 100% 25%)", 0, 0, 0.5, 1);
    assert_color("currentColor", 0, 1, 0, 1);
    assert_color("url(#nothing) blue", 0, 0, 1, 1);
}

static void gradients_give_their_first_stop(void **state)
{
    (void)state;
    duct_stroke_style style = style_of(
        SVG "><defs><linearGradient id='a'><stop style='stop-color:#0000ff'/><stop/></linearGradient>"
            "<radialGradient id='b' xlink:href='#a'/><linearGradient id='c' href='#c'/></defs>"
            "<path d='M0 0h1' stroke='url(#b)'/></svg>");
    assert_near((double)style.blue, 1, 0);
    assert_int_equal(count_strokes(SVG
                                   "><linearGradient id='c' href='#c'/><path d='M0 0h1' stroke='url(#c)'/>"
                                   "</svg>"),
                     1);
}

static void styles_cascade_as_css_says(void **state)
{
    (void)state;
    static const struct {
        const char *sheet, *attributes;
        double red; /* the stroke's; widths would do as well */
    } cases[] = {
        {"", "stroke='#ff0000'", 1},
        {"", "stroke='blue' style='stroke:red'", 1},
        {"path{stroke:red}", "stroke='blue'", 1},
        {"path{stroke:red}", "style='stroke:blue'", 0},
        {"path{stroke:red!important}", "style='stroke:blue'", 1},
        {"path{stroke:red ! important}", "style='stroke:blue!important'", 0},
        {".a{stroke:red}path{stroke:blue}", "class='b a'", 1},
        {"#i{stroke:red}.a{stroke:blue}", "class='a' id='i'", 1},
        {"path.a{stroke:red}.a{stroke:blue}", "class='a'", 1},
        {"*{stroke:blue}path{stroke:red}*{stroke:blue}", "", 1},
        {".a{stroke:blue}.b{stroke:red}", "class='b a'", 1},
        {"rect,path , .x{stroke:red}", "", 1},
        {"g path{stroke:red}", "", 1},
        {"svg g > path{stroke:red}", "", 1},
        {"svg > path{stroke:red}path{stroke:blue}", "", 0},
        {"svg > g path#i{stroke:red}", "id='i'", 1},
        {"path:hover{stroke:blue}path{stroke:red}path[d]{stroke:blue}", "", 1},
        {"/* path{} */path{/*;*/stroke:red;}/*", "", 1},
        {"@import url(x;y);@media print{path{stroke:blue}}path{stroke:red}@font-face{a:b}", "", 1},
        {"@media screen{path{stroke:red}}", "", 1},
        {"path{stroke:nonsense}", "stroke='red'", 0},
        {"}}}path{stroke:red", "", 1},
        {"<!-- path{stroke:red} -->", "", 1},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char svg[800];
        snprintf(svg, sizeof svg,
                 SVG
                 "><style type='text/css'><![CDATA[%s]]></style><g stroke='#000001'><path d='M0 0h1' %s/></g>"
                 "</svg>",
                 cases[i].sheet, cases[i].attributes);
        duct_stroke_style style = style_of(svg);
        if (fabs((double)style.red - cases[i].red) > 0) {
            fail_msg("case %zu: %s | %s: red is %g", i, cases[i].sheet, cases[i].attributes,
                     (double)style.red);
        }
    }
}

static void widths_follow_units_and_transforms(void **state)
{
    (void)state;
    assert_near(style_of(SVG "><path d='M0 0h1' stroke='red'/></svg>").width, 1, 1e-9);
    assert_near(style_of(SVG "><path d='M0 0h1' stroke='red' stroke-width='1mm'/></svg>").width, 96 / 25.4,
                1e-9);
    assert_near(
        style_of(
            SVG "><g transform='scale(2,8)' style='stroke-width:3'><path d='M0 0h1' stroke='red'/></g></svg>")
            .width,
        12, 1e-9);
    assert_near(
        style_of(SVG "width='30' height='40'><path d='M0 0h1' stroke='red' stroke-width='10%'/></svg>").width,
        50 / sqrt(2) / 10, 1e-9);
    assert_near(style_of(SVG "><path transform='scale(5)' vector-effect='non-scaling-stroke' d='M0 0h1' "
                             "stroke='red' stroke-width='3'/></svg>")
                    .width,
                3, 1e-9);
    assert_near(
        style_of(SVG "font-size='20px'><path d='M0 0h1' stroke='red' stroke-width='.5em'/></svg>").width, 10,
        1e-9);
}

static void opacities_multiply(void **state)
{
    (void)state;
    duct_stroke_style style =
        style_of(SVG "><g opacity='.5'><g opacity='50%'><path d='M0 0h1' stroke='#ff000080' "
                     "stroke-opacity='.5' opacity='.5'/></g></g></svg>");
    assert_near((double)style.opacity, 0.5 * 0.5 * 0.5 * 0.5 * 128 / 255, 1e-6);
}

static void what_is_not_drawn_is_not_read(void **state)
{
    (void)state;
#define P "<path d='M0 0h1' stroke='red'/>"
    assert_int_equal(count_strokes(SVG "><defs>" P "</defs><symbol>" P "</symbol><clipPath>" P
                                       "</clipPath><mask>" P "</mask><pattern>" P "</pattern><marker>" P
                                       "</marker><text>" P "</text><foreignObject>" P
                                       "</foreignObject><unknown>" P "</unknown>"
                                       "<g display='none'>" P "</g><g style='display:none'>" P "</g>"
                                       "<g visibility='hidden'>" P "</g><g opacity='0'>" P "</g>"
                                       "<use href='#x'/><image href='x.png'/>"
                                       "<path d='M0 0h1' stroke='none'/><path d='M0 0h1' stroke='red' "
                                       "stroke-width='0'/><path d='M0 0h1' stroke='red' stroke-opacity='0'/>"
                                       "<path d='M0 0h1' stroke='transparent'/><path stroke='red'/>"
                                       "<a>" P "</a></svg>"),
                     1);
    assert_int_equal(count_strokes(SVG "><g visibility='hidden'><path visibility='visible' d='M0 0h1' "
                                       "stroke='red'/>" P "</g></svg>"),
                     1);
    assert_int_equal(
        count_strokes(SVG "><switch><foreignObject requiredExtensions='x'/>" P P "</switch></svg>"), 1);
    assert_int_equal(
        count_strokes(SVG "xmlns:o='http://example.org/other'><o:path d='M0 0h1' stroke='red'/></svg>"), 0);
}

static void fills_are_taken_only_where_nothing_is_stroked(void **state)
{
    (void)state;
    assert_int_equal(count_strokes(SVG "><path d='M0 0h1v1z'/><path d='M0 0h1' stroke='red'/></svg>"), 1);
    duct_stroke_style style =
        style_of(SVG "><path d='M0 0h1v1z' fill='#0f0'/><path d='M0 0h1' fill='none'/></svg>");
    assert_near((double)style.green, 1, 0);
    assert_near(style.width, 0, 0);
    assert_int_equal(count_strokes(SVG "/>"), 0);
}

static void ids_and_groups_tell_places(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(SVG "xmlns:inkscape='http://www.inkscape.org/namespaces/inkscape' id='root' stroke='red'>"
                      "<g id='layer1' inkscape:label='Ink/1'><g><rect width='1' height='1'/><path id='p' "
                      "d='M0 0h1M2 2h1z'/>"
                      "<path d='M0 0h1'/></g><path d='M0 0h1'/></g><path d='M0 0h1M0 1h1'/></svg>");
    static const char *const expected[][2] = {
        {"layer1/g[1]/rect[1]", "Ink_1"}, {"p", "Ink_1"},  {"p/2", "Ink_1"}, {"layer1/g[1]/path[2]", "Ink_1"},
        {"layer1/path[1]", "Ink_1"},      {"path[1]", ""}, {"path[1]/2", ""}};
    assert_int_equal(duct_drawing_stroke_count(drawing), 7);
    for (size_t i = 0; i < 7; i++) {
        assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, i)), expected[i][0]);
        assert_string_equal(duct_stroke_group(duct_drawing_stroke(drawing, i)), expected[i][1]);
    }
    assert_false(duct_stroke_closed(duct_drawing_stroke(drawing, 1)));
    assert_true(duct_stroke_closed(duct_drawing_stroke(drawing, 2)));
    duct_drawing_free(drawing);
}

static void flattening_keeps_the_tolerance_that_was_asked_for(void **state)
{
    (void)state;
    const char *svg = SVG "><circle " STROKED "r='1000'/></svg>";
    double tolerances[] = {0.001, 0.05, 1};
    size_t before = SIZE_MAX;
    for (size_t i = 0; i < 3; i++) {
        duct_format_options options = duct_format_options_default();
        options.flatten_tolerance = tolerances[i];
        duct_drawing *drawing;
        duct_error error;
        assert_ok(
            duct_drawing_read_memory(NULL, svg, strlen(svg), "c.svg", NULL, &options, &drawing, &error));
        size_t size = duct_stroke_size(duct_drawing_stroke(drawing, 0));
        assert_true(size < before);
        before = size;
        for (size_t k = 0; k < size; k++) {
            size_t next = (k + 1) % size;
            double x = (value_of(drawing, 0, DUCT_X, k) + value_of(drawing, 0, DUCT_X, next)) / 2;
            double y = (value_of(drawing, 0, DUCT_Y, k) + value_of(drawing, 0, DUCT_Y, next)) / 2;
            assert_true(1000 - hypot(x, y) <= tolerances[i] * 1.01);
        }
        duct_drawing_free(drawing);
    }
}

static void texts_come_in_many_encodings(void **state)
{
    (void)state;
    assert_int_equal(
        count_strokes("\xef\xbb\xbf<?xml version='1.0'?><!-- <g> --><!DOCTYPE svg [<!ENTITY st \"stroke:red"
                      "\">]>\n<svg:svg xmlns:svg='http://www.w3.org/2000/svg'><svg:path d='M0 0h1' "
                      "style='&st;;fill:none'/></svg:svg>"),
        1);
    duct_drawing *drawing =
        read_text("<?xml version='1.0' encoding='ISO-8859-1'?><svg xmlns='http://www.w3.org/2000/"
                  "svg'><path id='\xe4' d='M0 0h1' stroke='red'/></svg>");
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 0)), "\xc3\xa4");
    duct_drawing_free(drawing);
    const char *narrow = "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0h1' stroke='red'/></svg>";
    char wide[400] = "\xff\xfe";
    for (size_t i = 0; i < strlen(narrow); i++) {
        wide[2 + 2 * i] = narrow[i];
    }
    drawing = read_text_as(wide, 2 + 2 * strlen(narrow), NULL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_drawing_free(drawing);
}

static void titles_become_annotations(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(SVG "><title>A cat</title><desc>asleep</desc></svg>");
    assert_string_equal(duct_drawing_annotation(drawing, "title"), "A cat");
    assert_string_equal(duct_drawing_annotation(drawing, "description"), "asleep");
    duct_drawing_free(drawing);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(path_data_has_all_straight_commands),
        cmocka_unit_test(path_data_goes_on_from_a_closed_subpath),
        cmocka_unit_test(path_data_has_all_curves),
        cmocka_unit_test(arc_flags_may_be_glued),
        cmocka_unit_test(errors_in_path_data_keep_what_came_before),
        cmocka_unit_test(basic_shapes_are_strokes),
        cmocka_unit_test(transforms_multiply_from_the_left),
        cmocka_unit_test(pages_come_in_all_units),
        cmocka_unit_test(inner_viewports_have_their_own_coordinates),
        cmocka_unit_test(colours_come_in_all_spellings),
        cmocka_unit_test(gradients_give_their_first_stop),
        cmocka_unit_test(styles_cascade_as_css_says),
        cmocka_unit_test(widths_follow_units_and_transforms),
        cmocka_unit_test(opacities_multiply),
        cmocka_unit_test(what_is_not_drawn_is_not_read),
        cmocka_unit_test(fills_are_taken_only_where_nothing_is_stroked),
        cmocka_unit_test(ids_and_groups_tell_places),
        cmocka_unit_test(flattening_keeps_the_tolerance_that_was_asked_for),
        cmocka_unit_test(texts_come_in_many_encodings),
        cmocka_unit_test(titles_become_annotations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
