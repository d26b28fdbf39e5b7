/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "diagram/palette.h"

#include <math.h>

static double linear(float value)
{
    return value <= 0.04045F ? (double)value / 12.92 : pow(((double)value + 0.055) / 1.055, 2.4);
}

/* Relative luminance (IEC 61966-2-1). */
static double luminance(duct_ink ink)
{
    return 0.2126 * linear(ink.red) + 0.7152 * linear(ink.green) + 0.0722 * linear(ink.blue);
}

/* About how a colour looks without green cones: the mean of red and green, after Vienot, Brettel and Mollon
 * 1999. */
static double distance_without_green(duct_ink a, duct_ink b)
{
    double warm = 0.29275 * (linear(a.red) - linear(b.red)) + 0.70725 * (linear(a.green) - linear(b.green));
    double blue = linear(a.blue) - linear(b.blue);
    return hypot(warm, blue);
}

static void the_usual_palette_gets_lighter_step_by_step(void **state)
{
    (void)state;
    double before = -1;
    for (int i = 0; i < DUCT_PALETTE_STEPS; i++) {
        duct_ink ink = duct_palette_ink(DUCT_PALETTE_VIOLET_YELLOW, (double)i / (DUCT_PALETTE_STEPS - 1));
        assert_true(luminance(ink) > before);
        before = luminance(ink);
        assert_true(ink.red >= 0 && ink.red <= 1 && ink.green >= 0 && ink.green <= 1);
        assert_true(ink.blue >= 0 && ink.blue <= 1 && ink.opacity == 1);
    }
    /* The light end still shows on white. */
    assert_true(1.05 / (before + 0.05) > 1.5);
}

static void the_paper_palette_goes_from_blue_to_red(void **state)
{
    (void)state;
    duct_ink low = duct_palette_ink(DUCT_PALETTE_BLUE_RED, 0),
             high = duct_palette_ink(DUCT_PALETTE_BLUE_RED, 1);
    assert_true(low.blue > 0.7F && low.red < 0.3F);
    assert_true(high.red > 0.7F && high.blue < 0.3F);
}

static void values_outside_are_cut_off(void **state)
{
    (void)state;
    for (int p = 0; p < 2; p++) {
        duct_diagram_palette palette = (duct_diagram_palette)p;
        duct_ink low = duct_palette_ink(palette, -5), first = duct_palette_ink(palette, 0);
        duct_ink high = duct_palette_ink(palette, 1e300), last = duct_palette_ink(palette, 1);
        assert_memory_equal(&low, &first, sizeof low);
        assert_memory_equal(&high, &last, sizeof high);
        duct_ink none = duct_palette_ink(palette, NAN);
        assert_true(none.red >= 0 && none.red <= 1);
    }
}

static void neighbouring_categories_differ_without_green_too(void **state)
{
    (void)state;
    for (size_t i = 0; i < 10; i++) {
        duct_ink ink = duct_palette_category(i), next = duct_palette_category(i + 1);
        assert_true(distance_without_green(ink, next) > 0.1);
        for (size_t j = 0; j < i; j++) {
            duct_ink other = duct_palette_category(j);
            assert_memory_not_equal(&ink, &other, sizeof ink);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_usual_palette_gets_lighter_step_by_step),
        cmocka_unit_test(the_paper_palette_goes_from_blue_to_red),
        cmocka_unit_test(values_outside_are_cut_off),
        cmocka_unit_test(neighbouring_categories_differ_without_green_too),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
