/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Values checked against an operation's table, and running an operation with them. */
#include "operations/operation_private.h"

#include "base/error.h"
#include "base/number.h"
#include "base/pool.h"
#include "base/text.h"
#include "operations/registry.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

typedef struct {
    char *text; /* canonical */
    double number;
    uint64_t seed;
    size_t choice;
    const duct_library *library;
} value;

struct duct_settings {
    duct_allocator allocator;
    const duct_operation *operation;
    value *values; /* by parameter */
};

static duct_status fail_value(duct_error *error, const duct_param *param, const char *text,
                              const char *allowed)
{
    return duct_fail(error, DUCT_BAD_SETTING, "%s: '%.80s' is not allowed; give %s", param->id, text,
                     allowed);
}

static duct_status fail_range(duct_error *error, const duct_param *param, const char *text)
{
    char low[DUCT_NUMBER_SIZE], high[DUCT_NUMBER_SIZE], allowed[2 * DUCT_NUMBER_SIZE + 64];
    duct_number_print(low, param->minimum, 0);
    duct_number_print(high, param->maximum, 0);
    snprintf(allowed, sizeof allowed, "%sa %snumber from %s to %s",
             param->type == DUCT_PARAM_AUTO ? "auto or " : "", param->type == DUCT_PARAM_INT ? "whole " : "",
             low, high);
    return fail_value(error, param, text, allowed);
}

static duct_status parse_bool(const duct_param *param, const char *text, value *parsed, duct_error *error)
{
    static const char *const yes[] = {"true", "yes", "on", "1"};
    static const char *const no[] = {"false", "no", "off", "0"};
    for (size_t i = 0; i < 4; i++) {
        if (strcasecmp(text, yes[i]) == 0 || strcasecmp(text, no[i]) == 0) {
            parsed->number = strcasecmp(text, yes[i]) == 0;
            return DUCT_OK;
        }
    }
    return fail_value(error, param, text, "true or false");
}

static duct_status parse_number(const duct_param *param, const char *text, value *parsed, duct_error *error)
{
    double number;
    if (!duct_number_parse(text, &number) || number < param->minimum || number > param->maximum ||
        (param->type == DUCT_PARAM_INT && number != floor(number))) {
        return fail_range(error, param, text);
    }
    parsed->number = number;
    return DUCT_OK;
}

static duct_status parse_seed(const duct_param *param, const char *text, value *parsed, duct_error *error)
{
    uint64_t seed = 0;
    bool good = *text != '\0';
    for (const char *s = text; good && *s != '\0'; s++) {
        good = *s >= '0' && *s <= '9' && seed <= (INT64_MAX - (uint64_t)(*s - '0')) / 10;
        seed = good ? seed * 10 + (uint64_t)(*s - '0') : 0;
    }
    if (!good) {
        return fail_value(error, param, text, "a whole number from 0 to 9223372036854775807");
    }
    parsed->seed = seed;
    return DUCT_OK;
}

static duct_status parse_choice(const duct_param *param, const char *text, value *parsed, duct_error *error)
{
    char allowed[256] = "one of: ";
    for (size_t i = 0; i < param->choice_count; i++) {
        if (strcmp(text, param->choices[i].id) == 0) {
            parsed->choice = i;
            return DUCT_OK;
        }
        size_t used = strlen(allowed);
        snprintf(allowed + used, sizeof allowed - used, "%s%s", i > 0 ? ", " : "", param->choices[i].id);
    }
    return fail_value(error, param, text, allowed);
}

static duct_status parse(const duct_param *param, const char *text, value *parsed, duct_error *error)
{
    switch (param->type) {
    case DUCT_PARAM_BOOL:
        return parse_bool(param, text, parsed, error);
    case DUCT_PARAM_INT:
    case DUCT_PARAM_REAL:
        return parse_number(param, text, parsed, error);
    case DUCT_PARAM_AUTO:
        if (strcmp(text, "auto") == 0) {
            parsed->number = NAN;
            return DUCT_OK;
        }
        return parse_number(param, text, parsed, error);
    case DUCT_PARAM_SEED:
        return parse_seed(param, text, parsed, error);
    case DUCT_PARAM_CHOICE:
        return parse_choice(param, text, parsed, error);
    case DUCT_PARAM_STYLE:
        return *text != '\0' ? DUCT_OK : fail_value(error, param, text, "the name of a style, or a file");
    case DUCT_PARAM_HAND:
    case DUCT_PARAM_STROKES:
        return DUCT_OK;
    }
    return duct_fail(error, DUCT_BAD_ARGUMENT, "%s: has a type that this version does not know", param->id);
}

/* The text as duct_settings_text() gives it, whichever way the user wrote the value; NULL without memory. */
static char *canonical(const duct_allocator *allocator, const duct_param *param, const char *text,
                       const value *parsed)
{
    duct_text out;
    duct_text_init(&out, allocator);
    switch (param->type) {
    case DUCT_PARAM_BOOL:
        duct_text_add(&out, parsed->number != 0 ? "true" : "false");
        break;
    case DUCT_PARAM_AUTO:
        if (isnan(parsed->number)) {
            duct_text_add(&out, "auto");
            break;
        }
        /* fall through */
    case DUCT_PARAM_INT:
    case DUCT_PARAM_REAL:
        duct_text_add_number(&out, parsed->number, 0);
        break;
    case DUCT_PARAM_SEED:
        duct_text_addf(&out, "%llu", (unsigned long long)parsed->seed);
        break;
    case DUCT_PARAM_CHOICE:
    case DUCT_PARAM_HAND:
    case DUCT_PARAM_STYLE:
    case DUCT_PARAM_STROKES:
        duct_text_add(&out, text);
        break;
    }
    return duct_text_take(&out, NULL);
}

static const duct_param *find(const duct_settings *settings, const char *id, size_t *index)
{
    const duct_operation *operation = settings->operation;
    for (size_t i = 0; i < operation->param_count; i++) {
        if (strcmp(operation->params[i].id, id) == 0) {
            *index = i;
            return &operation->params[i];
        }
    }
    return NULL;
}

static duct_status store(duct_settings *settings, size_t index, const char *text, duct_error *error)
{
    const duct_param *param = &settings->operation->params[index];
    value parsed = {NULL, 0, 0, 0, NULL};
    duct_status status = parse(param, text, &parsed, error);
    if (status != DUCT_OK) {
        return status;
    }
    parsed.text = canonical(&settings->allocator, param, text, &parsed);
    if (parsed.text == NULL) {
        return duct_fail_memory(error);
    }
    duct_release(&settings->allocator, settings->values[index].text);
    settings->values[index] = parsed;
    return DUCT_OK;
}

duct_status duct_settings_new(const duct_context *context, const duct_operation *operation,
                              duct_settings **settings, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_settings *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->operation = operation;
    made->values = duct_alloc(allocator, operation->param_count, sizeof *made->values);
    duct_status status = made->values != NULL ? DUCT_OK : duct_fail_memory(error);
    for (size_t i = 0; status == DUCT_OK && i < operation->param_count; i++) {
        status = store(made, i, operation->params[i].fallback, error);
    }
    if (status != DUCT_OK) {
        duct_settings_free(made);
        return status;
    }
    *settings = made;
    return DUCT_OK;
}

void duct_settings_free(duct_settings *settings)
{
    if (settings == NULL) {
        return;
    }
    const duct_allocator allocator = settings->allocator;
    for (size_t i = 0; settings->values != NULL && i < settings->operation->param_count; i++) {
        duct_release(&allocator, settings->values[i].text);
    }
    duct_release(&allocator, settings->values);
    duct_release(&allocator, settings);
}

const duct_operation *duct_settings_operation(const duct_settings *settings)
{
    return settings->operation;
}

static duct_status fail_param(duct_error *error, const duct_settings *settings, const char *param)
{
    return duct_fail(error, DUCT_BAD_SETTING,
                     "%s has no parameter '%.80s'; 'ductus %s --help' lists those it has",
                     settings->operation->id, param, settings->operation->id);
}

duct_status duct_settings_set(duct_settings *settings, const char *param, const char *text, duct_error *error)
{
    if (strcmp(param, "preset") == 0) {
        return duct_settings_preset(settings, text, error);
    }
    size_t index;
    if (find(settings, param, &index) == NULL) {
        return fail_param(error, settings, param);
    }
    return store(settings, index, text, error);
}

duct_status duct_settings_preset(duct_settings *settings, const char *preset, duct_error *error)
{
    const duct_operation *operation = settings->operation;
    const duct_preset *chosen = NULL;
    char names[256] = "";
    for (size_t i = 0; i < operation->preset_count; i++) {
        if (strcmp(operation->presets[i].id, preset) == 0) {
            chosen = &operation->presets[i];
        }
        size_t used = strlen(names);
        snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "", operation->presets[i].id);
    }
    if (chosen == NULL) {
        return duct_fail(error, DUCT_BAD_SETTING, "preset: there is no '%.80s'; give one of: %s", preset,
                         names);
    }
    /* All values or none: they are made beside the old ones first. */
    duct_settings fresh = *settings;
    fresh.values = duct_alloc(&settings->allocator, operation->param_count, sizeof *fresh.values);
    duct_status status = fresh.values != NULL ? DUCT_OK : duct_fail_memory(error);
    for (size_t i = 0; status == DUCT_OK && i < operation->param_count; i++) {
        const duct_param *param = &operation->params[i];
        const char *text = param->fallback;
        for (size_t v = 0; v < chosen->value_count; v++) {
            text = strcmp(chosen->values[v].param, param->id) == 0 ? chosen->values[v].value : text;
        }
        bool stays = param->type == DUCT_PARAM_HAND || param->type == DUCT_PARAM_STROKES;
        status = store(&fresh, i, stays ? settings->values[i].text : text, error);
        if (stays) {
            fresh.values[i].library = settings->values[i].library;
        }
    }
    value *dropped = status == DUCT_OK ? settings->values : fresh.values;
    if (status == DUCT_OK) {
        settings->values = fresh.values;
    }
    for (size_t i = 0; dropped != NULL && i < operation->param_count; i++) {
        duct_release(&settings->allocator, dropped[i].text);
    }
    duct_release(&settings->allocator, dropped);
    return status;
}

const char *duct_settings_text(const duct_settings *settings, const char *param)
{
    size_t index;
    return find(settings, param, &index) != NULL ? settings->values[index].text : NULL;
}

duct_status duct_settings_library(duct_settings *settings, const char *param, const duct_library *library,
                                  duct_error *error)
{
    size_t index;
    const duct_param *found = find(settings, param, &index);
    if (found == NULL || found->type != DUCT_PARAM_HAND) {
        return found == NULL ? fail_param(error, settings, param)
                             : duct_fail(error, DUCT_BAD_SETTING, "%s: does not take a hand", param);
    }
    settings->values[index].library = library;
    return DUCT_OK;
}

static const value *get(const duct_settings *settings, const char *param)
{
    static const value none = {NULL, 0, 0, 0, NULL};
    size_t index;
    return find(settings, param, &index) != NULL ? &settings->values[index] : &none;
}

bool duct_settings_bool(const duct_settings *settings, const char *param)
{
    return get(settings, param)->number != 0;
}

double duct_settings_number(const duct_settings *settings, const char *param)
{
    return get(settings, param)->number;
}

size_t duct_settings_size(const duct_settings *settings, const char *param)
{
    return (size_t)get(settings, param)->number;
}

uint64_t duct_settings_seed(const duct_settings *settings, const char *param)
{
    return get(settings, param)->seed;
}

size_t duct_settings_choice(const duct_settings *settings, const char *param)
{
    return get(settings, param)->choice;
}

bool duct_settings_auto_number(const duct_settings *settings, const char *param, double *number)
{
    double stored = get(settings, param)->number;
    if (isnan(stored)) {
        return false;
    }
    *number = stored;
    return true;
}

duct_status duct_settings_hand(const duct_context *context, const duct_settings *settings, const char *param,
                               const duct_library **library, duct_library **opened, duct_error *error)
{
    const value *hand = get(settings, param);
    *opened = NULL;
    if (hand->library != NULL) {
        *library = hand->library;
        return DUCT_OK;
    }
    if (hand->text == NULL || *hand->text == '\0') {
        return duct_fail(
            error, DUCT_BAD_SETTING,
            "%s: none was chosen; give the name of a hand ('ductus library list' shows them) or a file",
            param);
    }
    duct_status status = duct_library_open(context, hand->text, opened, error);
    *library = *opened;
    return status;
}

/* Strokes promise finite values; whoever filled one through the interface may not have kept that. */
static duct_status check_finite(const duct_drawing *drawing, duct_error *error)
{
    for (size_t s = 0; s < duct_drawing_stroke_count(drawing); s++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, s);
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            const double *values = duct_stroke_values(stroke, (duct_channel)c);
            for (size_t i = 0; values != NULL && i < duct_stroke_size(stroke); i++) {
                if (!isfinite(values[i])) {
                    return duct_fail(error, DUCT_BAD_ARGUMENT,
                                     "stroke '%.60s': %s of sample %zu is not a finite number",
                                     duct_stroke_id(stroke), duct_channel_name((duct_channel)c), i);
                }
            }
        }
    }
    return DUCT_OK;
}

duct_status duct_operation_run(const duct_context *context, const duct_settings *settings,
                               const duct_drawing *input, const duct_run_options *options,
                               duct_drawing **output, duct_error *error)
{
    const duct_operation_impl *operation = duct_operation_impl_of(settings->operation);
    if (operation == NULL) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "the settings belong to no operation of this library");
    }
    duct_status status = check_finite(input, error);
    if (status == DUCT_OK) {
        status = duct_progress_report(context, 0, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    duct_tracer tracer;
    duct_tracer_init(&tracer, duct_allocator_of(context), options != NULL ? options->trace : NULL,
                     options != NULL ? options->trace_user : NULL);
    duct_drawing *made = NULL;
    status = operation->run(context, settings, input, &tracer, &made, error);
    duct_tracer_free(&tracer);
    if (status == DUCT_OK) {
        *output = made;
    }
    return status;
}
