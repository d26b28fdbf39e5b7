/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The event files that MyPaint and libmypaint replay for their tests and benchmarks, `.dat`: a line a sample,
 *
 *     time  x  y  pressure  [tilt_x  tilt_y]
 *
 * time in seconds, x and y in pixels (y down), pressure 0..1, where 0 is the pen in the air, tilt -1..1,
 * which libmypaint takes as -60..60 degrees. Lines that begin with `#` are comments. */
#include "base/error.h"
#include "formats/format_private.h"
#include "formats/recorded.h"
#include "formats/recording.h"

#include <math.h>

#define FULL_TILT (DUCT_PI / 3)

enum { TIME, X, Y, PRESSURE, COLUMNS, TILT_X = COLUMNS, TILT_Y, COLUMNS_WITH_TILT, SNIFFED_LINES = 8 };

/* The next line's numbers; `count` is -1 where they are none of an event's. False at the file's end. */
static bool next_event(duct_lines *lines, double values[COLUMNS_WITH_TILT], int *count)
{
    const char *line;
    size_t size;
    while (duct_lines_next_filled(lines, &line, &size)) {
        if (line[0] != '#') {
            *count = duct_line_numbers(line, size, values, COLUMNS_WITH_TILT);
            *count = *count == COLUMNS || *count == COLUMNS_WITH_TILT ? *count : -1;
            return true;
        }
    }
    return false;
}

/* Four columns of numbers may be anything: the first lines have to look like time and pressure. */
static bool sniff(const char *data, size_t size)
{
    duct_lines lines;
    duct_lines_init(&lines, data, size);
    double values[COLUMNS_WITH_TILT], before = -INFINITY;
    int count, events = 0;
    while (events < SNIFFED_LINES && next_event(&lines, values, &count)) {
        if (count < 0 || values[TIME] < before || values[PRESSURE] < 0 || values[PRESSURE] > 1) {
            return false;
        }
        before = values[TIME];
        events++;
    }
    return events > 0;
}

static duct_status read_events(duct_lines *lines, duct_recorded *samples, duct_error *error)
{
    double values[COLUMNS_WITH_TILT];
    int count;
    bool down = false;
    while (next_event(lines, values, &count)) {
        if (count < 0) {
            return duct_fail(
                error, DUCT_BAD_FORMAT,
                "line %ld: an event is %d or %d numbers: time, x, y, pressure, and perhaps both tilts",
                lines->number, COLUMNS, COLUMNS_WITH_TILT);
        }
        bool before = down;
        down = values[PRESSURE] > 0;
        if (!down) {
            continue;
        }
        duct_recorded_sample *sample;
        duct_status status =
            duct_recorded_add(samples, samples->stroke_count - (before ? 1 : 0), &sample, error);
        if (status != DUCT_OK) {
            return status;
        }
        sample->values[DUCT_T] = values[TIME];
        sample->values[DUCT_X] = values[X];
        sample->values[DUCT_Y] = values[Y];
        sample->values[DUCT_PRESSURE] = values[PRESSURE];
        if (count == COLUMNS_WITH_TILT) {
            sample->values[DUCT_TILT_X] = values[TILT_X] * FULL_TILT;
            sample->values[DUCT_TILT_Y] = values[TILT_Y] * FULL_TILT;
        }
    }
    return DUCT_OK;
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)options;
    duct_lines lines;
    duct_lines_init(&lines, data, size);
    duct_recorded samples;
    duct_recorded_init(&samples, duct_allocator_of(context));
    duct_status status = read_events(&lines, &samples, error);
    if (status == DUCT_OK) {
        duct_recorded_start_time(&samples, 1);
        duct_recorded_drop_silent(&samples);
        status = duct_recorded_make_strokes(&samples, drawing, error);
    }
    duct_recorded_free(&samples);
    return status;
}

const duct_format_impl duct_format_mypaint_events = {
    {"mypaint", "MyPaint event file", "dat", true, false},
    sniff,
    read,
    NULL,
};
