/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lines.h"

#include "failure.h"
#include "outline.h"
#include "paths.h"

#include <string.h>

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

static void colour(duct_drawing *drawing, const GimpRGB *chosen)
{
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        duct_stroke *stroke = duct_drawing_edit_stroke(drawing, i);
        duct_stroke_style style = duct_stroke_get_style(stroke);
        style.red = (float)CLAMP(chosen->r, 0, 1);
        style.green = (float)CLAMP(chosen->g, 0, 1);
        style.blue = (float)CLAMP(chosen->b, 0, 1);
        duct_stroke_set_style(stroke, style);
    }
}

duct_status plug_lines_open(const struct job *job, plug_hold hold, void *user, struct lines *lines,
                            duct_error *error)
{
    memset(lines, 0, sizeof *lines);
    duct_status status = duct_drawing_new(NULL, &lines->drawing, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_drawing_set_page(lines->drawing, gimp_image_width(job->image), gimp_image_height(job->image));
    gimp_context_get_foreground(&lines->colour);
    lines->coloured = true;
    if (plug_option_is(job->options, OPTION_LINES, LINES_PATH)) {
        status = read_path(job, lines->drawing, error);
    } else if (plug_option_is(job->options, OPTION_LINES, LINES_VISIBLE)) {
        status = read_visible(job, lines->drawing, error);
    } else if (plug_option_is(job->options, OPTION_LINES, LINES_SELECTION)) {
        status = plug_outline_read(job->image, lines->drawing, error);
    } else {
        lines->coloured = plug_option_is(job->options, OPTION_COLOUR, "foreground");
        status = plug_line_art_open(job, hold, user, &lines->art, error);
    }
    if (status != DUCT_OK) {
        plug_lines_close(lines);
    }
    return status;
}

duct_status plug_lines_find(struct lines *lines, const duct_context *context, duct_error *error)
{
    duct_status status = DUCT_OK;
    if (lines->art != NULL && duct_drawing_stroke_count(lines->drawing) == 0) {
        status = plug_line_art_trace(lines->art, context, lines->drawing, error);
    }
    if (status == DUCT_OK && lines->coloured) {
        colour(lines->drawing, &lines->colour);
    }
    return status;
}

void plug_lines_close(struct lines *lines)
{
    duct_drawing_free(lines->drawing);
    plug_line_art_close(lines->art);
    lines->drawing = NULL;
    lines->art = NULL;
}
