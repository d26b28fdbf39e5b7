/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is in force for a trace: contexts, ink sources, trace formats, brushes, timestamps (sections 3.1, 4,
 * 5, 6). */
#include "base/error.h"
#include "base/number.h"
#include "formats/inkml_private.h"
#include "formats/recording.h"

#include <math.h>
#include <string.h>

/* References may be chained this far; a longer chain goes in a circle. */
enum { LONGEST_CHAIN = 32 };

/* The element `name` that `node` holds, or that its attribute `reference` names. */
static const xmlNode *find_part(const duct_inkml_document *document, const xmlNode *node, const char *name,
                                const char *reference)
{
    const xmlNode *part = duct_inkml_child(node, name);
    if (part != NULL) {
        return part;
    }
    const duct_inkml_entry *entry =
        duct_inkml_index_find(&document->index, duct_inkml_attribute(node, reference));
    return entry != NULL && duct_inkml_is(entry->node, name) ? entry->node : NULL;
}

/* ---- brushes ---- */

static int hex_digit(char c)
{
    const char *digits = "0123456789abcdef";
    const char *found = c != '\0' ? strchr(digits, c >= 'A' && c <= 'F' ? c + 32 : c) : NULL;
    return found != NULL ? (int)(found - digits) : -1;
}

static void parse_color(const char *text, duct_stroke_style *style)
{
    float parts[3];
    text += *text == '#';
    if (strlen(text) != 6) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        int high = hex_digit(text[2 * i]), low = hex_digit(text[2 * i + 1]);
        if (high < 0 || low < 0) {
            return;
        }
        parts[i] = (float)((high * 16 + low) / 255.0);
    }
    style->red = parts[0];
    style->green = parts[1];
    style->blue = parts[2];
}

static void apply_property(const duct_inkml_document *document, const xmlNode *property,
                           duct_stroke_style *style)
{
    const char *name = duct_inkml_attribute(property, "name"),
               *value = duct_inkml_attribute(property, "value");
    double number;
    if (name == NULL || value == NULL) {
        return;
    }
    if (strcmp(name, "color") == 0) {
        parse_color(value, style);
    } else if (!duct_number_parse(value, &number)) {
        return;
    } else if (strcmp(name, "transparency") == 0) {
        style->opacity = (float)(1 - fmin(fmax(number, 0), 255) / 255);
    } else if (strcmp(name, "width") == 0 && number >= 0) {
        double unit =
            duct_inkml_length_unit(duct_inkml_attribute(property, "units"), document->pixels_per_inch);
        style->width = number * (unit > 0 ? unit : 1);
    }
}

static float unit_float(double number)
{
    return (float)fmin(fmax(number, 0), 1);
}

/* The exact style, which our own writer adds where the standard's properties round it. */
static void apply_own_style(const xmlNode *brush, duct_stroke_style *style)
{
    const char *color = duct_inkml_own_attribute(brush, "color");
    double parts[3];
    int known = 0;
    while (color != NULL && known < 3) {
        color += strspn(color, " ");
        if (!duct_number_scan(color, &color, &parts[known])) {
            break;
        }
        known++;
    }
    if (known == 3) {
        style->red = unit_float(parts[0]);
        style->green = unit_float(parts[1]);
        style->blue = unit_float(parts[2]);
    }
    const char *opacity = duct_inkml_own_attribute(brush, "opacity"),
               *width = duct_inkml_own_attribute(brush, "width");
    double number;
    if (opacity != NULL && duct_number_parse(opacity, &number)) {
        style->opacity = unit_float(number);
    }
    if (width != NULL && duct_number_parse(width, &number) && number >= 0) {
        style->width = number;
    }
}

void duct_inkml_apply_brush(const duct_inkml_document *document, const xmlNode *brush, int depth,
                            duct_stroke_style *style)
{
    const duct_inkml_entry *base =
        duct_inkml_index_find(&document->index, duct_inkml_attribute(brush, "brushRef"));
    if (base != NULL && duct_inkml_is(base->node, "brush") && depth < LONGEST_CHAIN) {
        duct_inkml_apply_brush(document, base->node, depth + 1, style);
    }
    for (const xmlNode *child = brush->children; child != NULL; child = child->next) {
        if (duct_inkml_is(child, "brushProperty")) {
            apply_property(document, child, style);
        }
    }
    apply_own_style(brush, style);
    style->width = isfinite(style->width) ? style->width : 0;
}

/* ---- time ---- */

/* Seconds since 1970; false where the element does not say. */
static bool absolute_time(const duct_inkml_document *document, const xmlNode *timestamp, int depth,
                          double *seconds)
{
    double time = 0, offset = 0;
    duct_inkml_number(timestamp, "timeOffset", &offset);
    if (duct_inkml_number(timestamp, "time", &time)) {
        *seconds = (time + offset) / 1000;
        return true;
    }
    const duct_inkml_entry *base =
        duct_inkml_index_find(&document->index, duct_inkml_attribute(timestamp, "timestampRef"));
    if (base != NULL && depth < LONGEST_CHAIN && duct_inkml_is(base->node, "timestamp") &&
        absolute_time(document, base->node, depth + 1, &time)) {
        *seconds = time + offset / 1000;
        return true;
    }
    return false;
}

/* Seconds since the document's first timestamp. */
static double relative_time(duct_inkml_document *document, const xmlNode *timestamp)
{
    double seconds;
    if (!absolute_time(document, timestamp, 0, &seconds)) {
        return 0;
    }
    if (isnan(document->first_timestamp)) {
        document->first_timestamp = seconds;
    }
    return seconds - document->first_timestamp;
}

/* ---- contexts ---- */

static void apply_source(const duct_inkml_document *document, const xmlNode *source, duct_inkml_state *state)
{
    state->source = source;
    const xmlNode *format = find_part(document, source, "traceFormat", "traceFormatRef");
    state->format = format != NULL ? format : state->format;
}

void duct_inkml_apply_part(duct_inkml_document *document, const xmlNode *node, duct_inkml_state *state)
{
    if (duct_inkml_is(node, "inkSource")) {
        apply_source(document, node, state);
    } else if (duct_inkml_is(node, "traceFormat")) {
        state->format = node;
    } else if (duct_inkml_is(node, "canvas")) {
        state->canvas = node;
    } else if (duct_inkml_is(node, "canvasTransform")) {
        state->transform = node;
    } else if (duct_inkml_is(node, "brush")) {
        state->style = (duct_stroke_style){0, 0, 0, 1, 0};
        duct_inkml_apply_brush(document, node, 0, &state->style);
    } else if (duct_inkml_is(node, "timestamp")) {
        state->timestamp = relative_time(document, node);
    }
}

static duct_status apply_context(duct_inkml_document *document, const xmlNode *context, int depth,
                                 duct_inkml_state *state, duct_error *error)
{
    const char *reference = duct_inkml_attribute(context, "contextRef");
    const duct_inkml_entry *base = duct_inkml_index_find(&document->index, reference);
    if (base != NULL && duct_inkml_is(base->node, "context")) {
        if (depth >= LONGEST_CHAIN) {
            return duct_inkml_fail(
                context, error, "contextRef \"%.60s\": contexts refer to one another in a circle", reference);
        }
        duct_status status = apply_context(document, base->node, depth + 1, state, error);
        if (status != DUCT_OK) {
            return status;
        }
    } else if (reference != NULL && strcmp(reference, "#DefaultContext") != 0) {
        return duct_inkml_fail(context, error, "contextRef \"%.60s\" names no context of this file",
                               reference);
    }
    static const char *const parts[][2] = {
        {"inkSource", "inkSourceRef"}, {"traceFormat", "traceFormatRef"},
        {"canvas", "canvasRef"},       {"canvasTransform", "canvasTransformRef"},
        {"brush", "brushRef"},         {"timestamp", "timestampRef"},
    };
    for (size_t i = 0; i < sizeof parts / sizeof parts[0]; i++) {
        const xmlNode *part = find_part(document, context, parts[i][0], parts[i][1]);
        if (part != NULL) {
            duct_inkml_apply_part(document, part, state);
        }
    }
    return DUCT_OK;
}

duct_status duct_inkml_apply_context(duct_inkml_document *document, const xmlNode *context,
                                     duct_inkml_state *state, duct_error *error)
{
    return apply_context(document, context, 0, state, error);
}

duct_status duct_inkml_apply_references(duct_inkml_document *document, const xmlNode *node,
                                        duct_inkml_state *state, duct_error *error)
{
    const char *reference = duct_inkml_attribute(node, "contextRef");
    if (reference != NULL && strcmp(reference, "#DefaultContext") != 0) {
        const duct_inkml_entry *entry = duct_inkml_index_find(&document->index, reference);
        if (entry == NULL || !duct_inkml_is(entry->node, "context")) {
            return duct_inkml_fail(node, error, "contextRef \"%.60s\" names no context of this file",
                                   reference);
        }
        duct_status status = apply_context(document, entry->node, 0, state, error);
        if (status != DUCT_OK) {
            return status;
        }
    }
    const duct_inkml_entry *brush =
        duct_inkml_index_find(&document->index, duct_inkml_attribute(node, "brushRef"));
    if (brush != NULL && duct_inkml_is(brush->node, "brush")) {
        duct_inkml_apply_part(document, brush->node, state);
    }
    return DUCT_OK;
}

/* ---- channels ---- */

double duct_inkml_length_unit(const char *unit, double pixels_per_inch)
{
    static const struct {
        const char *name;
        double per_inch;
    } units[] = {{"in", 1},  {"cm", 2.54}, {"mm", 25.4}, {"m", 0.0254},
                 {"pt", 72}, {"pc", 6},    {"em", 6},    {"ex", 12}};
    for (size_t i = 0; unit != NULL && i < sizeof units / sizeof units[0]; i++) {
        if (strcmp(units[i].name, unit) == 0) {
            return pixels_per_inch / units[i].per_inch;
        }
    }
    return unit != NULL && strcmp(unit, "px") == 0 ? 1 : 0;
}

/* What one of the unit is in the stroke's own unit; 0 where the unit is none of that quantity. */
static double unit_factor(int meaning, const char *unit, double pixels_per_inch)
{
    if (unit == NULL) {
        return 0;
    }
    if (meaning == DUCT_X || meaning == DUCT_Y) {
        return duct_inkml_length_unit(unit, pixels_per_inch);
    }
    if (meaning == DUCT_T) {
        return strcmp(unit, "s") == 0    ? 1
               : strcmp(unit, "ms") == 0 ? 1e-3
               : strcmp(unit, "us") == 0 ? 1e-6
                                         : 0;
    }
    if (meaning == DUCT_PRESSURE) {
        return 0;
    }
    return strcmp(unit, "rad") == 0 ? 1 : strcmp(unit, "deg") == 0 ? DUCT_PI / 180 : 0;
}

/* The ink source's property `resolution` of a channel (section 4.2.1.3): "the scale of the values recorded".
 */
static double resolution_factor(const duct_inkml_state *state, const char *channel, int meaning,
                                double pixels_per_inch)
{
    const xmlNode *list = state->source != NULL ? duct_inkml_child(state->source, "channelProperties") : NULL;
    const xmlNode *property = list != NULL ? list->children : NULL;
    for (int looked = 0; property != NULL && looked < DUCT_INKML_MOST_CHILDREN; property = property->next) {
        looked++;
        const char *of =
            duct_inkml_is(property, "channelProperty") ? duct_inkml_attribute(property, "channel") : NULL;
        const char *name = of != NULL ? duct_inkml_attribute(property, "name") : NULL;
        if (name == NULL || strcmp(of, channel) != 0 || strcmp(name, "resolution") != 0) {
            continue;
        }
        double value;
        const char *unit = duct_inkml_attribute(property, "units");
        if (unit == NULL || !duct_inkml_number(property, "value", &value) || !(value > 0)) {
            return 0;
        }
        bool inverse = strncmp(unit, "1/", 2) == 0;
        double factor = unit_factor(meaning, unit + (inverse ? 2 : 0), pixels_per_inch);
        return inverse ? factor / value : factor * value;
    }
    return 0;
}

static int channel_meaning(const char *name)
{
    static const struct {
        const char *name;
        int meaning;
    } names[] = {{"X", DUCT_X},
                 {"Y", DUCT_Y},
                 {"T", DUCT_T},
                 {"F", DUCT_PRESSURE},
                 {"P", DUCT_PRESSURE},
                 {"OTx", DUCT_TILT_X},
                 {"OTy", DUCT_TILT_Y},
                 {"OR", DUCT_TWIST},
                 {"OA", DUCT_INKML_AZIMUTH},
                 {"OE", DUCT_INKML_ELEVATION}};
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        if (strcmp(names[i].name, name) == 0) {
            return names[i].meaning;
        }
    }
    return DUCT_INKML_UNUSED;
}

static void scale_pressure(const xmlNode *node, bool reversed, duct_inkml_channel *channel)
{
    double low = 0, high;
    const char *unit = duct_inkml_attribute(node, "units");
    duct_inkml_number(node, "min", &low);
    if (duct_inkml_number(node, "max", &high) && high > low) {
        channel->factor = 1 / (high - low);
        channel->offset = -low / (high - low);
    } else if (unit != NULL && strcmp(unit, "%") == 0) {
        channel->factor = 0.01;
    } else {
        channel->open_range = true;
        return;
    }
    if (reversed) {
        channel->factor = -channel->factor;
        channel->offset = 1 - channel->offset;
    }
}

static void scale_channel(duct_inkml_document *document, const duct_inkml_state *state, const xmlNode *node,
                          const char *name, duct_inkml_channel *channel)
{
    const char *orientation = duct_inkml_attribute(node, "orientation");
    bool reversed = orientation != NULL && strcmp(orientation, "-ve") == 0;
    int meaning = channel->meaning;
    channel->factor = 1;
    if (meaning == DUCT_PRESSURE) {
        scale_pressure(node, reversed, channel);
        return;
    }
    double ppi = document->pixels_per_inch;
    double factor = resolution_factor(state, name, meaning, ppi);
    factor = factor > 0 ? factor : unit_factor(meaning, duct_inkml_attribute(node, "units"), ppi);
    double usual = meaning == DUCT_T ? 1e-3 : meaning > DUCT_PRESSURE ? DUCT_PI / 180 : 1;
    factor = factor > 0 && isfinite(factor) ? factor : usual;
    channel->factor = factor;
    if (meaning == DUCT_TWIST) {
        reversed = !reversed; /* OR turns counter-clockwise */
    }
    if (meaning == DUCT_T) {
        const duct_inkml_entry *start =
            duct_inkml_index_find(&document->index, duct_inkml_attribute(node, "respectTo"));
        channel->offset = start != NULL && duct_inkml_is(start->node, "timestamp")
                              ? relative_time(document, start->node)
                              : 0;
    } else if (reversed) {
        double high;
        channel->factor = -factor;
        if (meaning <= DUCT_Y && duct_inkml_number(node, "max", &high)) {
            channel->offset = high * factor;
        } else {
            channel->flipped = meaning <= DUCT_Y;
        }
    }
}

static duct_status add_channel(duct_inkml_document *document, const duct_inkml_state *state,
                               const xmlNode *node, bool intermittent, duct_inkml_format *format,
                               duct_error *error)
{
    if (format->count == DUCT_INKML_MOST_CHANNELS) {
        return duct_inkml_fail(node, error, "a trace format may have %d channels at most",
                               DUCT_INKML_MOST_CHANNELS);
    }
    const char *name = duct_inkml_attribute(node, "name");
    duct_inkml_channel channel = {.meaning = channel_meaning(name != NULL ? name : ""),
                                  .intermittent = intermittent};
    for (size_t i = 0; i < format->count; i++) {
        if (format->channels[i].meaning == channel.meaning) {
            channel.meaning = DUCT_INKML_UNUSED; /* the first one counts */
        }
    }
    const xmlNode *mapping = duct_inkml_child(node, "mapping");
    const char *type = mapping != NULL ? duct_inkml_attribute(mapping, "type") : NULL;
    if (type != NULL && strcmp(type, "identity") != 0 && channel.meaning != DUCT_INKML_UNUSED) {
        return duct_fail(error, DUCT_UNSUPPORTED,
                         "line %ld: channel %.20s: a mapping of type \"%.20s\" is not supported",
                         xmlGetLineNo(node), name, type);
    }
    const char *standard = duct_inkml_attribute(node, "default");
    channel.has_default = standard != NULL && duct_number_parse(standard, &channel.standard);
    if (channel.meaning != DUCT_INKML_UNUSED) {
        scale_channel(document, state, node, name, &channel);
    }
    format->channels[format->count++] = channel;
    return DUCT_OK;
}

static duct_status add_list(duct_inkml_document *document, const duct_inkml_state *state, const xmlNode *list,
                            bool intermittent, duct_inkml_format *format, duct_error *error)
{
    duct_status status = DUCT_OK;
    int looked = 0;
    for (const xmlNode *child = list->children; status == DUCT_OK && child != NULL; child = child->next) {
        if (++looked > DUCT_INKML_MOST_CHILDREN) {
            return duct_inkml_fail(list, error, "a list of channels may hold %d nodes at most",
                                   DUCT_INKML_MOST_CHILDREN);
        }
        if (duct_inkml_is(child, "channel")) {
            status = add_channel(document, state, child, intermittent, format, error);
        }
    }
    return status;
}

static duct_status add_channels(duct_inkml_document *document, const duct_inkml_state *state,
                                duct_inkml_format *format, duct_error *error)
{
    duct_status status = add_list(document, state, state->format, false, format, error);
    format->regular = format->count;
    const xmlNode *list = duct_inkml_child(state->format, "intermittentChannels");
    if (status == DUCT_OK && list != NULL) {
        status = add_list(document, state, list, true, format, error);
    }
    if (status != DUCT_OK || format->count == 0) {
        return status;
    }
    bool known[DUCT_INKML_MEANINGS + 1] = {false};
    for (size_t i = 0; i < format->count; i++) {
        known[format->channels[i].meaning] = true;
    }
    return known[DUCT_X] && known[DUCT_Y]
               ? DUCT_OK
               : duct_inkml_fail(state->format, error, "the trace format has no channels X and Y");
}

/* ---- the canvas ---- */

/* Two rows "a b c" that make X and Y of "X Y 1"; the last column may be missing. */
static bool parse_affine(const char *text, double affine[6])
{
    for (int row = 0; row < 2; row++) {
        int column = 0;
        while (column < 3) {
            text += strspn(text, " \t\r\n");
            if (!duct_number_scan(text, &text, &affine[3 * row + column]) ||
                !isfinite(affine[3 * row + column])) {
                break;
            }
            column++;
        }
        text += strspn(text, " \t\r\n");
        if (column < 2 || (row == 0 ? *text != ',' : *text != '\0' && *text != ',')) {
            return false;
        }
        if (column == 2) {
            affine[3 * row + 2] = 0;
        }
        text += *text == ',';
    }
    return true;
}

static duct_status add_transform(duct_inkml_document *document, const duct_inkml_state *state,
                                 duct_inkml_format *format, duct_error *error)
{
    const xmlNode *mapping = find_part(document, state->transform, "mapping", "mappingRef");
    const char *type = mapping != NULL ? duct_inkml_attribute(mapping, "type") : NULL;
    if (type == NULL || strcmp(type, "identity") == 0) {
        return DUCT_OK;
    }
    const xmlNode *matrix = duct_inkml_child(mapping, "affine");
    matrix = matrix != NULL ? matrix : duct_inkml_child(mapping, "matrix"); /* its name in older drafts */
    if (strcmp(type, "affine") != 0 || matrix == NULL) {
        return duct_fail(
            error, DUCT_UNSUPPORTED,
            "line %ld: a canvas transform of type \"%.20s\" is not supported, only affine ones are",
            xmlGetLineNo(mapping), type);
    }
    xmlChar *made;
    bool good = parse_affine(duct_inkml_text(matrix, &made), format->affine);
    xmlFree(made);
    if (!good) {
        return duct_inkml_fail(matrix, error, "the affine mapping is not two rows of three numbers");
    }
    format->mapped = true;
    return DUCT_OK;
}

/* The factors of X and Y behind a canvas transform are those of the canvas's own channels. */
static duct_status use_canvas(duct_inkml_document *document, const duct_inkml_state *state,
                              duct_inkml_format *format, duct_error *error)
{
    duct_inkml_format canvas = {.count = 0};
    duct_inkml_state on_canvas = *state;
    on_canvas.source = NULL;
    on_canvas.format =
        state->canvas != NULL ? find_part(document, state->canvas, "traceFormat", "traceFormatRef") : NULL;
    duct_status status =
        on_canvas.format != NULL ? add_channels(document, &on_canvas, &canvas, error) : DUCT_OK;
    for (size_t i = 0; i < format->count; i++) {
        duct_inkml_channel *channel = &format->channels[i];
        if (channel->meaning > DUCT_Y) {
            continue;
        }
        channel->factor = 1;
        channel->offset = 0;
        channel->flipped = false;
        for (size_t k = 0; k < canvas.count; k++) {
            if (canvas.channels[k].meaning == channel->meaning) {
                channel->factor = canvas.channels[k].factor;
                channel->offset = canvas.channels[k].offset;
                channel->flipped = canvas.channels[k].flipped;
            }
        }
    }
    return status;
}

duct_status duct_inkml_make_format(duct_inkml_document *document, const duct_inkml_state *state,
                                   duct_inkml_format *format, duct_error *error)
{
    *format = (duct_inkml_format){.count = 0};
    duct_status status = DUCT_OK;
    if (state->format != NULL) {
        status = add_channels(document, state, format, error);
    }
    if (status == DUCT_OK && format->count == 0) {
        format->channels[0] = (duct_inkml_channel){.meaning = DUCT_X, .factor = 1};
        format->channels[1] = (duct_inkml_channel){.meaning = DUCT_Y, .factor = 1};
        format->count = format->regular = 2;
        format->implicit = true;
    }
    if (status == DUCT_OK && state->transform != NULL) {
        status = add_transform(document, state, format, error);
        if (status == DUCT_OK && format->mapped) {
            status = use_canvas(document, state, format, error);
        }
    }
    for (size_t i = 0; i < format->count; i++) {
        format->dated = format->dated || format->channels[i].dated;
    }
    const xmlNode *rate = state->source != NULL ? duct_inkml_child(state->source, "sampleRate") : NULL;
    const char *uniform = rate != NULL ? duct_inkml_attribute(rate, "uniform") : NULL;
    double value;
    if (rate != NULL && (uniform == NULL || strcmp(uniform, "false") != 0) &&
        duct_inkml_number(rate, "value", &value) && value > 0) {
        format->rate = value;
    }
    return status;
}
