/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Telling ink from paper.
 *
 * Scans are lit unevenly, so each pixel is first divided by the paper's level around it: the 90th percentile
 * of a block of 64 x 64 pixels, the highest of a block and its neighbours, interpolated between blocks. Then
 * one threshold does: Otsu's (A threshold selection method from gray-level histograms, 1979), with the square
 * roots of the counts, because lines may cover a thousandth of a page and Otsu's criterion favours halves. */
#include "lineart/lineart_private.h"

#include "base/error.h"
#include "base/pool.h"

#include <math.h>
#include <string.h>

enum { BLOCK = 64, LEVELS = 256, LEAST_CONTRAST = 24 };

static const double least_paper = 0.4; /* of the page's own level; what is darker is an area of ink */

struct page {
    const duct_context *context;
    const duct_allocator *allocator;
    duct_picture_rows rows;
    void *user;
    int width, height;
    int columns, lines; /* of blocks */
    uint8_t *grey;      /* BLOCK rows */
    uint8_t *paper;     /* level of each block */
    bool inverted;      /* light ink */
};

/* A pass over the picture's blocks of rows. */
typedef void (*visitor)(struct page *page, int y, int count, void *arg);

static duct_status pass(struct page *page, double begin, double end, visitor visit, void *arg,
                        duct_error *error)
{
    for (int y = 0; y < page->height; y += BLOCK) {
        int count = page->height - y < BLOCK ? page->height - y : BLOCK;
        double share = (double)y / page->height;
        duct_status status = duct_progress_report(page->context, begin + (end - begin) * share, error);
        if (status != DUCT_OK) {
            return status;
        }
        if (!page->rows(page->user, y, count, page->grey)) {
            return duct_fail(error, DUCT_IO, "the picture cannot be read at row %d", y);
        }
        visit(page, y, count, arg);
    }
    return DUCT_OK;
}

static int percentile(const uint32_t *counts, double share)
{
    double total = 0, sum = 0;
    for (int i = 0; i < LEVELS; i++) {
        total += counts[i];
    }
    for (int i = 0; i < LEVELS; i++) {
        sum += counts[i];
        if (sum >= share * total) {
            return i;
        }
    }
    return LEVELS - 1;
}

/* The first pass: counts of all pixels, and of each block the levels that paper would have, dark ink or
 * light. */
struct levels {
    double counts[LEVELS];
    uint8_t *dark, *light; /* the 10th and the 90th percentile of each block */
};

static void count_levels(struct page *page, int y, int count, void *arg)
{
    struct levels *levels = arg;
    for (int column = 0; column < page->columns; column++) {
        uint32_t counts[LEVELS] = {0};
        int from = column * BLOCK, to = from + BLOCK < page->width ? from + BLOCK : page->width;
        for (int row = 0; row < count; row++) {
            const uint8_t *grey = page->grey + (size_t)row * (size_t)page->width;
            for (int x = from; x < to; x++) {
                counts[grey[x]]++;
            }
        }
        size_t block = (size_t)(y / BLOCK) * (size_t)page->columns + (size_t)column;
        levels->dark[block] = (uint8_t)percentile(counts, 0.1);
        levels->light[block] = (uint8_t)percentile(counts, 0.9);
        for (int i = 0; i < LEVELS; i++) {
            levels->counts[i] += counts[i];
        }
    }
}

/* Otsu's threshold: what is at most this is ink. False where the two classes hardly differ. */
static bool otsu(const double *counts, int *threshold)
{
    double total = 0, moment = 0;
    for (int i = 0; i < LEVELS; i++) {
        total += sqrt(counts[i]);
        moment += i * sqrt(counts[i]);
    }
    double below = 0, below_moment = 0, best = -1, contrast = 0;
    for (int i = 0; i < LEVELS - 1; i++) {
        below += sqrt(counts[i]);
        below_moment += i * sqrt(counts[i]);
        double above = total - below;
        if (below <= 0 || above <= 0) {
            continue;
        }
        double apart = (moment - below_moment) / above - below_moment / below;
        double between = below * above * apart * apart;
        if (between > best * (1 + 1e-12)) {
            best = between;
            contrast = apart;
            *threshold = i;
        }
    }
    return best >= 0 && contrast >= LEAST_CONTRAST;
}

/* Where two classes are parted by a gap, the middle of the gap, so that smoothed edges are cut at their
 * middle. */
static int middle_of_gap(const double *counts, int threshold)
{
    int end = threshold + 1;
    while (end < LEVELS - 1 && !(counts[end] > 0)) {
        end++;
    }
    return (threshold + end - 1) / 2;
}

static bool rarer_is_light(const double *counts, int threshold)
{
    double dark = 0, light = 0;
    for (int i = 0; i < LEVELS; i++) {
        *(i <= threshold ? &dark : &light) += counts[i];
    }
    return light < dark;
}

static uint8_t highest_around(const struct page *page, const uint8_t *level, int column, int line)
{
    int most = 0;
    for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
            int x = column + dx, y = line + dy;
            if (x >= 0 && y >= 0 && x < page->columns && y < page->lines) {
                int here = level[(size_t)y * (size_t)page->columns + (size_t)x];
                most = here > most ? here : most;
            }
        }
    }
    return (uint8_t)most;
}

static void find_paper(struct page *page, struct levels *levels)
{
    uint8_t *level = page->inverted ? levels->dark : levels->light;
    uint32_t counts[LEVELS] = {0};
    size_t blocks = (size_t)page->columns * (size_t)page->lines;
    for (size_t i = 0; i < blocks; i++) {
        level[i] = page->inverted ? (uint8_t)(255 - level[i]) : level[i];
        counts[level[i]]++;
    }
    double floor_level = least_paper * percentile(counts, 0.9);
    for (int line = 0; line < page->lines; line++) {
        for (int column = 0; column < page->columns; column++) {
            uint8_t here = highest_around(page, level, column, line);
            page->paper[(size_t)line * (size_t)page->columns + (size_t)column] =
                (uint8_t)fmax(fmax(here, floor_level), 1);
        }
    }
}

static int clamp(int value, int most)
{
    return value < 0 ? 0 : value > most ? most : value;
}

/* One row with the paper's level taken out: 255 is paper. */
static void flatten_row(const struct page *page, int y, int row, uint8_t *flat)
{
    const uint8_t *grey = page->grey + (size_t)row * (size_t)page->width;
    double at_y = (y + row + 0.5) / BLOCK - 0.5;
    int line = (int)floor(at_y);
    double down = at_y - line;
    const uint8_t *above = page->paper + (size_t)clamp(line, page->lines - 1) * (size_t)page->columns;
    const uint8_t *below = page->paper + (size_t)clamp(line + 1, page->lines - 1) * (size_t)page->columns;
    for (int x = 0; x < page->width; x++) {
        double at_x = (x + 0.5) / BLOCK - 0.5;
        int column = (int)floor(at_x);
        double right = at_x - column;
        int a = clamp(column, page->columns - 1), b = clamp(column + 1, page->columns - 1);
        double paper = (above[a] * (1 - right) + above[b] * right) * (1 - down) +
                       (below[a] * (1 - right) + below[b] * right) * down;
        int value = page->inverted ? 255 - grey[x] : grey[x];
        flat[x] = (uint8_t)fmin(255, value * 255 / paper + 0.5);
    }
}

static void count_flat(struct page *page, int y, int count, void *arg)
{
    double *counts = arg;
    for (int row = 0; row < count; row++) {
        uint8_t *flat = page->grey + (size_t)BLOCK * (size_t)page->width;
        flatten_row(page, y, row, flat);
        for (int x = 0; x < page->width; x++) {
            counts[flat[x]] += 1;
        }
    }
}

struct cut {
    duct_bitmap *ink;
    int threshold;
};

static void set_bits(struct page *page, int y, int count, void *arg)
{
    const struct cut *cut = arg;
    for (int row = 0; row < count; row++) {
        uint8_t *flat = page->grey + (size_t)BLOCK * (size_t)page->width;
        flatten_row(page, y, row, flat);
        for (int x = 0; x < page->width; x++) {
            if (flat[x] <= cut->threshold) {
                duct_bitmap_set(cut->ink, x, y + row);
            }
        }
    }
}

static duct_status find(struct page *page, const duct_lineart_options *options, struct levels *levels,
                        duct_bitmap *ink, bool *found, duct_error *error)
{
    double flat[LEVELS] = {0};
    struct cut cut = {ink, 0};
    *found = false;
    duct_status status = pass(page, 0, 0.15, count_levels, levels, error);
    if (status != DUCT_OK || !otsu(levels->counts, &cut.threshold)) {
        return status;
    }
    page->inverted = options->ink == DUCT_INK_LIGHT ||
                     (options->ink == DUCT_INK_AUTO && rarer_is_light(levels->counts, cut.threshold));
    find_paper(page, levels);
    status = pass(page, 0.15, 0.3, count_flat, flat, error);
    if (status != DUCT_OK || !otsu(flat, &cut.threshold)) {
        return status;
    }
    cut.threshold =
        options->threshold > 0 ? (int)((1 - options->threshold) * 255) : middle_of_gap(flat, cut.threshold);
    *found = true;
    return pass(page, 0.3, 0.45, set_bits, &cut, error);
}

duct_status duct_ink_find(const duct_context *context, const duct_lineart_options *options,
                          duct_picture_rows rows, void *user, duct_bitmap *ink, bool *found,
                          duct_error *error)
{
    struct page page = {context, ink->allocator, rows, user, ink->width, ink->height, 0,
                        0,       NULL,           NULL, false};
    page.columns = (page.width + BLOCK - 1) / BLOCK;
    page.lines = (page.height + BLOCK - 1) / BLOCK;
    size_t blocks = (size_t)page.columns * (size_t)page.lines;
    struct levels levels = {{0}, NULL, NULL};
    page.grey = duct_alloc(page.allocator, (size_t)BLOCK + 1, (size_t)page.width);
    page.paper = duct_alloc(page.allocator, blocks, 1);
    levels.dark = duct_alloc(page.allocator, blocks, 1);
    levels.light = duct_alloc(page.allocator, blocks, 1);
    duct_status status =
        page.grey != NULL && page.paper != NULL && levels.dark != NULL && levels.light != NULL
            ? find(&page, options, &levels, ink, found, error)
            : duct_fail_memory(error);
    duct_release(page.allocator, page.grey);
    duct_release(page.allocator, page.paper);
    duct_release(page.allocator, levels.dark);
    duct_release(page.allocator, levels.light);
    return status;
}
