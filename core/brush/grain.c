/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/grain.h"

#include <math.h>

/* Octaves of gradient noise (Perlin, "Improving Noise", SIGGRAPH 2002), each turned against the one before so
 * that their lattices cannot be seen. The shares are those of the variance. */
enum { OCTAVES = 5 };

static const struct octave {
    double frequency, cosine, sine, share;
} octaves[OCTAVES] = {
    {0.55, 0.9238795325112867, 0.3826834323650898, 0.17},
    {1, 0.7071067811865476, -0.7071067811865476, 0.36},
    {1.9, 0.5225385649, 0.8526131713, 0.27},
    {3.6, 0.2079116908, -0.9781476007, 0.13},
    {7, 0.9781476007, 0.2079116908, 0.07},
};

/* The variance of gradient noise with gradients of length 1. */
static const double noise_variance = 0.0467;

static uint32_t mix(uint64_t key)
{
    key = (key ^ (key >> 30)) * 0xbf58476d1ce4e5b9u;
    key = (key ^ (key >> 27)) * 0x94d049bb133111ebu;
    return (uint32_t)(key >> 32);
}

/* The gradient of a lattice point times the way (dx, dy) from it. */
static double slope(uint64_t column, uint64_t row, uint64_t octave, double dx, double dy)
{
    static const double c = 0.9238795325112867, s = 0.3826834323650898, d = 0.7071067811865476;
    static const double directions[16][2] = {{1, 0},  {c, s},  {d, d},  {s, c},   {0, 1},   {-s, c},
                                             {-d, d}, {-c, s}, {-1, 0}, {-c, -s}, {-d, -d}, {-s, -c},
                                             {0, -1}, {s, -c}, {d, -d}, {c, -s}};
    const double *g = directions[mix(column * 0x9e3779b97f4a7c15u + row * 0xd1b54a32d192ed03u +
                                     octave * 0x8cb92ba72f3d8dd7u) &
                                 15];
    return g[0] * dx + g[1] * dy;
}

static double fade(double t)
{
    return t * t * t * (t * (t * 6 - 15) + 10);
}

static double noise(double x, double y, uint64_t octave)
{
    const double far = 1e15; /* doubles count no cells there */
    x = fmin(fmax(x, -far), far);
    y = fmin(fmax(y, -far), far);
    const double column = floor(x), row = floor(y), dx = x - column, dy = y - row;
    const uint64_t i = (uint64_t)(int64_t)column, j = (uint64_t)(int64_t)row;
    const double u = fade(dx), v = fade(dy);
    const double top = slope(i, j, octave, dx, dy) * (1 - u) + slope(i + 1, j, octave, dx - 1, dy) * u;
    const double below =
        slope(i, j + 1, octave, dx, dy - 1) * (1 - u) + slope(i + 1, j + 1, octave, dx - 1, dy - 1) * u;
    return top * (1 - v) + below * v;
}

/* How much of an octave pixels can show: 0 where its waves are shorter than one and a half, 1 from three. */
static double visible(double frequency, double pixel)
{
    const double t = fmin(fmax((1 / (frequency * pixel) - 1.5) / 1.5, 0), 1);
    return t * t * (3 - 2 * t);
}

double duct_grain_height(double x, double y, double pixel, double *missing)
{
    double height = 0;
    *missing = 0;
    for (uint64_t i = 0; i < OCTAVES; i++) {
        const struct octave *o = &octaves[i];
        const double part = visible(o->frequency, pixel);
        *missing += o->share * (1 - part * part);
        if (part > 0) {
            const double u = (x * o->cosine - y * o->sine) * o->frequency;
            const double v = (x * o->sine + y * o->cosine) * o->frequency;
            height += part * sqrt(o->share / noise_variance) * noise(u, v, i);
        }
    }
    return height;
}

/* With heights that are about normal, a pixel pressed with p is covered by S(a L(p) - b h), S the normal
 * distribution and L its inverse; a makes the mean over all heights p. The logistic function stands for S,
 * 1.702 being the factor between their arguments. */
typedef struct tooth {
    double a, b;
} tooth;

static tooth tooth_of(double depth, double missing)
{
    const double soft = 1 / sqrt(1 + depth * depth * missing);
    return (tooth){sqrt(1 + depth * depth) * soft, 1.702 * depth * soft};
}

static double covered(tooth t, double pressed, double height)
{
    return pressed >= 1 ? 1 : 1 / (1 + pow((1 - pressed) / pressed, t.a) * exp(-t.b * height));
}

static void texture_tile(uint16_t *tile, double left, double top, const duct_grain *grain,
                         const duct_paint_options *options)
{
    const double pixel = 1 / (options->scale * grain->size);
    for (int k = 0; k < DUCT_TILE_PIXELS; k++) {
        uint16_t *p = tile + (size_t)k * 4;
        if (p[3] == 0) {
            continue;
        }
        const double x = left + k % DUCT_TILE_SIZE + 0.5, y = top + k / DUCT_TILE_SIZE + 0.5;
        const double pressed = p[3] / (double)DUCT_FIX_ONE;
        double missing;
        const double height = duct_grain_height((x - options->offset_x) * pixel,
                                                (y - options->offset_y) * pixel, pixel, &missing);
        const double part =
            grain->cover * covered(tooth_of(grain->depth, missing), pressed, height) / pressed;
        for (size_t c = 0; c < 4; c++) {
            p[c] = (uint16_t)fmin(p[c] * part + 0.5, DUCT_FIX_ONE);
        }
    }
}

void duct_grain_apply(duct_canvas *layer, const duct_grain *grain, const duct_paint_options *options)
{
    for (int ty = layer->dirty[1]; ty <= layer->dirty[3]; ty++) {
        for (int tx = layer->dirty[0]; tx <= layer->dirty[2]; tx++) {
            uint16_t *tile = layer->tiles[(size_t)ty * (size_t)layer->columns + (size_t)tx];
            if (tile != NULL) {
                texture_tile(tile, (double)tx * DUCT_TILE_SIZE, (double)ty * DUCT_TILE_SIZE, grain, options);
            }
        }
    }
}
