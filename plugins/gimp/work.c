/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "work.h"

#include "failure.h"

#include <glib.h>

/* A share of a longer work's progress. */
struct share {
    const duct_context *whole;
    double from, to;
};

static bool report(void *user, double fraction)
{
    const struct share *part = user;
    const duct_context *whole = part->whole;
    return whole->progress == NULL ||
           whole->progress(whole->progress_user, part->from + (part->to - part->from) * fraction);
}

static duct_status operate(struct work *work, double until)
{
    struct share part = {&work->context, 0, until};
    duct_context context = work->context;
    context.progress = report;
    context.progress_user = &part;
    return duct_operation_run(&context, work->settings, work->input, NULL, &work->output, &work->error);
}

static duct_status paint(struct work *work, double from)
{
    struct share part = {&work->context, from, 1};
    const duct_drawing *drawing = work->known != NULL ? work->known : work->output;
    size_t count = duct_drawing_stroke_count(drawing);
    duct_status status =
        duct_canvas_new(&work->context, work->width, work->height, &work->canvas, &work->error);
    for (size_t i = 0; i < count && status == DUCT_OK; i++) {
        if (!report(&part, (double)i / (double)count)) {
            return plug_fail(&work->error, DUCT_CANCELLED, "cancelled");
        }
        status = duct_canvas_paint(work->canvas, work->brush, duct_drawing_stroke(drawing, i), &work->paint,
                                   &work->error);
    }
    return status;
}

duct_status plug_work_run(struct work *work)
{
    const double split = work->known != NULL ? 0 : work->brush != NULL ? 0.5 : 1;
    work->output = NULL;
    work->canvas = NULL;
    duct_status status = work->known != NULL ? DUCT_OK : operate(work, split);
    if (status == DUCT_OK && work->brush != NULL) {
        gint64 begun = g_get_monotonic_time();
        status = paint(work, split);
        work->brush_seconds = (double)(g_get_monotonic_time() - begun) / 1e6;
    }
    if (status != DUCT_OK) {
        plug_work_done(work);
    }
    return status;
}

void plug_work_done(struct work *work)
{
    duct_drawing_free(work->output);
    duct_canvas_free(work->canvas);
    work->output = NULL;
    work->canvas = NULL;
}
