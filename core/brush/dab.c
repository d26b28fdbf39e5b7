/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/dab.h"

#include <math.h>

/* A dab's opacity at the relative distance r from its middle is, with q = r^2 and hardness h (libmypaint),
 *   1 - q (1/h - 1)         for q <= h,
 *   (1 - q) h / (1 - h)     for h < q <= 1,
 * and 0 outside. Averaging it over the width of a pixel, along the gradient of r, needs its integral. */
typedef struct profile {
    float knee;         /* sqrt(h) */
    float slope;        /* 1/h - 1 */
    float rim;          /* h / (1 - h); 0 for a hard dab */
    float at_knee, all; /* the integral up to the knee, and up to 1 */
} profile;

static profile profile_of(double hardness)
{
    double h = hardness > 0.995 ? 1 : hardness < 0.01 ? 0.01 : hardness;
    double knee = sqrt(h), slope = 1 / h - 1, rim = h < 1 ? h / (1 - h) : 0;
    double at_knee = knee - slope * knee * knee * knee / 3;
    double all = at_knee + rim * (2.0 / 3 - knee + knee * knee * knee / 3);
    return (profile){(float)knee, (float)slope, (float)rim, (float)at_knee, (float)all};
}

static inline float integral_from_middle(const profile *p, float r)
{
    if (r >= 1) {
        return p->all;
    }
    float cube = r * r * r * (1.0f / 3);
    if (r <= p->knee) {
        return r - p->slope * cube;
    }
    float k = p->knee;
    return p->at_knee + p->rim * (r - cube - k + k * k * k * (1.0f / 3));
}

static inline float integral(const profile *p, float r)
{
    return r < 0 ? -integral_from_middle(p, -r) : integral_from_middle(p, r);
}

typedef struct shape {
    int left, top;          /* of the box that holds the dab */
    float x, y;             /* middle, from the box's corner, where floats are exact enough */
    float cosine, sine;     /* of the long axis */
    float scale_u, scale_v; /* 1 / half axes */
    float opacity;
    profile profile;
    uint32_t colour[3], target; /* 15-bit */
    bool wash;
} shape;

/* The opacity of the pixel whose middle lies at (dx, dy) from the dab's. */
static inline float pixel_opacity(const shape *s, float dx, float dy)
{
    float u = (dx * s->cosine + dy * s->sine) * s->scale_u;
    float v = (dy * s->cosine - dx * s->sine) * s->scale_v;
    float r = sqrtf(u * u + v * v);
    float width; /* how much r changes over a pixel */
    if (r > 1e-6f) {
        float gu = u * s->scale_u, gv = v * s->scale_v;
        width = sqrtf(gu * gu + gv * gv) / r;
    } else {
        width = s->scale_u;
    }
    float inner = r - 0.5f * width;
    if (inner >= 1) {
        return 0;
    }
    return s->opacity * (integral(&s->profile, r + 0.5f * width) - integral(&s->profile, inner)) / width;
}

static inline void blend(uint16_t *pixel, const shape *s, float opacity)
{
    const uint32_t half = DUCT_FIX_ONE / 2;
    uint32_t over = (uint32_t)(opacity * DUCT_FIX_ONE + 0.5f);
    over = over > DUCT_FIX_ONE ? DUCT_FIX_ONE : over;
    if (s->wash && over <= pixel[3]) {
        return;
    }
    uint32_t rest = s->wash ? 0 : DUCT_FIX_ONE - over;
    over = (over * s->target + half) >> 15;
    for (size_t k = 0; k < 3; k++) {
        pixel[k] = (uint16_t)((over * s->colour[k] + rest * pixel[k] + half) >> 15);
    }
    pixel[3] = (uint16_t)((over * DUCT_FIX_ONE + rest * pixel[3] + half) >> 15);
}

static void paint_in_tile(duct_canvas *canvas, const shape *s, int tx, int ty, const int box[4])
{
    int left = tx * DUCT_TILE_SIZE, top = ty * DUCT_TILE_SIZE;
    int x0 = box[0] > left ? box[0] : left, y0 = box[1] > top ? box[1] : top;
    int x1 = box[2] < left + DUCT_TILE_SIZE - 1 ? box[2] : left + DUCT_TILE_SIZE - 1;
    int y1 = box[3] < top + DUCT_TILE_SIZE - 1 ? box[3] : top + DUCT_TILE_SIZE - 1;
    uint16_t *tile = NULL;
    for (int y = y0; y <= y1; y++) {
        for (int x = x0; x <= x1; x++) {
            float opacity =
                pixel_opacity(s, (float)(x - s->left) + 0.5f - s->x, (float)(y - s->top) + 0.5f - s->y);
            if (opacity * DUCT_FIX_ONE < 0.5f) {
                continue;
            }
            if (tile == NULL) {
                tile = duct_canvas_touch(canvas, tx, ty);
                if (tile == NULL) {
                    return;
                }
            }
            blend(tile + ((size_t)(y - top) * DUCT_TILE_SIZE + (size_t)(x - left)) * 4, s, opacity);
        }
    }
}

static uint32_t fixed(double value)
{
    value = value < 0 ? 0 : value > 1 ? 1 : value;
    return (uint32_t)lround(value * DUCT_FIX_ONE);
}

static int clamp_pixel(double value, int limit)
{
    return value < 0 ? 0 : value > limit ? limit : (int)value;
}

void duct_dab_paint(duct_canvas *canvas, const duct_dab *dab)
{
    double ratio = dab->ratio > 1 ? dab->ratio : 1;
    if (!(dab->radius > 0.02) || !(dab->opacity > 0) || !(dab->hardness > 0) || !isfinite(dab->x) ||
        !isfinite(dab->y) || !isfinite(ratio) || !isfinite(dab->angle) || dab->radius > 1e5) {
        return;
    }
    /* Axes thinner than about a pixel are painted a pixel wide and paler, which is the same ink. Where dabs
     * do not build up, an ellipse's short axis tells nothing about the line's width, which may run across it.
     */
    const double thin = 0.6;
    double a = dab->radius, b = dab->radius / ratio, opacity = dab->opacity > 1 ? 1 : dab->opacity;
    double thin_a = fmin(a / thin, 1), thin_b = fmin(b / thin, 1);
    opacity *= dab->wash ? thin_a : thin_a * thin_b;
    a = fmax(a, thin);
    b = fmax(b, thin);
    double cosine = cos(dab->angle), sine = sin(dab->angle);
    double half_x = sqrt(a * a * cosine * cosine + b * b * sine * sine) + 1;
    double half_y = sqrt(a * a * sine * sine + b * b * cosine * cosine) + 1;
    double x0 = floor(dab->x - half_x), y0 = floor(dab->y - half_y);
    double x1 = ceil(dab->x + half_x), y1 = ceil(dab->y + half_y);
    if (x1 < 0 || y1 < 0 || x0 >= canvas->width || y0 >= canvas->height) {
        return;
    }
    const int box[4] = {clamp_pixel(x0, canvas->width - 1), clamp_pixel(y0, canvas->height - 1),
                        clamp_pixel(x1, canvas->width - 1), clamp_pixel(y1, canvas->height - 1)};
    const shape s = {box[0],
                     box[1],
                     (float)(dab->x - box[0]),
                     (float)(dab->y - box[1]),
                     (float)cosine,
                     (float)sine,
                     (float)(1 / a),
                     (float)(1 / b),
                     (float)opacity,
                     profile_of(dab->hardness),
                     {fixed(dab->red), fixed(dab->green), fixed(dab->blue)},
                     fixed(dab->target_alpha),
                     dab->wash};
    for (int ty = box[1] / DUCT_TILE_SIZE; ty <= box[3] / DUCT_TILE_SIZE; ty++) {
        for (int tx = box[0] / DUCT_TILE_SIZE; tx <= box[2] / DUCT_TILE_SIZE; tx++) {
            paint_in_tile(canvas, &s, tx, ty, box);
        }
    }
}

void duct_dab_average(const duct_canvas *canvas, double x, double y, double radius, float colour[4])
{
    radius = radius < 1 ? 1 : radius > 2000 ? 2000 : radius;
    int step = radius > 16 ? (int)(radius / 8) : 1;
    double weight = 0, sum[4] = {0, 0, 0, 0};
    int reach = (int)radius + 1;
    int cx = clamp_pixel(x + 1e5, 300000) - 100000, cy = clamp_pixel(y + 1e5, 300000) - 100000;
    for (int dy = -reach / step * step; dy <= reach; dy += step) {
        for (int dx = -reach / step * step; dx <= reach; dx += step) {
            double q = ((double)dx * dx + (double)dy * dy) / (radius * radius);
            if (q >= 1) {
                continue;
            }
            double w = 1 - q; /* the profile of hardness 0.5 */
            weight += w;
            int px = cx + dx, py = cy + dy;
            if (px < 0 || py < 0) {
                continue;
            }
            const uint16_t *tile = duct_canvas_tile(canvas, px / DUCT_TILE_SIZE, py / DUCT_TILE_SIZE);
            if (tile != NULL) {
                const uint16_t *pixel =
                    tile +
                    ((size_t)(py % DUCT_TILE_SIZE) * DUCT_TILE_SIZE + (size_t)(px % DUCT_TILE_SIZE)) * 4;
                for (size_t k = 0; k < 4; k++) {
                    sum[k] += w * pixel[k];
                }
            }
        }
    }
    colour[3] = (float)(sum[3] / weight / DUCT_FIX_ONE);
    for (size_t k = 0; k < 3; k++) {
        /* Under nothing libmypaint answers green, so that a wrong use of the colour is seen. */
        colour[k] = sum[3] > 0 ? (float)fmin(sum[k] / sum[3], 1) : k == 1 ? 1.0f : 0.0f;
    }
}
