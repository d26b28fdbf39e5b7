/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_WIDE_H
#define DUCTUS_BASE_WIDE_H

/* A function that is compiled for wide vectors as well, and chosen when the program starts by what the
 * processor has. Both do the same operations on each number in the same order, without fused multiply-add, so
 * both give the same bits; the sanitizer build has the portable one alone, and script/test compares the two
 * builds. DUCTUS_NARROW leaves the wide one out. For static functions: of others GCC exports the clones,
 * whatever their visibility. */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__clang__) && \
    !defined(DUCTUS_NARROW)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

/* Part of the function that it is used in, whatever that is compiled for. */
#define WIDE_PART static inline __attribute__((always_inline))

#endif
