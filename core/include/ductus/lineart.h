/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LINEART_H
#define DUCTUS_LINEART_H

#include <ductus/drawing.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Strokes out of pixels: the centre lines of what was drawn or scanned, as a pen might have drawn them.
 *
 * Paper is told from ink, lines are thinned to their middle, and at junctions a stroke goes on in the
 * straightest way. Lines of text come from the top down, what hangs together from left to right, and in it
 * the longest stroke first; a stroke begins at its left or upper end, a closed one at its top, against the
 * clock. docs/lineart.md says how. */

typedef enum duct_ink {
    DUCT_INK_AUTO, /* dark or light, whichever covers less */
    DUCT_INK_DARK,
    DUCT_INK_LIGHT
} duct_ink;

/* Gives `count` rows of the picture from row `y` on: `width` bytes a row, 0 black to 255 white, sRGB-encoded.
 * The rows are asked for three times over, each time from the top down, so that no whole picture has to be
 * held. Return false to stop with DUCT_IO. */
typedef bool (*duct_picture_rows)(void *user, int y, int count, uint8_t *grey);

typedef struct duct_lineart_options {
    duct_ink ink;
    double threshold; /* how dark ink is at least: 0 as the paper, 1 as black; 0: told from the picture */
    double widest;    /* pixels; what is wider is an area and gives no line */
    double shortest;  /* pixels; specks and hairs whose length and width together are less are left out */
} duct_lineart_options;

/* DUCT_INK_AUTO, threshold 0, widest 100, shortest 4. */
DUCT_API duct_lineart_options duct_lineart_options_default(void);

/* Appends the lines of a picture of width x height pixels to the drawing, in pixels: the middle of the upper
 * left pixel is (0.5, 0.5). Each stroke has x and y, the mean width of its line, and an id that follows from
 * its place, so that a change elsewhere in the picture leaves it its id. A picture without lines gives none.
 * `options` may be NULL. Memory is some four bits a pixel and what the lines take. On failure the drawing may
 * have some of them. Errors: DUCT_BAD_ARGUMENT (an option out of range), DUCT_LIMIT (more than 2^30 pixels,
 * or 65536 a side), DUCT_IO, DUCT_NO_MEMORY, DUCT_CANCELLED. */
DUCT_API duct_status duct_lineart_trace(const duct_context *context, int width, int height,
                                        duct_picture_rows rows, void *user,
                                        const duct_lineart_options *options, duct_drawing *drawing,
                                        duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
