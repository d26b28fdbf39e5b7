/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "library/weights.h"

#include "base/number.h"
#include "library/annotations.h"

#include <math.h>

bool duct_weight_valid(double weight)
{
    return weight >= DUCT_WEIGHT_LEAST && weight <= DUCT_WEIGHT_MOST;
}

void duct_weights_print(duct_text *out, const double *weights, size_t count)
{
    for (size_t i = 0; i < count;) {
        size_t end = i + 1;
        while (end < count && weights[end] == weights[i]) {
            end++;
        }
        duct_text_add(out, i > 0 ? " " : "");
        duct_text_add_number(out, weights[i], 0);
        duct_text_addf(out, "*%zu", end - i);
        i = end;
    }
}

/* Reads the runs; false where they are not as many weights as there are strokes. */
static bool scan(const char *text, double *weights, size_t count)
{
    size_t filled = 0;
    while (*text != '\0') {
        double weight, run;
        if (!duct_number_scan(text, &text, &weight) || *text != '*' ||
            !duct_number_scan(text + 1, &text, &run) || !duct_weight_valid(weight) ||
            !(run >= 1 && run <= (double)(count - filled) && run == floor(run)) ||
            (*text != '\0' && *text != ' ')) {
            return false;
        }
        for (size_t end = filled + (size_t)run; filled < end; filled++) {
            weights[filled] = weight;
        }
        text += *text == ' ';
    }
    return filled == count;
}

bool duct_weights_read(const duct_drawing *recording, double *weights)
{
    const char *text = duct_drawing_annotation(recording, DUCT_ANNOTATION_WEIGHTS);
    size_t count = duct_drawing_stroke_count(recording);
    bool stated = text != NULL && scan(text, weights, count), any = false;
    for (size_t i = 0; i < count; i++) {
        weights[i] = stated ? weights[i] : 1;
        any = any || weights[i] != 1;
    }
    return any;
}
