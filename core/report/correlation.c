/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/correlation.h"

#include <math.h>

/* Standard deviations up to these are no movement of a pen but a tablet's last digit, whose steps correlate
 * with nothing: a step of pressure among 1024, and a tenth of a degree. */
static const double still_pressure = 0.001, still_angle = 0.002;

/* z has no bound, and quantized values give coefficients of 1 by chance: a single one must not weigh as much
 * as ten others. */
static const double largest = 0.999;

/* Walks a run's values, angles without their jumps of a whole turn. */
typedef struct {
    const double *values;
    bool angle;
    double last, value;
} run;

static void run_step(run *self, size_t i)
{
    double value = self->values[i];
    if (!self->angle || i == 0) {
        self->value = value;
    } else {
        self->value += remainder(value - self->last, 2 * M_PI);
    }
    self->last = value;
}

bool duct_correlate(const double *a, const double *b, size_t count, bool angle, double *coefficient)
{
    run x = {a, angle, 0, 0}, y = {b, angle, 0, 0};
    double mean_x = 0, mean_y = 0, xx = 0, yy = 0, xy = 0;
    /* Running means: exact zeros for constant runs, whatever their value. */
    for (size_t i = 0; i < count; i++) {
        run_step(&x, i);
        run_step(&y, i);
        double n = (double)(i + 1), dx = x.value - mean_x, dy = y.value - mean_y;
        mean_x += dx / n;
        mean_y += dy / n;
        xx += dx * (x.value - mean_x);
        yy += dy * (y.value - mean_y);
        xy += dx * (y.value - mean_y);
    }
    double still = angle ? still_angle : still_pressure;
    double least = (double)count * still * still;
    if (!(xx > least) || !(yy > least)) {
        return false;
    }
    *coefficient = fmax(-1, fmin(1, xy / sqrt(xx * yy)));
    return true;
}

void duct_fisher_add(duct_fisher *fisher, double coefficient)
{
    fisher->sum += atanh(fmax(-largest, fmin(largest, coefficient)));
    fisher->count++;
}

void duct_fisher_add_mean(duct_fisher *fisher, const duct_fisher *other)
{
    if (other->count > 0) {
        fisher->sum += other->sum / (double)other->count;
        fisher->count++;
    }
}

double duct_fisher_mean(const duct_fisher *fisher)
{
    return fisher->count > 0 ? tanh(fisher->sum / (double)fisher->count) : NAN;
}
