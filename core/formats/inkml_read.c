/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reading InkML in three steps: the document is walked, which makes the strokes and remembers which traces
 * each one consists of; then their texts are decoded; then what needs all strokes is done (flipped axes,
 * pressure without a declared range). */
#include "base/error.h"
#include "base/number.h"
#include "formats/inkml_private.h"
#include "formats/recording.h"
#include "formats/xml.h"

#include <math.h>
#include <string.h>

#define NOTHING ((size_t)-1)

typedef struct {
    const xmlNode *trace;
    size_t state; /* index of what is in force */
    size_t next;  /* the trace that continues it, or NOTHING */
} segment;

typedef struct {
    size_t first, last; /* segments */
    bool flipped[2], open_range;
} chain;

typedef struct {
    duct_drawing *drawing;
    duct_inkml_document document;
    duct_inkml_state *states;
    size_t state_count, state_capacity;
    segment *segments;
    size_t segment_count, segment_capacity;
    chain *chains; /* one a stroke */
    size_t chain_capacity;
    duct_text group;    /* the path of the groups that are open */
    size_t group_bytes; /* in the paths of all strokes */
    size_t unnamed;     /* groups without a name so far */
} reader;

/* ---- the walk ---- */

static bool same_state(const duct_inkml_state *a, const duct_inkml_state *b)
{
    return a->format == b->format && a->source == b->source && a->transform == b->transform &&
           a->canvas == b->canvas && a->timestamp == b->timestamp;
}

static duct_status add_segment(reader *r, const xmlNode *trace, const duct_inkml_state *state,
                               duct_error *error)
{
    if (r->state_count == 0 || !same_state(&r->states[r->state_count - 1], state)) {
        void *states = r->states;
        if (!duct_reserve(r->document.allocator, &states, &r->state_capacity, r->state_count + 1,
                          sizeof *state)) {
            return duct_fail_memory(error);
        }
        r->states = states;
        r->states[r->state_count++] = *state;
    }
    void *segments = r->segments;
    if (!duct_reserve(r->document.allocator, &segments, &r->segment_capacity, r->segment_count + 1,
                      sizeof(segment))) {
        return duct_fail_memory(error);
    }
    r->segments = segments;
    r->segments[r->segment_count++] = (segment){trace, r->state_count - 1, NOTHING};
    return DUCT_OK;
}

static duct_status make_stroke(reader *r, const xmlNode *trace, const duct_inkml_state *state,
                               duct_error *error)
{
    size_t index = duct_drawing_stroke_count(r->drawing);
    void *chains = r->chains;
    if (!duct_reserve(r->document.allocator, &chains, &r->chain_capacity, index + 1, sizeof(chain))) {
        return duct_fail_memory(error);
    }
    r->chains = chains;
    r->chains[index] = (chain){r->segment_count - 1, r->segment_count - 1, {false, false}, false};
    duct_stroke *stroke;
    duct_status status = duct_recording_add_stroke(r->drawing, 0, &stroke, error);
    if (status != DUCT_OK) {
        return status;
    }
    const char *id = duct_inkml_own_attribute(trace, "id");
    id = id != NULL ? id : duct_inkml_id(trace);
    if (id != NULL) {
        status = duct_stroke_set_id(stroke, id, error);
    }
    if (status == DUCT_OK && r->group.size > 0) {
        r->group_bytes += r->group.size;
        status = r->group_bytes <= DUCT_INKML_GROUP_BYTES
                     ? duct_stroke_set_group(stroke, r->group.data, error)
                     : duct_fail(error, DUCT_LIMIT,
                                 "line %ld: the names of groups are too long for so many traces",
                                 xmlGetLineNo(trace));
    }
    const char *closed = duct_inkml_own_attribute(trace, "closed");
    duct_stroke_set_closed(stroke, closed != NULL && strcmp(closed, "true") == 0);
    duct_stroke_set_style(stroke, state->style);
    return status;
}

/* The stroke that a trace goes on with, or -1 for a new one. */
static duct_status find_prior(const reader *r, const xmlNode *trace, long *stroke, duct_error *error)
{
    const char *continuation = duct_inkml_attribute(trace, "continuation");
    *stroke = -1;
    if (continuation == NULL || strcmp(continuation, "begin") == 0) {
        return DUCT_OK;
    }
    const char *reference = duct_inkml_attribute(trace, "priorRef");
    const duct_inkml_entry *prior = duct_inkml_index_find(&r->document.index, reference);
    if (prior == NULL || prior->stroke < 0) {
        return duct_inkml_fail(trace, error, "priorRef \"%.60s\" names no earlier trace",
                               reference != NULL ? reference : "");
    }
    *stroke = prior->stroke;
    return DUCT_OK;
}

static duct_status walk_trace(reader *r, const xmlNode *trace, const duct_inkml_state *inherited,
                              duct_error *error)
{
    const char *type = duct_inkml_attribute(trace, "type");
    if (type != NULL && strcmp(type, "penUp") == 0) {
        return DUCT_OK;
    }
    duct_inkml_state state = *inherited;
    long stroke = -1;
    duct_status status = duct_inkml_apply_references(&r->document, trace, &state, error);
    if (status == DUCT_OK) {
        status = find_prior(r, trace, &stroke, error);
    }
    if (status == DUCT_OK) {
        status = add_segment(r, trace, &state, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    if (stroke >= 0) {
        chain *c = &r->chains[stroke];
        r->segments[c->last].next = r->segment_count - 1;
        c->last = r->segment_count - 1;
    } else {
        stroke = (long)duct_drawing_stroke_count(r->drawing);
        status = make_stroke(r, trace, &state, error);
    }
    const char *id = duct_inkml_id(trace);
    duct_inkml_entry *entry = id != NULL ? duct_inkml_index_find_id(&r->document.index, id) : NULL;
    if (entry != NULL && entry->node == trace) {
        entry->stroke = stroke;
    }
    return status;
}

/* Adds a group's name to the path: its label, its id, or a number. */
static duct_status enter_group(reader *r, const xmlNode *node, bool first, duct_error *error)
{
    const xmlNode *label = NULL;
    int looked = 0;
    for (const xmlNode *child = node->children; child != NULL && looked < DUCT_INKML_MOST_CHILDREN;
         child = child->next) {
        looked++;
        const char *type = duct_inkml_is(child, "annotation") ? duct_inkml_attribute(child, "type") : NULL;
        if (type != NULL && (strcmp(type, "label") == 0 || strcmp(type, "name") == 0)) {
            label = child;
            break;
        }
    }
    if (!first) {
        duct_text_add(&r->group, "/");
    }
    const char *id = duct_inkml_id(node);
    if (label != NULL) {
        xmlChar *made;
        duct_text_add(&r->group, duct_inkml_text(label, &made));
        xmlFree(made);
    } else if (id != NULL) {
        duct_text_add(&r->group, id);
    } else {
        duct_text_addf(&r->group, "group %zu", ++r->unnamed);
    }
    if (r->group.failed) {
        return duct_fail_memory(error);
    }
    if (r->group.size > DUCT_INKML_LONGEST_GROUP) {
        return duct_inkml_fail(node, error,
                               "the names of the groups that hold this one are longer than %d bytes",
                               DUCT_INKML_LONGEST_GROUP);
    }
    return DUCT_OK;
}

/* The depth is bounded by duct_xml_parse(). */
static duct_status walk_group(reader *r, const xmlNode *group, const duct_inkml_state *inherited, bool first,
                              duct_error *error)
{
    duct_inkml_state state = *inherited;
    size_t before = r->group.size;
    duct_status status = duct_inkml_apply_references(&r->document, group, &state, error);
    if (status == DUCT_OK) {
        status = enter_group(r, group, first, error);
    }
    for (const xmlNode *child = group->children; status == DUCT_OK && child != NULL; child = child->next) {
        if (duct_inkml_is(child, "trace")) {
            status = walk_trace(r, child, &state, error);
        } else if (duct_inkml_is(child, "traceGroup")) {
            status = walk_group(r, child, &state, false, error);
        }
    }
    if (!r->group.failed && r->group.data != NULL) {
        r->group.size = before;
        r->group.data[before] = '\0';
    }
    return status;
}

static duct_status walk_annotation(reader *r, const xmlNode *node, duct_error *error)
{
    const char *type = duct_inkml_attribute(node, "type");
    bool markup = duct_inkml_is(node, "annotationXML");
    if (markup && (type == NULL || strcmp(type, DUCT_INKML_OWN_NAMESPACE) == 0)) {
        return DUCT_OK;
    }
    xmlChar *made;
    const char *text = duct_inkml_text(node, &made);
    duct_status status = duct_drawing_annotate(r->drawing, type != NULL ? type : "annotation", text, error);
    xmlFree(made);
    return status;
}

static duct_status walk(reader *r, const xmlNode *root, duct_error *error)
{
    duct_inkml_state state = {.style = {0, 0, 0, 1, 0}};
    duct_status status = DUCT_OK;
    for (const xmlNode *child = root->children; status == DUCT_OK && child != NULL; child = child->next) {
        if (duct_inkml_is(child, "trace")) {
            status = walk_trace(r, child, &state, error);
        } else if (duct_inkml_is(child, "traceGroup")) {
            status = walk_group(r, child, &state, true, error);
        } else if (duct_inkml_is(child, "context")) {
            status = duct_inkml_apply_context(&r->document, child, &state, error);
        } else if (duct_inkml_is(child, "annotation") || duct_inkml_is(child, "annotationXML")) {
            status = walk_annotation(r, child, error);
        } else if (child->type == XML_ELEMENT_NODE) {
            /* Not where the standard has them, but where some programs write them. */
            duct_inkml_apply_part(&r->document, child, &state);
        }
    }
    return status;
}

/* ---- the traces ---- */

/* Time where the samples have none, by the sample rate; and from a time's own beginning to the common one. */
static void date_samples(const segment *s, const duct_inkml_state *state, const duct_inkml_format *format,
                         size_t begin, duct_inkml_samples *samples)
{
    double offset = 0;
    bool shifted = duct_inkml_number(s->trace, "timeOffset", &offset);
    double base = shifted && !format->dated ? state->timestamp + offset / 1000 : 0;
    for (size_t i = begin; i < samples->count; i++) {
        double *t = &samples->values[i * DUCT_INKML_MEANINGS + DUCT_T];
        if (isnan(*t) && format->rate > 0) {
            *t = (double)i / format->rate;
        }
        *t += base;
    }
}

static void tilt_from_angles(const duct_inkml_samples *samples)
{
    for (size_t i = 0; i < samples->count; i++) {
        double *sample = samples->values + i * DUCT_INKML_MEANINGS;
        if (isnan(sample[DUCT_TILT_X]) && isnan(sample[DUCT_TILT_Y]) && !isnan(sample[DUCT_INKML_AZIMUTH]) &&
            !isnan(sample[DUCT_INKML_ELEVATION])) {
            duct_recording_tilt(sample[DUCT_INKML_AZIMUTH], sample[DUCT_INKML_ELEVATION],
                                &sample[DUCT_TILT_X], &sample[DUCT_TILT_Y]);
        }
    }
}

static duct_status fill_stroke(duct_stroke *stroke, const duct_inkml_samples *samples, duct_error *error)
{
    duct_status status = duct_stroke_resize(stroke, samples->count, error);
    for (int c = 0; status == DUCT_OK && c < DUCT_CHANNEL_COUNT; c++) {
        bool known = c <= DUCT_Y;
        for (size_t i = 0; i < samples->count && !known; i++) {
            known = !isnan(samples->values[i * DUCT_INKML_MEANINGS + (size_t)c]);
        }
        double *values = known ? duct_stroke_edit(stroke, (duct_channel)c) : NULL;
        if (values == NULL) {
            status = known ? duct_fail_memory(error) : DUCT_OK;
            continue;
        }
        for (size_t i = 0; i < samples->count; i++) {
            values[i] = samples->values[i * DUCT_INKML_MEANINGS + (size_t)c];
        }
        duct_recording_fill_gaps(values, samples->count);
    }
    return status;
}

static void note_format(const duct_inkml_format *format, chain *c)
{
    for (size_t i = 0; i < format->count; i++) {
        const duct_inkml_channel *channel = &format->channels[i];
        if (channel->meaning <= DUCT_Y) {
            c->flipped[channel->meaning] = channel->flipped;
        }
        c->open_range = c->open_range || channel->open_range;
    }
}

static duct_status read_traces(reader *r, duct_error *error)
{
    duct_inkml_samples samples = {.allocator = r->document.allocator};
    duct_inkml_format format = {.count = 0};
    size_t made_for = NOTHING, total = 0;
    duct_status status = DUCT_OK;
    for (size_t i = 0; status == DUCT_OK && i < duct_drawing_stroke_count(r->drawing); i++) {
        samples.count = 0;
        size_t next = r->chains[i].first;
        while (status == DUCT_OK && next != NOTHING) {
            const segment *s = &r->segments[next];
            if (s->state != made_for) {
                status = duct_inkml_make_format(&r->document, &r->states[s->state], &format, error);
                made_for = status == DUCT_OK ? s->state : NOTHING;
            }
            size_t begin = samples.count;
            if (status == DUCT_OK) {
                status =
                    duct_inkml_parse_trace(s->trace, &format, next == r->chains[i].first, &samples, error);
            }
            if (status == DUCT_OK) {
                note_format(&format, &r->chains[i]);
                date_samples(s, &r->states[s->state], &format, begin, &samples);
            }
            next = s->next;
        }
        if (status == DUCT_OK && samples.count > DUCT_MAX_SAMPLES - total) {
            status =
                duct_fail(error, DUCT_LIMIT, "a drawing may have %d samples at most; split it into several",
                          DUCT_MAX_SAMPLES);
        }
        if (status == DUCT_OK) {
            total += samples.count;
            tilt_from_angles(&samples);
            status = fill_stroke(duct_drawing_edit_stroke(r->drawing, i), &samples, error);
        }
    }
    duct_release(samples.allocator, samples.values);
    return status;
}

/* ---- what needs all strokes ---- */

/* An axis that points the other way is turned already; now it begins at the page's end or, where there is no
 * page, where the strokes do. */
static void shift_flipped(const reader *r, duct_channel axis)
{
    double page = axis == DUCT_X ? duct_drawing_width(r->drawing) : duct_drawing_height(r->drawing);
    double lowest = INFINITY;
    for (size_t i = 0; i < duct_drawing_stroke_count(r->drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(r->drawing, i);
        const double *values = duct_stroke_values(stroke, axis);
        for (size_t k = 0; r->chains[i].flipped[axis] && k < duct_stroke_size(stroke); k++) {
            lowest = fmin(lowest, values[k]);
        }
    }
    double shift = page > 0 ? page : -lowest;
    for (size_t i = 0; isfinite(shift) && i < duct_drawing_stroke_count(r->drawing); i++) {
        if (r->chains[i].flipped[axis]) {
            duct_stroke *stroke = duct_drawing_edit_stroke(r->drawing, i);
            double *values = duct_stroke_edit(stroke, axis);
            for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
                values[k] += shift;
            }
        }
    }
}

/* Pressure without a declared range: where it goes beyond 1, the strongest in the file is full pressure. */
static void scale_open_pressure(const reader *r)
{
    double strongest = 1;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < duct_drawing_stroke_count(r->drawing); i++) {
            duct_stroke *stroke = duct_drawing_edit_stroke(r->drawing, i);
            if (!r->chains[i].open_range || duct_stroke_values(stroke, DUCT_PRESSURE) == NULL) {
                continue;
            }
            double *values = duct_stroke_edit(stroke, DUCT_PRESSURE);
            for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
                strongest = pass == 0 ? fmax(strongest, values[k]) : strongest;
                values[k] = pass == 1 ? values[k] / strongest : values[k];
            }
        }
    }
}

static duct_status finish(const reader *r, duct_error *error)
{
    shift_flipped(r, DUCT_X);
    shift_flipped(r, DUCT_Y);
    scale_open_pressure(r);
    for (size_t i = 0; i < duct_drawing_stroke_count(r->drawing); i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(r->drawing, i);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            const double *values = duct_stroke_values(stroke, (duct_channel)c);
            for (size_t k = 0; values != NULL && k < duct_stroke_size(stroke); k++) {
                if (!isfinite(values[k])) {
                    return duct_fail(error, DUCT_BAD_FORMAT, "stroke %zu: %s of sample %zu is out of range",
                                     i, duct_channel_name((duct_channel)c), k);
                }
            }
        }
        duct_recording_tidy(stroke);
    }
    return DUCT_OK;
}

/* The page, which our own writer puts into an <annotationXML>. */
static void read_page(reader *r, const xmlNode *root)
{
    r->document.pixels_per_inch = 96;
    const xmlNode *own = NULL;
    for (const xmlNode *child = root->children; child != NULL && own == NULL; child = child->next) {
        const char *type = duct_inkml_is(child, "annotationXML") ? duct_inkml_attribute(child, "type") : NULL;
        own = type != NULL && strcmp(type, DUCT_INKML_OWN_NAMESPACE) == 0 ? child->children : NULL;
    }
    while (own != NULL && (own->type != XML_ELEMENT_NODE || strcmp((const char *)own->name, "page") != 0)) {
        own = own->next;
    }
    double width, height, resolution;
    if (own == NULL) {
        return;
    }
    if (duct_inkml_number(own, "width", &width) && duct_inkml_number(own, "height", &height) && width >= 0 &&
        height >= 0) {
        duct_drawing_set_page(r->drawing, width, height);
    }
    if (duct_inkml_number(own, "resolution", &resolution) && resolution > 0) {
        r->document.pixels_per_inch = resolution;
        duct_drawing_set_resolution(r->drawing, resolution);
    }
}

duct_status duct_inkml_read(const duct_context *context, const char *data, size_t size, duct_drawing *drawing,
                            duct_error *error)
{
    xmlDoc *xml;
    duct_status status = duct_xml_parse(data, size, &xml, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    reader r = {.drawing = drawing, .document = {.allocator = allocator, .first_timestamp = NAN}};
    duct_text_init(&r.group, allocator);
    xmlNode *root = xmlDocGetRootElement(xml);
    if (!duct_inkml_is(root, "ink")) {
        status =
            duct_inkml_fail(root, error, "is no InkML: its root element is <%.60s>, not <ink>", root->name);
    } else if (!duct_inkml_index_make(allocator, root, &r.document.index)) {
        status = duct_fail_memory(error);
    }
    if (status == DUCT_OK) {
        read_page(&r, root);
        status = walk(&r, root, error);
    }
    if (status == DUCT_OK) {
        status = read_traces(&r, error);
    }
    if (status == DUCT_OK) {
        status = finish(&r, error);
    }
    duct_text_free(&r.group);
    duct_release(allocator, r.document.index.entries);
    duct_release(allocator, r.states);
    duct_release(allocator, r.segments);
    duct_release(allocator, r.chains);
    xmlFreeDoc(xml);
    return status;
}
