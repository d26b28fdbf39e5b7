/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Recordings of W3C Pointer Events as JSON, which web pages write in forms of their own. Whatever the form,
 * an event is an object with the names that the standard gives to its members, and the events stand in the
 * order of time: in lists at any depth, or a document after the other (a line each); lists of events without
 * types are strokes. Or an object has a list of numbers under each name: the events by column.
 * docs/formats.md lists the names. */
#include "base/error.h"
#include "formats/format_private.h"
#include "formats/json_scan.h"
#include "formats/recorded.h"
#include "formats/recording.h"

#include <math.h>
#include <string.h>

enum { NAME_SIZE = 32, POINTERS = 32 };

/* An event's numbers. The three pairs of positions are in the order in which they are preferred. */
typedef enum {
    PAGE_X,
    PAGE_Y,
    CLIENT_X,
    CLIENT_Y,
    OFFSET_X,
    OFFSET_Y,
    TIME,
    PRESSURE,
    TILT_X,
    TILT_Y,
    ALTITUDE,
    AZIMUTH,
    TWIST,
    BUTTONS,
    POINTER_ID,
    FIELD_COUNT
} field;

/* What an event's type says of its pointer. */
typedef enum {
    UNSAID, /* there is no type */
    DOWN,
    MOVE,
    UP,
    OTHER,  /* an event that says nothing */
    FOREIGN /* not a pointer's event at all */
} kind;

typedef struct {
    double values[FIELD_COUNT]; /* NAN: not given */
    kind kind;
    bool mouse;
} event;

/* The numbers under one name. */
typedef struct {
    double *values;
    size_t count, capacity;
} column;

/* A pointer that is down, or was. */
typedef struct {
    double id;
    bool used, down;
    size_t stroke, list; /* the stroke being drawn, and the list that its last event stood in */
} pointer;

typedef struct {
    duct_json_scan scan;
    duct_recorded samples;
    pointer pointers[POINTERS];
    size_t next_pointer; /* the one that is given up when a new one comes */
    size_t list;         /* changes with each list that begins or ends */
    size_t events;       /* so far, drawn or not */
} reader;

static field field_of(const char *name)
{
    static const struct {
        const char *name;
        field field;
    } names[] = {
        {"x", CLIENT_X},           {"y", CLIENT_Y},     {"clientX", CLIENT_X}, {"clientY", CLIENT_Y},
        {"pageX", PAGE_X},         {"pageY", PAGE_Y},   {"offsetX", OFFSET_X}, {"offsetY", OFFSET_Y},
        {"timeStamp", TIME},       {"timestamp", TIME}, {"time", TIME},        {"t", TIME},
        {"pressure", PRESSURE},    {"tiltX", TILT_X},   {"tiltY", TILT_Y},     {"altitudeAngle", ALTITUDE},
        {"azimuthAngle", AZIMUTH}, {"twist", TWIST},    {"buttons", BUTTONS},  {"pointerId", POINTER_ID},
    };
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(names[i].name, name) == 0) {
            return names[i].field;
        }
    }
    return FIELD_COUNT;
}

static kind kind_of(const char *type)
{
    static const struct {
        const char *name;
        kind kind;
    } kinds[] = {
        {"down", DOWN}, {"move", MOVE}, {"rawupdate", MOVE}, {"up", UP},       {"cancel", UP},
        {"leave", UP},  {"out", OTHER}, {"over", OTHER},     {"enter", OTHER},
    };
    size_t skip = strncmp(type, "pointer", 7) == 0 ? 7 : strncmp(type, "mouse", 5) == 0 ? 5 : 0;
    for (size_t i = 0; skip > 0 && i < sizeof kinds / sizeof kinds[0]; i++) {
        if (strcmp(kinds[i].name, type + skip) == 0) {
            return kinds[i].kind;
        }
    }
    return strcmp(type, "gotpointercapture") == 0 || strcmp(type, "lostpointercapture") == 0 ? OTHER
                                                                                             : FOREIGN;
}

static bool contains(const char *data, size_t size, const char *word)
{
    return memmem(data, size, word, strlen(word)) != NULL;
}

static bool sniff(const char *data, size_t size)
{
    static const char *const positions[] = {"\"x\"", "\"clientX\"", "\"pageX\"", "\"offsetX\""};
    static const char *const marks[] = {"\"pressure\"", "\"tiltX\"", "\"pointerType\"", "\"pointerId\"",
                                        "\"altitudeAngle\""};
    duct_json_scan scan;
    duct_json_scan_init(&scan, data, size);
    char first = duct_json_scan_peek(&scan);
    bool position = false, mark = false;
    if (first != '{' && first != '[') {
        return false;
    }
    for (size_t i = 0; i < sizeof positions / sizeof positions[0]; i++) {
        position = position || contains(data, size, positions[i]);
    }
    for (size_t i = 0; position && i < sizeof marks / sizeof marks[0]; i++) {
        mark = mark || contains(data, size, marks[i]);
    }
    return mark;
}

static duct_status fail_json(const reader *r, duct_error *error)
{
    return duct_fail(error, DUCT_BAD_FORMAT,
                     r->scan.at >= r->scan.end ? "line %ld: the file ends within a JSON value"
                                               : "line %ld: is no well-formed JSON",
                     r->scan.line);
}

/* ---- events become samples ---- */

static pointer *find_pointer(reader *r, double id)
{
    id = isnan(id) ? 0 : id;
    for (size_t i = 0; i < POINTERS; i++) {
        if (r->pointers[i].used && r->pointers[i].id == id) {
            return &r->pointers[i];
        }
    }
    pointer *p = &r->pointers[r->next_pointer];
    r->next_pointer = (r->next_pointer + 1) % POINTERS;
    *p = (pointer){.id = id, .used = true};
    return p;
}

/* The first pair that is given, or NULL. */
static const double *position_of(const event *e)
{
    for (int i = PAGE_X; i <= OFFSET_X; i += 2) {
        if (!isnan(e->values[i]) && !isnan(e->values[i + 1])) {
            return e->values + i;
        }
    }
    return NULL;
}

/* A point of something else has a position too. */
static bool is_event(const event *e)
{
    return position_of(e) != NULL && e->kind != FOREIGN &&
           (e->kind != UNSAID || !isnan(e->values[TIME]) || !isnan(e->values[PRESSURE]) ||
            !isnan(e->values[BUTTONS]) || !isnan(e->values[POINTER_ID]));
}

/* Whether the pointer touches at a move, or at an event without type. */
static bool touches(const event *e, const pointer *p)
{
    if (!isnan(e->values[BUTTONS])) {
        return e->values[BUTTONS] > 0;
    }
    if (e->kind == MOVE && p->down) {
        return true;
    }
    return isnan(e->values[PRESSURE]) ? e->kind == UNSAID : e->values[PRESSURE] > 0;
}

static void set_values(const event *e, double values[DUCT_CHANNEL_COUNT])
{
    const double *position = position_of(e);
    values[DUCT_X] = position[0];
    values[DUCT_Y] = position[1];
    values[DUCT_T] = e->values[TIME];
    if (e->mouse) {
        return; /* it has none of the rest: a pressed button counts as pressure 0.5 */
    }
    values[DUCT_PRESSURE] = e->values[PRESSURE];
    values[DUCT_TWIST] = e->values[TWIST] * DUCT_PI / 180;
    if (!isnan(e->values[ALTITUDE]) && !isnan(e->values[AZIMUTH])) {
        /* Preferred: browsers round the tilts to degrees. */
        double altitude = fmin(fmax(e->values[ALTITUDE], 0), DUCT_PI / 2);
        duct_recording_tilt(e->values[AZIMUTH], altitude, &values[DUCT_TILT_X], &values[DUCT_TILT_Y]);
    } else {
        values[DUCT_TILT_X] = e->values[TILT_X] * DUCT_PI / 180;
        values[DUCT_TILT_Y] = e->values[TILT_Y] * DUCT_PI / 180;
    }
}

static duct_status add_event(reader *r, const event *e, duct_error *error)
{
    r->events++;
    if (e->kind == OTHER) {
        return DUCT_OK;
    }
    pointer *p = find_pointer(r, e->values[POINTER_ID]);
    bool before = p->down && e->kind != DOWN;
    p->down = e->kind == DOWN || (e->kind != UP && touches(e, p));
    if (!p->down) {
        return DUCT_OK;
    }
    if (e->kind == UNSAID && isnan(e->values[BUTTONS]) && p->list != r->list) {
        before = false;
    }
    p->list = r->list;
    p->stroke = before ? p->stroke : r->samples.stroke_count;
    duct_recorded_sample *sample;
    duct_status status = duct_recorded_add(&r->samples, p->stroke, &sample, error);
    if (status == DUCT_OK) {
        set_values(e, sample->values);
    }
    return status;
}

/* ---- JSON becomes events ---- */

static duct_status read_value(reader *r, int depth, duct_error *error);

/* A list of numbers, behind its bracket. */
static duct_status read_column(reader *r, column *c, duct_error *error)
{
    double number;
    if (duct_json_scan_take(&r->scan, ']')) {
        return DUCT_OK;
    }
    do {
        if (!duct_json_scan_number(&r->scan, &number)) {
            return fail_json(r, error);
        }
        void *values = c->values;
        if (!duct_reserve(r->samples.allocator, &values, &c->capacity, c->count + 1, sizeof *c->values)) {
            return duct_fail_memory(error);
        }
        c->values = values;
        c->values[c->count++] = number;
    } while (duct_json_scan_take(&r->scan, ','));
    return duct_json_scan_take(&r->scan, ']') ? DUCT_OK : fail_json(r, error);
}

/* The events of an object's columns, which have to be equally long. */
static duct_status add_columns(reader *r, const column columns[FIELD_COUNT], event *e, duct_error *error)
{
    size_t count = 0;
    for (int f = 0; f < FIELD_COUNT; f++) {
        size_t size = columns[f].count;
        if (size > 0 && count > 0 && size != count) {
            return duct_fail(
                error, DUCT_BAD_FORMAT,
                "line %ld: the lists of an object have %zu and %zu numbers instead of equally many",
                r->scan.line, count, size);
        }
        count = size > 0 ? size : count;
    }
    r->list++;
    duct_status status = DUCT_OK;
    for (size_t i = 0; status == DUCT_OK && i < count; i++) {
        for (int f = 0; f < FIELD_COUNT; f++) {
            e->values[f] = columns[f].count > 0 ? columns[f].values[i] : e->values[f];
        }
        e->kind = UNSAID;
        if (is_event(e)) {
            status = add_event(r, e, error);
        }
    }
    return status;
}

/* The value of a member whose name is known. */
static duct_status read_field(reader *r, field f, event *e, column columns[FIELD_COUNT], int depth,
                              duct_error *error)
{
    if (duct_json_scan_peek(&r->scan) == '[') {
        duct_json_scan ahead = r->scan;
        ahead.at++;
        char first = duct_json_scan_peek(&ahead);
        if (columns[f].count == 0 && first != '[' && first != '{' && first != '"') {
            r->scan = ahead;
            return read_column(r, &columns[f], error);
        }
        return read_value(r, depth + 1, error);
    }
    double number;
    duct_json_scan before = r->scan;
    if (duct_json_scan_number(&r->scan, &number)) {
        e->values[f] = number;
        return DUCT_OK;
    }
    r->scan = before;
    return read_value(r, depth + 1, error);
}

/* The value of a member, behind its colon. `within` is set where the value gave events that the object's own
 * would repeat. */
static duct_status read_member(reader *r, const char *name, event *e, column columns[FIELD_COUNT],
                               bool *within, int depth, duct_error *error)
{
    char word[NAME_SIZE];
    bool text = duct_json_scan_peek(&r->scan) == '"';
    if (text && (strcmp(name, "type") == 0 || strcmp(name, "pointerType") == 0)) {
        if (!duct_json_scan_string(&r->scan, word, sizeof word)) {
            return fail_json(r, error);
        }
        if (*name == 't') {
            e->kind = kind_of(word);
        } else {
            e->mouse = strcmp(word, "mouse") == 0;
        }
        return DUCT_OK;
    }
    if (strncmp(name, "predicted", 9) == 0) {
        return duct_json_scan_skip(&r->scan) ? DUCT_OK : fail_json(r, error);
    }
    field f = field_of(name);
    if (f != FIELD_COUNT) {
        return read_field(r, f, e, columns, depth, error);
    }
    size_t events = r->events;
    duct_status status = read_value(r, depth + 1, error);
    *within = *within || (strncmp(name, "coalesced", 9) == 0 && r->events > events);
    return status;
}

/* Behind its brace. */
static duct_status read_members(reader *r, event *e, column columns[FIELD_COUNT], bool *within, int depth,
                                duct_error *error)
{
    if (duct_json_scan_take(&r->scan, '}')) {
        return DUCT_OK;
    }
    do {
        char name[NAME_SIZE];
        if (!duct_json_scan_string(&r->scan, name, sizeof name) || !duct_json_scan_take(&r->scan, ':')) {
            return fail_json(r, error);
        }
        duct_status status = read_member(r, name, e, columns, within, depth, error);
        if (status != DUCT_OK) {
            return status;
        }
    } while (duct_json_scan_take(&r->scan, ','));
    return duct_json_scan_take(&r->scan, '}') ? DUCT_OK : fail_json(r, error);
}

static duct_status read_object(reader *r, int depth, duct_error *error)
{
    event e = {.kind = UNSAID};
    column columns[FIELD_COUNT] = {0};
    bool within = false, lists = false;
    for (int f = 0; f < FIELD_COUNT; f++) {
        e.values[f] = NAN;
    }
    duct_status status = read_members(r, &e, columns, &within, depth, error);
    for (int f = 0; f < FIELD_COUNT; f++) {
        lists = lists || columns[f].count > 0;
    }
    if (status == DUCT_OK && lists) {
        status = add_columns(r, columns, &e, error);
    } else if (status == DUCT_OK && !within && is_event(&e)) {
        status = add_event(r, &e, error);
    }
    for (int f = 0; f < FIELD_COUNT; f++) {
        duct_release(r->samples.allocator, columns[f].values);
    }
    return status;
}

/* Behind its bracket. */
static duct_status read_list(reader *r, int depth, duct_error *error)
{
    if (duct_json_scan_take(&r->scan, ']')) {
        return DUCT_OK;
    }
    r->list++;
    do {
        duct_status status = read_value(r, depth + 1, error);
        if (status != DUCT_OK) {
            return status;
        }
    } while (duct_json_scan_take(&r->scan, ','));
    r->list++;
    return duct_json_scan_take(&r->scan, ']') ? DUCT_OK : fail_json(r, error);
}

static duct_status read_value(reader *r, int depth, duct_error *error)
{
    if (depth > DUCT_MAX_GROUP_DEPTH) {
        return duct_fail(error, DUCT_LIMIT, "line %ld: values are nested more than %d deep", r->scan.line,
                         DUCT_MAX_GROUP_DEPTH);
    }
    if (duct_json_scan_take(&r->scan, '{')) {
        return read_object(r, depth, error);
    }
    if (duct_json_scan_take(&r->scan, '[')) {
        return read_list(r, depth, error);
    }
    return duct_json_scan_skip(&r->scan) ? DUCT_OK : fail_json(r, error);
}

static duct_status read_documents(reader *r, duct_error *error)
{
    while (duct_json_scan_peek(&r->scan) != '\0' || r->scan.at < r->scan.end) {
        duct_status status = read_value(r, 1, error);
        if (status != DUCT_OK) {
            return status;
        }
    }
    if (r->events == 0) {
        return duct_fail(error, DUCT_BAD_FORMAT,
                         "holds no pointer events: objects with x and y and at least one of "
                         "type, time, pressure, buttons");
    }
    return DUCT_OK;
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)options;
    const duct_allocator *allocator = duct_allocator_of(context);
    reader *r = duct_alloc(allocator, 1, sizeof *r);
    if (r == NULL) {
        return duct_fail_memory(error);
    }
    duct_json_scan_init(&r->scan, data, size);
    duct_recorded_init(&r->samples, allocator);
    duct_status status = read_documents(r, error);
    if (status == DUCT_OK) {
        duct_recorded_start_time(&r->samples, 0.001);
        duct_recorded_drop_silent(&r->samples);
        status = duct_recorded_make_strokes(&r->samples, drawing, error);
    }
    duct_recorded_free(&r->samples);
    duct_release(allocator, r);
    return status;
}

const duct_format_impl duct_format_pointer_events = {
    {"pointer-events", "Recording of W3C Pointer Events", "json jsonl ndjson", true, false},
    sniff,
    read,
    NULL,
};
