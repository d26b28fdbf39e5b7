/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawings.h"

#define INK "<ink xmlns=\"http://www.w3.org/2003/InkML\">"

static void traces_without_a_format_are_x_and_y(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(INK "<trace>1 2, 3 4,5 6 </trace><trace id='t'>7 8 9</trace></ink>");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 3);
    assert_near(value_of(drawing, 0, DUCT_Y, 1), 4, 0);
    assert_false(duct_drawing_has(drawing, DUCT_T));
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 0)), "0");
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(drawing, 1)), "t");
    duct_drawing_free(drawing);
}

/* The example of section 3.2.1 of the Recommendation. */
static void differences_are_summed_as_in_the_standards_example(void **state)
{
    (void)state;
    static const double x[] = {1125, 1148, 1178, 1211, 1251, 1286, 1319},
                        y[] = {18432, 18475, 18510, 18540, 18573, 18608, 18651};
    duct_drawing *drawing = read_text(INK "<trace>1125 18432,'23'43,\"7\"-8,3-5,7 3,-5 2,-2 8</trace></ink>");
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 7);
    for (size_t i = 0; i < 7; i++) {
        assert_near(value_of(drawing, 0, DUCT_X, i), x[i], 0);
        assert_near(value_of(drawing, 0, DUCT_Y, i), y[i], 0);
    }
    duct_drawing_free(drawing);
}

static void wildcards_booleans_hexadecimal_and_plain_prefix(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(INK "<definitions><context xml:id='c'><traceFormat><channel name='X'/><channel name='Y'/>"
                      "<channel name='F' max='255'/><intermittentChannels>"
                      "<channel name='B1' type='boolean' default='F'/></intermittentChannels>"
                      "</traceFormat></context></definitions>"
                      "<trace contextRef='#c'>10 #1F 51 T,'2 * ?,* !5 #fF:F,!- 1 -#10 *</trace></ink>");
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 4);
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 31, 0);
    assert_near(value_of(drawing, 0, DUCT_X, 1), 12, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 1), 31, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 1), 0.2, 1e-15);
    assert_near(value_of(drawing, 0, DUCT_X, 2), 14, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 2), 5, 0);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 2), 1, 0);
    assert_near(value_of(drawing, 0, DUCT_X, 3), -1, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 3), -16, 0);
    duct_drawing_free(drawing);
}

static void units_resolutions_and_ranges(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(
        INK "<definitions><inkSource xml:id='s'><traceFormat>"
            "<channel name='X' units='mm'/><channel name='Y' units='dev'/><channel name='T' units='ms'/>"
            "<channel name='F' min='-100' max='100'/><channel name='OTx' units='deg'/><channel name='OTy' "
            "units='rad'/>"
            "<channel name='OR' units='deg'/></traceFormat><channelProperties>"
            "<channelProperty channel='Y' name='resolution' value='1000' "
            "units='1/in'/></channelProperties></inkSource>"
            "<context xml:id='c' inkSourceRef='#s'/></definitions>"
            "<context contextRef='#c'/><trace>25.4 500 1500 0 30 -0.5 -90</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_X, 0), 96, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 48, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_T, 0), 1.5, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 0.5, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 0.5235987755982988, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), -0.5, 0);
    assert_near(value_of(drawing, 0, DUCT_TWIST, 0), 1.5707963267948966, 1e-12); /* OR is counter-clockwise */
    duct_drawing_free(drawing);
}

static void azimuth_and_elevation_become_tilt(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(INK "<traceFormat><channel name='X'/><channel name='Y'/><channel name='OA' units='deg'/>"
                      "<channel name='OE' units='deg'/></traceFormat><trace>0 0 90 60</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_TILT_X, 0), 0, 1e-12);
    assert_near(value_of(drawing, 0, DUCT_TILT_Y, 0), 0.5235987755982988, 1e-12);
    duct_drawing_free(drawing);
}

static void axes_that_point_the_other_way_are_flipped_into_the_page(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(INK "<traceFormat><channel name='X'/><channel name='Y' orientation='-ve'/>"
                      "</traceFormat><trace>0 10,0 30</trace><trace>0 5</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 20, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 1), 0, 0);
    assert_near(value_of(drawing, 1, DUCT_Y, 0), 25, 0);
    duct_drawing_free(drawing);
    drawing = read_text(INK "<traceFormat><channel name='X'/><channel name='Y' orientation='-ve' max='100'/>"
                            "</traceFormat><trace>0 10</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 90, 0);
    duct_drawing_free(drawing);
}

static void canvas_transforms_map_points(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(INK "<context><canvasTransform><mapping type='affine'><affine>2 0 1, 0 3 -1</affine>"
                      "</mapping></canvasTransform></context><trace>10 20</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_X, 0), 21, 0);
    assert_near(value_of(drawing, 0, DUCT_Y, 0), 59, 0);
    duct_drawing_free(drawing);
    assert_refused(INK "<context><canvasTransform><mapping type='mathml'/></canvasTransform></context>"
                       "<trace>1 2</trace></ink>",
                   NULL, DUCT_UNSUPPORTED, "mathml");
    assert_refused(INK "<context><canvasTransform><mapping type='affine'><affine>2 0 1 0 3 -1</affine>"
                       "</mapping></canvasTransform></context><trace>1 2</trace></ink>",
                   NULL, DUCT_BAD_FORMAT, "two rows");
}

static void groups_brushes_and_inheritance(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(
        INK "<definitions><brush xml:id='red'><brushProperty name='color' value='#FF0000'/>"
            "<brushProperty name='transparency' value='51'/><brushProperty name='width' value='2.54' "
            "units='cm'/></brush>"
            "<brush xml:id='blue'><brushProperty name='color' value='#0000ff'/></brush></definitions>"
            "<traceGroup brushRef='#red'><annotation type='label'>Sky</annotation><trace>1 2</trace>"
            "<traceGroup xml:id='g'><trace brushRef='#blue'>3 4</trace></traceGroup></traceGroup>"
            "<traceGroup><trace>5 6</trace></traceGroup><traceView traceDataRef='#g'/></ink>");
    assert_int_equal(duct_drawing_stroke_count(drawing), 3);
    duct_stroke_style style = duct_stroke_get_style(duct_drawing_stroke(drawing, 0));
    assert_true(style.red == 1 && style.blue == 0);
    assert_near((double)style.opacity, 0.8, 1e-7);
    assert_near(style.width, 96, 1e-12);
    assert_string_equal(duct_stroke_group(duct_drawing_stroke(drawing, 0)), "Sky");
    assert_string_equal(duct_stroke_group(duct_drawing_stroke(drawing, 1)), "Sky/g");
    assert_string_equal(duct_stroke_group(duct_drawing_stroke(drawing, 2)), "group 1");
    style = duct_stroke_get_style(duct_drawing_stroke(drawing, 1));
    assert_true(style.red == 0 && style.blue == 1 && style.opacity == 1);
    duct_drawing_free(drawing);
}

static void continuations_are_joined_and_pen_up_is_skipped(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(
        INK
        "<trace xml:id='a' continuation='begin'>1 1</trace><trace xml:id='b'>9 9</trace>"
        "<trace type='penUp'>0 0</trace><trace xml:id='c' continuation='middle' priorRef='#a'>'1 1</trace>"
        "<trace continuation='end' priorRef='#c'>3 3,4 4</trace></ink>");
    assert_int_equal(duct_drawing_stroke_count(drawing), 2);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 4);
    assert_near(value_of(drawing, 0, DUCT_X, 1), 2, 0);
    assert_near(value_of(drawing, 0, DUCT_X, 3), 4, 0);
    duct_drawing_free(drawing);
}

static void time_from_channels_timestamps_and_rates(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text(
        INK "<definitions><timestamp xml:id='t0' time='1000000'/><timestamp xml:id='t1' timestampRef='#t0' "
            "timeOffset='5000'/>"
            "<context xml:id='a'><traceFormat><channel name='X'/><channel name='Y'/><channel name='T' "
            "respectTo='#t0' units='ms'/>"
            "</traceFormat></context><context xml:id='b'><traceFormat><channel name='X'/><channel name='Y'/>"
            "<channel name='T' respectTo='#t1' units='ms'/></traceFormat></context>"
            "<context xml:id='c'><inkSource><sampleRate value='100'/><traceFormat><channel "
            "name='X'/><channel name='Y'/>"
            "</traceFormat></inkSource></context></definitions>"
            "<trace contextRef='#a'>0 0 500</trace><trace contextRef='#b'>0 0 500</trace>"
            "<trace contextRef='#c' timeOffset='2000'>0 0,1 1,2 2</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_T, 0), 0.5, 1e-9);
    assert_near(value_of(drawing, 1, DUCT_T, 0), 5.5, 1e-9);
    assert_near(value_of(drawing, 2, DUCT_T, 2), 2.02, 1e-9);
    duct_drawing_free(drawing);
}

static void pressure_without_a_range_is_scaled_by_the_strongest(void **state)
{
    (void)state;
    duct_drawing *drawing =
        read_text(INK "<traceFormat><channel name='X'/><channel name='Y'/><channel name='F'/></traceFormat>"
                      "<trace>0 0 512</trace><trace>0 0 1024</trace></ink>");
    assert_near(value_of(drawing, 0, DUCT_PRESSURE, 0), 0.5, 0);
    assert_near(value_of(drawing, 1, DUCT_PRESSURE, 0), 1, 0);
    duct_drawing_free(drawing);
}

static void annotations_become_the_drawings(void **state)
{
    (void)state;
    duct_drawing *drawing = read_text("<inkml:ink xmlns:inkml='http://www.w3.org/2003/InkML'>"
                                      "<inkml:annotation type='artist'>Ann &amp; Bob</inkml:annotation>"
                                      "<inkml:annotationXML type='device'><d>pen</d></inkml:annotationXML>"
                                      "<inkml:trace>1 2</inkml:trace></inkml:ink>");
    assert_string_equal(duct_drawing_annotation(drawing, "artist"), "Ann & Bob");
    assert_string_equal(duct_drawing_annotation(drawing, "device"), "pen");
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_drawing_free(drawing);
}

static void refuses_malformed_traces_by_line(void **state)
{
    (void)state;
    assert_refused(INK "\n<trace>1 2,\n3 x</trace></ink>", NULL, DUCT_BAD_FORMAT, "line 3: point 2");
    assert_refused(INK "<trace>1 2,3</trace></ink>", NULL, DUCT_BAD_FORMAT, "fewer values");
    assert_refused(INK "<trace>1 2,,3 4</trace></ink>", NULL, DUCT_BAD_FORMAT, "empty");
    assert_refused(INK "<trace>'1 2</trace></ink>", NULL, DUCT_BAD_FORMAT, "no value before");
    assert_refused(INK "<trace>* 2</trace></ink>", NULL, DUCT_BAD_FORMAT, "no value before");
    assert_refused(INK "<trace>nan 2</trace></ink>", NULL, DUCT_BAD_FORMAT, "number is expected");
    assert_refused(INK "<trace>inf 2</trace></ink>", NULL, DUCT_BAD_FORMAT, "number is expected");
    assert_refused(INK "<trace>1e999 2</trace></ink>", NULL, DUCT_BAD_FORMAT, "number is expected");
    assert_refused(INK "<trace>1e308 2,'1e308 0</trace></ink>", NULL, DUCT_BAD_FORMAT, "out of range");
    assert_refused(INK "<trace contextRef='#nowhere'>1 2</trace></ink>", NULL, DUCT_BAD_FORMAT,
                   "names no context");
    assert_refused(INK "<traceFormat><channel name='X'/></traceFormat><trace>1</trace></ink>", NULL,
                   DUCT_BAD_FORMAT, "no channels X and Y");
    assert_refused(
        INK "<traceFormat><channel name='X'/><channel name='Y'/></traceFormat><trace>1 2 3</trace></ink>",
        NULL, DUCT_BAD_FORMAT, "more values");
    assert_refused("<svg/>", "inkml", DUCT_BAD_FORMAT, "not <ink>");
}

static void circles_of_references_are_refused(void **state)
{
    (void)state;
    assert_refused(INK "<definitions><context xml:id='a' contextRef='#b'/><context xml:id='b' "
                       "contextRef='#a'/></definitions>"
                       "<trace contextRef='#a'>1 2</trace></ink>",
                   NULL, DUCT_BAD_FORMAT, "circle");
    assert_refused(INK "<trace xml:id='a' continuation='end' priorRef='#b'>1 2</trace>"
                       "<trace xml:id='b' continuation='end' priorRef='#a'>1 2</trace></ink>",
                   NULL, DUCT_BAD_FORMAT, "names no earlier trace");
    duct_drawing *drawing =
        read_text(INK "<definitions><brush xml:id='a' brushRef='#b'/><brush xml:id='b' brushRef='#a'/>"
                      "<timestamp xml:id='s' timestampRef='#t'/><timestamp xml:id='t' timestampRef='#s'/>"
                      "</definitions><context timestampRef='#s'/><trace brushRef='#a'>1 2</trace></ink>");
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    duct_drawing_free(drawing);
}

static void too_many_channels_are_refused(void **state)
{
    (void)state;
    char text[8192] = INK "<traceFormat>";
    for (int i = 0; i < 65; i++) {
        strcat(text, "<channel name='Z'/>");
    }
    strcat(text, "</traceFormat><trace>1 2</trace></ink>");
    assert_refused(text, NULL, DUCT_BAD_FORMAT, "64 channels");
}

static void deep_groups_and_endless_names_are_refused(void **state)
{
    (void)state;
    enum { DEPTH = 3000, NAME = 40000 };
    char *text = malloc(64 + DEPTH * 12 + 4 * NAME);
    assert_non_null(text);
    size_t size = (size_t)sprintf(text, INK);
    for (int i = 0; i < DEPTH; i++) {
        size += (size_t)sprintf(text + size, "<traceGroup>");
    }
    assert_refused(text, NULL, DUCT_LIMIT, "nested more than 256 deep");
    size = (size_t)sprintf(text, INK);
    for (int i = 0; i < 2; i++) {
        size += (size_t)sprintf(text + size, "<traceGroup xml:id='");
        memset(text + size, i == 0 ? 'a' : 'b', NAME);
        size += NAME;
        size += (size_t)sprintf(text + size, "'>");
    }
    sprintf(text + size, "</traceGroup></traceGroup></ink>");
    assert_refused(text, NULL, DUCT_BAD_FORMAT, "longer than 65536 bytes");
    free(text);
}

static void entity_bombs_are_refused_and_small_entities_read(void **state)
{
    (void)state;
    char text[4096] = "<!DOCTYPE ink [<!ENTITY e0 '1 2,'>";
    for (int i = 1; i < 12; i++) {
        char one[200];
        snprintf(one, sizeof one, "<!ENTITY e%d '&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;'>", i,
                 i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1);
        strcat(text, one);
    }
    size_t size = strlen(text);
    strcat(text, "]>" INK "<trace>&e11;</trace></ink>");
    assert_refused(text, NULL, DUCT_LIMIT, "entities");
    strcpy(text + size, "]>" INK "<trace>&e1;3 4</trace></ink>");
    duct_drawing *drawing = read_text(text);
    assert_int_equal(duct_stroke_size(duct_drawing_stroke(drawing, 0)), 11);
    duct_drawing_free(drawing);
}

static void assert_same_drawing(const duct_drawing *a, const duct_drawing *b)
{
    assert_near(duct_drawing_width(a), duct_drawing_width(b), 0);
    assert_near(duct_drawing_height(a), duct_drawing_height(b), 0);
    assert_near(duct_drawing_resolution(a), duct_drawing_resolution(b), 0);
    assert_int_equal(duct_drawing_stroke_count(a), duct_drawing_stroke_count(b));
    for (size_t i = 0; i < duct_drawing_stroke_count(a); i++) {
        const duct_stroke *left = duct_drawing_stroke(a, i), *right = duct_drawing_stroke(b, i);
        assert_same_values(left, right, 0);
        assert_string_equal(duct_stroke_id(left), duct_stroke_id(right));
        assert_string_equal(duct_stroke_group(left), duct_stroke_group(right));
        assert_int_equal(duct_stroke_closed(left), duct_stroke_closed(right));
        duct_stroke_style l = duct_stroke_get_style(left), r = duct_stroke_get_style(right);
        assert_true(l.red == r.red && l.green == r.green && l.blue == r.blue);
        assert_true(l.opacity == r.opacity && l.width == r.width);
    }
}

static void round_trip_is_exact_to_the_last_bit(void **state)
{
    (void)state;
    static const char *const groups[] = {"", "a", "a/b", "a/b/c", "a//c", "/", "x<y>&\"'\n\t z", "a/b"};
    for (uint64_t seed = 1; seed <= 60; seed++) {
        duct_error error;
        duct_drawing *drawing = random_drawing(seed, 25, false);
        duct_drawing_set_page(drawing, 1000 * duct_random_uniform(seed, 0, 0, 50), 123.456);
        duct_drawing_set_resolution(drawing, seed % 2 ? 96 : 50 + 500 * duct_random_uniform(seed, 0, 0, 51));
        for (size_t i = 0; i < 25; i++) {
            duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
            uint64_t bits = duct_random_bits(seed, i, 0, 52);
            float u = (float)duct_random_uniform(seed, i, 0, 53);
            duct_stroke_style style = {u, (float)(bits % 256) / 255, 0.5f, bits % 3 ? 1 : u,
                                       bits % 5 ? 10 * (double)u : 0};
            duct_stroke_set_style(stroke, style);
            duct_stroke_set_closed(stroke, bits % 7 == 0);
            assert_ok(duct_stroke_set_group(stroke, groups[(bits >> 8) % 8], &error));
            if (bits % 11 == 0) {
                assert_ok(duct_stroke_set_id(stroke, "  <id>\r\n&\"\xc3\xa4\" ", &error));
            }
        }
        assert_ok(duct_drawing_annotate(drawing, "artist", "A <B> & \"C\"\r\n ", &error));
        assert_ok(duct_drawing_annotate(drawing, "", "", &error));
        duct_drawing *back = write_and_read(drawing, "inkml");
        assert_same_drawing(drawing, back);
        assert_string_equal(duct_drawing_annotation(back, "artist"), "A <B> & \"C\"\r\n ");
        assert_string_equal(duct_drawing_annotation(back, ""), "");
        duct_drawing_free(back);
        duct_drawing_free(drawing);
    }
}

static void deeper_groups_than_xml_may_nest_survive(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = random_drawing(4, 3, true);
    char path[1200] = "g";
    for (int i = 0; i < 500; i++) {
        strcat(path, "/g");
    }
    assert_ok(duct_stroke_set_group(duct_drawing_edit_stroke(drawing, 0), path, &error));
    assert_ok(duct_stroke_set_group(duct_drawing_edit_stroke(drawing, 1), strcat(path, "/h"), &error));
    duct_drawing *back = write_and_read(drawing, "inkml");
    assert_same_drawing(drawing, back);
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

static void texts_that_are_no_utf8_still_give_well_formed_xml(void **state)
{
    (void)state;
    duct_error error;
    duct_drawing *drawing = random_drawing(4, 1, true);
    assert_ok(duct_stroke_set_id(duct_drawing_edit_stroke(drawing, 0), "a\xff\x01\xc3\xed\xa0\x80z", &error));
    duct_drawing *back = write_and_read(drawing, "inkml");
    assert_string_equal(duct_stroke_id(duct_drawing_stroke(back, 0)), "az");
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

static const char small[] =
    INK "<annotation type='artist'>A</annotation><definitions><context xml:id='c'><inkSource><traceFormat>"
        "<channel name='X' units='mm'/><channel name='Y' orientation='-ve'/><channel name='F' "
        "max='9'/></traceFormat>"
        "</inkSource></context><brush xml:id='b'><brushProperty name='color' "
        "value='#123456'/></brush></definitions>"
        "<traceGroup contextRef='#c'><trace xml:id='t' brushRef='#b'>1 2 3,'4\"5 6,* ? "
        "*</trace></traceGroup></ink>";

static void truncated_and_mutated_documents_do_no_harm(void **state)
{
    (void)state;
    assert_int_equal(read_truncated(small, "inkml"), strlen(small));
    read_mutated(small, "inkml", 20000);
}

static void failing_allocations_leave_nothing(void **state)
{
    (void)state;
    fail_allocations(small, "inkml");
}

static void a_million_samples_in_a_trace(void **state)
{
    (void)state;
    duct_error error;
    enum { COUNT = 1000000 };
    duct_drawing *drawing = random_drawing(5, 0, true);
    duct_stroke *stroke;
    assert_ok(duct_drawing_add_stroke(drawing, "long", COUNT, &stroke, &error));
    double *x = duct_stroke_edit(stroke, DUCT_X), *t = duct_stroke_edit(stroke, DUCT_T);
    for (size_t i = 0; i < COUNT; i++) {
        x[i] = (double)i / 128;
        t[i] = (double)i / 200;
    }
    duct_drawing *back = write_and_read(drawing, "inkml");
    assert_same_drawing(drawing, back);
    duct_drawing_free(back);
    duct_drawing_free(drawing);
}

static void many_continuations_take_linear_time(void **state)
{
    (void)state;
    enum { COUNT = 100000 };
    char *text = malloc(200 + COUNT * 80);
    assert_non_null(text);
    size_t size = (size_t)sprintf(text, INK "<trace xml:id='t0'>0 0</trace>");
    for (int i = 1; i <= COUNT; i++) {
        size += (size_t)sprintf(
            text + size, "<trace xml:id='t%d' continuation='middle' priorRef='#t%d'>'1 1</trace>", i, i - 1);
    }
    size += (size_t)sprintf(text + size, "</ink>");
    duct_drawing *drawing = read_text_as(text, size, NULL);
    assert_int_equal(duct_drawing_stroke_count(drawing), 1);
    assert_near(value_of(drawing, 0, DUCT_X, COUNT), COUNT, 0);
    duct_drawing_free(drawing);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(traces_without_a_format_are_x_and_y),
        cmocka_unit_test(differences_are_summed_as_in_the_standards_example),
        cmocka_unit_test(wildcards_booleans_hexadecimal_and_plain_prefix),
        cmocka_unit_test(units_resolutions_and_ranges),
        cmocka_unit_test(azimuth_and_elevation_become_tilt),
        cmocka_unit_test(axes_that_point_the_other_way_are_flipped_into_the_page),
        cmocka_unit_test(canvas_transforms_map_points),
        cmocka_unit_test(groups_brushes_and_inheritance),
        cmocka_unit_test(continuations_are_joined_and_pen_up_is_skipped),
        cmocka_unit_test(time_from_channels_timestamps_and_rates),
        cmocka_unit_test(pressure_without_a_range_is_scaled_by_the_strongest),
        cmocka_unit_test(annotations_become_the_drawings),
        cmocka_unit_test(refuses_malformed_traces_by_line),
        cmocka_unit_test(circles_of_references_are_refused),
        cmocka_unit_test(too_many_channels_are_refused),
        cmocka_unit_test(deep_groups_and_endless_names_are_refused),
        cmocka_unit_test(entity_bombs_are_refused_and_small_entities_read),
        cmocka_unit_test(round_trip_is_exact_to_the_last_bit),
        cmocka_unit_test(deeper_groups_than_xml_may_nest_survive),
        cmocka_unit_test(texts_that_are_no_utf8_still_give_well_formed_xml),
        cmocka_unit_test(truncated_and_mutated_documents_do_no_harm),
        cmocka_unit_test(failing_allocations_leave_nothing),
        cmocka_unit_test(a_million_samples_in_a_trace),
        cmocka_unit_test(many_continuations_take_linear_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
