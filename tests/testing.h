/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTING_H
#define DUCTUS_TESTING_H

/* What every unit test includes first: cmocka in the order it wants, and the project's own helpers. */

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <ductus/context.h>
#include <ductus/status.h>

/* Fails with the error's sentence where a call did not return DUCT_OK. */
#define assert_ok(call)                                                              \
    do {                                                                             \
        error = (duct_error){DUCT_OK, ""};                                           \
        duct_status assert_status = (call);                                          \
        if (assert_status != DUCT_OK) {                                              \
            print_error("%s: %s\n", duct_status_text(assert_status), error.message); \
        }                                                                            \
        assert_int_equal(assert_status, DUCT_OK);                                    \
    } while (0)

/* An allocator whose n-th allocation fails (n from 1; 0: none does), and that counts what is still held. */
typedef struct failing_allocator {
    duct_allocator allocator;
    long calls;
    long fails_at;
    long held;
} failing_allocator;

static inline void *failing_allocate(void *user, size_t size)
{
    failing_allocator *self = user;
    if (__atomic_add_fetch(&self->calls, 1, __ATOMIC_SEQ_CST) == self->fails_at) {
        return NULL;
    }
    __atomic_add_fetch(&self->held, 1, __ATOMIC_SEQ_CST);
    return malloc(size);
}

static inline void *failing_reallocate(void *user, void *memory, size_t size)
{
    failing_allocator *self = user;
    if (__atomic_add_fetch(&self->calls, 1, __ATOMIC_SEQ_CST) == self->fails_at) {
        return NULL;
    }
    if (memory == NULL) {
        __atomic_add_fetch(&self->held, 1, __ATOMIC_SEQ_CST);
    }
    return realloc(memory, size);
}

static inline void failing_release(void *user, void *memory)
{
    failing_allocator *self = user;
    __atomic_sub_fetch(&self->held, 1, __ATOMIC_SEQ_CST);
    free(memory);
}

static inline void failing_init(failing_allocator *self, long fails_at)
{
    *self =
        (failing_allocator){{failing_allocate, failing_reallocate, failing_release, self}, 0, fails_at, 0};
}

/* The folder of real recordings ($DUCTUS_DATA, or ../shared/data beside the checkout), or NULL; then the test
 * says so and skips. */
static inline const char *shared_data(void)
{
    static char path[4096];
    const char *given = getenv("DUCTUS_DATA");
    const char *source = getenv("DUCTUS_SOURCE");
    if (given != NULL && *given != '\0') {
        snprintf(path, sizeof path, "%s", given);
    } else {
        snprintf(path, sizeof path, "%s/../shared/data", source != NULL ? source : ".");
    }
    char probe[4200];
    snprintf(probe, sizeof probe, "%s/README.md", path);
    FILE *file = fopen(probe, "r");
    if (file == NULL) {
        print_message("skipped: no real recordings here (set DUCTUS_DATA to their folder)\n");
        return NULL;
    }
    fclose(file);
    return path;
}

#endif
