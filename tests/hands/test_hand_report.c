/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The built-in hands are as consistent as people are, by the report of section 3.1. The range of people is
 * that of the paper's 18 pages of English handwriting, which
 *
 *     for page in ../shared/data/helpinghand/{Brenda,Chika,Linjie,Neeraj,Steve}English?.cyn; do
 *       build/release/bin/ductus library report $page
 *     done
 *
 * prints: similar pairs 0.555 (NeerajEnglish1) to 0.860 (ChikaEnglish2), random pairs 0.041 (LinjieEnglish1)
 * to 0.235 (SteveEnglish1). */
#include "testing.h"

#include "style.h"

#include <ductus/ductus.h>

static const double least_similar = 0.555, most_similar = 0.860, least_random = 0.041, most_random = 0.235;

static duct_error error;

static duct_correlation report_of(const char *name)
{
    duct_library *library = NULL;
    duct_report *report = NULL;
    assert_ok(duct_library_open(NULL, name, &library, &error));
    const duct_library *list[] = {library};
    assert_ok(duct_library_report(NULL, list, 1, NULL, &report, &error));
    const duct_correlation all = duct_report_between(report, 0, 0)->together;
    duct_report_free(report);
    duct_library_free(library);
    return all;
}

static void built_in_hands_correlate_as_recorded_ones_do(void **state)
{
    (void)state;
    int outside = 0;
    for (size_t i = 0; i < hand_style_count; i++) {
        const duct_correlation all = report_of(hand_styles[i]->name);
        const bool within = all.similar >= least_similar && all.similar <= most_similar &&
                            all.random >= least_random && all.random <= most_random;
        print_message("%s: similar %.3f, random %.3f%s\n", hand_styles[i]->name, all.similar, all.random,
                      within ? "" : ", outside the range of recorded hands");
        outside += !within;
    }
    assert_int_equal(outside, 0);
}

/* The pages at the range's ends, so that a report that measures otherwise cannot keep the old range. */
static void the_range_is_that_of_the_recordings(void **state)
{
    (void)state;
    const char *data = shared_data();
    static const struct {
        const char *page;
        double similar, random;
    } ends[] = {{"NeerajEnglish1", 0.555, 0.149},
                {"ChikaEnglish2", 0.860, 0.137},
                {"LinjieEnglish1", 0.733, 0.041},
                {"SteveEnglish1", 0.641, 0.235}};
    for (size_t i = 0; data != NULL && i < sizeof ends / sizeof *ends; i++) {
        char path[4200];
        snprintf(path, sizeof path, "%s/helpinghand/%s.cyn", data, ends[i].page);
        const duct_correlation all = report_of(path);
        assert_float_equal(all.similar, ends[i].similar, 0.0011);
        assert_float_equal(all.random, ends[i].random, 0.0011);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(built_in_hands_correlate_as_recorded_ones_do),
        cmocka_unit_test(the_range_is_that_of_the_recordings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
