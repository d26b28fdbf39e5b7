/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BRUSH_COLOUR_H
#define DUCTUS_BRUSH_COLOUR_H

#include <math.h>

/* Hue, saturation and value, each 0..1, of a colour whose parts are 0..1 (others are clamped). */
static inline void duct_hsv(float red, float green, float blue, float hsv[3])
{
    float r = fminf(fmaxf(red, 0), 1), g = fminf(fmaxf(green, 0), 1), b = fminf(fmaxf(blue, 0), 1);
    float most = fmaxf(r, fmaxf(g, b)), range = most - fminf(r, fminf(g, b)), hue = 0;
    if (range > 0) {
        if (most <= r) {
            hue = (g - b) / range + (g < b ? 6.0f : 0.0f);
        } else if (most <= g) {
            hue = (b - r) / range + 2;
        } else {
            hue = (r - g) / range + 4;
        }
    }
    hsv[0] = hue / 6;
    hsv[1] = most > 0 ? range / most : 0;
    hsv[2] = most;
}

#endif
