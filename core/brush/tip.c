/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A drawing tip: pen, pencil or stick of charcoal. Its mark is an oval that turns with the barrel; as the
 * barrel leans it lies down along the lean, from the point on, and so gets longer and presses less. Dabs do
 * not build up along a stroke (`wash`): what they leave is one even mark, for the paper's grain to texture.
 *
 * How pressure acts is read from the file's own curves for size and opacity, so that other programs paint
 * with a brush that answers alike. */
#include "brush/brush_private.h"
#include "brush/dab.h"
#include "brush/walk.h"

#include "base/error.h"

#include <math.h>

static const double pi = 3.14159265358979323846;
static const double largest_radius = 1000; /* of a dab, canvas pixels */

typedef struct tip {
    const duct_brush *brush;
    double radius; /* at pressure 0.5, canvas pixels */
    duct_stroke_style style;
} tip;

/* A setting's curve over pressure, libmypaint's way: straight between points, and beyond the outer ones. */
static double pressed_part(const duct_curve *curve, double pressure)
{
    int i = 1;
    while (i + 1 < curve->count && pressure > (double)curve->x[i]) {
        i++;
    }
    const double x0 = (double)curve->x[i - 1], y0 = (double)curve->y[i - 1];
    const double width = (double)curve->x[i] - x0;
    return width > 0 ? y0 + ((double)curve->y[i] - y0) * (pressure - x0) / width : (double)curve->y[i];
}

/* What pressure adds to a setting. */
static double from_pressure(const duct_brush *brush, MyPaintBrushSetting setting, double pressure)
{
    double sum = 0;
    for (size_t c = 0; c < brush->curve_count; c++) {
        const duct_curve *curve = &brush->curves[c];
        if (curve->setting == setting && curve->input == MYPAINT_BRUSH_INPUT_PRESSURE && curve->count > 1) {
            sum += pressed_part(curve, pressure);
        }
    }
    return sum;
}

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* An ellipse as the matrix whose eigenvectors are its axes and whose eigenvalues their squared halves: the
 * sum of two is about what one swept along the other covers, and depends smoothly on both. */
typedef struct ellipse {
    double xx, xy, yy;
} ellipse;

static void shape_dab(const ellipse *e, duct_dab *dab)
{
    const double mean = (e->xx + e->yy) / 2, apart = hypot((e->xx - e->yy) / 2, e->xy);
    const double most = mean + apart, least = fmax(mean - apart, 1e-6 * most);
    dab->radius = fmin(sqrt(most), largest_radius);
    dab->ratio = sqrt(most / least);
    dab->angle = apart > 0 ? atan2(e->xy, (e->xx - e->yy) / 2) / 2 : 0;
}

/* How far the ellipse reaches in the direction (x, y), a unit vector. */
static double reach(const ellipse *e, double x, double y)
{
    return sqrt(fmax(e->xx * x * x + 2 * e->xy * x * y + e->yy * y * y, 0));
}

static void paint_pose(const tip *t, duct_canvas *target, const duct_pose *pose)
{
    const duct_brush *brush = t->brush;
    const duct_tuft *shape = &brush->tuft;
    const double size =
        t->radius *
        exp(clamp(from_pressure(brush, MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC, pose->pressure), -6, 3));
    const double pressed = (double)brush->base[MYPAINT_BRUSH_SETTING_OPAQUE_MULTIPLY] +
                           from_pressure(brush, MYPAINT_BRUSH_SETTING_OPAQUE_MULTIPLY, pose->pressure);
    const double opacity = clamp((double)brush->base[MYPAINT_BRUSH_SETTING_OPAQUE] * pressed, 0, 1);
    if (!(opacity > 0)) {
        return;
    }
    const double turn = pose->twist + shape->angle * pi / 180, c = cos(turn), s = sin(turn);
    /* What is smaller than a pixel has no shape, and its width would be taken for the oval's length. */
    const double ratio = 1 + (shape->ratio - 1) * clamp((size - 0.6) / 0.6, 0, 1);
    const double a = size * size * ratio, b = size * size / ratio;
    ellipse e = {a * c * c + b * s * s, (a - b) * c * s, a * s * s + b * c * c};
    const double lean = hypot(pose->lean_x, pose->lean_y),
                 hardness = (double)brush->base[MYPAINT_BRUSH_SETTING_HARDNESS];
    duct_dab dab = {.x = pose->x,
                    .y = pose->y,
                    .hardness = clamp(hardness, 0.05, 1),
                    .opacity = opacity * (1 - 0.5 * shape->tilt * lean),
                    .red = t->style.red,
                    .green = t->style.green,
                    .blue = t->style.blue,
                    .target_alpha = 1,
                    .wash = true};
    shape_dab(&e, &dab);
    duct_dab_paint(target, &dab);
    if (!(lean > 1e-6) || !(brush->side > 0)) {
        return;
    }
    const double point = reach(&e, pose->lean_x / lean, pose->lean_y / lean);
    const double along = size * brush->side;
    e.xx += along * along * pose->lean_x * pose->lean_x;
    e.xy += along * along * pose->lean_x * pose->lean_y;
    e.yy += along * along * pose->lean_y * pose->lean_y;
    const double moved = (reach(&e, pose->lean_x / lean, pose->lean_y / lean) - point) / lean;
    dab.x += moved * pose->lean_x;
    dab.y += moved * pose->lean_y;
    dab.opacity = opacity * (1 - shape->tilt * lean);
    shape_dab(&e, &dab);
    duct_dab_paint(target, &dab);
}

duct_status duct_tip_paint(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                           const duct_paint_options *options, duct_error *error)
{
    (void)error;
    const tip t = {brush, duct_brush_radius(brush, stroke, options), duct_stroke_get_style(stroke)};
    const double around = fmin((4 + 4 * brush->side) * t.radius, 4 * largest_radius) + 64;
    const double box[4] = {-around, -around, target->width + around, target->height + around};
    duct_walk walk;
    duct_walk_begin(&walk, stroke, options, box, fmax(0.1, 0.05 * t.radius));
    duct_pose pose;
    while (duct_walk_next(&walk, &pose)) {
        paint_pose(&t, target, &pose);
    }
    return DUCT_OK;
}
