/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The segments of a restyled drawing, read from the trace of its run ("HelpingHand" section 4.2.3, Fig. 6).
 */
#include "diagram/segments.h"

#include "base/error.h"
#include "base/file.h"
#include "diagram/json_walk.h"

#include <stdlib.h>
#include <string.h>

typedef struct reader {
    duct_json_walk walk;
    duct_segments *segments;
    const char *pass;
    duct_segmented found; /* of the pass that is being read */
    bool unchosen;        /* a sample was read for which nothing was chosen */
} reader;

static const char *id_of(const duct_segmented *stroke)
{
    return stroke->id != NULL ? stroke->id : "";
}

static int compare_ids(const void *a, const void *b)
{
    const duct_segmented *first = *(const duct_segmented *const *)a;
    const duct_segmented *second = *(const duct_segmented *const *)b;
    int order = strcmp(id_of(first), id_of(second));
    return order != 0 ? order : (first > second) - (first < second);
}

static bool no_memory(reader *self)
{
    if (self->walk.status == DUCT_OK) {
        self->walk.status = duct_fail_memory(self->walk.error);
    }
    return false;
}

/* A text value; the caller releases it. */
static bool read_text(reader *self, char **text, const char *sentence)
{
    json_object *value;
    if (!duct_walk_value(&self->walk, &value)) {
        return false;
    }
    bool good = json_object_is_type(value, json_type_string);
    char *copy = good ? duct_strdup(&self->segments->allocator, json_object_get_string(value)) : NULL;
    json_object_put(value);
    if (!good) {
        duct_walk_fail(&self->walk, sentence);
        return false;
    }
    if (copy == NULL) {
        return no_memory(self);
    }
    duct_release(&self->segments->allocator, *text);
    *text = copy;
    return true;
}

/* A whole number below `limit`. */
static bool number_of(json_object *value, size_t limit, size_t *number)
{
    if (!json_object_is_type(value, json_type_int)) {
        return false;
    }
    int64_t given = json_object_get_int64(value);
    if (given < 0 || (uint64_t)given >= limit) {
        return false;
    }
    *number = (size_t)given;
    return true;
}

static bool read_library_samples(reader *self)
{
    duct_segments *segments = self->segments;
    json_object *value;
    if (segments->library_samples != NULL) {
        duct_walk_fail(&self->walk, "the library is described twice");
        return false;
    }
    if (!duct_walk_value(&self->walk, &value)) {
        return false;
    }
    bool good = json_object_is_type(value, json_type_array), room = true;
    size_t count = good ? json_object_array_length(value) : 0;
    if (good) {
        segments->library_samples = duct_alloc(&segments->allocator, count, sizeof(size_t));
        room = segments->library_samples != NULL;
        segments->library_count = room ? count : 0;
    }
    for (size_t i = 0; i < segments->library_count && good; i++) {
        good =
            number_of(json_object_array_get_idx(value, i), DUCT_MAX_SAMPLES, &segments->library_samples[i]);
    }
    json_object_put(value);
    if (!good) {
        duct_walk_fail(&self->walk, "\"stroke_samples\" has to be an array of whole numbers");
    }
    return room ? good : no_memory(self);
}

static bool read_library(reader *self)
{
    char key[DUCT_WALK_KEY];
    bool begun = false;
    if (!duct_walk_enter(&self->walk, '{', "\"library\"")) {
        return false;
    }
    while (duct_walk_member(&self->walk, &begun, key)) {
        if (!(strcmp(key, "stroke_samples") == 0 ? read_library_samples(self)
                                                 : duct_walk_skip(&self->walk))) {
            return false;
        }
    }
    return self->walk.status == DUCT_OK;
}

static bool read_settings(reader *self)
{
    char key[DUCT_WALK_KEY];
    bool begun = false;
    if (!duct_walk_enter(&self->walk, '{', "\"settings\"")) {
        return false;
    }
    while (duct_walk_member(&self->walk, &begun, key)) {
        bool good = strcmp(key, "hand") == 0
                        ? read_text(self, &self->segments->hand, "\"hand\" has to be a text")
                        : duct_walk_skip(&self->walk);
        if (!good) {
            return false;
        }
    }
    return self->walk.status == DUCT_OK;
}

/* A sample's chosen place, [stroke, sample, distance]. */
static bool read_chosen(reader *self, size_t *stroke, size_t *sample)
{
    const duct_segments *segments = self->segments;
    json_object *value;
    if (!duct_walk_value(&self->walk, &value)) {
        return false;
    }
    bool good = json_object_is_type(value, json_type_array) && json_object_array_length(value) >= 2 &&
                number_of(json_object_array_get_idx(value, 0), segments->library_count, stroke) &&
                number_of(json_object_array_get_idx(value, 1), segments->library_samples[*stroke], sample);
    json_object_put(value);
    if (!good) {
        duct_walk_fail(&self->walk, "\"chosen\" names a place that the library does not have");
    }
    return good;
}

static bool read_next(reader *self, bool *jump)
{
    json_object *value;
    if (!duct_walk_value(&self->walk, &value)) {
        return false;
    }
    *jump =
        json_object_is_type(value, json_type_string) && strcmp(json_object_get_string(value), "jump") == 0;
    json_object_put(value);
    return true;
}

/* Adds a sample to the segment that goes on, or begins one. */
static bool add_sample(reader *self, size_t stroke, size_t sample, bool jumped)
{
    duct_segmented *found = &self->found;
    duct_segment *last = found->count > 0 ? &found->items[found->count - 1] : NULL;
    if (last == NULL || jumped || last->library_stroke != stroke) {
        void *items = found->items;
        if (!duct_reserve(&self->segments->allocator, &items, &found->capacity, found->count + 1,
                          sizeof *found->items)) {
            return no_memory(self);
        }
        found->items = items;
        found->items[found->count++] = (duct_segment){found->samples, found->samples, stroke, sample, sample};
        return true;
    }
    last->last = found->samples;
    last->begin = sample < last->begin ? sample : last->begin;
    last->end = sample > last->end ? sample : last->end;
    return true;
}

static bool read_sample(reader *self, bool *jumped)
{
    char key[DUCT_WALK_KEY];
    bool begun = false, chosen = false, jump = false;
    size_t stroke = 0, sample = 0;
    if (!duct_walk_enter(&self->walk, '{', "a sample")) {
        return false;
    }
    while (duct_walk_member(&self->walk, &begun, key)) {
        bool good;
        if (strcmp(key, "chosen") == 0) {
            good = read_chosen(self, &stroke, &sample);
            chosen = true;
        } else if (strcmp(key, "next") == 0) {
            good = read_next(self, &jump);
        } else {
            good = duct_walk_skip(&self->walk);
        }
        if (!good) {
            return false;
        }
    }
    if (self->walk.status != DUCT_OK) {
        return false;
    }
    self->unchosen = self->unchosen || !chosen;
    bool good = !chosen || add_sample(self, stroke, sample, *jumped);
    self->found.samples++;
    *jumped = jump || !chosen;
    return good;
}

static bool read_samples(reader *self)
{
    bool begun = false, jumped = true;
    self->found.samples = self->found.count = 0;
    if (!duct_walk_enter(&self->walk, '[', "\"samples\"")) {
        return false;
    }
    while (duct_walk_element(&self->walk, &begun)) {
        if (!read_sample(self, &jumped)) {
            return false;
        }
    }
    return self->walk.status == DUCT_OK;
}

/* Reads a pass; what it holds becomes the stroke's where the pass is wanted. */
static bool read_pass(reader *self, duct_segmented *stroke)
{
    char key[DUCT_WALK_KEY], *name = NULL;
    bool begun = false, good = duct_walk_enter(&self->walk, '{', "a pass");
    self->found.samples = self->found.count = 0;
    while (good && duct_walk_member(&self->walk, &begun, key)) {
        if (strcmp(key, "pass") == 0) {
            good = read_text(self, &name, "\"pass\" has to be a text");
        } else {
            good = strcmp(key, "samples") == 0 ? read_samples(self) : duct_walk_skip(&self->walk);
        }
    }
    good = good && self->walk.status == DUCT_OK;
    if (good && (self->pass == NULL || (name != NULL && strcmp(self->pass, name) == 0))) {
        duct_segmented kept = self->found;
        self->found = (duct_segmented){NULL, 0, stroke->items, 0, stroke->capacity};
        kept.id = stroke->id;
        *stroke = kept;
    }
    duct_release(&self->segments->allocator, name);
    return good;
}

static bool read_passes(reader *self, duct_segmented *stroke)
{
    bool begun = false;
    if (!duct_walk_enter(&self->walk, '[', "\"passes\"")) {
        return false;
    }
    while (duct_walk_element(&self->walk, &begun)) {
        if (!read_pass(self, stroke)) {
            return false;
        }
    }
    return self->walk.status == DUCT_OK;
}

static bool read_stroke(reader *self)
{
    duct_segments *segments = self->segments;
    void *strokes = segments->strokes;
    if (segments->count >= DUCT_MAX_STROKES) {
        duct_walk_fail(&self->walk, "there are too many strokes");
        return false;
    }
    if (!duct_reserve(&segments->allocator, &strokes, &segments->capacity, segments->count + 1,
                      sizeof *segments->strokes)) {
        return no_memory(self);
    }
    segments->strokes = strokes;
    duct_segmented *stroke = &segments->strokes[segments->count++];
    *stroke = (duct_segmented){NULL, 0, NULL, 0, 0};
    char key[DUCT_WALK_KEY];
    bool begun = false;
    if (!duct_walk_enter(&self->walk, '{', "a stroke")) {
        return false;
    }
    while (duct_walk_member(&self->walk, &begun, key)) {
        bool good;
        if (strcmp(key, "id") == 0) {
            good = read_text(self, &stroke->id, "a stroke's \"id\" has to be a text");
        } else {
            good = strcmp(key, "passes") == 0 ? read_passes(self, stroke) : duct_walk_skip(&self->walk);
        }
        if (!good) {
            return false;
        }
    }
    return self->walk.status == DUCT_OK;
}

static bool read_strokes(reader *self)
{
    bool begun = false;
    if (self->segments->library_samples == NULL || self->segments->strokes != NULL) {
        duct_walk_fail(&self->walk,
                       "it is no trace of a restyled drawing: \"strokes\" has to follow \"library\", once");
        return false;
    }
    if (!duct_walk_enter(&self->walk, '[', "\"strokes\"")) {
        return false;
    }
    while (duct_walk_element(&self->walk, &begun)) {
        if (!read_stroke(self)) {
            return false;
        }
    }
    return self->walk.status == DUCT_OK;
}

static duct_status read_trace(reader *self)
{
    duct_json_walk *walk = &self->walk;
    char key[DUCT_WALK_KEY];
    bool begun = false, strokes = false;
    bool good = duct_walk_enter(walk, '{', "a trace");
    while (good && duct_walk_member(walk, &begun, key)) {
        if (strcmp(key, "settings") == 0) {
            good = read_settings(self);
        } else if (strcmp(key, "library") == 0) {
            good = read_library(self);
        } else if (strcmp(key, "strokes") == 0) {
            good = read_strokes(self);
            strokes = true;
        } else {
            good = duct_walk_skip(walk);
        }
    }
    if (walk->status == DUCT_OK && duct_walk_end(walk) && !strokes) {
        duct_walk_fail(walk, "it is no trace of a restyled drawing: it has no \"strokes\"");
    }
    if (walk->status == DUCT_OK && self->unchosen) {
        walk->status =
            duct_fail(walk->error, DUCT_UNSUPPORTED,
                      "has samples for which no place was chosen; segments need a run with --select optimal");
    }
    return walk->status;
}

static duct_status put_in_order(duct_segments *segments, duct_error *error)
{
    segments->by_id = duct_alloc(&segments->allocator, segments->count, sizeof *segments->by_id);
    segments->numbers = duct_alloc(&segments->allocator, segments->count, sizeof *segments->numbers);
    if (segments->by_id == NULL || segments->numbers == NULL) {
        return duct_fail_memory(error);
    }
    size_t before = 0;
    for (size_t i = 0; i < segments->count; i++) {
        segments->by_id[i] = &segments->strokes[i];
        segments->numbers[i] = before;
        before += segments->strokes[i].count;
    }
    if (segments->count > 0) {
        qsort(segments->by_id, segments->count, sizeof *segments->by_id, compare_ids);
    }
    return DUCT_OK;
}

duct_status duct_segments_read_memory(const duct_context *context, const char *text, size_t size,
                                      const char *name, const char *pass, duct_segments **segments,
                                      duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    reader self = {.pass = pass};
    duct_status status = duct_walk_init(&self.walk, text, size, error);
    self.segments = status == DUCT_OK ? duct_alloc(allocator, 1, sizeof *self.segments) : NULL;
    if (self.segments == NULL) {
        duct_walk_done(&self.walk);
        return duct_fail_memory(error);
    }
    self.segments->allocator = *allocator;
    status = read_trace(&self);
    duct_walk_done(&self.walk);
    if (status == DUCT_OK) {
        status = put_in_order(self.segments, error);
    }
    duct_release(allocator, self.found.items);
    if (status != DUCT_OK) {
        if (status != DUCT_NO_MEMORY) {
            duct_error_prefix(error, name);
        }
        duct_segments_free(self.segments);
        return status;
    }
    *segments = self.segments;
    return DUCT_OK;
}

duct_status duct_segments_read(const duct_context *context, const char *path, const char *pass,
                               duct_segments **segments, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    char *text;
    size_t size;
    duct_status status = duct_file_read(allocator, path, DUCT_MAX_FILE_BYTES, &text, &size, error);
    if (status == DUCT_OK) {
        status = duct_segments_read_memory(context, text, size, path, pass, segments, error);
        duct_release(allocator, text);
    }
    return status;
}

void duct_segments_free(duct_segments *segments)
{
    if (segments == NULL) {
        return;
    }
    duct_allocator allocator = segments->allocator;
    for (size_t i = 0; i < segments->count; i++) {
        duct_release(&allocator, segments->strokes[i].id);
        duct_release(&allocator, segments->strokes[i].items);
    }
    duct_release(&allocator, segments->strokes);
    duct_release(&allocator, segments->by_id);
    duct_release(&allocator, segments->numbers);
    duct_release(&allocator, segments->library_samples);
    duct_release(&allocator, segments->hand);
    duct_release(&allocator, segments);
}

const char *duct_segments_hand(const duct_segments *segments)
{
    return segments->hand != NULL ? segments->hand : "";
}

size_t duct_segments_stroke_count(const duct_segments *segments)
{
    return segments->count;
}

const char *duct_segments_stroke_id(const duct_segments *segments, size_t stroke)
{
    return stroke < segments->count ? id_of(&segments->strokes[stroke]) : NULL;
}

const duct_segment *duct_segments_of(const duct_segments *segments, size_t stroke, size_t *count,
                                     size_t *samples)
{
    bool there = stroke < segments->count;
    *count = there ? segments->strokes[stroke].count : 0;
    *samples = there ? segments->strokes[stroke].samples : 0;
    return *count > 0 ? segments->strokes[stroke].items : NULL;
}

const duct_segmented *duct_segments_find(const duct_segments *segments, size_t index, const char *id)
{
    if (index < segments->count && strcmp(id_of(&segments->strokes[index]), id) == 0) {
        return &segments->strokes[index];
    }
    size_t low = 0, high = segments->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (strcmp(id_of(segments->by_id[middle]), id) < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    bool found = low < segments->count && strcmp(id_of(segments->by_id[low]), id) == 0;
    return found ? segments->by_id[low] : NULL;
}

bool duct_segments_fit(const duct_segments *segments, const duct_library *library)
{
    if (duct_library_stroke_count(library) != segments->library_count) {
        return false;
    }
    for (size_t i = 0; i < segments->library_count; i++) {
        if (duct_library_stroke_samples(library, i) != segments->library_samples[i]) {
            return false;
        }
    }
    return true;
}
