/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_PICTURES_H
#define DUCTUS_TESTS_PICTURES_H

#include "testing.h"

#include <ductus/lineart.h>

#include <math.h>

/* A grey picture to draw on and to trace. */
typedef struct picture {
    int width, height;
    uint8_t *grey;
} picture;

static inline picture new_picture(int width, int height, uint8_t level)
{
    picture made = {width, height, malloc((size_t)width * (size_t)height)};
    memset(made.grey, level, (size_t)width * (size_t)height);
    return made;
}

static inline bool picture_rows(void *user, int y, int count, uint8_t *grey)
{
    const picture *from = user;
    memcpy(grey, from->grey + (size_t)y * (size_t)from->width, (size_t)count * (size_t)from->width);
    return true;
}

static inline double to_segment(double x, double y, double ax, double ay, double bx, double by)
{
    double dx = bx - ax, dy = by - ay, square = dx * dx + dy * dy;
    double t = square > 0 ? ((x - ax) * dx + (y - ay) * dy) / square : 0;
    t = fmin(fmax(t, 0), 1);
    return hypot(x - ax - t * dx, y - ay - t * dy);
}

static inline void ink(picture *to, int x, int y, double cover, double level)
{
    uint8_t *pixel = &to->grey[(size_t)y * (size_t)to->width + (size_t)x];
    cover = fmin(fmax(cover, 0), 1);
    *pixel = (uint8_t)(*pixel + (level - *pixel) * cover + 0.5);
}

/* A line with round ends and smoothed edges. */
static inline void draw_line(picture *to, double ax, double ay, double bx, double by, double width,
                             double level)
{
    for (int y = 0; y < to->height; y++) {
        for (int x = 0; x < to->width; x++) {
            double cover = width / 2 + 0.5 - to_segment(x + 0.5, y + 0.5, ax, ay, bx, by);
            if (cover > 0) {
                ink(to, x, y, cover, level);
            }
        }
    }
}

static inline void draw_ring(picture *to, double cx, double cy, double radius, double width, double level)
{
    for (int y = 0; y < to->height; y++) {
        for (int x = 0; x < to->width; x++) {
            double away = fabs(hypot(x + 0.5 - cx, y + 0.5 - cy) - radius);
            if (width / 2 + 0.5 > away) {
                ink(to, x, y, width / 2 + 0.5 - away, level);
            }
        }
    }
}

static inline duct_drawing *trace(picture *from, const duct_lineart_options *options)
{
    duct_error error;
    duct_drawing *drawing = NULL;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    assert_ok(
        duct_lineart_trace(NULL, from->width, from->height, picture_rows, from, options, drawing, &error));
    return drawing;
}

#endif
