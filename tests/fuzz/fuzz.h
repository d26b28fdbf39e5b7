/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_TESTS_FUZZ_H
#define DUCTUS_TESTS_FUZZ_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* What a fuzzer does with one input; libFuzzer gives it its name. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Ends the program, which is how a fuzzer says that it found something, where a promise is broken. `sentence`
 * is of the error that may say why. */
#define fuzz_require(promise, sentence) fuzz_check((promise), #promise, sentence, __FILE__, __LINE__)

static inline void fuzz_check(int kept, const char *promise, const char *sentence, const char *file, int line)
{
    if (!kept) {
        fprintf(stderr, "%s:%d: not %s (%s)\n", file, line, promise, sentence);
        abort();
    }
}

#endif
