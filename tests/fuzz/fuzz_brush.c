/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses a brush file and, where it is one, paints a short stroke with it. */
#include "fuzz.h"

#include "brush/brush_private.h"

#include <ductus/ductus.h>

#include <string.h>

static void paint(const duct_brush *brush)
{
    duct_error error = {DUCT_OK, ""};
    duct_canvas *canvas = NULL;
    duct_drawing *drawing = NULL;
    duct_stroke *stroke = NULL;
    if (duct_drawing_new(NULL, &drawing, &error) == DUCT_OK &&
        duct_canvas_new(NULL, 96, 96, &canvas, &error) == DUCT_OK &&
        duct_drawing_add_stroke(drawing, "a", 3, &stroke, &error) == DUCT_OK) {
        static const double x[] = {30, 40, 60}, pressure[] = {0.1, 0.5, 1};
        duct_paint_options options = duct_paint_options_default();
        options.brush_size = 6;
        memcpy(duct_stroke_edit(stroke, DUCT_X), x, sizeof x);
        memcpy(duct_stroke_edit(stroke, DUCT_Y), x, sizeof x);
        memcpy(duct_stroke_edit(stroke, DUCT_PRESSURE), pressure, sizeof pressure);
        fuzz_require(duct_canvas_paint(canvas, brush, stroke, &options, &error) == DUCT_OK, error.message);
    }
    duct_canvas_free(canvas);
    duct_drawing_free(drawing);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const duct_allocator *allocator = duct_allocator_of(NULL);
    duct_brush *brush = duct_alloc(allocator, 1, sizeof *brush);
    char *text = malloc(size + 1);
    if (brush != NULL && text != NULL) {
        duct_error error = {DUCT_OK, ""};
        memcpy(text, data, size);
        text[size] = '\0';
        brush->allocator = allocator;
        if (duct_brush_parse(brush, text, &error) == DUCT_OK) {
            paint(brush);
        } else {
            fuzz_require(error.message[0] != '\0', error.message);
        }
    }
    free(text);
    duct_brush_free(brush);
    return 0;
}
