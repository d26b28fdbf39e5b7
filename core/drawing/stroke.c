/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawing/drawing_private.h"

#include "base/error.h"
#include "drawing/stroke_private.h"

#include <string.h>

struct duct_stroke {
    duct_allocator allocator;
    char *id;
    char *group;
    size_t size;
    double *channels[DUCT_CHANNEL_COUNT]; /* NULL: absent */
    duct_stroke_style style;
    long part;
    bool closed;
    bool changed;
};

const char *duct_channel_name(duct_channel channel)
{
    static const char *const names[DUCT_CHANNEL_COUNT] = {"x",      "y",      "time", "pressure",
                                                          "tilt_x", "tilt_y", "twist"};
    return (unsigned)channel < DUCT_CHANNEL_COUNT ? names[channel] : "unknown";
}

duct_status duct_stroke_new(const duct_allocator *allocator, const char *id, size_t size,
                            duct_stroke **stroke, duct_error *error)
{
    duct_stroke *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->style.opacity = 1;
    made->part = -1;
    made->changed = true;
    made->id = duct_strdup(allocator, id != NULL ? id : "");
    made->group = duct_strdup(allocator, "");
    made->channels[DUCT_X] = duct_alloc(allocator, size, sizeof(double));
    made->channels[DUCT_Y] = duct_alloc(allocator, size, sizeof(double));
    made->size = size;
    if (made->id == NULL || made->group == NULL || made->channels[DUCT_X] == NULL ||
        made->channels[DUCT_Y] == NULL) {
        duct_stroke_free(made);
        return duct_fail_memory(error);
    }
    *stroke = made;
    return DUCT_OK;
}

duct_status duct_stroke_copy(const duct_allocator *allocator, const duct_stroke *stroke, duct_stroke **copy,
                             duct_error *error)
{
    duct_stroke *made;
    duct_status status = duct_stroke_new(allocator, stroke->id, stroke->size, &made, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = duct_stroke_set_group(made, stroke->group, error);
    for (int c = 0; status == DUCT_OK && c < DUCT_CHANNEL_COUNT; c++) {
        if (stroke->channels[c] == NULL) {
            continue;
        }
        double *values = duct_stroke_edit(made, (duct_channel)c);
        if (values == NULL) {
            status = duct_fail_memory(error);
        } else {
            memcpy(values, stroke->channels[c], stroke->size * sizeof *values);
        }
    }
    if (status != DUCT_OK) {
        duct_stroke_free(made);
        return status;
    }
    made->style = stroke->style;
    made->part = stroke->part;
    made->closed = stroke->closed;
    made->changed = stroke->changed;
    *copy = made;
    return DUCT_OK;
}

void duct_stroke_free(duct_stroke *stroke)
{
    if (stroke == NULL) {
        return;
    }
    const duct_allocator allocator = stroke->allocator;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(&allocator, stroke->channels[c]);
    }
    duct_release(&allocator, stroke->id);
    duct_release(&allocator, stroke->group);
    duct_release(&allocator, stroke);
}

size_t duct_stroke_size(const duct_stroke *stroke)
{
    return stroke->size;
}

const double *duct_stroke_values(const duct_stroke *stroke, duct_channel channel)
{
    return (unsigned)channel < DUCT_CHANNEL_COUNT ? stroke->channels[channel] : NULL;
}

double *duct_stroke_edit(duct_stroke *stroke, duct_channel channel)
{
    if ((unsigned)channel >= DUCT_CHANNEL_COUNT) {
        return NULL;
    }
    stroke->changed = true;
    if (stroke->channels[channel] == NULL) {
        stroke->channels[channel] = duct_alloc(&stroke->allocator, stroke->size, sizeof(double));
    }
    return stroke->channels[channel];
}

void duct_stroke_drop(duct_stroke *stroke, duct_channel channel)
{
    if (channel == DUCT_X || channel == DUCT_Y || (unsigned)channel >= DUCT_CHANNEL_COUNT) {
        return;
    }
    stroke->changed = true;
    duct_release(&stroke->allocator, stroke->channels[channel]);
    stroke->channels[channel] = NULL;
}

duct_status duct_stroke_resize(duct_stroke *stroke, size_t size, duct_error *error)
{
    if (size > DUCT_MAX_SAMPLES) {
        return duct_fail(error, DUCT_LIMIT, "a stroke may have %d samples at most", DUCT_MAX_SAMPLES);
    }
    double *resized[DUCT_CHANNEL_COUNT] = {NULL};
    size_t kept = size < stroke->size ? size : stroke->size;
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        if (stroke->channels[c] == NULL) {
            continue;
        }
        resized[c] = duct_alloc(&stroke->allocator, size, sizeof(double));
        if (resized[c] == NULL) {
            for (int made = 0; made < c; made++) {
                duct_release(&stroke->allocator, resized[made]);
            }
            return duct_fail_memory(error);
        }
        memcpy(resized[c], stroke->channels[c], kept * sizeof(double));
    }
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(&stroke->allocator, stroke->channels[c]);
        stroke->channels[c] = resized[c];
    }
    stroke->size = size;
    stroke->changed = true;
    return DUCT_OK;
}

duct_status duct_stroke_replace(duct_stroke *stroke, size_t size, double *const values[DUCT_CHANNEL_COUNT],
                                duct_error *error)
{
    double *copies[DUCT_CHANNEL_COUNT] = {NULL};
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        if (values[c] == NULL) {
            continue;
        }
        copies[c] = duct_alloc(&stroke->allocator, size, sizeof(double));
        if (copies[c] == NULL) {
            for (int made = 0; made < c; made++) {
                duct_release(&stroke->allocator, copies[made]);
            }
            return duct_fail_memory(error);
        }
        memcpy(copies[c], values[c], size * sizeof(double));
    }
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        duct_release(&stroke->allocator, stroke->channels[c]);
        stroke->channels[c] = copies[c];
    }
    stroke->size = size;
    stroke->changed = true;
    return DUCT_OK;
}

static duct_status replace_text(duct_stroke *stroke, char **field, const char *text, duct_error *error)
{
    char *copy = duct_strdup(&stroke->allocator, text != NULL ? text : "");
    if (copy == NULL) {
        return duct_fail_memory(error);
    }
    duct_release(&stroke->allocator, *field);
    *field = copy;
    return DUCT_OK;
}

const char *duct_stroke_id(const duct_stroke *stroke)
{
    return stroke->id;
}

duct_status duct_stroke_set_id(duct_stroke *stroke, const char *id, duct_error *error)
{
    return replace_text(stroke, &stroke->id, id, error);
}

const char *duct_stroke_group(const duct_stroke *stroke)
{
    return stroke->group;
}

duct_status duct_stroke_set_group(duct_stroke *stroke, const char *group, duct_error *error)
{
    return replace_text(stroke, &stroke->group, group, error);
}

duct_stroke_style duct_stroke_get_style(const duct_stroke *stroke)
{
    return stroke->style;
}

void duct_stroke_set_style(duct_stroke *stroke, duct_stroke_style style)
{
    stroke->style = style;
    stroke->changed = true;
}

bool duct_stroke_closed(const duct_stroke *stroke)
{
    return stroke->closed;
}

void duct_stroke_set_closed(duct_stroke *stroke, bool closed)
{
    stroke->closed = closed;
    stroke->changed = true;
}

long duct_stroke_part(const duct_stroke *stroke)
{
    return stroke->part;
}

void duct_stroke_set_part(duct_stroke *stroke, long part)
{
    stroke->part = part;
}

bool duct_stroke_changed(const duct_stroke *stroke)
{
    return stroke->changed;
}

void duct_stroke_set_changed(duct_stroke *stroke, bool changed)
{
    stroke->changed = changed;
}
