/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Strokes of a graph, and the order in which somebody would draw them. */
#include "lineart/lineart_private.h"

#include "base/error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct place {
    double x, y;
    bool fixed; /* an end or a corner, which smoothing leaves where it is */
};

struct line {
    size_t first, count; /* places */
    size_t part;         /* what hangs together */
    size_t index;
    double length, width;
    bool closed;
};

struct part {
    double x0, y0, x1, y1;
    double length, width;
    int band;
};

struct writer {
    duct_graph *graph;
    struct place *places, *scratch;
    size_t place_count, place_capacity, scratch_capacity;
    struct line *lines;
    size_t line_count, line_capacity;
    size_t *parts_of;   /* the part of each node; union-find */
    struct part *parts; /* by node, and behind them those of closed lines and dots */
    size_t part_count;
    bool failed;
};

static bool grow(struct writer *writer, void *list, size_t *capacity, size_t needed, size_t size)
{
    void **memory = list;
    if (!duct_reserve(writer->graph->allocator, memory, capacity, needed, size)) {
        writer->failed = true;
        return false;
    }
    return true;
}

static void add_place(struct writer *writer, double x, double y, bool fixed)
{
    if (grow(writer, &writer->places, &writer->place_capacity, writer->place_count + 1,
             sizeof(struct place))) {
        writer->places[writer->place_count++] = (struct place){x, y, fixed};
    }
}

static size_t part_of(struct writer *writer, size_t node)
{
    while (writer->parts_of[node] != node) {
        writer->parts_of[node] = writer->parts_of[writer->parts_of[node]];
        node = writer->parts_of[node];
    }
    return node;
}

static const duct_node *node_at(const struct writer *writer, const duct_edge *edge, int side)
{
    return &writer->graph->nodes[duct_graph_node(writer->graph, (size_t)edge->node[side])];
}

static double apart(const struct place *place, const duct_node *node)
{
    return hypot(place->x - node->x, place->y - node->y);
}

/* Whether a line ends at one that is much wider, into which thinning lets it run askew. */
static bool is_blot(const duct_edge *edge, const duct_node *node)
{
    return node->degree >= 3 && node->radius > 1.5 * edge->radius + 1;
}

/* Appends an edge's pixels from one side to the other. Where the line runs on through a node, or ends at a
 * wider line, what is inside the node's blot is left out: thinning bends lines there. */
static void add_edge(struct writer *writer, const duct_edge *edge, int side)
{
    size_t begin = writer->place_count;
    const duct_node *from = edge->node[0] != DUCT_NO_NODE ? node_at(writer, edge, side) : NULL;
    const duct_node *to = from != NULL ? node_at(writer, edge, 1 - side) : NULL;
    bool through_from = from != NULL && (edge->next[side] >= 0 ? !edge->corner[side] : is_blot(edge, from));
    bool through_to = to != NULL && (edge->next[1 - side] >= 0 ? !edge->corner[1 - side] : is_blot(edge, to));
    for (size_t i = 0; i < edge->count; i++) {
        const duct_pixel *pixel = &writer->graph->pixels[edge->first + (side == 0 ? i : edge->count - 1 - i)];
        const struct place here = {pixel->x + 0.5, pixel->y + 0.5, false};
        bool inside = (through_from && apart(&here, from) < from->reach) ||
                      (through_to && apart(&here, to) < to->reach);
        if (!inside || (i == edge->count / 2 && writer->place_count == begin)) {
            add_place(writer, here.x, here.y, false);
        }
    }
}

/* Follows edges from an end on, until nothing goes on or the first edge comes again. */
static void add_line(struct writer *writer, size_t edge_index, int side, bool *used)
{
    duct_graph *graph = writer->graph;
    struct line made = {writer->place_count, 0, 0, writer->line_count, 0, 0, false};
    const duct_edge *edge = &graph->edges[edge_index];
    double weighted = 0;
    made.closed = edge->node[0] == DUCT_NO_NODE || edge->next[side] >= 0;
    if (edge->node[0] != DUCT_NO_NODE) {
        const duct_node *node = node_at(writer, edge, side);
        made.part = part_of(writer, (size_t)(node - graph->nodes));
        if (made.closed ? edge->corner[side] : !is_blot(edge, node)) {
            add_place(writer, node->x, node->y, true);
        }
    }
    for (;;) {
        edge = &graph->edges[edge_index];
        used[edge_index] = true;
        add_edge(writer, edge, side);
        made.length += edge->length;
        weighted += edge->length * edge->radius;
        ptrdiff_t next = edge->next[1 - side];
        bool again = next >= 0 && used[next / 2];
        if (edge->node[0] != DUCT_NO_NODE && !again) {
            const duct_node *node = node_at(writer, edge, 1 - side);
            if (next < 0 ? !is_blot(edge, node) : edge->corner[1 - side]) {
                add_place(writer, node->x, node->y, true);
            }
        }
        if (next < 0 || again) {
            break;
        }
        edge_index = (size_t)next / 2;
        side = (int)(next % 2);
    }
    made.count = writer->place_count - made.first;
    made.width = 2 * (made.length > 0 ? weighted / made.length : edge->radius);
    if (made.closed && graph->edges[edge_index].node[0] == DUCT_NO_NODE) {
        made.part = SIZE_MAX;
    }
    if (made.count > 0 &&
        grow(writer, &writer->lines, &writer->line_capacity, writer->line_count + 1, sizeof made)) {
        writer->lines[writer->line_count++] = made;
    }
}

/* A blot that is about as long as it is wide. */
static void add_dot(struct writer *writer, const duct_node *node)
{
    struct line made = {writer->place_count, 1, SIZE_MAX, writer->line_count, 0, 2 * node->radius, false};
    add_place(writer, node->x, node->y, true);
    if (grow(writer, &writer->lines, &writer->line_capacity, writer->line_count + 1, sizeof made)) {
        writer->lines[writer->line_count++] = made;
    }
}

static duct_status collect(struct writer *writer, duct_error *error)
{
    duct_graph *graph = writer->graph;
    bool *used = duct_alloc(graph->allocator, graph->edge_count + 1, sizeof *used);
    writer->parts_of = duct_alloc(graph->allocator, graph->node_count + 1, sizeof *writer->parts_of);
    if (used == NULL || writer->parts_of == NULL) {
        duct_release(graph->allocator, used);
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < graph->node_count; i++) {
        writer->parts_of[i] = i;
    }
    for (size_t i = 0; i < graph->edge_count; i++) {
        const duct_edge *edge = &graph->edges[i];
        used[i] = edge->gone;
        if (!edge->gone && edge->node[0] != DUCT_NO_NODE) {
            size_t a = part_of(writer, duct_graph_node(graph, (size_t)edge->node[0]));
            size_t b = part_of(writer, duct_graph_node(graph, (size_t)edge->node[1]));
            writer->parts_of[a < b ? b : a] = a < b ? a : b;
        }
    }
    for (size_t i = 0; i < graph->edge_count && !writer->failed; i++) {
        for (int side = 0; side < 2; side++) {
            if (!used[i] && graph->edges[i].node[0] != DUCT_NO_NODE && graph->edges[i].next[side] < 0) {
                add_line(writer, i, side, used);
            }
        }
    }
    for (size_t i = 0; i < graph->edge_count && !writer->failed; i++) {
        if (!used[i]) {
            add_line(writer, i, 0, used);
        }
    }
    for (size_t i = 0; i < graph->node_count && !writer->failed; i++) {
        const duct_node *node = &graph->nodes[i];
        if (node->merged == i && node->degree == 0 && node->branches != 1) {
            add_dot(writer, node);
        }
    }
    duct_release(graph->allocator, used);
    return writer->failed ? duct_fail_memory(error) : DUCT_OK;
}

static void spread(struct part *part, const struct place *place)
{
    part->x0 = fmin(part->x0, place->x);
    part->y0 = fmin(part->y0, place->y);
    part->x1 = fmax(part->x1, place->x);
    part->y1 = fmax(part->y1, place->y);
}

static duct_status measure_parts(struct writer *writer, duct_error *error)
{
    size_t nodes = writer->graph->node_count;
    writer->part_count = nodes + writer->line_count;
    writer->parts = duct_alloc(writer->graph->allocator, writer->part_count + 1, sizeof *writer->parts);
    if (writer->parts == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < writer->part_count; i++) {
        writer->parts[i] = (struct part){INFINITY, INFINITY, -INFINITY, -INFINITY, 0, 0, 0};
    }
    for (size_t i = 0; i < writer->line_count; i++) {
        struct line *line = &writer->lines[i];
        line->part = line->part == SIZE_MAX ? nodes + i : line->part;
        struct part *part = &writer->parts[line->part];
        for (size_t k = 0; k < line->count; k++) {
            spread(part, &writer->places[line->first + k]);
        }
        part->length += line->length;
        part->width = fmax(part->width, line->width);
    }
    return DUCT_OK;
}

static int compare_numbers(const void *a, const void *b)
{
    double one = *(const double *)a, other = *(const double *)b;
    return one < other ? -1 : one > other;
}

/* A part and what it is sorted by. */
struct key {
    double y;
    size_t part;
};

static int compare_keys(const void *a, const void *b)
{
    const struct key *one = a, *other = b;
    if (one->y < other->y || one->y > other->y) {
        return one->y < other->y ? -1 : 1;
    }
    return one->part < other->part ? -1 : one->part > other->part;
}

/* Parts whose middles are at about the same height are a band, as a line of text is. */
static duct_status find_bands(struct writer *writer, duct_error *error)
{
    const duct_allocator *allocator = writer->graph->allocator;
    struct key *keys = duct_alloc(allocator, writer->part_count + 1, sizeof *keys);
    double *heights = duct_alloc(allocator, writer->part_count + 1, sizeof *heights);
    if (keys == NULL || heights == NULL) {
        duct_release(allocator, keys);
        duct_release(allocator, heights);
        return duct_fail_memory(error);
    }
    size_t count = 0;
    for (size_t i = 0; i < writer->part_count; i++) {
        const struct part *part = &writer->parts[i];
        if (part->x1 >= part->x0) {
            heights[count] = part->y1 - part->y0;
            keys[count++] = (struct key){(part->y0 + part->y1) / 2, i};
        }
    }
    qsort(keys, count, sizeof *keys, compare_keys);
    qsort(heights, count, sizeof *heights, compare_numbers);
    double height = count > 0 ? fmax(1.2 * heights[count / 2], 8) : 0;
    int band = 0;
    double top = count > 0 ? keys[0].y : 0;
    for (size_t i = 0; i < count; i++) {
        if (keys[i].y > top + height) {
            band++;
            top = keys[i].y;
        }
        writer->parts[keys[i].part].band = band;
    }
    duct_release(allocator, keys);
    duct_release(allocator, heights);
    return DUCT_OK;
}

/* A line with its part's place, so that it can be sorted without looking elsewhere. */
struct ordered {
    struct line line;
    int band;
    double x;
};

static int compare_lines(const void *a, const void *b)
{
    const struct ordered *one = a, *other = b;
    if (one->band != other->band) {
        return one->band < other->band ? -1 : 1;
    }
    if (one->x < other->x || one->x > other->x) {
        return one->x < other->x ? -1 : 1;
    }
    if (one->line.part != other->line.part) {
        return one->line.part < other->line.part ? -1 : 1;
    }
    if (one->line.length > other->line.length || one->line.length < other->line.length) {
        return one->line.length > other->line.length ? -1 : 1;
    }
    return one->line.index < other->line.index ? -1 : one->line.index > other->line.index;
}

/* Fills gaps, so that neighbours are about a pixel apart. */
static size_t fill_gaps(struct writer *writer, const struct line *line)
{
    const struct place *places = writer->places + line->first;
    size_t count = 0, steps = line->closed ? line->count : line->count - 1;
    for (size_t i = 0; i < line->count; i++) {
        const struct place *a = &places[i], *b = &places[(i + 1) % line->count];
        double way = i < steps ? hypot(b->x - a->x, b->y - a->y) : 0;
        size_t more = way > 1.5 ? (size_t)(way - 0.5) : 0;
        if (!grow(writer, &writer->scratch, &writer->scratch_capacity, count + 1 + more,
                  sizeof(struct place))) {
            return 0;
        }
        writer->scratch[count++] = *a;
        for (size_t k = 1; k <= more; k++) {
            double t = (double)k / (double)(more + 1);
            writer->scratch[count++] =
                (struct place){a->x + t * (b->x - a->x), a->y + t * (b->y - a->y), false};
        }
    }
    return count;
}

/* Takes the pixels' steps out of a line: binomial smoothing, more of it the wider the line. */
static void smooth(struct place *places, size_t count, bool closed, double width)
{
    int rounds = (int)fmin(fmax(2 + width / 2, 4), 12);
    for (int round = 0; round < rounds && count > 2; round++) {
        struct place before = closed ? places[count - 1] : places[0], first = places[0];
        for (size_t i = 0; i < count; i++) {
            struct place here = places[i];
            struct place after = i + 1 < count ? places[i + 1] : closed ? first : here;
            if (!here.fixed) {
                places[i].x = (before.x + 2 * here.x + after.x) / 4;
                places[i].y = (before.y + 2 * here.y + after.y) / 4;
            }
            before = here;
        }
    }
}

static void reverse(struct place *places, size_t count)
{
    for (size_t i = 0; i < count / 2; i++) {
        struct place swapped = places[i];
        places[i] = places[count - 1 - i];
        places[count - 1 - i] = swapped;
    }
}

/* Right-handed people begin at the left or at the top. */
static void turn_open(struct place *places, size_t count)
{
    double dx = places[count - 1].x - places[0].x, dy = places[count - 1].y - places[0].y;
    if (fabs(dx) > fabs(dy) ? dx < 0 : dy < 0) {
        reverse(places, count);
    }
}

/* From the top, against the clock. */
static void turn_closed(struct place *places, size_t count)
{
    double area = 0;
    for (size_t i = 0; i < count; i++) {
        const struct place *a = &places[i], *b = &places[(i + 1) % count];
        area += a->x * b->y - b->x * a->y;
    }
    if (area > 0) {
        reverse(places, count);
    }
    size_t top = 0;
    for (size_t i = 1; i < count; i++) {
        top = places[i].y < places[top].y ? i : top;
    }
    /* Turned by three reversals. */
    reverse(places, top);
    reverse(places + top, count - top);
    reverse(places, count);
}

/* Every second place, the fixed ones and the last. */
static size_t thin_out(struct place *places, size_t count)
{
    size_t kept = 0;
    for (size_t i = 0; i < count; i++) {
        if (i % 2 == 0 || places[i].fixed || i + 1 == count) {
            places[kept++] = places[i];
        }
    }
    return kept;
}

static duct_status write_line(struct writer *writer, const struct line *line, duct_drawing *drawing,
                              duct_error *error)
{
    size_t count = fill_gaps(writer, line);
    struct place *places = writer->scratch;
    if (writer->failed) {
        return duct_fail_memory(error);
    }
    bool closed = line->closed && count > 4;
    smooth(places, count, closed, line->width);
    if (closed) {
        turn_closed(places, count);
    } else {
        turn_open(places, count);
    }
    count = count > 4 ? thin_out(places, count) : count;
    char id[64];
    const struct place *middle = &places[count / 2];
    snprintf(id, sizeof id, "%d,%d-%d,%d", (int)places[0].x, (int)places[0].y, (int)middle->x,
             (int)middle->y);
    duct_stroke *stroke = NULL;
    duct_status status = duct_drawing_add_stroke(drawing, id, count, &stroke, error);
    if (status != DUCT_OK) {
        return status;
    }
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    for (size_t i = 0; i < count; i++) {
        x[i] = places[i].x;
        y[i] = places[i].y;
    }
    duct_stroke_style style = duct_stroke_get_style(stroke);
    style.width = line->width;
    duct_stroke_set_style(stroke, style);
    duct_stroke_set_closed(stroke, closed);
    return DUCT_OK;
}

static duct_status write_lines(struct writer *writer, const duct_lineart_options *options,
                               duct_drawing *drawing, duct_error *error)
{
    struct ordered *sorted = duct_alloc(writer->graph->allocator, writer->line_count + 1, sizeof *sorted);
    if (sorted == NULL) {
        return duct_fail_memory(error);
    }
    size_t count = 0;
    for (size_t i = 0; i < writer->line_count; i++) {
        const struct line *line = &writer->lines[i];
        const struct part *part = &writer->parts[line->part];
        if (part->length + part->width >= options->shortest) {
            sorted[count++] = (struct ordered){*line, part->band, part->x0};
        }
    }
    qsort(sorted, count, sizeof *sorted, compare_lines);
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < count && status == DUCT_OK; i++) {
        status = write_line(writer, &sorted[i].line, drawing, error);
    }
    duct_release(writer->graph->allocator, sorted);
    return status;
}

duct_status duct_graph_strokes(duct_graph *graph, const duct_lineart_options *options, duct_drawing *drawing,
                               duct_error *error)
{
    struct writer writer;
    memset(&writer, 0, sizeof writer);
    writer.graph = graph;
    duct_status status = collect(&writer, error);
    if (status == DUCT_OK) {
        status = measure_parts(&writer, error);
    }
    if (status == DUCT_OK) {
        status = find_bands(&writer, error);
    }
    if (status == DUCT_OK) {
        status = write_lines(&writer, options, drawing, error);
    }
    duct_release(graph->allocator, writer.places);
    duct_release(graph->allocator, writer.scratch);
    duct_release(graph->allocator, writer.lines);
    duct_release(graph->allocator, writer.parts_of);
    duct_release(graph->allocator, writer.parts);
    return status;
}
