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

duct_status plug_job_set(struct job *job, const char *param, const char *value, duct_error *error)
{
    if (duct_settings_text(job->options, param) != NULL) {
        return duct_settings_set(job->options, param, value, error);
    }
    if (duct_settings_text(job->settings, param) != NULL || strcmp(param, "preset") == 0) {
        return duct_settings_set(job->settings, param, value, error);
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
        const char *id = table->params[i].id;
        g_string_append_printf(text, "%s=%s\n", id, duct_settings_text(settings, id));
    }
}

char *plug_job_write_text(const struct job *job)
{
    GString *text = g_string_new(NULL);
    write_values(text, job->options);
    write_values(text, job->settings);
    return g_string_free(text, FALSE);
}
