/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "operations/tracer.h"

#include "base/error.h"

#include <string.h>

void duct_tracer_init(duct_tracer *tracer, const duct_allocator *allocator, duct_trace trace, void *user)
{
    memset(tracer, 0, sizeof *tracer);
    tracer->allocator = allocator;
    tracer->trace = trace;
    tracer->user = user;
    pthread_mutex_init(&tracer->lock, NULL);
}

void duct_tracer_free(duct_tracer *tracer)
{
    for (size_t i = 0; tracer->waiting != NULL && i < tracer->count; i++) {
        duct_release(tracer->allocator, tracer->waiting[i]);
    }
    duct_release(tracer->allocator, tracer->waiting);
    duct_release(tracer->allocator, tracer->waiting_size);
    pthread_mutex_destroy(&tracer->lock);
}

duct_status duct_tracer_write(duct_tracer *tracer, const char *text, size_t size, duct_error *error)
{
    if (tracer->trace != NULL && !tracer->stopped && !tracer->trace(tracer->user, text, size)) {
        tracer->stopped = true;
    }
    return tracer->stopped ? duct_fail(error, DUCT_IO, "the trace cannot be written") : DUCT_OK;
}

duct_status duct_tracer_expect(duct_tracer *tracer, size_t count, duct_error *error)
{
    if (tracer->trace == NULL) {
        return DUCT_OK;
    }
    tracer->waiting = duct_alloc(tracer->allocator, count, sizeof *tracer->waiting);
    tracer->waiting_size = duct_alloc(tracer->allocator, count, sizeof *tracer->waiting_size);
    if (tracer->waiting == NULL || tracer->waiting_size == NULL) {
        return duct_fail_memory(error);
    }
    tracer->count = count;
    return DUCT_OK;
}

duct_status duct_tracer_stroke(duct_tracer *tracer, size_t index, char *text, size_t size, duct_error *error)
{
    duct_status status = DUCT_OK;
    pthread_mutex_lock(&tracer->lock);
    tracer->waiting[index] = text;
    tracer->waiting_size[index] = size;
    while (tracer->next < tracer->count && tracer->waiting[tracer->next] != NULL) {
        size_t next = tracer->next++;
        if (next > 0) {
            status = duct_tracer_write(tracer, ",", 1, error);
        }
        if (status == DUCT_OK) {
            status = duct_tracer_write(tracer, tracer->waiting[next], tracer->waiting_size[next], error);
        }
        duct_release(tracer->allocator, tracer->waiting[next]);
        tracer->waiting[next] = NULL;
    }
    pthread_mutex_unlock(&tracer->lock);
    return status;
}
