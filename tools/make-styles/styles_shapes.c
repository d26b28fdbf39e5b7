/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Styles with shapes of their own along the line: loops, grass, blocks, thorns. */
#include "style.h"

#include <math.h>

static double mix(double a, double b, double share)
{
    return a + share * (b - a);
}

/* Adds a piece from the last sample to (x, y), bent by `bow` to the left, over `steps` samples, while the
 * plain line goes on evenly to x = `along`. */
static void piece(style_pair *pair, double x, double y, double bow, double along, size_t steps)
{
    style_curve *plain = &pair->plain, *drawn = &pair->styled[0];
    double x0 = drawn->x[drawn->count - 1], y0 = drawn->y[drawn->count - 1];
    double from = plain->x[plain->count - 1], dx = x - x0, dy = y - y0;
    for (size_t i = 1; i <= steps; i++) {
        double share = (double)i / (double)steps, lift = bow * 4 * share * (1 - share);
        style_add(plain, mix(from, along, share), 0, 0.5);
        style_add(drawn, x0 + share * dx + lift * dy, y0 + share * dy - lift * dx, 0.5);
    }
}

static bool loops(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    double phase = M_PI / 2;
    pair->passes = 1;
    for (double at = 0; at < 330; at += 0.35) {
        double size = 8.5 * (1 + 0.22 * style_noise(91, at / 32)),
               pitch = 13 + 2.5 * style_noise(92, at / 27);
        style_add(&pair->plain, at, 0, 0.5);
        style_add(&pair->styled[0], at + 0.75 * size * cos(phase), size * sin(phase) - 1, 0.5);
        phase -= 0.35 * 2 * M_PI / pitch;
    }
    return true;
}

static bool grass(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    pair->passes = 1;
    style_add(&pair->plain, 0, 0, 0.5);
    style_add(&pair->styled[0], 0, 0, 0.5);
    double at = 0;
    for (unsigned blade = 0; at < 330; blade++) {
        double width = 5 + 4 * style_chance(101, blade), height = 12 + 15 * style_chance(102, blade);
        double lean = 9 * (style_chance(103, blade) - 0.35);
        size_t steps = (size_t)(height * 1.2);
        piece(pair, at + 0.4 * width + lean, -height, 0.1, at + 0.5 * width, steps);
        piece(pair, at + width, 1.5 * (style_chance(104, blade) - 0.5), -0.08, at + width, steps);
        at += width;
    }
    return true;
}

static bool blocks(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    pair->passes = 1;
    style_add(&pair->plain, 0, 0, 0.5);
    style_add(&pair->styled[0], 0, 0, 0.5);
    double at = 0;
    for (unsigned block = 0; at < 360; block++) {
        double gap = 9 + 3 * style_chance(111, block), width = 10 + 5 * style_chance(112, block);
        double height = 11 + 4 * style_chance(113, block), total = gap + width + 2 * height;
        double begin = at, span = gap + width;
        double walked = gap;
        piece(pair, at + gap, 0, 0, begin + span * walked / total, 14);
        walked += height;
        piece(pair, at + gap, -height, 0, begin + span * walked / total, 14);
        walked += width;
        piece(pair, at + gap + width, -height, 0, begin + span * walked / total, 14);
        piece(pair, at + gap + width, 0, 0, begin + span, 14);
        at += span;
    }
    return true;
}

/* A quiet line with a thorn now and then, on either side. */
static bool thorns(size_t index, style_pair *pair)
{
    if (index > 0) {
        return false;
    }
    pair->passes = 1;
    style_add(&pair->plain, 0, 0, 0.5);
    style_add(&pair->styled[0], 0, 0, 0.5);
    double at = 0;
    for (unsigned thorn = 0; at < 420; thorn++) {
        double quiet = 14 + 16 * style_chance(121, thorn), side = thorn % 2 == 0 ? -1 : 1;
        double height = 6 + 5 * style_chance(122, thorn);
        piece(pair, at + quiet, 0.8 * style_noise(123, thorn), 0.03 * side, at + quiet, (size_t)quiet);
        at += quiet;
        piece(pair, at + 5, side * height, 0.14 * side, at + 2.5, 12);
        piece(pair, at + 5.5, 0, -0.05 * side, at + 5.5, 12);
        at += 5.5;
    }
    piece(pair, at + 20, 0, 0, at + 20, 20);
    return true;
}

const style styles_shapes[] = {
    {"loops", "Loops", "0", "rotation", NULL, NULL, false, loops},
    {"grass", "Grass", "0", "rotation", NULL, NULL, false, grass},
    {"blocks", "Blocks", "0", "rotation", NULL, NULL, false, blocks},
    {"thorns", "Thorns", "0", "rotation", NULL, NULL, false, thorns},
};
const size_t styles_shapes_count = sizeof styles_shapes / sizeof styles_shapes[0];
