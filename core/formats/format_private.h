/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMAT_PRIVATE_H
#define DUCTUS_FORMAT_PRIVATE_H

#include "base/text.h"

#include <ductus/format.h>

/* One file format: a constant of this type in a file of its own, listed in formats.c and nowhere else. */
typedef struct duct_format_impl {
    duct_format info;

    /* True where the content surely is of this format. `data` is terminated by a 0 byte. */
    bool (*sniff)(const char *data, size_t size);

    /* Fills an empty drawing from the file's content (terminated by a 0 byte). Sentences say where in the
     * file
     * ("line 12: stroke 3: ..."), not in which file: the caller puts the name before them. On failure the
     * drawing may be half full: the caller frees it. NULL where the format is not read. */
    duct_status (*read)(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error);

    /* Adds the drawing's file content to `out`. NULL where the format is not written. */
    duct_status (*write)(const duct_context *context, const duct_drawing *drawing,
                         const duct_format_options *options, duct_text *out, duct_error *error);
} duct_format_impl;

extern const duct_format_impl duct_format_svg;
extern const duct_format_impl duct_format_inkml;
extern const duct_format_impl duct_format_cyn;
extern const duct_format_impl duct_format_csv;
extern const duct_format_impl duct_format_svc;
extern const duct_format_impl duct_format_mypaint_events;
extern const duct_format_impl duct_format_xopp;
extern const duct_format_impl duct_format_pointer_events;

#endif
