/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMAT_H
#define DUCTUS_FORMAT_H

#include <ductus/drawing.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Files that hold drawings and recordings. Which formats there are is data, see duct_format_at(). */

typedef struct duct_format {
    const char *id;         /* "svg", "inkml", "cyn", "csv" */
    const char *label;      /* "Scalable Vector Graphics" */
    const char *extensions; /* file name endings without dot, separated by spaces */
    bool reads, writes;
} duct_format;

/* How a line is written into a vector format that has no pressure of its own (SVG). */
typedef enum duct_line_style {
    DUCT_LINE_OUTLINE, /* strokes with a pressure channel as filled outlines of a nib that follows the pose */
    DUCT_LINE_PATH     /* always as plain paths: trajectory only */
} duct_line_style;

typedef struct duct_format_options {
    double flatten_tolerance; /* reading: largest distance of a flattened curve from the true one, pixels */
    double fit_tolerance; /* writing: largest distance of a fitted Bezier curve from the samples, pixels */
    duct_line_style line_style; /* writing */
} duct_format_options;

/* flatten_tolerance 0.05, fit_tolerance 0.1, DUCT_LINE_OUTLINE. */
DUCT_API duct_format_options duct_format_options_default(void);

/* The formats, in a fixed order; NULL when `index` is past the last one. Static storage. */
DUCT_API const duct_format *duct_format_at(size_t index);

/* Reads a drawing from a file ("-": standard input is the command line's business, not the library's).
 * The format is told by the content, then by the file's ending. `options` may be NULL. The caller frees the
 * drawing. Errors: DUCT_IO, DUCT_BAD_FORMAT, DUCT_LIMIT, DUCT_NO_MEMORY; the sentence begins with the file's
 * name and says where in it. */
DUCT_API duct_status duct_drawing_read(const duct_context *context, const char *path,
                                       const duct_format_options *options, duct_drawing **drawing,
                                       duct_error *error);

/* The same from memory. `name` stands for the file's name in sentences; `format` may be NULL to tell by
 * content and by the ending of `name`. */
DUCT_API duct_status duct_drawing_read_memory(const duct_context *context, const void *data, size_t size,
                                              const char *name, const char *format,
                                              const duct_format_options *options, duct_drawing **drawing,
                                              duct_error *error);

/* Writes a drawing; the file's ending picks the format. The file appears whole or not at all: it is written
 * beside its place and renamed. Errors: DUCT_UNSUPPORTED (no such format), DUCT_BAD_ARGUMENT (values that are
 * not finite), DUCT_IO, DUCT_NO_MEMORY. */
DUCT_API duct_status duct_drawing_write(const duct_context *context, const duct_drawing *drawing,
                                        const char *path, const duct_format_options *options,
                                        duct_error *error);

/* The same into memory: `*data` is terminated by a 0 byte that `*size` does not count; the caller frees it
 * with duct_memory_free(). */
DUCT_API duct_status duct_drawing_write_memory(const duct_context *context, const duct_drawing *drawing,
                                               const char *format, const duct_format_options *options,
                                               char **data, size_t *size, duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
