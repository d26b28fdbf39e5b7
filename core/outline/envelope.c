/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "outline/outline_private.h"

#include <math.h>

/* Polygons that cover what a nib sweeps. Between two nibs that is their convex hull: parts of the two
 * ellipses and their two common tangents, one on each side. The hulls of a run of nibs that turns by little
 * and nowhere more tightly than the nib's own size are joined directly, side by side, into one simple
 * polygon; where that is not so a new run begins, with a whole nib at its beginning. A run is proved simple
 * by a linear test: its boundary is made of two chains that both go forward along the run and do not cross.
 */

static const double pi = 3.14159265358979323846;
static const double most_spread =
    1.9; /* radians, 109 degrees: the largest difference of directions within a run */
enum { MAX_ARC = 512, NEWTON_STEPS = 12 };

typedef struct {
    double x, y;
} vector;

/* The interval between two nibs: where the common tangents touch. */
typedef struct {
    duct_normal left, right;
    bool regular; /* it has exactly one tangent on each side */
} interval;

typedef struct {
    vector *points;
    size_t count, capacity;
} chain;

typedef struct {
    const duct_allocator *allocator;
    const duct_nib *nibs;
    double sagitta;
    chain left, right; /* both forward, without the caps */
    size_t first, last;
    interval begin, end;     /* the run's first and last interval */
    double least, most;      /* directions of the run's edges, relative to `direction` */
    vector direction;        /* of the run's first interval */
    const duct_nib *largest; /* the last nib of which all is covered by a polygon of its own; or NULL */
    duct_polygons *polygons;
    bool failed;
} envelope;

static void add(envelope *e, chain *c, double x, double y)
{
    void *points = c->points;
    if (!duct_reserve(e->allocator, &points, &c->capacity, c->count + 1, sizeof(vector))) {
        e->failed = true;
        return;
    }
    c->points = points;
    c->points[c->count++] = (vector){x, y};
}

/* The normal of the common tangent on one side (+1 left, -1 right, seen along the chord with y up): a root of
 * n . chord = support(a) - support(b), which Newton's method finds from the perpendicular. */
static bool common_tangent(const duct_nib *a, const duct_nib *b, double side, duct_normal *normal)
{
    double dx = b->x - a->x, dy = b->y - a->y;
    double angle = atan2(dy, dx) + side * pi / 2;
    for (int i = 0; i < NEWTON_STEPS; i++) {
        duct_normal n = {cos(angle), sin(angle)};
        double pa[2], pb[2];
        duct_nib_touch(a, n, pa);
        duct_nib_touch(b, n, pb);
        /* The derivative of a support point's reach along n is its component along the tangent. */
        double value = n.x * (pb[0] - pa[0]) + n.y * (pb[1] - pa[1]);
        double slope = -n.y * (pb[0] - pa[0]) + n.x * (pb[1] - pa[1]);
        if (slope * side >= 0) {
            return false;
        }
        double step = value / slope;
        angle -= fmin(fmax(step, -0.5), 0.5);
        if (fabs(step) < 1e-12) {
            *normal = (duct_normal){cos(angle), sin(angle)};
            return true;
        }
    }
    return false;
}

/* Bounds how much the support and its slope differ between two nibs, in any direction. */
static double difference(const duct_nib *a, const duct_nib *b)
{
    double size = fmax(fabs(a->major - b->major), fabs(a->minor - b->minor));
    double flat = fmax(a->major - a->minor, b->major - b->minor);
    double ratio = fmax(a->major / a->minor, b->major / b->minor);
    return (size + flat * fabs(sin(a->angle - b->angle))) * fmin(ratio, 4);
}

static interval measure(const duct_nib *a, const duct_nib *b)
{
    interval found = {{0, 0}, {0, 0}, false};
    double length = hypot(b->x - a->x, b->y - a->y);
    found.regular = length > 1e-9 && length > 1.1 * difference(a, b) &&
                    common_tangent(a, b, 1, &found.left) && common_tangent(a, b, -1, &found.right);
    return found;
}

/* The largest step of the ellipse's parameter whose chord is true to the sagitta: an integral part of a turn,
 * so that all polygons of one nib share their vertices. */
static double arc_step(const envelope *e, const duct_nib *nib)
{
    double share = fmin(e->sagitta / nib->major, 0.5);
    double count = ceil(pi / acos(1 - share));
    return 2 * pi / fmin(fmax(count, 8), MAX_ARC);
}

/* Adds the points of the nib's edge strictly between two normals, counterclockwise (side +1) or clockwise
 * (-1). */
static void add_arc(envelope *e, chain *c, const duct_nib *nib, duct_normal from, duct_normal to, double side)
{
    double step = arc_step(e, nib);
    double begin = duct_nib_parameter(nib, from), end = duct_nib_parameter(nib, to);
    if (side > 0 && end < begin) {
        end += 2 * pi;
    } else if (side < 0 && end > begin) {
        end -= 2 * pi;
    }
    double margin = 0.05;
    if (side > 0) {
        for (double k = ceil(begin / step + margin); k < end / step - margin; k += 1) {
            double p[2];
            duct_nib_point(nib, k * step, p);
            add(e, c, p[0], p[1]);
        }
    } else {
        for (double k = floor(begin / step - margin); k > end / step + margin; k -= 1) {
            double p[2];
            duct_nib_point(nib, k * step, p);
            add(e, c, p[0], p[1]);
        }
    }
}

static void add_touch(envelope *e, chain *c, const duct_nib *nib, duct_normal normal)
{
    double p[2];
    duct_nib_touch(nib, normal, p);
    add(e, c, p[0], p[1]);
}

/* Ends one edge of a side and begins the next at the nib between them. `side` is +1 on the right, where the
 * outer boundary goes counterclockwise, else -1. False, and nothing is added, where the inner side has no
 * room to do so. */
static bool join(envelope *e, chain *c, const duct_nib *nib, const duct_nib *next, duct_normal in,
                 duct_normal out, double side)
{
    double turn = side * (in.x * out.y - in.y * out.x);
    if (turn >= 0) {
        double a[2], b[2];
        duct_nib_touch(nib, in, a);
        duct_nib_touch(nib, out, b);
        add(e, c, a[0], a[1]);
        if (hypot(b[0] - a[0], b[1] - a[1]) > 0.1 * e->sagitta) {
            add_arc(e, c, nib, in, out, side);
            add(e, c, b[0], b[1]);
        }
        return true;
    }
    vector from = c->points[c->count - 1];
    double a[2], b[2], d[2];
    duct_nib_touch(nib, in, a);
    duct_nib_touch(nib, out, b);
    duct_nib_touch(next, out, d);
    double ax = a[0] - from.x, ay = a[1] - from.y, bx = d[0] - b[0], by = d[1] - b[1];
    double cross = ax * by - ay * bx;
    double gx = b[0] - from.x, gy = b[1] - from.y;
    double t = (gx * by - gy * bx) / cross, u = (gx * ay - gy * ax) / cross;
    if (!(t > 1e-9 && t < 1 + 1e-9 && u > -1e-9 && u < 1 - 1e-9)) { /* also where cross is 0 */
        return false;
    }
    add(e, c, from.x + t * ax, from.y + t * ay);
    return true;
}

static double angle_from(vector direction, double x, double y)
{
    return atan2(direction.x * y - direction.y * x, direction.x * x + direction.y * y);
}

static bool monotone(const vector *points, size_t count, vector d)
{
    for (size_t i = 1; i < count; i++) {
        if ((points[i].x - points[i - 1].x) * d.x + (points[i].y - points[i - 1].y) * d.y < 0) {
            return false;
        }
    }
    return true;
}

/* True where every vertex of the ring's lower chain (first..top) lies to the right of the upper one, seen
 * along d. */
static bool apart(const vector *lower, size_t lower_count, const vector *upper, size_t upper_count, vector d)
{
    size_t i = 0, k = 0;
    while (i + 1 < lower_count && k + 1 < upper_count) {
        /* Compare at the nearer of the two next vertices. */
        double si = lower[i + 1].x * d.x + lower[i + 1].y * d.y,
               sk = upper[k + 1].x * d.x + upper[k + 1].y * d.y;
        const vector *edge = si < sk ? upper + k : lower + i,
                     *point = si < sk ? lower + i + 1 : upper + k + 1;
        double cross = (edge[1].x - edge[0].x) * (point->y - edge[0].y) -
                       (edge[1].y - edge[0].y) * (point->x - edge[0].x);
        bool last = (i + 2 == lower_count && si <= sk) || (k + 2 == upper_count && sk <= si);
        if (!last && (si < sk ? cross > 0 : cross < 0)) {
            return false;
        }
        if (si < sk) {
            i++;
        } else {
            k++;
        }
    }
    return true;
}

/* Proves that the ring is simple: it goes forward along d from its rearmost to its foremost vertex and back
 * on the other side, and the way back stays on the left. `ring` is turned so that it begins at the rearmost
 * vertex. */
static bool simple_ring(vector *ring, size_t count, vector d, vector *scratch)
{
    size_t rear = 0, front = 0;
    for (size_t i = 1; i < count; i++) {
        double s = ring[i].x * d.x + ring[i].y * d.y;
        rear = s < ring[rear].x * d.x + ring[rear].y * d.y ? i : rear;
        front = s > ring[front].x * d.x + ring[front].y * d.y ? i : front;
    }
    for (size_t i = 0; i < count; i++) {
        scratch[i] = ring[(rear + i) % count];
    }
    size_t top = (front + count - rear) % count;
    for (size_t i = 0; i <= top; i++) {
        ring[i] = scratch[i];
    }
    /* The upper chain is stored forward behind the lower one; both have the rearmost and the foremost vertex.
     */
    vector *upper = ring + top + 1;
    size_t upper_count = count - top + 1;
    upper[0] = scratch[0];
    for (size_t i = 1; i < upper_count; i++) {
        upper[i] = scratch[count - i];
    }
    bool ok = monotone(ring, top + 1, d) && monotone(upper, upper_count, d) &&
              apart(ring, top + 1, upper, upper_count, d);
    for (size_t i = 0; i < count; i++) {
        ring[i] = scratch[i];
    }
    return ok;
}

static void emit(envelope *e, const vector *ring, size_t count)
{
    for (size_t i = 0; i < count && !e->failed; i++) {
        /* Vertices in the same place help nobody. */
        const vector *before = &ring[i > 0 ? i - 1 : count - 1];
        if (hypot(ring[i].x - before->x, ring[i].y - before->y) > 1e-3 * e->sagitta) {
            e->failed = !duct_polygons_add(e->allocator, e->polygons, ring[i].x, ring[i].y);
        }
    }
    e->failed = e->failed || !duct_polygons_end(e->allocator, e->polygons);
}

/* Direction k of those in which a nib is measured: spread as its vertices are, so that a flat one gets enough
 * at its ends. */
static duct_normal direction_of(const duct_nib *nib, double parameter)
{
    double u = cos(parameter) / nib->major, v = sin(parameter) / nib->minor;
    double norm = hypot(u, v);
    return (duct_normal){(u * nib->c - v * nib->s) / norm, (u * nib->s + v * nib->c) / norm};
}

static double reach(const duct_nib *nib, duct_normal n)
{
    return n.x * nib->x + n.y * nib->y + duct_nib_support(nib, n);
}

/* True where the inner nib lies within the outer one, as far as its polygon tells. */
static bool contains(const envelope *e, const duct_nib *outer, const duct_nib *inner)
{
    double apart = hypot(inner->x - outer->x, inner->y - outer->y);
    if (apart + inner->major <= outer->minor) {
        return true;
    }
    if (apart + inner->minor > outer->major) {
        return false;
    }
    double step = arc_step(e, outer);
    for (double t = 0; t < 2 * pi - 0.5 * step; t += step) {
        duct_normal n = direction_of(outer, t);
        if (reach(inner, n) > reach(outer, n)) {
            return false;
        }
    }
    return true;
}

/* The convex hull of two nibs in any position: at each direction the one that reaches further. A pen that
 * rests and presses gives many such pairs, most of them within the largest of their nibs. */
static void emit_hull(envelope *e, const duct_nib *a, const duct_nib *b)
{
    if (e->largest != NULL && contains(e, e->largest, a) && contains(e, e->largest, b)) {
        return;
    }
    const duct_nib *large = a->major >= b->major ? a : b;
    double step = fmin(arc_step(e, a), arc_step(e, b));
    bool of_a = false, of_b = false;
    chain ring = {0};
    for (double t = 0; t < 2 * pi - 0.5 * step && !e->failed; t += step) {
        duct_normal n = direction_of(large, t);
        bool further = reach(a, n) >= reach(b, n);
        of_a = of_a || further;
        of_b = of_b || !further;
        add_touch(e, &ring, further ? a : b, n);
    }
    if (!e->failed) {
        emit(e, ring.points, ring.count);
        e->largest = of_a && of_b ? e->largest : of_a ? a : b;
    }
    duct_release(e->allocator, ring.points);
}

/* Ends the run at its last nib: puts the caps on, and adds its polygon, or its hulls where that is not
 * simple. */
static void end_run(envelope *e)
{
    if (e->failed || e->last == e->first) {
        return;
    }
    const duct_nib *first = e->nibs + e->first, *last = e->nibs + e->last;
    add_touch(e, &e->right, last, e->end.right);
    add_touch(e, &e->left, last, e->end.left);
    chain ring = e->right;
    e->right = (chain){0};
    add_arc(e, &ring, last, e->end.right, e->end.left, 1);
    for (size_t i = e->left.count; i-- > 0 && !e->failed;) {
        add(e, &ring, e->left.points[i].x, e->left.points[i].y);
    }
    add_arc(e, &ring, first, e->begin.left, e->begin.right, 1);
    double middle = 0.5 * (e->least + e->most);
    vector d = {e->direction.x * cos(middle) - e->direction.y * sin(middle),
                e->direction.x * sin(middle) + e->direction.y * cos(middle)};
    size_t count = ring.count;
    /* Two more vertices for simple_ring(). */
    add(e, &ring, 0, 0);
    add(e, &ring, 0, 0);
    vector *scratch = duct_alloc(e->allocator, count + 2, sizeof *scratch);
    e->failed = e->failed || scratch == NULL;
    if (!e->failed && (e->last == e->first + 1 || simple_ring(ring.points, count, d, scratch))) {
        emit(e, ring.points, count);
    } else {
        for (size_t i = e->first; i < e->last && !e->failed; i++) {
            emit_hull(e, e->nibs + i, e->nibs + i + 1);
        }
    }
    duct_release(e->allocator, scratch);
    duct_release(e->allocator, e->right.points);
    e->right = ring; /* its memory is used again */
    e->right.count = e->left.count = 0;
    e->first = e->last;
}

static void begin_run(envelope *e, size_t first, const interval *one)
{
    const duct_nib *a = e->nibs + first, *b = a + 1;
    double length = hypot(b->x - a->x, b->y - a->y);
    e->first = first;
    e->last = first + 1;
    e->begin = e->end = *one;
    e->direction = (vector){(b->x - a->x) / length, (b->y - a->y) / length};
    double left = angle_from(e->direction, one->left.y, -one->left.x);
    double right = angle_from(e->direction, -one->right.y, one->right.x);
    e->least = fmin(left, right);
    e->most = fmax(left, right);
    e->left.count = e->right.count = 0;
    add_touch(e, &e->left, a, one->left);
    add_touch(e, &e->right, a, one->right);
}

/* Adds the next interval to the run; false where it cannot be part of it. */
static bool grow_run(envelope *e, const interval *next)
{
    const duct_nib *nib = e->nibs + e->last;
    double left = angle_from(e->direction, next->left.y, -next->left.x);
    double right = angle_from(e->direction, -next->right.y, next->right.x);
    double least = fmin(e->least, fmin(left, right)), most = fmax(e->most, fmax(left, right));
    if (most - least > most_spread) {
        return false;
    }
    size_t left_count = e->left.count, right_count = e->right.count;
    if (!join(e, &e->left, nib, nib + 1, e->end.left, next->left, -1) ||
        !join(e, &e->right, nib, nib + 1, e->end.right, next->right, 1)) {
        e->left.count = left_count;
        e->right.count = right_count;
        return false;
    }
    e->least = least;
    e->most = most;
    e->end = *next;
    e->last++;
    return true;
}

bool duct_envelope(const duct_allocator *allocator, const duct_nib_list *nibs, double sagitta, bool split,
                   duct_polygons *polygons)
{
    envelope e = {.allocator = allocator, .nibs = nibs->items, .sagitta = sagitta, .polygons = polygons};
    if (nibs->count == 1) {
        emit_hull(&e, nibs->items, nibs->items);
    }
    bool running = false;
    for (size_t i = 0; i + 1 < nibs->count && !e.failed; i++) {
        interval next = measure(nibs->items + i, nibs->items + i + 1);
        if (running && next.regular && !split && grow_run(&e, &next)) {
            continue;
        }
        if (running) {
            end_run(&e);
        }
        running = next.regular && !split;
        if (running) {
            begin_run(&e, i, &next);
        } else if (!e.failed) {
            emit_hull(&e, nibs->items + i, nibs->items + i + 1);
        }
    }
    if (running) {
        end_run(&e);
    }
    duct_release(allocator, e.left.points);
    duct_release(allocator, e.right.points);
    return !e.failed;
}
