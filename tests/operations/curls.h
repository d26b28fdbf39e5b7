/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_CURLS_H
#define DUCTUS_TESTS_CURLS_H

/* A made-up hand and drawings for it, and restyling these by the table's settings. */
#include "testing.h"

#include <ductus/ductus.h>

#include <math.h>

/* A made-up hand: curly strokes whose pressure and twist follow their curvature. */
static inline void add_curl(duct_drawing *drawing, size_t s, double left, double top, double size, bool pose)
{
    duct_error error;
    duct_stroke *stroke;
    char id[16];
    snprintf(id, sizeof id, "s%zu", s);
    size_t count = 40 + 7 * (s % 5);
    assert_ok(duct_drawing_add_stroke(drawing, id, count, &stroke, &error));
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    double *p = pose ? duct_stroke_edit(stroke, DUCT_PRESSURE) : NULL;
    double *tx = pose ? duct_stroke_edit(stroke, DUCT_TILT_X) : NULL,
           *ty = pose ? duct_stroke_edit(stroke, DUCT_TILT_Y) : NULL;
    double *tw = pose ? duct_stroke_edit(stroke, DUCT_TWIST) : NULL;
    double angle = 0.7 * (double)s, at_x = left, at_y = top;
    for (size_t i = 0; i < count; i++) {
        double bend = 0.16 * sin(0.21 * (double)i * (1 + 0.2 * (double)(s % 3)) + (double)s);
        angle += bend;
        at_x += size * cos(angle);
        at_y += size * sin(angle);
        x[i] = at_x;
        y[i] = at_y;
        if (pose) {
            p[i] = 0.5 + 2.5 * bend * sin(3.2 * (double)i / (double)count);
            tx[i] = 0.3 + 0.1 * cos(angle);
            ty[i] = -0.4 + 0.1 * sin(angle);
            tw[i] = 5 + 0.3 * sin(angle);
        }
    }
}

static inline duct_library *make_hand(bool pose)
{
    duct_error error;
    duct_drawing *recording;
    duct_library *library;
    assert_ok(duct_drawing_new(NULL, &recording, &error));
    for (size_t s = 0; s < 30; s++) {
        add_curl(recording, s, 50.0 * (double)(s % 6), 80.0 * (double)(s / 6), 2, pose);
    }
    const duct_drawing *list[] = {recording};
    assert_ok(duct_library_build(NULL, list, 1, NULL, &library, &error));
    duct_drawing_free(recording);
    return library;
}

static inline duct_drawing *make_drawing(size_t strokes, double left, double top, double size)
{
    duct_error error;
    duct_drawing *drawing;
    assert_ok(duct_drawing_new(NULL, &drawing, &error));
    for (size_t s = 0; s < strokes; s++) {
        /* Turned half round, so that the hand has no stroke that is the same. */
        add_curl(drawing, 3 * s + 1, left + 60 * size * (double)s, top, -2.5 * size, false);
    }
    return drawing;
}

/* Runs restyle with pairs of parameter and value, ended by NULL. */
static inline duct_drawing *run(const duct_context *context, const duct_library *hand,
                                const duct_drawing *input, ...)
{
    duct_error error;
    const duct_operation *operation;
    duct_settings *settings;
    duct_drawing *output;
    assert_ok(duct_operation_find("restyle", &operation, &error));
    assert_ok(duct_settings_new(NULL, operation, &settings, &error));
    assert_ok(duct_settings_library(settings, "hand", hand, &error));
    va_list list;
    va_start(list, input);
    for (const char *param = va_arg(list, const char *); param != NULL; param = va_arg(list, const char *)) {
        assert_ok(duct_settings_set(settings, param, va_arg(list, const char *), &error));
    }
    va_end(list);
    assert_ok(duct_operation_run(context, settings, input, NULL, &output, &error));
    duct_settings_free(settings);
    return output;
}

/* A trace's text. */
typedef struct {
    char *text;
    size_t size;
} traced;

static inline bool keep_trace(void *user, const char *text, size_t size)
{
    traced *self = user;
    self->text = realloc(self->text, self->size + size + 1);
    memcpy(self->text + self->size, text, size);
    self->size += size;
    self->text[self->size] = '\0';
    return true;
}

#endif
