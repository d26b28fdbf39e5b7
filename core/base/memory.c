/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/memory.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void *system_allocate(void *user, size_t size)
{
    (void)user;
    return malloc(size);
}

static void *system_reallocate(void *user, void *memory, size_t size)
{
    (void)user;
    return realloc(memory, size);
}

static void system_release(void *user, void *memory)
{
    (void)user;
    free(memory);
}

static const duct_allocator system_allocator = {system_allocate, system_reallocate, system_release, NULL};

duct_context duct_context_default(void)
{
    duct_context context = {NULL, 0, NULL, NULL, NULL};
    return context;
}

const duct_allocator *duct_allocator_of(const duct_context *context)
{
    return context != NULL && context->allocator != NULL ? context->allocator : &system_allocator;
}

void *duct_alloc_raw(const duct_allocator *allocator, size_t count, size_t size)
{
    if (size != 0 && count > SIZE_MAX / 2 / size) {
        return NULL;
    }
    size_t bytes = count * size;
    return allocator->allocate(allocator->user, bytes > 0 ? bytes : 1);
}

void *duct_alloc(const duct_allocator *allocator, size_t count, size_t size)
{
    void *memory = duct_alloc_raw(allocator, count, size);
    if (memory != NULL) {
        memset(memory, 0, count * size);
    }
    return memory;
}

void *duct_realloc(const duct_allocator *allocator, void *memory, size_t count, size_t size)
{
    if (size != 0 && count > SIZE_MAX / 2 / size) {
        return NULL;
    }
    size_t bytes = count * size;
    return allocator->reallocate(allocator->user, memory, bytes > 0 ? bytes : 1);
}

void duct_release(const duct_allocator *allocator, void *memory)
{
    if (memory != NULL) {
        allocator->release(allocator->user, memory);
    }
}

char *duct_strdup(const duct_allocator *allocator, const char *text)
{
    if (text == NULL) {
        return NULL;
    }
    size_t length = strlen(text);
    char *copy = duct_alloc(allocator, length + 1, 1);
    if (copy != NULL) {
        memcpy(copy, text, length + 1);
    }
    return copy;
}

bool duct_reserve(const duct_allocator *allocator, void **memory, size_t *capacity, size_t needed,
                  size_t size)
{
    if (needed <= *capacity) {
        return true;
    }
    size_t room = *capacity < 8 ? 8 : *capacity;
    while (room < needed) {
        if (room > SIZE_MAX / 4) {
            return false;
        }
        room *= 2;
    }
    void *grown = duct_realloc(allocator, *memory, room, size);
    if (grown == NULL) {
        return false;
    }
    *memory = grown;
    *capacity = room;
    return true;
}

void duct_memory_free(const duct_context *context, void *memory)
{
    duct_release(duct_allocator_of(context), memory);
}
