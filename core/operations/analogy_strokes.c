/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "operations/analogy_strokes.h"

#include "base/error.h"
#include "style/style.h"

#include <math.h>
#include <string.h>

void duct_pieces_done(duct_pieces *pieces)
{
    for (size_t i = 0; i < pieces->count; i++) {
        duct_curve_done(pieces->allocator, &pieces->items[i].curve);
        duct_release(pieces->allocator, pieces->items[i].constraints);
    }
    duct_release(pieces->allocator, pieces->items);
    *pieces = (duct_pieces){pieces->allocator, NULL, 0, 0};
}

static duct_status add_piece(duct_pieces *pieces, duct_piece *piece, duct_error *error)
{
    void *items = pieces->items;
    if (!duct_reserve(pieces->allocator, &items, &pieces->capacity, pieces->count + 1,
                      sizeof *pieces->items)) {
        duct_curve_done(pieces->allocator, &piece->curve);
        return duct_fail_memory(error);
    }
    pieces->items = items;
    pieces->items[pieces->count++] = *piece;
    return DUCT_OK;
}

/* How far along the line its direction is looked at, and the turn that is a corner. */
static const double corner_span = 3, corner_turn = 40 * M_PI / 180;

/* The turn at control point i between what lies `corner_span` before and behind it, radians. */
static double turn_at(const duct_curve *curve, size_t i)
{
    long count = (long)curve->count;
    double directions[2][2];
    for (int side = 0; side < 2; side++) {
        long way = side == 0 ? -1 : 1, at = (long)i;
        for (long n = 1; n < count; n++) {
            long next = (long)i + way * n;
            if (!curve->closed && (next < 0 || next >= count)) {
                break;
            }
            at = ((next % count) + count) % count;
            if (hypot(curve->x[at] - curve->x[i], curve->y[at] - curve->y[i]) >= corner_span) {
                break;
            }
        }
        directions[side][0] = (double)way * (curve->x[at] - curve->x[i]);
        directions[side][1] = (double)way * (curve->y[at] - curve->y[i]);
    }
    double *u = directions[0], *v = directions[1];
    return fabs(atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
}

/* Whether no control point within the span turns more; the first one wins among equals. */
static bool is_corner(const duct_curve *curve, const double *turns, size_t i)
{
    if (!(turns[i] > corner_turn)) {
        return false;
    }
    for (size_t j = 0; j < curve->count; j++) {
        bool near = j != i && hypot(curve->x[j] - curve->x[i], curve->y[j] - curve->y[i]) < corner_span;
        size_t apart = j > i ? j - i : i - j;
        apart = curve->closed && curve->count - apart < apart ? curve->count - apart : apart;
        if (near && apart < 16 && (turns[j] > turns[i] || (turns[j] == turns[i] && j < i))) {
            return false;
        }
    }
    return true;
}

/* The control points first .. last (which may run over the end of a closed curve) as a curve. */
static duct_status cut(const duct_pieces *pieces, const duct_curve *curve, size_t first, size_t last,
                       duct_piece *piece, duct_error *error)
{
    size_t count = last - first + 1;
    duct_status status =
        duct_curve_init(pieces->allocator, count, false, curve->extra != NULL, &piece->curve, error);
    if (status != DUCT_OK) {
        return status;
    }
    for (size_t i = 0; i < count; i++) {
        size_t from = (first + i) % curve->count;
        piece->curve.x[i] = curve->x[from];
        piece->curve.y[i] = curve->y[from];
        if (curve->extra != NULL) {
            piece->curve.extra[i] = curve->extra[from];
        }
    }
    piece->from = curve->t[first % curve->count];
    piece->to = last >= curve->count ? 1 + curve->t[last % curve->count] : curve->t[last];
    duct_curve_use_arc_length(&piece->curve);
    return DUCT_OK;
}

static duct_status add_split(duct_pieces *pieces, const duct_curve *curve, const duct_piece *like,
                             duct_error *error)
{
    double *turns = duct_alloc(pieces->allocator, curve->count, sizeof *turns);
    size_t *corners = duct_alloc(pieces->allocator, curve->count + 2, sizeof *corners), count = 0;
    duct_status status = turns != NULL && corners != NULL ? DUCT_OK : duct_fail_memory(error);
    if (status == DUCT_OK) {
        for (size_t i = 0; i < curve->count; i++) {
            bool end = !curve->closed && (i == 0 || i + 1 == curve->count);
            turns[i] = end ? 0 : turn_at(curve, i);
        }
        if (!curve->closed) {
            corners[count++] = 0;
        }
        for (size_t i = 0; i < curve->count; i++) {
            if (is_corner(curve, turns, i)) {
                corners[count++] = i;
            }
        }
        if (!curve->closed) {
            corners[count++] = curve->count - 1;
        } else if (count > 0) {
            corners[count] = corners[0] + curve->count;
            count++;
        }
    }
    for (size_t i = 0; i + 1 < count && status == DUCT_OK; i++) {
        duct_piece piece = *like;
        piece.part = i;
        status = cut(pieces, curve, corners[i], corners[i + 1], &piece, error);
        status = status == DUCT_OK ? add_piece(pieces, &piece, error) : status;
    }
    duct_release(pieces->allocator, turns);
    duct_release(pieces->allocator, corners);
    return status;
}

duct_status duct_pieces_add(duct_pieces *pieces, const duct_stroke *stroke, size_t number, size_t style,
                            bool split, bool join, duct_error *error)
{
    duct_piece piece = {.stroke = number, .style = style, .from = 0, .to = 1, .join = join};
    duct_status status = duct_curve_of_stroke(pieces->allocator, stroke, 1, true, &piece.curve, error);
    if (status != DUCT_OK) {
        return status;
    }
    if (piece.curve.count == 0) {
        duct_curve_done(pieces->allocator, &piece.curve);
        return DUCT_OK;
    }
    if (split) {
        size_t before = pieces->count;
        status = add_split(pieces, &piece.curve, &piece, error);
        if (status != DUCT_OK || pieces->count > before) {
            duct_curve_done(pieces->allocator, &piece.curve);
            return status;
        }
    }
    return add_piece(pieces, &piece, error);
}

static duct_status constrain(duct_pieces *pieces, size_t index, double t, double x, double y, double weight,
                             duct_error *error)
{
    duct_piece *piece = &pieces->items[index];
    void *items = piece->constraints;
    if (!duct_reserve(pieces->allocator, &items, &piece->constraint_capacity, piece->constraint_count + 1,
                      sizeof *piece->constraints)) {
        return duct_fail_memory(error);
    }
    piece->constraints = items;
    piece->constraints[piece->constraint_count++] = (duct_curve_constraint){t, x, y, weight};
    return DUCT_OK;
}

/* The nearest place of a curve to a point: its parameter; `*distance` tells how far. */
static double nearest(const duct_curve *curve, double x, double y, double *distance)
{
    double best = INFINITY, t = 0;
    for (size_t i = 0; i < duct_curve_segments(curve); i++) {
        size_t next = i + 1 < curve->count ? i + 1 : 0;
        double dx = curve->x[next] - curve->x[i], dy = curve->y[next] - curve->y[i];
        double square = dx * dx + dy * dy;
        double share = square > 0 ? ((x - curve->x[i]) * dx + (y - curve->y[i]) * dy) / square : 0;
        share = share < 0 ? 0 : share > 1 ? 1 : share;
        double far = hypot(curve->x[i] + share * dx - x, curve->y[i] + share * dy - y);
        if (far < best) {
            double end = next > 0 ? curve->t[next] : curve->t[0] + 1;
            best = far;
            t = curve->t[i] + share * (end - curve->t[i]);
        }
    }
    *distance = best;
    return t;
}

/* One end of an open piece. */
typedef struct {
    size_t piece, leader;
    double t, x, y;
} line_end;

static size_t leader_of(line_end *ends, size_t i)
{
    while (ends[i].leader != i) {
        i = ends[i].leader;
    }
    return i;
}

static size_t collect_ends(const duct_pieces *pieces, line_end *ends)
{
    size_t count = 0;
    for (size_t p = 0; p < pieces->count; p++) {
        const duct_curve *curve = &pieces->items[p].curve;
        for (size_t end = 0; end < 2 && pieces->items[p].join && !curve->closed; end++) {
            size_t at = end == 0 ? 0 : curve->count - 1;
            ends[count] = (line_end){p, count, (double)end, curve->x[at], curve->y[at]};
            count++;
        }
    }
    return count;
}

/* An end that meets no other: to the curve on which it lies, if there is one. */
static duct_status join_across(duct_pieces *pieces, const line_end *end, double reach, duct_error *error)
{
    duct_status status = DUCT_OK;
    for (size_t p = 0; p < pieces->count && status == DUCT_OK; p++) {
        double distance;
        if (p == end->piece || !pieces->items[p].join) {
            continue;
        }
        double t = nearest(&pieces->items[p].curve, end->x, end->y, &distance);
        if (distance <= reach) {
            status = constrain(pieces, p, t, end->x, end->y, INFINITY, error);
            return status == DUCT_OK ? constrain(pieces, end->piece, end->t, end->x, end->y, INFINITY, error)
                                     : status;
        }
    }
    return status;
}

duct_status duct_pieces_join(duct_pieces *pieces, double reach, duct_error *error)
{
    line_end *ends = duct_alloc(pieces->allocator, 2 * pieces->count, sizeof *ends);
    if (ends == NULL) {
        return duct_fail_memory(error);
    }
    size_t count = collect_ends(pieces, ends);
    for (size_t i = 0; i < count; i++) {
        for (size_t j = 0; j < i; j++) {
            if (hypot(ends[i].x - ends[j].x, ends[i].y - ends[j].y) <= reach) {
                size_t a = leader_of(ends, i), b = leader_of(ends, j);
                ends[a > b ? a : b].leader = a > b ? b : a;
            }
        }
    }
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < count && status == DUCT_OK; i++) {
        double x = 0, y = 0, members = 0;
        for (size_t j = 0; j < count; j++) {
            if (leader_of(ends, j) == i) {
                x += ends[j].x;
                y += ends[j].y;
                members++;
            }
        }
        for (size_t j = 0; j < count && members > 1 && status == DUCT_OK; j++) {
            if (leader_of(ends, j) == i) {
                status =
                    constrain(pieces, ends[j].piece, ends[j].t, x / members, y / members, INFINITY, error);
            }
        }
        if (members == 1 && status == DUCT_OK) {
            status = join_across(pieces, &ends[i], reach, error);
        }
    }
    duct_release(pieces->allocator, ends);
    return status;
}

duct_status duct_pieces_hold_ends(duct_pieces *pieces, double weight, duct_error *error)
{
    duct_status status = DUCT_OK;
    for (size_t p = 0; p < pieces->count && status == DUCT_OK; p++) {
        const duct_piece *piece = &pieces->items[p];
        for (size_t end = 0; end < 2 && !piece->curve.closed && status == DUCT_OK; end++) {
            bool held = false;
            for (size_t c = 0; c < piece->constraint_count; c++) {
                held = held || piece->constraints[c].t == (double)end;
            }
            size_t at = end == 0 ? 0 : piece->curve.count - 1;
            if (!held) {
                status =
                    constrain(pieces, p, (double)end, piece->curve.x[at], piece->curve.y[at], weight, error);
            }
        }
    }
    return status;
}

duct_status duct_pieces_pin(duct_pieces *pieces, const duct_drawing *drawing, const duct_stroke_list *pins,
                            double weight, duct_error *error)
{
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < pins->count && pieces->count > 0 && status == DUCT_OK; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, pins->items[i]);
        size_t size = duct_stroke_size(stroke), best = 0;
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        if (size == 0) {
            continue;
        }
        double box[4] = {x[0], y[0], x[0], y[0]};
        for (size_t k = 1; k < size; k++) {
            box[0] = fmin(box[0], x[k]);
            box[1] = fmin(box[1], y[k]);
            box[2] = fmax(box[2], x[k]);
            box[3] = fmax(box[3], y[k]);
        }
        double at_x = 0.5 * (box[0] + box[2]), at_y = 0.5 * (box[1] + box[3]), least = INFINITY, where = 0;
        for (size_t p = 0; p < pieces->count; p++) {
            double distance, t = nearest(&pieces->items[p].curve, at_x, at_y, &distance);
            if (distance < least) {
                least = distance;
                best = p;
                where = t;
            }
        }
        status = constrain(pieces, best, where, at_x, at_y, weight, error);
    }
    return status;
}
