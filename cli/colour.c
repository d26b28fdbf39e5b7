/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "colour.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const struct {
    const char *name;
    unsigned long rgba;
} NAMES[] = {
    {"none", 0x00000000},  {"transparent", 0x00000000}, {"white", 0xffffffff}, {"black", 0x000000ff},
    {"grey", 0x808080ff},  {"gray", 0x808080ff},        {"red", 0xff0000ff},   {"green", 0x008000ff},
    {"blue", 0x0000ffff},  {"yellow", 0xffff00ff},      {"cyan", 0x00ffffff},  {"magenta", 0xff00ffff},
    {"ivory", 0xfffff0ff}, {"beige", 0xf5f5dcff},       {"navy", 0x000080ff},
};

static void unpack(unsigned long rgba, float colour[4])
{
    for (int i = 0; i < 4; i++) {
        colour[i] = (float)((rgba >> (24 - 8 * i)) & 0xff) / 255.0F;
    }
}

bool cli_colour_parse(const char *text, float colour[4])
{
    for (size_t i = 0; i < sizeof NAMES / sizeof *NAMES; i++) {
        if (strcasecmp(text, NAMES[i].name) == 0) {
            unpack(NAMES[i].rgba, colour);
            return true;
        }
    }
    size_t digits = text[0] == '#' ? strlen(text + 1) : 0;
    if (digits == 0 || strspn(text + 1, "0123456789abcdefABCDEF") != digits) {
        return false;
    }
    unsigned long value = strtoul(text + 1, NULL, 16);
    if (digits == 3) {
        unpack(((value & 0xf00) * 17) << 16 | ((value & 0xf0) * 17) << 12 | ((value & 0xf) * 17) << 8 | 0xff,
               colour);
    } else if (digits == 6) {
        unpack(value << 8 | 0xff, colour);
    } else if (digits == 8) {
        unpack(value, colour);
    } else {
        return false;
    }
    return true;
}
