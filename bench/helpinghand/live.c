/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Live mode: the time that each sample takes with the default hand and the recordings' own pages, as it would
 * come in from a tablet of 140 and of 1,000 samples a second; and how far its poses are from the whole
 * stroke's. */
#include "bench.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A page at another rate: between recorded samples, straight lines. Calls back for every sample; `index`
 * counts within the stroke. Returns how many there were. */
static size_t play(duct_stream *stream, const duct_drawing *page, double rate, double *times, size_t room)
{
    duct_error error;
    duct_stream_pose pose;
    size_t made = 0;
    for (size_t s = 0; s < duct_drawing_stroke_count(page); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(page, s);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        const double *t = duct_stroke_values(stroke, DUCT_T);
        size_t size = duct_stroke_size(stroke), at = 0;
        if (size < 2 || t == NULL) {
            continue;
        }
        for (size_t i = 0; made < room; i++) {
            double when = t[0] + (double)i / rate;
            while (at + 2 < size && t[at + 1] < when) {
                at++;
            }
            if (when > t[size - 1]) {
                break;
            }
            double span = t[at + 1] - t[at], share = span > 0 ? fmin((when - t[at]) / span, 1) : 1;
            double begin = bench_cpu();
            bench_check(duct_stream_push(stream, x[at] + share * (x[at + 1] - x[at]),
                                         y[at] + share * (y[at + 1] - y[at]), when, &pose, &error),
                        &error);
            times[made++] = bench_cpu() - begin;
        }
        duct_stream_flush(stream, NULL);
    }
    return made;
}

/* What the clock itself takes. */
static double clock_cost(void)
{
    enum { TIMES = 1001 };
    double costs[TIMES];
    for (size_t i = 0; i < TIMES; i++) {
        double begin = bench_cpu();
        costs[i] = bench_cpu() - begin;
    }
    return bench_median(costs, TIMES);
}

void bench_live(const char *out)
{
    enum { ROOM = 200000 };
    duct_error error;
    static const char *const hands[] = {"anna", "helpinghand/SteveEnglish1.cyn"};
    double *times = bench_alloc(ROOM, sizeof *times), cost = clock_cost();
    char path[4096];
    snprintf(path, sizeof path, "%s/live.csv", out);
    FILE *table = fopen(path, "w");
    if (table == NULL) {
        fprintf(stderr, "bench-helpinghand: cannot write %s\n", path);
        exit(1);
    }
    fputs("hand,samples,rate,median microseconds,99th percentile\n", table);
    duct_drawing *page = bench_recording("helpinghand/BrendaEnglish2.cyn");
    const duct_drawing *list[] = {page};
    duct_library *sampled;
    bench_check(duct_library_build(NULL, list, 1, NULL, &sampled, &error), &error);
    printf("live mode, processor time a sample (the clock takes %.2f us of it):\n", 1e6 * cost);
    for (size_t h = 0; h < 2; h++) {
        duct_library *hand;
        if (h == 0) {
            bench_check(duct_library_open(NULL, hands[h], &hand, &error), &error);
        } else {
            hand = bench_library(&hands[h], 1, 9000);
        }
        duct_stream_options options = duct_stream_options_default();
        options.unit = duct_library_unit(sampled);
        duct_stream *stream;
        bench_check(duct_stream_new(NULL, hand, &options, &stream, &error), &error);
        for (int r = 0; r < 2; r++) {
            double rate = r == 0 ? 140 : 1000;
            size_t made = play(stream, page, rate, times, ROOM);
            double middle = bench_quantile(times, made, 0.5), high = bench_quantile(times, made, 0.99);
            printf("  %-30s %6zu library samples, %4.0f Hz: median %6.1f us, 99th percentile %6.1f us (%zu "
                   "samples)\n",
                   hands[h], duct_library_sample_count(hand), rate, 1e6 * middle, 1e6 * high, made);
            fprintf(table, "%s,%zu,%.0f,%.2f,%.2f\n", hands[h], duct_library_sample_count(hand), rate,
                    1e6 * middle, 1e6 * high);
        }
        duct_stream_free(stream);
        duct_library_free(hand);
    }
    fflush(stdout);
    fclose(table);
    duct_library_free(sampled);
    duct_drawing_free(page);
    free(times);
}
