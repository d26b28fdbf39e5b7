/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_FUZZ_H
#define DUCTUS_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

/* What a fuzzer does with one input; libFuzzer gives it its name. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Ends the program, which is how a fuzzer says that it found something, where a promise is broken. */
static inline void fuzz_require(int kept)
{
    if (!kept) {
        abort();
    }
}

#endif
