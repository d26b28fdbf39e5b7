/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_CLIP_H
#define PLUG_CLIP_H

#include "job.h"

#include <gegl.h>

/* Where a job may paint: inside the selection, and on a new layer only where the active layer's locked alpha
 * and its mask would let paint through. */
struct clip {
    struct {
        GeglBuffer *buffer;
        const Babl *format;
        bool alpha; /* it is the second of two channels that counts */
        int x, y;   /* of the buffer in the image */
    } parts[3];
    int count; /* 0: anywhere */
};

void plug_clip_init(struct clip *clip, const struct job *job);
void plug_clip_done(struct clip *clip);

/* Multiplies `mask` by how much paint each pixel takes, 0..1; `area` is in the pixels of the image times
 * `scale`. */
void plug_clip_apply(const struct clip *clip, const GeglRectangle *area, double scale, float *mask);

#endif
