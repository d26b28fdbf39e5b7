/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "drawing/drawing_private.h"

#include "base/error.h"
#include "drawing/stroke_private.h"

#include <string.h>

typedef struct {
    char *key;
    char *value;
} annotation;

struct duct_drawing {
    duct_allocator allocator;
    duct_stroke **strokes;
    size_t stroke_count, stroke_capacity;
    size_t sample_count; /* as added; guards the limit only */
    annotation *annotations;
    size_t annotation_count, annotation_capacity;
    double width, height, resolution;
    duct_origin *origin;
};

duct_status duct_drawing_new(const duct_context *context, duct_drawing **drawing, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_drawing *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->resolution = 96;
    *drawing = made;
    return DUCT_OK;
}

void duct_drawing_free(duct_drawing *drawing)
{
    if (drawing == NULL) {
        return;
    }
    const duct_allocator allocator = drawing->allocator;
    for (size_t i = 0; i < drawing->stroke_count; i++) {
        duct_stroke_free(drawing->strokes[i]);
    }
    for (size_t i = 0; i < drawing->annotation_count; i++) {
        duct_release(&allocator, drawing->annotations[i].key);
        duct_release(&allocator, drawing->annotations[i].value);
    }
    duct_drawing_set_origin(drawing, NULL);
    duct_release(&allocator, drawing->strokes);
    duct_release(&allocator, drawing->annotations);
    duct_release(&allocator, drawing);
}

duct_status duct_drawing_like(const duct_context *context, const duct_drawing *drawing, duct_drawing **empty,
                              duct_error *error)
{
    duct_drawing *made;
    duct_status status = duct_drawing_new(context, &made, error);
    if (status != DUCT_OK) {
        return status;
    }
    made->width = drawing->width;
    made->height = drawing->height;
    made->resolution = drawing->resolution;
    for (size_t i = 0; status == DUCT_OK && i < drawing->annotation_count; i++) {
        status =
            duct_drawing_annotate(made, drawing->annotations[i].key, drawing->annotations[i].value, error);
    }
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    if (drawing->origin != NULL) {
        atomic_fetch_add(&drawing->origin->references, 1);
        made->origin = drawing->origin;
    }
    *empty = made;
    return DUCT_OK;
}

duct_status duct_drawing_copy(const duct_context *context, const duct_drawing *drawing, duct_drawing **copy,
                              duct_error *error)
{
    duct_drawing *made;
    duct_status status = duct_drawing_like(context, drawing, &made, error);
    if (status != DUCT_OK) {
        return status;
    }
    for (size_t i = 0; status == DUCT_OK && i < drawing->stroke_count; i++) {
        status = duct_drawing_add_copy(made, drawing->strokes[i], NULL, error);
    }
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    *copy = made;
    return DUCT_OK;
}

double duct_drawing_width(const duct_drawing *drawing)
{
    return drawing->width;
}

double duct_drawing_height(const duct_drawing *drawing)
{
    return drawing->height;
}

void duct_drawing_set_page(duct_drawing *drawing, double width, double height)
{
    drawing->width = width;
    drawing->height = height;
}

double duct_drawing_resolution(const duct_drawing *drawing)
{
    return drawing->resolution;
}

void duct_drawing_set_resolution(duct_drawing *drawing, double pixels_per_inch)
{
    drawing->resolution = pixels_per_inch;
}

size_t duct_drawing_stroke_count(const duct_drawing *drawing)
{
    return drawing->stroke_count;
}

const duct_stroke *duct_drawing_stroke(const duct_drawing *drawing, size_t index)
{
    return index < drawing->stroke_count ? drawing->strokes[index] : NULL;
}

duct_stroke *duct_drawing_edit_stroke(duct_drawing *drawing, size_t index)
{
    if (index >= drawing->stroke_count) {
        return NULL;
    }
    duct_stroke_set_changed(drawing->strokes[index], true);
    return drawing->strokes[index];
}

/* Takes over the stroke, also on failure. */
static duct_status append(duct_drawing *drawing, duct_stroke *stroke, duct_error *error)
{
    size_t size = duct_stroke_size(stroke);
    if (drawing->stroke_count >= DUCT_MAX_STROKES || size > DUCT_MAX_SAMPLES - drawing->sample_count) {
        duct_stroke_free(stroke);
        return duct_fail(error, DUCT_LIMIT,
                         "a drawing may have %d strokes and %d samples at most; split it into several",
                         DUCT_MAX_STROKES, DUCT_MAX_SAMPLES);
    }
    void *strokes = drawing->strokes;
    if (!duct_reserve(&drawing->allocator, &strokes, &drawing->stroke_capacity, drawing->stroke_count + 1,
                      sizeof(duct_stroke *))) {
        duct_stroke_free(stroke);
        return duct_fail_memory(error);
    }
    drawing->strokes = strokes;
    drawing->strokes[drawing->stroke_count++] = stroke;
    drawing->sample_count += size;
    return DUCT_OK;
}

duct_status duct_drawing_add_stroke(duct_drawing *drawing, const char *id, size_t size, duct_stroke **stroke,
                                    duct_error *error)
{
    if (size > DUCT_MAX_SAMPLES) {
        return duct_fail(error, DUCT_LIMIT, "a stroke may have %d samples at most", DUCT_MAX_SAMPLES);
    }
    duct_stroke *made;
    duct_status status = duct_stroke_new(&drawing->allocator, id, size, &made, error);
    if (status == DUCT_OK) {
        status = append(drawing, made, error);
    }
    if (status == DUCT_OK && stroke != NULL) {
        *stroke = made;
    }
    return status;
}

duct_status duct_drawing_add_copy(duct_drawing *drawing, const duct_stroke *stroke, duct_stroke **copy,
                                  duct_error *error)
{
    duct_stroke *made;
    duct_status status = duct_stroke_copy(&drawing->allocator, stroke, &made, error);
    if (status == DUCT_OK) {
        status = append(drawing, made, error);
    }
    if (status == DUCT_OK && copy != NULL) {
        *copy = made;
    }
    return status;
}

static annotation *find_annotation(const duct_drawing *drawing, const char *key)
{
    for (size_t i = 0; i < drawing->annotation_count; i++) {
        if (strcmp(drawing->annotations[i].key, key) == 0) {
            return &drawing->annotations[i];
        }
    }
    return NULL;
}

const char *duct_drawing_annotation(const duct_drawing *drawing, const char *key)
{
    const annotation *found = find_annotation(drawing, key);
    return found != NULL ? found->value : NULL;
}

duct_status duct_drawing_annotate(duct_drawing *drawing, const char *key, const char *value,
                                  duct_error *error)
{
    annotation *found = find_annotation(drawing, key);
    if (value == NULL) {
        if (found != NULL) {
            duct_release(&drawing->allocator, found->key);
            duct_release(&drawing->allocator, found->value);
            size_t behind = (size_t)(drawing->annotations + drawing->annotation_count - found) - 1;
            memmove(found, found + 1, behind * sizeof *found);
            drawing->annotation_count--;
        }
        return DUCT_OK;
    }
    char *text = duct_strdup(&drawing->allocator, value);
    if (text == NULL) {
        return duct_fail_memory(error);
    }
    if (found != NULL) {
        duct_release(&drawing->allocator, found->value);
        found->value = text;
        return DUCT_OK;
    }
    char *name = duct_strdup(&drawing->allocator, key);
    void *annotations = drawing->annotations;
    bool room = duct_reserve(&drawing->allocator, &annotations, &drawing->annotation_capacity,
                             drawing->annotation_count + 1, sizeof(annotation));
    drawing->annotations = annotations;
    if (name == NULL || !room) {
        duct_release(&drawing->allocator, name);
        duct_release(&drawing->allocator, text);
        return duct_fail_memory(error);
    }
    drawing->annotations[drawing->annotation_count++] = (annotation){name, text};
    return DUCT_OK;
}

bool duct_drawing_annotation_at(const duct_drawing *drawing, size_t index, const char **key,
                                const char **value)
{
    if (index >= drawing->annotation_count) {
        return false;
    }
    *key = drawing->annotations[index].key;
    *value = drawing->annotations[index].value;
    return true;
}

bool duct_drawing_has(const duct_drawing *drawing, duct_channel channel)
{
    for (size_t i = 0; i < drawing->stroke_count; i++) {
        if (duct_stroke_values(drawing->strokes[i], channel) != NULL) {
            return true;
        }
    }
    return false;
}

bool duct_drawing_bounds(const duct_drawing *drawing, double box[4])
{
    bool any = false;
    memset(box, 0, 4 * sizeof *box);
    for (size_t i = 0; i < drawing->stroke_count; i++) {
        const double *x = duct_stroke_values(drawing->strokes[i], DUCT_X);
        const double *y = duct_stroke_values(drawing->strokes[i], DUCT_Y);
        size_t size = duct_stroke_size(drawing->strokes[i]);
        for (size_t k = 0; k < size; k++) {
            if (!any) {
                box[0] = box[2] = x[k];
                box[1] = box[3] = y[k];
                any = true;
            }
            box[0] = x[k] < box[0] ? x[k] : box[0];
            box[1] = y[k] < box[1] ? y[k] : box[1];
            box[2] = x[k] > box[2] ? x[k] : box[2];
            box[3] = y[k] > box[3] ? y[k] : box[3];
        }
    }
    return any;
}

void duct_drawing_set_origin(duct_drawing *drawing, duct_origin *origin)
{
    duct_origin *old = drawing->origin;
    drawing->origin = origin;
    if (old != NULL && atomic_fetch_sub(&old->references, 1) == 1) {
        old->destroy(old);
    }
}

const duct_origin *duct_drawing_origin(const duct_drawing *drawing)
{
    return drawing->origin;
}

int duct_drawing_unpainted(const duct_drawing *drawing)
{
    return drawing->origin != NULL ? drawing->origin->unpainted : 0;
}

const duct_allocator *duct_drawing_allocator(const duct_drawing *drawing)
{
    return &drawing->allocator;
}
