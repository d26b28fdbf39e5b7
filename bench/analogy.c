/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast `analogy` is, beside the exact search in the same run, one thread:
 *
 *     bench-analogy [TABLE.svg]
 *
 * - a curve of 500 samples in the style of an example pair of 500, multiresolution, at the paper's
 * neighbourhood (81 samples): milliseconds with the exact and with the fast search, their mean energies, and
 * the same with the example made ready beforehand, as for every curve of a drawing but the first;
 * - the same against the curve's length, and against the example's. With a file name, as a chart.
 *
 * Only the ratios within one run mean anything. */
#include "analogy/analogy.h"
#include "base/memory.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { ROUNDS = 5, COURSES = 8, MOST_POINTS = 8 };

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void check(duct_status status, const duct_error *error)
{
    if (status != DUCT_OK) {
        fprintf(stderr, "bench-analogy: %s\n", error->message);
        exit(1);
    }
}

/* One of many bent courses of `count` points, a pixel apart. */
static duct_curve make_course(size_t count, int variant)
{
    duct_error error;
    duct_curve curve;
    check(duct_curve_init(duct_allocator_of(NULL), count, false, false, &curve, &error), &error);
    double x = 0, y = 0;
    for (size_t i = 0; i < count; i++) {
        double at = (double)i, angle = 0.5 * sin(at / 47 + variant) + 0.4 * sin(at / 31.7 + 1);
        curve.x[i] = x;
        curve.y[i] = y;
        x += cos(angle);
        y += sin(angle);
    }
    duct_curve_use_arc_length(&curve);
    return curve;
}

/* Waves whose length and height drift, on a straight line, `count` points of each about a pixel apart. */
static duct_curve_pair make_example(size_t count)
{
    duct_error error;
    duct_curve_pair pair;
    const duct_allocator *allocator = duct_allocator_of(NULL);
    check(duct_curve_init(allocator, count, false, false, &pair.a, &error), &error);
    check(duct_curve_init(allocator, count, false, false, &pair.b, &error), &error);
    for (size_t i = 0; i < count; i++) {
        double at = 0.78 * (double)i;
        pair.a.x[i] = pair.b.x[i] = at;
        pair.b.y[i] = (4 + sin(at / 53)) * sin(at / (3.6 + 0.3 * sin(at / 71)));
    }
    duct_curve_use_arc_length(&pair.a);
    memcpy(pair.b.t, pair.a.t, count * sizeof *pair.b.t);
    return pair;
}

typedef struct {
    double prepared, whole, energy; /* seconds, seconds, cost */
    size_t points;
} result;

/* The best of several rounds. */
static result run(size_t length, size_t example, bool exact, int variant, int rounds)
{
    duct_error error;
    result best = {INFINITY, INFINITY, 0, 0};
    duct_curve course = make_course(length, variant);
    duct_curve_pair pair = make_example(example);
    duct_analogy_options options = duct_analogy_options_default();
    options.exact = exact;
    options.randomness = 0;
    for (int round = 0; round < rounds; round++) {
        duct_analogy *analogy;
        duct_analogy_figures figures;
        duct_curve made;
        double start = now();
        check(duct_analogy_new(duct_allocator_of(NULL), &pair, 1, &options, &analogy, &error), &error);
        double ready = now();
        check(duct_analogy_apply(analogy, &course, 1, NULL, 0, &made, &figures, &error), &error);
        double end = now();
        best.whole = fmin(best.whole, end - start);
        best.prepared = fmin(best.prepared, end - ready);
        best.energy = figures.energy;
        best.points = made.count;
        duct_curve_done(duct_allocator_of(NULL), &made);
        duct_analogy_free(analogy);
    }
    duct_curve_done(duct_allocator_of(NULL), &course);
    duct_curve_done(duct_allocator_of(NULL), &pair.a);
    duct_curve_done(duct_allocator_of(NULL), &pair.b);
    return best;
}

/* Two lines of milliseconds over samples, as SVG. */
static void draw(const char *path, const double *at, const double *by_length, const double *by_example,
                 size_t count)
{
    FILE *file = fopen(path, "w");
    if (file == NULL) {
        fprintf(stderr, "bench-analogy: %s cannot be written\n", path);
        exit(1);
    }
    double most = 0, right = at[count - 1];
    for (size_t i = 0; i < count; i++) {
        most = fmax(most, fmax(by_length[i], by_example[i]));
    }
    fputs("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"520\" height=\"300\" font-family=\"sans-serif\" "
          "font-size=\"12\"><rect width=\"520\" height=\"300\" fill=\"white\"/><path d=\"M50 20V260H500\" "
          "fill=\"none\" stroke=\"black\"/>\n",
          file);
    const double *lines[] = {by_length, by_example};
    const char *colours[] = {"#0b62a4", "#c8501e"};
    const char *names[] = {"against the curve's samples (example 500)", "against the example's (curve 500)"};
    for (int l = 0; l < 2; l++) {
        fprintf(file, "<polyline fill=\"none\" stroke=\"%s\" stroke-width=\"2\" points=\"", colours[l]);
        for (size_t i = 0; i < count; i++) {
            fprintf(file, "%.1f,%.1f ", 50 + 450 * at[i] / right, 260 - 230 * lines[l][i] / most);
        }
        fprintf(file, "\"/><text x=\"70\" y=\"%d\" fill=\"%s\">%s</text>\n", 40 + 18 * l, colours[l],
                names[l]);
    }
    for (size_t i = 0; i < count; i++) {
        if (i + 1 == count || at[i] >= right / 4) {
            fprintf(file, "<text x=\"%.1f\" y=\"276\" text-anchor=\"middle\">%g</text>\n",
                    50 + 450 * at[i] / right, at[i]);
        }
    }
    fprintf(file,
            "<text x=\"44\" y=\"34\" text-anchor=\"end\">%.0f</text><text x=\"44\" y=\"16\" "
            "text-anchor=\"end\">ms</text><text x=\"275\" y=\"294\" "
            "text-anchor=\"middle\">samples</text></svg>\n",
            most);
    fclose(file);
}

int main(int count, char **words)
{
    result exact = run(500, 500, true, 0, 1), fast = run(500, 500, false, 0, ROUNDS);
    printf("a curve of 500 samples, an example of 500, one thread:\n");
    printf("  exact search      %8.1f ms   mean energy %.4g   %zu points\n", 1e3 * exact.whole, exact.energy,
           exact.points);
    printf("  fast search       %8.1f ms   mean energy %.4g   %zu points   %.1f times as fast\n",
           1e3 * fast.whole, fast.energy, fast.points, exact.whole / fast.whole);
    printf("  example made ready %7.1f ms\n", 1e3 * fast.prepared);
    double energies[2] = {exact.energy, fast.energy};
    for (int variant = 1; variant < COURSES; variant++) {
        energies[0] += run(500, 500, true, variant, 1).energy;
        energies[1] += run(500, 500, false, variant, 1).energy;
    }
    printf("  over %d courses    mean energy %.4g with the exact search, %.4g with the fast one\n", COURSES,
           energies[0] / COURSES, energies[1] / COURSES);
    const double sizes[] = {125, 250, 500, 1000, 2000, 4000};
    double by_length[MOST_POINTS], by_example[MOST_POINTS];
    size_t steps = sizeof sizes / sizeof sizes[0];
    printf("samples   ms by length of the curve   ms by length of the example\n");
    for (size_t i = 0; i < steps; i++) {
        by_length[i] = 1e3 * run((size_t)sizes[i], 500, false, 0, 2).whole;
        by_example[i] = 1e3 * run(500, (size_t)sizes[i], false, 0, 2).whole;
        printf("%7g %10.1f %27.1f\n", sizes[i], by_length[i], by_example[i]);
    }
    if (count > 1) {
        draw(words[1], sizes, by_length, by_example, steps);
    }
    return 0;
}
