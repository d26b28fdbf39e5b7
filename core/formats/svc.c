/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signature and handwriting recordings of Wacom tablets, `.svc`, named after the Signature Verification
 * Competition of 2004: the number of samples (which may be missing), then a line a sample,
 *
 *     x  y  time  button  azimuth  altitude  pressure
 *
 * with button 1 where the pen touches; the competition's first task has the first four columns only. Nothing
 * in the file tells its units, so they are told by its numbers; docs/formats.md lists how. */
#include "base/error.h"
#include "formats/format_private.h"
#include "formats/recorded.h"
#include "formats/recording.h"

#include <math.h>

#define PIXELS_PER_MM (96 / 25.4)

enum {
    X,
    Y,
    TIME,
    BUTTON,
    SHORT_COLUMNS,
    AZIMUTH = SHORT_COLUMNS,
    ALTITUDE,
    PRESSURE,
    COLUMNS,
    SNIFFED_LINES = 8
};

/* While samples are collected, the channels of tilt hold azimuth and altitude as the file has them. */
static const duct_channel raw_azimuth = DUCT_TILT_X, raw_altitude = DUCT_TILT_Y;

typedef struct {
    duct_lines lines;
    int columns; /* of the first sample; 0: none yet */
    bool announced;
    double count; /* of samples, as the file announces it */
} cursor;

/* Skips the number of samples, where there is one. */
static void begin(cursor *at, const char *data, size_t size)
{
    const char *line;
    *at = (cursor){.columns = 0};
    duct_lines_init(&at->lines, data, size);
    duct_lines ahead = at->lines;
    at->announced = duct_lines_next_filled(&ahead, &line, &size) &&
                    duct_line_numbers(line, size, &at->count, 1) == 1 && at->count >= 0;
    if (at->announced) {
        at->lines = ahead;
    }
}

/* False at the file's end, and where the line is no sample, which `good` then says. */
static bool next_sample(cursor *at, double values[COLUMNS], bool *good)
{
    const char *line;
    size_t size;
    *good = true;
    if (!duct_lines_next_filled(&at->lines, &line, &size)) {
        return false;
    }
    int count = duct_line_numbers(line, size, values, COLUMNS);
    at->columns = at->columns == 0 ? count : at->columns;
    *good = count == at->columns && (count == COLUMNS || count == SHORT_COLUMNS) &&
            (values[BUTTON] == 0 || values[BUTTON] == 1);
    return *good;
}

/* Without the number of samples, four columns are not enough to know the format by. */
static bool sniff(const char *data, size_t size)
{
    cursor at;
    double values[COLUMNS];
    bool good = true;
    int samples = 0;
    begin(&at, data, size);
    while (samples < SNIFFED_LINES && next_sample(&at, values, &good)) {
        samples++;
    }
    return good && samples > 0 && (at.columns == COLUMNS || at.announced);
}

static duct_status read_samples(cursor *at, duct_recorded *samples, duct_error *error)
{
    double values[COLUMNS];
    bool good, down = false;
    size_t count = 0;
    for (; next_sample(at, values, &good); count++) {
        bool before = down;
        down = values[BUTTON] == 1;
        if (!down) {
            continue;
        }
        duct_recorded_sample *sample;
        duct_status status =
            duct_recorded_add(samples, samples->stroke_count - (before ? 1 : 0), &sample, error);
        if (status != DUCT_OK) {
            return status;
        }
        sample->values[DUCT_X] = values[X];
        sample->values[DUCT_Y] = values[Y];
        sample->values[DUCT_T] = values[TIME];
        if (at->columns == COLUMNS) {
            sample->values[raw_azimuth] = values[AZIMUTH];
            sample->values[raw_altitude] = values[ALTITUDE];
            sample->values[DUCT_PRESSURE] = values[PRESSURE];
        }
    }
    if (!good) {
        return duct_fail(
            error, DUCT_BAD_FORMAT,
            "line %ld: sample %zu: x, y, time, button (0 or 1) and perhaps azimuth, altitude and "
            "pressure are expected, as many numbers in each line",
            at->lines.number, count);
    }
    if (at->announced && at->count > (double)count) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: %.0f samples are announced, but %zu follow",
                         at->lines.number, at->count, count);
    }
    if (!at->announced && count == 0) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the number of samples is expected",
                         at->lines.number);
    }
    return DUCT_OK;
}

static double largest(const duct_recorded *samples, duct_channel channel)
{
    double most = 0;
    for (size_t i = 0; i < samples->count; i++) {
        most = fmax(most, fabs(samples->items[i].values[channel]));
    }
    return most;
}

/* Tablets tell apart 2^n levels; a file of small numbers only is told by the fewest that can be. */
static double pressure_unit(const duct_recorded *samples)
{
    double most = largest(samples, DUCT_PRESSURE), levels = 1;
    if (most > 1) {
        for (levels = 256; levels < most && levels < 65536; levels *= 2) {
        }
    }
    return 1 / fmax(levels, most);
}

/* Milliseconds, unless samples then came faster than twice a millisecond. */
static double time_unit(const duct_recorded *samples)
{
    double sum = 0;
    size_t steps = 0;
    for (size_t i = 1; i < samples->count; i++) {
        if (samples->items[i].stroke == samples->items[i - 1].stroke) {
            sum += fabs(samples->items[i].values[DUCT_T] - samples->items[i - 1].values[DUCT_T]);
            steps++;
        }
    }
    return steps > 0 && sum > 0 && sum / (double)steps < 0.5 ? 1 : 0.001;
}

/* Tenths of a degree, unless no pen then stood higher than 9 degrees. */
static double angle_unit(const duct_recorded *samples)
{
    double most = largest(samples, raw_altitude);
    return most > 90 ? DUCT_PI / 1800 : most > 1.6 ? DUCT_PI / 180 : 1;
}

/* Positions with a fraction are millimetres; others are the tablet's units, of which there are 200 a mm, or
 * 20 where a driver made them coarser: a recording in the finer ones hardly stays below 10000. */
static double position_unit(const duct_recorded *samples)
{
    for (size_t i = 0; i < samples->count; i++) {
        double x = samples->items[i].values[DUCT_X], y = samples->items[i].values[DUCT_Y];
        if (x != nearbyint(x) || y != nearbyint(y)) {
            return PIXELS_PER_MM;
        }
    }
    double most = fmax(largest(samples, DUCT_X), largest(samples, DUCT_Y));
    return PIXELS_PER_MM / (most > 10000 ? 200 : 20);
}

/* Some recorders (PaHaW's) write y before x and measure azimuth in the frame so exchanged. Hands lean towards
 * the writer: azimuth, clockwise from the direction of the second column, is then between 90 and 270 degrees.
 * Where it is on average between 270 and 360, the pen would lean away to the left, but towards the writer and
 * to the right with the columns exchanged. */
static bool columns_are_exchanged(const duct_recorded *samples, double angle)
{
    double sine = 0, cosine = 0;
    for (size_t i = 0; i < samples->count; i++) {
        sine += sin(samples->items[i].values[raw_azimuth] * angle);
        cosine += cos(samples->items[i].values[raw_azimuth] * angle);
    }
    return sine < 0 && cosine > 0 && largest(samples, raw_altitude) > 0;
}

/* The two angles become tilt; azimuth is clockwise from "up the page". */
static void find_tilt(duct_recorded *samples, double angle, bool exchanged)
{
    bool known = largest(samples, raw_altitude) > 0;
    for (size_t i = 0; i < samples->count; i++) {
        double *values = samples->items[i].values;
        double azimuth = values[raw_azimuth] * angle;
        /* Negative where the pen is turned round to erase. */
        double altitude = fmin(fabs(values[raw_altitude]) * angle, DUCT_PI / 2);
        values[DUCT_TILT_X] = values[DUCT_TILT_Y] = NAN;
        if (known) {
            duct_recording_tilt(exchanged ? -azimuth : azimuth - DUCT_PI / 2, altitude, &values[DUCT_TILT_X],
                                &values[DUCT_TILT_Y]);
        }
    }
}

/* Moves the strokes' box to (0, 0) and turns y downwards. */
static void find_positions(duct_recorded *samples, bool exchanged)
{
    double unit = position_unit(samples), left = INFINITY, top = -INFINITY;
    for (size_t i = 0; i < samples->count; i++) {
        double *values = samples->items[i].values, x = values[DUCT_X];
        values[DUCT_X] = exchanged ? values[DUCT_Y] : x;
        values[DUCT_Y] = exchanged ? x : values[DUCT_Y];
        left = fmin(left, values[DUCT_X]);
        top = fmax(top, values[DUCT_Y]);
    }
    for (size_t i = 0; i < samples->count; i++) {
        double *values = samples->items[i].values;
        values[DUCT_X] = (values[DUCT_X] - left) * unit;
        values[DUCT_Y] = (top - values[DUCT_Y]) * unit;
    }
}

static void convert(duct_recorded *samples, int columns)
{
    double angle = angle_unit(samples), pressure = pressure_unit(samples);
    bool exchanged = columns == COLUMNS && columns_are_exchanged(samples, angle);
    duct_recorded_start_time(samples, time_unit(samples));
    find_positions(samples, exchanged);
    find_tilt(samples, angle, exchanged);
    for (size_t i = 0; i < samples->count; i++) {
        samples->items[i].values[DUCT_PRESSURE] *= pressure;
    }
    duct_recorded_drop_silent(samples);
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)options;
    cursor at;
    begin(&at, data, size);
    duct_recorded samples;
    duct_recorded_init(&samples, duct_allocator_of(context));
    duct_status status = read_samples(&at, &samples, error);
    if (status == DUCT_OK) {
        convert(&samples, at.columns);
        status = duct_recorded_make_strokes(&samples, drawing, error);
    }
    duct_recorded_free(&samples);
    return status;
}

const duct_format_impl duct_format_svc = {
    {"svc", "Handwriting recording of a tablet", "svc", true, false},
    sniff,
    read,
    NULL,
};
