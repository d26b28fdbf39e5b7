/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "output.h"

#include "colour.h"
#include "message.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

static const char USUAL_BRUSH[] = "bristle";

const cli_option cli_output_options[] = {
    {.name = "output",
     .letter = 'o',
     .kind = CLI_TEXT,
     .value = "OUT",
     .group = "Writing",
     .help =
         "Where to write; the ending picks the format. A folder keeps the inputs' names and is made where it "
         "is not there; - is standard output."},
    {.name = "to",
     .kind = CLI_TEXT,
     .value = "FORMAT",
     .group = "Writing",
     .completes = CLI_COMPLETES_WRITABLE,
     .help = "The format for standard output or for all files of a folder (svg, inkml, png, ...)."},
    {.name = "line",
     .kind = CLI_CHOICE,
     .choices = "outline path",
     .value = "STYLE",
     .group = "Writing",
     .help = "How formats without pressure hold a stroke that has it: 'outline', the filled outline of a nib "
             "that "
             "follows the pose; 'path', the trajectory as a plain path.",
     .fallback = "outline"},
    {.name = "fit-tolerance",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 0.0001,
     .maximum = 100,
     .group = "Writing",
     .help = "Largest distance, in pixels, of a fitted curve from the samples.",
     .fallback = "0.1"},
    {.name = "brush",
     .kind = CLI_TEXT,
     .value = "NAME",
     .group = "Images",
     .completes = CLI_COMPLETES_BRUSHES,
     .help =
         "The brush that paints an image: one that 'ductus brushes' lists, or a MyPaint brush file (.myb).",
     .fallback = USUAL_BRUSH},
    {.name = "size",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 0,
     .maximum = 10000,
     .group = "Images",
     .help = "The brush's diameter in drawing pixels; 0: each stroke's own width.",
     .fallback = "0"},
    {.name = "dpi",
     .kind = CLI_REAL,
     .value = "X",
     .minimum = 1,
     .maximum = 9600,
     .group = "Images",
     .help =
         "Image pixels an inch. Without it: the drawing's own, which is 96 unless its file says otherwise."},
    {.name = "background",
     .kind = CLI_TEXT,
     .value = "COLOUR",
     .group = "Images",
     .completes = CLI_COMPLETES_NOTHING,
     .help = "What lies under the strokes: #rgb, #rrggbb, #rrggbbaa, a colour's name, or none.",
     .fallback = "white"},
    {.name = "bits",
     .kind = CLI_CHOICE,
     .choices = "8 16 32",
     .value = "N",
     .group = "Images",
     .help = "Bits a channel: 8 or 16 for PNG and TIFF, 16 or 32 for EXR. Without it: the format's usual."},
};
const size_t cli_output_option_count = sizeof cli_output_options / sizeof *cli_output_options;

int cli_output_begin(cli_output *output, const cli_session *session, const cli_arguments *arguments,
                     const char *command)
{
    *output = (cli_output){
        .session = session, .vector = duct_format_options_default(), .render = duct_render_options_default()};
    const char *line = cli_text(arguments, "line");
    output->vector.line_style =
        line != NULL && strcmp(line, "path") == 0 ? DUCT_LINE_PATH : DUCT_LINE_OUTLINE;
    output->vector.fit_tolerance = cli_number(arguments, "fit-tolerance", output->vector.fit_tolerance);
    output->brush_name = cli_text(arguments, "brush");
    output->render.paint.brush_size = cli_number(arguments, "size", output->render.paint.brush_size);
    output->render.paint.seed = (uint64_t)cli_number(arguments, "seed", 0);
    output->render.resolution = cli_number(arguments, "dpi", 0);
    output->image.bits = (int)cli_number(arguments, "bits", 0);
    const char *background = cli_text(arguments, "background");
    if (background != NULL && !cli_colour_parse(background, output->render.background)) {
        return cli_misused(
            "%s: --background: '%s' is no colour; write #rrggbb, #rrggbbaa, a name such as white, "
            "or none",
            command, background);
    }
    memcpy(output->image.background, output->render.background, sizeof output->image.background);
    return CLI_DONE;
}

void cli_output_end(cli_output *output)
{
    duct_brush_free(output->brush);
    output->brush = NULL;
}

static const char *ending_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const char *name = slash != NULL ? slash + 1 : path;
    const char *dot = strrchr(name, '.');
    return dot != NULL && dot != name ? dot + 1 : "";
}

static bool has_ending(const duct_format *format, const char *ending)
{
    size_t length = strlen(ending);
    for (const char *at = format->extensions; *at != '\0';) {
        size_t size = strcspn(at, " ");
        if (size == length && strncasecmp(at, ending, size) == 0) {
            return true;
        }
        at += size;
        at += strspn(at, " ");
    }
    return false;
}

const char *cli_output_format(const char *path, bool *image)
{
    const char *ending = ending_of(path);
    const duct_format *format;
    *image = false;
    if (*ending == '\0') {
        return NULL;
    }
    for (size_t i = 0; (format = duct_format_at(i)) != NULL; i++) {
        if (format->writes && has_ending(format, ending)) {
            return format->id;
        }
    }
    *image = duct_image_writable(path);
    return *image ? ending : NULL;
}

void cli_output_formats(char *text, size_t size)
{
    static const char *const IMAGES[] = {"x.png", "x.tif", "x.exr"};
    const duct_format *format;
    size_t used = 0;
    text[0] = '\0';
    for (size_t i = 0; (format = duct_format_at(i)) != NULL; i++) {
        if (format->writes && used < size) {
            used += (size_t)snprintf(text + used, size - used, "%s%s", used > 0 ? ", " : "", format->id);
        }
    }
    for (size_t i = 0; i < sizeof IMAGES / sizeof *IMAGES; i++) {
        if (duct_image_writable(IMAGES[i]) && used < size) {
            used += (size_t)snprintf(text + used, size - used, ", %s", IMAGES[i] + 2);
        }
    }
}

int cli_output_load_brush(cli_output *output)
{
    if (output->brush != NULL) {
        return CLI_DONE;
    }
    const char *name = output->brush_name != NULL ? output->brush_name : USUAL_BRUSH;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_brush_load(&output->session->context, name, &output->brush, &error);
    return status == DUCT_OK ? CLI_DONE : cli_fail_error(NULL, status, &error);
}

static int write_stdout(const char *bytes, size_t size)
{
    if ((size > 0 && fwrite(bytes, 1, size, stdout) != size) || fflush(stdout) != 0) {
        return cli_fail("standard output: cannot be written: %s", strerror(errno));
    }
    return CLI_DONE;
}

static int write_vector(cli_output *output, const duct_drawing *drawing, const char *path, const char *format)
{
    const duct_context *context = &output->session->context;
    duct_error error = {DUCT_OK, ""};
    cli_progress_phase("writing");
    if (strcmp(path, "-") != 0) {
        duct_status status = duct_drawing_write(context, drawing, path, &output->vector, &error);
        return status == DUCT_OK ? CLI_DONE : cli_fail_error(path, status, &error);
    }
    char *bytes = NULL;
    size_t size = 0;
    duct_status status =
        duct_drawing_write_memory(context, drawing, format, &output->vector, &bytes, &size, &error);
    if (status != DUCT_OK) {
        return cli_fail_error("standard output", status, &error);
    }
    int result = cli_stopped();
    result = result != 0 ? result : write_stdout(bytes, size);
    duct_memory_free(context, bytes);
    return result;
}

static int copy_to_stdout(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file == NULL) {
        return cli_fail("%s: cannot be read: %s", path, strerror(errno));
    }
    char block[65536];
    int result = CLI_DONE;
    size_t got;
    while (result == CLI_DONE && (got = fread(block, 1, sizeof block, file)) > 0) {
        result = write_stdout(block, got);
    }
    fclose(file);
    return result;
}

static int write_canvas(cli_output *output, const duct_canvas *canvas, const char *path, const char *place)
{
    duct_error error = {DUCT_OK, ""};
    int stopped = cli_stopped();
    if (stopped != 0) {
        return stopped;
    }
    cli_progress_phase("writing");
    duct_status status = duct_image_write(&output->session->context, canvas, path, &output->image, &error);
    return status == DUCT_OK ? CLI_DONE : cli_fail_error(place, status, &error);
}

/* Image files need to be seekable, so standard output gets a copy of a temporary one. */
static int write_canvas_to_stdout(cli_output *output, const duct_canvas *canvas, const char *format)
{
    const char *temporary = getenv("TMPDIR");
    char folder[4096], path[4200];
    snprintf(folder, sizeof folder, "%s/ductus-XXXXXX",
             temporary != NULL && *temporary != '\0' ? temporary : "/tmp");
    if (mkdtemp(folder) == NULL) {
        return cli_fail("%s: cannot be made: %s", folder, strerror(errno));
    }
    snprintf(path, sizeof path, "%s/image.%s", folder, format);
    int result = write_canvas(output, canvas, path, "standard output");
    result = result != CLI_DONE ? result : copy_to_stdout(path);
    unlink(path);
    rmdir(folder);
    return result;
}

static void note_unpainted(const cli_output *output, const duct_drawing *drawing, const char *path)
{
    static const char *const names[] = {"fills", "text", "images"};
    int unpainted = duct_drawing_unpainted(drawing);
    char list[64] = "";
    for (int i = 0; i < 3; i++) {
        int bit = 1 << i, later = unpainted >> (i + 1);
        if (unpainted & bit) {
            size_t used = strlen(list);
            snprintf(list + used, sizeof list - used, "%s%s", names[i],
                     later == 0                   ? ""
                     : (later & (later - 1)) == 0 ? " and "
                                                  : ", ");
        }
    }
    if (*list != '\0') {
        cli_note(output->session, "%s: only lines are painted; the drawing's %s are not",
                 strcmp(path, "-") == 0 ? "standard output" : path, list);
    }
}

static int write_image(cli_output *output, const duct_drawing *drawing, const char *path, const char *format)
{
    int result = cli_output_load_brush(output);
    if (result != CLI_DONE) {
        return result;
    }
    duct_error error = {DUCT_OK, ""};
    duct_canvas *canvas = NULL;
    cli_progress_phase("painting");
    duct_status status =
        duct_render(&output->session->context, drawing, output->brush, &output->render, &canvas, &error);
    if (status != DUCT_OK) {
        return cli_fail_error(strcmp(path, "-") == 0 ? "standard output" : path, status, &error);
    }
    output->image.resolution =
        output->render.resolution > 0 ? output->render.resolution : duct_drawing_resolution(drawing);
    result = strcmp(path, "-") == 0 ? write_canvas_to_stdout(output, canvas, format)
                                    : write_canvas(output, canvas, path, path);
    duct_canvas_free(canvas);
    if (result == CLI_DONE) {
        note_unpainted(output, drawing, path);
    }
    return result;
}

int cli_output_write(cli_output *output, const duct_drawing *drawing, const char *path, const char *format)
{
    bool image = false;
    int stopped = cli_stopped();
    if (stopped != 0) {
        return stopped;
    }
    if (strcmp(path, "-") == 0) {
        char name[64];
        snprintf(name, sizeof name, "x.%.32s", format);
        cli_output_format(name, &image);
    } else {
        cli_output_format(path, &image);
    }
    return image ? write_image(output, drawing, path, format) : write_vector(output, drawing, path, format);
}
