/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Parses the input as the value of a `d` attribute, as a host would through ductus/path.h: the path keeps the
 * promises of duct_path, its own text gives as many nodes again, and its strokes can be fitted and outlined.
 */
#include "fuzz.h"

#include <ductus/ductus.h>

#include <math.h>
#include <string.h>

static size_t check_path(const duct_path *path)
{
    size_t verbs, points, needed = 0;
    const unsigned char *verb = duct_path_verbs(path, &verbs);
    const double *xy = duct_path_points(path, &points);
    for (size_t i = 0; i < verbs; i++) {
        fuzz_require(verb[i] <= DUCT_PATH_CLOSE, "");
        fuzz_require(i > 0 || verb[i] == DUCT_PATH_MOVE, "");
        needed += verb[i] == DUCT_PATH_CUBIC ? 3 : verb[i] == DUCT_PATH_CLOSE ? 0 : 1;
    }
    fuzz_require(needed == points, "");
    for (size_t i = 0; i < 2 * points; i++) {
        fuzz_require(isfinite(xy[i]), "");
    }
    return verbs;
}

static duct_path *new_path(void)
{
    duct_path *path = NULL;
    fuzz_require(duct_path_new(NULL, &path, NULL) == DUCT_OK, "");
    return path;
}

static void read_again(const duct_path *path, size_t verbs)
{
    duct_error error = {DUCT_OK, ""};
    char *text = NULL;
    fuzz_require(duct_path_svg(NULL, path, 6, &text, &error) == DUCT_OK, error.message);
    duct_path *back = new_path();
    fuzz_require(duct_path_add_svg(back, text, &error) == DUCT_OK, error.message);
    fuzz_require(check_path(back) == verbs, text);
    duct_path_free(back);
    duct_memory_free(NULL, text);
}

static void use_stroke(const duct_stroke *stroke, double size)
{
    duct_error error = {DUCT_OK, ""};
    duct_path *fitted = new_path();
    fuzz_require(duct_path_fit(fitted, stroke, size / 100, &error) == DUCT_OK, error.message);
    check_path(fitted);
    duct_path_clear(fitted);
    duct_nib_options nib = duct_nib_options_default();
    nib.width = size / 20;
    nib.fit_tolerance = size / 1000;
    duct_status status = duct_path_outline(fitted, stroke, &nib, &error);
    fuzz_require(status == DUCT_OK || error.message[0] != '\0', error.message);
    check_path(fitted);
    duct_path_free(fitted);
}

/* The larger side of what the path covers. */
static double extent(const duct_path *path)
{
    size_t points;
    const double *xy = duct_path_points(path, &points);
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (size_t i = 0; i < 2 * points; i++) {
        low[i % 2] = fmin(low[i % 2], xy[i]);
        high[i % 2] = fmax(high[i % 2], xy[i]);
    }
    return points > 0 ? fmax(high[0] - low[0], high[1] - low[1]) : 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char *text = malloc(size + 1);
    if (text == NULL) {
        return 0;
    }
    memcpy(text, data, size);
    text[size] = '\0';
    duct_error error = {DUCT_OK, ""};
    duct_path *path = new_path();
    fuzz_require(duct_path_add_svg(path, text, &error) == DUCT_OK, error.message);
    free(text);
    size_t verbs = check_path(path);
    duct_drawing *drawing = NULL;
    fuzz_require(duct_drawing_new(NULL, &drawing, &error) == DUCT_OK, error.message);
    double large = fmax(extent(path), 1e-3);
    duct_status status = duct_path_flatten(path, "p", large / 1000, drawing, &error);
    fuzz_require(status == DUCT_OK || error.message[0] != '\0', error.message);
    if (large < 1e6) {
        read_again(path, verbs);
    }
    /* A few strokes of a few samples: what is made of them has tests and sizes of its own. */
    for (size_t i = 0; status == DUCT_OK && i < 3 && i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        if (duct_stroke_size(stroke) <= 200) {
            use_stroke(stroke, large);
        }
    }
    duct_drawing_free(drawing);
    duct_path_free(path);
    return 0;
}
