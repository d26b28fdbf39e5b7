/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef MAKE_HANDS_STYLE_H
#define MAKE_HANDS_STYLE_H

#include "glyphs.h"
#include "grip.h"
#include "manner.h"

/* All that makes one hand differ from another. One file a hand (hand_*.c). */
typedef struct hand_style {
    const char *name;
    uint64_t seed;
    const char *const *lines; /* the page's text, line by line, NULL behind the last */
    const alphabet *letters;
    /* The writing. */
    double top, left, line_pitch;           /* pixels: the first baseline, the left edge, between baselines */
    double size;                            /* x-height in pixels */
    double slant;                           /* dx for one dy upwards */
    double letter_space, word_space;        /* in x-heights, added to the letters' advance; between words */
    double joining;                         /* chance that letters which can be joined are */
    double letter_jitter;                   /* of a letter's targets, in x-heights */
    double shape_jitter;                    /* of a drawing stroke's targets, as a share of its size */
    double size_jitter, slant_jitter;       /* wandering along the line: shares, dx for dy */
    double baseline_jitter, baseline_slope; /* in x-heights; dy for dx */
    motor_style writing;
    motor_style drawing;
    stroke_manner manner;
    grip_style grip;
} hand_style;

extern const hand_style hand_anna, hand_bruno, hand_clara, hand_david, hand_eve;

/* All of them (styles.c). */
extern const hand_style *const hand_styles[];
extern const size_t hand_style_count;

/* The style of that name, or NULL. */
const hand_style *hand_style_find(const char *name);

#endif
