/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed: the searches beside FLANN's randomized kd-forest and a plain scan, and whole strokes beside
 * libmypaint painting them. All methods of a table take turns within one run; only ratios mean anything. */
#include "bench.h"

#include "features/features.h"
#include "library/feature_index.h"
#include "library/library_private.h"
#include "search/search.h"

#include <flann/flann.h>
#include <math.h>
#include <mypaint-brush.h>
#include <mypaint-fixed-tiled-surface.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { K = 20, ROUNDS = 7, STROKE = 60 };

static const char *const pages[] = {
    "helpinghand/SteveEnglish1.cyn",  "helpinghand/SteveEnglish2.cyn",  "helpinghand/SteveEnglish3.cyn",
    "helpinghand/SteveEnglish4.cyn",  "helpinghand/ChikaEnglish1.cyn",  "helpinghand/ChikaEnglish2.cyn",
    "helpinghand/ChikaEnglish3.cyn",  "helpinghand/ChikaEnglish4.cyn",  "helpinghand/NeerajEnglish1.cyn",
    "helpinghand/NeerajEnglish2.cyn", "helpinghand/NeerajEnglish3.cyn", "helpinghand/NeerajEnglish4.cyn",
    "helpinghand/LinjieEnglish1.cyn", "helpinghand/LinjieEnglish2.cyn", "helpinghand/LinjieEnglish3.cyn",
    "helpinghand/BrendaEnglish1.cyn", "helpinghand/BrendaEnglish4.cyn", "helpinghand/SteveSchool.cyn",
    "helpinghand/PushkarSchool.cyn",  "helpinghand/JimMcCannSchool.cyn"};
enum { PAGES = sizeof pages / sizeof *pages };
static const char query_page[] = "helpinghand/BrendaEnglish2.cyn";

static FILE *open_table(const char *out, const char *name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s.csv", out, name);
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        fprintf(stderr, "bench-helpinghand: cannot write %s\n", path);
        exit(1);
    }
    return file;
}

/* ---- searches ---- */

typedef struct {
    const float *rows, *queries;
    size_t count, dimensions, strokes; /* STROKE queries each, neighbouring samples */
} problem;

/* Rows of the library and, where it has fewer than are asked for, of its strokes in other sizes. */
static float *make_rows(size_t count, size_t *dimensions)
{
    duct_error error;
    static const double scales[] = {1, 0.8, 1.2, 0.65, 1.45, 0.9, 1.1, 0.72};
    duct_feature_options features = duct_feature_options_default();
    *dimensions = duct_feature_dimensions(&features);
    duct_library *library = bench_library(pages, PAGES, count);
    duct_feature_index index;
    bench_check(duct_library_features(library, &features, DUCT_SEARCH_PATCHMATCH, &index, &error), &error);
    float *rows = bench_alloc(count * *dimensions, sizeof *rows);
    size_t filled = 0;
    for (size_t scale = 0; filled < count; scale++) {
        duct_drawing *drawing;
        duct_library *scaled;
        duct_library_options options = {
            .unit = duct_library_unit(library), .scales = &scales[scale], .scale_count = 1};
        bench_check(duct_library_drawing(NULL, library, &drawing, &error), &error);
        const duct_drawing *list[] = {drawing};
        bench_check(duct_library_build(NULL, list, 1, &options, &scaled, &error), &error);
        bench_check(duct_library_features(scaled, &features, DUCT_SEARCH_PATCHMATCH, &index, &error), &error);
        size_t more = duct_library_sample_count(scaled);
        more = more < count - filled ? more : count - filled;
        memcpy(rows + filled * *dimensions, index.rows, more * *dimensions * sizeof *rows);
        filled += more;
        duct_library_free(scaled);
        duct_drawing_free(drawing);
        if (scale + 1 == sizeof scales / sizeof *scales && filled < count) {
            fprintf(stderr, "bench-helpinghand: only %zu rows instead of %zu\n", filled, count);
            exit(1);
        }
    }
    duct_library_free(library);
    return rows;
}

/* Features of a page's strokes, cut to STROKE samples. */
static float *make_queries(size_t most, size_t *strokes)
{
    duct_error error;
    duct_drawing *page = bench_recording(query_page);
    const duct_drawing *list[] = {page};
    duct_library *sampled;
    duct_feature_index index;
    duct_feature_options features = duct_feature_options_default();
    bench_check(duct_library_build(NULL, list, 1, NULL, &sampled, &error), &error);
    bench_check(duct_library_features(sampled, &features, DUCT_SEARCH_PATCHMATCH, &index, &error), &error);
    float *queries = bench_alloc(most * STROKE * index.dimensions, sizeof *queries);
    *strokes = 0;
    for (size_t s = 0; s < duct_library_stroke_count(sampled) && *strokes < most; s++) {
        if (duct_library_stroke_samples(sampled, s) >= STROKE) {
            memcpy(queries + *strokes * STROKE * index.dimensions,
                   index.rows + sampled->starts[s] * index.dimensions,
                   STROKE * index.dimensions * sizeof *queries);
            ++*strokes;
        }
    }
    duct_library_free(sampled);
    duct_drawing_free(page);
    return queries;
}

typedef struct {
    const char *name;
    duct_search *search;  /* ours, or */
    flann_index_t forest; /* FLANN's, or neither: a plain scan */
    int checks;
    size_t strokes; /* how many of the problem's it is given: the plain scan needs fewer */
} method;

static void plain_scan(const problem *self, const float *query, uint32_t *near)
{
    float squares[K];
    size_t kept = 0;
    for (size_t row = 0; row < self->count; row++) {
        float square = 0;
        for (size_t d = 0; d < self->dimensions; d++) {
            float difference = query[d] - self->rows[row * self->dimensions + d];
            square += difference * difference;
        }
        if (kept == K && square >= squares[K - 1]) {
            continue;
        }
        size_t at = kept < K ? kept++ : K - 1;
        for (; at > 0 && squares[at - 1] > square; at--) {
            squares[at] = squares[at - 1];
            near[at] = near[at - 1];
        }
        squares[at] = square;
        near[at] = (uint32_t)row;
    }
}

/* Searches all strokes; near holds K rows a query. */
static double run_method(const problem *self, const method *how, uint32_t *near)
{
    static float distances[STROKE * K];
    static int found_rows[K];
    size_t found[STROKE];
    duct_error error;
    struct FLANNParameters parameters = DEFAULT_FLANN_PARAMETERS;
    parameters.checks = how->checks;
    parameters.cores = 1;
    parameters.random_seed = 0;
    double begin = bench_cpu();
    for (size_t s = 0; s < how->strokes; s++) {
        const float *rows = self->queries + s * STROKE * self->dimensions;
        uint32_t *to = near + s * STROKE * K;
        if (how->search != NULL) {
            const duct_search_query query = {rows, STROKE, K, 0, 0, s};
            bench_check(duct_search_sequence(how->search, duct_allocator_of(NULL), &query, to, distances,
                                             found, &error),
                        &error);
            continue;
        }
        for (size_t i = 0; i < STROKE; i++) {
            float *query = (float *)(uintptr_t)rows + i * self->dimensions;
            if (how->forest == NULL) {
                plain_scan(self, query, to + i * K);
                continue;
            }
            flann_find_nearest_neighbors_index_float(how->forest, query, 1, found_rows, distances, K,
                                                     &parameters);
            for (size_t n = 0; n < K; n++) {
                to[i * K + n] = (uint32_t)found_rows[n];
            }
        }
    }
    return (bench_cpu() - begin) / (double)(how->strokes * STROKE);
}

static double recall_of(const problem *self, const method *how, const uint32_t *truth, const uint32_t *near)
{
    size_t met = 0, asked = how->strokes * STROKE;
    (void)self;
    for (size_t q = 0; q < asked; q++) {
        for (size_t n = 0; n < K; n++) {
            for (size_t t = 0; t < K; t++) {
                met += near[q * K + n] == truth[q * K + t];
            }
        }
    }
    return (double)met / (double)(asked * K);
}

static flann_index_t plant(const problem *self)
{
    struct FLANNParameters parameters = DEFAULT_FLANN_PARAMETERS;
    float speedup;
    parameters.algorithm = FLANN_INDEX_KDTREE;
    parameters.trees = 4;
    parameters.cores = 1;
    parameters.log_level = FLANN_LOG_NONE;
    return flann_build_index_float((float *)(uintptr_t)self->rows, (int)self->count, (int)self->dimensions,
                                   &speedup, &parameters);
}

static void search_at(size_t rows, FILE *table)
{
    enum { METHODS = 6, STROKES = 40 };
    duct_error error;
    problem self = {.count = rows};
    float *own = make_rows(rows, &self.dimensions), *queries = make_queries(STROKES, &self.strokes);
    self.rows = own;
    self.queries = queries;
    size_t some = rows > 50000 ? 4 : self.strokes, half = rows > 50000 ? 12 : self.strokes;
    flann_index_t forest = plant(&self);
    method methods[METHODS] = {
        {"exact", NULL, NULL, 0, self.strokes}, {"forest-128", NULL, forest, 128, half},
        {"forest-32", NULL, forest, 32, half},  {"kd-tree", NULL, NULL, 0, some},
        {"patchmatch", NULL, NULL, 0, half},    {"scan", NULL, NULL, 0, some},
    };
    static const duct_search_kind kinds[METHODS] = {DUCT_SEARCH_EXACT,      DUCT_SEARCH_EXACT,
                                                    DUCT_SEARCH_EXACT,      DUCT_SEARCH_FLANN,
                                                    DUCT_SEARCH_PATCHMATCH, DUCT_SEARCH_EXACT};
    double built = 0, times[METHODS][ROUNDS], recall[METHODS];
    uint32_t starts[2] = {0, (uint32_t)rows};
    for (size_t m = 0; m < METHODS; m++) {
        if (m == 0 || m == 3 || m == 4) {
            double begin = bench_cpu();
            bench_check(duct_search_new(duct_allocator_of(NULL), kinds[m], self.rows, rows, self.dimensions,
                                        starts, &methods[m].search, &error),
                        &error);
            built = m == 0 ? bench_cpu() - begin : built;
        }
    }
    size_t size = self.strokes * STROKE * K;
    uint32_t *truth = bench_alloc(size, sizeof *truth), *near = bench_alloc(size, sizeof *near);
    for (size_t round = 0; round < (rows > 200000 ? 3 : ROUNDS); round++) {
        for (size_t m = 0; m < METHODS; m++) {
            times[m][round] = run_method(&self, &methods[m], m == 0 ? truth : near);
            if (round == 0) {
                recall[m] = m == 0 ? 1 : recall_of(&self, &methods[m], truth, near);
            }
        }
    }
    printf("search, %zu rows, k = %d (index built in %.0f ms):\n", rows, (int)K, 1e3 * built);
    double reference = 0;
    for (size_t m = 0; m < METHODS; m++) {
        double time = bench_median(times[m], rows > 200000 ? 3 : ROUNDS);
        reference = m == 0 ? time : reference;
        printf("  %-12s %9.2f us a query   recall %.4f   %7.2f times exact's time\n", methods[m].name,
               1e6 * time, recall[m], time / reference);
        fprintf(table, "%zu,%s,%.3f,%.4f\n", rows, methods[m].name, 1e6 * time, recall[m]);
        duct_search_free(methods[m].search);
    }
    fflush(stdout);
    struct FLANNParameters parameters = DEFAULT_FLANN_PARAMETERS;
    flann_free_index_float(forest, &parameters);
    free(own);
    free(queries);
    free(truth);
    free(near);
}

void bench_search_speed(const char *out)
{
    static const size_t sizes[] = {10, 100, 1000, 9000, 100000, 1000000};
    const char *least = getenv("BENCH_LEAST_ROWS"), *most = getenv("BENCH_MOST_ROWS");
    FILE *table = open_table(out, "search");
    fputs("rows,method,microseconds,recall\n", table);
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        if ((least == NULL || sizes[i] >= strtoul(least, NULL, 10)) &&
            (most == NULL || sizes[i] <= strtoul(most, NULL, 10))) {
            search_at(sizes[i] < 2 * K ? 2 * K : sizes[i], table);
        }
    }
    fclose(table);
}

/* ---- whole strokes ---- */

/* libmypaint paints a drawing's strokes with its default brush of 20 pixels; each stroke is made 1,000 pixels
 * long, or keeps the size it has on the page. */
static double paint(const duct_drawing *drawing, double length)
{
    enum { SIDE = 2000 };
    MyPaintFixedTiledSurface *surface = mypaint_fixed_tiled_surface_new(SIDE, SIDE);
    MyPaintSurface *canvas = mypaint_fixed_tiled_surface_interface(surface);
    MyPaintBrush *brush = mypaint_brush_new();
    mypaint_brush_from_defaults(brush);
    mypaint_brush_set_base_value(brush, MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC, (float)log(10));
    double time = 0;
    for (size_t s = 0; s < duct_drawing_stroke_count(drawing); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, s);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        const double *t = duct_stroke_values(stroke, DUCT_T), *p = duct_stroke_values(stroke, DUCT_PRESSURE);
        double made = 0, scale = 1;
        for (size_t i = 1; i < duct_stroke_size(stroke); i++) {
            made += hypot(x[i] - x[i - 1], y[i] - y[i - 1]);
        }
        scale = length > 0 ? length / made : 1;
        double begin = bench_cpu();
        mypaint_brush_reset(brush);
        mypaint_brush_new_stroke(brush);
        mypaint_surface_begin_atomic(canvas);
        for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
            mypaint_brush_stroke_to(brush, canvas, (float)(SIDE / 2 + scale * (x[i] - x[0])),
                                    (float)(SIDE / 2 + scale * (y[i] - y[0])), p != NULL ? (float)p[i] : 0.5f,
                                    0, 0, i > 0 && t != NULL ? t[i] - t[i - 1] : 0.007);
        }
        MyPaintRectangle box;
        mypaint_surface_end_atomic(canvas, &box);
        time += bench_cpu() - begin;
    }
    mypaint_brush_unref(brush);
    mypaint_surface_unref(canvas);
    return time;
}

static void stroke_row(const char *what, FILE *table, double *times, size_t strokes, double painted)
{
    double time = bench_median(times, ROUNDS) / (double)strokes;
    printf("  %-44s %8.4f ms   %6.2f of libmypaint's time\n", what, 1e3 * time, time / painted);
    fprintf(table, "%s,%.5f,%.4f\n", what, 1e3 * time, time / painted);
}

void bench_stroke_speed(const char *out)
{
    enum { MODES = 6 };
    static const char *const names[MODES] = {"trajectory and pose (two passes)",
                                             "one pass",
                                             "pose only",
                                             "average, two passes",
                                             "two passes, k = 10",
                                             "two passes, k = 40"};
    static const char *const settings[MODES][7] = {
        {"mode", "two-pass", NULL},
        {"mode", "one-pass", NULL},
        {"mode", "pose", NULL},
        {"select", "average", NULL},
        {"neighbours", "10", "trajectory-neighbours", "10", NULL},
        {"neighbours", "40", "trajectory-neighbours", "40", NULL},
    };
    duct_error error;
    FILE *table = open_table(out, "strokes");
    fputs("what,milliseconds,of libmypaint\n", table);
    duct_library *hand = bench_library(pages, PAGES, 9000);
    duct_drawing *page = bench_recording(query_page);
    const duct_drawing *list[] = {page};
    duct_library *sampled;
    bench_check(duct_library_build(NULL, list, 1, NULL, &sampled, &error), &error);
    double unit = duct_library_unit(sampled);
    duct_library_free(sampled);
    duct_drawing *queries = bench_cut(page, unit, STROKE - 1, 40);
    size_t strokes = duct_drawing_stroke_count(queries);
    char scale[64];
    snprintf(scale, sizeof scale, "%.17g", unit / duct_library_unit(hand));
    double times[MODES][ROUNDS], painted[ROUNDS], small[ROUNDS], two[ROUNDS], one[ROUNDS];
    duct_drawing *restyled = bench_restyle(hand, queries, 1, (const char *[]){"scale", scale, NULL}, NULL);
    for (size_t round = 0; round < ROUNDS; round++) {
        painted[round] = paint(restyled, 1000) / (double)strokes;
        small[round] = paint(restyled, 0) / (double)strokes;
        for (size_t m = 0; m < MODES; m++) {
            const char *words[16] = {"scale", scale};
            for (size_t i = 0; settings[m][i] != NULL; i++) {
                words[2 + i] = settings[m][i];
            }
            duct_drawing_free(bench_restyle(hand, queries, 1, words, &times[m][round]));
        }
        duct_drawing *many = NULL;
        bench_check(duct_drawing_copy(NULL, page, &many, &error), &error);
        double begin = bench_wall();
        duct_drawing_free(bench_restyle(hand, many, 1, NULL, NULL));
        one[round] = bench_wall() - begin;
        duct_drawing_free(bench_restyle(hand, many, 2, NULL, &two[round]));
        duct_drawing_free(many);
    }
    double reference = bench_median(painted, ROUNDS);
    printf("a stroke of %d samples, %zu library samples, %zu strokes, one thread:\n", (int)STROKE,
           duct_library_sample_count(hand), strokes);
    for (size_t m = 0; m < MODES; m++) {
        stroke_row(names[m], table, times[m], strokes, reference);
    }
    printf("  %-44s %8.4f ms\n", "libmypaint, default brush, 1,000 px long", 1e3 * reference);
    printf("  %-44s %8.4f ms\n", "the same at the page's size (about 130 px)",
           1e3 * bench_median(small, ROUNDS));
    fprintf(table, "libmypaint,%.5f,1\n", 1e3 * reference);
    double single = bench_median(one, ROUNDS), pair = bench_median(two, ROUNDS);
    printf("  a page with two threads: %.2f times as fast as with one\n", single / pair);
    fprintf(table, "two threads beside one,%.3f,\n", single / pair);
    fflush(stdout);
    fclose(table);
    duct_drawing_free(restyled);
    duct_drawing_free(queries);
    duct_drawing_free(page);
    duct_library_free(hand);
}
