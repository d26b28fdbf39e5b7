/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "result.h"

#include "failure.h"
#include "paint.h"
#include "paths.h"

static char *name_of(gint32 item)
{
    char *name = gimp_item_get_name(item);
    return name != NULL ? name : g_strdup("");
}

static duct_status check_active(const struct job *job, duct_error *error)
{
    if (job->drawable <= 0 || !gimp_item_is_drawable(job->drawable)) {
        return plug_fail(
            error, DUCT_UNSUPPORTED,
            "there is no active layer to paint on: choose one, or let the result be a new layer");
    }
    char *name = name_of(job->drawable);
    duct_status status = DUCT_OK;
    if (gimp_item_is_group(job->drawable)) {
        status =
            plug_fail(error, DUCT_UNSUPPORTED,
                      "'%.80s' is a group of layers and cannot be painted on: choose a layer, or let the "
                      "result be a new layer",
                      name);
    } else if (gimp_item_get_lock_content(job->drawable)) {
        status =
            plug_fail(error, DUCT_UNSUPPORTED,
                      "the pixels of '%.80s' are locked: unlock them in the dialog of layers, or let the "
                      "result be a new layer",
                      name);
    }
    g_free(name);
    return status;
}

duct_status plug_result_check(const struct job *job, duct_error *error)
{
    if (!gimp_image_is_valid(job->image)) {
        return plug_fail(error, DUCT_BAD_ARGUMENT, "there is no image of that number");
    }
    if ((job->drawable > 0 && gimp_item_get_image(job->drawable) != job->image) ||
        (job->vectors > 0 && gimp_item_get_image(job->vectors) != job->image)) {
        return plug_fail(error, DUCT_BAD_ARGUMENT, "the layer or path given belongs to another image");
    }
    if (!plug_option_paints(job->options)) {
        return DUCT_OK;
    }
    if (gimp_image_base_type(job->image) == GIMP_INDEXED) {
        return plug_fail(
            error, DUCT_UNSUPPORTED,
            "the image has a palette, which cannot hold the brush's shades: choose Image > Mode > "
            "RGB first, or let the result be paths");
    }
    if (gimp_image_get_floating_sel(job->image) > 0) {
        return plug_fail(error, DUCT_UNSUPPORTED,
                         "the image has a floating selection: anchor it, or make it a layer, first");
    }
    return plug_option_is(job->options, OPTION_RESULT, RESULT_ONTO) ? check_active(job, error) : DUCT_OK;
}

/* The layer that new layers go above: the active one, or that whose mask is active; -1: the topmost. */
static gint32 layer_below(const struct job *job)
{
    if (job->drawable > 0 && gimp_item_is_layer_mask(job->drawable)) {
        return gimp_layer_from_mask(job->drawable);
    }
    return job->drawable > 0 && gimp_item_is_layer(job->drawable) ? job->drawable
                                                                  : gimp_image_get_active_layer(job->image);
}

static bool insert_layer(const struct job *job, gint32 layer)
{
    gint32 below = layer_below(job);
    gint32 parent = below > 0 ? gimp_item_get_parent(below) : -1;
    int position = below > 0 ? gimp_image_get_item_position(job->image, below) : 0;
    if (!gimp_image_insert_layer(job->image, layer, parent > 0 ? parent : 0, position)) {
        return false;
    }
    if (plug_option_is(job->options, OPTION_LINES, LINES_ART) &&
        plug_option_bool(job->options, OPTION_HIDE) && below > 0) {
        gimp_item_set_visible(below, FALSE);
    }
    return true;
}

/* GIMP itself lays a floating selection down: with mode and opacity, in the layer's precision, minding its
 * alpha lock. */
static bool lay_down(const struct job *job, gint32 layer)
{
    return gimp_floating_sel_attach(layer, job->drawable) && gimp_floating_sel_anchor(layer);
}

static bool insert_paths(const struct job *job, const GArray *paths)
{
    bool done = true;
    for (guint i = 0; i < paths->len && done; i++) {
        gint32 path = g_array_index(paths, gint32, i);
        done = gimp_image_insert_vectors(job->image, path, 0, 0);
        gimp_item_set_visible(path, TRUE);
    }
    return done;
}

static duct_status insert_all(const struct job *job, const struct result *result, duct_error *error)
{
    bool onto = plug_option_is(job->options, OPTION_RESULT, RESULT_ONTO);
    duct_status status = DUCT_OK;
    gimp_image_undo_group_start(job->image);
    if (result->layer > 0 && !(onto ? lay_down(job, result->layer) : insert_layer(job, result->layer))) {
        status = plug_fail_gimp(error, onto ? "paint on the active layer" : "add a layer");
    }
    if (status == DUCT_OK && result->paths != NULL && !insert_paths(job, result->paths)) {
        status = plug_fail_gimp(error, "add a path");
    }
    gimp_image_undo_group_end(job->image);
    return status;
}

static void forget(struct result *result)
{
    if (result->layer > 0 && gimp_item_is_valid(result->layer)) {
        gimp_item_delete(result->layer);
    }
    for (guint i = 0; result->paths != NULL && i < result->paths->len; i++) {
        gimp_item_delete(g_array_index(result->paths, gint32, i));
    }
    plug_result_done(result);
}

duct_status plug_result_commit(const struct job *job, const duct_context *context, const struct work *work,
                               struct result *result, duct_error *error)
{
    result->layer = -1;
    result->paths = NULL;
    duct_status status = DUCT_OK;
    if (plug_option_makes_paths(job->options)) {
        status =
            plug_paths_make(job->image, work->output, job->operation->label,
                            plug_option_number(job->options, OPTION_TOLERANCE, 0.5), &result->paths, error);
    }
    if (status == DUCT_OK && work->canvas != NULL) {
        struct clip clip;
        plug_clip_init(&clip, job);
        status = plug_paint_layer(job, context, work->canvas, &clip, &result->layer, error);
        plug_clip_done(&clip);
    }
    if (status != DUCT_OK) {
        forget(result);
        return status;
    }
    status = insert_all(job, result, error);
    if (plug_option_is(job->options, OPTION_RESULT, RESULT_ONTO)) {
        result->layer = -1;
    }
    gimp_displays_flush();
    return status;
}

void plug_result_done(struct result *result)
{
    if (result->paths != NULL) {
        g_array_free(result->paths, TRUE);
    }
    result->paths = NULL;
    result->layer = -1;
}
