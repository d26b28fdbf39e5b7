/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "paths.h"

#include "failure.h"

#include <string.h>

static const double flatten_tolerance = 0.05;

/* GIMP's strokes are triplets: the control before a node, the node, and the control behind it. */
struct triplets {
    const double *values; /* 6 a node */
    size_t nodes;
    bool closed;
};

static void add_curve(duct_path *path, const double *from, const double *to)
{
    const double *a = from + 2, *control_a = from + 4, *control_b = to, *b = to + 2;
    if (memcmp(a, control_a, 2 * sizeof *a) == 0 && memcmp(b, control_b, 2 * sizeof *b) == 0) {
        duct_path_line(path, b[0], b[1]);
    } else {
        duct_path_cubic(path, control_a[0], control_a[1], control_b[0], control_b[1], b[0], b[1]);
    }
}

static void add_triplets(duct_path *path, const struct triplets *stroke)
{
    duct_path_move(path, stroke->values[2], stroke->values[3]);
    for (size_t i = 1; i < stroke->nodes; i++) {
        add_curve(path, stroke->values + 6 * (i - 1), stroke->values + 6 * i);
    }
    if (stroke->closed && stroke->nodes > 1) {
        add_curve(path, stroke->values + 6 * (stroke->nodes - 1), stroke->values);
        duct_path_close(path);
    }
}

static void read_strokes(gint32 vectors, duct_path *path)
{
    int count = 0;
    int *strokes = gimp_vectors_get_strokes(vectors, &count);
    for (int i = 0; i < count; i++) {
        int numbers = 0;
        double *points = NULL;
        gboolean closed = FALSE;
        GimpVectorsStrokeType type =
            gimp_vectors_stroke_get_points(vectors, strokes[i], &numbers, &points, &closed);
        if (type == GIMP_VECTORS_STROKE_TYPE_BEZIER && numbers >= 6) {
            const struct triplets stroke = {points, (size_t)numbers / 6, closed != FALSE};
            add_triplets(path, &stroke);
        }
        g_free(points);
    }
    g_free(strokes);
}

duct_status plug_paths_read(gint32 vectors, const char *name, duct_drawing *drawing, duct_error *error)
{
    duct_path *path = NULL;
    duct_status status = duct_path_new(NULL, &path, error);
    if (status != DUCT_OK) {
        return status;
    }
    char *own = name != NULL ? g_strdup(name) : gimp_item_get_name(vectors);
    size_t first = duct_drawing_stroke_count(drawing);
    read_strokes(vectors, path);
    status = duct_path_flatten(path, own != NULL ? own : "", flatten_tolerance, drawing, error);
    if (status != DUCT_OK && status != DUCT_NO_MEMORY) {
        char *said = g_strdup(error->message);
        plug_fail(error, status, "the path '%.80s': %s", own != NULL ? own : "", said);
        g_free(said);
    }
    for (size_t i = first; status == DUCT_OK && i < duct_drawing_stroke_count(drawing); i++) {
        status = duct_stroke_set_group(duct_drawing_edit_stroke(drawing, i), own != NULL ? own : "", error);
    }
    g_free(own);
    duct_path_free(path);
    return status;
}

/* A growing list of triplets for one subpath. */
struct writer {
    GArray *values; /* double */
    bool closed;
};

static void node(struct writer *to, double in_x, double in_y, double x, double y)
{
    const double six[6] = {in_x, in_y, x, y, x, y};
    g_array_append_vals(to->values, six, 6);
}

static void turn_last_out(struct writer *to, double x, double y)
{
    double *last = (double *)(void *)to->values->data + to->values->len - 6;
    last[4] = x;
    last[5] = y;
}

/* The node that closes a line lies on its first one, which takes over what leads there. */
static void join_ends(struct writer *to)
{
    double *first = (double *)(void *)to->values->data;
    double *last = first + to->values->len - 6;
    to->closed = true;
    if (to->values->len >= 12 && first[2] == last[2] && first[3] == last[3]) {
        first[0] = last[0];
        first[1] = last[1];
        g_array_set_size(to->values, to->values->len - 6);
    }
}

static void collect(struct writer *to, const duct_path *path)
{
    size_t verb_count = 0, point_count = 0;
    const unsigned char *verbs = duct_path_verbs(path, &verb_count);
    const double *at = duct_path_points(path, &point_count);
    for (size_t i = 0; i < verb_count; i++) {
        switch ((duct_path_verb)verbs[i]) {
        case DUCT_PATH_MOVE:
        case DUCT_PATH_LINE:
            node(to, at[0], at[1], at[0], at[1]);
            at += 2;
            break;
        case DUCT_PATH_CUBIC:
            turn_last_out(to, at[0], at[1]);
            node(to, at[2], at[3], at[4], at[5]);
            at += 6;
            break;
        case DUCT_PATH_CLOSE:
            join_ends(to);
            break;
        }
    }
}

static duct_status add_stroke(gint32 vectors, const duct_stroke *stroke, double tolerance, duct_path *path,
                              duct_error *error)
{
    duct_path_clear(path);
    duct_status status = duct_path_fit(path, stroke, tolerance, error);
    if (status != DUCT_OK || duct_path_nodes(path) == 0) {
        return status;
    }
    struct writer to = {g_array_new(FALSE, FALSE, sizeof(double)), false};
    collect(&to, path);
    int id =
        gimp_vectors_stroke_new_from_points(vectors, GIMP_VECTORS_STROKE_TYPE_BEZIER, (int)to.values->len,
                                            (const double *)(void *)to.values->data, to.closed);
    g_array_free(to.values, TRUE);
    return id >= 0 ? DUCT_OK : plug_fail_gimp(error, "make a path of a stroke");
}

static gint32 vectors_of_group(gint32 image, const char *group, const char *suffix, GHashTable *by_group,
                               GArray *made)
{
    void *known = g_hash_table_lookup(by_group, group);
    if (known != NULL) {
        return GPOINTER_TO_INT(known);
    }
    char *name = g_strdup_printf("%s%s%s", group, *group != '\0' ? ": " : "", suffix);
    gint32 vectors = gimp_vectors_new(image, name);
    g_free(name);
    if (vectors > 0) {
        g_hash_table_insert(by_group, g_strdup(group), GINT_TO_POINTER(vectors));
        g_array_append_val(made, vectors);
    }
    return vectors;
}

duct_status plug_paths_make(gint32 image, const duct_drawing *drawing, const char *suffix, double tolerance,
                            GArray **made, duct_error *error)
{
    GHashTable *by_group = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    GArray *list = g_array_new(FALSE, FALSE, sizeof(gint32));
    duct_path *path = NULL;
    duct_status status = duct_path_new(NULL, &path, error);
    for (size_t i = 0; status == DUCT_OK && i < duct_drawing_stroke_count(drawing); i++) {
        const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
        gint32 vectors = vectors_of_group(image, duct_stroke_group(stroke), suffix, by_group, list);
        status = vectors > 0 ? add_stroke(vectors, stroke, tolerance, path, error)
                             : plug_fail_gimp(error, "make a path");
    }
    duct_path_free(path);
    g_hash_table_destroy(by_group);
    if (status != DUCT_OK) {
        for (guint i = 0; i < list->len; i++) {
            gimp_item_delete(g_array_index(list, gint32, i));
        }
        g_array_free(list, TRUE);
        return status;
    }
    *made = list;
    return DUCT_OK;
}
