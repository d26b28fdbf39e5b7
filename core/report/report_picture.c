/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The report as a picture after "HelpingHand" Fig. 3: a row a library, with its bars on the left and its row
 * of the matrix on the right. */
#include "report/report_private.h"

#include "base/error.h"
#include "picture/picture.h"

#include <math.h>
#include <stdio.h>

enum { ROW = 38, FONT = 13, SMALL = 11, GAP = 14, BARS = 240, TOP = 54, NUMBER = 24 };

static const duct_ink black = {0.13f, 0.13f, 0.13f, 1}, grey = {0.45f, 0.45f, 0.45f, 1};
static const duct_ink pale = {0.88f, 0.88f, 0.88f, 1}, white = {1, 1, 1, 1};
static const duct_ink similar_ink = {0.13f, 0.40f, 0.67f, 1}, random_ink = {0.96f, 0.65f, 0.38f, 1};

typedef struct {
    duct_picture *picture;
    const duct_report *report;
    double names;  /* the names' column ends here */
    double matrix; /* the matrix's left side */
    double top;    /* of the first row */
} layout;

/* White to dark blue for 0 to 1. */
static duct_ink shade(double value)
{
    float t = (float)fmax(0, fmin(1, value));
    return (duct_ink){1 - 0.95f * t, 1 - 0.74f * t, 1 - 0.45f * t, 1};
}

static void number(char text[NUMBER], double value)
{
    if (isnan(value)) {
        snprintf(text, NUMBER, "-");
        return;
    }
    /* Hundredths by hand: printf's decimal point is the locale's. */
    int hundredths = (int)lround(fabs(value) * 100);
    snprintf(text, NUMBER, "%s%d.%02d", value < 0 && hundredths > 0 ? "\xe2\x88\x92" : "", hundredths / 100,
             hundredths % 100);
}

static void draw_bar(const layout *self, double y, double value, duct_ink ink)
{
    char text[NUMBER];
    number(text, value);
    double length = value > 0 ? value * BARS : 0;
    duct_picture_rectangle(self->picture, self->names + GAP, y, length, 12, ink);
    duct_picture_text(self->picture, self->names + GAP + length + 4, y + 10, SMALL, DUCT_TEXT_START, 0, black,
                      text);
}

static void draw_scale(const layout *self)
{
    static const char *const marks[] = {"0", "0.25", "0.5", "0.75", "1"};
    double bottom = self->top + ROW * (double)self->report->count;
    for (size_t i = 0; i < 5; i++) {
        double x = self->names + GAP + BARS * (double)i / 4;
        duct_picture_line(self->picture, x, self->top - 2, x, bottom, 1, i == 0 ? grey : pale);
        duct_picture_text(self->picture, x, bottom + 14, SMALL, DUCT_TEXT_MIDDLE, 0, grey, marks[i]);
    }
    double x = self->names + GAP, y = 30;
    duct_picture_rectangle(self->picture, x, y, 12, 12, similar_ink);
    duct_picture_text(self->picture, x + 17, y + 10, SMALL, DUCT_TEXT_START, 0, black, "similar shapes");
    duct_picture_rectangle(self->picture, x + 120, y, 12, 12, random_ink);
    duct_picture_text(self->picture, x + 137, y + 10, SMALL, DUCT_TEXT_START, 0, black, "random pairs");
}

static void draw_cell(const layout *self, size_t row, size_t column)
{
    char text[NUMBER];
    double value = duct_report_between(self->report, row, column)->together.similar;
    double x = self->matrix + ROW * (double)column, y = self->top + ROW * (double)row;
    number(text, value);
    duct_picture_rectangle(self->picture, x, y, ROW - 1, ROW - 1, shade(isnan(value) ? 0 : value));
    duct_picture_text(self->picture, x + ROW / 2.0, y + ROW / 2.0 + 4, SMALL, DUCT_TEXT_MIDDLE, 0,
                      value > 0.55 ? white : black, text);
}

static void draw_rows(const layout *self)
{
    for (size_t i = 0; i < self->report->count; i++) {
        const duct_correlation *own = &duct_report_between(self->report, i, i)->together;
        double y = self->top + ROW * (double)i;
        duct_picture_text(self->picture, self->names, y + ROW / 2.0 + 4, FONT, DUCT_TEXT_END, 0, black,
                          duct_report_library_name(self->report, i));
        draw_bar(self, y + 5, own->similar, similar_ink);
        draw_bar(self, y + 19, own->random, random_ink);
    }
}

static void draw_matrix(const layout *self)
{
    size_t count = self->report->count;
    for (size_t i = 0; count > 1 && i < count; i++) {
        double x = self->matrix + ROW * (double)i;
        duct_picture_text(self->picture, x + ROW / 2.0 + 4, self->top - 6, FONT, DUCT_TEXT_START, -M_PI / 4,
                          black, duct_report_library_name(self->report, i));
        for (size_t k = 0; k < count; k++) {
            draw_cell(self, i, k);
        }
    }
}

/* What is drawn is laid out first, since the picture's size follows from the names. */
static duct_status draw(const duct_context *context, const duct_report *report, duct_picture **picture,
                        duct_error *error)
{
    static const char title[] = "Correlation of pose between patches of strokes";
    double widest = 40, count = (double)report->count;
    for (size_t i = 0; i < report->count; i++) {
        widest = fmax(widest, duct_picture_text_width(FONT, duct_report_library_name(report, i)));
    }
    widest = fmin(widest, 400);
    bool several = report->count > 1;
    layout self = {.report = report, .names = GAP + widest, .top = TOP};
    self.top = several ? fmax(TOP, 30 + 0.75 * widest) : TOP;
    self.matrix = self.names + GAP + BARS + 56;
    double right = several ? self.matrix + ROW * count + 0.75 * widest : self.matrix;
    duct_status status =
        duct_picture_new(context, fmax(right, GAP + duct_picture_text_width(FONT, title)) + GAP,
                         self.top + ROW * count + 28, &self.picture, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_picture_rectangle(self.picture, 0, 0, 1e5, 1e5, white);
    duct_picture_text(self.picture, GAP, 20, FONT, DUCT_TEXT_START, 0, black, title);
    draw_scale(&self);
    draw_rows(&self);
    draw_matrix(&self);
    *picture = self.picture;
    return DUCT_OK;
}

duct_status duct_report_draw(const duct_context *context, const duct_report *report, const char *path,
                             duct_error *error)
{
    duct_picture *picture = NULL;
    duct_status status = draw(context, report, &picture, error);
    if (status == DUCT_OK) {
        status = duct_picture_write(context, picture, path, 2, error);
    }
    duct_picture_free(picture);
    return status;
}
