/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brush/walk.h"

#include <math.h>

/* Where the stroke has no time: the middle of what people draw with, in drawing pixels a second. */
static const double usual_speed = 400;
/* No hand is faster; equal time stamps would give an infinite speed. */
static const double largest_speed = 20000;

static const double sixty_degrees = 1.0471975511965976;

/* The pose at a sample, all but its time; false where its place is not finite. */
static bool sample_pose(const duct_walk *walk, size_t index, duct_pose *pose)
{
    size_t i = index < duct_stroke_size(walk->stroke) ? index : 0;
    double x = walk->values[DUCT_X][i] * walk->scale + walk->offset_x;
    double y = walk->values[DUCT_Y][i] * walk->scale + walk->offset_y;
    if (!(fabs(x) < 1e100) || !(fabs(y) < 1e100)) {
        return false;
    }
    *pose = (duct_pose){.x = x, .y = y, .pressure = 0.5};
    const double *pressure = walk->values[DUCT_PRESSURE];
    if (pressure != NULL && isfinite(pressure[i])) {
        pose->pressure = fmin(fmax(pressure[i], 0), 1);
    }
    const double *tilt_x = walk->values[DUCT_TILT_X], *tilt_y = walk->values[DUCT_TILT_Y];
    if (tilt_x != NULL && isfinite(tilt_x[i])) {
        pose->lean_x = fmin(fmax(tilt_x[i] / sixty_degrees, -2), 2);
    }
    if (tilt_y != NULL && isfinite(tilt_y[i])) {
        pose->lean_y = fmin(fmax(tilt_y[i] / sixty_degrees, -2), 2);
    }
    double lean = hypot(pose->lean_x, pose->lean_y);
    if (lean > 1) {
        pose->lean_x /= lean;
        pose->lean_y /= lean;
    }
    const double *twist = walk->values[DUCT_TWIST];
    if (twist != NULL && fabs(twist[i]) < 1e6) {
        pose->twist = twist[i];
    }
    return true;
}

/* Seconds between two samples, `length` canvas pixels apart. */
static double segment_time(const duct_walk *walk, size_t from, size_t to, double length)
{
    double usual = length / walk->default_speed;
    if (!walk->timed || to >= duct_stroke_size(walk->stroke)) {
        return usual;
    }
    double time = walk->values[DUCT_T][to] - walk->values[DUCT_T][from];
    double least = length / (largest_speed * walk->scale);
    return isfinite(time) ? fmax(time, least) : usual;
}

void duct_walk_begin(duct_walk *walk, const duct_stroke *stroke, const duct_paint_options *options,
                     const double box[4], double step)
{
    *walk = (duct_walk){.stroke = stroke,
                        .scale = options->scale,
                        .offset_x = options->offset_x,
                        .offset_y = options->offset_y,
                        .step = step};
    for (int channel = 0; channel < DUCT_CHANNEL_COUNT; channel++) {
        walk->values[channel] = duct_stroke_values(stroke, (duct_channel)channel);
    }
    for (int i = 0; i < 4; i++) {
        walk->box[i] = box[i];
    }
    size_t size = duct_stroke_size(stroke);
    walk->size = size + (duct_stroke_closed(stroke) && size > 1 ? 1 : 0);
    walk->default_speed = usual_speed * options->scale;
    const double *time = walk->values[DUCT_T];
    walk->timed = time != NULL && size > 1 && time[size - 1] > time[0] && isfinite(time[size - 1] - time[0]);
}

static double mix(double a, double b, double t)
{
    return a + (b - a) * t;
}

/* The pose `along` canvas pixels behind the segment's first point. */
static duct_pose pose_at(duct_walk *walk, double along)
{
    const duct_pose *a = &walk->from, *b = &walk->to;
    double t = walk->length > 0 ? fmin(fmax(along / walk->length, 0), 1) : 1;
    double clock = mix(walk->clock, walk->clock + b->time, t);
    duct_pose pose = {.x = mix(a->x, b->x, t),
                      .y = mix(a->y, b->y, t),
                      .pressure = mix(a->pressure, b->pressure, t),
                      .lean_x = mix(a->lean_x, b->lean_x, t),
                      .lean_y = mix(a->lean_y, b->lean_y, t),
                      .twist = mix(a->twist, b->twist, t),
                      .time = fmax(clock - walk->told, 0),
                      .distance = walk->distance + along,
                      .jump = walk->jump};
    walk->told = clock;
    walk->jump = false;
    return pose;
}

/* Liang and Barsky: the part t0..t1 of the segment that lies within the box; false where there is none. */
static bool clip(const duct_walk *walk, double *t0, double *t1)
{
    double dx = walk->to.x - walk->from.x, dy = walk->to.y - walk->from.y;
    const double p[4] = {-dx, dx, -dy, dy};
    const double q[4] = {walk->from.x - walk->box[0], walk->box[2] - walk->from.x,
                         walk->from.y - walk->box[1], walk->box[3] - walk->from.y};
    *t0 = 0;
    *t1 = 1;
    for (int i = 0; i < 4; i++) {
        if (p[i] == 0) {
            if (q[i] < 0) {
                return false;
            }
        } else if (p[i] < 0) {
            *t0 = fmax(*t0, q[i] / p[i]);
        } else {
            *t1 = fmin(*t1, q[i] / p[i]);
        }
    }
    return *t0 <= *t1;
}

/* Makes `from` .. `to` the segment to go along: sets the first place on it and where to leave it. */
static void enter_segment(duct_walk *walk)
{
    walk->length = hypot(walk->to.x - walk->from.x, walk->to.y - walk->from.y);
    double first = walk->step - walk->carry, t0, t1;
    if (!clip(walk, &t0, &t1)) {
        walk->at = INFINITY;
        walk->end = 0;
        walk->jump = true;
        return;
    }
    double begin = t0 * walk->length;
    walk->end = t1 * walk->length;
    walk->at = begin > first ? first + ceil((begin - first) / walk->step) * walk->step : first;
    if (t0 > 0) {
        walk->jump = true;
    }
}

static void leave_segment(duct_walk *walk)
{
    double carry = fmod(walk->carry + walk->length, walk->step);
    walk->carry = carry >= 0 ? carry : 0;
    walk->distance += walk->length;
    walk->clock += walk->to.time;
    if (walk->end < walk->length) {
        walk->jump = true;
    }
    walk->from = walk->to;
    walk->in_segment = false;
}

static bool inside(const duct_walk *walk, const duct_pose *pose)
{
    return pose->x >= walk->box[0] && pose->x <= walk->box[2] && pose->y >= walk->box[1] &&
           pose->y <= walk->box[3];
}

/* The stroke's first place; false where no sample is finite. */
static bool start(duct_walk *walk)
{
    walk->started = true;
    walk->jump = true;
    while (walk->next < walk->size) {
        if (sample_pose(walk, walk->next++, &walk->from)) {
            return true;
        }
    }
    walk->ended = true;
    return false;
}

/* Goes on to the next segment; false at the stroke's end. */
static bool advance(duct_walk *walk)
{
    size_t last = walk->next - 1;
    while (walk->next < walk->size) {
        size_t index = walk->next++;
        if (sample_pose(walk, index, &walk->to)) {
            double length = hypot(walk->to.x - walk->from.x, walk->to.y - walk->from.y);
            walk->to.time = segment_time(walk, last, index, length);
            walk->in_segment = true;
            enter_segment(walk);
            return true;
        }
    }
    return false;
}

bool duct_walk_next(duct_walk *walk, duct_pose *pose)
{
    if (!walk->started) {
        if (!start(walk)) {
            return false;
        }
        if (inside(walk, &walk->from)) {
            walk->to = walk->from;
            *pose = pose_at(walk, 0);
            return true;
        }
    }
    while (!walk->ended) {
        if (walk->in_segment) {
            if (walk->at <= walk->end) {
                *pose = pose_at(walk, walk->at);
                double at = walk->at + walk->step;
                /* Far out, where doubles are coarser than a step, the segment is over. */
                walk->at = at > walk->at ? at : INFINITY;
                return true;
            }
            leave_segment(walk);
        }
        if (!advance(walk)) {
            walk->ended = true;
            /* The end lies up to a step behind the last place. */
            if (walk->carry > 0 && inside(walk, &walk->from)) {
                walk->to = walk->from;
                walk->to.time = 0;
                walk->length = 0;
                *pose = pose_at(walk, 0);
                return true;
            }
        }
    }
    return false;
}
