/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Styles with pressure: gothic, dry brush, calligraphy. */
#include "style.h"

#include <math.h>

static void stroke_to(style_pair *pair, double x, double y, double from, double to, double along)
{
    style_curve *plain = &pair->plain, *drawn = &pair->styled[0];
    double x0 = drawn->x[drawn->count - 1], y0 = drawn->y[drawn->count - 1];
    double start = plain->x[plain->count - 1];
    size_t steps = (size_t)(hypot(x - x0, y - y0) * 1.2) + 4;
    for (size_t i = 1; i <= steps; i++) {
        double share = (double)i / (double)steps;
        style_add(plain, start + share * (along - start), 0, 0.5);
        style_add(drawn, x0 + share * (x - x0), y0 + share * (y - y0), from + share * (to - from));
    }
}

/* Minims of a broken script: heavy and upright, with a foot to the right, joined by hairlines. */
static bool gothic(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    pair->passes = 1;
    style_add(&pair->plain, 0, 0, 0.5);
    style_add(&pair->styled[0], 0, 0, 0.1);
    double at = 0;
    for (unsigned minim = 0; at < 330; minim++) {
        double pitch = 12 + 2.5 * style_chance(131, minim), height = 17 + 4 * style_chance(132, minim);
        stroke_to(pair, at + 0.34 * pitch, -height, 0.06, 0.06, at + 0.3 * pitch);
        stroke_to(pair, at + 0.55 * pitch, -height + 4, 0.5, 1, at + 0.42 * pitch);
        stroke_to(pair, at + 0.55 * pitch, -3.5, 1, 1, at + 0.75 * pitch);
        stroke_to(pair, at + 0.85 * pitch, 0, 1, 0.3, at + 0.9 * pitch);
        stroke_to(pair, at + pitch, -1.5, 0.1, 0.06, at + pitch);
        at += pitch;
    }
    return true;
}

/* A loaded brush that sets down, runs dry in streaks, and lifts. */
static bool dry_brush(size_t index, style_pair *pair)
{
    static const double lengths[] = {400, 140};
    if (index > 1) {
        return false;
    }
    style_line(pair, 1, 0, 0, lengths[index], 0);
    style_curve *drawn = &pair->styled[0];
    unsigned seed = 140 + (unsigned)index;
    double last = (double)(drawn->count - 1);
    for (size_t i = 0; i < drawn->count; i++) {
        double at = (double)i, share = at / last;
        double down = fmin(1, at / 9), up = fmin(1, (last - at) / 26);
        double streak = 0.5 + 0.5 * style_noise(seed, at / 13), grit = style_noise(seed + 1, at / 2.6);
        double dry = 0.25 + 0.75 * share;
        double load = 1 - dry * (0.62 * streak + 0.22 * fabs(grit));
        drawn->pressure[i] = fmax(0.02, fmin(1, sqrt(down) * pow(up, 0.8) * load));
        drawn->y[i] += 1.3 * style_noise(seed + 2, at / 31) + 0.5 * grit * dry;
    }
    return true;
}

/* A broad pen held at one angle: thick and thin by direction. */
static bool calligraphy(size_t index, style_pair *pair)
{
    const size_t count = 560;
    if (index > 1) {
        return false;
    }
    pair->passes = 1;
    pair->plain.closed = pair->styled[0].closed = true;
    for (size_t i = 0; i < count; i++) {
        double turn = 2 * M_PI * (double)i / (double)count * (index == 0 ? 1 : -1);
        double x = 90 * cos(turn), y = 90 * sin(turn);
        double dx = index == 0 ? -sin(turn) : sin(turn), dy = index == 0 ? cos(turn) : -cos(turn);
        double across = fabs(dx * sin(-0.7) - dy * cos(-0.7));
        double hand = style_noise(150 + (unsigned)index, (double)i / 30);
        double back = style_noise(150 + (unsigned)index, ((double)i - (double)count) / 30);
        double blend = (double)i / (double)count;
        double wander = 1.2 * ((1 - blend) * hand + blend * back);
        style_add(&pair->plain, x, y, 0.5);
        style_add(&pair->styled[0], x + wander * cos(turn), y + wander * sin(turn),
                  0.04 + 0.92 * across * across);
    }
    return true;
}

const style styles_pen[] = {
    {"gothic", "Gothic", "0", "rotation", NULL, NULL, true, gothic},
    {"dry-brush", "Dry brush", "0", "rotation", "false", "true", true, dry_brush},
    {"calligraphy", "Broad pen", "2", "translation", NULL, NULL, true, calligraphy},
};
const size_t styles_pen_count = sizeof styles_pen / sizeof styles_pen[0];
