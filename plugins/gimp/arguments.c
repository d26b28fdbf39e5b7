/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "arguments.h"

#include "failure.h"

#include <string.h>

enum { FIRST = 3 /* arguments before the settings */ };

/* The type of a parameter as an argument. */
static GimpPDBArgType type_of(const duct_param *param)
{
    switch (param->type) {
    case DUCT_PARAM_BOOL:
    case DUCT_PARAM_INT:
        return GIMP_PDB_INT32;
    case DUCT_PARAM_REAL:
        return GIMP_PDB_FLOAT;
    case DUCT_PARAM_CHOICE:
    case DUCT_PARAM_AUTO:
    case DUCT_PARAM_SEED:
    case DUCT_PARAM_HAND:
    case DUCT_PARAM_STYLE:
    case DUCT_PARAM_STROKES:
        break;
    }
    return GIMP_PDB_STRING;
}

static void describe_range(GString *text, const duct_param *param)
{
    char low[G_ASCII_DTOSTR_BUF_SIZE], high[G_ASCII_DTOSTR_BUF_SIZE];
    g_ascii_formatd(low, sizeof low, "%.10g", param->minimum);
    g_ascii_formatd(high, sizeof high, "%.10g", param->maximum);
    g_string_append_printf(text, "%s to %s%s%s", low, high, *param->unit != '\0' ? " " : "", param->unit);
}

/* Tooltip, and in brackets what may be given. */
static char *describe(const duct_param *param)
{
    GString *text = g_string_new(param->tooltip);
    g_string_append(text, " {");
    switch (param->type) {
    case DUCT_PARAM_BOOL:
        g_string_append(text, "TRUE, FALSE");
        break;
    case DUCT_PARAM_INT:
    case DUCT_PARAM_REAL:
        describe_range(text, param);
        break;
    case DUCT_PARAM_AUTO:
        g_string_append(text, "\"auto\", or as text ");
        describe_range(text, param);
        break;
    case DUCT_PARAM_SEED:
        g_string_append(text, "a whole number from 0 on, as text");
        break;
    case DUCT_PARAM_CHOICE:
        for (size_t i = 0; i < param->choice_count; i++) {
            g_string_append_printf(text, "%s\"%s\"", i > 0 ? ", " : "", param->choices[i].id);
        }
        break;
    case DUCT_PARAM_HAND:
    case DUCT_PARAM_STYLE:
        g_string_append(text, "a name, or a file's path");
        break;
    case DUCT_PARAM_STROKES:
        g_string_append(text, "strokes, separated by commas");
        break;
    }
    if (*param->fallback != '\0') {
        g_string_append_printf(text, "; default %s", param->fallback);
    }
    g_string_append_c(text, '}');
    return g_string_free(text, FALSE);
}

static void add(GArray *list, GimpPDBArgType type, const char *name, char *description)
{
    GimpParamDef argument = {type, g_strdup(name), description};
    g_array_append_val(list, argument);
}

static void add_table(GArray *list, const duct_operation *table, const plug_variant *variant)
{
    for (size_t i = 0; i < table->param_count; i++) {
        const duct_param *param = &table->params[i];
        if (!plug_job_fixed(variant, param)) {
            char name[PLUG_NAME_SIZE];
            plug_job_name(table, param, name, sizeof name);
            add(list, type_of(param), name, describe(param));
        }
    }
}

GimpParamDef *plug_arguments_make(const duct_operation *operation, const plug_variant *variant, int *count)
{
    GArray *list = g_array_new(FALSE, FALSE, sizeof(GimpParamDef));
    add(list, GIMP_PDB_INT32, "run-mode",
        g_strdup("The run mode {RUN-INTERACTIVE (0), RUN-NONINTERACTIVE (1), RUN-WITH-LAST-VALS (2)}"));
    add(list, GIMP_PDB_IMAGE, "image", g_strdup("The image"));
    if (variant->on_vectors) {
        add(list, GIMP_PDB_VECTORS, "path", g_strdup("The path whose lines are drawn"));
    } else {
        add(list, GIMP_PDB_DRAWABLE, "drawable", g_strdup("The layer above which, or on which, is painted"));
    }
    if (variant->as_text) {
        add(list, GIMP_PDB_STRING, "settings",
            g_strdup_printf("\"name=value; name=value ...\", the names being those of the arguments of "
                            "plug-in-ductus-%s; what is not named is at its default",
                            operation->id));
    } else {
        add_table(list, &plug_options, variant);
        add_table(list, operation, variant);
    }
    *count = (int)list->len;
    return (GimpParamDef *)(void *)g_array_free(list, FALSE);
}

void plug_arguments_free(GimpParamDef *arguments, int count)
{
    for (int i = 0; i < count; i++) {
        g_free(arguments[i].name);
        g_free(arguments[i].description);
    }
    g_free(arguments);
}

/* The argument as the text that settings take. */
static const char *as_text(const duct_param *param, const GimpParam *value, char *buffer, size_t size)
{
    switch (type_of(param)) {
    case GIMP_PDB_INT32:
        if (param->type == DUCT_PARAM_BOOL) {
            return value->data.d_int32 != 0 ? "true" : "false";
        }
        g_snprintf(buffer, size, "%d", value->data.d_int32);
        return buffer;
    case GIMP_PDB_FLOAT:
        return g_ascii_dtostr(buffer, (int)size, value->data.d_float);
    default:
        return value->data.d_string != NULL ? value->data.d_string : "";
    }
}

static duct_status read_table(duct_settings *settings, const plug_variant *variant, const GimpParam **next,
                              duct_error *error)
{
    const duct_operation *table = duct_settings_operation(settings);
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < table->param_count && status == DUCT_OK; i++) {
        const duct_param *param = &table->params[i];
        if (!plug_job_fixed(variant, param)) {
            char buffer[64];
            const char *text = as_text(param, (*next)++, buffer, sizeof buffer);
            status = duct_settings_set(settings, param->id, text, error);
        }
    }
    return status;
}

static int count_of(const duct_operation *operation, const plug_variant *variant)
{
    int count = 0;
    GimpParamDef *arguments = plug_arguments_make(operation, variant, &count);
    plug_arguments_free(arguments, count);
    return count;
}

duct_status plug_arguments_read(struct job *job, const GimpParam *values, int count, GimpRunMode mode,
                                duct_error *error)
{
    int expected = mode == GIMP_RUN_NONINTERACTIVE ? count_of(job->operation, job->variant) : FIRST;
    if (count < expected) {
        return plug_fail(error, DUCT_BAD_ARGUMENT, "%d arguments were given and %d are needed", count,
                         expected);
    }
    job->image = values[1].data.d_image;
    if (job->variant->on_vectors) {
        job->vectors = values[2].data.d_vectors;
        job->drawable = gimp_image_get_active_drawable(job->image);
    } else {
        job->drawable = values[2].data.d_drawable;
    }
    if (mode != GIMP_RUN_NONINTERACTIVE) {
        return DUCT_OK;
    }
    if (job->variant->as_text) {
        return plug_job_read_text(job, values[FIRST].data.d_string != NULL ? values[FIRST].data.d_string : "",
                                  error);
    }
    const GimpParam *next = values + FIRST;
    duct_status status = read_table(job->options, job->variant, &next, error);
    return status == DUCT_OK ? read_table(job->settings, job->variant, &next, error) : status;
}
