/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "features/contexts.h"

#include <math.h>

/* Which of `most` bins hold a place counted in bins, whose centres are whole numbers: the lower one of two,
 * and the upper one's share. */
typedef struct {
    int low, high;
    double share;
} split;

static split split_ring(double distance, double reach)
{
    const int last = DUCT_CONTEXT_RINGS - 1;
    /* The outermost ring's centre lies, by the logarithm, half a doubling inside its edge. */
    double place = (double)last + 0.5 + log2(distance / reach);
    if (!(place > 0)) {
        return (split){0, 0, 0};
    }
    if (place >= (double)last) {
        return (split){last, last, 0};
    }
    int low = (int)place;
    return (split){low, low + 1, place - (double)low};
}

static split split_sector(double dx, double dy)
{
    const double sectors = (double)DUCT_CONTEXT_SECTORS;
    double place = atan2(dy, dx) * (sectors / (2 * M_PI));
    place = place < 0 ? place + sectors : place;
    int low = place < sectors ? (int)place : 0; /* a place that is not a number counts as 0 */
    double share = place < sectors ? place - (double)low : 0;
    return (split){low, (low + 1) % DUCT_CONTEXT_SECTORS, share};
}

static void add_sample(double dx, double dy, double reach, double bins[DUCT_CONTEXT_BINS])
{
    double distance = hypot(dx, dy), directed = distance < 1 ? distance : 1;
    if (directed < 1) {
        for (int s = 0; s < DUCT_CONTEXT_SECTORS; s++) {
            bins[s] += (1 - directed) / DUCT_CONTEXT_SECTORS;
        }
    }
    if (directed > 0) {
        split ring = split_ring(distance, reach), sector = split_sector(dx, dy);
        double *inner = bins + DUCT_CONTEXT_SECTORS * ring.low;
        double *outer = bins + DUCT_CONTEXT_SECTORS * ring.high;
        inner[sector.low] += directed * (1 - ring.share) * (1 - sector.share);
        inner[sector.high] += directed * (1 - ring.share) * sector.share;
        outer[sector.low] += directed * ring.share * (1 - sector.share);
        outer[sector.high] += directed * ring.share * sector.share;
    }
}

/* The histogram of the `many` samples from `i` on in one direction. */
static void histogram(const double *x, const double *y, size_t i, size_t many, int direction, double reach,
                      double weight, float *out)
{
    double bins[DUCT_CONTEXT_BINS] = {0};
    for (size_t n = 1; n <= many; n++) {
        size_t k = direction > 0 ? i + n : i - n;
        add_sample(x[k] - x[i], y[k] - y[i], reach, bins);
    }
    double factor = many > 0 ? weight * DUCT_CONTEXT_SCALE / (double)many : 0;
    for (int b = 0; b < DUCT_CONTEXT_BINS; b++) {
        out[b] = (float)(factor * bins[b]);
    }
}

void duct_context_histograms(const double *x, const double *y, size_t count, size_t i, double reach,
                             double weight, float bins[DUCT_CONTEXT_DIMENSIONS])
{
    size_t window = (size_t)floor(reach), after = count - 1 - i;
    histogram(x, y, i, i < window ? i : window, -1, reach, weight, bins);
    histogram(x, y, i, after < window ? after : window, 1, reach, weight, bins + DUCT_CONTEXT_BINS);
}
