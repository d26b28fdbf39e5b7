/* SPDX-License-Identifier: GPL-3.0-or-later */
/* brush-sheet BRUSH OUT.png [WIDTH [DPI]]: the marks of a brush over one curve. Each row varies one input of
 * the pen and nothing else, the last one all of them along the stroke. For looking at while a brush is made,
 * and for docs/brushes.md. */
#include <ductus/ductus.h>

#include "glyphs.h"
#include "motion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

enum { COLUMNS = 6, ROWS = 5, SAMPLES = 160 };

static const double cell_width = 150, cell_height = 82, caption_width = 92;

static const char *const captions[ROWS] = {"pressure", "tilt", "lean", "twist", "all"};

typedef struct pen {
    double pressure, tilt_x, tilt_y, twist;
} pen;

/* Row 0: pressure; 1: how far the pen tilts, to the right and down; 2: where it leans to; 3: twist; 4: all,
 * along the stroke. `u` is 0..1 along the stroke. */
static pen pen_at(int row, int column, double u)
{
    pen p = {0.5, 0, 0, 0};
    const double share = (double)column / (COLUMNS - 1), angle = 2 * pi * column / COLUMNS;
    switch (row) {
    case 0:
        p.pressure = column < 4 ? 0.1 + 0.3 * column : column == 4 ? u : 0.5 - 0.5 * cos(2 * pi * u);
        break;
    case 1:
        p.tilt_x = p.tilt_y = 0.8 * share;
        break;
    case 2:
        p.tilt_x = 0.9 * cos(angle);
        p.tilt_y = 0.9 * sin(angle);
        break;
    case 3:
        p.twist = column < 5 ? share * pi : u * 2 * pi;
        break;
    default:
        p.pressure = 0.05 + 0.9 * pow(sin(pi * u), 0.7);
        p.tilt_x = 0.8 * sin(2 * pi * u + angle);
        p.tilt_y = 0.6 * cos(2 * pi * u + angle);
        p.twist = 2 * u * (column - 2);
        break;
    }
    return p;
}

static duct_status add_mark(duct_drawing *drawing, int row, int column, double width, duct_error *error)
{
    duct_stroke *stroke = NULL;
    char id[32];
    snprintf(id, sizeof id, "mark-%d-%d", column, row);
    duct_status status = duct_drawing_add_stroke(drawing, id, SAMPLES, &stroke, error);
    if (status != DUCT_OK) {
        return status;
    }
    double *values[DUCT_CHANNEL_COUNT];
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        values[c] = duct_stroke_edit(stroke, (duct_channel)c);
        if (values[c] == NULL) {
            return DUCT_NO_MEMORY;
        }
    }
    for (int i = 0; i < SAMPLES; i++) {
        double u = (double)i / (SAMPLES - 1);
        pen p = pen_at(row, column, u);
        values[DUCT_X][i] = caption_width + (column + 0.16 + 0.68 * u) * cell_width;
        values[DUCT_Y][i] = (row + 0.5) * cell_height + 0.24 * cell_height * sin(2.2 * pi * u);
        values[DUCT_T][i] = u * 1.2;
        values[DUCT_PRESSURE][i] = p.pressure;
        values[DUCT_TILT_X][i] = p.tilt_x;
        values[DUCT_TILT_Y][i] = p.tilt_y;
        values[DUCT_TWIST][i] = p.twist;
    }
    duct_stroke_set_style(stroke, (duct_stroke_style){0.09f, 0.12f, 0.3f, 1, width});
    return DUCT_OK;
}

/* A caption's letters, as a calm hand prints them. */
static duct_status write_caption(duct_drawing *drawing, int row, duct_error *error)
{
    static const motor_style calm = {.duration = 0.2,
                                     .reach = 50,
                                     .isochrony = 0.4,
                                     .sigma = 0.22,
                                     .smooth_delay = 0.44,
                                     .corner_delay = 0.7,
                                     .roundness = 1,
                                     .accuracy = 1};
    static trajectory way;
    glyph_place place = {10, (row + 0.5) * cell_height + 5, 9, 0};
    for (const char *c = captions[row]; *c != '\0'; c++) {
        const glyph *letter = alphabet_find(&alphabet_angular, *c);
        for (size_t s = 0; letter != NULL && s < glyph_strokes(letter); s++) {
            action_plan plan = {.count = 0};
            duct_stroke *stroke = NULL;
            glyph_write(letter, s, &place, &plan);
            motion_perform(&calm, &plan, 0, 1, 1, &way);
            duct_status status = duct_drawing_add_stroke(drawing, "", way.size, &stroke, error);
            if (status != DUCT_OK) {
                return status;
            }
            memcpy(duct_stroke_edit(stroke, DUCT_X), way.x, way.size * sizeof *way.x);
            memcpy(duct_stroke_edit(stroke, DUCT_Y), way.y, way.size * sizeof *way.y);
            duct_stroke_set_style(stroke, (duct_stroke_style){0.4f, 0.4f, 0.4f, 1, 1.4});
        }
        place.left += letter != NULL ? place.size * (letter->advance / 100.0 + 0.2) : place.size;
    }
    return DUCT_OK;
}

/* All marks, or all captions, on a page of the sheet's size. */
static duct_status make_page(bool marks, double width, duct_drawing **page, duct_error *error)
{
    duct_status status = duct_drawing_new(NULL, page, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_drawing_set_page(*page, caption_width + COLUMNS * cell_width, ROWS * cell_height);
    for (int row = 0; status == DUCT_OK && row < ROWS; row++) {
        if (!marks) {
            status = write_caption(*page, row, error);
            continue;
        }
        for (int column = 0; status == DUCT_OK && column < COLUMNS; column++) {
            status = add_mark(*page, row, column, width, error);
        }
    }
    return status;
}

/* Paints the strokes of a page on a canvas of its own where there is none yet. */
static duct_status paint_page(const duct_drawing *page, const char *brush_name, double dpi,
                              duct_canvas **canvas, duct_error *error)
{
    duct_brush *brush = NULL;
    duct_status status = duct_brush_load(NULL, brush_name, &brush, error);
    if (status == DUCT_OK && *canvas == NULL) {
        duct_render_options options = duct_render_options_default();
        options.resolution = dpi;
        status = duct_render(NULL, page, brush, &options, canvas, error);
    } else if (status == DUCT_OK) {
        duct_paint_options options = duct_paint_options_default();
        options.scale = dpi / 96;
        for (size_t i = 0; status == DUCT_OK && i < duct_drawing_stroke_count(page); i++) {
            status = duct_canvas_paint(*canvas, brush, duct_drawing_stroke(page, i), &options, error);
        }
    }
    duct_brush_free(brush);
    return status;
}

static duct_status make_sheet(const char *brush_name, const char *path, double width, double dpi,
                              duct_error *error)
{
    duct_drawing *marks = NULL, *words = NULL;
    duct_canvas *canvas = NULL;
    duct_status status = make_page(true, width, &marks, error);
    if (status == DUCT_OK) {
        status = make_page(false, width, &words, error);
    }
    if (status == DUCT_OK) {
        status = paint_page(marks, brush_name, dpi, &canvas, error);
    }
    if (status == DUCT_OK) {
        status = paint_page(words, "ink", dpi, &canvas, error);
    }
    if (status == DUCT_OK) {
        duct_image_options options = {{1, 1, 1, 1}, dpi, 8};
        status = duct_image_write(NULL, canvas, path, &options, error);
    }
    duct_canvas_free(canvas);
    duct_drawing_free(marks);
    duct_drawing_free(words);
    return status;
}

int main(int count, char **words)
{
    if (count < 3) {
        fprintf(stderr, "usage: brush-sheet BRUSH OUT.png [WIDTH [DPI]]\n");
        return 2;
    }
    duct_error error = {DUCT_OK, ""};
    const double width = count > 3 ? strtod(words[3], NULL) : 14,
                 dpi = count > 4 ? strtod(words[4], NULL) : 96;
    duct_status status = make_sheet(words[1], words[2], width, dpi, &error);
    if (status != DUCT_OK) {
        fprintf(stderr, "brush-sheet: %s\n", error.message);
    }
    return status == DUCT_OK ? 0 : 1;
}
