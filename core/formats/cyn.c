/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The recordings of HelpingHand (Lu, Yu, Finkelstein, DiVerdi 2012), `.cyn`: lines of text,
 *
 *     #, Version 0.0, #, photoshop 5         (a header, which may be missing as a whole)
 *     1, PATH                                (how many names follow, and the names)
 *     COUNT                                  (of strokes)
 *     stroke INDEX, COUNT                    (of samples), and a line of eight numbers a sample:
 *     index  time  x  y  pressure  rotation  tilt_x  tilt_y
 *
 * Time is in seconds, x and y are fractions of the canvas (y down), which is taken as a page of 2000 x 2000
 * pixels, as the paper does; rotation is in degrees. Tilt -1..1 stands for -60..60 degrees, the full scale of
 * Wacom's drivers, which is also what libmypaint takes. Tilt y and rotation are measured with y up, unlike
 * the positions and unlike Pointer Events: in the recordings the pens of right-handed writers lean "away"
 * from them and turn back as the hand moves to the right, which no hand does. So both change their sign here.
 * A channel that is 0 throughout a file was not recorded and is absent (the two tilts together). */
#include "base/error.h"
#include "base/number.h"
#include "formats/format_private.h"
#include "formats/recording.h"

#include <math.h>
#include <string.h>

#define PAGE 2000.0
#define FULL_TILT (DUCT_PI / 3)
#define NOMINAL_STEP 0.007

enum {
    COLUMNS = 8,
    SHORTEST_SAMPLE = 2 * COLUMNS - 1,
    SHORTEST_STROKE = sizeof "stroke 0\n0" - 1,
    DIGITS = 9
};

static bool starts_with(const char *line, size_t size, const char *word)
{
    size_t length = strlen(word);
    return size >= length && memcmp(line, word, length) == 0;
}

/* A count of at most 19 digits and nothing else on the line. */
static bool parse_count(const char *line, size_t size, size_t *count)
{
    size_t value = 0;
    if (size == 0 || size > 19) {
        return false;
    }
    for (size_t i = 0; i < size; i++) {
        if (line[i] < '0' || line[i] > '9') {
            return false;
        }
        value = value * 10 + (size_t)(line[i] - '0');
    }
    *count = value;
    return true;
}

static bool sniff(const char *data, size_t size)
{
    duct_lines lines;
    const char *line;
    size_t length, count;
    duct_lines_init(&lines, data, size);
    bool header = false, counted = false;
    while (duct_lines_next_filled(&lines, &line, &length) && lines.number <= 40) {
        if (line[0] == '#') {
            continue;
        }
        if (starts_with(line, length, "photoshop ") && header) {
            return true;
        }
        if (starts_with(line, length, "stroke ")) {
            return counted;
        }
        header = header || starts_with(line, length, "Version ");
        counted = parse_count(line, length, &count);
        if (!header && !counted) {
            return false;
        }
    }
    return false;
}

/* Reads up to the number of strokes. */
static duct_status read_header(duct_lines *lines, size_t *count, duct_error *error)
{
    const char *line;
    size_t size, names;
    bool header = false, named = false;
    while (duct_lines_next_filled(lines, &line, &size)) {
        if (line[0] == '#' || starts_with(line, size, "Version ") || starts_with(line, size, "photoshop ")) {
            header = true;
        } else if (header && !named) {
            if (!parse_count(line, size, &names)) {
                return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the number of names is expected",
                                 lines->number);
            }
            named = true;
        } else if (parse_count(line, size, count)) {
            return DUCT_OK;
        } else if (!header || starts_with(line, size, "stroke ")) {
            break;
        }
    }
    return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the number of strokes is expected", lines->number);
}

static duct_status read_sample(duct_lines *lines, size_t stroke, double values[COLUMNS], duct_error *error)
{
    const char *line;
    size_t size;
    if (!duct_lines_next_filled(lines, &line, &size)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: stroke %zu: the file ends before the stroke does",
                         lines->number, stroke);
    }
    const char *at = line, *end = line + size;
    for (int c = 0; c < COLUMNS; c++) {
        while (at < end && (*at == ' ' || *at == '\t')) {
            at++;
        }
        if (at >= end || !duct_number_scan(at, &at, &values[c]) || !isfinite(values[c]) ||
            (at < end && *at != ' ' && *at != '\t')) {
            return duct_fail(error, DUCT_BAD_FORMAT,
                             "line %ld: stroke %zu: number %d of %d is missing or is no number",
                             lines->number, stroke, c + 1, COLUMNS);
        }
    }
    if (at < end) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: stroke %zu: there are more than %d numbers",
                         lines->number, stroke, COLUMNS);
    }
    return DUCT_OK;
}

/* The lines before a stroke's samples. Memory is taken only after this, and never for more than the file can
 * hold. */
static duct_status read_stroke_header(duct_lines *lines, size_t index, size_t *count, duct_error *error)
{
    const char *line;
    size_t size;
    if (!duct_lines_next_filled(lines, &line, &size) || !starts_with(line, size, "stroke")) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the beginning of stroke %zu is expected",
                         lines->number, index);
    }
    if (!duct_lines_next_filled(lines, &line, &size) || !parse_count(line, size, count)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: stroke %zu: the number of samples is expected",
                         lines->number, index);
    }
    if (*count > (size_t)(lines->end - lines->at) / SHORTEST_SAMPLE) {
        return duct_fail(error, DUCT_BAD_FORMAT,
                         "line %ld: stroke %zu: %zu samples are announced, but fewer follow", lines->number,
                         index, *count);
    }
    return DUCT_OK;
}

static duct_status read_stroke(duct_lines *lines, duct_drawing *drawing, bool seen[DUCT_CHANNEL_COUNT],
                               duct_error *error)
{
    static const duct_channel order[COLUMNS - 1] = {DUCT_T,     DUCT_X,      DUCT_Y,     DUCT_PRESSURE,
                                                    DUCT_TWIST, DUCT_TILT_X, DUCT_TILT_Y};
    static const double unit[COLUMNS - 1] = {1, PAGE, PAGE, 1, -DUCT_PI / 180, FULL_TILT, -FULL_TILT};
    size_t index = duct_drawing_stroke_count(drawing), count = 0;
    duct_status status = read_stroke_header(lines, index, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_stroke *stroke;
    status = duct_recording_add_stroke(drawing, count, &stroke, error);
    double *channels[COLUMNS - 1];
    for (int c = 0; status == DUCT_OK && c < COLUMNS - 1; c++) {
        channels[c] = duct_stroke_edit(stroke, order[c]);
        status = channels[c] != NULL ? DUCT_OK : duct_fail_memory(error);
    }
    for (size_t i = 0; status == DUCT_OK && i < count; i++) {
        double values[COLUMNS];
        status = read_sample(lines, index, values, error);
        for (int c = 0; status == DUCT_OK && c < COLUMNS - 1; c++) {
            channels[c][i] = values[c + 1] * unit[c];
            seen[order[c]] = seen[order[c]] || values[c + 1] != 0;
            if (!isfinite(channels[c][i])) {
                status = duct_fail(error, DUCT_BAD_FORMAT, "line %ld: stroke %zu: number %d is out of range",
                                   lines->number, index, c + 2);
            }
        }
    }
    if (status == DUCT_OK) {
        duct_recording_tidy(stroke);
    }
    return status;
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)context;
    (void)options;
    duct_lines lines;
    size_t count = 0;
    duct_lines_init(&lines, data, size);
    duct_status status = read_header(&lines, &count, error);
    if (status == DUCT_OK && count > (size_t)(lines.end - lines.at) / SHORTEST_STROKE) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: %zu strokes are announced, but fewer follow",
                         lines.number, count);
    }
    bool seen[DUCT_CHANNEL_COUNT] = {false};
    for (size_t i = 0; status == DUCT_OK && i < count; i++) {
        status = read_stroke(&lines, drawing, seen, error);
    }
    const char *line;
    if (status == DUCT_OK && duct_lines_next_filled(&lines, &line, &size)) {
        return duct_fail(error, DUCT_BAD_FORMAT,
                         "line %ld: nothing is expected behind stroke %zu, the last of %zu", lines.number,
                         count - 1, count);
    }
    if (status != DUCT_OK) {
        return status;
    }
    seen[DUCT_T] = true;
    seen[DUCT_TILT_X] = seen[DUCT_TILT_Y] = seen[DUCT_TILT_X] || seen[DUCT_TILT_Y];
    for (size_t i = 0; i < count; i++) {
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            if (!seen[c]) {
                duct_stroke_drop(duct_drawing_edit_stroke(drawing, i), (duct_channel)c);
            }
        }
    }
    duct_drawing_set_page(drawing, PAGE, PAGE);
    return DUCT_OK;
}

/* A number with a space before and some behind it, in a column as wide as Photoshop's recorder makes it. */
static void add_column(duct_text *out, double value)
{
    char buffer[DUCT_NUMBER_SIZE];
    duct_number_print(buffer, value == 0 ? 0 : value, DIGITS);
    duct_text_addf(out, " %-13s", buffer);
}

/* Degrees in 0..360. What would be printed as 360 becomes 0. */
static double wrapped_degrees(double radians)
{
    double degrees = fmod(radians * 180 / DUCT_PI, 360);
    degrees = degrees < 0 ? degrees + 360 : degrees;
    return degrees >= 360 - 5e-7 ? 0 : degrees;
}

static void write_stroke(const duct_stroke *stroke, const double origin[2], double scale, duct_text *out)
{
    const double *channels[DUCT_CHANNEL_COUNT];
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        channels[c] = duct_stroke_values(stroke, (duct_channel)c);
    }
    const double *time = channels[DUCT_T], *pressure = channels[DUCT_PRESSURE], *twist = channels[DUCT_TWIST];
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        duct_text_addf(out, "%-4zu", i);
        add_column(out, time != NULL ? time[i] : NOMINAL_STEP * (double)i);
        add_column(out, (channels[DUCT_X][i] - origin[0]) / scale);
        add_column(out, (channels[DUCT_Y][i] - origin[1]) / scale);
        add_column(out, pressure != NULL ? pressure[i] : 0);
        add_column(out, twist != NULL ? wrapped_degrees(-twist[i]) : 0);
        add_column(out, channels[DUCT_TILT_X] != NULL ? channels[DUCT_TILT_X][i] / FULL_TILT : 0);
        add_column(out, channels[DUCT_TILT_Y] != NULL ? -channels[DUCT_TILT_Y][i] / FULL_TILT : 0);
        duct_text_add(out, "\r\n");
    }
}

static duct_status write(const duct_context *context, const duct_drawing *drawing,
                         const duct_format_options *options, duct_text *out, duct_error *error)
{
    (void)context;
    (void)options;
    double origin[2] = {0, 0};
    double scale = fmax(duct_drawing_width(drawing), duct_drawing_height(drawing));
    double box[4];
    if (!(scale > 0) && duct_drawing_bounds(drawing, box)) {
        origin[0] = box[0];
        origin[1] = box[1];
        scale = fmax(box[2] - box[0], box[3] - box[1]);
    }
    scale = scale > 0 ? scale : 1;
    size_t count = duct_drawing_stroke_count(drawing);
    duct_text_addf(out, "#\r\nVersion 0.0\r\n#\r\n\r\nphotoshop 5\r\n1\r\nunrelated\r\n\r\n%zu\r\n", count);
    for (size_t i = 0; i < count && !out->failed; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        duct_text_addf(out, "stroke %zu\r\n%zu\r\n", i, duct_stroke_size(stroke));
        write_stroke(stroke, origin, scale, out);
        duct_text_add(out, "\r\n");
    }
    return out->failed ? duct_fail_memory(error) : DUCT_OK;
}

const duct_format_impl duct_format_cyn = {
    {"cyn", "HelpingHand recording", "cyn", true, true},
    sniff,
    read,
    write,
};
