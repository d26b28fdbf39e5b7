/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program that gives pose while a stroke is being drawn: replay HAND RECORDING [--fast]
 *
 * It plays a recording back in real time, as if somebody drew it now, hands each sample to a stream as it
 * comes, and prints the pose that the hand has for it and the time that took. --fast leaves the waiting out.
 * Samples without time come 140 a second, the rate of the tablets of the HelpingHand paper. */
#define _POSIX_C_SOURCE 200809L

#include <ductus/ductus.h>

#include <stdio.h>
#include <string.h>
#include <time.h>

enum { RATE = 140 };

typedef struct {
    size_t samples;
    double sum, most; /* seconds */
} timing;

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

static void wait_until(double when)
{
    double left = when - now();
    if (left > 0) {
        struct timespec pause = {(time_t)left, (long)(1e9 * (left - (double)(time_t)left))};
        nanosleep(&pause, NULL);
    }
}

static void print_pose(const duct_library *hand, const char *what, double took, const duct_stream_pose *pose)
{
    const double values[] = {pose->pressure, pose->tilt_x, pose->tilt_y, pose->twist};
    printf("%s", what);
    for (int i = 0; i < 4; i++) {
        /* What the hand's tablet could not measure is absent, not 0. */
        duct_channel channel = (duct_channel)(DUCT_PRESSURE + i);
        if (duct_library_has(hand, channel)) {
            printf(" %s %.3f", duct_channel_name(channel), values[i]);
        }
    }
    if (took > 0) {
        printf(" (%.0f us)", 1e6 * took);
    }
    printf("\n");
}

static duct_status replay_stroke(duct_stream *stream, const duct_library *hand, const duct_stroke *stroke,
                                 bool fast, timing *times, duct_error *error)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    const double *t = duct_stroke_values(stroke, DUCT_T);
    double begun = now();
    duct_stream_pose pose;
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        double when = t != NULL ? t[i] - t[0] : (double)i / RATE;
        if (!fast) {
            wait_until(begun + when);
        }
        double before = now();
        duct_status status = duct_stream_push(stream, x[i], y[i], when, &pose, error);
        if (status != DUCT_OK) {
            return status;
        }
        double took = now() - before;
        times->samples++;
        times->sum += took;
        times->most = took > times->most ? took : times->most;
        char place[96];
        snprintf(place, sizeof place, "  %.2f %.2f:", x[i], y[i]);
        print_pose(hand, place, took, &pose);
        fflush(stdout);
    }
    if (duct_stream_flush(stream, &pose)) {
        print_pose(hand, "  end:", 0, &pose);
    }
    return DUCT_OK;
}

int main(int count, char **words)
{
    bool fast = count == 4 && strcmp(words[3], "--fast") == 0;
    if (count != 3 && !fast) {
        fprintf(stderr, "usage: replay HAND RECORDING [--fast]\n");
        return 2;
    }
    duct_context context = duct_context_default();
    duct_error error = {DUCT_OK, ""};
    duct_library *hand = NULL;
    duct_drawing *recording = NULL;
    duct_stream *stream = NULL;
    timing times = {0, 0, 0};

    duct_status status = duct_library_open(&context, words[1], &hand, &error);
    if (status == DUCT_OK) {
        status = duct_drawing_read(&context, words[2], NULL, &recording, &error);
    }
    if (status == DUCT_OK) {
        status = duct_stream_new(&context, hand, NULL, &stream, &error);
    }
    for (size_t i = 0; status == DUCT_OK && i < duct_drawing_stroke_count(recording); i++) {
        printf("stroke %zu\n", i + 1);
        status = replay_stroke(stream, hand, duct_drawing_stroke(recording, i), fast, &times, &error);
    }
    if (status != DUCT_OK) {
        fprintf(stderr, "replay: %s\n", error.message);
    } else if (times.samples > 0) {
        printf("%zu samples: %.0f us each, %.0f us at most; a tablet leaves %.0f us\n", times.samples,
               1e6 * times.sum / (double)times.samples, 1e6 * times.most, 1e6 / RATE);
    }
    duct_stream_free(stream);
    duct_drawing_free(recording);
    duct_library_free(hand);
    return status == DUCT_OK ? 0 : 1;
}
