/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast `restyle` is, against references measured in the same run:
 *
 *     bench-restyle [HAND [DRAWING]]     (default: the hand "anna" on the page of the hand "bruno")
 *
 * - search: microseconds a query and recall, beside a plain scan of all rows;
 * - one thread: milliseconds a stroke for trajectory and pose, beside the same with a plain scan in place of
 * the search, beside libmypaint painting the same strokes, and beside the 0.08 s of the HelpingHand paper
 * (2012);
 * - threads: how much faster two are than one;
 * - size: time and memory for 10,000 strokes in one run. */
#include "base/memory.h"
#include "features/features.h"
#include "geometry/resample.h"
#include "library/feature_index.h"
#include "library/library_private.h"
#include "search/search.h"

#include <ductus/ductus.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

enum { ROUNDS = 7, K = 20, MANY = 10000 };
static const double paper_seconds = 0.08;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void check(duct_status status, const duct_error *error)
{
    if (status != DUCT_OK) {
        fprintf(stderr, "bench-restyle: %s\n", error->message);
        exit(1);
    }
}

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *values, size_t count)
{
    qsort(values, count, sizeof *values, by_value);
    return values[count / 2];
}

/* The reference search: every row, in order, the K best kept by insertion. */
static size_t scan(const float *rows, size_t count, size_t dimensions, const float *query, uint32_t *near,
                   float *squares)
{
    size_t kept = 0;
    for (size_t row = 0; row < count; row++) {
        float square = 0;
        for (size_t d = 0; d < dimensions; d++) {
            float difference = query[d] - rows[row * dimensions + d];
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
    return kept;
}

/* The features of all strokes of a drawing, sampled so that its median stroke is as long as the library's. */
static float *make_queries(const duct_drawing *drawing, size_t *count)
{
    duct_error error;
    duct_library *sampled;
    const duct_drawing *list[] = {drawing};
    duct_feature_options options = duct_feature_options_default();
    check(duct_library_build(NULL, list, 1, NULL, &sampled, &error), &error);
    duct_feature_index index;
    check(duct_library_features(sampled, &options, DUCT_SEARCH_EXACT, &index, &error), &error);
    *count = duct_library_sample_count(sampled);
    float *rows = malloc(*count * index.dimensions * sizeof *rows);
    memcpy(rows, index.rows, *count * index.dimensions * sizeof *rows);
    duct_library_free(sampled);
    return rows;
}

static double bench_search(const duct_library *library, const duct_drawing *drawing)
{
    duct_error error;
    duct_feature_options options = duct_feature_options_default();
    duct_feature_index exact, flann;
    check(duct_library_features(library, &options, DUCT_SEARCH_EXACT, &exact, &error), &error);
    check(duct_library_features(library, &options, DUCT_SEARCH_FLANN, &flann, &error), &error);
    size_t query_count, rows = duct_library_sample_count(library), dimensions = exact.dimensions;
    float *queries = make_queries(drawing, &query_count);
    const duct_search *kinds[] = {NULL, exact.search, flann.search};
    static const char *const names[] = {"plain scan", "exact", "flann"};
    double times[3][ROUNDS], recall[3] = {0};
    uint32_t *truth = malloc(query_count * K * sizeof *truth);
    for (size_t round = 0; round < ROUNDS; round++) {
        for (size_t kind = 0; kind < 3; kind++) {
            size_t met = 0, hint_count = 0;
            uint32_t near[K], hints[2 * K];
            float distances[K];
            double begin = now();
            for (size_t q = 0; q < query_count; q++) {
                const float *query = queries + q * dimensions;
                size_t found = kind == 0 ? scan(exact.rows, rows, dimensions, query, near, distances)
                                         : duct_search_nearest(kinds[kind], query, K, hints, hint_count, near,
                                                               distances);
                hint_count = 0;
                for (size_t n = 0; n < found; n++) {
                    hints[hint_count++] = near[n];
                    hints[hint_count++] = near[n] + 1;
                }
                if (kind == 0 && round == 0) {
                    memcpy(truth + q * K, near, sizeof near);
                }
                for (size_t n = 0; round == 0 && n < found; n++) {
                    for (size_t t = 0; t < K; t++) {
                        met += near[n] == truth[q * K + t];
                    }
                }
            }
            times[kind][round] = (now() - begin) / (double)query_count;
            if (round == 0) {
                recall[kind] = (double)met / (double)(query_count * K);
            }
        }
    }
    double reference = median(times[0], ROUNDS);
    printf("search, %zu rows of %zu, k = %d, %zu queries:\n", rows, dimensions, (int)K, query_count);
    for (size_t kind = 0; kind < 3; kind++) {
        double time = median(times[kind], ROUNDS);
        printf("  %-12s %8.2f us a query   recall %.4f   %5.1f times the plain scan's speed\n", names[kind],
               1e6 * time, recall[kind], reference / time);
    }
    free(queries);
    free(truth);
    return reference * (double)query_count;
}

static double run_once(const duct_library *hand, const duct_drawing *drawing, int threads,
                       duct_drawing **kept)
{
    duct_error error;
    const duct_operation *operation;
    duct_settings *settings;
    duct_drawing *output;
    duct_context context = duct_context_default();
    context.threads = threads;
    check(duct_operation_find("restyle", &operation, &error), &error);
    check(duct_settings_new(NULL, operation, &settings, &error), &error);
    check(duct_settings_library(settings, "hand", hand, &error), &error);
    double begin = now();
    check(duct_operation_run(&context, settings, drawing, NULL, &output, &error), &error);
    double time = now() - begin;
    duct_settings_free(settings);
    if (kept != NULL) {
        *kept = output;
    } else {
        duct_drawing_free(output);
    }
    return time;
}

static double paint_once(const duct_drawing *drawing, const duct_brush *brush)
{
    duct_error error;
    duct_canvas *canvas;
    duct_render_options options = duct_render_options_default();
    options.resolution = 96;
    options.paint.brush_size = 8;
    double begin = now();
    check(duct_render(NULL, drawing, brush, &options, &canvas, &error), &error);
    double time = now() - begin;
    duct_canvas_free(canvas);
    return time;
}

static void bench_strokes(const duct_library *hand, const duct_drawing *drawing, double scan_seconds)
{
    duct_error error;
    duct_brush *brush;
    duct_drawing *restyled;
    check(duct_brush_load(NULL, "ink", &brush, &error), &error);
    double strokes = (double)duct_drawing_stroke_count(drawing);
    double one[ROUNDS], two[ROUNDS], paint[ROUNDS];
    run_once(hand, drawing, 1, &restyled);
    for (size_t round = 0; round < ROUNDS; round++) {
        one[round] = run_once(hand, drawing, 1, NULL) / strokes;
        two[round] = run_once(hand, drawing, 2, NULL) / strokes;
        paint[round] = paint_once(restyled, brush) / strokes;
    }
    double single = median(one, ROUNDS), pair = median(two, ROUNDS), painted = median(paint, ROUNDS);
    /* Two passes ask one query a sample each. The reference does the same work with the plain scan. */
    double reference = single + 2 * scan_seconds / strokes;
    printf("trajectory and pose, %zu strokes, one thread:\n", duct_drawing_stroke_count(drawing));
    printf("  %.3f ms a stroke\n", 1e3 * single);
    printf("  %6.1f times as fast as with a plain scan (about %.2f ms)\n", reference / single,
           1e3 * reference);
    printf("  %6.1f times as fast as the paper's 0.08 s of 2012\n", paper_seconds / single);
    printf("  %6.2f of the time that libmypaint takes to paint the strokes\n", single / painted);
    printf("two threads: %.2f times as fast as one\n", single / pair);
    duct_drawing_free(restyled);
    duct_brush_free(brush);
}

static double peak_mib(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)usage.ru_maxrss / 1024;
}

static double drawing_mib(const duct_drawing *drawing)
{
    size_t bytes = 0;
    for (size_t s = 0; s < duct_drawing_stroke_count(drawing); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, s);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            bytes += duct_stroke_values(stroke, (duct_channel)c) != NULL
                         ? duct_stroke_size(stroke) * sizeof(double)
                         : 0;
        }
    }
    return (double)bytes / (1 << 20);
}

static void bench_size(const duct_library *hand, const duct_drawing *page)
{
    duct_error error;
    duct_drawing *many, *output;
    check(duct_drawing_new(NULL, &many, &error), &error);
    for (size_t i = 0; i < MANY; i++) {
        check(duct_drawing_add_copy(many, duct_drawing_stroke(page, i % duct_drawing_stroke_count(page)),
                                    NULL, &error),
              &error);
    }
    double before = peak_mib(), time = run_once(hand, many, 0, &output), after = peak_mib();
    printf("%d strokes in one run: %.2f s on all processors; memory grew by %.0f MiB, of which the output is "
           "%.0f\n",
           (int)MANY, time, after - before, drawing_mib(output));
    duct_drawing_free(output);
    duct_drawing_free(many);
}

int main(int count, char **words)
{
    duct_error error;
    duct_library *hand, *other = NULL;
    duct_drawing *drawing;
    check(duct_library_open(NULL, count > 1 ? words[1] : "anna", &hand, &error), &error);
    if (count > 2) {
        check(duct_drawing_read(NULL, words[2], NULL, &drawing, &error), &error);
    } else {
        check(duct_library_open(NULL, "bruno", &other, &error), &error);
        check(duct_library_drawing(NULL, other, &drawing, &error), &error);
    }
    printf("hand %s: %zu strokes, %zu samples\n", duct_library_name(hand), duct_library_stroke_count(hand),
           duct_library_sample_count(hand));
    double scan_seconds = bench_search(hand, drawing);
    bench_strokes(hand, drawing, scan_seconds);
    bench_size(hand, drawing);
    duct_drawing_free(drawing);
    duct_library_free(other);
    duct_library_free(hand);
    return 0;
}
