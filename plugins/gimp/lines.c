/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lines.h"

#include "failure.h"
#include "line_art.h"
#include "outline.h"
#include "paths.h"

static duct_status read_path(const struct job *job, duct_drawing *drawing, duct_error *error)
{
    gint32 vectors = job->vectors > 0 ? job->vectors : gimp_image_get_active_vectors(job->image);
    if (vectors <= 0) {
        return plug_fail(
            error, DUCT_UNSUPPORTED,
            "the image has no active path: draw one with the Paths tool, or work on another kind "
            "of lines");
    }
    duct_status status = plug_paths_read(vectors, NULL, drawing, error);
    if (status == DUCT_OK && duct_drawing_stroke_count(drawing) == 0) {
        char *name = gimp_item_get_name(vectors);
        status =
            plug_fail(error, DUCT_UNSUPPORTED,
                      "the path '%.80s' has no line: give it at least two points, or choose another path",
                      name != NULL ? name : "");
        g_free(name);
    }
    return status;
}

/* From the lowest path up, as they cover one another. */
static duct_status read_visible(const struct job *job, duct_drawing *drawing, duct_error *error)
{
    int count = 0;
    int *vectors = gimp_image_get_vectors(job->image, &count);
    duct_status status = DUCT_OK;
    for (int i = count - 1; i >= 0 && status == DUCT_OK; i--) {
        if (gimp_item_get_visible(vectors[i])) {
            status = plug_paths_read(vectors[i], NULL, drawing, error);
        }
    }
    g_free(vectors);
    if (status == DUCT_OK && duct_drawing_stroke_count(drawing) == 0) {
        return plug_fail(error, DUCT_UNSUPPORTED,
                         "no visible path has a line: click at the eye of a path in the dialog of paths");
    }
    return status;
}

static void colour(duct_drawing *drawing)
{
    GimpRGB foreground;
    gimp_context_get_foreground(&foreground);
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
        duct_stroke_style style = duct_stroke_get_style(stroke);
        style.red = (float)CLAMP(foreground.r, 0, 1);
        style.green = (float)CLAMP(foreground.g, 0, 1);
        style.blue = (float)CLAMP(foreground.b, 0, 1);
        duct_stroke_set_style(stroke, style);
    }
}

static duct_status read_lines(const struct job *job, const duct_context *context, duct_drawing *drawing,
                              duct_error *error)
{
    if (plug_option_is(job->options, OPTION_LINES, LINES_PATH)) {
        return read_path(job, drawing, error);
    }
    if (plug_option_is(job->options, OPTION_LINES, LINES_VISIBLE)) {
        return read_visible(job, drawing, error);
    }
    if (plug_option_is(job->options, OPTION_LINES, LINES_SELECTION)) {
        return plug_outline_read(job->image, drawing, error);
    }
    return plug_line_art_read(job, context, drawing, error);
}

duct_status plug_lines_read(const struct job *job, const duct_context *context, duct_drawing **drawing,
                            duct_error *error)
{
    duct_drawing *made = NULL;
    duct_status status = duct_drawing_new(NULL, &made, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_drawing_set_page(made, gimp_image_width(job->image), gimp_image_height(job->image));
    status = read_lines(job, context, made, error);
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    if (!plug_option_is(job->options, OPTION_LINES, LINES_ART) ||
        plug_option_is(job->options, OPTION_COLOUR, "foreground")) {
        colour(made);
    }
    *drawing = made;
    return DUCT_OK;
}
