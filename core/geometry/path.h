/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_PATH_H
#define DUCTUS_GEOMETRY_PATH_H

#include "base/text.h"

#include <ductus/path.h>

#include <stdbool.h>
#include <stddef.h>

/* What <ductus/path.h> hides. A failed allocation sets `failed` and makes all further calls do nothing. Each
 * subpath begins with a move. */
struct duct_path {
    const duct_allocator *allocator;
    unsigned char *verbs;
    size_t verb_count, verb_capacity;
    double *points; /* x, y, x, y, ... */
    size_t point_count, point_capacity;
    double start[2]; /* of the last subpath */
    bool failed;
};

/* A path on the stack, and the end of it. */
void duct_path_init(duct_path *path, const duct_allocator *allocator);
void duct_path_done(duct_path *path);

/* Adds the path as duct_path_svg() gives it. */
void duct_path_text(const duct_path *path, int decimals, duct_text *text);

#endif
