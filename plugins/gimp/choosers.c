/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "choosers.h"

#include "brushes.h"
#include "pictures.h"

#include <ductus/library.h>

#include <string.h>

enum { COLUMN_PICTURE, COLUMN_LABEL, COLUMN_VALUE, COLUMN_FILE, COLUMNS };

/* What is to be drawn for a row: a hand's recording, a brush's picture. */
typedef GdkPixbuf *(*picture_maker)(const char *file, const char *value);

struct chooser {
    plug_chosen chosen;
    void *user;
    const char *title, *patterns; /* of the file dialog */
    picture_maker picture;
    GtkWidget *row, *combo;
    GtkTreeStore *store;
    GArray *waiting; /* GtkTreeIter of rows without their picture */
    guint idle;
    bool setting;
};

static void combo_changed(GtkComboBox *combo, struct chooser *chooser)
{
    GtkTreeIter row;
    char *value = NULL;
    if (chooser->setting || !gtk_combo_box_get_active_iter(combo, &row)) {
        return;
    }
    gtk_tree_model_get(GTK_TREE_MODEL(chooser->store), &row, COLUMN_VALUE, &value, -1);
    if (value != NULL) {
        chooser->chosen(value, chooser->user);
    }
    g_free(value);
}

/* One picture at a time, so that the dialog does not wait for them. */
static gboolean make_picture(void *user)
{
    struct chooser *chooser = user;
    if (chooser->waiting->len == 0) {
        chooser->idle = 0;
        return FALSE;
    }
    GtkTreeIter row = g_array_index(chooser->waiting, GtkTreeIter, 0);
    g_array_remove_index(chooser->waiting, 0);
    char *file = NULL, *value = NULL;
    gtk_tree_model_get(GTK_TREE_MODEL(chooser->store), &row, COLUMN_FILE, &file, COLUMN_VALUE, &value, -1);
    GdkPixbuf *picture = chooser->picture(file, value);
    if (picture != NULL) {
        gtk_tree_store_set(chooser->store, &row, COLUMN_PICTURE, picture, -1);
        g_object_unref(picture);
    }
    g_free(file);
    g_free(value);
    return TRUE;
}

static void add(struct chooser *chooser, GtkTreeIter *parent, const char *label, const char *value,
                const char *file)
{
    GtkTreeIter row;
    GdkPixbuf *blank = plug_picture_blank();
    gtk_tree_store_append(chooser->store, &row, parent);
    gtk_tree_store_set(chooser->store, &row, COLUMN_PICTURE, blank, COLUMN_LABEL, label, COLUMN_VALUE, value,
                       COLUMN_FILE, file, -1);
    g_object_unref(blank);
    g_array_append_val(chooser->waiting, row);
}

static void add_filter(GtkFileChooser *dialog, const char *patterns)
{
    GtkFileFilter *filter = gtk_file_filter_new();
    char **list = g_strsplit(patterns, " ", -1);
    for (char **pattern = list; *pattern != NULL; pattern++) {
        gtk_file_filter_add_pattern(filter, *pattern);
    }
    g_strfreev(list);
    gtk_file_filter_set_name(filter, patterns);
    gtk_file_chooser_add_filter(dialog, filter);
}

static void choose_file(GtkButton *button, struct chooser *chooser)
{
    GtkWidget *top = gtk_widget_get_toplevel(GTK_WIDGET(button));
    GtkWidget *dialog = gtk_file_chooser_dialog_new(
        chooser->title, GTK_WINDOW(top), GTK_FILE_CHOOSER_ACTION_OPEN, GTK_STOCK_CANCEL, GTK_RESPONSE_CANCEL,
        GTK_STOCK_OPEN, GTK_RESPONSE_OK, NULL);
    add_filter(GTK_FILE_CHOOSER(dialog), chooser->patterns);
    if (gtk_dialog_run(GTK_DIALOG(dialog)) == GTK_RESPONSE_OK) {
        char *path = gtk_file_chooser_get_filename(GTK_FILE_CHOOSER(dialog));
        plug_chooser_set(chooser, path);
        chooser->chosen(path, chooser->user);
        g_free(path);
    }
    gtk_widget_destroy(dialog);
}

static void make_widget(struct chooser *chooser)
{
    GtkWidget *button = gtk_button_new();
    GtkCellRenderer *picture = gtk_cell_renderer_pixbuf_new(), *label = gtk_cell_renderer_text_new();
    chooser->row = gtk_hbox_new(FALSE, 6);
    chooser->store =
        gtk_tree_store_new(COLUMNS, GDK_TYPE_PIXBUF, G_TYPE_STRING, G_TYPE_STRING, G_TYPE_STRING);
    chooser->combo = gtk_combo_box_new_with_model(GTK_TREE_MODEL(chooser->store));
    gtk_cell_layout_pack_start(GTK_CELL_LAYOUT(chooser->combo), picture, FALSE);
    gtk_cell_layout_add_attribute(GTK_CELL_LAYOUT(chooser->combo), picture, "pixbuf", COLUMN_PICTURE);
    gtk_cell_layout_pack_start(GTK_CELL_LAYOUT(chooser->combo), label, TRUE);
    gtk_cell_layout_add_attribute(GTK_CELL_LAYOUT(chooser->combo), label, "text", COLUMN_LABEL);
    gtk_button_set_image(GTK_BUTTON(button), gtk_image_new_from_stock(GTK_STOCK_OPEN, GTK_ICON_SIZE_MENU));
    gtk_widget_set_tooltip_text(button, chooser->title);
    gtk_box_pack_start(GTK_BOX(chooser->row), chooser->combo, TRUE, TRUE, 0);
    gtk_box_pack_start(GTK_BOX(chooser->row), button, FALSE, FALSE, 0);
    g_signal_connect(chooser->combo, "changed", G_CALLBACK(combo_changed), chooser);
    g_signal_connect(button, "clicked", G_CALLBACK(choose_file), chooser);
}

static struct chooser *new_chooser(plug_chosen chosen, void *user, picture_maker picture, const char *title,
                                   const char *patterns)
{
    struct chooser *chooser = g_new0(struct chooser, 1);
    chooser->chosen = chosen;
    chooser->user = user;
    chooser->picture = picture;
    chooser->title = title;
    chooser->patterns = patterns;
    chooser->waiting = g_array_new(FALSE, FALSE, sizeof(GtkTreeIter));
    make_widget(chooser);
    return chooser;
}

struct chooser *plug_hand_chooser_new(plug_chosen chosen, void *user)
{
    struct chooser *chooser = new_chooser(chosen, user, plug_picture_of_hand, "A recording as the hand",
                                          "*.inkml *.cyn *.csv *.svc *.xopp *.json *.dat");
    duct_hand *hands = NULL;
    size_t count = 0;
    duct_error error;
    if (duct_library_list(NULL, &hands, &count, &error) == DUCT_OK) {
        for (size_t i = 0; i < count; i++) {
            add(chooser, NULL, hands[i].name, hands[i].name, hands[i].path);
        }
        duct_hands_free(NULL, hands, count);
    }
    chooser->idle = g_idle_add_full(G_PRIORITY_LOW, make_picture, chooser, NULL);
    return chooser;
}

struct chooser *plug_brush_chooser_new(plug_chosen chosen, void *user)
{
    struct chooser *chooser =
        new_chooser(chosen, user, plug_picture_of_brush, "A MyPaint brush file", "*.myb");
    GArray *brushes = plug_brushes_list();
    GtkTreeIter parent;
    const char *group = "";
    for (guint i = 0; i < brushes->len; i++) {
        const plug_brush *brush = &g_array_index(brushes, plug_brush, i);
        /* Ductus's own stand in the list itself, those of others in a menu for each of their folders. */
        bool own = strchr(brush->value, '/') == NULL;
        if (!own && strcmp(group, brush->group) != 0) {
            group = brush->group;
            gtk_tree_store_append(chooser->store, &parent, NULL);
            gtk_tree_store_set(chooser->store, &parent, COLUMN_LABEL, group, -1);
        }
        add(chooser, own ? NULL : &parent, brush->label, brush->value, brush->picture);
    }
    g_array_free(brushes, TRUE);
    chooser->idle = g_idle_add_full(G_PRIORITY_LOW, make_picture, chooser, NULL);
    return chooser;
}

void plug_chooser_free(struct chooser *chooser)
{
    if (chooser == NULL) {
        return;
    }
    if (chooser->idle != 0) {
        g_source_remove(chooser->idle);
    }
    g_array_free(chooser->waiting, TRUE);
    g_object_unref(chooser->store);
    g_free(chooser);
}

GtkWidget *plug_chooser_widget(struct chooser *chooser)
{
    return chooser->row;
}

struct search {
    const char *value;
    GtkTreeIter found;
    bool done;
};

static gboolean compare(GtkTreeModel *model, GtkTreePath *path, GtkTreeIter *row, void *user)
{
    struct search *search = user;
    char *value = NULL;
    (void)path;
    gtk_tree_model_get(model, row, COLUMN_VALUE, &value, -1);
    if (value != NULL && strcmp(value, search->value) == 0) {
        search->found = *row;
        search->done = true;
    }
    g_free(value);
    return search->done;
}

void plug_chooser_set(struct chooser *chooser, const char *value)
{
    struct search search = {value, {0}, false};
    chooser->setting = true;
    gtk_tree_model_foreach(GTK_TREE_MODEL(chooser->store), compare, &search);
    if (!search.done && *value != '\0') {
        char *label = g_path_get_basename(value);
        add(chooser, NULL, label, value, value);
        g_free(label);
        gtk_tree_model_foreach(GTK_TREE_MODEL(chooser->store), compare, &search);
        if (chooser->idle == 0) {
            chooser->idle = g_idle_add_full(G_PRIORITY_LOW, make_picture, chooser, NULL);
        }
    }
    if (search.done) {
        gtk_combo_box_set_active_iter(GTK_COMBO_BOX(chooser->combo), &search.found);
    }
    chooser->setting = false;
}
