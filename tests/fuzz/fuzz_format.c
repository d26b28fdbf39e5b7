/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a drawing in the format DUCTUS_FUZZ_FORMAT, or in whichever the content is taken for. What is read
 * keeps the promises of duct_stroke, and where the format is written too, it is written and read back. */
#include "fuzz.h"

#include <ductus/ductus.h>

#include <math.h>
#include <string.h>

#ifndef DUCTUS_FUZZ_FORMAT
#define DUCTUS_FUZZ_FORMAT "" /* told by the content */
#endif

static const char fuzzed[] = DUCTUS_FUZZ_FORMAT;

static void check_stroke(const duct_stroke *stroke)
{
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        const double *values = duct_stroke_values(stroke, (duct_channel)c);
        for (size_t k = 0; values != NULL && k < duct_stroke_size(stroke); k++) {
            fuzz_require(isfinite(values[k]), "");
            fuzz_require(c != DUCT_PRESSURE || (values[k] >= 0 && values[k] <= 1), "");
            fuzz_require((c != DUCT_TILT_X && c != DUCT_TILT_Y) || fabs(values[k]) <= 1.5708, "");
            fuzz_require(c != DUCT_T || k == 0 || values[k] >= values[k - 1], "");
        }
    }
}

static void check_written(const duct_drawing *drawing, const char *id)
{
    duct_error error = {DUCT_OK, ""};
    char *written = NULL;
    size_t size = 0;
    duct_status status = duct_drawing_write_memory(NULL, drawing, id, NULL, &written, &size, &error);
    fuzz_require(status == DUCT_OK && written[size] == '\0', error.message);
    duct_drawing *back = NULL;
    status = duct_drawing_read_memory(NULL, written, size, "back", id, NULL, &back, &error);
    fuzz_require(status == DUCT_OK, error.message);
    duct_drawing_free(back);
    duct_memory_free(NULL, written);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    duct_error error = {DUCT_OK, ""};
    duct_drawing *drawing = NULL;
    duct_status status = duct_drawing_read_memory(NULL, data, size, "fuzzed", *fuzzed != '\0' ? fuzzed : NULL,
                                                  NULL, &drawing, &error);
    fuzz_require((status == DUCT_OK) == (drawing != NULL), error.message);
    if (drawing == NULL) {
        fuzz_require(strncmp(error.message, "fuzzed: ", 8) == 0 && error.message[8] != '\0', error.message);
        return 0;
    }
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        check_stroke(duct_drawing_stroke(drawing, i));
    }
    const duct_format *format;
    for (size_t f = 0; (format = duct_format_at(f)) != NULL; f++) {
        if (format->writes && strcmp(format->id, fuzzed) == 0) {
            check_written(drawing, fuzzed);
        }
    }
    duct_drawing_free(drawing);
    return 0;
}
