/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <ductus/random.h>

#include <math.h>
#include <stddef.h>

uint64_t duct_random_id(const char *stroke_id)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (const char *s = stroke_id; s != NULL && *s != '\0'; s++) {
        hash = (hash ^ (unsigned char)*s) * 0x100000001b3u;
    }
    return hash;
}

/* The finaliser of SplitMix64 (Steele, Lea, Flood 2014): a bijection that changes about half of all bits for
 * any change of its input. */
static uint64_t mix(uint64_t z)
{
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

uint64_t duct_random_bits(uint64_t seed, uint64_t stroke, uint64_t sample, uint64_t purpose)
{
    const uint64_t golden = 0x9e3779b97f4a7c15u;
    uint64_t hash = mix(seed + golden);
    hash = mix((hash ^ stroke) + golden);
    hash = mix((hash ^ sample) + golden);
    return mix((hash ^ purpose) + golden);
}

double duct_random_uniform(uint64_t seed, uint64_t stroke, uint64_t sample, uint64_t purpose)
{
    return (double)(duct_random_bits(seed, stroke, sample, purpose) >> 11) * 0x1p-53;
}

double duct_random_normal(uint64_t seed, uint64_t stroke, uint64_t sample, uint64_t purpose)
{
    uint64_t bits = duct_random_bits(seed, stroke, sample, purpose);
    double radius = ((double)(bits >> 11) + 1) * 0x1p-53; /* in (0, 1]: its logarithm is finite */
    double angle = (double)(mix(bits + 0x9e3779b97f4a7c15u) >> 11) * 0x1p-53 * 6.283185307179586;
    return sqrt(-2 * log(radius)) * cos(angle);
}
