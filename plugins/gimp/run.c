/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A job from its lines to its result, without a dialog. If the user cancels at GIMP's progress bar, GIMP ends
 * this process; as nothing has been put into the image until all is worked out, nothing is left behind. */
#include "run.h"

#include "brushes.h"
#include "failure.h"
#include "lines.h"

#include <string.h>

/* GIMP's bar, told no more often than it can be seen. */
struct bar {
    double from, to;
    gint64 told; /* microseconds */
};

static bool tell(void *user, double fraction)
{
    struct bar *bar = user;
    gint64 now = g_get_monotonic_time();
    if (now - bar->told > 50000) {
        bar->told = now;
        gimp_progress_update(bar->from + (bar->to - bar->from) * fraction);
    }
    return true;
}

static duct_context context_of(struct bar *bar, double from, double to)
{
    bar->from = from;
    bar->to = to;
    duct_context context = duct_context_default();
    context.progress = tell;
    context.progress_user = bar;
    return context;
}

duct_paint_options plug_run_paint_options(const struct job *job, double scale, double x, double y)
{
    duct_paint_options options = duct_paint_options_default();
    options.scale = scale;
    options.offset_x = -x * scale;
    options.offset_y = -y * scale;
    options.brush_size = plug_option_number(job->options, OPTION_SIZE, 0);
    return options;
}

duct_status plug_run_prepare(const struct job *job, struct work *work, duct_brush **brush, duct_error *error)
{
    memset(work, 0, sizeof *work);
    *brush = NULL;
    if (plug_option_paints(job->options)) {
        duct_status status = plug_brush_load(duct_settings_text(job->options, OPTION_BRUSH), brush, error);
        if (status != DUCT_OK) {
            return status;
        }
    }
    work->settings = job->settings;
    work->brush = *brush;
    work->paint = plug_run_paint_options(job, 1, 0, 0);
    work->width = gimp_image_width(job->image);
    work->height = gimp_image_height(job->image);
    work->context = duct_context_default();
    return DUCT_OK;
}

duct_status plug_run(const struct job *job, struct result *result, duct_error *error)
{
    struct work work;
    duct_brush *brush = NULL;
    struct lines lines = {0};
    struct bar bar = {0, 1, 0};
    duct_status status = plug_result_check(job, error);
    if (status == DUCT_OK) {
        status = plug_run_prepare(job, &work, &brush, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    gint64 times[4] = {g_get_monotonic_time(), 0, 0, 0};
    gimp_progress_init(job->operation->label);
    duct_context context = context_of(&bar, 0, 0.2);
    status = plug_lines_open(job, NULL, NULL, &lines, error);
    if (status == DUCT_OK) {
        status = plug_lines_find(&lines, &context, error);
    }
    times[1] = g_get_monotonic_time();
    if (status == DUCT_OK) {
        work.input = lines.drawing;
        work.context = context_of(&bar, 0.2, 0.9);
        status = plug_work_run(&work);
        *error = work.error;
    }
    times[2] = g_get_monotonic_time();
    if (status == DUCT_OK) {
        context = context_of(&bar, 0.9, 1);
        status = plug_result_commit(job, &context, &work, result, error);
        plug_work_done(&work);
    }
    times[3] = g_get_monotonic_time();
    /* For bench/gimp.py; G_MESSAGES_DEBUG=ductus shows it. */
    g_debug("seconds: lines %.3f, operation %.3f, brush %.3f, image %.3f",
            (double)(times[1] - times[0]) / 1e6, (double)(times[2] - times[1]) / 1e6 - work.brush_seconds,
            work.brush_seconds, (double)(times[3] - times[2]) / 1e6);
    plug_lines_close(&lines);
    duct_brush_free(brush);
    gimp_progress_end();
    return status;
}
