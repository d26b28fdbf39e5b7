/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_NUMBER_H
#define DUCTUS_BASE_NUMBER_H

#include <stdbool.h>

/* Numbers as text, the same in every locale: host programs set LC_NUMERIC. */

enum { DUCT_NUMBER_SIZE = 400 };

/* Reads the longest decimal number at `text` and points `end` behind it; false where there is none. Leading
 * spaces, hexadecimal, "inf" and "nan" are not numbers. Overflow gives an infinity. */
bool duct_number_scan(const char *text, const char **end, double *number);

/* True where the whole text (spaces around it allowed) is one finite number. */
bool duct_number_parse(const char *text, double *number);

/* Prints with at most `digits` significant digits, 1..17; 0: as few as read back to the same number. */
void duct_number_print(char buffer[DUCT_NUMBER_SIZE], double number, int digits);

/* Prints with at most `decimals` digits behind the point, without trailing zeros. */
void duct_number_print_fixed(char buffer[DUCT_NUMBER_SIZE], double number, int decimals);

#endif
