/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "brushes.h"

#include <libgimp/gimp.h>

#include <string.h>

static void clear_brush(void *memory)
{
    plug_brush *brush = memory;
    g_free(brush->value);
    g_free(brush->group);
    g_free(brush->label);
    g_free(brush->picture);
}

static int compare(const void *a, const void *b)
{
    const plug_brush *one = a, *other = b;
    int order = g_utf8_collate(one->group, other->group);
    return order != 0 ? order : g_utf8_collate(one->label, other->label);
}

/* Where MyPaint brushes lie: as GIMP is set up, and, where it does not say, the usual places. */
static char **folders(void)
{
    char *path = gimp_gimprc_query("mypaint-brush-path");
    if (path == NULL || *path == '\0') {
        g_free(path);
        path = g_strdup("/usr/share/mypaint-data/2.0/brushes" G_SEARCHPATH_SEPARATOR_S
                        "/usr/share/mypaint-data/1.0/brushes" G_SEARCHPATH_SEPARATOR_S "~/.mypaint/brushes");
    }
    char *expanded = gimp_config_path_expand(path, TRUE, NULL);
    char **list = g_strsplit(expanded != NULL ? expanded : path, G_SEARCHPATH_SEPARATOR_S, -1);
    g_free(expanded);
    g_free(path);
    for (char **folder = list; *folder != NULL; folder++) {
        if (g_str_has_prefix(*folder, "~/")) {
            char *whole = g_build_filename(g_get_home_dir(), *folder + 2, NULL);
            g_free(*folder);
            *folder = whole;
        }
    }
    return list;
}

static bool known(const GArray *list, const char *value)
{
    for (guint i = 0; i < list->len; i++) {
        if (strcmp(g_array_index(list, plug_brush, i).value, value) == 0) {
            return true;
        }
    }
    return false;
}

static void add_file(GArray *list, const char *folder, const char *group, const char *file)
{
    if (!g_str_has_suffix(file, ".myb")) {
        return;
    }
    char *label = g_strndup(file, strlen(file) - strlen(".myb"));
    char *value = g_strdup_printf("%s/%s", group, label);
    if (known(list, value)) {
        g_free(label);
        g_free(value);
        return;
    }
    char *picture = g_strdup_printf("%s/%s/%s_prev.png", folder, group, label);
    plug_brush brush = {value, g_strdup(group), label, picture};
    g_array_append_val(list, brush);
}

static void add_folder(GArray *list, const char *folder)
{
    GDir *groups = g_dir_open(folder, 0, NULL);
    for (const char *group; groups != NULL && (group = g_dir_read_name(groups)) != NULL;) {
        char *path = g_build_filename(folder, group, NULL);
        GDir *files = g_dir_open(path, 0, NULL);
        for (const char *file; files != NULL && (file = g_dir_read_name(files)) != NULL;) {
            add_file(list, folder, group, file);
        }
        if (files != NULL) {
            g_dir_close(files);
        }
        g_free(path);
    }
    if (groups != NULL) {
        g_dir_close(groups);
    }
}

static void add_own(GArray *list)
{
    char **names = NULL;
    size_t count = 0;
    duct_error error;
    if (duct_brush_list(NULL, &names, &count, &error) != DUCT_OK) {
        return;
    }
    for (size_t i = 0; i < count; i++) {
        plug_brush brush = {g_strdup(names[i]), g_strdup("Ductus"), g_strdup(names[i]), NULL};
        g_array_append_val(list, brush);
        duct_memory_free(NULL, names[i]);
    }
    duct_memory_free(NULL, names);
}

GArray *plug_brushes_list(void)
{
    GArray *list = g_array_new(FALSE, FALSE, sizeof(plug_brush));
    g_array_set_clear_func(list, clear_brush);
    add_own(list);
    guint own = list->len;
    char **all = folders();
    for (char **folder = all; *folder != NULL; folder++) {
        add_folder(list, *folder);
    }
    g_strfreev(all);
    if (list->len > own) {
        qsort(&g_array_index(list, plug_brush, own), list->len - own, sizeof(plug_brush), compare);
    }
    return list;
}

/* The file of the MyPaint brush folder/name; NULL where there is none. */
static char *find(const char *value)
{
    char *found = NULL;
    char **all = folders();
    for (char **folder = all; *folder != NULL && found == NULL; folder++) {
        char *path = g_strdup_printf("%s/%s.myb", *folder, value);
        if (g_file_test(path, G_FILE_TEST_IS_REGULAR)) {
            found = g_steal_pointer(&path);
        }
        g_free(path);
    }
    g_strfreev(all);
    return found;
}

duct_status plug_brush_load(const char *value, duct_brush **brush, duct_error *error)
{
    bool path = g_path_is_absolute(value) || g_str_has_suffix(value, ".myb");
    char *file = !path && strchr(value, '/') != NULL ? find(value) : NULL;
    duct_status status = duct_brush_load(NULL, file != NULL ? file : value, brush, error);
    g_free(file);
    return status;
}
