/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "geometry/path.h"

#include "base/error.h"
#include "base/memory.h"

void duct_path_init(duct_path *path, const duct_allocator *allocator)
{
    *path = (duct_path){.allocator = allocator};
}

void duct_path_done(duct_path *path)
{
    if (path->allocator != NULL) {
        duct_release(path->allocator, path->verbs);
        duct_release(path->allocator, path->points);
    }
    *path = (duct_path){.allocator = path->allocator};
}

/* Room for the verb and its points first, so that a path never holds half a step. */
static void append(duct_path *path, duct_path_verb verb, const double *xy, size_t points)
{
    if (path->failed) {
        return;
    }
    void *verbs = path->verbs, *values = path->points;
    bool room = duct_reserve(path->allocator, &verbs, &path->verb_capacity, path->verb_count + 1, 1);
    path->verbs = verbs;
    if (room && points > 0) {
        room = duct_reserve(path->allocator, &values, &path->point_capacity, path->point_count + points,
                            2 * sizeof(double));
        path->points = values;
    }
    if (!room) {
        path->failed = true;
        return;
    }
    path->verbs[path->verb_count++] = (unsigned char)verb;
    for (size_t i = 0; i < 2 * points; i++) {
        path->points[2 * path->point_count + i] = xy[i];
    }
    path->point_count += points;
}

duct_status duct_path_new(const duct_context *context, duct_path **path, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_path *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    duct_path_init(made, allocator);
    *path = made;
    return DUCT_OK;
}

void duct_path_free(duct_path *path)
{
    if (path != NULL) {
        const duct_allocator *allocator = path->allocator;
        duct_path_done(path);
        duct_release(allocator, path);
    }
}

void duct_path_clear(duct_path *path)
{
    path->verb_count = path->point_count = 0;
    path->failed = false;
}

void duct_path_move(duct_path *path, double x, double y)
{
    path->start[0] = x;
    path->start[1] = y;
    append(path, DUCT_PATH_MOVE, (double[]){x, y}, 1);
}

/* Whatever is drawn without a move begins at (x, y), or where the closed subpath before it began, as in SVG.
 */
static void begin(duct_path *path, double x, double y)
{
    if (path->verb_count == 0) {
        duct_path_move(path, x, y);
    } else if (path->verbs[path->verb_count - 1] == DUCT_PATH_CLOSE) {
        duct_path_move(path, path->start[0], path->start[1]);
    }
}

void duct_path_line(duct_path *path, double x, double y)
{
    begin(path, x, y);
    append(path, DUCT_PATH_LINE, (double[]){x, y}, 1);
}

void duct_path_cubic(duct_path *path, double x1, double y1, double x2, double y2, double x, double y)
{
    begin(path, x1, y1);
    append(path, DUCT_PATH_CUBIC, (double[]){x1, y1, x2, y2, x, y}, 3);
}

void duct_path_close(duct_path *path)
{
    if (path->verb_count > 0 && path->verbs[path->verb_count - 1] != DUCT_PATH_CLOSE) {
        append(path, DUCT_PATH_CLOSE, NULL, 0);
    }
}

const unsigned char *duct_path_verbs(const duct_path *path, size_t *count)
{
    *count = path->failed ? 0 : path->verb_count;
    return *count > 0 ? path->verbs : NULL;
}

const double *duct_path_points(const duct_path *path, size_t *count)
{
    *count = path->failed ? 0 : path->point_count;
    return *count > 0 ? path->points : NULL;
}

static size_t points_of(unsigned char verb)
{
    return verb == DUCT_PATH_CUBIC ? 3 : verb == DUCT_PATH_CLOSE ? 0 : 1;
}

void duct_path_text(const duct_path *path, int decimals, duct_text *text)
{
    static const char letters[] = {'M', 'L', 'C', 'Z'};
    const double *point = path->points;
    for (size_t i = 0; i < path->verb_count; i++) {
        const char step[3] = {i > 0 ? ' ' : letters[path->verbs[i]], i > 0 ? letters[path->verbs[i]] : '\0',
                              '\0'};
        duct_text_add(text, step);
        for (size_t k = points_of(path->verbs[i]); k > 0; k--, point += 2) {
            duct_text_add(text, " ");
            duct_text_add_fixed(text, point[0], decimals);
            duct_text_add(text, ",");
            duct_text_add_fixed(text, point[1], decimals);
        }
    }
}

duct_status duct_path_svg(const duct_context *context, const duct_path *path, int decimals, char **text,
                          duct_error *error)
{
    duct_text made;
    duct_text_init(&made, duct_allocator_of(context));
    duct_path_text(path, decimals < 0 ? 0 : decimals > 15 ? 15 : decimals, &made);
    made.failed = made.failed || path->failed;
    size_t size;
    char *data = made.failed ? NULL : duct_text_take(&made, &size);
    duct_text_free(&made);
    if (data == NULL) {
        return duct_fail_memory(error);
    }
    *text = data;
    return DUCT_OK;
}

size_t duct_path_nodes(const duct_path *path)
{
    size_t nodes = 0, point = 0, start = 0;
    bool drawn = false;
    for (size_t i = 0; i < path->verb_count; i++) {
        if (path->verbs[i] == DUCT_PATH_MOVE) {
            start = point;
            drawn = false;
        } else if (path->verbs[i] == DUCT_PATH_CLOSE) {
            /* A last node that lies on the first one is shown as one. */
            const double *first = path->points + 2 * start, *last = path->points + 2 * (point - 1);
            nodes -= drawn &&
                     !(first[0] < last[0] || first[0] > last[0] || first[1] < last[1] || first[1] > last[1]);
            drawn = false;
            continue;
        } else {
            drawn = true;
        }
        nodes++;
        point += points_of(path->verbs[i]);
    }
    return nodes;
}
