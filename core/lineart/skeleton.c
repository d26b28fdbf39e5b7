/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a thinned picture to a graph. Two pixels are neighbours where they share a side, or a corner without a
 * pixel that shares a side with both; so a staircase is one line. Pixels with one neighbour are ends, those
 * with three or more are junctions; junctions that touch are one node. */
#include "lineart/lineart_private.h"

#include "base/error.h"
#include "base/pool.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Clockwise from the pixel above. */
static const int step_x[8] = {0, 1, 1, 1, 0, -1, -1, -1};
static const int step_y[8] = {-1, -1, 0, 1, 1, 1, 0, -1};

/* A pixel that is an end or a junction, and its node. In reading order, so that it can be looked up. */
struct mark {
    duct_pixel at;
    size_t node;
};

struct tracer {
    const duct_context *context;
    const duct_bitmap *thin, *ink;
    duct_bitmap seen; /* pixels of edges */
    struct mark *marks;
    size_t mark_count, mark_capacity;
    duct_graph *graph;
};

void duct_graph_init(duct_graph *graph, const duct_allocator *allocator)
{
    memset(graph, 0, sizeof *graph);
    graph->allocator = allocator;
}

void duct_graph_done(duct_graph *graph)
{
    duct_release(graph->allocator, graph->pixels);
    duct_release(graph->allocator, graph->nodes);
    duct_release(graph->allocator, graph->edges);
}

size_t duct_graph_node(duct_graph *graph, size_t node)
{
    while (graph->nodes[node].merged != node) {
        graph->nodes[node].merged = graph->nodes[graph->nodes[node].merged].merged;
        node = graph->nodes[node].merged;
    }
    return node;
}

/* The directions of a pixel's neighbours, a bit each. */
static unsigned neighbours(const duct_bitmap *thin, int x, int y)
{
    unsigned set = 0;
    for (unsigned i = 0; i < 8; i++) {
        set |= (unsigned)duct_bitmap_get(thin, x + step_x[i], y + step_y[i]) << i;
    }
    for (unsigned i = 1; i < 8; i += 2) {
        unsigned sides = 1u << (i - 1) | 1u << ((i + 1) % 8);
        if ((set & sides) != 0) {
            set &= ~(1u << i);
        }
    }
    return set;
}

static int count_bits(unsigned set)
{
    int count = 0;
    for (; set != 0; set &= set - 1) {
        count++;
    }
    return count;
}

static bool grow(duct_graph *graph, void *list, size_t *capacity, size_t needed, size_t size)
{
    void **memory = list;
    if (!duct_reserve(graph->allocator, memory, capacity, needed, size)) {
        graph->failed = true;
        return false;
    }
    return true;
}

static void add_pixel(duct_graph *graph, int x, int y)
{
    if (grow(graph, &graph->pixels, &graph->pixel_capacity, graph->pixel_count + 1, sizeof *graph->pixels)) {
        graph->pixels[graph->pixel_count++] = (duct_pixel){x, y};
    }
}

static int compare_marks(const void *a, const void *b)
{
    const struct mark *one = a, *other = b;
    if (one->at.y != other->at.y) {
        return one->at.y < other->at.y ? -1 : 1;
    }
    return one->at.x < other->at.x ? -1 : one->at.x > other->at.x;
}

static struct mark *find_mark(const struct tracer *tracer, int x, int y)
{
    if (tracer->mark_count == 0) {
        return NULL;
    }
    const struct mark key = {{x, y}, 0};
    return bsearch(&key, tracer->marks, tracer->mark_count, sizeof key, compare_marks);
}

static duct_status find_marks(struct tracer *tracer, duct_error *error)
{
    const duct_bitmap *thin = tracer->thin;
    duct_graph *graph = tracer->graph;
    for (int y = 0; y < thin->height && !graph->failed; y++) {
        const uint64_t *row = duct_bitmap_row(thin, y);
        for (size_t w = 0; w < thin->stride; w++) {
            for (uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
                int x = (int)(w * 64) + __builtin_ctzll(bits) - 1;
                if (count_bits(neighbours(thin, x, y)) != 2 &&
                    grow(graph, &tracer->marks, &tracer->mark_capacity, tracer->mark_count + 1,
                         sizeof(struct mark))) {
                    tracer->marks[tracer->mark_count++] = (struct mark){{x, y}, SIZE_MAX};
                }
            }
        }
    }
    return graph->failed ? duct_fail_memory(error) : DUCT_OK;
}

static void take_in(struct tracer *tracer, struct mark *mark, size_t node)
{
    duct_node *to = &tracer->graph->nodes[node];
    double n = (double)to->weight;
    to->x = (to->x * n + mark->at.x + 0.5) / (n + 1);
    to->y = (to->y * n + mark->at.y + 0.5) / (n + 1);
    to->radius = fmax(to->radius, duct_bitmap_radius(tracer->ink, mark->at.x, mark->at.y, -1));
    to->reach = to->radius;
    to->weight++;
    mark->node = node;
}

/* Junctions that touch, from one of them on. They are few, so what waits is kept in the marks' own order. */
static void flood(struct tracer *tracer, struct mark *first, size_t node, size_t *waiting)
{
    size_t count = 0;
    waiting[count++] = (size_t)(first - tracer->marks);
    take_in(tracer, first, node);
    while (count > 0) {
        const duct_pixel at = tracer->marks[waiting[--count]].at;
        unsigned set = neighbours(tracer->thin, at.x, at.y);
        if (count_bits(set) < 3) {
            continue;
        }
        for (unsigned i = 0; i < 8; i++) {
            if ((set >> i & 1) == 0) {
                continue;
            }
            struct mark *next = find_mark(tracer, at.x + step_x[i], at.y + step_y[i]);
            if (next != NULL && next->node == SIZE_MAX &&
                count_bits(neighbours(tracer->thin, next->at.x, next->at.y)) >= 3) {
                take_in(tracer, next, node);
                waiting[count++] = (size_t)(next - tracer->marks);
            }
        }
    }
}

static duct_status make_nodes(struct tracer *tracer, duct_error *error)
{
    duct_graph *graph = tracer->graph;
    size_t *waiting = duct_alloc(graph->allocator, tracer->mark_count + 1, sizeof *waiting);
    if (waiting == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < tracer->mark_count && !graph->failed; i++) {
        if (tracer->marks[i].node == SIZE_MAX &&
            grow(graph, &graph->nodes, &graph->node_capacity, graph->node_count + 1, sizeof *graph->nodes)) {
            size_t node = graph->node_count++;
            graph->nodes[node] = (duct_node){0, 0, 0, 0, 0, node, 0, 0, 0};
            flood(tracer, &tracer->marks[i], node, waiting);
        }
    }
    duct_release(graph->allocator, waiting);
    return graph->failed ? duct_fail_memory(error) : DUCT_OK;
}

static duct_edge *add_edge(duct_graph *graph, ptrdiff_t from)
{
    if (!grow(graph, &graph->edges, &graph->edge_capacity, graph->edge_count + 1, sizeof *graph->edges)) {
        return NULL;
    }
    duct_edge *edge = &graph->edges[graph->edge_count++];
    *edge = (duct_edge){{from, DUCT_NO_NODE}, graph->pixel_count, 0, 0, 0, false, {-1, -1}, {false, false}};
    return edge;
}

/* Follows a line from a pixel on, away from the one at `back`; the node that it leads to, or DUCT_NO_NODE
 * where it comes back to where it began. */
static ptrdiff_t follow(struct tracer *tracer, int x, int y, int back_x, int back_y)
{
    for (;;) {
        duct_bitmap_set(&tracer->seen, x, y);
        add_pixel(tracer->graph, x, y);
        unsigned set = neighbours(tracer->thin, x, y);
        int next_x = x, next_y = y;
        const struct mark *end = NULL;
        for (unsigned i = 0; i < 8 && !tracer->graph->failed; i++) {
            int to_x = x + step_x[i], to_y = y + step_y[i];
            if ((set >> i & 1) == 0 || (to_x == back_x && to_y == back_y)) {
                continue;
            }
            const struct mark *mark = find_mark(tracer, to_x, to_y);
            if (mark != NULL) {
                end = mark;
            } else if (!duct_bitmap_get(&tracer->seen, to_x, to_y)) {
                next_x = to_x;
                next_y = to_y;
            }
        }
        if (end != NULL) {
            return (ptrdiff_t)end->node;
        }
        if (next_x == x && next_y == y) {
            return DUCT_NO_NODE;
        }
        back_x = x;
        back_y = y;
        x = next_x;
        y = next_y;
    }
}

static void edges_from(struct tracer *tracer, const struct mark *from)
{
    unsigned set = neighbours(tracer->thin, from->at.x, from->at.y);
    for (unsigned i = 0; i < 8 && !tracer->graph->failed; i++) {
        int x = from->at.x + step_x[i], y = from->at.y + step_y[i];
        if ((set >> i & 1) == 0) {
            continue;
        }
        const struct mark *to = find_mark(tracer, x, y);
        if (to != NULL) {
            /* Two nodes side by side; once for both. */
            duct_edge *edge = to->node > from->node ? add_edge(tracer->graph, (ptrdiff_t)from->node) : NULL;
            if (edge != NULL) {
                edge->node[1] = (ptrdiff_t)to->node;
            }
        } else if (!duct_bitmap_get(&tracer->seen, x, y)) {
            duct_edge *edge = add_edge(tracer->graph, (ptrdiff_t)from->node);
            if (edge != NULL) {
                size_t index = tracer->graph->edge_count - 1;
                ptrdiff_t end = follow(tracer, x, y, from->at.x, from->at.y);
                edge = &tracer->graph->edges[index];
                edge->node[1] = end != DUCT_NO_NODE ? end : (ptrdiff_t)from->node;
                edge->count = tracer->graph->pixel_count - edge->first;
            }
        }
    }
}

static void closed_edges(struct tracer *tracer)
{
    const duct_bitmap *thin = tracer->thin;
    for (int y = 0; y < thin->height && !tracer->graph->failed; y++) {
        const uint64_t *row = duct_bitmap_row(thin, y);
        for (size_t w = 0; w < thin->stride; w++) {
            for (uint64_t bits = row[w]; bits != 0; bits &= bits - 1) {
                int x = (int)(w * 64) + __builtin_ctzll(bits) - 1;
                if (duct_bitmap_get(&tracer->seen, x, y) || find_mark(tracer, x, y) != NULL) {
                    continue;
                }
                duct_edge *edge = add_edge(tracer->graph, DUCT_NO_NODE);
                if (edge == NULL) {
                    return;
                }
                size_t index = tracer->graph->edge_count - 1;
                follow(tracer, x, y, x, y);
                edge = &tracer->graph->edges[index];
                edge->count = tracer->graph->pixel_count - edge->first;
            }
        }
    }
}

static int compare_numbers(const void *a, const void *b)
{
    double one = *(const double *)a, other = *(const double *)b;
    return one < other ? -1 : one > other;
}

static double distance(double ax, double ay, double bx, double by)
{
    return hypot(ax - bx, ay - by);
}

/* Length and median radius. */
static bool measure(struct tracer *tracer, duct_edge *edge)
{
    duct_graph *graph = tracer->graph;
    const duct_pixel *pixels = graph->pixels + edge->first;
    double *radii = duct_alloc(graph->allocator, edge->count + 2, sizeof *radii);
    if (radii == NULL) {
        graph->failed = true;
        return false;
    }
    double radius = -1;
    for (size_t i = 0; i < edge->count; i++) {
        radii[i] = radius = duct_bitmap_radius(tracer->ink, pixels[i].x, pixels[i].y, radius);
        if (i > 0) {
            edge->length += distance(pixels[i].x, pixels[i].y, pixels[i - 1].x, pixels[i - 1].y);
        }
    }
    size_t count = edge->count;
    for (int side = 0; side < 2 && edge->node[side] != DUCT_NO_NODE; side++) {
        const duct_node *node = &graph->nodes[edge->node[side]];
        if (edge->count == 0) {
            const duct_node *other = &graph->nodes[edge->node[1 - side]];
            edge->length = distance(node->x, node->y, other->x, other->y);
            radii[count++] = node->radius;
        } else {
            const duct_pixel *end = &pixels[side == 0 ? 0 : edge->count - 1];
            edge->length += distance(node->x, node->y, end->x + 0.5, end->y + 0.5);
        }
    }
    qsort(radii, count, sizeof *radii, compare_numbers);
    edge->radius = count > 0 ? radii[count / 2] : 0.5;
    duct_release(graph->allocator, radii);
    return true;
}

static duct_status make_edges(struct tracer *tracer, duct_error *error)
{
    duct_graph *graph = tracer->graph;
    for (size_t i = 0; i < tracer->mark_count && !graph->failed; i++) {
        edges_from(tracer, &tracer->marks[i]);
    }
    closed_edges(tracer);
    for (size_t i = 0; i < graph->edge_count && !graph->failed; i++) {
        if ((i & 255) == 0) {
            duct_status status = duct_progress_report(
                tracer->context, 0.75 + 0.15 * (double)i / (double)graph->edge_count, error);
            if (status != DUCT_OK) {
                return status;
            }
        }
        measure(tracer, &graph->edges[i]);
    }
    return graph->failed ? duct_fail_memory(error) : DUCT_OK;
}

duct_status duct_graph_trace(const duct_context *context, const duct_bitmap *thin, const duct_bitmap *ink,
                             duct_graph *graph, duct_error *error)
{
    struct tracer tracer = {context, thin, ink, {0}, NULL, 0, 0, graph};
    duct_status status = duct_bitmap_init(&tracer.seen, graph->allocator, thin->width, thin->height)
                             ? find_marks(&tracer, error)
                             : duct_fail_memory(error);
    if (status == DUCT_OK) {
        status = make_nodes(&tracer, error);
    }
    if (status == DUCT_OK) {
        status = make_edges(&tracer, error);
    }
    duct_release(graph->allocator, tracer.marks);
    if (tracer.seen.words != NULL) {
        duct_bitmap_done(&tracer.seen);
    }
    return status;
}
