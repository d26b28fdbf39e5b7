/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DRAWING_PRIVATE_H
#define DUCTUS_DRAWING_PRIVATE_H

#include "base/memory.h"

#include <ductus/drawing.h>

#include <stdatomic.h>

/* What a drawing remembers of the file it was read from, so that its format can write back unchanged what
 * Ductus does not touch. Shared, immutable and counted: all copies of a drawing hold the same one. */
typedef struct duct_origin duct_origin;
struct duct_origin {
    atomic_size_t references;
    const char *format;                   /* the format's id: only that format may use it */
    void (*destroy)(duct_origin *origin); /* frees it, with the memory of the format's own struct around it */
    int unpainted;                        /* what the file shows beside strokes: duct_unpainted */
};

/* Puts an origin into a drawing, which takes over the caller's reference. */
void duct_drawing_set_origin(duct_drawing *drawing, duct_origin *origin);
/* NULL where there is none. */
const duct_origin *duct_drawing_origin(const duct_drawing *drawing);

/* The stroke's part of the origin: the number that the reader gave it; -1 where it has none. */
long duct_stroke_part(const duct_stroke *stroke);
void duct_stroke_set_part(duct_stroke *stroke, long part);

/* True where the stroke was edited after it was read. Readers call the setter with false at their end. */
bool duct_stroke_changed(const duct_stroke *stroke);
void duct_stroke_set_changed(duct_stroke *stroke, bool changed);

/* Gives a stroke new samples all at once: copies of `values` by channel, NULL for channels that become absent
 * (never X and Y). Errors: DUCT_NO_MEMORY (the stroke is as it was). */
duct_status duct_stroke_replace(duct_stroke *stroke, size_t size, double *const values[DUCT_CHANNEL_COUNT],
                                duct_error *error);

const duct_allocator *duct_drawing_allocator(const duct_drawing *drawing);

#endif
