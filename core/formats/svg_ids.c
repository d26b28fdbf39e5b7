/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_ids.h"

#include "formats/svg_scan.h"

#include <ductus/random.h>

void duct_svg_ids_init(duct_svg_ids *ids, const duct_allocator *allocator)
{
    *ids = (duct_svg_ids){.allocator = allocator};
}

void duct_svg_ids_free(duct_svg_ids *ids)
{
    duct_release(ids->allocator, ids->slots);
    duct_svg_ids_init(ids, ids->allocator);
}

/* The id's slot, or the free one where it belongs. The capacity is a power of two and never full. */
static duct_svg_id_slot *slot_of(const duct_svg_ids *ids, uint64_t hash)
{
    size_t at = (size_t)hash & (ids->capacity - 1);
    while (ids->slots[at].hash != 0 && ids->slots[at].hash != hash) {
        at = (at + 1) & (ids->capacity - 1);
    }
    return &ids->slots[at];
}

static bool grow(duct_svg_ids *ids)
{
    duct_svg_ids larger = *ids;
    larger.capacity = ids->capacity > 0 ? 2 * ids->capacity : 64;
    larger.slots = duct_alloc(ids->allocator, larger.capacity, sizeof *larger.slots);
    if (larger.slots == NULL) {
        ids->failed = true;
        return false;
    }
    for (size_t i = 0; i < ids->capacity; i++) {
        if (ids->slots[i].hash != 0) {
            *slot_of(&larger, ids->slots[i].hash) = ids->slots[i];
        }
    }
    duct_release(ids->allocator, ids->slots);
    *ids = larger;
    return true;
}

/* The slot of an id, which is taken from then on; NULL where there is no memory. */
static duct_svg_id_slot *take(duct_svg_ids *ids, const char *id, bool *was_free)
{
    if (2 * ids->count >= ids->capacity && !grow(ids)) {
        return NULL;
    }
    uint64_t hash = duct_random_id(id);
    hash += hash == 0;
    duct_svg_id_slot *slot = slot_of(ids, hash);
    *was_free = slot->hash == 0;
    ids->count += *was_free;
    slot->hash = hash;
    return slot;
}

bool duct_svg_ids_take(duct_svg_ids *ids, const char *id)
{
    bool was_free = false;
    return take(ids, id, &was_free) != NULL && was_free;
}

/* Puts numbers behind `wanted` until nobody has it. They go on from the last one that was given. */
static void make_new(duct_svg_ids *ids, duct_text *wanted)
{
    bool was_free = false;
    duct_svg_id_slot *slot = take(ids, wanted->data, &was_free);
    uint64_t number = slot != NULL && slot->number > 1 ? slot->number : 1;
    uint64_t hash = slot != NULL ? slot->hash : 0;
    size_t size = wanted->size;
    while (!was_free && !ids->failed && !wanted->failed) {
        wanted->size = size;
        duct_text_addf(wanted, "-%llu", (unsigned long long)++number);
        take(ids, wanted->data, &was_free);
    }
    if (!ids->failed) {
        slot_of(ids, hash)->number = number;
    }
}

void duct_svg_ids_add_new(duct_svg_ids *ids, const char *id, const char *suffix, duct_text *out)
{
    duct_text wanted;
    duct_text_init(&wanted, out->allocator);
    duct_text_add(&wanted, id);
    duct_text_add(&wanted, suffix);
    for (size_t i = 0; i < wanted.size && !wanted.failed; i++) {
        if (duct_is_space(wanted.data[i])) {
            wanted.data[i] = '_';
        }
    }
    if (!wanted.failed) {
        make_new(ids, &wanted);
    }
    out->failed = out->failed || wanted.failed || ids->failed;
    if (!out->failed) {
        duct_text_add_xml(out, wanted.data);
    }
    duct_text_free(&wanted);
}
