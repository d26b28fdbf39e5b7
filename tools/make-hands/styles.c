/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "style.h"

#include <string.h>

const hand_style *const hand_styles[] = {&hand_anna, &hand_bruno, &hand_clara, &hand_david, &hand_eve};

const size_t hand_style_count = sizeof hand_styles / sizeof hand_styles[0];

const hand_style *hand_style_find(const char *name)
{
    for (size_t i = 0; i < hand_style_count; i++) {
        if (strcmp(hand_styles[i]->name, name) == 0) {
            return hand_styles[i];
        }
    }
    return NULL;
}
