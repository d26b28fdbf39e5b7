/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_MAKE_STYLES_STYLE_H
#define DUCTUS_MAKE_STYLES_STYLE_H

#include <stdbool.h>
#include <stddef.h>

/* A style as a drawing of pairs of curves that a program computes: all in drawing pixels. A and A' have
 * equally many samples, and those of the same number belong together. */

enum { MOST_SAMPLES = 4000, MOST_CURVES = 4, MOST_PASSES = 3 };

typedef struct style_curve {
    size_t count;
    bool closed;
    double x[MOST_SAMPLES], y[MOST_SAMPLES];
    double pressure[MOST_SAMPLES];
} style_curve;

typedef struct style_pair {
    style_curve plain;
    style_curve styled[MOST_PASSES]; /* A', A'' ...: each is drawn for every curve */
    size_t passes;
} style_pair;

typedef struct style {
    const char *name;
    const char *label;
    /* What suits the style, where the user leaves it to the style; NULL: the operation's own. */
    const char *shape_weight, *invariance, *join_corners, *split_corners;
    bool pressure;
    /* Draws example `index`; false when there is no such one. */
    bool (*draw)(size_t index, style_pair *pair);
} style;

extern const style styles_lines[], styles_shapes[], styles_pen[];
extern const size_t styles_lines_count, styles_shapes_count, styles_pen_count;

void style_add(style_curve *curve, double x, double y, double pressure);

/* Smooth noise in -1..1, one bump a unit: a function of (seed, place). */
double style_noise(unsigned seed, double place);

/* Uniform in 0..1: a function of (seed, number). */
double style_chance(unsigned seed, unsigned number);

/* A line from (x0, y0) to (x1, y1), sampled every pixel, with A' equal to it. */
void style_line(style_pair *pair, size_t passes, double x0, double y0, double x1, double y1);

#endif
