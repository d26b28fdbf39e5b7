/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/recording.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

void duct_recording_tilt(double azimuth, double altitude, double *tilt_x, double *tilt_y)
{
    double cosine = cos(azimuth), sine = sin(azimuth), rise = tan(altitude);
    /* A pen that lies flat leans by a right angle along each axis that it does not stand square on: here the
     * rounding of the cosine of a right angle would show. */
    if (rise < 1e-9) {
        cosine = fabs(cosine) < 1e-9 ? 0 : cosine;
        sine = fabs(sine) < 1e-9 ? 0 : sine;
        rise = 0;
    }
    *tilt_x = atan2(cosine, rise);
    *tilt_y = atan2(sine, rise);
}

static void clamp(double *values, size_t size, double low, double high)
{
    for (size_t i = 0; values != NULL && i < size; i++) {
        values[i] = values[i] < low ? low : values[i] > high ? high : values[i];
    }
}

static double *present(duct_stroke *stroke, duct_channel channel)
{
    return duct_stroke_values(stroke, channel) != NULL ? duct_stroke_edit(stroke, channel) : NULL;
}

void duct_recording_tidy(duct_stroke *stroke)
{
    size_t size = duct_stroke_size(stroke);
    clamp(present(stroke, DUCT_PRESSURE), size, 0, 1);
    clamp(present(stroke, DUCT_TILT_X), size, -DUCT_PI / 2, DUCT_PI / 2);
    clamp(present(stroke, DUCT_TILT_Y), size, -DUCT_PI / 2, DUCT_PI / 2);
    double *time = present(stroke, DUCT_T);
    for (size_t i = 1; time != NULL && i < size; i++) {
        time[i] = time[i] < time[i - 1] ? time[i - 1] : time[i];
    }
    double *twist = present(stroke, DUCT_TWIST);
    for (size_t i = 1; twist != NULL && i < size; i++) {
        double step = twist[i] - twist[i - 1];
        /* Values that are unwrapped already stay as they are, to the last bit. */
        if (fabs(step) > DUCT_PI) {
            twist[i] -= 2 * DUCT_PI * nearbyint(step / (2 * DUCT_PI));
        }
    }
}

bool duct_recording_fill_gaps(double *values, size_t size)
{
    size_t known = 0;
    while (known < size && isnan(values[known])) {
        known++;
    }
    if (known == size) {
        return false;
    }
    for (size_t i = 0; i < known; i++) {
        values[i] = values[known];
    }
    for (size_t i = known + 1; i < size; i++) {
        values[i] = isnan(values[i]) ? values[i - 1] : values[i];
    }
    return true;
}

void duct_lines_init(duct_lines *lines, const char *data, size_t size)
{
    bool mark = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0;
    *lines = (duct_lines){mark ? data + 3 : data, data + size, 0};
}

static bool is_space(char c)
{
    return c == ' ' || c == '\t';
}

bool duct_lines_next(duct_lines *lines, const char **line, size_t *size)
{
    if (lines->at >= lines->end) {
        return false;
    }
    const char *start = lines->at, *stop = start;
    while (stop < lines->end && *stop != '\n' && *stop != '\r') {
        stop++;
    }
    lines->at = stop;
    if (stop < lines->end) {
        lines->at += stop[0] == '\r' && stop + 1 < lines->end && stop[1] == '\n' ? 2 : 1;
    }
    while (start < stop && is_space(*start)) {
        start++;
    }
    while (start < stop && is_space(stop[-1])) {
        stop--;
    }
    lines->number++;
    *line = start;
    *size = (size_t)(stop - start);
    return true;
}

bool duct_lines_next_filled(duct_lines *lines, const char **line, size_t *size)
{
    do {
        if (!duct_lines_next(lines, line, size)) {
            return false;
        }
    } while (*size == 0);
    return true;
}

duct_status duct_recording_add_stroke(duct_drawing *drawing, size_t size, duct_stroke **stroke,
                                      duct_error *error)
{
    char id[24];
    snprintf(id, sizeof id, "%zu", duct_drawing_stroke_count(drawing));
    return duct_drawing_add_stroke(drawing, id, size, stroke, error);
}
