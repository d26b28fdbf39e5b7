/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_GEOMETRY_PATH_H
#define DUCTUS_GEOMETRY_PATH_H

#include "base/text.h"

#include <stdbool.h>
#include <stddef.h>

/* A vector path: subpaths of straight lines and cubic Bezier curves. A failed allocation sets `failed` and
 * makes all further calls do nothing, so that a maker checks once at its end. */
typedef enum duct_path_verb {
    DUCT_PATH_MOVE,  /* 1 point */
    DUCT_PATH_LINE,  /* 1 point */
    DUCT_PATH_CUBIC, /* 3 points: two controls and the end */
    DUCT_PATH_CLOSE  /* no point */
} duct_path_verb;

typedef struct duct_path {
    const duct_allocator *allocator;
    unsigned char *verbs;
    size_t verb_count, verb_capacity;
    double *points; /* x, y, x, y, ... */
    size_t point_count, point_capacity;
    bool failed;
} duct_path;

void duct_path_init(duct_path *path, const duct_allocator *allocator);
void duct_path_done(duct_path *path);
void duct_path_move(duct_path *path, double x, double y);
void duct_path_line(duct_path *path, double x, double y);
void duct_path_cubic(duct_path *path, double x1, double y1, double x2, double y2, double x, double y);
void duct_path_close(duct_path *path);

/* Adds the path as the value of an SVG `d` attribute: absolute commands, `decimals` digits behind the point.
 */
void duct_path_svg(const duct_path *path, int decimals, duct_text *text);

/* How many nodes an editor shows: moves, line ends and curve ends. */
size_t duct_path_nodes(const duct_path *path);

#endif
