/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_IDS_H
#define DUCTUS_FORMATS_SVG_IDS_H

#include "base/text.h"

#include <stdint.h>

typedef struct duct_svg_id_slot {
    uint64_t hash;   /* 0: free */
    uint64_t number; /* the last number that was put behind this id */
} duct_svg_id_slot;

/* The ids that a document's elements have: a hash table of the ids' hashes alone, since taking two ids for
 * one only costs a number. A failed allocation sets `failed`. */
typedef struct duct_svg_ids {
    const duct_allocator *allocator;
    duct_svg_id_slot *slots;
    size_t count, capacity;
    bool failed;
} duct_svg_ids;

void duct_svg_ids_init(duct_svg_ids *ids, const duct_allocator *allocator);
void duct_svg_ids_free(duct_svg_ids *ids);

/* Takes an id; false where it was taken already. */
bool duct_svg_ids_take(duct_svg_ids *ids, const char *id);

/* Takes and adds, escaped for XML, an id that nobody has: `id` and `suffix`, with a number behind it where
 * needed, and
 * '_' for white space, which ids may not hold. */
void duct_svg_ids_add_new(duct_svg_ids *ids, const char *id, const char *suffix, duct_text *out);

#endif
