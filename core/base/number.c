/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/number.h"

#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The C locale object; made once, never changed, kept for the life of the process. */
static locale_t c_locale;
static pthread_once_t c_locale_once = PTHREAD_ONCE_INIT;

static void make_c_locale(void)
{
    c_locale = newlocale(LC_ALL_MASK, "C", (locale_t)0);
}

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

/* The end of the number's text by its grammar, or NULL. strtod alone would accept too much. */
static const char *number_end(const char *text)
{
    const char *s = text;
    if (*s == '+' || *s == '-') {
        s++;
    }
    bool digits = false;
    while (is_digit(*s)) {
        digits = true;
        s++;
    }
    if (*s == '.') {
        s++;
        while (is_digit(*s)) {
            digits = true;
            s++;
        }
    }
    if (!digits) {
        return NULL;
    }
    if (*s == 'e' || *s == 'E') {
        const char *e = s + 1;
        if (*e == '+' || *e == '-') {
            e++;
        }
        if (is_digit(*e)) {
            while (is_digit(*e)) {
                e++;
            }
            s = e;
        }
    }
    return s;
}

/* Most numbers in drawings are short decimals: fifteen digits and a small power of ten are exact in a double,
 * and so is their quotient, correctly rounded. */
static bool scan_short(const char *text, const char *end, double *number)
{
    static const double power[] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                   1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const char *s = text;
    bool negative = *s == '-';
    if (*s == '+' || *s == '-') {
        s++;
    }
    double mantissa = 0;
    int digits = 0, decimals = 0;
    bool behind = false;
    for (; s < end; s++) {
        if (*s == '.') {
            behind = true;
        } else if (is_digit(*s)) {
            mantissa = mantissa * 10 + (*s - '0');
            digits++;
            decimals += behind;
        } else {
            return false;
        }
    }
    if (digits > 15) {
        return false;
    }
    mantissa /= power[decimals];
    *number = negative ? -mantissa : mantissa;
    return true;
}

bool duct_number_scan(const char *text, const char **end, double *number)
{
    const char *last = number_end(text);
    if (last == NULL) {
        return false;
    }
    if (!scan_short(text, last, number)) {
        pthread_once(&c_locale_once, make_c_locale);
        /* A '0x' prefix cannot reach strtod: number_end() would have stopped at the 'x', and strtod is only
         * believed where it stops at the same place. */
        char *stop;
        double value = strtod_l(text, &stop, c_locale);
        if (stop != last) {
            value = *text == '-' ? -0.0 : 0.0;
        }
        *number = value;
    }
    *end = last;
    return true;
}

bool duct_number_parse(const char *text, double *number)
{
    text += strspn(text, " \t\r\n");
    const char *end;
    double value;
    if (!duct_number_scan(text, &end, &value) || !isfinite(value)) {
        return false;
    }
    if (end[strspn(end, " \t\r\n")] != '\0') {
        return false;
    }
    *number = value;
    return true;
}

static void print(char buffer[DUCT_NUMBER_SIZE], const char *format, int precision, double number)
{
    pthread_once(&c_locale_once, make_c_locale);
    locale_t old = uselocale(c_locale);
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wformat-nonliteral"
    snprintf(buffer, DUCT_NUMBER_SIZE, format, precision, number);
#pragma GCC diagnostic pop
    uselocale(old);
}

void duct_number_print(char buffer[DUCT_NUMBER_SIZE], double number, int digits)
{
    if (digits > 0) {
        print(buffer, "%.*g", digits, number);
        return;
    }
    for (digits = 15; digits <= 17; digits++) {
        const char *end;
        double back;
        print(buffer, "%.*g", digits, number);
        if (duct_number_scan(buffer, &end, &back) && back == number) {
            return;
        }
    }
}

void duct_number_print_fixed(char buffer[DUCT_NUMBER_SIZE], double number, int decimals)
{
    print(buffer, "%.*f", decimals, number);
    if (strchr(buffer, '.') != NULL) {
        size_t length = strlen(buffer);
        while (buffer[length - 1] == '0') {
            length--;
        }
        if (buffer[length - 1] == '.') {
            length--;
        }
        buffer[length] = '\0';
    }
    if (strcmp(buffer, "-0") == 0) {
        strcpy(buffer, "0");
    }
}
