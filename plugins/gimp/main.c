/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plug-in's entry points: GIMP asks once for what there is, and then runs this program for each call. */
#include "arguments.h"
#include "dialog.h"
#include "failure.h"
#include "run.h"
#include "values.h"

#include <string.h>

static void query(void)
{
    plug_procedures_install();
}

static duct_status run_job(struct job *job, GimpRunMode mode, struct result *result, duct_error *error)
{
    switch (mode) {
    case GIMP_RUN_INTERACTIVE:
        plug_values_load(job);
        plug_values_first(job);
        return plug_dialog_run(job, result, error);
    case GIMP_RUN_WITH_LAST_VALS:
        plug_values_load(job);
        plug_values_first(job);
        break;
    case GIMP_RUN_NONINTERACTIVE:
        break;
    }
    return plug_run(job, result, error);
}

/* Buffers are all that is used of GEGL; its some hundred operations would take a third of a second to load.
 */
static void start_gegl(void)
{
    g_setenv("GEGL_PATH", "", FALSE);
    gegl_init(NULL, NULL);
}

static duct_status run_call(const char *name, int count, const GimpParam *values, struct result *result,
                            duct_error *error)
{
    const duct_operation *operation;
    const plug_variant *variant;
    if (!plug_procedure_find(name, &operation, &variant) || count < 3) {
        return plug_fail(error, DUCT_BAD_ARGUMENT,
                         "this is no procedure of Ductus, or was called without image");
    }
    GimpRunMode mode = (GimpRunMode)values[0].data.d_int32;
    struct job job;
    duct_status status = plug_job_init(&job, operation, variant, error);
    if (status == DUCT_OK) {
        status = plug_arguments_read(&job, values, count, mode, error);
    }
    if (status == DUCT_OK) {
        start_gegl();
        status = run_job(&job, mode, result, error);
    }
    plug_job_done(&job);
    return status;
}

/* A sentence for GIMP's message box. */
static char *sentence(const duct_error *error)
{
    char *text = g_strdup_printf("Ductus: %s.", error->message);
    return text;
}

static void run(const gchar *name, gint count, const GimpParam *values, gint *answer_count,
                GimpParam **answers)
{
    static GimpParam answer[4];
    static char *message;
    duct_error error = {DUCT_OK, ""};
    struct result result = {-1, NULL};
    duct_status status = run_call(name, count, values, &result, &error);
    memset(answer, 0, sizeof answer);
    answer[0].type = GIMP_PDB_STATUS;
    *answers = answer;
    if (status == DUCT_CANCELLED) {
        answer[0].data.d_status = GIMP_PDB_CANCEL;
        *answer_count = 1;
        return;
    }
    if (status != DUCT_OK) {
        message = sentence(&error);
        answer[0].data.d_status = GIMP_PDB_EXECUTION_ERROR;
        answer[1].type = GIMP_PDB_STRING;
        answer[1].data.d_string = message;
        *answer_count = 2;
        return;
    }
    answer[0].data.d_status = GIMP_PDB_SUCCESS;
    answer[1].type = GIMP_PDB_LAYER;
    answer[1].data.d_layer = result.layer;
    answer[2].type = GIMP_PDB_INT32;
    answer[2].data.d_int32 = result.paths != NULL ? (gint32)result.paths->len : 0;
    answer[3].type = GIMP_PDB_INT32ARRAY;
    answer[3].data.d_int32array = result.paths != NULL ? (gint32 *)(void *)result.paths->data : NULL;
    *answer_count = 4;
    /* GIMP reads the answers after this function has returned, so the paths' numbers stay. */
}

const GimpPlugInInfo PLUG_IN_INFO = {NULL, NULL, query, run};

MAIN()
