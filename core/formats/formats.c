/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of file formats, and what all of them share: telling them apart, names in sentences, whole files.
 */
#include "base/error.h"
#include "base/file.h"
#include "drawing/drawing_private.h"
#include "formats/format_private.h"

#include <math.h>
#include <string.h>
#include <strings.h>

/* Sniffed in this order. */
static const duct_format_impl *const formats[] = {
    &duct_format_xopp, /* before SVG, which takes all else that is compressed, to say what to do */
    &duct_format_svg,
    &duct_format_inkml,
    &duct_format_cyn,
    &duct_format_csv,
    &duct_format_svc,
    &duct_format_mypaint_events,
    &duct_format_pointer_events,
};

enum { FORMAT_COUNT = sizeof formats / sizeof formats[0] };

duct_format_options duct_format_options_default(void)
{
    return (duct_format_options){0.05, 0.1, DUCT_LINE_OUTLINE};
}

const duct_format *duct_format_at(size_t index)
{
    return index < FORMAT_COUNT ? &formats[index]->info : NULL;
}

static const duct_format_impl *format_by_id(const char *id)
{
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        if (strcmp(formats[i]->info.id, id) == 0) {
            return formats[i];
        }
    }
    return NULL;
}

static bool has_ending(const duct_format *format, const char *ending)
{
    size_t length = strlen(ending);
    const char *word = format->extensions;
    while (length > 0 && *word != '\0') {
        size_t size = strcspn(word, " ");
        if (size == length && strncasecmp(word, ending, size) == 0) {
            return true;
        }
        word += size;
        word += strspn(word, " ");
    }
    return false;
}

static const duct_format_impl *format_by_ending(const char *path)
{
    const char *ending = duct_path_ending(path);
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        if (has_ending(&formats[i]->info, ending)) {
            return formats[i];
        }
    }
    return NULL;
}

static const duct_format_impl *format_by_content(const char *data, size_t size)
{
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        if (formats[i]->sniff(data, size)) {
            return formats[i];
        }
    }
    return NULL;
}

/* "svg, inkml, cyn, csv": those that are read, or those that are written. */
static const char *list_formats(char *list, size_t size, bool written)
{
    size_t length = 0;
    list[0] = '\0';
    for (size_t i = 0; i < FORMAT_COUNT; i++) {
        const duct_format *format = &formats[i]->info;
        size_t more = strlen(format->id) + 2;
        if ((written ? format->writes : format->reads) && length + more < size) {
            memcpy(list + length, length > 0 ? ", " : "", length > 0 ? 2 : 0);
            length += length > 0 ? 2 : 0;
            memcpy(list + length, format->id, strlen(format->id) + 1);
            length += strlen(format->id);
        }
    }
    return list;
}

static duct_status tell_format(const char *data, size_t size, const char *name, const char *id,
                               const duct_format_impl **format, duct_error *error)
{
    char list[128];
    const duct_format_impl *found;
    if (id != NULL) {
        found = format_by_id(id);
        if (found == NULL || found->read == NULL) {
            return duct_fail(error, DUCT_UNSUPPORTED, "there is no format \"%s\" to read; there are %s", id,
                             list_formats(list, sizeof list, false));
        }
    } else {
        if (size == 0) {
            return duct_fail(error, DUCT_BAD_FORMAT, "is empty");
        }
        found = format_by_content(data, size);
        if (found == NULL) {
            found = format_by_ending(name);
        }
        if (found == NULL || found->read == NULL) {
            return duct_fail(error, DUCT_BAD_FORMAT,
                             "is in none of the formats that can be read, which are %s",
                             list_formats(list, sizeof list, false));
        }
    }
    *format = found;
    return DUCT_OK;
}

/* Files hold finite numbers only. */
static duct_status check_finite(const duct_drawing *drawing, duct_error *error)
{
    if (!isfinite(duct_drawing_width(drawing)) || !isfinite(duct_drawing_height(drawing)) ||
        !isfinite(duct_drawing_resolution(drawing)) || !(duct_drawing_resolution(drawing) > 0)) {
        return duct_fail(error, DUCT_BAD_ARGUMENT,
                         "the page's size is not finite, or its resolution is not above 0");
    }
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        duct_stroke_style style = duct_stroke_get_style(stroke);
        if (!isfinite(style.red) || !isfinite(style.green) || !isfinite(style.blue) ||
            !isfinite(style.opacity) || !isfinite(style.width)) {
            return duct_fail(error, DUCT_BAD_ARGUMENT, "the style of stroke %zu is not finite", i);
        }
        for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
            const double *values = duct_stroke_values(stroke, (duct_channel)c);
            for (size_t k = 0; values != NULL && k < duct_stroke_size(stroke); k++) {
                if (!isfinite(values[k])) {
                    return duct_fail(error, DUCT_BAD_ARGUMENT, "%s of sample %zu of stroke %zu is not finite",
                                     duct_channel_name((duct_channel)c), k, i);
                }
            }
        }
    }
    return DUCT_OK;
}

/* `data` is terminated by a 0 byte. The sentence gets no name yet. */
static duct_status read_terminated(const duct_context *context, const char *data, size_t size,
                                   const char *name, const char *id, const duct_format_options *options,
                                   duct_drawing **drawing, duct_error *error)
{
    const duct_format_impl *format = NULL;
    duct_status status = tell_format(data, size, name, id, &format, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_drawing *made = NULL;
    status = duct_drawing_new(context, &made, error);
    if (status != DUCT_OK) {
        return status;
    }
    const duct_format_options usual = duct_format_options_default();
    status = format->read(context, data, size, options != NULL ? options : &usual, made, error);
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    for (size_t i = 0; i < duct_drawing_stroke_count(made); i++) {
        duct_stroke_set_changed(duct_drawing_edit_stroke(made, i), false);
    }
    *drawing = made;
    return DUCT_OK;
}

duct_status duct_drawing_read(const duct_context *context, const char *path,
                              const duct_format_options *options, duct_drawing **drawing, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    char *data = NULL;
    size_t size = 0;
    duct_status status = duct_file_read(allocator, path, DUCT_MAX_FILE_BYTES, &data, &size, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = read_terminated(context, data, size, path, NULL, options, drawing, error);
    duct_release(allocator, data);
    if (status != DUCT_OK) {
        duct_error_prefix(error, path);
    }
    return status;
}

duct_status duct_drawing_read_memory(const duct_context *context, const void *data, size_t size,
                                     const char *name, const char *format, const duct_format_options *options,
                                     duct_drawing **drawing, duct_error *error)
{
    const char *shown = name != NULL ? name : "the drawing";
    if (size > DUCT_MAX_FILE_BYTES) {
        return duct_fail(error, DUCT_LIMIT, "%s: is larger than the limit of %d MiB", shown,
                         DUCT_MAX_FILE_BYTES >> 20);
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    char *copy = duct_realloc(allocator, NULL, size + 1, 1);
    if (copy == NULL) {
        return duct_fail_memory(error);
    }
    if (size > 0) {
        memcpy(copy, data, size);
    }
    copy[size] = '\0';
    duct_status status = read_terminated(context, copy, size, shown, format, options, drawing, error);
    duct_release(allocator, copy);
    if (status != DUCT_OK) {
        duct_error_prefix(error, shown);
    }
    return status;
}

static duct_status write_text(const duct_context *context, const duct_drawing *drawing,
                              const duct_format_impl *format, const duct_format_options *options, char **data,
                              size_t *size, duct_error *error)
{
    const duct_format_options usual = duct_format_options_default();
    duct_text text;
    duct_text_init(&text, duct_allocator_of(context));
    duct_status status = check_finite(drawing, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = format->write(context, drawing, options != NULL ? options : &usual, &text, error);
    if (status != DUCT_OK) {
        duct_text_free(&text);
        return status;
    }
    size_t length = 0;
    char *made = duct_text_take(&text, &length);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    *data = made;
    *size = length;
    return DUCT_OK;
}

duct_status duct_drawing_write(const duct_context *context, const duct_drawing *drawing, const char *path,
                               const duct_format_options *options, duct_error *error)
{
    const duct_format_impl *format = format_by_ending(path);
    if (format == NULL || format->write == NULL) {
        char list[128];
        return duct_fail(error, DUCT_UNSUPPORTED, "%s: no format has this ending; drawings are written as %s",
                         path, list_formats(list, sizeof list, true));
    }
    char *data = NULL;
    size_t size = 0;
    duct_status status = write_text(context, drawing, format, options, &data, &size, error);
    if (status != DUCT_OK) {
        duct_error_prefix(error, path);
        return status;
    }
    const duct_allocator *allocator = duct_allocator_of(context);
    status = duct_file_write(allocator, path, data, size, error);
    duct_release(allocator, data);
    return status;
}

duct_status duct_drawing_write_memory(const duct_context *context, const duct_drawing *drawing,
                                      const char *format, const duct_format_options *options, char **data,
                                      size_t *size, duct_error *error)
{
    const duct_format_impl *found = format != NULL ? format_by_id(format) : NULL;
    if (found == NULL || found->write == NULL) {
        char list[128];
        return duct_fail(error, DUCT_UNSUPPORTED, "there is no format \"%s\" to write; there are %s",
                         format != NULL ? format : "", list_formats(list, sizeof list, true));
    }
    return write_text(context, drawing, found, options, data, size, error);
}
