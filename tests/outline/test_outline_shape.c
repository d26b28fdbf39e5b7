/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "shapes.h"

#include <ductus/format.h>

/* Outlines compared with the plain way: each two neighbouring nibs' hull a polygon of its own, all united. */

typedef struct {
    double area, difference; /* square pixels */
    bool thick;              /* the two differ somewhere by more than the tolerance */
    size_t crossing;
} comparison;

static comparison compare(const duct_stroke *stroke, const duct_nib_options *options, const duct_path *path)
{
    const duct_allocator *allocator = duct_allocator_of(NULL);
    duct_error error;
    duct_nib_list nibs = {0};
    duct_polygons hulls = {0}, rings = {0};
    double tolerance = options->fit_tolerance;
    /* The reference is ten times as exact. */
    duct_nib_options fine = *options;
    fine.fit_tolerance = 0.1 * tolerance;
    assert_true(duct_sweep_nibs(allocator, stroke, &fine, &nibs));
    assert_true(duct_envelope(allocator, &nibs, DUCT_SHARE_ARC * fine.fit_tolerance, true, &hulls));
    assert_ok(duct_polygons_union(allocator, &hulls, 0, &rings, &error));
    GEOSContextHandle_t geos = GEOS_init_r();
    comparison result = {0};
    GEOSGeometry *plain = shape_of_rings(geos, &rings), *fitted = shape_of_path(geos, path, &result.crossing);
    GEOSGeometry *difference = GEOSSymDifference_r(geos, plain, fitted);
    assert_non_null(difference);
    /* What is left when its border of half a tolerance is gone was thicker than the tolerance (a tenth is
     * left for GEOS, whose buffers are polygons). */
    GEOSGeometry *core = GEOSBuffer_r(geos, difference, -0.55 * tolerance, 8);
    assert_non_null(core);
    result.area = area_of(geos, plain);
    result.difference = area_of(geos, difference);
    result.thick = area_of(geos, core) > 0.01 * tolerance * tolerance;
    GEOSGeom_destroy_r(geos, core);
    GEOSGeom_destroy_r(geos, difference);
    GEOSGeom_destroy_r(geos, plain);
    GEOSGeom_destroy_r(geos, fitted);
    GEOS_finish_r(geos);
    duct_release(allocator, nibs.items);
    duct_polygons_free(allocator, &hulls);
    duct_polygons_free(allocator, &rings);
    return result;
}

/* Where edges come closer to each other than the tolerance, a fitted ring may cross itself by as much. */
static void check(const char *what, const duct_stroke *stroke, const duct_nib_options *options, bool touching)
{
    duct_path path = outline_of(stroke, options);
    comparison result = compare(stroke, options, &path);
    if (result.thick || (!touching && result.crossing > 0)) {
        print_error("%s: differs by %g of %g square pixels%s, %zu rings cross themselves\n", what,
                    result.difference, result.area,
                    result.thick ? ", somewhere by more than the tolerance" : "", result.crossing);
    }
    assert_false(result.thick);
    assert_true(touching || result.crossing == 0);
    duct_path_done(&path);
}

/* Curves with a name, over t = 0..1. */
typedef void (*curve)(double t, double xy[2]);

static void wave(double t, double xy[2])
{
    xy[0] = 160 * t;
    xy[1] = 30 * sin(6 * t);
}

static void loops(double t, double xy[2])
{
    xy[0] = 30 * cos(12 * t) + 80 * t;
    xy[1] = 30 * sin(12 * t);
}

static void eight(double t, double xy[2])
{
    xy[0] = 35 * sin(2 * pi * t);
    xy[1] = 25 * sin(4 * pi * t);
}

static void spiral(double t, double xy[2])
{
    xy[0] = (3 + 35 * t) * cos(25 * t);
    xy[1] = (3 + 35 * t) * sin(25 * t);
}

static void hairpin(double t, double xy[2])
{
    xy[0] = 2 * fabs(2 * t - 1);
    xy[1] = 60 * (1 - fabs(2 * t - 1));
}

static void back_and_forth(double t, double xy[2])
{
    xy[0] = 40 * (1 - fabs(2 * t - 1));
    xy[1] = 0;
}

static void right_angle(double t, double xy[2])
{
    xy[0] = 60 * fmin(1, 2 * t);
    xy[1] = 60 * fmax(0, 2 * t - 1);
}

static void cusp(double t, double xy[2])
{
    double u = 2 * t - 1;
    xy[0] = 60 * u * u * u;
    xy[1] = 60 * u * u;
}

static void curls(double t, double xy[2])
{
    xy[0] = 60 * t + 5 * cos(19 * t);
    xy[1] = 40 * t + 5 * sin(19 * t);
}

static void tremor(double t, double xy[2])
{
    xy[0] = 60 * t;
    xy[1] = 3 * sin(40 * t);
}

static void dwell(double t, double xy[2])
{
    double moved = fmax(0, t - 0.5);
    xy[0] = 100 * moved + 0.02 * sin(1000 * t);
    xy[1] = 20 * moved + 0.02 * cos(777 * t);
}

static const struct {
    const char *name;
    curve at;
} curves[] = {{"wave", wave},
              {"loops", loops},
              {"eight", eight},
              {"spiral", spiral},
              {"hairpin", hairpin},
              {"back and forth", back_and_forth},
              {"right angle", right_angle},
              {"cusp", cusp},
              {"curls", curls},
              {"tremor", tremor},
              {"dwell", dwell}};

static sheet draw(curve at, size_t count)
{
    sheet s = sheet_new(count);
    /* With times these are pen strokes, whose smooth way between samples does not depend on the tolerance. */
    sheet_channel(&s, DUCT_T, 0);
    for (size_t i = 0; i < count; i++) {
        double xy[2];
        at((double)i / (double)(count - 1), xy);
        s.x[i] = xy[0];
        s.y[i] = xy[1];
    }
    return s;
}

static void check_curves(size_t samples, double width, double aspect, double twist, double pressure_waves)
{
    for (size_t k = 0; k < sizeof curves / sizeof *curves; k++) {
        sheet s = draw(curves[k].at, samples);
        double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.5);
        double *angle = twist != 0 ? sheet_channel(&s, DUCT_TWIST, 0) : NULL;
        for (size_t i = 0; i < samples; i++) {
            double t = (double)i / (double)(samples - 1);
            pressure[i] = 0.5 + 0.4 * sin(pressure_waves * t);
            if (angle != NULL) {
                angle[i] = twist * t;
            }
        }
        duct_nib_options options = round_nib(width);
        options.aspect = aspect;
        check(curves[k].name, s.stroke, &options, aspect > 1);
        duct_drawing_free(s.drawing);
    }
}

static void thin_lines_match_the_union_of_hulls(void **state)
{
    (void)state;
    check_curves(200, 1, 1, 0, 9);
}

static void broad_lines_match_the_union_of_hulls(void **state)
{
    (void)state;
    check_curves(200, 8, 1, 0, 9);
}

static void lines_broader_than_their_bends_match_the_union_of_hulls(void **state)
{
    (void)state;
    check_curves(120, 40, 1, 0, 5);
}

static void flat_nibs_that_turn_match_the_union_of_hulls(void **state)
{
    (void)state;
    check_curves(150, 8, 6, 5, 9);
}

static void sudden_pressure_matches_the_union_of_hulls(void **state)
{
    (void)state;
    check_curves(150, 12, 2, 3, 90);
}

static void closed_strokes_match_the_union_of_hulls(void **state)
{
    (void)state;
    for (size_t width = 2; width <= 32; width *= 4) {
        sheet s = sheet_new(90);
        sheet_channel(&s, DUCT_T, 0);
        double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.5);
        for (size_t i = 0; i < s.count; i++) {
            double a = 2 * pi * (double)i / (double)s.count;
            s.x[i] = 30 * cos(a) + 4 * cos(5 * a);
            s.y[i] = 25 * sin(a);
            pressure[i] = 0.5 + 0.4 * sin(3 * a);
        }
        duct_stroke_set_closed(s.stroke, true);
        duct_nib_options options = round_nib((double)width);
        check("closed", s.stroke, &options, false);
        duct_drawing_free(s.drawing);
    }
}

/* Random walks: everything that can cross crosses. */
static void scribbles_match_the_union_of_hulls(void **state)
{
    (void)state;
    for (uint64_t seed = 1; seed <= 25; seed++) {
        sheet s = sheet_new(60);
        sheet_channel(&s, DUCT_T, 0);
        double *pressure = sheet_channel(&s, DUCT_PRESSURE, 0.5), *twist = sheet_channel(&s, DUCT_TWIST, 0);
        uint64_t number = seed;
        double heading = 0, x = 0, y = 0;
        for (size_t i = 0; i < s.count; i++) {
            double random[4];
            for (int k = 0; k < 4; k++) {
                number = number * 6364136223846793005u + 1442695040888963407u;
                random[k] = (double)(number >> 40) / (double)(1 << 24);
            }
            heading += 2.4 * (random[0] - 0.5);
            x += 6 * random[1] * cos(heading);
            y += 6 * random[1] * sin(heading);
            s.x[i] = x;
            s.y[i] = y;
            pressure[i] = random[2];
            twist[i] = 2 * random[3];
        }
        duct_nib_options options = round_nib(5);
        options.aspect = 1 + (double)(seed % 4);
        char name[32];
        snprintf(name, sizeof name, "scribble %d", (int)seed);
        check(name, s.stroke, &options, true);
        duct_drawing_free(s.drawing);
    }
}

static void real_strokes_match_the_union_of_hulls(void **state)
{
    (void)state;
    const char *folder = shared_data();
    if (folder == NULL) {
        skip();
    }
    static const char *const names[] = {"SteveEnglish1", "BrendaFlower", "LinjieChinese1", "PushkarSchool"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        char file[5000], what[64];
        snprintf(file, sizeof file, "%s/helpinghand/%s.cyn", folder, names[k]);
        duct_drawing *drawing;
        duct_error error;
        assert_ok(duct_drawing_read(NULL, file, NULL, &drawing, &error));
        for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i += 5) {
            duct_nib_options options = duct_nib_options_default();
            options.width = 4;
            snprintf(what, sizeof what, "%s, stroke %zu", names[k], i);
            check(what, duct_drawing_stroke(drawing, i), &options, true);
        }
        duct_drawing_free(drawing);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(thin_lines_match_the_union_of_hulls),
        cmocka_unit_test(broad_lines_match_the_union_of_hulls),
        cmocka_unit_test(lines_broader_than_their_bends_match_the_union_of_hulls),
        cmocka_unit_test(flat_nibs_that_turn_match_the_union_of_hulls),
        cmocka_unit_test(sudden_pressure_matches_the_union_of_hulls),
        cmocka_unit_test(closed_strokes_match_the_union_of_hulls),
        cmocka_unit_test(scribbles_match_the_union_of_hulls),
        cmocka_unit_test(real_strokes_match_the_union_of_hulls),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
