/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Diagrams: where the panels, their captions and the legend lie. */
#include "base/error.h"
#include "base/number.h"
#include "base/pool.h"
#include "diagram/palette.h"
#include "diagram/panel.h"

#include <ductus/diagram.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Picture pixels. */
static const double MARGIN = 16, PADDING = 14, CAPTION = 22, NOTE = 17, LEGEND = 46,
                    BAR_WIDTH = 4 * DUCT_PALETTE_STEPS, BAR_HEIGHT = 10, STEP = 1.2;
enum { MOST_PANELS = 1024, USUAL_COLUMNS = 4, NUMBER_ROOM = 32 };

typedef struct {
    const duct_context *context;
    const duct_diagram_panel *panels;
    size_t count;
    duct_diagram_options options;
    size_t cells, columns, rows;
    double cell_height, row_height; /* a row has captions and notes below its cells */
    bool captions, notes, ranged;
    double low, high;
    double (*boxes)[4];
    duct_shown *shown;
    duct_picture *picture;
} diagram;

duct_diagram_options duct_diagram_options_default(void)
{
    return (duct_diagram_options){.by = DUCT_BY_PRESSURE, .line_width = 2.5, .panel_width = 560, .scale = 1};
}

static duct_status check(const duct_diagram_panel *panels, size_t count, const duct_diagram_options *options,
                         const char *path, duct_error *error)
{
    if (count == 0 || count > MOST_PANELS) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a diagram shows 1 to %d drawings", MOST_PANELS);
    }
    if (!(options->panel_width >= 64 && options->panel_width <= 8192) ||
        !(options->line_width > 0 && options->line_width <= 100) || options->columns < 0 ||
        !(options->scale >= 0.1 && options->scale <= 16) || !isfinite(options->low) ||
        !isfinite(options->high) || options->low > options->high || options->by > DUCT_BY_SEGMENTS ||
        options->palette > DUCT_PALETTE_BLUE_RED) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a diagram's options are out of range");
    }
    if (!duct_picture_writable(path)) {
        return duct_fail(error, DUCT_UNSUPPORTED, "%s: diagrams are written as .svg or .png", path);
    }
    bool traced = false;
    for (size_t i = 0; i < count; i++) {
        traced = traced || panels[i].segments != NULL;
        if (panels[i].segments != NULL && panels[i].library != NULL &&
            !duct_segments_fit(panels[i].segments, panels[i].library)) {
            return duct_fail(
                error, DUCT_UNSUPPORTED,
                "the library %s is not the one that the trace was made with: their strokes differ",
                duct_library_name(panels[i].library));
        }
    }
    if (options->by == DUCT_BY_SEGMENTS && !traced) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "segments are shown from a trace, and none was given");
    }
    return DUCT_OK;
}

static bool is_beside(const diagram *self, size_t panel)
{
    return self->options.by == DUCT_BY_SEGMENTS && self->panels[panel].segments != NULL &&
           self->panels[panel].library != NULL;
}

/* Drawings on pages of one size are shown at one scale, so that they can be compared. */
static void share_box(diagram *self)
{
    for (size_t i = 1; i < self->count; i++) {
        const duct_drawing *drawing = self->panels[i].drawing, *first = self->panels[0].drawing;
        if (!(duct_drawing_width(drawing) > 0) || duct_drawing_width(drawing) != duct_drawing_width(first) ||
            duct_drawing_height(drawing) != duct_drawing_height(first)) {
            return;
        }
    }
    for (size_t i = 1; i < self->count; i++) {
        for (int side = 0; side < 4; side++) {
            double mine = self->boxes[i][side], all = self->boxes[0][side];
            self->boxes[0][side] = side < 2 ? fmin(mine, all) : fmax(mine, all);
        }
    }
    for (size_t i = 1; i < self->count; i++) {
        memcpy(self->boxes[i], self->boxes[0], sizeof self->boxes[0]);
    }
}

static duct_status lay_out(diagram *self, duct_error *error)
{
    double aspect = 0.2, inner = self->options.panel_width - 2 * PADDING;
    for (size_t i = 0; i < self->count; i++) {
        double *box = self->boxes[i];
        duct_drawing_bounds(self->panels[i].drawing, box);
        if (!isfinite(box[2] - box[0]) || !isfinite(box[3] - box[1])) {
            return duct_fail(error, DUCT_LIMIT, "the drawing is too large to be shown");
        }
        self->cells += is_beside(self, i) ? 2 : 1;
        self->captions =
            self->captions || (self->panels[i].caption != NULL && *self->panels[i].caption != '\0');
        self->notes =
            self->notes || (self->options.by == DUCT_BY_SEGMENTS && self->panels[i].segments != NULL);
    }
    share_box(self);
    for (size_t i = 0; i < self->count; i++) {
        double width = self->boxes[i][2] - self->boxes[i][0], height = self->boxes[i][3] - self->boxes[i][1];
        aspect = fmax(aspect, width > 0 ? height / width : height > 0 ? 1.5 : 0);
    }
    self->cell_height = fmin(aspect, 1.5) * inner + 2 * PADDING;
    self->columns = self->options.columns > 0 ? (size_t)self->options.columns : USUAL_COLUMNS;
    self->columns = self->columns < self->cells ? self->columns : self->cells;
    self->rows = (self->cells + self->columns - 1) / self->columns;
    self->row_height = self->cell_height + (self->captions ? CAPTION : 0) + (self->notes ? NOTE : 0) + MARGIN;
    return DUCT_OK;
}

/* The place of a cell, without its padding. */
static duct_cell cell_at(const diagram *self, size_t index)
{
    return (duct_cell){MARGIN + (double)(index % self->columns) * (self->options.panel_width + MARGIN) +
                           PADDING,
                       MARGIN + (double)(index / self->columns) * self->row_height + PADDING,
                       self->options.panel_width - 2 * PADDING, self->cell_height - 2 * PADDING};
}

static duct_status sample_all(diagram *self, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    duct_cell cell = cell_at(self, 0);
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < self->count && status == DUCT_OK; i++) {
        double step = STEP / duct_placing_fit(self->boxes[i], &cell).scale;
        status = duct_shown_make(allocator, self->panels[i].drawing, self->options.by, step, &self->shown[i],
                                 error);
        if (status == DUCT_OK) {
            status = duct_progress_report(self->context, 0.7 * (double)(i + 1) / (double)self->count, error);
        }
    }
    return status;
}

static const struct {
    const char *title, *unit, *missing;
} SUBJECTS[] = {
    [DUCT_BY_NOTHING] = {"", "", ""},
    [DUCT_BY_PRESSURE] = {"pressure", "", "pressure"},
    [DUCT_BY_TILT] = {"tilt from upright", "°", "tilt"},
    [DUCT_BY_TILT_X] = {"tilt to the right", "°", "tilt"},
    [DUCT_BY_TILT_Y] = {"tilt towards the user", "°", "tilt"},
    [DUCT_BY_TWIST] = {"twist of the barrel", "°", "twist"},
    [DUCT_BY_SPEED] = {"speed", " pixels/s", "time"},
    [DUCT_BY_SEGMENTS] = {"", "", ""},
};

static duct_status find_range(diagram *self, duct_error *error)
{
    duct_status status;
    duct_diagram_by by = self->options.by;
    double low = 0, high = 0;
    self->ranged = duct_shown_range(duct_allocator_of(self->context), self->shown, self->count, by, &low,
                                    &high, &status, error);
    if (status != DUCT_OK) {
        return status;
    }
    if (!self->ranged && by != DUCT_BY_NOTHING && by != DUCT_BY_SEGMENTS) {
        return duct_fail(error, DUCT_UNSUPPORTED, "no stroke has %s, so it cannot be shown",
                         SUBJECTS[by].missing);
    }
    bool given = self->options.low != 0 || self->options.high != 0;
    self->low = given ? self->options.low : low;
    self->high = given ? self->options.high : high;
    return DUCT_OK;
}

static void print_value(double value, double span, char text[NUMBER_ROOM])
{
    char number[DUCT_NUMBER_SIZE];
    int decimals = span >= 20 ? 0 : span >= 2 ? 1 : 2;
    duct_number_print_fixed(number, value, decimals);
    snprintf(text, NUMBER_ROOM, "%.20s", number);
}

static void draw_scale(const diagram *self, double x, double y)
{
    duct_picture *picture = self->picture;
    char low[NUMBER_ROOM], high[NUMBER_ROOM], text[4 * NUMBER_ROOM];
    double step = BAR_WIDTH / DUCT_PALETTE_STEPS;
    for (int i = 0; i < DUCT_PALETTE_STEPS; i++) {
        double share = (double)i / (DUCT_PALETTE_STEPS - 1);
        duct_picture_rectangle(picture, x + i * step, y, step, BAR_HEIGHT,
                               duct_palette_ink(self->options.palette, share));
    }
    print_value(self->low, self->high - self->low, low);
    print_value(self->high, self->high - self->low, high);
    const char *unit = SUBJECTS[self->options.by].unit;
    snprintf(text, sizeof text, "%s%s", low, unit);
    duct_picture_text(picture, x, y + BAR_HEIGHT + 14, 12, DUCT_TEXT_START, 0, duct_ink_quiet, text);
    snprintf(text, sizeof text, "%s%s", high, unit);
    duct_picture_text(picture, x + BAR_WIDTH, y + BAR_HEIGHT + 14, 12, DUCT_TEXT_END, 0, duct_ink_quiet,
                      text);
    duct_picture_text(picture, x + BAR_WIDTH + 12, y + BAR_HEIGHT, 13, DUCT_TEXT_START, 0, duct_ink_text,
                      SUBJECTS[self->options.by].title);
}

static bool has_marks(const diagram *self)
{
    return self->options.nibs || self->options.needles;
}

static void draw_legend(const diagram *self)
{
    double x = MARGIN, y = MARGIN + (double)self->rows * self->row_height + 4;
    if (self->ranged) {
        draw_scale(self, x, y);
        x += BAR_WIDTH + 12;
    }
    if (has_marks(self)) {
        const char *text = !self->options.needles ? "ellipses: the nib; longer with pressure"
                           : !self->options.nibs  ? "needles: where the barrel leans"
                                                  : "ellipses: the nib; needles: where the barrel leans";
        duct_picture_text(self->picture, x, y + BAR_HEIGHT + 14, 12, DUCT_TEXT_START, 0, duct_ink_quiet,
                          text);
    }
}

/* "14 segments, 48 samples each on average" */
static void note_segments(const duct_segments *segments, char *text, size_t size)
{
    size_t count = 0, samples = 0;
    for (size_t i = 0; i < segments->count; i++) {
        count += segments->strokes[i].count;
        samples += segments->strokes[i].samples;
    }
    snprintf(text, size, "%zu segments, %.0f samples each on average", count,
             count > 0 ? (double)samples / (double)count : 0);
}

static void draw_caption(const diagram *self, size_t cell_index, const char *caption, const char *note)
{
    duct_cell cell = cell_at(self, cell_index);
    double x = cell.x + cell.width / 2, y = cell.y + cell.height + PADDING;
    char kept[256];
    size_t room = (size_t)(self->options.panel_width / duct_picture_text_width(13, "x"));
    if (caption != NULL && *caption != '\0') {
        /* Cut where it does not fit; a character of UTF-8 stays whole. */
        size_t size = strlen(caption);
        bool cut = size > room && duct_picture_text_width(13, caption) > self->options.panel_width;
        size = cut ? room - 1 : size;
        size = size < sizeof kept - 4 ? size : sizeof kept - 4;
        while (size > 0 && ((unsigned char)caption[size] & 0xc0) == 0x80) {
            size--;
        }
        snprintf(kept, sizeof kept, "%.*s%s", (int)size, caption, cut ? "…" : "");
        duct_picture_text(self->picture, x, y + 15, 13, DUCT_TEXT_MIDDLE, 0, duct_ink_text, kept);
    }
    if (note != NULL) {
        duct_picture_text(self->picture, x, y + (self->captions ? CAPTION : 0) + 9, 11, DUCT_TEXT_MIDDLE, 0,
                          duct_ink_quiet, note);
    }
}

static duct_status draw_panel(const diagram *self, size_t index, size_t *next_cell, duct_error *error)
{
    const duct_diagram_panel *panel = &self->panels[index];
    duct_cell cell = cell_at(self, *next_cell);
    duct_placing placing = duct_placing_fit(self->boxes[index], &cell);
    bool segments = self->options.by == DUCT_BY_SEGMENTS && panel->segments != NULL;
    char note[128];
    if (segments) {
        note_segments(panel->segments, note, sizeof note);
    }
    draw_caption(self, (*next_cell)++, panel->caption, segments ? note : NULL);
    duct_status status =
        duct_panel_draw(duct_allocator_of(self->context), self->picture, panel, &self->shown[index],
                        &self->options, &placing, self->low, self->high, error);
    if (status == DUCT_OK && is_beside(self, index)) {
        snprintf(note, sizeof note, "the parts of the hand %.40s that were used",
                 duct_library_name(panel->library));
        draw_caption(self, *next_cell, self->captions ? note : NULL, self->captions ? NULL : note);
        cell = cell_at(self, (*next_cell)++);
        status = duct_beside_draw(self->context, self->picture, panel, &self->options, &cell, error);
    }
    return status;
}

static duct_status draw_all(diagram *self, duct_error *error)
{
    static const duct_ink white = {1, 1, 1, 1};
    double width = MARGIN + (double)self->columns * (self->options.panel_width + MARGIN);
    double height =
        MARGIN + (double)self->rows * self->row_height + (self->ranged || has_marks(self) ? LEGEND : 0);
    duct_status status = duct_picture_new(self->context, ceil(width), ceil(height), &self->picture, error);
    size_t next_cell = 0;
    if (status == DUCT_OK) {
        duct_picture_rectangle(self->picture, 0, 0, ceil(width), ceil(height), white);
        draw_legend(self);
    }
    for (size_t i = 0; i < self->count && status == DUCT_OK; i++) {
        status = draw_panel(self, i, &next_cell, error);
        if (status == DUCT_OK) {
            status =
                duct_progress_report(self->context, 0.7 + 0.3 * (double)(i + 1) / (double)self->count, error);
        }
    }
    return status;
}

static duct_status make(diagram *self, const char *path, duct_error *error)
{
    duct_status status = lay_out(self, error);
    status = status != DUCT_OK ? status : sample_all(self, error);
    status = status != DUCT_OK ? status : find_range(self, error);
    status = status != DUCT_OK ? status : draw_all(self, error);
    return status != DUCT_OK
               ? status
               : duct_picture_write(self->context, self->picture, path, self->options.scale, error);
}

duct_status duct_diagram_write(const duct_context *context, const duct_diagram_panel *panels, size_t count,
                               const duct_diagram_options *options, const char *path, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    diagram self = {.context = context,
                    .panels = panels,
                    .count = count,
                    .options = options != NULL ? *options : duct_diagram_options_default()};
    duct_status status = check(panels, count, &self.options, path, error);
    if (status != DUCT_OK) {
        return status;
    }
    self.boxes = duct_alloc(allocator, count, sizeof *self.boxes);
    self.shown = duct_alloc(allocator, count, sizeof *self.shown);
    if (self.boxes == NULL || self.shown == NULL) {
        status = duct_fail_memory(error);
    } else {
        status = make(&self, path, error);
    }
    for (size_t i = 0; self.shown != NULL && i < count; i++) {
        duct_shown_free(allocator, &self.shown[i]);
    }
    duct_release(allocator, self.shown);
    duct_release(allocator, self.boxes);
    duct_picture_free(self.picture);
    return status;
}
