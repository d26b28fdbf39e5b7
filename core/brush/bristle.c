/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A brush of bristles, in the spirit of DiVerdi, Krishnaswamy and Hadap, "Industrial-Strength Painting with a
 * Virtual Bristle Brush" (VRST 2010): many tips, each with a length, an ink supply and a path of its own,
 * leave streaks that run along the stroke. Deviating from it, bristles do not collide or bend as rods: the
 * footprint is spread, moved and squeezed as a whole by pressure, tilt and twist, and each tip is dragged
 * behind its place in it, which is a fraction of the work and needs no time step.
 *
 * All that is random is a function of (seed, stroke id, bristle, purpose). Lengths are relative to the
 * brush's size, so that a stroke looks the same at any scale. */
#include "brush/brush_private.h"
#include "brush/dab.h"
#include "brush/walk.h"

#include "base/error.h"

#include <ductus/random.h>

#include <math.h>

static const double pi = 3.14159265358979323846;

enum {
    PURPOSE_ANGLE = 16,
    PURPOSE_PLACE,
    PURPOSE_LENGTH,
    PURPOSE_INK,
    PURPOSE_SHADE,
    PURPOSE_THICKNESS,
    PURPOSE_LAG,
    PURPOSE_GRAIN
};

typedef struct bristle {
    double u,
        v; /* place in the footprint: along its width (-1..1) and its thickness (-1..1 over the ratio) */
    double lift;      /* 0..1: how far the tip ends above the longest bristles' */
    double ink;       /* supply, about 1 */
    double thickness; /* about 1 */
    double lag;       /* drag length over the brush's radius */
    float red, green, blue;
    double x, y;     /* the tip, canvas pixels */
    double cell;     /* the grain's cell that `grain` belongs to */
    double grain[2]; /* 0..1, at the cell's ends */
} bristle;

typedef struct tuft {
    const duct_tuft *shape;
    bristle *bristles;
    size_t count;
    double radius; /* of the footprint at pressure 0.5, canvas pixels */
    double tip;    /* radius of a bristle's mark there */
    double step;   /* of the walk */
    double opacity, hardness;
    uint64_t seed, stroke;
} tuft;

static double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* 0 at `low` and below, 1 at `high` and above, smooth between. */
static double ramp(double low, double high, double value)
{
    double t = clamp((value - low) / (high - low), 0, 1);
    return t * t * (3 - 2 * t);
}

static double chance(const tuft *t, size_t i, int purpose)
{
    return duct_random_uniform(t->seed, t->stroke, i, (uint64_t)purpose);
}

static void place_bristle(const tuft *t, size_t i, bristle *b)
{
    double n = (double)t->count;
    if (t->shape->ratio < 1.5) {
        /* Vogel's sunflower fills a disc evenly at any count; a little disorder hides its spirals. */
        double r = sqrt(((double)i + 0.2 + 0.6 * chance(t, i, PURPOSE_PLACE)) / n);
        double angle = (double)i * 2.399963229728653 + 0.8 * (chance(t, i, PURPOSE_ANGLE) - 0.5);
        b->u = r * cos(angle);
        b->v = r * sin(angle) / t->shape->ratio;
    } else {
        b->u = ((double)i + chance(t, i, PURPOSE_PLACE)) / n * 2 - 1;
        b->v = (chance(t, i, PURPOSE_ANGLE) * 2 - 1) / t->shape->ratio;
    }
}

static float shaded(float colour, double shade)
{
    double c = clamp((double)colour, 0, 1);
    return (float)clamp(shade > 0 ? c + (1 - c) * shade : c * (1 + shade), 0, 1);
}

static void grow_bristle(const tuft *t, size_t i, duct_stroke_style style, bristle *b)
{
    place_bristle(t, i, b);
    double from_middle = b->u * b->u + (t->shape->ratio < 1.5 ? b->v * b->v : 0);
    b->lift = 0.75 * pow(chance(t, i, PURPOSE_LENGTH), 1.3) + 0.25 * from_middle;
    b->ink = 0.6 + 0.8 * chance(t, i, PURPOSE_INK);
    b->thickness = 0.7 + 0.6 * chance(t, i, PURPOSE_THICKNESS);
    b->lag = (0.05 + 0.5 * (1 - t->shape->stiffness)) * (0.5 + chance(t, i, PURPOSE_LAG));
    double shade =
        0.5 * t->shape->colour * clamp(duct_random_normal(t->seed, t->stroke, i, PURPOSE_SHADE), -2, 2);
    b->red = shaded(style.red, shade);
    b->green = shaded(style.green, shade);
    b->blue = shaded(style.blue, shade);
    b->cell = -1;
}

/* How the paper's grain and the ink's unevenness let a bristle paint: 0..1 along the stroke, smooth. */
static double grain(const tuft *t, size_t i, bristle *b, double distance)
{
    double place = distance / (2 * t->radius) * (0.5 + 0.5 * b->thickness) + (double)i * 0.37;
    double cell = floor(place), along = place - cell;
    if (cell != b->cell) {
        uint64_t number = (uint64_t)clamp(cell, 0, 1e15) * DUCT_MAX_BRISTLES + i;
        b->cell = cell;
        b->grain[0] = duct_random_uniform(t->seed, t->stroke, number, PURPOSE_GRAIN);
        b->grain[1] = duct_random_uniform(t->seed, t->stroke, number + DUCT_MAX_BRISTLES, PURPOSE_GRAIN);
    }
    double s = along * along * (3 - 2 * along);
    return b->grain[0] + (b->grain[1] - b->grain[0]) * s;
}

/* The whole footprint at a pose. */
typedef struct footprint {
    double size;           /* radius, canvas pixels */
    double cosine, sine;   /* of the turn */
    double lean_x, lean_y; /* unit vector towards the leaning side, or 0 */
    double lean;           /* 0..1: how much tilt acts */
    double pressure;
} footprint;

static footprint footprint_at(const tuft *t, const duct_pose *pose)
{
    footprint f = {.pressure = pose->pressure};
    double spread = t->shape->spread;
    f.size = t->radius * fmax(1 - spread + 2 * spread * pose->pressure, 0.1);
    double angle = pose->twist + t->shape->angle * pi / 180;
    f.cosine = cos(angle);
    f.sine = sin(angle);
    double lean = hypot(pose->lean_x, pose->lean_y);
    if (lean > 1e-9) {
        f.lean_x = pose->lean_x / lean;
        f.lean_y = pose->lean_y / lean;
    }
    f.lean = t->shape->tilt * lean;
    return f;
}

/* Where a bristle's tip belongs at a pose, and how hard it is pressed: 0 hangs in the air, 1 is pressed down.
 * A leaning brush lies down on the side it leans to: the patch moves there, gets long and narrow, and the
 * bristles on the other side lift off. */
static double press(const footprint *f, const duct_pose *pose, const bristle *b, double dryness, double *x,
                    double *y)
{
    double qx = b->u * f->cosine - b->v * f->sine, qy = b->u * f->sine + b->v * f->cosine;
    double along = qx * f->lean_x + qy * f->lean_y;
    double ax = along * f->lean_x, ay = along * f->lean_y;
    double longer = 1 + 1.1 * f->lean, narrower = 1 - 0.4 * f->lean, moved = 0.7 * f->lean;
    *x = pose->x + f->size * (ax * longer + (qx - ax) * narrower + moved * f->lean_x);
    *y = pose->y + f->size * (ay * longer + (qy - ay) * narrower + moved * f->lean_y);
    double load = f->pressure * 1.2 + f->lean * 0.55 * along;
    return ramp(0, 0.18, load - 0.02 - 0.6 * dryness * b->lift);
}

/* Moves a tip to its place, dragged behind it, and paints its mark. `alone`: the mark is not one of many that
 * overlap along a line. */
static void paint_bristle(const tuft *t, duct_canvas *target, size_t i, const footprint *f,
                          const duct_pose *pose, bool alone)
{
    bristle *b = &t->bristles[i];
    double x, y, contact = press(f, pose, b, t->shape->dryness, &x, &y);
    double follow = pose->jump ? 1 : 1 - exp(-t->step / (b->lag * t->radius));
    double dx = pose->jump ? 0 : (x - b->x) * follow, dy = pose->jump ? 0 : (y - b->y) * follow;
    b->x = pose->jump ? x : b->x + dx;
    b->y = pose->jump ? y : b->y + dy;
    if (contact <= 0) {
        return;
    }
    double travelled = pose->distance / (2 * t->radius);
    double supply = t->shape->ink > 0 ? b->ink / (1 + travelled / t->shape->ink) : b->ink;
    double wet = supply * (0.3 + 1.2 * f->pressure);
    double covers = ramp(-0.06, 0.14, wet - t->shape->dryness * (0.1 + 0.9 * grain(t, i, b, pose->distance)));
    double opacity = t->opacity * contact * covers;
    if (opacity < 0.004) {
        return;
    }
    double radius = t->tip * b->thickness * (0.55 + 0.45 * contact) * sqrt(f->size / t->radius);
    if (!alone) {
        /* So many marks lie over each other that together they have the opacity wanted. */
        double overlap = fmax(1.3 * radius / t->step, 1);
        opacity = 1 - pow(1 - fmin(opacity, 0.995), 1 / overlap);
    }
    duct_dab dab = {b->x, b->y, radius, 1, 0, t->hardness, opacity, b->red, b->green, b->blue, 1, false};
    /* Where the footprint turns, outer tips go farther than the pen. */
    double marks = clamp(ceil(hypot(dx, dy) / (1.3 * t->step)), 1, 64);
    for (double k = marks - 1; k >= 0; k--) {
        dab.x = b->x - dx * k / marks;
        dab.y = b->y - dy * k / marks;
        duct_dab_paint(target, &dab);
    }
}

static void paint_walk(const tuft *t, duct_canvas *target, duct_walk *walk)
{
    duct_pose pose, first = {0};
    size_t count = 0;
    while (duct_walk_next(walk, &pose)) {
        if (count++ == 0) {
            first = pose;
        }
        footprint f = footprint_at(t, &pose);
        for (size_t i = 0; i < t->count; i++) {
            paint_bristle(t, target, i, &f, &pose, false);
        }
    }
    if (count == 1) {
        footprint f = footprint_at(t, &first);
        for (size_t i = 0; i < t->count; i++) {
            paint_bristle(t, target, i, &f, &first, true);
        }
    }
}

/* A small brush gets fewer bristles, so that their marks are not much thinner than a pixel: more could not be
 * seen and would cost as much as those of a large brush. */
static size_t visible_bristles(const duct_tuft *shape, double radius)
{
    const double least = 24;
    double marks = 2.5 * shape->thickness * radius;
    double count = fmax(marks * marks / shape->ratio, least);
    return (size_t)fmin(count, shape->bristles);
}

duct_status duct_bristle_paint(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                               const duct_paint_options *options, duct_error *error)
{
    const duct_tuft *shape = &brush->tuft;
    tuft t = {.shape = shape, .seed = options->seed};
    t.stroke = duct_random_id(duct_stroke_id(stroke));
    t.radius = duct_brush_radius(brush, stroke, options);
    t.count = visible_bristles(shape, t.radius);
    t.tip = shape->thickness * 1.25 * t.radius / sqrt((double)t.count * shape->ratio);
    t.step = clamp(0.35 * t.tip, 0.45, 1000);
    t.opacity = clamp((double)brush->base[MYPAINT_BRUSH_SETTING_OPAQUE], 0, 1);
    t.hardness = clamp((double)brush->base[MYPAINT_BRUSH_SETTING_HARDNESS], 0.05, 1);
    t.bristles = duct_alloc(target->allocator, t.count, sizeof *t.bristles);
    if (t.bristles == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < t.count; i++) {
        grow_bristle(&t, i, duct_stroke_get_style(stroke), &t.bristles[i]);
    }
    double reach = 6 * t.radius + 64;
    const double box[4] = {-reach, -reach, target->width + reach, target->height + reach};
    duct_walk walk;
    duct_walk_begin(&walk, stroke, options, box, t.step);
    paint_walk(&t, target, &walk);
    duct_release(target->allocator, t.bristles);
    return DUCT_OK;
}
