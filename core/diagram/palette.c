/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Colours by lightness, chroma and hue, in the space OKLab (Ottosson, "A perceptual color space for image
 * processing", 2020), in which equal steps look about equal. */
#include "diagram/palette.h"

#include <math.h>

typedef struct {
    double lightness, chroma, hue; /* 0..1; 0..0.3; degrees: 29 red, 110 yellow, 142 green, 264 blue */
} colour;

static double encode(double linear)
{
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}

/* Linear red, green and blue; true where all lie within 0..1. */
static bool convert(colour given, double rgb[3])
{
    double a = given.chroma * cos(given.hue * M_PI / 180), b = given.chroma * sin(given.hue * M_PI / 180);
    double l = given.lightness + 0.3963377774 * a + 0.2158037573 * b;
    double m = given.lightness - 0.1055613458 * a - 0.0638541728 * b;
    double s = given.lightness - 0.0894841775 * a - 1.2914855480 * b;
    l = l * l * l;
    m = m * m * m;
    s = s * s * s;
    rgb[0] = 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s;
    rgb[1] = -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s;
    rgb[2] = -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s;
    bool inside = true;
    for (int i = 0; i < 3; i++) {
        inside = inside && rgb[i] >= 0 && rgb[i] <= 1;
    }
    return inside;
}

/* The colour as sRGB; its chroma shrinks until a screen can show it, lightness and hue stay. */
static duct_ink ink_of(colour wanted)
{
    double rgb[3], low = 0, high = wanted.chroma;
    if (!convert(wanted, rgb)) {
        for (int i = 0; i < 20; i++) {
            wanted.chroma = (low + high) / 2;
            if (convert(wanted, rgb)) {
                low = wanted.chroma;
            } else {
                high = wanted.chroma;
            }
        }
        wanted.chroma = low;
        convert(wanted, rgb);
    }
    float part[3];
    for (int i = 0; i < 3; i++) {
        part[i] = (float)fmin(fmax(encode(fmin(fmax(rgb[i], 0), 1)), 0), 1);
    }
    return (duct_ink){part[0], part[1], part[2], 1};
}

duct_ink duct_palette_ink(duct_diagram_palette palette, double share)
{
    double t = floor(fmin(fmax(share, 0), 1) * (DUCT_PALETTE_STEPS - 1) + 0.5) / (DUCT_PALETTE_STEPS - 1);
    if (palette == DUCT_PALETTE_BLUE_RED) {
        return ink_of((colour){0.45 + 0.13 * t + 0.27 * sin(M_PI * t), 0.26, 264 - 235 * t});
    }
    /* The light end is dark enough for thin lines on white. */
    return ink_of((colour){0.30 + 0.54 * t, 0.12 + 0.06 * t * t, 305 - 212 * t});
}

duct_ink duct_palette_category(size_t index)
{
    static const colour colours[] = {
        {0.45, 0.18, 262}, {0.76, 0.16, 70},  {0.52, 0.13, 150}, {0.72, 0.14, 345}, {0.40, 0.13, 20},
        {0.75, 0.12, 225}, {0.50, 0.20, 315}, {0.80, 0.16, 108}, {0.36, 0.07, 200}, {0.66, 0.20, 38},
    };
    return ink_of(colours[index % (sizeof colours / sizeof *colours)]);
}
