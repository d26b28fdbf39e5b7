/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_CLI_COLOUR_H
#define DUCTUS_CLI_COLOUR_H

#include <stdbool.h>

/* Reads a colour as a user writes it: #rgb, #rrggbb, #rrggbbaa, one of a few names, or "none" (transparent).
 * Red, green, blue and alpha, 0..1, sRGB-encoded. False where it is no colour; then `colour` is untouched. */
bool cli_colour_parse(const char *text, float colour[4]);

#endif
