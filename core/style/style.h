/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_STYLE_H
#define DUCTUS_STYLE_H

#include "analogy/analogy.h"
#include "analogy/correspondence.h"

#include <ductus/drawing.h>
#include <ductus/library.h>

/* Styles: example curves A and A' in drawings, by name or from files. */

enum { DUCT_STYLE_PASSES = 4 };

/* A style's examples. A curve may be drawn several times over: as A', as A'' ..., each a pass with examples
 * of its own, and each gives an output curve. */
typedef struct duct_style {
    duct_allocator allocator;
    size_t pass_count;
    struct {
        duct_curve_pair *pairs;
        size_t count;
    } passes[DUCT_STYLE_PASSES];
    double scale; /* pixels of the drawing to be styled for one of the style's */
    /* What suits the style, by its drawing's annotations: NAN, or a value. */
    double shape_weight;
    int rotation, join_corners, split_corners; /* -1: it does not say; 0 or 1 */
    double width; /* of the styled lines, in the style's pixels; 0 where it states none */
} duct_style;

/* The built-in styles and the user's own, as duct_library_list() lists hands. Free with duct_hands_free(). */
duct_status duct_style_list(const duct_context *context, duct_hand **styles, size_t *count,
                            duct_error *error);

/* Reads the drawing of a style by name, or any drawing by its path. Errors: DUCT_NOT_FOUND (the sentence
 * lists the styles there are), and those of duct_drawing_read(). */
duct_status duct_style_read(const duct_context *context, const char *name, duct_drawing **drawing,
                            duct_error *error);

/* Which strokes of a style's drawing are A and which are A': by groups (layers) of these names, or by ids
 * that are these names; else by colour where there are two (the first stroke's is A's); else in turns (A, A',
 * A, A' ...). A single stroke is an A' without A. `name` stands in sentences. Errors: DUCT_UNSUPPORTED,
 * DUCT_NO_MEMORY. */
duct_status duct_style_make(const duct_allocator *allocator, const duct_drawing *drawing, const char *name,
                            duct_correspondence how, double scale, duct_style *style, duct_error *error);

/* The same from chosen strokes: `plain` and `styled` of the same number, or `plain` NULL. */
duct_status duct_style_make_of(const duct_allocator *allocator, const duct_stroke *const *plain,
                               const duct_stroke *const *styled, size_t count, duct_correspondence how,
                               double scale, duct_style *style, duct_error *error);

/* Freeing an all-zero style is allowed. */
void duct_style_done(duct_style *style);

/* A stroke as a curve, times `factor`, without repeated points; with its pressure where asked for. It has no
 * points where the stroke has no length. Errors: DUCT_NO_MEMORY. */
duct_status duct_curve_of_stroke(const duct_allocator *allocator, const duct_stroke *stroke, double factor,
                                 bool pressure, duct_curve *curve, duct_error *error);

#endif
