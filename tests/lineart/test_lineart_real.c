/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scanned pages: how much of the ink the strokes cover, painted as round lines of their width, and how much
 * they cover that is no ink. */
#include "lineart/pictures.h"

#include <ductus/image.h>

static picture grey_of(const duct_image *image)
{
    picture made = new_picture(image->width, image->height, 255);
    for (size_t i = 0; i < (size_t)image->width * (size_t)image->height; i++) {
        const float *p = image->pixels + 4 * i;
        float value = 0.2126F * p[0] + 0.7152F * p[1] + 0.0722F * p[2];
        made.grey[i] = (uint8_t)(fminf(fmaxf(value, 0), 1) * 255 + 0.5F);
    }
    return made;
}

static void cover_disc(picture *to, double x, double y, double radius)
{
    for (int py = (int)floor(y - radius); py <= (int)ceil(y + radius); py++) {
        for (int px = (int)floor(x - radius); px <= (int)ceil(x + radius); px++) {
            if (px >= 0 && py >= 0 && px < to->width && py < to->height &&
                hypot(px + 0.5 - x, py + 0.5 - y) <= radius) {
                to->grey[(size_t)py * (size_t)to->width + (size_t)px] = 0;
            }
        }
    }
}

static picture painted(const duct_drawing *drawing, int width, int height)
{
    picture made = new_picture(width, height, 255);
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            cover_disc(&made, x[k], y[k], duct_stroke_get_style(stroke).width / 2 + 1.5);
        }
    }
    return made;
}

static void try_page(const char *path, size_t *pages)
{
    duct_error error;
    duct_image image = {0, 0, NULL, 0};
    if (duct_image_read(NULL, path, &image, &error) == DUCT_UNSUPPORTED) {
        print_message("skipped: %s\n", error.message);
        return;
    }
    picture page = grey_of(&image);
    duct_image_free(NULL, &image);
    duct_drawing *drawing = trace(&page, NULL);
    picture strokes = painted(drawing, page.width, page.height);
    size_t inked = 0, covered = 0, stray = 0, blank = 0;
    for (size_t i = 0; i < (size_t)page.width * (size_t)page.height; i++) {
        if (page.grey[i] < 90) {
            inked++;
            covered += strokes.grey[i] == 0;
        } else if (page.grey[i] > 200) {
            blank++;
            stray += strokes.grey[i] == 0;
        }
    }
    print_message("%s: %zu strokes, %.1f%% of the ink, %.2f%% of the paper\n", strrchr(path, '/') + 1,
                  duct_drawing_stroke_count(drawing), 100.0 * (double)covered / (double)inked,
                  100.0 * (double)stray / (double)blank);
    assert_true(duct_drawing_stroke_count(drawing) > 300);
    assert_true((double)covered > 0.93 * (double)inked);
    assert_true((double)stray < 0.04 * (double)blank);
    (*pages)++;
    duct_drawing_free(drawing);
    free(strokes.grey);
    free(page.grey);
}

static void scanned_pages_are_covered_by_their_strokes(void **state)
{
    (void)state;
    const char *data = shared_data();
    if (data == NULL) {
        skip();
    }
    char folder[4200], path[5000];
    snprintf(folder, sizeof folder, "%s/handwriting_copiste", data);
    size_t pages = 0;
    /* Two pages; all of them would take a minute. */
    static const char *const names[] = {"wikitexte_0017.jpg", "wikitexte_0052.jpg"};
    for (size_t i = 0; i < 2; i++) {
        snprintf(path, sizeof path, "%s/%s", folder, names[i]);
        FILE *file = fopen(path, "rb");
        if (file != NULL) {
            fclose(file);
            try_page(path, &pages);
        }
    }
    if (pages == 0) {
        skip();
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(scanned_pages_are_covered_by_their_strokes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
