/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DIAGRAM_SEGMENTS_H
#define DUCTUS_DIAGRAM_SEGMENTS_H

#include "base/memory.h"

#include <ductus/diagram.h>

typedef struct duct_segmented {
    char *id;
    size_t samples; /* of the pass; 0: the stroke was passed over */
    duct_segment *items;
    size_t count, capacity;
} duct_segmented;

struct duct_segments {
    duct_allocator allocator;
    char *hand;
    size_t *library_samples; /* of each library stroke */
    size_t library_count;
    duct_segmented *strokes;
    size_t count, capacity;
    size_t *numbers;              /* for each stroke: how many segments there are before its first */
    const duct_segmented **by_id; /* the strokes sorted by id, those of one id in order */
};

/* The traced stroke for stroke `index` of a drawing, whose id is `id`: the one at the same place where the
 * ids agree, else the first of that id; NULL where there is none. */
const duct_segmented *duct_segments_find(const duct_segments *segments, size_t index, const char *id);

/* True where the library has as many strokes, of as many samples, as the trace's. */
bool duct_segments_fit(const duct_segments *segments, const duct_library *library);

#endif
