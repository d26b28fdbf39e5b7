/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads the segments out of a trace; what is read keeps the promises of duct_segment. */
#include "fuzz.h"

#include <ductus/ductus.h>

#include <string.h>

static void read_pass(const uint8_t *data, size_t size, const char *pass)
{
    duct_error error = {DUCT_OK, ""};
    duct_segments *segments = NULL;
    duct_status status =
        duct_segments_read_memory(NULL, (const char *)data, size, "fuzzed", pass, &segments, &error);
    fuzz_require((status == DUCT_OK) == (segments != NULL), error.message);
    if (segments == NULL) {
        fuzz_require(strncmp(error.message, "fuzzed: ", 8) == 0 && error.message[8] != '\0', error.message);
        return;
    }
    for (size_t i = 0; i < duct_segments_stroke_count(segments); i++) {
        size_t count, samples;
        const duct_segment *all = duct_segments_of(segments, i, &count, &samples);
        fuzz_require(duct_segments_stroke_id(segments, i) != NULL, "");
        for (size_t k = 0; k < count; k++) {
            fuzz_require(all[k].first <= all[k].last && all[k].last < samples, "");
            fuzz_require(k == 0 || all[k].first == all[k - 1].last + 1, "");
        }
    }
    duct_segments_free(segments);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    read_pass(data, size, NULL);
    read_pass(data, size, "trajectory");
    return 0;
}
