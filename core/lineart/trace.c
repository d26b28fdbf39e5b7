/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lineart/lineart_private.h"

#include "base/error.h"
#include "base/pool.h"

#include <math.h>

enum { MOST_SIDE = 65536, MOST_PIXELS = 1 << 30 };

duct_lineart_options duct_lineart_options_default(void)
{
    return (duct_lineart_options){DUCT_INK_AUTO, 0, 100, 4};
}

static duct_status check(int width, int height, const duct_lineart_options *options, duct_error *error)
{
    if (width < 1 || height < 1 || width > MOST_SIDE || height > MOST_SIDE || height > MOST_PIXELS / width) {
        return duct_fail(error, DUCT_LIMIT,
                         "a picture of %d x %d pixels cannot be traced: it may have %d a side and %d in all",
                         width, height, MOST_SIDE, MOST_PIXELS);
    }
    if (!(options->threshold >= 0 && options->threshold < 1)) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "the threshold for ink is not in 0..1");
    }
    if (!(options->widest >= 1 && options->widest <= MOST_SIDE) ||
        !(options->shortest >= 0 && isfinite(options->shortest))) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "the widest or the shortest line is not a usable number");
    }
    return DUCT_OK;
}

static duct_status trace_graph(const duct_context *context, const duct_bitmap *ink,
                               const duct_lineart_options *options, duct_graph *graph, duct_error *error)
{
    duct_bitmap thin;
    if (!duct_bitmap_copy(&thin, ink)) {
        return duct_fail_memory(error);
    }
    duct_status status = duct_thin(context, &thin, options->widest, error);
    if (status == DUCT_OK) {
        status = duct_graph_trace(context, &thin, ink, graph, error);
    }
    duct_bitmap_done(&thin);
    return status;
}

duct_status duct_lineart_trace(const duct_context *context, int width, int height, duct_picture_rows rows,
                               void *user, const duct_lineart_options *options, duct_drawing *drawing,
                               duct_error *error)
{
    duct_lineart_options used = options != NULL ? *options : duct_lineart_options_default();
    duct_status status = check(width, height, &used, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_bitmap ink;
    if (!duct_bitmap_init(&ink, allocator, width, height)) {
        return duct_fail_memory(error);
    }
    duct_graph graph;
    duct_graph_init(&graph, allocator);
    bool found = false;
    status = duct_ink_find(context, &used, rows, user, &ink, &found, error);
    if (status == DUCT_OK && found) {
        status = trace_graph(context, &ink, &used, &graph, error);
    }
    duct_bitmap_done(&ink);
    if (status == DUCT_OK) {
        status = duct_graph_join(&graph, error);
    }
    if (status == DUCT_OK) {
        status = duct_progress_report(context, 1, error);
    }
    if (status == DUCT_OK) {
        status = duct_graph_strokes(&graph, &used, drawing, error);
    }
    duct_graph_done(&graph);
    return status;
}
