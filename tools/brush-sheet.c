/* SPDX-License-Identifier: GPL-3.0-or-later */
/* brush-sheet BRUSH OUT.png [WIDTH]: the marks of a brush over one curve, each column varying one input of
 * the pen and nothing else. For looking at while a brush is made, and for docs/brushes.md. */
#include <ductus/ductus.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double pi = 3.14159265358979323846;

enum { COLUMNS = 4, ROWS = 6, SAMPLES = 160 };

static const double cell_width = 230, cell_height = 110;

typedef struct pen {
    double pressure, tilt_x, tilt_y, twist;
} pen;

/* Column 0: pressure; 1: tilt, by direction; 2: twist; 3: all, along the stroke. `u` is 0..1 along the
 * stroke. */
static pen pen_at(int column, int row, double u)
{
    pen p = {0.5, 0, 0, 0};
    double share = (double)row / (ROWS - 1), angle = share * 2 * pi * 5 / 6;
    switch (column) {
    case 0:
        p.pressure = row < 4 ? 0.12 + 0.88 * row / 3 : row == 4 ? u : 0.5 - 0.5 * cos(2 * pi * u);
        break;
    case 1:
        p.tilt_x = 0.9 * cos(angle);
        p.tilt_y = 0.9 * sin(angle);
        break;
    case 2:
        p.twist = row < 5 ? share * pi : u * 2 * pi;
        break;
    default:
        p.pressure = 0.05 + 0.9 * pow(sin(pi * u), 0.7);
        p.tilt_x = 0.8 * sin(2 * pi * u + angle);
        p.tilt_y = 0.6 * cos(2 * pi * u + angle);
        p.twist = 2 * u * (row - 2);
        break;
    }
    return p;
}

static duct_status add_mark(duct_drawing *drawing, int column, int row, double width, duct_error *error)
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
        pen p = pen_at(column, row, u);
        values[DUCT_X][i] = (column + 0.14 + 0.72 * u) * cell_width;
        values[DUCT_Y][i] = (row + 0.5) * cell_height + 0.27 * cell_height * sin(2.2 * pi * u);
        values[DUCT_T][i] = u * 1.2;
        values[DUCT_PRESSURE][i] = p.pressure;
        values[DUCT_TILT_X][i] = p.tilt_x;
        values[DUCT_TILT_Y][i] = p.tilt_y;
        values[DUCT_TWIST][i] = p.twist;
    }
    duct_stroke_set_style(stroke, (duct_stroke_style){0.09f, 0.12f, 0.3f, 1, width});
    return DUCT_OK;
}

static duct_status make_sheet(const char *brush_name, const char *path, double width, duct_error *error)
{
    duct_drawing *drawing = NULL;
    duct_brush *brush = NULL;
    duct_canvas *canvas = NULL;
    duct_status status = duct_drawing_new(NULL, &drawing, error);
    if (status == DUCT_OK) {
        duct_drawing_set_page(drawing, COLUMNS * cell_width, ROWS * cell_height);
        for (int i = 0; status == DUCT_OK && i < COLUMNS * ROWS; i++) {
            status = add_mark(drawing, i % COLUMNS, i / COLUMNS, width, error);
        }
    }
    if (status == DUCT_OK) {
        status = duct_brush_load(NULL, brush_name, &brush, error);
    }
    if (status == DUCT_OK) {
        duct_render_options options = duct_render_options_default();
        options.resolution = 144;
        status = duct_render(NULL, drawing, brush, &options, &canvas, error);
    }
    if (status == DUCT_OK) {
        duct_image_options options = {{1, 1, 1, 1}, 144, 8};
        status = duct_image_write(NULL, canvas, path, &options, error);
    }
    duct_canvas_free(canvas);
    duct_brush_free(brush);
    duct_drawing_free(drawing);
    return status;
}

int main(int count, char **words)
{
    if (count < 3) {
        fprintf(stderr, "usage: brush-sheet BRUSH OUT.png [WIDTH]\n");
        return 2;
    }
    duct_error error = {DUCT_OK, ""};
    duct_status status = make_sheet(words[1], words[2], count > 3 ? strtod(words[3], NULL) : 20, &error);
    if (status != DUCT_OK) {
        fprintf(stderr, "brush-sheet: %s\n", error.message);
    }
    return status == DUCT_OK ? 0 : 1;
}
