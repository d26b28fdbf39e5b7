/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of operations, and their tables as JSON. */
#include "operations/operation_private.h"

#include "base/error.h"
#include "base/json.h"
#include "operations/registry.h"

#include <stdio.h>
#include <string.h>

static const duct_operation_impl *const operations[] = {
    &duct_operation_restyle,
    &duct_operation_analogy,
    &duct_operation_synthesize_curve,
};

enum { OPERATION_COUNT = sizeof operations / sizeof operations[0] };

const duct_operation *duct_operation_at(size_t index)
{
    return index < OPERATION_COUNT ? &operations[index]->info : NULL;
}

const duct_operation_impl *duct_operation_impl_of(const duct_operation *operation)
{
    for (size_t i = 0; i < OPERATION_COUNT; i++) {
        if (&operations[i]->info == operation) {
            return operations[i];
        }
    }
    return NULL;
}

duct_status duct_operation_find(const char *id, const duct_operation **operation, duct_error *error)
{
    char names[256] = "";
    size_t used = 0;
    for (size_t i = 0; i < OPERATION_COUNT; i++) {
        if (strcmp(operations[i]->info.id, id) == 0) {
            *operation = &operations[i]->info;
            return DUCT_OK;
        }
        if (used < sizeof names) {
            int length = snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "",
                                  operations[i]->info.id);
            used += length > 0 ? (size_t)length : 0;
        }
    }
    return duct_fail(error, DUCT_NOT_FOUND, "there is no operation '%s'; there are: %s", id, names);
}

const char *duct_param_type_name(duct_param_type type)
{
    switch (type) {
    case DUCT_PARAM_BOOL:
        return "bool";
    case DUCT_PARAM_INT:
        return "int";
    case DUCT_PARAM_REAL:
        return "real";
    case DUCT_PARAM_CHOICE:
        return "choice";
    case DUCT_PARAM_AUTO:
        return "auto-or-real";
    case DUCT_PARAM_SEED:
        return "seed";
    case DUCT_PARAM_HAND:
        return "hand";
    case DUCT_PARAM_STYLE:
        return "style";
    case DUCT_PARAM_STROKES:
        return "strokes";
    }
    return "unknown";
}

static bool is_number(duct_param_type type)
{
    return type == DUCT_PARAM_INT || type == DUCT_PARAM_REAL || type == DUCT_PARAM_AUTO;
}

static void describe(duct_json *json, const char *id, const char *label, const char *tooltip)
{
    duct_json_string(json, "id", id);
    duct_json_string(json, "label", label);
    duct_json_string(json, "tooltip", tooltip);
}

static void param_json(duct_json *json, const duct_param *param)
{
    duct_json_object(json, NULL);
    describe(json, param->id, param->label, param->tooltip);
    duct_json_string(json, "type", duct_param_type_name(param->type));
    duct_json_string(json, "unit", param->unit);
    if (is_number(param->type)) {
        duct_json_row(json, "range", '[');
        duct_json_number(json, NULL, param->minimum);
        duct_json_number(json, NULL, param->maximum);
        duct_json_close(json, ']');
        duct_json_number(json, "step", param->step);
    }
    duct_json_string(json, "default", param->fallback);
    duct_json_array(json, "choices");
    for (size_t i = 0; i < param->choice_count; i++) {
        duct_json_object(json, NULL);
        describe(json, param->choices[i].id, param->choices[i].label, param->choices[i].tooltip);
        duct_json_close(json, '}');
    }
    duct_json_close(json, ']');
    duct_json_string(json, "group", param->group);
    duct_json_bool(json, "advanced", param->advanced);
    duct_json_close(json, '}');
}

static void operation_json(duct_json *json, const duct_operation *operation)
{
    duct_json_object(json, NULL);
    duct_json_string(json, "id", operation->id);
    duct_json_string(json, "label", operation->label);
    duct_json_string(json, "summary", operation->summary);
    duct_json_array(json, "parameters");
    for (size_t i = 0; i < operation->param_count; i++) {
        param_json(json, &operation->params[i]);
    }
    duct_json_close(json, ']');
    duct_json_array(json, "presets");
    for (size_t i = 0; i < operation->preset_count; i++) {
        const duct_preset *preset = &operation->presets[i];
        duct_json_object(json, NULL);
        describe(json, preset->id, preset->label, preset->tooltip);
        duct_json_object(json, "values");
        for (size_t v = 0; v < preset->value_count; v++) {
            duct_json_string(json, preset->values[v].param, preset->values[v].value);
        }
        duct_json_close(json, '}');
        duct_json_close(json, '}');
    }
    duct_json_close(json, ']');
    duct_json_close(json, '}');
}

duct_status duct_operations_json(const duct_context *context, char **text, duct_error *error)
{
    duct_text out;
    duct_text_init(&out, duct_allocator_of(context));
    duct_json json;
    duct_json_init(&json, &out);
    duct_json_object(&json, NULL);
    duct_json_array(&json, "operations");
    for (size_t i = 0; i < OPERATION_COUNT; i++) {
        operation_json(&json, &operations[i]->info);
    }
    duct_json_close(&json, ']');
    duct_json_close(&json, '}');
    duct_text_add(&out, "\n");
    char *data = duct_text_take(&out, NULL);
    if (data == NULL) {
        return duct_fail_memory(error);
    }
    *text = data;
    return DUCT_OK;
}
