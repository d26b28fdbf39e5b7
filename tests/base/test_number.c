/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/number.h"

#include <ductus/random.h>

#include <locale.h>
#include <math.h>

static void reads_decimal_numbers_and_stops_behind_them(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double value;
        const char *rest;
    } good[] = {{"1", 1, ""},
                {"-1.5e2x", -150, "x"},
                {"+.5,", 0.5, ","},
                {"5.", 5, ""},
                {"1e", 1, "e"},
                {"1e+", 1, "e+"},
                {"0x10", 0, "x10"},
                {"1-2", 1, "-2"},
                {"1.2.3", 1.2, ".3"},
                {"007", 7, ""},
                {"1,5", 1, ",5"},
                {"-0", 0, ""},
                {"123456789012345678901234567890", 123456789012345678901234567890.0, ""},
                {"0.1000000000000000055511151231257827", 0.1, ""},
                {"4.9e-324", 4.9e-324, ""}};
    for (size_t i = 0; i < sizeof good / sizeof good[0]; i++) {
        const char *end = NULL;
        double value = -99;
        assert_true(duct_number_scan(good[i].text, &end, &value));
        assert_true(value == good[i].value);
        assert_string_equal(end, good[i].rest);
    }
    static const char *const bad[] = {"", "-", "+", ".", "e5", " 1", "inf", "nan", "-.e1", "NaN", "infinity"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        const char *end = NULL;
        double value = -99;
        assert_false(duct_number_scan(bad[i], &end, &value));
        assert_true(value == -99 && end == NULL);
    }
}

static void parse_takes_whole_finite_texts_only(void **state)
{
    (void)state;
    double value = 0;
    assert_true(duct_number_parse(" \t1.25\r\n", &value) && value == 1.25);
    static const char *const bad[] = {"", "1 2", "1x", "1e999", "-1e999", "inf", "nan", "0x1"};
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        value = -99;
        assert_false(duct_number_parse(bad[i], &value));
        assert_true(value == -99);
    }
}

static void shortest_digits_read_back_to_the_same_number(void **state)
{
    (void)state;
    char buffer[DUCT_NUMBER_SIZE];
    for (uint64_t i = 0; i < 20000; i++) {
        uint64_t bits = duct_random_bits(1, i, 0, 0);
        double value, back;
        memcpy(&value, &bits, sizeof value);
        if (!isfinite(value)) {
            continue;
        }
        duct_number_print(buffer, value, 0);
        assert_true(duct_number_parse(buffer, &back));
        assert_true(back == value);
    }
    duct_number_print(buffer, 0.1, 0);
    assert_string_equal(buffer, "0.1");
    duct_number_print(buffer, 1e300, 0);
    assert_string_equal(buffer, "1e+300");
}

static void fixed_digits_have_no_trailing_zeros(void **state)
{
    (void)state;
    char buffer[DUCT_NUMBER_SIZE];
    duct_number_print_fixed(buffer, 1.5, 3);
    assert_string_equal(buffer, "1.5");
    duct_number_print_fixed(buffer, -0.0001, 3);
    assert_string_equal(buffer, "0");
    duct_number_print_fixed(buffer, 100, 0);
    assert_string_equal(buffer, "100");
    duct_number_print_fixed(buffer, 100, 2);
    assert_string_equal(buffer, "100");
    duct_number_print_fixed(buffer, -1.7976931348623157e308, 17);
    assert_int_equal(strlen(buffer), 310);
}

static void the_locale_does_not_matter(void **state)
{
    (void)state;
    static const char *const names[] = {"de_DE.UTF-8", "de_DE.utf8", "fr_FR.UTF-8", "de_DE"};
    const char *set = NULL;
    for (size_t i = 0; i < 4 && set == NULL; i++) {
        set = setlocale(LC_ALL, names[i]);
    }
    if (set == NULL) {
        print_message("skipped: no locale with a decimal comma is installed\n");
        skip();
    }
    char buffer[DUCT_NUMBER_SIZE];
    double value = 0;
    duct_number_print(buffer, 1234.5, 0);
    assert_string_equal(buffer, "1234.5");
    duct_number_print_fixed(buffer, 1234.5, 2);
    assert_string_equal(buffer, "1234.5");
    assert_true(duct_number_parse("1.5e1", &value) && value == 15);
    assert_true(duct_number_parse("0.12345678901234567", &value) && value == 0.12345678901234567);
    assert_string_equal(setlocale(LC_ALL, NULL), set);
    setlocale(LC_ALL, "C");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_decimal_numbers_and_stops_behind_them),
        cmocka_unit_test(parse_takes_whole_finite_texts_only),
        cmocka_unit_test(shortest_digits_read_back_to_the_same_number),
        cmocka_unit_test(fixed_digits_have_no_trailing_zeros),
        cmocka_unit_test(the_locale_does_not_matter),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
