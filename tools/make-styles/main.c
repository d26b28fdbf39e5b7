/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Draws the built-in styles of curve analogies: make-styles FOLDER writes FOLDER/NAME.inkml, with the groups
 * A, A', A'' ..., and FOLDER/thumbnails/NAME.svg. */
#include "style.h"

#include <ductus/ductus.h>

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { THUMBNAIL_WIDTH = 240, MARGIN = 40 };

void style_add(style_curve *curve, double x, double y, double pressure)
{
    if (curve->count < MOST_SAMPLES) {
        curve->x[curve->count] = x;
        curve->y[curve->count] = y;
        curve->pressure[curve->count++] = pressure;
    }
}

double style_chance(unsigned seed, unsigned number)
{
    return duct_random_uniform(seed, 0, number, 1);
}

double style_noise(unsigned seed, double place)
{
    double floor_of = floor(place), share = place - floor_of;
    uint64_t cell = (uint64_t)((int64_t)floor_of + 1000000);
    double a = 2 * duct_random_uniform(seed, 1, cell, 0) - 1;
    double b = 2 * duct_random_uniform(seed, 1, cell + 1, 0) - 1;
    return a + (b - a) * share * share * (3 - 2 * share);
}

void style_line(style_pair *pair, size_t passes, double x0, double y0, double x1, double y1)
{
    size_t steps = (size_t)hypot(x1 - x0, y1 - y0);
    for (size_t i = 0; i <= steps; i++) {
        double share = (double)i / (double)steps, x = x0 + share * (x1 - x0), y = y0 + share * (y1 - y0);
        style_add(&pair->plain, x, y, 0.5);
        for (size_t p = 0; p < passes; p++) {
            style_add(&pair->styled[p], x, y, 0.5);
        }
    }
    pair->passes = passes;
}

static duct_status add_curve(duct_drawing *drawing, const style_curve *curve, const char *id,
                             const char *group, double down, bool pressure, duct_error *error)
{
    duct_stroke *stroke;
    duct_status status = duct_drawing_add_stroke(drawing, id, curve->count, &stroke, error);
    if (status != DUCT_OK) {
        return status;
    }
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    double *p = pressure ? duct_stroke_edit(stroke, DUCT_PRESSURE) : NULL;
    for (size_t i = 0; i < curve->count; i++) {
        x[i] = MARGIN + round(curve->x[i] * 1000) / 1000;
        y[i] = down + round(curve->y[i] * 1000) / 1000;
        if (p != NULL) {
            p[i] = round(fmin(1, fmax(0, curve->pressure[i])) * 1000) / 1000;
        }
    }
    duct_stroke_set_closed(stroke, curve->closed);
    duct_stroke_style ink = {0, 0, 0, 1, pressure ? 3 : 1};
    duct_stroke_set_style(stroke, ink);
    return duct_stroke_set_group(stroke, group, error);
}

/* The pictures of A' alone, as wide as a button. */
static duct_status write_thumbnail(const char *folder, const style *drawn, const style_pair *pair,
                                   duct_error *error)
{
    char path[4096];
    duct_drawing *drawing;
    duct_status status = duct_drawing_new(NULL, &drawing, error);
    const double shift = pair->plain.closed ? 100 : 0;
    duct_drawing_set_page(drawing, THUMBNAIL_WIDTH, pair->plain.closed ? 280 : 80);
    for (size_t pass = 0; pass < pair->passes && status == DUCT_OK; pass++) {
        style_curve curve = pair->styled[pass];
        size_t shown = 0;
        while (shown < curve.count && (curve.closed || curve.x[shown] < THUMBNAIL_WIDTH - 2 * MARGIN)) {
            curve.x[shown++] += shift - (shift > 0 ? 20 : 0);
        }
        curve.count = shown;
        char id[32];
        snprintf(id, sizeof id, "s%zu", pass);
        status = add_curve(drawing, &curve, id, "", pair->plain.closed ? 140 : 45, drawn->pressure, error);
    }
    snprintf(path, sizeof path, "%s/thumbnails/%s.svg", folder, drawn->name);
    if (status == DUCT_OK) {
        status = duct_drawing_write(NULL, drawing, path, NULL, error);
    }
    duct_drawing_free(drawing);
    return status;
}

static duct_status annotate(duct_drawing *drawing, const style *drawn, duct_error *error)
{
    const char *const facts[][2] = {{"title", drawn->label},
                                    {"artist", "a program (synthetic)"},
                                    {"shape-weight", drawn->shape_weight},
                                    {"invariance", drawn->invariance},
                                    {"join-corners", drawn->join_corners},
                                    {"split-corners", drawn->split_corners}};
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < sizeof facts / sizeof facts[0] && status == DUCT_OK; i++) {
        status = duct_drawing_annotate(drawing, facts[i][0], facts[i][1], error);
    }
    return status;
}

static duct_status make_style(const char *folder, const style *drawn, duct_error *error)
{
    static style_pair pair;
    char path[4096], id[32], group[8];
    duct_drawing *drawing;
    duct_status status = duct_drawing_new(NULL, &drawing, error);
    double down = 60;
    if (status == DUCT_OK) {
        status = annotate(drawing, drawn, error);
    }
    for (size_t index = 0; status == DUCT_OK && index < MOST_CURVES; index++) {
        memset(&pair, 0, sizeof pair);
        if (!drawn->draw(index, &pair)) {
            break;
        }
        down += pair.plain.closed ? 80 : 0;
        snprintf(id, sizeof id, "plain-%zu", index + 1);
        status = add_curve(drawing, &pair.plain, id, "A", down, false, error);
        for (size_t pass = 0; pass < pair.passes && status == DUCT_OK; pass++) {
            snprintf(id, sizeof id, "styled-%zu-%zu", index + 1, pass + 1);
            snprintf(group, sizeof group, "A%.*s", (int)pass + 1, "''''");
            status = add_curve(drawing, &pair.styled[pass], id, group, down, drawn->pressure, error);
        }
        if (status == DUCT_OK && index == 0) {
            status = write_thumbnail(folder, drawn, &pair, error);
        }
        down += pair.plain.closed ? 140 : 80;
    }
    duct_drawing_set_page(drawing, 520, down);
    snprintf(path, sizeof path, "%s/%s.inkml", folder, drawn->name);
    if (status == DUCT_OK) {
        status = duct_drawing_write(NULL, drawing, path, NULL, error);
    }
    duct_drawing_free(drawing);
    return status;
}

int main(int count, char **words)
{
    const struct {
        const style *list;
        size_t count;
    } all[] = {{styles_lines, styles_lines_count},
               {styles_shapes, styles_shapes_count},
               {styles_pen, styles_pen_count}};
    duct_error error = {DUCT_OK, ""};
    duct_status status = DUCT_OK;
    if (count != 2) {
        fputs("usage: make-styles FOLDER\n", stderr);
        return 2;
    }
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        for (size_t s = 0; s < all[i].count && status == DUCT_OK; s++) {
            status = make_style(words[1], &all[i].list[s], &error);
        }
    }
    if (status != DUCT_OK) {
        fprintf(stderr, "make-styles: %s\n", error.message);
        return 1;
    }
    return 0;
}
