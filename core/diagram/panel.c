/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "diagram/panel.h"

#include "base/error.h"
#include "diagram/palette.h"

#include <math.h>

enum { NIB_POINTS = 20 };

/* Picture pixels. */
static const double MARK_GAP = 12, NIB_REACH = 7, NEEDLE_REACH = 34, THREAD = 1;

const duct_ink duct_ink_text = {0.15F, 0.16F, 0.2F, 1};
const duct_ink duct_ink_quiet = {0.45F, 0.46F, 0.5F, 1};
const duct_ink duct_ink_missing = {0.78F, 0.79F, 0.81F, 1};

duct_placing duct_placing_fit(const double box[4], const duct_cell *cell)
{
    double width = box[2] - box[0], height = box[3] - box[1], scale = HUGE_VAL;
    if (width > 0) {
        scale = cell->width / width;
    }
    if (height > 0) {
        scale = fmin(scale, cell->height / height);
    }
    if (!isfinite(scale)) {
        scale = 1;
    }
    return (duct_placing){scale, cell->x + (cell->width - scale * (box[0] + box[2])) / 2,
                          cell->y + (cell->height - scale * (box[1] + box[3])) / 2};
}

size_t duct_segment_number(const duct_segments *segments, const duct_segmented *stroke, size_t segment)
{
    return segments->numbers[stroke - segments->strokes] + segment;
}

/* What drawing a stroke needs: positions in the picture, and a colour and a width for each step. */
typedef struct {
    double *x, *y, *widths;
    duct_ink *inks;
    const duct_diagram_panel *panel;
    const duct_diagram_options *options;
    const duct_placing *placing;
    double low, high;
} pen;

static double share_of(const pen *self, double value)
{
    return self->high > self->low ? (value - self->low) / (self->high - self->low) : 0.5;
}

static duct_ink own_ink(const duct_stroke *stroke)
{
    duct_stroke_style style = duct_stroke_get_style(stroke);
    return (duct_ink){style.red, style.green, style.blue, style.opacity};
}

/* Sample i of n is as far along the stroke as sample i of the traced pass, which was uniform too; a segment
 * reaches half a sample beyond its ends. */
static void colour_segments(const pen *self, const duct_segmented *traced, size_t count)
{
    size_t segment = 0;
    for (size_t i = 0; i < count; i++) {
        double share = count > 1 ? ((double)i + 0.5) / (double)count : 0;
        double place = share * (double)(traced->samples - 1);
        while (segment + 1 < traced->count && place > (double)traced->items[segment].last + 0.5) {
            segment++;
        }
        self->inks[i] = duct_palette_category(duct_segment_number(self->panel->segments, traced, segment));
    }
}

/* Colours the `steps` lines between the samples (or a dot's one sample). */
static void colour_stroke(const pen *self, const duct_shown_stroke *shown, size_t index, size_t steps)
{
    const duct_segmented *traced = NULL;
    if (self->options->by == DUCT_BY_SEGMENTS && self->panel->segments != NULL) {
        traced = duct_segments_find(self->panel->segments, index, duct_stroke_id(shown->stroke));
    }
    if (traced != NULL && traced->count > 0) {
        colour_segments(self, traced, steps);
        return;
    }
    for (size_t i = 0; i < steps; i++) {
        size_t next = i + 1 < shown->samples.count ? i + 1 : i;
        if (shown->values != NULL) {
            double value = 0.5 * (shown->values[i] + shown->values[next]);
            self->inks[i] = duct_palette_ink(self->options->palette, share_of(self, value));
        } else {
            self->inks[i] = self->options->by == DUCT_BY_NOTHING ? own_ink(shown->stroke) : duct_ink_missing;
        }
    }
}

static void width_stroke(const pen *self, const duct_shown_stroke *shown, size_t steps)
{
    const double *pressure = shown->samples.channels[DUCT_PRESSURE];
    for (size_t i = 0; i < steps; i++) {
        self->widths[i] = self->options->line_width;
        if (self->options->width_by_pressure && pressure != NULL) {
            /* In eighths of a pixel: neighbours of one width become one line in the file. */
            self->widths[i] = ceil(8 * self->options->line_width * (0.2 + 2 * pressure[i])) / 8;
        }
    }
}

static void draw_nib(duct_picture *picture, double x, double y, double reach, double angle, duct_ink ink)
{
    double xs[NIB_POINTS], ys[NIB_POINTS];
    for (int i = 0; i < NIB_POINTS; i++) {
        double turn = 2 * M_PI * i / NIB_POINTS;
        double along = reach * cos(turn), across = 0.28 * reach * sin(turn);
        xs[i] = x + along * cos(angle) - across * sin(angle);
        ys[i] = y + along * sin(angle) + across * cos(angle);
    }
    duct_picture_polygon(picture, xs, ys, NIB_POINTS, ink);
}

/* The marks at one sample: nib and needle. */
static void draw_mark(const pen *self, duct_picture *picture, const duct_samples *samples, size_t i,
                      duct_ink ink)
{
    const double *pressure = samples->channels[DUCT_PRESSURE], *twist = samples->channels[DUCT_TWIST];
    const double *tilt_x = samples->channels[DUCT_TILT_X], *tilt_y = samples->channels[DUCT_TILT_Y];
    if (self->options->nibs) {
        double reach = NIB_REACH * (pressure != NULL ? 0.35 + 1.3 * pressure[i] : 1);
        ink.opacity *= 0.85F;
        draw_nib(picture, self->x[i], self->y[i], reach, twist != NULL ? twist[i] : 0, ink);
    }
    if (self->options->needles && tilt_x != NULL && tilt_y != NULL) {
        double dx = tan(tilt_x[i]), dy = tan(tilt_y[i]), lean = hypot(dx, dy);
        /* The shadow of a barrel of NEEDLE_REACH: its length is the sine of the lean. */
        double length = lean > 0 ? NEEDLE_REACH * sin(atan(lean)) / lean : 0;
        duct_picture_line(picture, self->x[i], self->y[i], self->x[i] + length * dx, self->y[i] + length * dy,
                          0.9, duct_ink_text);
        duct_picture_circle(picture, self->x[i], self->y[i], 1.2, duct_ink_text);
    }
}

static void draw_marks(const pen *self, duct_picture *picture, const duct_samples *samples)
{
    double step = samples->step * self->placing->scale;
    double gap = step > 0 ? fmax(1, floor(MARK_GAP / step + 0.5)) : 1;
    size_t every = gap < (double)samples->count ? (size_t)gap : samples->count;
    for (size_t i = 0; i < samples->count; i += every) {
        draw_mark(self, picture, samples, i, self->inks[i + 1 < samples->count || i == 0 ? i : i - 1]);
    }
}

static void draw_stroke(const pen *self, duct_picture *picture, const duct_shown_stroke *shown, size_t index)
{
    const duct_samples *samples = &shown->samples;
    size_t steps = samples->count > 1 ? samples->count - 1 : samples->count;
    for (size_t i = 0; i < samples->count; i++) {
        self->x[i] = self->placing->x + self->placing->scale * samples->channels[DUCT_X][i];
        self->y[i] = self->placing->y + self->placing->scale * samples->channels[DUCT_Y][i];
    }
    if (steps == 0) {
        return;
    }
    colour_stroke(self, shown, index, steps);
    width_stroke(self, shown, steps);
    if (samples->count == 1) {
        duct_picture_circle(picture, self->x[0], self->y[0], 0.75 * self->widths[0], self->inks[0]);
    } else if (self->options->nibs) {
        /* The nibs carry the colour; the line only holds them together. */
        duct_picture_polyline(picture, self->x, self->y, samples->count, THREAD, duct_ink_missing);
    } else {
        duct_picture_segments(picture, self->x, self->y, samples->count, self->widths, 0, self->inks);
    }
    if (self->options->nibs || self->options->needles) {
        draw_marks(self, picture, samples);
    }
}

duct_status duct_panel_draw(const duct_allocator *allocator, duct_picture *picture,
                            const duct_diagram_panel *panel, const duct_shown *shown,
                            const duct_diagram_options *options, const duct_placing *placing, double low,
                            double high, duct_error *error)
{
    size_t most = 1;
    for (size_t i = 0; i < shown->count; i++) {
        most = shown->strokes[i].samples.count > most ? shown->strokes[i].samples.count : most;
    }
    pen self = {.panel = panel, .options = options, .placing = placing, .low = low, .high = high};
    self.x = duct_alloc(allocator, 3 * most, sizeof *self.x);
    self.inks = duct_alloc(allocator, most, sizeof *self.inks);
    duct_status status = DUCT_OK;
    if (self.x == NULL || self.inks == NULL) {
        status = duct_fail_memory(error);
    } else {
        self.y = self.x + most;
        self.widths = self.y + most;
        for (size_t i = 0; i < shown->count; i++) {
            draw_stroke(&self, picture, &shown->strokes[i], i);
        }
    }
    duct_release(allocator, self.x);
    duct_release(allocator, self.inks);
    return status;
}
