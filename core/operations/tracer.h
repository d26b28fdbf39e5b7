/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATIONS_TRACER_H
#define DUCTUS_OPERATIONS_TRACER_H

#include "base/json.h"

#include <ductus/operation.h>

#include <pthread.h>

/* Writes the trace of a run stroke by stroke. Workers finish strokes in any order; the tracer hands their
 * texts out in the drawing's order and holds back only what is early, so that a trace is the same on any
 * number of threads and needs little memory. */
typedef struct duct_tracer {
    const duct_allocator *allocator;
    duct_trace trace; /* NULL: nothing is traced */
    void *user;
    pthread_mutex_t lock;
    char **waiting; /* by stroke */
    size_t *waiting_size;
    size_t count, next;
    bool stopped;
} duct_tracer;

void duct_tracer_init(duct_tracer *tracer, const duct_allocator *allocator, duct_trace trace, void *user);
void duct_tracer_free(duct_tracer *tracer);

/* Writes text now, e.g. the head and the tail around all strokes. Errors: DUCT_IO where the user refused. */
duct_status duct_tracer_write(duct_tracer *tracer, const char *text, size_t size, duct_error *error);

/* Prepares for `count` strokes. Errors: DUCT_NO_MEMORY. */
duct_status duct_tracer_expect(duct_tracer *tracer, size_t count, duct_error *error);

/* Takes over a stroke's text (from duct_text_take()); may be called from several threads. */
duct_status duct_tracer_stroke(duct_tracer *tracer, size_t index, char *text, size_t size, duct_error *error);

#endif
