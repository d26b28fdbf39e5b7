/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "page.h"

#include "wander.h"

#include <ductus/random.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A page in the making. */
typedef struct writer {
    const hand_style *style;
    duct_drawing *page;
    duct_error *error;
    hand_place hand;
    double clock; /* s, when the last stroke ended */
    double pen_x, pen_y;
    size_t number; /* strokes so far */
    size_t letter; /* letters so far */
    trajectory way;
    pose hold;
    action_plan plan;
} writer;

/* Tablets count in steps. Rounding also keeps last-digit differences between compilers out of the file. */
static double rounded(double value, double steps)
{
    return round(value * steps) / steps;
}

static void copy_rounded(const double *from, double steps, size_t size, double *to)
{
    for (size_t k = 0; k < size; k++) {
        to[k] = rounded(from[k], steps);
    }
}

static duct_status store(writer *w, const char *id, const char *group)
{
    const size_t size = w->way.size;
    duct_stroke *stroke = NULL;
    duct_status status = duct_drawing_add_stroke(w->page, id, size, &stroke, w->error);
    if (status == DUCT_OK) {
        status = duct_stroke_set_group(stroke, group, w->error);
    }
    for (int channel = 0; status == DUCT_OK && channel < DUCT_CHANNEL_COUNT; channel++) {
        if (duct_stroke_edit(stroke, (duct_channel)channel) == NULL) {
            snprintf(w->error->message, sizeof w->error->message, "no memory for stroke %s", id);
            status = w->error->status = DUCT_NO_MEMORY;
        }
    }
    if (status != DUCT_OK) {
        return status;
    }
    copy_rounded(w->way.x, 100, size, duct_stroke_edit(stroke, DUCT_X));
    copy_rounded(w->way.y, 100, size, duct_stroke_edit(stroke, DUCT_Y));
    copy_rounded(w->hold.pressure, 2048, size, duct_stroke_edit(stroke, DUCT_PRESSURE));
    copy_rounded(w->hold.tilt_x, 4096, size, duct_stroke_edit(stroke, DUCT_TILT_X));
    copy_rounded(w->hold.tilt_y, 4096, size, duct_stroke_edit(stroke, DUCT_TILT_Y));
    copy_rounded(w->hold.twist, 4096, size, duct_stroke_edit(stroke, DUCT_TWIST));
    double *t = duct_stroke_edit(stroke, DUCT_T);
    for (size_t k = 0; k < size; k++) {
        t[k] = rounded(w->clock + w->way.t[k], 1e5);
    }
    duct_stroke_set_style(stroke, (duct_stroke_style){0, 0, 0, 1, 4});
    return DUCT_OK;
}

/* Carries out the plan that the writer holds, as the page's next stroke, and empties it. */
static duct_status perform(writer *w, const motor_style *motor, double jitter, const char *group)
{
    char id[32];
    snprintf(id, sizeof id, "%s-%03zu", w->style->name, w->number);
    const uint64_t seed = w->style->seed, stroke = duct_random_id(id);
    manner_hook(&w->style->manner, &w->plan);
    motion_perform(motor, &w->plan, jitter, seed, stroke, &w->way);
    w->plan.count = 0;

    /* The pen moves through the air to the stroke's beginning, on the tablet's clock. */
    const double distance = hypot(w->way.x[0] - w->pen_x, w->way.y[0] - w->pen_y);
    const double chance = 0.04 * fabs(duct_random_normal(seed, stroke, 0, CHANCE_PAUSE));
    const double air = w->number == 0 ? 0 : 0.12 + chance + 0.02 * sqrt(distance);
    w->clock += ceil(air * MOTION_RATE) / MOTION_RATE;
    grip_hold(&w->style->grip, &w->way, PAGE_SIDE, air, w->number, seed, stroke, &w->hand, &w->hold);
    const duct_status status = store(w, id, group);
    const size_t last = w->way.size - 1;
    w->clock += w->way.t[last];
    w->pen_x = w->way.x[last];
    w->pen_y = w->way.y[last];
    w->number++;
    return status;
}

/* Dots and bars wait until the joined run they belong to is written. */
enum { RUN_LETTERS = 16 };

typedef struct run {
    const glyph *letters[RUN_LETTERS];
    glyph_place places[RUN_LETTERS];
    size_t count;
} run;

static duct_status write_run(writer *w, const run *letters)
{
    const double jitter = w->style->letter_jitter * w->style->size;
    bool written = true;
    for (size_t i = 0; i < letters->count; i++) {
        written = written && glyph_write(letters->letters[i], 0, &letters->places[i], &w->plan);
    }
    duct_status status = written ? perform(w, &w->style->writing, jitter, "text") : DUCT_BAD_ARGUMENT;
    for (size_t i = 0; i < letters->count; i++) {
        const size_t strokes = glyph_strokes(letters->letters[i]);
        for (size_t k = 1; status == DUCT_OK && k < strokes; k++) {
            written = glyph_write(letters->letters[i], k, &letters->places[i], &w->plan);
            status = written ? perform(w, &w->style->writing, jitter, "text") : DUCT_BAD_ARGUMENT;
        }
    }
    if (!written) {
        snprintf(w->error->message, sizeof w->error->message, "the form of letter '%c' is malformed",
                 letters->letters[0]->letter);
        w->error->status = DUCT_BAD_ARGUMENT;
    }
    return status;
}

/* Sizes, slants and the baseline wander from letter to letter. */
static glyph_place place_letter(writer *w, size_t line, double x)
{
    const hand_style *style = w->style;
    const double u = (double)w->letter / 4;
    const uint64_t seed = style->seed;
    const double baseline = style->top + (double)line * style->line_pitch;
    const double off = style->baseline_jitter * wander(seed, line, CHANCE_BASELINE, x / 300) * style->size;
    return (glyph_place){x, baseline + off + style->baseline_slope * (x - style->left),
                         style->size * (1 + style->size_jitter * wander(seed, 0, CHANCE_SIZE, u)),
                         style->slant + style->slant_jitter * wander(seed, 0, CHANCE_SLANT, u)};
}

static bool joined(const writer *w, const glyph *letter, const glyph *next)
{
    return next != NULL && letter->joins_out && next->joins_in &&
           duct_random_uniform(w->style->seed, 0, w->letter, CHANCE_JOIN) < w->style->joining;
}

static duct_status write_line(writer *w, size_t line)
{
    const hand_style *style = w->style;
    double x = style->left + 12 * duct_random_normal(style->seed, line, 0, CHANCE_SPACE);
    run letters = {.count = 0};
    duct_status status = DUCT_OK;
    for (const char *c = style->lines[line]; *c != '\0' && status == DUCT_OK; c++) {
        const double chance = 1 + 0.15 * duct_random_normal(style->seed, 1, w->letter, CHANCE_SPACE);
        if (*c == ' ') {
            x += style->word_space * style->size * chance;
            continue;
        }
        const glyph *letter = alphabet_find(style->letters, *c);
        if (letter == NULL) {
            snprintf(w->error->message, sizeof w->error->message, "hand %s has no letter '%c' (line %zu)",
                     style->name, *c, line + 1);
            return w->error->status = DUCT_BAD_ARGUMENT;
        }
        letters.letters[letters.count] = letter;
        letters.places[letters.count] = place_letter(w, line, x);
        letters.count++;
        x += style->size * (letter->advance / 100.0 + style->letter_space * chance);
        w->letter++;
        if (letters.count == RUN_LETTERS || !joined(w, letter, alphabet_find(style->letters, c[1]))) {
            status = write_run(w, &letters);
            letters.count = 0;
        }
    }
    return status;
}

static duct_status draw_shapes(writer *w)
{
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < shapes_count && status == DUCT_OK; i++) {
        const stroke_manner *manner = &w->style->manner;
        const size_t pieces = manner_pieces(manner, &shapes_page[i]);
        for (size_t k = 0; k < pieces && status == DUCT_OK; k++) {
            const shape form = manner_piece(manner, &shapes_page[i], k);
            if (!shape_write(&form, &w->plan)) {
                snprintf(w->error->message, sizeof w->error->message,
                         "drawing stroke %zu has too many targets", i);
                return w->error->status = DUCT_BAD_ARGUMENT;
            }
            const double jitter = w->style->shape_jitter * fmin(shape_size(&form), 120);
            status = perform(w, &w->style->drawing, jitter, "drawing");
        }
    }
    return status;
}

static duct_status annotate(writer *w)
{
    static const char *const facts[][2] = {
        {"artist", "Ductus generator (synthetic)"}, {"licence", "GPL-3.0-or-later"}, {"synthetic", "true"}};
    duct_status status = duct_drawing_annotate(w->page, "name", w->style->name, w->error);
    for (size_t i = 0; i < sizeof facts / sizeof facts[0] && status == DUCT_OK; i++) {
        status = duct_drawing_annotate(w->page, facts[i][0], facts[i][1], w->error);
    }
    return status;
}

static duct_status make(const duct_context *context, const hand_style *style, bool drawing,
                        duct_drawing **page, duct_error *error)
{
    duct_error ignored;
    writer *w = calloc(1, sizeof *w);
    if (error == NULL) {
        error = &ignored;
    }
    if (w == NULL) {
        snprintf(error->message, sizeof error->message, "no memory for a page");
        return error->status = DUCT_NO_MEMORY;
    }
    w->style = style;
    w->error = error;
    duct_status status = duct_drawing_new(context, &w->page, w->error);
    if (status == DUCT_OK) {
        duct_drawing_set_page(w->page, PAGE_SIDE, PAGE_SIDE);
        status = annotate(w);
    }
    for (size_t line = 0; status == DUCT_OK && style->lines[line] != NULL; line++) {
        status = write_line(w, line);
    }
    if (status == DUCT_OK && drawing) {
        status = draw_shapes(w);
    }
    if (status == DUCT_OK) {
        *page = w->page;
    } else {
        duct_drawing_free(w->page);
    }
    free(w);
    return status;
}

duct_status page_make(const duct_context *context, const hand_style *style, duct_drawing **page,
                      duct_error *error)
{
    return make(context, style, true, page, error);
}

duct_status page_write_line(const duct_context *context, const hand_style *style, const char *text,
                            duct_drawing **page, duct_error *error)
{
    const char *const lines[] = {text, NULL};
    hand_style now = *style;
    now.lines = lines;
    return make(context, &now, false, page, error);
}
