/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The library's side of a picture of segments ("HelpingHand" Fig. 6): the strokes that were used, and which
 * parts of them. */
#include "diagram/panel.h"

#include "base/error.h"
#include "diagram/palette.h"

#include <math.h>
#include <stdio.h>

/* Most strokes that are drawn, and the room around each, picture pixels. */
enum { MOST_STROKES = 60 };
static const double GAP = 10, LABEL = 12;

/* The library strokes in the order of their first use. */
typedef struct {
    size_t *strokes, count;
    bool *used; /* by library stroke */
} uses;

static duct_status find_uses(const duct_allocator *allocator, const duct_segments *segments, uses *found,
                             duct_error *error)
{
    found->count = 0;
    found->strokes = duct_alloc(allocator, segments->library_count, sizeof *found->strokes);
    found->used = duct_alloc(allocator, segments->library_count, sizeof *found->used);
    if (found->strokes == NULL || found->used == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t s = 0; s < segments->count; s++) {
        for (size_t i = 0; i < segments->strokes[s].count; i++) {
            size_t stroke = segments->strokes[s].items[i].library_stroke;
            if (!found->used[stroke]) {
                found->used[stroke] = true;
                found->strokes[found->count++] = stroke;
            }
        }
    }
    return DUCT_OK;
}

static void bounds_of(const duct_stroke *stroke, double box[4])
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        box[0] = i == 0 ? x[i] : fmin(box[0], x[i]);
        box[1] = i == 0 ? y[i] : fmin(box[1], y[i]);
        box[2] = i == 0 ? x[i] : fmax(box[2], x[i]);
        box[3] = i == 0 ? y[i] : fmax(box[3], y[i]);
    }
}

/* One library stroke: grey, with its used parts over it. `points` has room for twice its samples. */
static void draw_library_stroke(duct_picture *picture, const duct_segments *segments,
                                const duct_stroke *stroke, size_t number, const duct_placing *placing,
                                double width, double *points)
{
    size_t count = duct_stroke_size(stroke);
    double *x = points, *y = points + count;
    for (size_t i = 0; i < count; i++) {
        x[i] = placing->x + placing->scale * duct_stroke_values(stroke, DUCT_X)[i];
        y[i] = placing->y + placing->scale * duct_stroke_values(stroke, DUCT_Y)[i];
    }
    duct_picture_polyline(picture, x, y, count, 1.2, duct_ink_missing);
    for (size_t s = 0; s < segments->count; s++) {
        const duct_segmented *traced = &segments->strokes[s];
        for (size_t i = 0; i < traced->count; i++) {
            const duct_segment *segment = &traced->items[i];
            if (segment->library_stroke == number && segment->end < count) {
                duct_picture_polyline(picture, x + segment->begin, y + segment->begin,
                                      segment->end - segment->begin + 1, width,
                                      duct_palette_category(duct_segment_number(segments, traced, i)));
            }
        }
    }
}

/* The number of columns that makes cells of about one shape. */
static size_t columns_for(size_t count, const duct_cell *cell)
{
    double ideal = sqrt((double)count * cell->width / fmax(cell->height, 1));
    size_t columns = ideal < 1 ? 1 : (size_t)(ideal + 0.5);
    return columns < count ? columns : count;
}

static void draw_grid(duct_picture *picture, const duct_segments *segments, const duct_drawing *drawing,
                      const uses *found, double width, const duct_cell *cell, double *points)
{
    size_t count = found->count < MOST_STROKES ? found->count : MOST_STROKES;
    size_t columns = columns_for(count, cell), rows = (count + columns - 1) / columns;
    duct_cell part = {0, 0, cell->width / (double)columns - GAP, cell->height / (double)rows - GAP - LABEL};
    double common = HUGE_VAL;
    for (size_t i = 0; i < count; i++) {
        double box[4] = {0, 0, 0, 0};
        bounds_of(duct_drawing_stroke(drawing, found->strokes[i]), box);
        common = fmin(common, duct_placing_fit(box, &part).scale);
    }
    for (size_t i = 0; i < count; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, found->strokes[i]);
        double box[4] = {0, 0, 0, 0};
        char label[32];
        bounds_of(stroke, box);
        part.x = cell->x + (double)(i % columns) * (part.width + GAP) + GAP / 2;
        part.y = cell->y + (double)(i / columns) * (part.height + GAP + LABEL) + GAP / 2;
        duct_placing placing = duct_placing_fit(box, &part);
        if (placing.scale > 4 * common) {
            /* A dot must not look like a circle, so strokes of very different size stay a little different.
             */
            double shrink = placing.scale - 4 * common;
            placing.scale = 4 * common;
            placing.x += shrink * (box[0] + box[2]) / 2;
            placing.y += shrink * (box[1] + box[3]) / 2;
        }
        draw_library_stroke(picture, segments, stroke, found->strokes[i], &placing, width, points);
        snprintf(label, sizeof label, "%zu", found->strokes[i]);
        duct_picture_text(picture, part.x + part.width / 2, part.y + part.height + LABEL - 2, 9,
                          DUCT_TEXT_MIDDLE, 0, duct_ink_quiet, label);
    }
}

duct_status duct_beside_draw(const duct_context *context, duct_picture *picture,
                             const duct_diagram_panel *panel, const duct_diagram_options *options,
                             const duct_cell *cell, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    const duct_segments *segments = panel->segments;
    uses found = {NULL, 0, NULL};
    duct_drawing *drawing = NULL;
    double *points = NULL;
    duct_status status = find_uses(allocator, segments, &found, error);
    if (status == DUCT_OK) {
        status = duct_library_drawing(context, panel->library, &drawing, error);
    }
    if (status == DUCT_OK && found.count > 0) {
        size_t most = 1;
        for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
            size_t size = duct_stroke_size(duct_drawing_stroke(drawing, i));
            most = size > most ? size : most;
        }
        points = duct_alloc(allocator, 2 * most, sizeof *points);
        if (points == NULL) {
            status = duct_fail_memory(error);
        } else {
            draw_grid(picture, segments, drawing, &found, options->line_width, cell, points);
        }
    }
    duct_release(allocator, points);
    duct_drawing_free(drawing);
    duct_release(allocator, found.strokes);
    duct_release(allocator, found.used);
    return status;
}
