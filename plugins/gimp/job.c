/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "job.h"

#include "failure.h"

#include <string.h>

duct_status plug_job_init(struct job *job, const duct_operation *operation, const plug_variant *variant,
                          duct_error *error)
{
    memset(job, 0, sizeof *job);
    job->operation = operation;
    job->variant = variant;
    job->image = job->drawable = job->vectors = -1;
    duct_status status = duct_settings_new(NULL, operation, &job->settings, error);
    if (status == DUCT_OK) {
        status = duct_settings_new(NULL, &plug_options, &job->options, error);
    }
    if (status == DUCT_OK && variant->lines != NULL) {
        status = duct_settings_set(job->options, OPTION_LINES, variant->lines, error);
    }
    return status;
}

void plug_job_done(struct job *job)
{
    duct_settings_free(job->settings);
    duct_settings_free(job->options);
    job->settings = job->options = NULL;
}

bool plug_job_fixed(const plug_variant *variant, const duct_param *param)
{
    return variant->lines != NULL && strcmp(param->id, OPTION_LINES) == 0;
}

static bool is_own(const char *id)
{
    for (size_t i = 0; i < plug_options.param_count; i++) {
        if (strcmp(plug_options.params[i].id, id) == 0) {
            return true;
        }
    }
    return false;
}

void plug_job_name(const duct_operation *operation, const duct_param *param, char *name, size_t size)
{
    bool shared = operation != &plug_options && is_own(param->id);
    g_snprintf(name, size, "%s%s%s", shared ? operation->id : "", shared ? "-" : "", param->id);
}

/* The operation's parameter of that name; NULL where there is none. */
static const char *own_id(const duct_operation *operation, const char *name)
{
    for (size_t i = 0; i < operation->param_count; i++) {
        char known[PLUG_NAME_SIZE];
        plug_job_name(operation, &operation->params[i], known, sizeof known);
        if (strcmp(known, name) == 0) {
            return operation->params[i].id;
        }
    }
    return strcmp(name, "preset") == 0 ? name : NULL;
}

duct_status plug_job_set(struct job *job, const char *param, const char *value, duct_error *error)
{
    if (duct_settings_text(job->options, param) != NULL) {
        return duct_settings_set(job->options, param, value, error);
    }
    const char *id = own_id(job->operation, param);
    if (id != NULL) {
        return duct_settings_set(job->settings, id, value, error);
    }
    return plug_fail(error, DUCT_BAD_SETTING,
                     "there is no setting '%.80s'; GIMP's Procedure Browser lists those of plug-in-ductus-%s",
                     param, job->operation->id);
}

duct_status plug_job_read_text(struct job *job, const char *text, duct_error *error)
{
    char **pairs = g_strsplit_set(text, ";\n", -1);
    duct_status status = DUCT_OK;
    for (char **pair = pairs; *pair != NULL && status == DUCT_OK; pair++) {
        char *trimmed = g_strstrip(*pair);
        if (*trimmed == '\0') {
            continue;
        }
        char *equals = strchr(trimmed, '=');
        if (equals == NULL) {
            status = plug_fail(error, DUCT_BAD_SETTING,
                               "'%.80s' is no setting; write name=value, parted by semicolons", trimmed);
            break;
        }
        *equals = '\0';
        status = plug_job_set(job, g_strchomp(trimmed), g_strchug(equals + 1), error);
    }
    g_strfreev(pairs);
    return status;
}

static void write_values(GString *text, const duct_settings *settings)
{
    const duct_operation *table = duct_settings_operation(settings);
    for (size_t i = 0; i < table->param_count; i++) {
        char name[PLUG_NAME_SIZE];
        plug_job_name(table, &table->params[i], name, sizeof name);
        g_string_append_printf(text, "%s=%s\n", name, duct_settings_text(settings, table->params[i].id));
    }
}

char *plug_job_write_text(const struct job *job)
{
    GString *text = g_string_new(NULL);
    write_values(text, job->options);
    write_values(text, job->settings);
    return g_string_free(text, FALSE);
}
