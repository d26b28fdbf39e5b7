/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Tables of samples, a row each, below a row of column names: docs/formats.md lists the names. The delimiter
 * is a comma, semicolon or tab, whichever lets the first row name columns x and y; cells may be quoted as in
 * RFC 4180. */
#include "base/error.h"
#include "base/number.h"
#include "formats/format_private.h"
#include "formats/recording.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

/* Behind a stroke's own channels two more columns that become tilt. */
enum {
    AZIMUTH = DUCT_CHANNEL_COUNT,
    ALTITUDE,
    VALUE_COUNT,
    STROKE = VALUE_COUNT,
    WACOM_STROKE, /* STROKE in Wacom's tables, in others the number of the row */
    IGNORED,
    MOST_COLUMNS = 256
};

typedef struct {
    int meaning; /* a duct_channel, AZIMUTH, ALTITUDE, STROKE, WACOM_STROKE or IGNORED */
    double unit; /* what a cell's number is multiplied with */
} column;

typedef struct {
    const char *at, *end;
    char delimiter;
    long line;
} cursor;

/* A cell without its quotes and the spaces around it. A doubled quote inside is left as it is. */
typedef struct {
    const char *text;
    size_t size;
    bool last; /* in its row */
} cell;

typedef struct {
    const duct_allocator *allocator;
    duct_drawing *drawing;
    cursor at;
    column columns[MOST_COLUMNS];
    size_t column_count;
    bool used[IGNORED]; /* which meanings occur */
    bool wacom;         /* whether the names are those of Wacom's Universal Ink */
    double wacom_start; /* of the first stroke, milliseconds; NAN: not met yet */
    double *samples;    /* VALUE_COUNT values a sample; NAN: the cell is empty */
    size_t sample_count, sample_capacity;
    const char *stroke; /* the text that the stroke column has now */
    size_t stroke_size;
    bool open; /* whether a stroke is being collected */
} reader;

static bool is_break(char c)
{
    return c == '\n' || c == '\r';
}

static void trim(cell *c)
{
    while (c->size > 0 && (c->text[0] == ' ' || c->text[0] == '\t')) {
        c->text++;
        c->size--;
    }
    while (c->size > 0 && (c->text[c->size - 1] == ' ' || c->text[c->size - 1] == '\t')) {
        c->size--;
    }
}

static void skip_break(cursor *at)
{
    if (at->at < at->end) {
        at->at += at->at[0] == '\r' && at->at + 1 < at->end && at->at[1] == '\n' ? 2 : 1;
        at->line++;
    }
}

/* False where a quoted cell does not end as it should. */
static bool next_cell(cursor *at, cell *c)
{
    while (at->at < at->end && (*at->at == ' ' || (*at->at == '\t' && at->delimiter != '\t'))) {
        at->at++;
    }
    bool quoted = at->at < at->end && *at->at == '"';
    c->text = at->at += quoted;
    if (quoted) {
        while (at->at < at->end && (at->at[0] != '"' || (at->at + 1 < at->end && at->at[1] == '"'))) {
            at->line += *at->at == '\n';
            at->at += *at->at == '"' ? 2 : 1;
        }
        if (at->at >= at->end) {
            return false;
        }
        c->size = (size_t)(at->at++ - c->text);
        while (at->at < at->end && *at->at == ' ') {
            at->at++;
        }
        if (at->at < at->end && *at->at != at->delimiter && !is_break(*at->at)) {
            return false;
        }
    } else {
        while (at->at < at->end && *at->at != at->delimiter && !is_break(*at->at)) {
            at->at++;
        }
        c->size = (size_t)(at->at - c->text);
        trim(c);
    }
    c->last = at->at >= at->end || *at->at != at->delimiter;
    at->at += c->last ? 0 : 1;
    return true;
}

/* Lower case letters and digits of a column's name, without the unit that it ends in: "Tilt X_deg" is
 * "tiltx". */
static void plain_name(const cell *c, char name[32], const char **unit)
{
    static const char *const units[] = {"_deg", "_rad", "_ms", "_s", "_px", "_mm"};
    size_t length = 0;
    char lower[64];
    size_t size = c->size < sizeof lower - 1 ? c->size : sizeof lower - 1;
    for (size_t i = 0; i < size; i++) {
        lower[i] = (char)(c->text[i] >= 'A' && c->text[i] <= 'Z' ? c->text[i] + 32 : c->text[i]);
    }
    *unit = "";
    for (size_t u = 0; u < sizeof units / sizeof units[0]; u++) {
        size_t ending = strlen(units[u]);
        if (size > ending && memcmp(lower + size - ending, units[u], ending) == 0) {
            *unit = units[u];
            size -= ending;
            break;
        }
    }
    for (size_t i = 0; i < size && length < 31; i++) {
        if (lower[i] != '_' && lower[i] != '-' && lower[i] != ' ') {
            name[length++] = lower[i];
        }
    }
    name[length] = '\0';
}

static column name_column(const cell *c)
{
    static const struct {
        const char *name;
        int meaning;
    } names[] = {
        {"stroke", STROKE},
        {"x", DUCT_X},
        {"y", DUCT_Y},
        {"t", DUCT_T},
        {"time", DUCT_T},
        {"pressure", DUCT_PRESSURE},
        {"tiltx", DUCT_TILT_X},
        {"tilty", DUCT_TILT_Y},
        {"twist", DUCT_TWIST},
        {"azimuth", AZIMUTH},
        {"altitude", ALTITUDE},
        {"splinex", DUCT_X},
        {"spliney", DUCT_Y},
        {"sensortimestamp", DUCT_T},
        {"sensorpressure", DUCT_PRESSURE},
        {"sensorazimuth", AZIMUTH},
        {"sensoraltitude", ALTITUDE},
        {"idx", WACOM_STROKE},
    };
    char name[32];
    const char *unit;
    plain_name(c, name, &unit);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(names[i].name, name) != 0) {
            continue;
        }
        int meaning = names[i].meaning;
        bool angle = meaning >= DUCT_TILT_X && meaning <= ALTITUDE;
        bool length = meaning == DUCT_X || meaning == DUCT_Y;
        if (*unit == '\0' || (angle && strcmp(unit, "_rad") == 0) ||
            (meaning == DUCT_T && strcmp(unit, "_s") == 0) || (length && strcmp(unit, "_px") == 0)) {
            return (column){meaning, 1};
        }
        if (angle && strcmp(unit, "_deg") == 0) {
            return (column){meaning, DUCT_PI / 180};
        }
        if (meaning == DUCT_T && strcmp(unit, "_ms") == 0) {
            return (column){meaning, 0.001};
        }
        if (length && strcmp(unit, "_mm") == 0) {
            return (column){meaning, 96 / 25.4};
        }
    }
    return (column){IGNORED, 0};
}

/* Sets the cursor to the first line that holds anything and is no comment. */
static void skip_to_names(cursor *at, const char *data, size_t size)
{
    bool mark = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0;
    *at = (cursor){mark ? data + 3 : data, data + size, ',', 1};
    while (at->at < at->end && (is_break(*at->at) || *at->at == '#')) {
        while (at->at < at->end && !is_break(*at->at)) {
            at->at++;
        }
        skip_break(at);
    }
}

/* Reads the row of names with one delimiter; DUCT_BAD_FORMAT where it names no x and y. */
static duct_status read_names(reader *r, const cursor *start, char delimiter, duct_error *error)
{
    r->at = *start;
    r->at.delimiter = delimiter;
    r->column_count = 0;
    memset(r->used, 0, sizeof r->used);
    r->wacom = false;
    cell c;
    do {
        if (!next_cell(&r->at, &c)) {
            return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: a quoted column name does not end",
                             r->at.line);
        }
        column named = name_column(&c);
        if (r->column_count == MOST_COLUMNS) {
            return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: there are more than %d columns", r->at.line,
                             MOST_COLUMNS);
        }
        r->wacom = r->wacom || (c.size > 7 && strncasecmp(c.text, "spline_", 7) == 0);
        if (named.meaning < WACOM_STROKE && r->used[named.meaning]) {
            return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: two columns are both named \"%.*s\"",
                             r->at.line, (int)(c.size < 64 ? c.size : 64), c.text);
        }
        if (named.meaning != IGNORED) {
            r->used[named.meaning] = true;
        }
        r->columns[r->column_count++] = named;
    } while (!c.last);
    if (!r->used[DUCT_X] || !r->used[DUCT_Y]) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the columns x and y are missing", start->line);
    }
    for (size_t i = 0; i < r->column_count && r->wacom && !r->used[STROKE]; i++) {
        r->used[STROKE] = r->columns[i].meaning == WACOM_STROKE;
        r->columns[i].meaning = r->used[STROKE] ? STROKE : r->columns[i].meaning;
    }
    skip_break(&r->at);
    return DUCT_OK;
}

static duct_status find_names(reader *r, const char *data, size_t size, duct_error *error)
{
    static const char delimiters[] = {',', ';', '\t'};
    cursor start;
    skip_to_names(&start, data, size);
    for (size_t i = 1; i < sizeof delimiters; i++) {
        if (read_names(r, &start, delimiters[i], NULL) == DUCT_OK) {
            return DUCT_OK;
        }
    }
    return read_names(r, &start, delimiters[0], error);
}

static bool sniff(const char *data, size_t size)
{
    reader r = {0};
    return find_names(&r, data, size, NULL) == DUCT_OK;
}

/* The id of the stroke that is being collected: the text of the stroke column, or its index where that is
 * empty. */
static duct_status make_stroke(reader *r, duct_stroke **stroke, duct_error *error)
{
    duct_status status = duct_recording_add_stroke(r->drawing, r->sample_count, stroke, error);
    if (status != DUCT_OK || r->stroke_size == 0) {
        return status;
    }
    duct_text id;
    duct_text_init(&id, r->allocator);
    for (size_t i = 0; i < r->stroke_size; i++) {
        duct_text_add_bytes(&id, r->stroke + i, 1);
        i += r->stroke[i] == '"'; /* a doubled quote */
    }
    status = id.failed ? duct_fail_memory(error) : duct_stroke_set_id(*stroke, id.data, error);
    duct_text_free(&id);
    return status;
}

/* Fills a channel with column `meaning` of the samples, unless all its cells are empty. */
static duct_status fill_channel(const reader *r, duct_stroke *stroke, duct_channel channel, duct_error *error)
{
    double *values = duct_stroke_edit(stroke, channel);
    if (values == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < r->sample_count; i++) {
        values[i] = r->samples[i * VALUE_COUNT + (size_t)channel];
    }
    if (!duct_recording_fill_gaps(values, r->sample_count)) {
        duct_stroke_drop(stroke, channel);
    }
    return DUCT_OK;
}

static void tilt_from_angles(reader *r)
{
    for (size_t i = 0; i < r->sample_count; i++) {
        double *sample = r->samples + i * VALUE_COUNT;
        duct_recording_tilt(sample[AZIMUTH], sample[ALTITUDE], &sample[DUCT_TILT_X], &sample[DUCT_TILT_Y]);
    }
}

/* Universal Ink's timestamp is the stroke's beginning in whole milliseconds plus the *seconds* since then. It
 * becomes seconds since the first stroke's beginning. */
static void wacom_time(reader *r)
{
    double begin = NAN;
    for (size_t i = 0; i < r->sample_count; i++) {
        double *time = &r->samples[i * VALUE_COUNT + DUCT_T];
        begin = isnan(begin) ? floor(*time) : begin;
        r->wacom_start = isnan(r->wacom_start) ? begin : r->wacom_start;
        *time = (begin - r->wacom_start) / 1000 + (*time - begin);
    }
}

static duct_status end_stroke(reader *r, duct_error *error)
{
    if (!r->open) {
        return DUCT_OK;
    }
    bool angles = r->used[AZIMUTH] && r->used[ALTITUDE] && !r->used[DUCT_TILT_X] && !r->used[DUCT_TILT_Y];
    if (angles) {
        tilt_from_angles(r);
    }
    if (r->wacom && r->used[DUCT_T]) {
        wacom_time(r);
    }
    duct_stroke *stroke = NULL;
    duct_status status = make_stroke(r, &stroke, error);
    for (int c = 0; status == DUCT_OK && c < DUCT_CHANNEL_COUNT; c++) {
        if (r->used[c] || (angles && (c == DUCT_TILT_X || c == DUCT_TILT_Y))) {
            status = fill_channel(r, stroke, (duct_channel)c, error);
        }
    }
    if (status == DUCT_OK) {
        duct_recording_tidy(stroke);
    }
    r->sample_count = 0;
    r->open = false;
    return status;
}

static duct_status read_row(reader *r, double sample[VALUE_COUNT], cell *stroke, duct_error *error)
{
    size_t index = 0;
    cell c;
    long line = r->at.line;
    do {
        if (!next_cell(&r->at, &c)) {
            return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: a quoted cell does not end", line);
        }
        if (index >= r->column_count) {
            if (c.last && c.size == 0) {
                break; /* a delimiter at the end of each line is common */
            }
            return duct_fail(error, DUCT_BAD_FORMAT,
                             "line %ld: there are more cells than the %zu column names", line,
                             r->column_count);
        }
        const column *named = &r->columns[index++];
        if (named->meaning == STROKE) {
            *stroke = c;
        } else if (named->meaning < STROKE && c.size > 0) {
            const char *end;
            double number;
            trim(&c);
            if (!duct_number_scan(c.text, &end, &number) || end != c.text + c.size || !isfinite(number)) {
                return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: column %zu: \"%.*s\" is no number", line,
                                 index, (int)(c.size < 40 ? c.size : 40), c.text);
            }
            sample[named->meaning] = number * named->unit;
        }
    } while (!c.last);
    skip_break(&r->at);
    return DUCT_OK;
}

static duct_status add_row(reader *r, const double sample[VALUE_COUNT], cell stroke, long line,
                           duct_error *error)
{
    bool same = !r->used[STROKE] ||
                (stroke.size == r->stroke_size && memcmp(stroke.text, r->stroke, stroke.size) == 0);
    if (r->open && !same) {
        duct_status status = end_stroke(r, error);
        if (status != DUCT_OK) {
            return status;
        }
    }
    r->open = true;
    r->stroke = stroke.text;
    r->stroke_size = stroke.size;
    if (isnan(sample[DUCT_X]) != isnan(sample[DUCT_Y])) {
        return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: one of x and y is missing", line);
    }
    if (isnan(sample[DUCT_X])) {
        return DUCT_OK;
    }
    void *samples = r->samples;
    if (r->sample_count >= DUCT_MAX_SAMPLES) {
        return duct_fail(error, DUCT_LIMIT, "line %ld: a stroke may have %d samples at most", line,
                         DUCT_MAX_SAMPLES);
    }
    if (!duct_reserve(r->allocator, &samples, &r->sample_capacity, r->sample_count + 1,
                      VALUE_COUNT * sizeof(double))) {
        return duct_fail_memory(error);
    }
    r->samples = samples;
    memcpy(r->samples + r->sample_count++ * VALUE_COUNT, sample, VALUE_COUNT * sizeof *sample);
    return DUCT_OK;
}

static duct_status read_rows(reader *r, duct_error *error)
{
    duct_status status = DUCT_OK;
    while (status == DUCT_OK && r->at.at < r->at.end) {
        if (is_break(*r->at.at)) {
            skip_break(&r->at); /* an empty line ends a stroke */
            status = end_stroke(r, error);
            continue;
        }
        double sample[VALUE_COUNT];
        for (int c = 0; c < VALUE_COUNT; c++) {
            sample[c] = NAN;
        }
        cell stroke = {"", 0, false};
        long line = r->at.line;
        status = read_row(r, sample, &stroke, error);
        if (status == DUCT_OK) {
            status = add_row(r, sample, stroke, line, error);
        }
    }
    return status == DUCT_OK ? end_stroke(r, error) : status;
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)options;
    reader r = {
        .allocator = duct_allocator_of(context), .drawing = drawing, .stroke = "", .wacom_start = NAN};
    duct_status status = find_names(&r, data, size, error);
    if (status == DUCT_OK) {
        status = read_rows(&r, error);
    }
    duct_release(r.allocator, r.samples);
    return status;
}

/* True where the ids can stand in the stroke column: none is empty or the same as the one before it. */
static bool ids_tell_strokes_apart(const duct_drawing *drawing)
{
    const char *before = "";
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        const char *id = duct_stroke_id(duct_drawing_stroke(drawing, i));
        if (strcmp(id, before) == 0) {
            return false;
        }
        before = id;
        if (*id == '\0') {
            return false;
        }
    }
    return true;
}

static void add_id(duct_text *out, const char *id)
{
    if (id[strcspn(id, " ,;\t\"\r\n#")] == '\0') {
        duct_text_add(out, id);
        return;
    }
    duct_text_add(out, "\"");
    for (const char *s = id; *s != '\0'; s++) {
        duct_text_add_bytes(out, *s == '"' ? "\"\"" : s, *s == '"' ? 2 : 1);
    }
    duct_text_add(out, "\"");
}

static void write_stroke(const duct_stroke *stroke, const char *id, const bool used[DUCT_CHANNEL_COUNT],
                         duct_text *out)
{
    size_t size = duct_stroke_size(stroke);
    /* A stroke without samples is a row without values. */
    for (size_t i = 0; i < size || (i == 0 && size == 0); i++) {
        add_id(out, id);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            const double *values = duct_stroke_values(stroke, (duct_channel)c);
            if (used[c]) {
                duct_text_add(out, ",");
            }
            if (used[c] && values != NULL && size > 0) {
                duct_text_add_number(out, values[i], 0);
            }
        }
        duct_text_add(out, "\n");
    }
}

static duct_status write(const duct_context *context, const duct_drawing *drawing,
                         const duct_format_options *options, duct_text *out, duct_error *error)
{
    static const char *const names[DUCT_CHANNEL_COUNT] = {"x",      "y",      "t",    "pressure",
                                                          "tilt_x", "tilt_y", "twist"};
    (void)context;
    (void)options;
    bool used[DUCT_CHANNEL_COUNT];
    duct_text_add(out, "stroke");
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        used[c] = c <= DUCT_Y || duct_drawing_has(drawing, (duct_channel)c);
        duct_text_addf(out, used[c] ? ",%s" : "%.0s", names[c]);
    }
    duct_text_add(out, "\n");
    bool ids = ids_tell_strokes_apart(drawing);
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing) && !out->failed; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        char index[24];
        snprintf(index, sizeof index, "%zu", i);
        write_stroke(stroke, ids ? duct_stroke_id(stroke) : index, used, out);
    }
    return out->failed ? duct_fail_memory(error) : DUCT_OK;
}

const duct_format_impl duct_format_csv = {
    {"csv", "Table of samples", "csv tsv", true, true},
    sniff,
    read,
    write,
};
