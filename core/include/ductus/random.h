/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_RANDOM_H
#define DUCTUS_RANDOM_H

#include <ductus/export.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Addressable random numbers: each number is a function of (seed, stroke id, sample, purpose) and of nothing
 * else. There is no state, so the order of calls, the number of threads and the other strokes of a drawing
 * cannot change a result, and editing one stroke never re-rolls the rest. */

/* A stroke's identity as a number: the 64-bit FNV-1a hash of the id text. NULL counts as "". */
DUCT_API uint64_t duct_random_id(const char *stroke_id);

/* 64 uniform bits. `sample` is a sample's or candidate's index; `purpose` tells apart the uses of randomness
 * within one operation (each operation numbers its own). */
DUCT_API uint64_t duct_random_bits(uint64_t seed, uint64_t stroke, uint64_t sample, uint64_t purpose);

/* Uniform in [0, 1). */
DUCT_API double duct_random_uniform(uint64_t seed, uint64_t stroke, uint64_t sample, uint64_t purpose);

/* Normal with mean 0 and standard deviation 1 (Box-Muller). */
DUCT_API double duct_random_normal(uint64_t seed, uint64_t stroke, uint64_t sample, uint64_t purpose);

#ifdef __cplusplus
}
#endif

#endif
