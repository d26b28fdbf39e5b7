/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_RENDER_H
#define DUCTUS_RENDER_H

#include <ductus/drawing.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Painting strokes with the MyPaint brush engine: pressure, tilt and the barrel's rotation all reach the
 * brush. */

/* A brush: a MyPaint brush file (.myb), with an optional "ductus" section that splits its footprint into
 * bristles (docs/brushes.md). Read-only once loaded; may be used from several threads at once. */
typedef struct duct_brush duct_brush;

/* Loads a brush by name (see duct_brush_list) or by the path of a .myb file. The caller frees it.
 * Errors: DUCT_NOT_FOUND (the sentence lists the brushes there are), DUCT_IO, DUCT_BAD_FORMAT. */
DUCT_API duct_status duct_brush_load(const duct_context *context, const char *name_or_path,
                                     duct_brush **brush, duct_error *error);
DUCT_API void duct_brush_free(duct_brush *brush); /* NULL is allowed */
DUCT_API const char *duct_brush_name(const duct_brush *brush);

/* The names of the brushes in the data folder, sorted, each to be freed with duct_memory_free(), as is the
 * list. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_brush_list(const duct_context *context, char ***names, size_t *count,
                                     duct_error *error);

/* A canvas: a sparse surface of 64 x 64 tiles that exist where something was painted. */
typedef struct duct_canvas duct_canvas;

enum { DUCT_TILE_SIZE = 64 };

/* An empty, transparent canvas of 1..65536 pixels a side. The caller frees it. Errors: DUCT_LIMIT,
 * DUCT_NO_MEMORY. */
DUCT_API duct_status duct_canvas_new(const duct_context *context, int width, int height, duct_canvas **canvas,
                                     duct_error *error);
DUCT_API void duct_canvas_free(duct_canvas *canvas); /* NULL is allowed */
DUCT_API int duct_canvas_width(const duct_canvas *canvas);
DUCT_API int duct_canvas_height(const duct_canvas *canvas);

/* The tile in column `tx` and row `ty`: DUCT_TILE_SIZE^2 pixels of red, green, blue, alpha, premultiplied,
 * 15 bit (0..32768 stands for 0..1), row by row; NULL where nothing was painted. Owned by the canvas. */
DUCT_API const uint16_t *duct_canvas_tile(const duct_canvas *canvas, int tx, int ty);

typedef struct duct_paint_options {
    double scale;              /* canvas pixels a drawing pixel */
    double offset_x, offset_y; /* canvas position of the drawing's (0, 0), in canvas pixels */
    double brush_size; /* brush diameter in drawing pixels; 0: each stroke's own width, or the brush's where
                          it has none. It is the width of the marks of Ductus's own brushes at pressure 0.5.
                          No dab gets wider than 2000 canvas pixels */
    uint64_t seed; /* for brushes that draw randomly; each stroke's numbers follow from (seed, stroke id) */
} duct_paint_options;

/* scale 1, no offset, brush_size 0, seed 0. */
DUCT_API duct_paint_options duct_paint_options_default(void);

/* Paints one stroke in its own colour. Missing channels are neutral: pressure 0.5, pen upright, no twist,
 * constant speed. The same stroke gives the same pixels on every run, whatever was painted before elsewhere.
 * Samples that are not finite are passed over, and what lies off the canvas costs nothing. `options` may be
 * NULL. Errors: DUCT_NO_MEMORY (part of the stroke may have been painted), DUCT_BAD_ARGUMENT (a scale that is
 * not positive, or numbers that are not finite). */
DUCT_API duct_status duct_canvas_paint(duct_canvas *canvas, const duct_brush *brush,
                                       const duct_stroke *stroke, const duct_paint_options *options,
                                       duct_error *error);

typedef struct duct_render_options {
    duct_paint_options paint; /* `scale` and the offsets are set from the page and `resolution` */
    double resolution;        /* image pixels an inch; 0: the drawing's own */
    float background[4];      /* red, green, blue, alpha (0..1, sRGB-encoded, not premultiplied) */
} duct_render_options;

/* Resolution 0, seed 0, opaque white. */
DUCT_API duct_render_options duct_render_options_default(void);

/* Paints the whole drawing on a new canvas the size of its page (of its strokes' box and a margin where it
 * has no page). The background is not painted. The caller frees it. Errors: DUCT_LIMIT, DUCT_NO_MEMORY,
 * DUCT_CANCELLED. */
DUCT_API duct_status duct_render(const duct_context *context, const duct_drawing *drawing,
                                 const duct_brush *brush, const duct_render_options *options,
                                 duct_canvas **canvas, duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
