/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DRAWING_H
#define DUCTUS_DRAWING_H

#include <ductus/context.h>
#include <ductus/status.h>
#include <ductus/stroke.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A drawing: an ordered list of strokes (in time order where that is known) on a page.
 *
 * A drawing that was read from a file remembers its source, so that writing the same format gives back
 * unchanged whatever Ductus does not touch. Copies share that memory. */
typedef struct duct_drawing duct_drawing;

/* Limits that every reader keeps, so that a hostile file ends in a sentence and not in an exhausted machine.
 */
enum {
    DUCT_MAX_FILE_BYTES = 1 << 29, /* 512 MiB */
    DUCT_MAX_STROKES = 1 << 22,    /* about four million strokes in a drawing */
    DUCT_MAX_SAMPLES = 1 << 26,    /* about 67 million samples in a drawing */
    DUCT_MAX_GROUP_DEPTH = 256     /* nested groups */
};

/* An empty drawing on a page of 0 x 0. The caller frees it with duct_drawing_free(). Errors: DUCT_NO_MEMORY.
 */
DUCT_API duct_status duct_drawing_new(const duct_context *context, duct_drawing **drawing, duct_error *error);

/* NULL is allowed. */
DUCT_API void duct_drawing_free(duct_drawing *drawing);

/* An equal drawing that shares nothing which can change. The caller frees it. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_drawing_copy(const duct_context *context, const duct_drawing *drawing,
                                       duct_drawing **copy, duct_error *error);

/* An empty drawing with the page, annotations and source of `drawing`, to be filled with its strokes'
 * results. The caller frees it. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_drawing_like(const duct_context *context, const duct_drawing *drawing,
                                       duct_drawing **empty, duct_error *error);

/* The page in drawing pixels; its upper left corner is (0, 0). 0 x 0 where the source has no page. */
DUCT_API double duct_drawing_width(const duct_drawing *drawing);
DUCT_API double duct_drawing_height(const duct_drawing *drawing);
DUCT_API void duct_drawing_set_page(duct_drawing *drawing, double width, double height);

/* Drawing pixels an inch: 96 unless the source says otherwise. */
DUCT_API double duct_drawing_resolution(const duct_drawing *drawing);
DUCT_API void duct_drawing_set_resolution(duct_drawing *drawing, double pixels_per_inch);

DUCT_API size_t duct_drawing_stroke_count(const duct_drawing *drawing);

/* Stroke `index`, 0 <= index < count; NULL outside. Owned by the drawing; valid until it is freed. */
DUCT_API const duct_stroke *duct_drawing_stroke(const duct_drawing *drawing, size_t index);

/* The same for editing; the stroke counts as changed from then on. */
DUCT_API duct_stroke *duct_drawing_edit_stroke(duct_drawing *drawing, size_t index);

/* Appends a stroke of `size` samples, all at (0, 0), black, opaque, width 0, open. Errors: DUCT_NO_MEMORY,
 * DUCT_LIMIT. */
DUCT_API duct_status duct_drawing_add_stroke(duct_drawing *drawing, const char *id, size_t size,
                                             duct_stroke **stroke, duct_error *error);

/* Appends an equal copy of a stroke of this or another drawing. A copy of a stroke that is unchanged since it
 * was read stays unchanged. `copy` may be NULL. Errors: DUCT_NO_MEMORY, DUCT_LIMIT. */
DUCT_API duct_status duct_drawing_add_copy(duct_drawing *drawing, const duct_stroke *stroke,
                                           duct_stroke **copy, duct_error *error);

/* Facts about the whole drawing as text, e.g. "artist", "licence", "device". NULL where there is none. */
DUCT_API const char *duct_drawing_annotation(const duct_drawing *drawing, const char *key);

/* Sets an annotation; NULL removes it. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_drawing_annotate(duct_drawing *drawing, const char *key, const char *value,
                                           duct_error *error);

/* Walks the annotations in the order they were made: false when `index` is past the last one. */
DUCT_API bool duct_drawing_annotation_at(const duct_drawing *drawing, size_t index, const char **key,
                                         const char **value);

/* True where any stroke has the channel. */
DUCT_API bool duct_drawing_has(const duct_drawing *drawing, duct_channel channel);

/* What a file shows that is no stroke: it stays in the file when that is written in its own format, and is
 * not painted. */
typedef enum duct_unpainted {
    DUCT_UNPAINTED_FILLS = 1,
    DUCT_UNPAINTED_TEXT = 2,
    DUCT_UNPAINTED_IMAGES = 4
} duct_unpainted;

/* The sum of what the file that the drawing was read from shows of these; 0 where there is none. */
DUCT_API int duct_drawing_unpainted(const duct_drawing *drawing);

/* The smallest box around all samples, in drawing pixels. False where there are none (the box is then 0). */
DUCT_API bool duct_drawing_bounds(const duct_drawing *drawing, double box[4] /* x0 y0 x1 y1 */);

#ifdef __cplusplus
}
#endif

#endif
