/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "values.h"

#include <ductus/library.h>

#include <string.h>

/* The procedure whose values these are; the text procedure has those of the one that takes them one by one.
 */
static void name_of(const struct job *job, char *name, size_t size)
{
    plug_variant variant = *job->variant;
    variant.suffix = variant.as_text ? "" : variant.suffix;
    plug_procedure_name(job->operation, &variant, name, size);
}

/* The user's file of a procedure; free with g_free(). */
static char *file_of(const char *procedure)
{
    char *name = g_strconcat(procedure, ".values", NULL);
    char *path = g_build_filename(gimp_directory(), "plug-in-settings", name, NULL);
    g_free(name);
    return path;
}

static void read_values(struct job *job, const char *text)
{
    char **values = g_strsplit(text, "\n", -1);
    for (char **value = values; *value != NULL; value++) {
        duct_error passed_over;
        plug_job_read_text(job, *value, &passed_over);
    }
    g_strfreev(values);
}

void plug_values_load(struct job *job)
{
    char name[PLUG_NAME_SIZE];
    name_of(job, name, sizeof name);
    int size = gimp_get_data_size(name);
    char *text = NULL;
    if (size > 0) {
        text = g_malloc0((gsize)size + 1);
        gimp_get_data(name, text);
    } else {
        char *file = file_of(name);
        g_file_get_contents(file, &text, NULL, NULL);
        g_free(file);
    }
    if (text != NULL) {
        read_values(job, text);
    }
    g_free(text);
    if (job->variant->lines != NULL) {
        duct_error cannot_fail;
        plug_job_set(job, OPTION_LINES, job->variant->lines, &cannot_fail);
    }
}

void plug_values_keep(const struct job *job)
{
    char name[PLUG_NAME_SIZE];
    name_of(job, name, sizeof name);
    char *text = plug_job_write_text(job);
    gimp_set_data(name, text, (guint32)strlen(text));
    char *file = file_of(name);
    char *folder = g_path_get_dirname(file);
    /* A folder that cannot be written to only means that the values last no longer than GIMP. */
    if (g_mkdir_with_parents(folder, 0700) == 0) {
        g_file_set_contents(file, text, -1, NULL);
    }
    g_free(folder);
    g_free(file);
    g_free(text);
}

void plug_values_first(struct job *job)
{
    duct_hand *hands = NULL;
    size_t count = 0;
    duct_error error;
    if (duct_library_list(NULL, &hands, &count, &error) != DUCT_OK) {
        return;
    }
    for (size_t i = 0; i < job->operation->param_count && count > 0; i++) {
        const duct_param *param = &job->operation->params[i];
        if (param->type == DUCT_PARAM_HAND && *duct_settings_text(job->settings, param->id) == '\0') {
            duct_settings_set(job->settings, param->id, hands[0].name, &error);
        }
    }
    duct_hands_free(NULL, hands, count);
}
