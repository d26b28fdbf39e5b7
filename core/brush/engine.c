/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Painting a stroke with libmypaint 1.6, so that the same stroke gives the same pixels on every run.
 *
 * libmypaint leaves part of a new brush uninitialised, and draws random numbers whose generator starts alike
 * in each brush and cannot be set. So each stroke gets a brush of its own with every setting set and a first
 * event that paints nothing, and the generator is turned on by resets, each of which draws one number: how
 * many follows from the seed and the stroke's id. */
#include "brush/brush_private.h"
#include "brush/colour.h"
#include "brush/surface.h"
#include "brush/walk.h"

#include "base/error.h"

#include <ductus/random.h>

#include <math.h>

static const double pi = 3.14159265358979323846;

enum {
    PURPOSE_TURNS = 1,
    MOST_TURNS = 1024 /* different starts of the random generator */
};

static MyPaintBrush *new_brush(const duct_brush *brush, const duct_stroke *stroke, double radius)
{
    MyPaintBrush *engine = mypaint_brush_new();
    if (engine == NULL) {
        return NULL;
    }
    mypaint_brush_from_defaults(engine);
    for (int s = 0; s < MYPAINT_BRUSH_SETTINGS_COUNT; s++) {
        for (int i = 0; i < MYPAINT_BRUSH_INPUTS_COUNT; i++) {
            mypaint_brush_set_mapping_n(engine, (MyPaintBrushSetting)s, (MyPaintBrushInput)i, 0);
        }
        mypaint_brush_set_base_value(engine, (MyPaintBrushSetting)s, brush->base[s]);
    }
    for (size_t c = 0; c < brush->curve_count; c++) {
        const duct_curve *curve = &brush->curves[c];
        mypaint_brush_set_mapping_n(engine, curve->setting, curve->input, curve->count);
        for (int i = 0; i < curve->count; i++) {
            mypaint_brush_set_mapping_point(engine, curve->setting, curve->input, i, curve->x[i],
                                            curve->y[i]);
        }
    }
    mypaint_brush_set_base_value(engine, MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC, (float)log(radius));
    duct_stroke_style style = duct_stroke_get_style(stroke);
    float hsv[3];
    duct_hsv(style.red, style.green, style.blue, hsv);
    mypaint_brush_set_base_value(engine, MYPAINT_BRUSH_SETTING_COLOR_H, hsv[0]);
    mypaint_brush_set_base_value(engine, MYPAINT_BRUSH_SETTING_COLOR_S, hsv[1]);
    mypaint_brush_set_base_value(engine, MYPAINT_BRUSH_SETTING_COLOR_V, hsv[2]);
    return engine;
}

/* Tells libmypaint the pose of a place that is at most a step away. The pose's angles are set as its states
 * first, because it would interpolate them as angles, which turn wildly where the pen is almost upright; the
 * walk has interpolated them as vectors. */
static void send(MyPaintBrush *engine, duct_surface *surface, const duct_pose *pose, double time, double zoom)
{
    /* To libmypaint a tilt of exactly 0 means that there is no tilt, and it then gives 90 degrees for both of
     * its parts, so an upright pen leans a millionth. */
    float lean_x = (float)pose->lean_x, lean_y = (float)pose->lean_y;
    if (lean_x == 0 && lean_y == 0) {
        lean_y = 1e-6f;
    }
    double lean = hypot(pose->lean_x, pose->lean_y);
    double declination = 90 - 60 * lean;
    double ascension = lean > 0 ? atan2(-pose->lean_x, pose->lean_y) * 180 / pi : 0;
    double turns = pose->twist / (2 * pi);
    turns -= floor(turns); /* brushes see it as 0..360 degrees */
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DECLINATION, (float)declination);
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_ASCENSION, (float)ascension);
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DECLINATIONX, (float)(pose->lean_x * 60));
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DECLINATIONY, (float)(pose->lean_y * 60));
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_BARREL_ROTATION, (float)(turns * 360));
    mypaint_brush_stroke_to_2(engine, &surface->tiled.parent, (float)pose->x, (float)pose->y,
                              (float)pose->pressure, lean_x, lean_y, time, (float)zoom, 0, (float)turns);
}

/* Puts the pen down somewhere without painting on the way. */
static void put_down(MyPaintBrush *engine, const duct_pose *pose)
{
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_X, (float)pose->x);
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_Y, (float)pose->y);
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_ACTUAL_X, (float)pose->x);
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_ACTUAL_Y, (float)pose->y);
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_PRESSURE, (float)pose->pressure);
    /* The first dab is due at once: a stroke begins where its first sample is. */
    mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_PARTIAL_DABS, 0.999f);
}

/* Gives the brush its direction from the beginning: it would have to find it on the way. */
static void point(MyPaintBrush *engine, double dx, double dy)
{
    double length = hypot(dx, dy);
    if (length > 0) {
        float x = (float)(dx / length), y = (float)(dy / length);
        mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DIRECTION_DX, x);
        mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DIRECTION_DY, y);
        mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DIRECTION_ANGLE_DX, x);
        mypaint_brush_set_state(engine, MYPAINT_BRUSH_STATE_DIRECTION_ANGLE_DY, y);
    }
}

/* Brings a new brush into a known state at the stroke's first place. */
static void warm_up(MyPaintBrush *engine, duct_surface *surface, const duct_pose *pose, uint64_t turns,
                    double zoom)
{
    surface->muted = true;
    duct_pose hover = *pose;
    hover.pressure = 0;
    for (int i = 0; i < 2; i++) {
        mypaint_brush_reset(engine);
        send(engine, surface, &hover, 0.0001, zoom);
        send(engine, surface, &hover, 0.0001, zoom);
    }
    for (uint64_t i = 0; i <= turns; i++) {
        mypaint_brush_reset(engine);
        send(engine, surface, &hover, 0.0001, zoom);
    }
    mypaint_brush_new_stroke(engine);
    send(engine, surface, &hover, 0.0001, zoom);
    surface->muted = false;
}

/* A stroke without length: libmypaint paints by distance and by time, so the pen trembles a little and stays
 * for a tenth of a second. */
static void dot(MyPaintBrush *engine, duct_surface *surface, const duct_pose *pose, double radius,
                double zoom)
{
    duct_pose place = *pose;
    for (int i = 0; i < 4; i++) {
        place.x = pose->x + (i % 2 == 0 ? 0.01 : -0.01) * radius;
        send(engine, surface, &place, 0.025, zoom);
    }
}

static void paint_walk(MyPaintBrush *engine, duct_surface *surface, duct_walk *walk, double radius,
                       uint64_t turns)
{
    const double longest = 0.1;    /* seconds; libmypaint forgets the stroke after pauses */
    double zoom = 1 / walk->scale; /* speeds and directions are measured in drawing pixels */
    duct_pose pose, first = {0};
    size_t count = 0;
    while (duct_walk_next(walk, &pose)) {
        if (count++ == 0) {
            first = pose;
            warm_up(engine, surface, &pose, turns, zoom);
        }
        if (pose.jump) {
            put_down(engine, &pose);
        }
        if (count == 1) {
            continue; /* the way to the second place paints the first one too */
        }
        if (count == 2) {
            point(engine, pose.x - first.x, pose.y - first.y);
        }
        send(engine, surface, &pose, fmin(fmax(pose.time, 0.0001), longest), zoom);
    }
    if (count == 1) {
        dot(engine, surface, &first, radius, zoom);
    }
}

duct_status duct_engine_paint(duct_canvas *target, const duct_brush *brush, const duct_stroke *stroke,
                              const duct_paint_options *options, duct_error *error)
{
    double radius = duct_brush_radius(brush, stroke, options);
    double reach = fmin(8 * radius + 64, 4096);
    const double box[4] = {-reach, -reach, target->width + reach, target->height + reach};
    duct_surface *surface = duct_alloc(target->allocator, 1, sizeof *surface);
    MyPaintBrush *engine = surface != NULL ? new_brush(brush, stroke, radius) : NULL;
    if (engine == NULL) {
        duct_release(target->allocator, surface);
        return duct_fail_memory(error);
    }
    uint64_t id = duct_random_id(duct_stroke_id(stroke));
    uint64_t turns = duct_random_bits(options->seed, id, 0, PURPOSE_TURNS) % MOST_TURNS;
    duct_walk walk;
    duct_walk_begin(&walk, stroke, options, box, fmax(0.5, 0.04 * radius));
    duct_surface_begin(surface, target);
    surface->wash = brush->wash;
    paint_walk(engine, surface, &walk, radius, turns);
    duct_surface_end(surface);
    mypaint_brush_unref(engine);
    duct_release(target->allocator, surface);
    return DUCT_OK;
}
