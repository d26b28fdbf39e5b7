/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Styles that follow the line: jitter, wobble, waves, sketchy overdraw, the architect's overshoot. */
#include "style.h"

#include <math.h>

static bool jitter(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    style_line(pair, 1, 0, 0, 360, 0);
    style_curve *drawn = &pair->styled[0];
    for (size_t i = 0; i < drawn->count; i++) {
        double at = (double)i;
        drawn->x[i] += 1.2 * style_noise(11, at / 3.5);
        drawn->y[i] += 2.6 * style_noise(12, at / 4) + 1.2 * style_noise(13, at / 11);
    }
    return true;
}

static bool wobble(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    style_line(pair, 1, 0, 0, 420, 0);
    style_curve *drawn = &pair->styled[0];
    for (size_t i = 0; i < drawn->count; i++) {
        double at = (double)i;
        drawn->x[i] += 2 * style_noise(21, at / 17);
        drawn->y[i] += 5.5 * style_noise(22, at / 19) + 1.2 * style_noise(23, at / 9);
    }
    return true;
}

static bool waves(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    style_line(pair, 1, 0, 0, 420, 0);
    style_curve *drawn = &pair->styled[0];
    double phase = 0;
    for (size_t i = 0; i < drawn->count; i++) {
        double at = (double)i;
        drawn->y[i] += 7 * (1 + 0.2 * style_noise(31, at / 45)) * sin(phase);
        phase += 2 * M_PI / (24 * (1 + 0.12 * style_noise(32, at / 37)));
    }
    return true;
}

/* How far a sample lies beyond its place on a line of length `last` that is drawn too long at both ends. */
static double overshoot(double at, double last, double before, double after)
{
    const double span = 12;
    double begin = fmax(0, 1 - at / span), end = fmax(0, 1 - (last - at) / span);
    return after * end * end - before * begin * begin;
}

/* Drawn three times over, each time a little beside and bent a little differently. */
static bool sketchy(size_t index, style_pair *pair)
{
    static const double lengths[] = {700, 260, 90};
    if (index > 2) {
        return false;
    }
    style_line(pair, 3, 0, 0, lengths[index], 0);
    for (unsigned pass = 0; pass < 3; pass++) {
        style_curve *drawn = &pair->styled[pass];
        unsigned seed = 40 + 10 * pass + (unsigned)index;
        double last = (double)(drawn->count - 1);
        double before = 2 + 9 * style_chance(seed, 1), after = 2 + 9 * style_chance(seed, 2);
        double from = 3.4 * (style_chance(seed, 3) - 0.5), to = 3.4 * (style_chance(seed, 4) - 0.5);
        for (size_t i = 0; i < drawn->count; i++) {
            double share = (double)i / last, at = (double)i;
            drawn->x[i] += overshoot(at, last, before, after);
            drawn->y[i] = from + share * (to - from) + 1.6 * style_noise(seed, at / 38) +
                          0.35 * style_noise(seed + 5, at / 8);
            double hold = fmin(share, 1 - share) * last / 14;
            drawn->pressure[i] = 0.2 + 0.3 * fmin(1, hold) + 0.1 * style_noise(seed + 6, at / 25);
        }
    }
    return true;
}

/* Straight, a hair bent, and beyond the corner at both ends. */
static bool architect(size_t index, style_pair *pair)
{
    static const double lengths[] = {700, 320, 140, 60};
    if (index > 3) {
        return false;
    }
    style_line(pair, 1, 0, 0, lengths[index], 0);
    style_curve *drawn = &pair->styled[0];
    unsigned seed = 70 + (unsigned)index;
    double last = (double)(drawn->count - 1), before = 9 + 5 * style_chance(seed, 1),
           after = 9 + 6 * style_chance(seed, 2), bow = 1.6 * (style_chance(seed, 3) - 0.5);
    for (size_t i = 0; i < drawn->count; i++) {
        double share = (double)i / last, at = (double)i;
        drawn->x[i] += overshoot(at, last, before, after);
        drawn->y[i] = bow * sin(M_PI * share) + 0.45 * style_noise(seed, at / 16);
        double hold = fmin(share, 1 - share) * last;
        drawn->pressure[i] = 0.38 + 0.42 * exp(-hold / 5);
    }
    return true;
}

const style styles_lines[] = {
    {"jitter", "Jitter", "0", "rotation", NULL, NULL, false, jitter},
    {"wobble", "Wobble", "0", "rotation", NULL, NULL, false, wobble},
    {"waves", "Waves", "0", "rotation", NULL, NULL, false, waves},
    {"sketchy", "Sketchy overdraw", "0", "rotation", "false", "true", true, sketchy},
    {"architect", "Architect's overshoot", "0", "rotation", "false", "true", true, architect},
};
const size_t styles_lines_count = sizeof styles_lines / sizeof styles_lines[0];
