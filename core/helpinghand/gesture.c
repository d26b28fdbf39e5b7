/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "helpinghand/gesture.h"

#include <math.h>

static double value(const duct_library *library, duct_channel channel, uint32_t sample)
{
    return library->channels[channel] != NULL ? library->channels[channel][sample] : 0;
}

duct_gesture duct_gesture_of(const duct_library *library, uint32_t sample, uint32_t stroke)
{
    const double *x = library->channels[DUCT_X], *y = library->channels[DUCT_Y];
    uint32_t to = sample > library->starts[stroke] ? sample : sample + 1;
    double twist = value(library, DUCT_TWIST, sample);
    return (duct_gesture){value(library, DUCT_PRESSURE, sample),
                          value(library, DUCT_TILT_X, sample),
                          value(library, DUCT_TILT_Y, sample),
                          cos(twist),
                          sin(twist),
                          x[to] - x[to - 1],
                          y[to] - y[to - 1]};
}

static duct_gesture add(duct_gesture a, duct_gesture b, double weight)
{
    return (duct_gesture){a.pressure + weight * b.pressure,
                          a.tilt_x + weight * b.tilt_x,
                          a.tilt_y + weight * b.tilt_y,
                          a.twist_cos + weight * b.twist_cos,
                          a.twist_sin + weight * b.twist_sin,
                          a.vx + weight * b.vx,
                          a.vy + weight * b.vy};
}

static duct_gesture of_candidate(const duct_library *library, const duct_candidate *candidate)
{
    return duct_gesture_of(library, candidate->sample, candidate->stroke);
}

void duct_gestures_closest(const duct_library *library, const duct_columns *columns, duct_gesture *gestures)
{
    for (size_t i = 0; i < columns->count; i++) {
        size_t best = columns->starts[i];
        for (size_t n = best + 1; n < columns->starts[i + 1]; n++) {
            best = columns->items[n].distance < columns->items[best].distance ? n : best;
        }
        gestures[i] = of_candidate(library, &columns->items[best]);
    }
}

void duct_gestures_average(const duct_library *library, const duct_columns *columns, duct_gesture *gestures)
{
    static const duct_gesture none = {0, 0, 0, 0, 0, 0, 0};
    for (size_t i = 0; i < columns->count; i++) {
        /* An exact match would have infinite weight: below this distance all count alike. */
        const double nearest = 1e-6;
        duct_gesture sum = none;
        double weights = 0;
        for (size_t n = columns->starts[i]; n < columns->starts[i + 1]; n++) {
            double weight = 1 / fmax((double)columns->items[n].distance, nearest);
            sum = add(sum, of_candidate(library, &columns->items[n]), weight);
            weights += weight;
        }
        gestures[i] = add(none, sum, 1 / weights);
    }
}

bool duct_is_jump(const duct_columns *columns, const size_t *chosen, size_t i)
{
    const duct_candidate *here = &columns->items[chosen[i]], *next = &columns->items[chosen[i + 1]];
    bool repeated = i > 0 && columns->items[chosen[i - 1]].sample == here->sample;
    return duct_transition_of(here, next, repeated) == DUCT_TRANSITION_JUMP;
}

static size_t least(size_t a, size_t b, size_t c)
{
    size_t ab = a < b ? a : b;
    return ab < c ? ab : c;
}

/* Fades over the jump behind query sample `i`: `left` samples up to and with i, `right` samples after it. */
static void fade(const duct_library *library, const duct_columns *columns, const size_t *chosen, size_t i,
                 size_t left, size_t right, duct_gesture *gestures)
{
    const duct_candidate *a = &columns->items[chosen[i]], *b = &columns->items[chosen[i + 1]];
    for (size_t q = i + 1 - left; q <= i + right; q++) {
        double share = (double)(q - (i + 1 - left) + 1) / (double)(left + right + 1);
        duct_gesture old, new;
        if (q <= i) {
            old = of_candidate(library, &columns->items[chosen[q]]);
            new = duct_gesture_of(library, b->sample - (uint32_t)(i + 1 - q), b->stroke);
        } else {
            old = duct_gesture_of(library, a->sample + (uint32_t)(q - i), a->stroke);
            new = of_candidate(library, &columns->items[chosen[q]]);
        }
        duct_gesture mixed = {0, 0, 0, 0, 0, 0, 0};
        gestures[q] = add(add(mixed, old, 1 - share), new, share);
    }
}

void duct_gestures_sequence(const duct_library *library, const duct_columns *columns, const size_t *chosen,
                            size_t blend, duct_gesture *gestures)
{
    for (size_t i = 0; i < columns->count; i++) {
        gestures[i] = of_candidate(library, &columns->items[chosen[i]]);
    }
    size_t begin = 0; /* of the segment that ends at the jump */
    for (size_t i = 0; i + 1 < columns->count; i++) {
        if (!duct_is_jump(columns, chosen, i)) {
            continue;
        }
        size_t end = i + 1; /* past the end of the segment that begins after it */
        while (end + 1 < columns->count && !duct_is_jump(columns, chosen, end)) {
            end++;
        }
        end++;
        const duct_candidate *a = &columns->items[chosen[i]], *b = &columns->items[chosen[i + 1]];
        size_t before_b = b->sample - library->starts[b->stroke];
        size_t after_a = library->starts[a->stroke + 1] - 1 - a->sample;
        /* The first half of a segment belongs to the jump before it, the second half to the one behind it. */
        size_t half_left = begin == 0 ? i + 1 : (i + 1 - begin) / 2;
        size_t half_right = end == columns->count ? end - i - 1 : (end - i - 1) - (end - i - 1) / 2;
        size_t left = least(blend, before_b, half_left), right = least(blend, after_a, half_right);
        if (left + right > 0) {
            fade(library, columns, chosen, i, left, right, gestures);
        }
        begin = i + 1;
    }
}
