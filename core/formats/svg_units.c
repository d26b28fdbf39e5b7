/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_units.h"

#include <math.h>

static double percent_base(duct_svg_axis axis, const duct_svg_viewport *viewport)
{
    switch (axis) {
    case DUCT_SVG_HORIZONTAL:
        return viewport->width;
    case DUCT_SVG_VERTICAL:
        return viewport->height;
    case DUCT_SVG_FONT:
        return viewport->font_size;
    case DUCT_SVG_DIAGONAL:
        break;
    }
    return hypot(viewport->width, viewport->height) / sqrt(2);
}

bool duct_svg_length(duct_slice value, duct_svg_axis axis, const duct_svg_viewport *viewport, double *length)
{
    static const struct {
        const char *unit;
        double pixels;
    } fixed[] = {{"", 1},           {"px", 1},  {"mm", 96 / 25.4}, {"cm", 96 / 2.54}, {"in", 96},
                 {"pt", 96.0 / 72}, {"pc", 16}, {"q", 96 / 101.6}, {"rem", 16}};
    double number;
    if (value.text == NULL || !duct_slice_number(&value, &number)) {
        return false;
    }
    duct_slice unit = duct_slice_trim(value);
    double factor = -1;
    for (size_t i = 0; i < sizeof fixed / sizeof *fixed; i++) {
        if (duct_slice_is(unit, fixed[i].unit)) {
            factor = fixed[i].pixels;
        }
    }
    if (duct_slice_is(unit, "%")) {
        factor = percent_base(axis, viewport) / 100;
    } else if (duct_slice_is(unit, "em")) {
        factor = viewport->font_size;
    } else if (duct_slice_is(unit, "ex") || duct_slice_is(unit, "ch")) {
        factor = viewport->font_size / 2;
    } else if (duct_slice_is(unit, "vw")) {
        factor = viewport->width / 100;
    } else if (duct_slice_is(unit, "vh")) {
        factor = viewport->height / 100;
    }
    if (!(factor >= 0) || !isfinite(number * factor)) {
        return false;
    }
    *length = number * factor;
    return true;
}

bool duct_svg_opacity(duct_slice value, double *opacity)
{
    double number;
    if (value.text == NULL || !duct_slice_number(&value, &number)) {
        return false;
    }
    duct_slice unit = duct_slice_trim(value);
    if (duct_slice_is(unit, "%")) {
        number /= 100;
    } else if (unit.size > 0) {
        return false;
    }
    *opacity = fmin(fmax(number, 0), 1);
    return true;
}
