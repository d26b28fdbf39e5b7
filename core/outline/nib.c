/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline/nib.h"

#include <math.h>

static const double pi = 3.14159265358979323846;
static const double farthest = 1e8; /* pixels; beyond, coordinates lose the precision of outlines */
static const double widest = 1e5;   /* pixels */
static const double least_altitude = 0.436332; /* 25 degrees: a flatter pen's nib grows no further */
static const double clear_tilt =
    0.349066; /* 20 degrees: from here on the tilt's direction is to be trusted */

duct_nib_options duct_nib_options_default(void)
{
    return (duct_nib_options){
        .width = 0, .thinnest = 0.3, .thickest = 1.7, .aspect = 1.5, .fit_tolerance = 0.1};
}

static double clamp(double value, double least, double most)
{
    return value > least ? value < most ? value : most : least; /* NaN gives the least */
}

/* The width at a pressure, as a share of the full width: linear from `thinnest` to 1 and on to `thickest`. */
static double width_share(const duct_nib_options *options, double pressure)
{
    double thinnest = clamp(options->thinnest, 0, 100), thickest = clamp(options->thickest, 0, 100);
    double p = 2 * clamp(pressure, 0, 1);
    return p < 1 ? thinnest + p * (1 - thinnest) : 1 + (p - 1) * (thickest - 1);
}

/* The pen's inclination from upright and the direction in which it leans, from the tilts of Pointer Events.
 */
static double inclination(double tilt_x, double tilt_y, double *azimuth)
{
    double tx = tan(clamp(tilt_x, -1.5, 1.5)), ty = tan(clamp(tilt_y, -1.5, 1.5));
    *azimuth = atan2(ty, tx);
    return atan(hypot(tx, ty));
}

/* Turns an axis by half turns until it is nearest to the one before. */
static double unwrap_axis(double angle, double before)
{
    return angle - pi * floor((angle - before) / pi + 0.5);
}

void duct_nibs_of(const duct_stroke *stroke, const duct_nib_options *options, duct_nib *nibs)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    const double *pressure = duct_stroke_values(stroke, DUCT_PRESSURE);
    const double *tilt_x = duct_stroke_values(stroke, DUCT_TILT_X);
    const double *tilt_y = duct_stroke_values(stroke, DUCT_TILT_Y);
    const double *twist = duct_stroke_values(stroke, DUCT_TWIST);
    double width = options->width > 0 ? options->width : duct_stroke_get_style(stroke).width;
    width = width > 0 ? fmin(width, widest) : 1;
    double thinnest = 0.05 * clamp(options->fit_tolerance, 1e-3, 1);
    double aspect = clamp(options->aspect, 1, 100);
    double angle = 0;
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        double share = pressure != NULL ? width_share(options, pressure[i]) : 1;
        double lean = 0, azimuth = 0, oriented = twist != NULL ? 1 : 0;
        if (tilt_x != NULL || tilt_y != NULL) {
            lean = inclination(tilt_x != NULL ? tilt_x[i] : 0, tilt_y != NULL ? tilt_y[i] : 0, &azimuth);
            /* The direction of a pen that is nearly upright means little: without twist its nib becomes
             * round. */
            double trust = fmin(lean / clear_tilt, 1);
            oriented = twist != NULL ? 1 : trust * trust * (3 - 2 * trust);
        }
        double slant = fmax(cos(lean), sin(least_altitude));
        double ratio = 1 + oriented * (aspect / slant - 1);
        if (twist != NULL || lean > 0.02) {
            angle = unwrap_axis(twist != NULL ? clamp(twist[i], -1e6, 1e6) : azimuth, angle);
        }
        /* The area does not depend on the ratio, so the line's darkness does not either. */
        double radius = 0.5 * width * share, root = sqrt(ratio);
        nibs[i] = (duct_nib){clamp(x[i], -farthest, farthest),
                             clamp(y[i], -farthest, farthest),
                             fmax(radius * root, thinnest),
                             fmax(radius / root, thinnest),
                             angle,
                             cos(angle),
                             sin(angle)};
    }
}

duct_nib duct_nib_between(const duct_nib *a, const duct_nib *b, double t, double x, double y)
{
    double angle = a->angle + t * (b->angle - a->angle);
    return (duct_nib){x,
                      y,
                      a->major + t * (b->major - a->major),
                      a->minor + t * (b->minor - a->minor),
                      angle,
                      cos(angle),
                      sin(angle)};
}

double duct_nib_support(const duct_nib *nib, duct_normal normal)
{
    double u = nib->major * (normal.x * nib->c + normal.y * nib->s);
    double v = nib->minor * (normal.y * nib->c - normal.x * nib->s);
    return sqrt(u * u + v * v);
}

void duct_nib_touch(const duct_nib *nib, duct_normal normal, double xy[2])
{
    double u = nib->major * (normal.x * nib->c + normal.y * nib->s);
    double v = nib->minor * (normal.y * nib->c - normal.x * nib->s);
    double reach = sqrt(u * u + v * v);
    u *= nib->major / reach;
    v *= nib->minor / reach;
    xy[0] = nib->x + u * nib->c - v * nib->s;
    xy[1] = nib->y + u * nib->s + v * nib->c;
}

double duct_nib_parameter(const duct_nib *nib, duct_normal normal)
{
    return atan2(nib->minor * (normal.y * nib->c - normal.x * nib->s),
                 nib->major * (normal.x * nib->c + normal.y * nib->s));
}

void duct_nib_point(const duct_nib *nib, double t, double xy[2])
{
    double u = nib->major * cos(t), v = nib->minor * sin(t);
    xy[0] = nib->x + u * nib->c - v * nib->s;
    xy[1] = nib->y + u * nib->s + v * nib->c;
}
