/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The text of a trace (section 3.2.1): points parted by commas; a value is a number, a first (') or second
 * (") difference, which stays in force until another prefix comes (! for plain values), T or F, or a
 * wildcard: * goes on as before, ? is not known. */
#include "base/error.h"
#include "base/number.h"
#include "formats/inkml_private.h"

#include <math.h>
#include <string.h>

enum { PLAIN, FIRST, SECOND };

typedef struct {
    int order; /* PLAIN, FIRST or SECOND */
    double last, velocity, acceleration;
} decoder;

typedef struct {
    const xmlNode *trace;
    const char *start, *at;
    size_t point;
    const duct_inkml_format *format;
    decoder decoders[DUCT_INKML_MOST_CHANNELS];
    double values[DUCT_INKML_MOST_CHANNELS];
} parser;

static bool is_gap(char c)
{
    return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == ':';
}

static duct_status fail(const parser *p, duct_error *error, const char *reason)
{
    long line = xmlGetLineNo(p->trace);
    for (const char *s = p->start; s < p->at; s++) {
        line += *s == '\n';
    }
    return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: point %zu of the trace: %s", line, p->point, reason);
}

/* A number in decimal or, behind '#', hexadecimal digits. */
static bool parse_number(parser *p, double *number)
{
    const char *at = p->at;
    bool negative = *at == '-';
    if (negative && (is_gap(at[1]) || at[1] == '#')) {
        at += 1;
        at += strspn(at, " \t\r\n");
    } else {
        negative = false;
    }
    double value = 0;
    if (*at == '#') {
        size_t digits = strspn(at + 1, "0123456789abcdefABCDEF");
        for (size_t i = 1; i <= digits; i++) {
            int digit = at[i] <= '9' ? at[i] - '0' : (at[i] | 32) - 'a' + 10;
            value = value * 16 + digit;
        }
        if (digits == 0) {
            return false;
        }
        at += digits + 1;
    } else if (!duct_number_scan(at, &at, &value)) {
        return false;
    }
    p->at = at;
    *number = negative ? -value : value;
    return isfinite(value);
}

/* Takes a value's number in by the order of difference that is in force. */
static void advance(decoder *d, double number)
{
    if (d->order == PLAIN) {
        d->acceleration = 0;
        d->velocity = isnan(d->last) ? 0 : number - d->last;
        d->last = number;
    } else if (d->order == FIRST) {
        d->acceleration = number - d->velocity;
        d->velocity = number;
        d->last += number;
    } else {
        d->acceleration = number;
        d->velocity += number;
        d->last += d->velocity;
    }
}

static duct_status parse_value(parser *p, decoder *d, double *value, duct_error *error)
{
    static const char prefixes[] = "!'\"";
    const char *prefix = strchr(prefixes, *p->at);
    if (prefix != NULL && *prefix != '\0') {
        d->order = (int)(prefix - prefixes);
        p->at++;
        while (is_gap(*p->at)) {
            p->at++;
        }
    }
    char c = *p->at;
    if (c == '?') {
        p->at++;
        *value = NAN;
        return DUCT_OK;
    }
    if (c == 'T' || c == 'F') {
        p->at++;
        *value = d->last = c == 'T';
        return DUCT_OK;
    }
    double number = 0;
    if ((c == '*' || d->order != PLAIN) && isnan(d->last)) {
        return fail(p, error, "a difference or \"*\" has no value before it");
    }
    if (c == '*') {
        p->at++;
        number = d->order == PLAIN ? d->last : d->order == FIRST ? d->velocity : d->acceleration;
    } else if (!parse_number(p, &number)) {
        return fail(p, error, "a number is expected");
    }
    advance(d, number);
    *value = d->last;
    return isfinite(d->last) ? DUCT_OK : fail(p, error, "a value is out of range");
}

/* The values of one point, up to its comma or the end. */
static duct_status parse_point(parser *p, size_t *given, duct_error *error)
{
    const duct_inkml_format *format = p->format;
    size_t count = 0;
    for (;;) {
        while (is_gap(*p->at)) {
            p->at++;
        }
        if (*p->at == ',' || *p->at == '\0') {
            break;
        }
        if (count >= format->count) {
            if (!format->implicit) {
                return fail(p, error, "there are more values than channels");
            }
            decoder ignored = {.last = 0};
            double value;
            duct_status status = parse_value(p, &ignored, &value, error);
            if (status != DUCT_OK) {
                return status;
            }
            continue;
        }
        duct_status status = parse_value(p, &p->decoders[count], &p->values[count], error);
        if (status != DUCT_OK) {
            return status;
        }
        count++;
    }
    *given = count;
    if (count > 0 && count < format->regular) {
        return fail(p, error, "there are fewer values than channels");
    }
    for (size_t c = count; c < format->count; c++) {
        const duct_inkml_channel *channel = &format->channels[c];
        bool none = isnan(p->decoders[c].last) && channel->has_default;
        p->values[c] = none ? channel->standard : p->decoders[c].last;
    }
    return DUCT_OK;
}

static duct_status add_sample(parser *p, duct_inkml_samples *samples, duct_error *error)
{
    const duct_inkml_format *format = p->format;
    double sample[DUCT_INKML_MEANINGS + 1];
    for (int m = 0; m < DUCT_INKML_MEANINGS; m++) {
        sample[m] = NAN;
    }
    for (size_t c = 0; c < format->count; c++) {
        sample[format->channels[c].meaning] = p->values[c];
    }
    if (isnan(sample[DUCT_X]) || isnan(sample[DUCT_Y])) {
        return DUCT_OK; /* nobody knows where the pen was */
    }
    if (format->mapped) {
        const double *m = format->affine, x = sample[DUCT_X], y = sample[DUCT_Y];
        sample[DUCT_X] = m[0] * x + m[1] * y + m[2];
        sample[DUCT_Y] = m[3] * x + m[4] * y + m[5];
    }
    for (size_t c = 0; c < format->count; c++) {
        const duct_inkml_channel *channel = &format->channels[c];
        double *value = &sample[channel->meaning];
        if (channel->meaning == DUCT_INKML_UNUSED || (channel->meaning > DUCT_Y && isnan(*value))) {
            continue;
        }
        *value = *value * channel->factor + channel->offset;
        if (!isfinite(*value)) {
            return fail(p, error, "a value is out of range");
        }
    }
    void *values = samples->values;
    if (!duct_reserve(samples->allocator, &values, &samples->capacity, samples->count + 1,
                      DUCT_INKML_MEANINGS * sizeof(double))) {
        return duct_fail_memory(error);
    }
    samples->values = values;
    memcpy(samples->values + samples->count++ * DUCT_INKML_MEANINGS, sample,
           DUCT_INKML_MEANINGS * sizeof *sample);
    return DUCT_OK;
}

static duct_status parse_points(parser *p, duct_inkml_samples *samples, duct_error *error)
{
    duct_status status = DUCT_OK;
    while (status == DUCT_OK) {
        size_t given = 0;
        p->point++;
        status = parse_point(p, &given, error);
        if (status != DUCT_OK) {
            break;
        }
        if (given == 0) {
            /* A comma may follow the last point. */
            return *p->at == '\0' ? DUCT_OK : fail(p, error, "it is empty");
        }
        if (samples->count >= DUCT_MAX_SAMPLES) {
            return duct_fail(error, DUCT_LIMIT, "line %ld: a stroke may have %d samples at most",
                             xmlGetLineNo(p->trace), DUCT_MAX_SAMPLES);
        }
        status = add_sample(p, samples, error);
        if (*p->at == '\0') {
            break;
        }
        p->at++;
    }
    return status;
}

duct_status duct_inkml_parse_trace(const xmlNode *trace, const duct_inkml_format *format, bool fresh,
                                   duct_inkml_samples *samples, duct_error *error)
{
    xmlChar *made;
    parser p = {.trace = trace, .format = format};
    p.start = p.at = duct_inkml_text(trace, &made);
    for (size_t c = 0; c < format->count; c++) {
        p.decoders[c].last = fresh ? NAN : samples->last[c];
        p.decoders[c].velocity = fresh ? 0 : samples->velocity[c];
    }
    duct_status status = parse_points(&p, samples, error);
    for (size_t c = 0; c < DUCT_INKML_MOST_CHANNELS; c++) {
        samples->last[c] = c < format->count ? p.decoders[c].last : NAN;
        samples->velocity[c] = c < format->count ? p.decoders[c].velocity : 0;
    }
    xmlFree(made);
    return status;
}
