/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "page.h"

#include <ductus/ductus.h>

#include <ctype.h>
#include <math.h>

static duct_error error;

/* What the built-in hands are, to the last sample, whatever the compiler and its optimisation. A hand that is
 * changed on purpose changes its number here. */
static const struct {
    const char *name;
    uint64_t fingerprint;
} known_hands[] = {
    {"anna", 0x6c8d7c73e53ed415},  {"bruno", 0xa3262d387f69fed5}, {"clara", 0x1942283f31f089de},
    {"david", 0x5cf3ec1771ed85a9}, {"eve", 0x5a98bd7ad5ab85ee},
};

static duct_drawing *make_page(const hand_style *style)
{
    duct_drawing *page = NULL;
    assert_ok(page_make(NULL, style, &page, &error));
    return page;
}

static uint64_t fingerprint(const duct_drawing *page)
{
    uint64_t hash = 0xcbf29ce484222325u;
    for (size_t s = 0; s < duct_drawing_stroke_count(page); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(page, s);
        for (int channel = 0; channel < DUCT_CHANNEL_COUNT; channel++) {
            const double *values = duct_stroke_values(stroke, (duct_channel)channel);
            for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
                hash = (hash ^ (uint64_t)llround(values[k] * 1e5)) * 0x100000001b3u;
            }
        }
    }
    return hash;
}

static void styles_have_names_of_their_own(void **state)
{
    (void)state;
    assert_true(hand_style_count >= 1);
    for (size_t i = 0; i < hand_style_count; i++) {
        assert_ptr_equal(hand_style_find(hand_styles[i]->name), hand_styles[i]);
    }
    assert_null(hand_style_find("nobody"));
}

static void pages_hold_text_and_drawing_strokes(void **state)
{
    (void)state;
    for (size_t i = 0; i < hand_style_count; i++) {
        duct_drawing *page = make_page(hand_styles[i]);
        size_t text = 0, drawing = 0;
        const size_t count = duct_drawing_stroke_count(page);
        for (size_t s = 0; s < count; s++) {
            const char *group = duct_stroke_group(duct_drawing_stroke(page, s));
            text += strcmp(group, "text") == 0;
            drawing += strcmp(group, "drawing") == 0;
        }
        assert_int_equal(text + drawing, count);
        assert_true(count >= 150 && count <= 300);
        assert_true(text >= 80);
        assert_true(drawing >= 100);
        assert_string_equal(duct_drawing_annotation(page, "name"), hand_styles[i]->name);
        assert_string_equal(duct_drawing_annotation(page, "synthetic"), "true");
        assert_string_equal(duct_drawing_annotation(page, "artist"), "Ductus generator (synthetic)");
        assert_string_equal(duct_drawing_annotation(page, "licence"), "GPL-3.0-or-later");
        duct_drawing_free(page);
    }
}

static void pages_hold_every_letter_digit_and_mark(void **state)
{
    (void)state;
    for (size_t i = 0; i < hand_style_count; i++) {
        int seen[256] = {0};
        for (const char *const *line = hand_styles[i]->lines; *line != NULL; line++) {
            for (const char *c = *line; *c != '\0'; c++) {
                seen[(unsigned char)*c]++;
                assert_true(*c == ' ' || alphabet_find(hand_styles[i]->letters, *c) != NULL);
            }
        }
        for (int c = 'a'; c <= 'z'; c++) {
            assert_true(seen[c] >= 2);
            assert_true(seen[toupper(c)] >= 1);
        }
        for (const char *c = "0123456789.,'-!?"; *c != '\0'; c++) {
            assert_true(seen[(unsigned char)*c] >= 1);
        }
    }
}

static void channels_keep_their_ranges(void **state)
{
    (void)state;
    for (size_t i = 0; i < hand_style_count; i++) {
        duct_drawing *page = make_page(hand_styles[i]);
        double clock = -1;
        for (size_t s = 0; s < duct_drawing_stroke_count(page); s++) {
            const duct_stroke *stroke = duct_drawing_stroke(page, s);
            const double *v[DUCT_CHANNEL_COUNT];
            for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
                v[c] = duct_stroke_values(stroke, (duct_channel)c);
                assert_non_null(v[c]);
            }
            assert_true(duct_stroke_size(stroke) >= 2);
            for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
                assert_true(v[DUCT_X][k] >= 0 && v[DUCT_X][k] <= PAGE_SIDE);
                assert_true(v[DUCT_Y][k] >= 0 && v[DUCT_Y][k] <= PAGE_SIDE);
                assert_true(v[DUCT_PRESSURE][k] > 0 && v[DUCT_PRESSURE][k] < 1);
                assert_true(fabs(v[DUCT_TILT_X][k]) < M_PI / 3);
                assert_true(fabs(v[DUCT_TILT_Y][k]) < M_PI / 3);
                assert_true(fabs(v[DUCT_TWIST][k]) < M_PI);
                assert_true(v[DUCT_T][k] > clock);
                if (k > 0) {
                    assert_true(fabs(v[DUCT_T][k] - clock - (1.0 / MOTION_RATE)) <= 2e-5);
                    assert_true(fabs(v[DUCT_TWIST][k] - v[DUCT_TWIST][k - 1]) < 0.1);
                }
                clock = v[DUCT_T][k];
            }
        }
        duct_drawing_free(page);
    }
}

static void pose_is_like_that_of_recorded_hands(void **state)
{
    (void)state;
    for (size_t i = 0; i < hand_style_count; i++) {
        duct_drawing *page = make_page(hand_styles[i]);
        double sums[DUCT_CHANNEL_COUNT] = {0}, squares[DUCT_CHANNEL_COUNT] = {0}, samples = 0, first = 0;
        const size_t count = duct_drawing_stroke_count(page);
        for (size_t s = 0; s < count; s++) {
            const duct_stroke *stroke = duct_drawing_stroke(page, s);
            const size_t size = duct_stroke_size(stroke);
            for (int c = DUCT_PRESSURE; c <= DUCT_TWIST; c++) {
                for (size_t k = 0; k < size; k++) {
                    const double value = duct_stroke_values(stroke, (duct_channel)c)[k];
                    sums[c] += value;
                    squares[c] += value * value;
                }
            }
            samples += (double)size;
            first += duct_stroke_values(stroke, DUCT_PRESSURE)[0];
        }
        double deviation[DUCT_CHANNEL_COUNT];
        for (int c = DUCT_PRESSURE; c <= DUCT_TWIST; c++) {
            sums[c] /= samples;
            deviation[c] = sqrt(squares[c] / samples - sums[c] * sums[c]);
        }
        const double degree = M_PI / 180;
        assert_in_range(sums[DUCT_PRESSURE] * 100, 35, 72);
        assert_in_range(deviation[DUCT_PRESSURE] * 100, 7, 25);
        assert_in_range(first / (double)count * 100, 5, 65);
        assert_true(fabs(sums[DUCT_TILT_X]) < 40 * degree && fabs(sums[DUCT_TILT_Y]) < 35 * degree);
        assert_in_range(deviation[DUCT_TILT_X] / degree * 10, 10, 70);
        assert_in_range(deviation[DUCT_TILT_Y] / degree * 10, 10, 70);
        assert_in_range(deviation[DUCT_TWIST] / degree, 5, 25);
        duct_drawing_free(page);
    }
}

/* Mean pressure, tilt and twist, and median-like speed of a hand, each in steps that can be seen. */
static void character(const hand_style *style, double traits[5])
{
    duct_drawing *page = make_page(style);
    double samples = 0, way = 0, time = 0;
    memset(traits, 0, 5 * sizeof *traits);
    for (size_t s = 0; s < duct_drawing_stroke_count(page); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(page, s);
        const double *v[DUCT_CHANNEL_COUNT];
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            v[c] = duct_stroke_values(stroke, (duct_channel)c);
        }
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            traits[0] += v[DUCT_PRESSURE][k] / 0.1;
            traits[1] += v[DUCT_TILT_X][k] / 0.15;
            traits[2] += v[DUCT_TILT_Y][k] / 0.15;
            traits[3] += v[DUCT_TWIST][k] / 0.3;
            samples++;
            if (k > 0) {
                way += hypot(v[DUCT_X][k] - v[DUCT_X][k - 1], v[DUCT_Y][k] - v[DUCT_Y][k - 1]);
                time += v[DUCT_T][k] - v[DUCT_T][k - 1];
            }
        }
    }
    for (int i = 0; i < 4; i++) {
        traits[i] /= samples;
    }
    traits[4] = log(way / time) / 0.3;
    duct_drawing_free(page);
}

static void hands_are_clearly_different(void **state)
{
    (void)state;
    double traits[8][5];
    assert_true(hand_style_count <= 8);
    for (size_t i = 0; i < hand_style_count; i++) {
        character(hand_styles[i], traits[i]);
        for (size_t j = 0; j < i; j++) {
            int apart = 0;
            for (int k = 0; k < 5; k++) {
                apart += fabs(traits[i][k] - traits[j][k]) >= 1;
            }
            if (apart < 2) {
                fail_msg("%s and %s are alike", hand_styles[i]->name, hand_styles[j]->name);
            }
        }
    }
}

static void lines_of_text_are_written_without_drawing(void **state)
{
    (void)state;
    duct_drawing *page = NULL;
    assert_ok(page_write_line(NULL, hand_styles[1], "it", &page, &error));
    assert_int_equal(duct_drawing_stroke_count(page), 4);
    duct_drawing_free(page);
    page = NULL;
    assert_int_equal(page_write_line(NULL, hand_styles[1], "#", &page, &error), DUCT_BAD_ARGUMENT);
    assert_null(page);
}

/* Within a page of the HelpingHand recordings, `ductus library report
 * ../shared/data/helpinghand/[A-Z]*English*.cyn` gives these correlations from pen to pen. A made hand must
 * not follow its shapes more strictly than people do, nor more loosely. */
static void pose_follows_shapes_as_far_as_that_of_recorded_hands(void **state)
{
    (void)state;
    const double similar[2] = {0.50, 0.82}, random[2] = {0.03, 0.21};
    for (size_t i = 0; i < hand_style_count; i++) {
        const duct_drawing *page = make_page(hand_styles[i]);
        duct_library *library = NULL;
        duct_report *report = NULL;
        assert_ok(duct_library_build(NULL, &page, 1, NULL, &library, &error));
        const duct_library *const libraries[] = {library};
        assert_ok(duct_library_report(NULL, libraries, 1, NULL, &report, &error));
        const duct_correlation *all = &duct_report_between(report, 0, 0)->together;
        print_message("%s: similar %.3f, random %.3f\n", hand_styles[i]->name, all->similar, all->random);
        assert_true(all->similar > similar[0] && all->similar < similar[1]);
        assert_true(all->random > random[0] && all->random < random[1]);
        duct_report_free(report);
        duct_library_free(library);
        duct_drawing_free((duct_drawing *)page);
    }
}

/* The slope of ln(speed) over ln(curvature), from inner samples that curve and move. */
static double power_law(const duct_drawing *page)
{
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (size_t s = 0; s < duct_drawing_stroke_count(page); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(page, s);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        for (size_t k = 4; k + 4 < duct_stroke_size(stroke); k++) {
            const double ax = x[k] - x[k - 2], ay = y[k] - y[k - 2];
            const double bx = x[k + 2] - x[k], by = y[k + 2] - y[k];
            const double length = (hypot(ax, ay) + hypot(bx, by)) / 2;
            const double turn = fabs(atan2(ax * by - ay * bx, ax * bx + ay * by));
            if (length < 1 || turn < 0.02 || turn > 2) {
                continue;
            }
            const double u = log(turn / length), v = log(length);
            n++;
            sx += u;
            sy += v;
            sxx += u * u;
            sxy += u * v;
        }
    }
    assert_true(n > 1000);
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

static void pen_slows_down_in_curves(void **state)
{
    (void)state;
    for (size_t i = 0; i < hand_style_count; i++) {
        duct_drawing *page = make_page(hand_styles[i]);
        /* People's is about -1/3. */
        const double slope = power_law(page);
        print_message("%s: speed goes with curvature to the power %.2f\n", hand_styles[i]->name, slope);
        assert_true(slope < -0.2 && slope > -0.55);
        duct_drawing_free(page);
    }
}

static void pages_are_the_same_bytes_each_time(void **state)
{
    (void)state;
    int unknown = 0, changed = 0;
    for (size_t i = 0; i < hand_style_count; i++) {
        duct_drawing *a = make_page(hand_styles[i]);
        duct_drawing *b = make_page(hand_styles[i]);
        char *text[2] = {NULL, NULL};
        size_t size[2];
        assert_ok(duct_drawing_write_memory(NULL, a, "inkml", NULL, &text[0], &size[0], &error));
        assert_ok(duct_drawing_write_memory(NULL, b, "inkml", NULL, &text[1], &size[1], &error));
        assert_int_equal(size[0], size[1]);
        assert_memory_equal(text[0], text[1], size[0]);
        bool known = false, same = false;
        for (size_t k = 0; k < sizeof known_hands / sizeof known_hands[0]; k++) {
            if (strcmp(known_hands[k].name, hand_styles[i]->name) == 0) {
                known = true;
                same = fingerprint(a) == known_hands[k].fingerprint;
            }
        }
        print_message("%s has the fingerprint 0x%016llx\n", hand_styles[i]->name,
                      (unsigned long long)fingerprint(a));
        unknown += !known;
        changed += !same;
        duct_memory_free(NULL, text[0]);
        duct_memory_free(NULL, text[1]);
        duct_drawing_free(a);
        duct_drawing_free(b);
    }
    assert_int_equal(unknown, 0);
    assert_int_equal(changed, 0);
}

static void another_seed_gives_another_page(void **state)
{
    (void)state;
    hand_style style = *hand_styles[0];
    style.seed++;
    duct_drawing *a = make_page(hand_styles[0]);
    duct_drawing *b = make_page(&style);
    assert_true(fingerprint(a) != fingerprint(b));
    duct_drawing_free(a);
    duct_drawing_free(b);
}

static void unknown_letters_are_named(void **state)
{
    (void)state;
    static const char *const lines[] = {"a%b", NULL};
    hand_style style = *hand_styles[0];
    style.lines = lines;
    duct_drawing *page = NULL;
    assert_int_equal(page_make(NULL, &style, &page, &error), DUCT_BAD_ARGUMENT);
    assert_non_null(strstr(error.message, "'%'"));
    assert_null(page);
    assert_int_equal(page_make(NULL, &style, &page, NULL), DUCT_BAD_ARGUMENT);
}

static void failing_allocations_leak_nothing(void **state)
{
    (void)state;
    static const char *const lines[] = {"Ai", NULL};
    hand_style style = *hand_styles[0];
    style.lines = lines;
    bool made = false;
    for (long n = 1; !made; n += n < 40 ? 1 : 29) {
        failing_allocator memory;
        failing_init(&memory, n);
        duct_context context = duct_context_default();
        context.allocator = &memory.allocator;
        duct_drawing *page = NULL;
        const duct_status status = page_make(&context, &style, &page, &error);
        made = memory.calls < n;
        assert_int_equal(status, made ? DUCT_OK : DUCT_NO_MEMORY);
        duct_drawing_free(page);
        assert_int_equal(memory.held, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(styles_have_names_of_their_own),
        cmocka_unit_test(pages_hold_text_and_drawing_strokes),
        cmocka_unit_test(pages_hold_every_letter_digit_and_mark),
        cmocka_unit_test(channels_keep_their_ranges),
        cmocka_unit_test(pose_is_like_that_of_recorded_hands),
        cmocka_unit_test(pose_follows_shapes_as_far_as_that_of_recorded_hands),
        cmocka_unit_test(hands_are_clearly_different),
        cmocka_unit_test(lines_of_text_are_written_without_drawing),
        cmocka_unit_test(pen_slows_down_in_curves),
        cmocka_unit_test(pages_are_the_same_bytes_each_time),
        cmocka_unit_test(another_seed_gives_another_page),
        cmocka_unit_test(unknown_letters_are_named),
        cmocka_unit_test(failing_allocations_leak_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
