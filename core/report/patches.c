/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/patches.h"

#include "base/error.h"
#include "base/pool.h"
#include "library/feature_index.h"

#include <math.h>
#include <string.h>

/* The unit tangents of a stroke's samples as x, y pairs. A sample without direction gives 0. */
static void find_tangents(const double *x, const double *y, size_t count, float *tangents)
{
    for (size_t i = 0; i < count; i++) {
        size_t before = i > 0 ? i - 1 : 0, after = i + 1 < count ? i + 1 : i;
        double dx = x[after] - x[before], dy = y[after] - y[before], length = hypot(dx, dy);
        tangents[2 * i] = length > 0 ? (float)(dx / length) : 0;
        tangents[2 * i + 1] = length > 0 ? (float)(dy / length) : 0;
    }
}

/* x- or x+ of section 4.1; neighbouring samples are one unit apart. */
static float closeness(size_t samples, double window)
{
    double share = (double)samples / window;
    return share < 1 ? (float)sqrt(share) : 1.0f;
}

static size_t patches_in(const duct_library *library, size_t stroke, size_t radius)
{
    size_t samples = library->starts[stroke + 1] - library->starts[stroke];
    return samples > 2 * radius ? samples - 2 * radius : 0;
}

static void fill(duct_patches *self, float *tangents)
{
    const duct_library *library = self->library;
    const double window = duct_feature_options_default().reach;
    size_t patch = 0, width = self->dimensions - 2;
    for (size_t s = 0; s < library->stroke_count; s++) {
        size_t start = library->starts[s], samples = library->starts[s + 1] - start;
        size_t here = patches_in(library, s, self->radius);
        self->starts[s] = (uint32_t)patch;
        if (here > 0) {
            find_tangents(library->channels[DUCT_X] + start, library->channels[DUCT_Y] + start, samples,
                          tangents);
        }
        for (size_t k = 0; k < here; k++, patch++) {
            float *row = self->features + patch * self->dimensions;
            size_t centre = k + self->radius;
            memcpy(row, tangents + 2 * k, width * sizeof *row);
            row[width] = closeness(centre, window);
            row[width + 1] = closeness(samples - 1 - centre, window);
            self->centres[patch] = (uint32_t)(start + centre);
            self->strokes[patch] = (uint32_t)s;
        }
    }
    self->starts[library->stroke_count] = (uint32_t)patch;
}

duct_status duct_patches_make(const duct_allocator *allocator, const duct_library *library, size_t radius,
                              duct_patches *patches, duct_error *error)
{
    duct_patches self = {.radius = radius, .dimensions = 2 * (2 * radius + 1) + 2, .library = library};
    size_t longest = 0;
    for (size_t s = 0; s < library->stroke_count; s++) {
        size_t samples = library->starts[s + 1] - library->starts[s];
        longest = samples > longest ? samples : longest;
        self.count += patches_in(library, s, radius);
    }
    float *tangents = duct_alloc(allocator, 2 * longest, sizeof *tangents);
    self.features = duct_alloc(allocator, self.count * self.dimensions, sizeof *self.features);
    self.centres = duct_alloc(allocator, self.count, sizeof *self.centres);
    self.strokes = duct_alloc(allocator, self.count, sizeof *self.strokes);
    self.starts = duct_alloc(allocator, library->stroke_count + 1, sizeof *self.starts);
    duct_status status = DUCT_OK;
    if (tangents == NULL || self.features == NULL || self.centres == NULL || self.strokes == NULL ||
        self.starts == NULL) {
        status = duct_fail_memory(error);
    } else {
        fill(&self, tangents);
        if (self.count > 0) {
            status = duct_search_new(allocator, DUCT_SEARCH_EXACT, self.features, self.count, self.dimensions,
                                     self.starts, &self.search, error);
        }
    }
    duct_release(allocator, tangents);
    if (status != DUCT_OK) {
        duct_patches_free(allocator, &self);
        return status;
    }
    *patches = self;
    return DUCT_OK;
}

void duct_patches_free(const duct_allocator *allocator, duct_patches *patches)
{
    duct_search_free(patches->search);
    duct_release(allocator, patches->features);
    duct_release(allocator, patches->centres);
    duct_release(allocator, patches->strokes);
    duct_release(allocator, patches->starts);
    memset(patches, 0, sizeof *patches);
}

/* Room for the neighbours of one query. */
typedef struct {
    uint32_t *rows;
    float *distances;
    size_t row_capacity, distance_capacity;
} scratch;

typedef struct {
    const duct_allocator *allocator;
    const duct_patches *from, *to;
    uint32_t *partners;
    float *distances;
    scratch *scratch; /* by worker */
} pairing;

static bool make_room(const duct_allocator *allocator, scratch *room, size_t k)
{
    void *rows = room->rows, *distances = room->distances;
    bool good = duct_reserve(allocator, &rows, &room->row_capacity, k, sizeof *room->rows) &&
                duct_reserve(allocator, &distances, &room->distance_capacity, k, sizeof *room->distances);
    room->rows = rows;
    room->distances = distances;
    return good;
}

/* The most similar patch of another stroke, or of the other library. The nearest patches of one's own
 * stroke, its next samples, cannot be left out of the search: so it asks for more until others are among
 * them. */
static duct_status pair_one(pairing *self, scratch *room, size_t patch, uint32_t hint, duct_error *error)
{
    const duct_patches *from = self->from, *to = self->to;
    bool within = from == to;
    uint32_t stroke = from->strokes[patch];
    size_t own = within ? from->starts[stroke + 1] - from->starts[stroke] : 0;
    self->partners[patch] = DUCT_PATCH_NONE;
    for (size_t k = within ? 16 : 1; own < to->count; k *= 4) {
        size_t asked = k < own + 1 ? k : own + 1;
        if (!make_room(self->allocator, room, asked)) {
            return duct_fail_memory(error);
        }
        size_t found =
            duct_search_nearest(to->search, from->features + patch * from->dimensions, asked, &hint,
                                hint != DUCT_PATCH_NONE && hint < to->count, room->rows, room->distances);
        for (size_t i = 0; i < found; i++) {
            if (!within || to->strokes[room->rows[i]] != stroke) {
                self->partners[patch] = room->rows[i];
                self->distances[patch] = room->distances[i];
                return DUCT_OK;
            }
        }
        if (asked == own + 1) {
            break; /* cannot happen: one of them is another stroke's */
        }
    }
    return DUCT_OK;
}

enum { PIECE = 128 }; /* patches a task: neighbours, so that one's partner hints at the next one's */

static duct_status pair_piece(void *arg, size_t worker, size_t index, duct_error *error)
{
    pairing *self = arg;
    size_t begin = index * PIECE, end = begin + PIECE;
    uint32_t hint = DUCT_PATCH_NONE;
    for (size_t i = begin; i < end && i < self->from->count; i++) {
        duct_status status = pair_one(self, &self->scratch[worker], i, hint, error);
        if (status != DUCT_OK) {
            return status;
        }
        hint = self->partners[i] != DUCT_PATCH_NONE ? self->partners[i] + 1 : DUCT_PATCH_NONE;
    }
    return DUCT_OK;
}

duct_status duct_patches_pair(const duct_context *context, const duct_patches *from, const duct_patches *to,
                              double begin, double end, uint32_t *partners, float *distances,
                              duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    size_t pieces = (from->count + PIECE - 1) / PIECE, workers = duct_pool_workers(context, pieces);
    pairing self = {allocator, from, to, partners, distances, NULL};
    self.scratch = duct_alloc(allocator, workers, sizeof *self.scratch);
    if (self.scratch == NULL) {
        return duct_fail_memory(error);
    }
    duct_status status = duct_pool_run(context, pieces, begin, end, pair_piece, &self, error);
    for (size_t i = 0; i < workers; i++) {
        duct_release(allocator, self.scratch[i].rows);
        duct_release(allocator, self.scratch[i].distances);
    }
    duct_release(allocator, self.scratch);
    return status;
}
