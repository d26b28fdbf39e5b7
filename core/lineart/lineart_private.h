/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LINEART_PRIVATE_H
#define DUCTUS_LINEART_PRIVATE_H

#include "lineart/bitmap.h"

#include <ductus/lineart.h>

/* Sets the bits of the pixels that are ink; `*found` tells whether ink and paper differ at all. The bitmap is
 * initialised. Progress from `begin` to `end`. */
duct_status duct_ink_find(const duct_context *context, const duct_lineart_options *options,
                          duct_picture_rows rows, void *user, duct_bitmap *ink, bool *found,
                          duct_error *error);

/* Thins what is set to lines of one pixel, and takes away what is wider than `widest`. */
duct_status duct_thin(const duct_context *context, duct_bitmap *bitmap, double widest, duct_error *error);

typedef struct duct_pixel {
    int32_t x, y;
} duct_pixel;

/* A place where lines end or meet. */
typedef struct duct_node {
    double x, y;
    double radius;   /* half the width of the line there */
    double reach;    /* how far from it thinning bends lines */
    double slimmest; /* of the radii of the lines that meet there */
    size_t merged;   /* into this node; itself where it is not */
    size_t weight;   /* how many it stands for */
    int degree;      /* ends of edges here */
    int branches;    /* the same before hairs were dropped */
} duct_node;

enum { DUCT_NO_NODE = -1 };

/* A line between two nodes, or a closed one without. */
typedef struct duct_edge {
    ptrdiff_t node[2];   /* DUCT_NO_NODE for both: closed */
    size_t first, count; /* its pixels in the graph's `pixels`, without those of the nodes */
    double length;       /* with the ways to the nodes */
    double radius;       /* the median along it */
    bool gone;
    ptrdiff_t next[2]; /* what goes on behind each end: an end (2 * edge + side), or -1 */
    bool corner[2];    /* the line turns sharply there */
} duct_edge;

typedef struct duct_graph {
    const duct_allocator *allocator;
    duct_pixel *pixels;
    size_t pixel_count, pixel_capacity;
    duct_node *nodes;
    size_t node_count, node_capacity;
    duct_edge *edges;
    size_t edge_count, edge_capacity;
    bool failed; /* no memory */
} duct_graph;

void duct_graph_init(duct_graph *graph, const duct_allocator *allocator);
void duct_graph_done(duct_graph *graph);

/* The lines of a thinned picture; `ink` is what it was thinned from. */
duct_status duct_graph_trace(const duct_context *context, const duct_bitmap *thin, const duct_bitmap *ink,
                             duct_graph *graph, duct_error *error);

/* The node that stands for a node by now. */
size_t duct_graph_node(duct_graph *graph, size_t node);

/* Takes away what thinning made up (hairs, and the two junctions of one crossing), and decides how strokes go
 * on at junctions. */
duct_status duct_graph_join(duct_graph *graph, duct_error *error);

/* Appends the graph's strokes to the drawing. */
duct_status duct_graph_strokes(duct_graph *graph, const duct_lineart_options *options, duct_drawing *drawing,
                               duct_error *error);

#endif
