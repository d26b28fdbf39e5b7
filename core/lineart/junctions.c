/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What thinning makes of thick lines, and how a pen went: hairs that are no longer than the line is wide are
 * dropped; two junctions closer than the line's width, or with a
 * thicker line between them, are one crossing; at a junction a stroke goes on where
 * it turns least. */
#include "lineart/lineart_private.h"

#include "base/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double sharpest = 60 * 3.14159265358979323846 / 180; /* turn that a stroke takes at a junction */
static const double sharp = 40 * 3.14159265358979323846 / 180;    /* turn that is a corner */

static void count_degrees(duct_graph *graph)
{
    for (size_t i = 0; i < graph->node_count; i++) {
        graph->nodes[i].degree = 0;
    }
    for (size_t i = 0; i < graph->edge_count; i++) {
        const duct_edge *edge = &graph->edges[i];
        for (int side = 0; side < 2 && !edge->gone && edge->node[side] != DUCT_NO_NODE; side++) {
            graph->nodes[duct_graph_node(graph, (size_t)edge->node[side])].degree++;
        }
    }
}

static duct_node *node_at(duct_graph *graph, const duct_edge *edge, int side)
{
    return &graph->nodes[duct_graph_node(graph, (size_t)edge->node[side])];
}

static bool is_hair(duct_graph *graph, const duct_edge *edge)
{
    if (edge->gone || edge->node[0] == DUCT_NO_NODE) {
        return false;
    }
    const duct_node *a = node_at(graph, edge, 0), *b = node_at(graph, edge, 1);
    if (a == b) {
        return edge->length <= 2 * a->radius + 2; /* a loop inside the line */
    }
    const duct_node *junction = a->degree >= 3 ? a : b;
    const duct_node *end = a->degree >= 3 ? b : a;
    return junction->degree >= 3 && end->degree == 1 && edge->length <= 1.2 * junction->radius + 1;
}

static void drop_hairs(duct_graph *graph)
{
    count_degrees(graph);
    for (size_t i = 0; i < graph->edge_count; i++) {
        graph->edges[i].gone = graph->edges[i].gone || is_hair(graph, &graph->edges[i]);
    }
}

static void merge_nodes(duct_node *nodes, size_t from, size_t to, double length)
{
    duct_node *kept = &nodes[to], *other = &nodes[from];
    double total = (double)(kept->weight + other->weight);
    kept->x = (kept->x * (double)kept->weight + other->x * (double)other->weight) / total;
    kept->y = (kept->y * (double)kept->weight + other->y * (double)other->weight) / total;
    kept->reach = fmax(fmax(kept->reach, other->reach), length / 2 + fmin(kept->radius, other->radius));
    kept->radius = fmax(kept->radius, other->radius);
    kept->weight += other->weight;
    kept->branches += other->branches;
    other->merged = to;
}

static void find_slimmest(duct_graph *graph)
{
    for (size_t i = 0; i < graph->node_count; i++) {
        graph->nodes[i].slimmest = INFINITY;
    }
    for (size_t i = 0; i < graph->edge_count; i++) {
        const duct_edge *edge = &graph->edges[i];
        for (int side = 0; side < 2 && !edge->gone && edge->node[side] != DUCT_NO_NODE; side++) {
            duct_node *node = node_at(graph, edge, side);
            node->slimmest = fmin(node->slimmest, edge->radius);
        }
    }
}

/* Whether an edge lies inside a crossing: it is no longer than the lines are wide; or, where they cross at a
 * sharp angle and so run together for a while, it is thicker than those that lead to it. */
static bool is_crossing(const duct_edge *edge, const duct_node *one, const duct_node *other)
{
    double slimmest = fmax(one->slimmest, other->slimmest);
    return edge->length <= 2.2 * fmin(one->radius, other->radius) + 3 ||
           (edge->radius > 1.15 * slimmest && edge->length <= 6 * slimmest);
}

/* Makes one of the two junctions of each crossing. */
static void join_crossings(duct_graph *graph)
{
    count_degrees(graph);
    find_slimmest(graph);
    for (size_t i = 0; i < graph->edge_count; i++) {
        duct_edge *edge = &graph->edges[i];
        if (edge->gone || edge->node[0] == DUCT_NO_NODE) {
            continue;
        }
        size_t a = duct_graph_node(graph, (size_t)edge->node[0]);
        size_t b = duct_graph_node(graph, (size_t)edge->node[1]);
        const duct_node *one = &graph->nodes[a], *other = &graph->nodes[b];
        if (a != b && one->degree >= 3 && other->degree >= 3 && is_crossing(edge, one, other)) {
            int degree = one->degree + other->degree - 2;
            edge->gone = true;
            merge_nodes(graph->nodes, a < b ? b : a, a < b ? a : b, edge->length);
            graph->nodes[a < b ? a : b].degree = degree;
        }
    }
}

/* The pixel at a distance from the edge's end along it, as a place. */
static void place_along(const duct_graph *graph, const duct_edge *edge, int side, double way, double *x,
                        double *y)
{
    size_t steps = (size_t)way;
    steps = steps < edge->count ? steps : edge->count - 1;
    const duct_pixel *pixel = &graph->pixels[edge->first + (side == 0 ? steps : edge->count - 1 - steps)];
    *x = pixel->x + 0.5;
    *y = pixel->y + 0.5;
}

/* The direction in which an edge leaves a node, from beyond the node's own blot. */
static double leaving(duct_graph *graph, const duct_edge *edge, int side)
{
    const duct_node *node = node_at(graph, edge, side), *other = node_at(graph, edge, 1 - side);
    if (edge->count < 2) {
        return atan2(other->y - node->y, other->x - node->x);
    }
    double near_x, near_y, far_x, far_y;
    double near = edge->count > 3 * node->reach + 4 ? node->reach : 0;
    place_along(graph, edge, side, near, &near_x, &near_y);
    place_along(graph, edge, side, near + 2 * node->radius + 4, &far_x, &far_y);
    if (far_x == near_x && far_y == near_y) {
        return atan2(near_y - node->y, near_x - node->x);
    }
    return atan2(far_y - near_y, far_x - near_x);
}

/* An end of an edge at a node. */
struct end {
    size_t node;
    size_t index; /* 2 * edge + side */
    double angle;
};

struct pair {
    double turn;
    size_t a, b;
};

static int compare_ends(const void *a, const void *b)
{
    const struct end *one = a, *other = b;
    if (one->node != other->node) {
        return one->node < other->node ? -1 : 1;
    }
    return one->index < other->index ? -1 : one->index > other->index;
}

static int compare_pairs(const void *a, const void *b)
{
    const struct pair *one = a, *other = b;
    if (one->turn < other->turn || one->turn > other->turn) {
        return one->turn < other->turn ? -1 : 1;
    }
    if (one->a != other->a) {
        return one->a < other->a ? -1 : 1;
    }
    return one->b < other->b ? -1 : one->b > other->b;
}

/* How far from straight on it is from one end to the other, 0..pi. */
static double turn(double from, double to)
{
    const double pi = 3.14159265358979323846;
    double angle = fabs(remainder(from - to, 2 * pi));
    return pi - angle;
}

static void connect(duct_graph *graph, size_t a, size_t b, bool corner)
{
    graph->edges[a / 2].corner[a % 2] = graph->edges[b / 2].corner[b % 2] = corner;
    graph->edges[a / 2].next[a % 2] = (ptrdiff_t)b;
    graph->edges[b / 2].next[b % 2] = (ptrdiff_t)a;
}

enum { MOST_ENDS = 64 /* at one node; blots with more are left as they are */ };

/* Pairs the ends at one node, the straightest first. */
static void pair_ends(duct_graph *graph, const struct end *ends, size_t count)
{
    struct pair pairs[MOST_ENDS * MOST_ENDS / 2];
    size_t pair_count = 0;
    if (count < 2 || count > MOST_ENDS) {
        return;
    }
    for (size_t a = 0; a < count; a++) {
        for (size_t b = a + 1; b < count; b++) {
            pairs[pair_count++] = (struct pair){turn(ends[a].angle, ends[b].angle), a, b};
        }
    }
    qsort(pairs, pair_count, sizeof *pairs, compare_pairs);
    bool taken[MOST_ENDS] = {false};
    for (size_t i = 0; i < pair_count; i++) {
        /* Where only two meet, it is a corner of one line. */
        if (taken[pairs[i].a] || taken[pairs[i].b] || (count > 2 && pairs[i].turn > sharpest)) {
            continue;
        }
        taken[pairs[i].a] = taken[pairs[i].b] = true;
        connect(graph, ends[pairs[i].a].index, ends[pairs[i].b].index, pairs[i].turn > sharp);
    }
}

static duct_status pair_all(duct_graph *graph, duct_error *error)
{
    struct end *ends = duct_alloc(graph->allocator, 2 * graph->edge_count + 1, sizeof *ends);
    if (ends == NULL) {
        return duct_fail_memory(error);
    }
    size_t count = 0;
    for (size_t i = 0; i < graph->edge_count; i++) {
        const duct_edge *edge = &graph->edges[i];
        for (int side = 0; side < 2 && !edge->gone && edge->node[side] != DUCT_NO_NODE; side++) {
            size_t node = duct_graph_node(graph, (size_t)edge->node[side]);
            ends[count++] = (struct end){node, 2 * i + (size_t)side, leaving(graph, edge, side)};
        }
    }
    qsort(ends, count, sizeof *ends, compare_ends);
    for (size_t first = 0, next; first < count; first = next) {
        for (next = first + 1; next < count && ends[next].node == ends[first].node; next++) {
        }
        pair_ends(graph, ends + first, next - first);
    }
    duct_release(graph->allocator, ends);
    return DUCT_OK;
}

duct_status duct_graph_join(duct_graph *graph, duct_error *error)
{
    count_degrees(graph);
    for (size_t i = 0; i < graph->node_count; i++) {
        graph->nodes[i].branches = graph->nodes[i].degree;
    }
    drop_hairs(graph);
    join_crossings(graph);
    drop_hairs(graph);
    count_degrees(graph);
    return pair_all(graph, error);
}
