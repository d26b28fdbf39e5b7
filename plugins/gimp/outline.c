/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline.h"

#include "failure.h"
#include "paths.h"

/* Copies the selection inside the box into the scratch image's, whose upper left corner is the box's. */
static bool copy_selection(gint32 image, const GeglRectangle *box, gint32 scratch)
{
    const GimpRGB any = {1, 1, 1, 1};
    gint32 channel = gimp_channel_new(scratch, "selection", (guint)box->width, (guint)box->height, 100, &any);
    if (!gimp_image_insert_channel(scratch, channel, 0, 0)) {
        return false;
    }
    GeglBuffer *from = gimp_drawable_get_buffer(gimp_image_get_selection(image));
    GeglBuffer *to = gimp_drawable_get_buffer(channel);
    gegl_buffer_copy(from, box, GEGL_ABYSS_NONE, to, GEGL_RECTANGLE(0, 0, box->width, box->height));
    g_object_unref(from);
    g_object_unref(to);
    return gimp_image_select_item(scratch, GIMP_CHANNEL_OP_REPLACE, channel);
}

static bool make_path(gint32 scratch, const GeglRectangle *box)
{
    gint32 layer = gimp_layer_new(scratch, "layer", box->width, box->height, GIMP_GRAY_IMAGE, 100,
                                  GIMP_LAYER_MODE_NORMAL);
    if (!gimp_image_insert_layer(scratch, layer, 0, 0)) {
        return false;
    }
    int count = 0;
    GimpParam *values =
        gimp_run_procedure("plug-in-sel2path", &count, GIMP_PDB_INT32, GIMP_RUN_NONINTERACTIVE,
                           GIMP_PDB_IMAGE, scratch, GIMP_PDB_DRAWABLE, layer, GIMP_PDB_END);
    bool done = count > 0 && values[0].data.d_status == GIMP_PDB_SUCCESS;
    gimp_destroy_params(values, count);
    return done;
}

static void move(duct_drawing *drawing, size_t first, double dx, double dy)
{
    for (size_t i = first; i < duct_drawing_stroke_count(drawing); i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
        double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
        for (size_t k = 0; k < duct_stroke_size(stroke); k++) {
            x[k] += dx;
            y[k] += dy;
        }
    }
}

duct_status plug_outline_read(gint32 image, duct_drawing *drawing, duct_error *error)
{
    gboolean some = FALSE;
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    if (!gimp_selection_bounds(image, &some, &x0, &y0, &x1, &y1) || !some) {
        return plug_fail(error, DUCT_UNSUPPORTED,
                         "nothing is selected: select something, or work on another kind of lines");
    }
    /* A rim around it, so that the outline does not run along the scratch image's edge. */
    const GeglRectangle box = {x0 - 2, y0 - 2, x1 - x0 + 4, y1 - y0 + 4};
    gint32 scratch = gimp_image_new(box.width, box.height, GIMP_GRAY);
    if (scratch <= 0) {
        return plug_fail_gimp(error, "make a copy of the selection");
    }
    gimp_image_undo_disable(scratch);
    duct_status status = DUCT_OK;
    if (!copy_selection(image, &box, scratch) || !make_path(scratch, &box)) {
        status = plug_fail_gimp(error, "turn the selection into a path");
    }
    size_t first = duct_drawing_stroke_count(drawing);
    gint32 vectors = status == DUCT_OK ? gimp_image_get_active_vectors(scratch) : -1;
    if (vectors > 0) {
        status = plug_paths_read(vectors, "Selection", drawing, error);
    }
    gimp_image_delete(scratch);
    if (status == DUCT_OK && duct_drawing_stroke_count(drawing) == first) {
        return plug_fail(error, DUCT_UNSUPPORTED,
                         "the selection has no outline that could be drawn: select a larger area");
    }
    move(drawing, first, box.x, box.y);
    return status;
}
