/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_transform.h"

#include "base/number.h"

#include <math.h>
#include <string.h>

static const double degree = 3.14159265358979323846 / 180;

/* The numbers in a function's brackets, with CSS's units behind them; -1 where they are malformed. */
static int read_arguments(const char **text, double numbers[6])
{
    static const struct {
        const char *unit;
        double factor;
    } units[] = {{"px", 1}, {"deg", 1}, {"rad", 180 / 3.14159265358979323846}, {"turn", 360}, {"grad", 0.9}};
    const char *s = *text;
    int count = 0;
    duct_skip_space(&s);
    while (*s != ')') {
        const char *end;
        if (count >= 6 || !duct_number_scan(s, &end, &numbers[count]) || !isfinite(numbers[count])) {
            return -1;
        }
        s = end;
        for (size_t i = 0; i < sizeof units / sizeof *units; i++) {
            size_t length = strlen(units[i].unit);
            if (strncmp(s, units[i].unit, length) == 0) {
                numbers[count] *= units[i].factor;
                s += length;
                break;
            }
        }
        count++;
        if (duct_skip_comma(&s) && *s == ')') {
            return -1;
        }
    }
    *text = s + 1;
    return count;
}

static bool rotation(const double *n, int count, duct_affine *map)
{
    double sine = sin(n[0] * degree), cosine = cos(n[0] * degree);
    *map = (duct_affine){cosine, sine, -sine, cosine, 0, 0};
    if (count == 3) {
        map->e = n[1] - cosine * n[1] + sine * n[2];
        map->f = n[2] - sine * n[1] - cosine * n[2];
    }
    return count == 1 || count == 3;
}

static bool function_map(duct_slice name, const double *n, int count, duct_affine *map)
{
    *map = duct_affine_identity();
    if (duct_slice_is(name, "matrix")) {
        *map = (duct_affine){n[0], n[1], n[2], n[3], n[4], n[5]};
        return count == 6;
    }
    if (duct_slice_is(name, "translate")) {
        map->e = n[0];
        map->f = count == 2 ? n[1] : 0;
        return count == 1 || count == 2;
    }
    if (duct_slice_is(name, "scale")) {
        map->a = n[0];
        map->d = count == 2 ? n[1] : n[0];
        return count == 1 || count == 2;
    }
    if (duct_slice_is(name, "rotate")) {
        return rotation(n, count, map);
    }
    if (count != 1) {
        return false;
    }
    double *entry = duct_slice_is(name, "skewx")        ? &map->c
                    : duct_slice_is(name, "skewy")      ? &map->b
                    : duct_slice_is(name, "translatex") ? &map->e
                    : duct_slice_is(name, "translatey") ? &map->f
                    : duct_slice_is(name, "scalex")     ? &map->a
                    : duct_slice_is(name, "scaley")     ? &map->d
                                                        : NULL;
    if (entry == NULL) {
        return false;
    }
    *entry = entry == &map->c || entry == &map->b ? tan(n[0] * degree) : n[0];
    return true;
}

bool duct_svg_transform(duct_slice value, duct_affine *map)
{
    if (value.text == NULL) {
        return false;
    }
    value = duct_slice_trim(value);
    const char *s = value.text, *end = value.text + value.size;
    duct_affine all = duct_affine_identity();
    if (duct_slice_is(value, "none")) {
        *map = all;
        return true;
    }
    while (s < end) {
        const char *name = s;
        while (s < end && ((*s >= 'a' && *s <= 'z') || (*s >= 'A' && *s <= 'Z'))) {
            s++;
        }
        duct_slice function = {name, (size_t)(s - name)};
        duct_skip_space(&s);
        double numbers[6] = {0};
        duct_affine one;
        if (s >= end || *s++ != '(') {
            return false;
        }
        int count = read_arguments(&s, numbers);
        if (count < 0 || s > end || !function_map(function, numbers, count, &one)) {
            return false;
        }
        all = duct_affine_multiply(all, one);
        while (s < end && (duct_is_space(*s) || *s == ',')) {
            s++;
        }
    }
    *map = all;
    return true;
}

bool duct_svg_viewbox(const char *value, double box[4])
{
    if (value == NULL) {
        return false;
    }
    double made[4];
    const char *s = value;
    duct_skip_space(&s);
    for (int i = 0; i < 4; i++) {
        const char *end;
        if (!duct_number_scan(s, &end, &made[i]) || !isfinite(made[i])) {
            return false;
        }
        s = end;
        duct_skip_comma(&s);
    }
    if (*s != '\0' || !(made[2] > 0) || !(made[3] > 0)) {
        return false;
    }
    memcpy(box, made, sizeof made);
    return true;
}

/* The share of the free space that goes before the box: 0, 1/2 or 1 for Min, Mid, Max. */
static double alignment(const char *three)
{
    return strncmp(three, "Min", 3) == 0 ? 0 : strncmp(three, "Max", 3) == 0 ? 1 : 0.5;
}

duct_affine duct_svg_viewbox_map(const double box[4], const char *preserve, double width, double height)
{
    double sx = width / box[2], sy = height / box[3];
    duct_slice rest = duct_slice_of(preserve != NULL ? preserve : ""), word;
    double align_x = 0.5, align_y = 0.5;
    duct_slice_word(&rest, &word);
    if (duct_slice_is(word, "defer")) {
        duct_slice_word(&rest, &word);
    }
    if (!duct_slice_is(word, "none")) {
        if (word.size == 8) {
            align_x = alignment(word.text + 1);
            align_y = alignment(word.text + 5);
        }
        duct_slice_word(&rest, &word);
        sx = sy = duct_slice_is(word, "slice") ? fmax(sx, sy) : fmin(sx, sy);
    }
    return (duct_affine){sx,
                         0,
                         0,
                         sy,
                         (width - box[2] * sx) * align_x - box[0] * sx,
                         (height - box[3] * sy) * align_y - box[1] * sy};
}
