/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "controls.h"

#include "choosers.h"

#include <libgimp/gimpui.h>

#include <math.h>
#include <string.h>

/* The control of one parameter. */
struct control {
    const duct_param *param;
    duct_settings *settings;
    struct controls *owner;
    GtkWidget *widget; /* with the value; the whole row but its label */
    GtkWidget *automatic;
    GtkAdjustment *number;
    struct chooser *chooser;
};

struct controls {
    struct job *job;
    plug_changed changed;
    void *user;
    GtkWidget *notebook;
    struct control *list;
    size_t count;
    bool showing; /* values are being set by us */
};

static void store(struct control *control, const char *text)
{
    duct_error passed_over; /* controls hold no values that the table forbids; half-typed ones wait */
    if (!control->owner->showing &&
        duct_settings_set(control->settings, control->param->id, text, &passed_over) == DUCT_OK) {
        control->owner->changed(control->owner->user);
    }
}

static void number_changed(GtkAdjustment *adjustment, struct control *control)
{
    char text[G_ASCII_DTOSTR_BUF_SIZE];
    /* A spin button shows a thousandth at most. */
    g_ascii_formatd(text, sizeof text, "%.10g", round(gtk_adjustment_get_value(adjustment) * 1000) / 1000);
    store(control, text);
}

static void automatic_changed(GtkToggleButton *button, struct control *control)
{
    bool automatic = gtk_toggle_button_get_active(button);
    gtk_widget_set_sensitive(control->widget, !automatic);
    if (automatic) {
        store(control, "auto");
    } else {
        number_changed(control->number, control);
    }
}

static void switch_changed(GtkToggleButton *button, struct control *control)
{
    store(control, gtk_toggle_button_get_active(button) ? "true" : "false");
}

static void choice_changed(GtkComboBox *combo, struct control *control)
{
    int index = gtk_combo_box_get_active(combo);
    if (index >= 0) {
        store(control, control->param->choices[index].id);
    }
}

static void text_changed(GtkEditable *entry, struct control *control)
{
    store(control, gtk_entry_get_text(GTK_ENTRY(entry)));
}

static void chosen(const char *value, void *user)
{
    store(user, value);
}

static void new_seed(GtkButton *button, GtkEntry *entry)
{
    (void)button;
    char text[32];
    g_snprintf(text, sizeof text, "%u", g_random_int());
    gtk_entry_set_text(entry, text);
}

/* Decimals that a step needs. */
static int digits_of(const duct_param *param)
{
    if (param->type == DUCT_PARAM_INT) {
        return 0;
    }
    return param->step >= 1 ? 1 : param->step >= 0.1 ? 2 : 3;
}

static bool is_short_range(const duct_param *param)
{
    return (param->maximum - param->minimum) / param->step <= 200;
}

/* A slider for short ranges, a field for long ones. */
static GtkWidget *make_number(struct control *control)
{
    const duct_param *param = control->param;
    control->number = GTK_ADJUSTMENT(
        gtk_adjustment_new(param->minimum, param->minimum, param->maximum, param->step, 10 * param->step, 0));
    GtkWidget *row = gtk_hbox_new(FALSE, 6);
    guint digits = (guint)digits_of(param);
    if (is_short_range(param) && param->type != DUCT_PARAM_AUTO) {
        GtkWidget *slider = gtk_hscale_new(control->number);
        gtk_scale_set_draw_value(GTK_SCALE(slider), FALSE);
        gtk_widget_set_size_request(slider, 120, -1);
        gtk_box_pack_start(GTK_BOX(row), slider, TRUE, TRUE, 0);
    }
    GtkWidget *field = gtk_spin_button_new(control->number, param->step, digits);
    gtk_entry_set_width_chars(GTK_ENTRY(field), 8);
    gtk_box_pack_start(GTK_BOX(row), field, FALSE, FALSE, 0);
    if (*param->unit != '\0') {
        gtk_box_pack_start(GTK_BOX(row), gtk_label_new(param->unit), FALSE, FALSE, 0);
    }
    g_signal_connect(control->number, "value-changed", G_CALLBACK(number_changed), control);
    return row;
}

static GtkWidget *make_automatic(struct control *control)
{
    GtkWidget *row = gtk_hbox_new(FALSE, 6);
    control->automatic = gtk_check_button_new_with_label("automatic");
    control->widget = make_number(control);
    gtk_box_pack_start(GTK_BOX(row), control->automatic, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(row), control->widget, FALSE, FALSE, 0);
    g_signal_connect(control->automatic, "toggled", G_CALLBACK(automatic_changed), control);
    return row;
}

static GtkWidget *make_choice(struct control *control)
{
    control->widget = gtk_combo_box_text_new();
    for (size_t i = 0; i < control->param->choice_count; i++) {
        gtk_combo_box_text_append_text(GTK_COMBO_BOX_TEXT(control->widget), control->param->choices[i].label);
    }
    g_signal_connect(control->widget, "changed", G_CALLBACK(choice_changed), control);
    return control->widget;
}

static GtkWidget *make_seed(struct control *control)
{
    GtkWidget *row = gtk_hbox_new(FALSE, 6), *button = gtk_button_new_with_label("New");
    control->widget = gtk_entry_new();
    gtk_entry_set_width_chars(GTK_ENTRY(control->widget), 14);
    gtk_box_pack_start(GTK_BOX(row), control->widget, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(row), button, FALSE, FALSE, 0);
    gtk_widget_set_tooltip_text(button, "Another seed, by chance.");
    g_signal_connect(control->widget, "changed", G_CALLBACK(text_changed), control);
    g_signal_connect(button, "clicked", G_CALLBACK(new_seed), control->widget);
    return row;
}

/* The row's widget, without label. */
static GtkWidget *make(struct control *control)
{
    switch (control->param->type) {
    case DUCT_PARAM_BOOL:
        control->widget = gtk_check_button_new_with_label(control->param->label);
        g_signal_connect(control->widget, "toggled", G_CALLBACK(switch_changed), control);
        return control->widget;
    case DUCT_PARAM_INT:
    case DUCT_PARAM_REAL:
        control->widget = make_number(control);
        return control->widget;
    case DUCT_PARAM_AUTO:
        return make_automatic(control);
    case DUCT_PARAM_CHOICE:
        return make_choice(control);
    case DUCT_PARAM_SEED:
        return make_seed(control);
    case DUCT_PARAM_HAND:
        control->chooser = plug_option_is_brush(control->param) ? plug_brush_chooser_new(chosen, control)
                                                                : plug_hand_chooser_new(chosen, control);
        control->widget = plug_chooser_widget(control->chooser);
        return control->widget;
    case DUCT_PARAM_STYLE:
    case DUCT_PARAM_STROKES:
        control->widget = gtk_entry_new();
        g_signal_connect(control->widget, "changed", G_CALLBACK(text_changed), control);
        return control->widget;
    }
    return gtk_label_new("");
}

/* The tooltip, and what each choice means. */
static char *tooltip_of(const duct_param *param)
{
    GString *text = g_string_new(param->tooltip);
    for (size_t i = 0; i < param->choice_count; i++) {
        if (*param->choices[i].tooltip != '\0') {
            g_string_append_printf(text, "\n%s: %s", param->choices[i].label, param->choices[i].tooltip);
        }
    }
    return g_string_free(text, FALSE);
}

static void add_row(GtkTable *table, struct control *control)
{
    guint row;
    row = GPOINTER_TO_UINT(g_object_get_data(G_OBJECT(table), "rows"));
    g_object_set_data(G_OBJECT(table), "rows", GUINT_TO_POINTER(row + 1));
    GtkWidget *widget = make(control);
    char *tooltip = tooltip_of(control->param);
    gtk_widget_set_tooltip_text(widget, tooltip);
    if (control->param->type == DUCT_PARAM_BOOL) {
        gtk_table_attach(table, widget, 0, 2, row, row + 1, GTK_FILL, GTK_FILL, 0, 0);
    } else {
        GtkWidget *label = gtk_label_new(control->param->label);
        gtk_misc_set_alignment(GTK_MISC(label), 0, 0.5F);
        gtk_widget_set_tooltip_text(label, tooltip);
        gtk_table_attach(table, label, 0, 1, row, row + 1, GTK_FILL, GTK_FILL, 0, 0);
        gtk_table_attach(table, widget, 1, 2, row, row + 1, GTK_EXPAND | GTK_FILL, GTK_FILL, 0, 0);
    }
    g_free(tooltip);
}

static GtkWidget *new_table(void)
{
    GtkWidget *table = gtk_table_new(1, 2, FALSE);
    gtk_table_set_row_spacings(GTK_TABLE(table), 6);
    gtk_table_set_col_spacings(GTK_TABLE(table), 8);
    return table;
}

/* The table of a group, made when it is first asked for: a frame on the first page for everyday parameters, a
 * page of its own for the others. */
static GtkTable *table_of(struct controls *controls, GHashTable *tables, GtkWidget *first,
                          const duct_param *param)
{
    char *key = g_strdup_printf("%d%s", param->advanced, param->group);
    GtkWidget *table = g_hash_table_lookup(tables, key);
    if (table != NULL) {
        g_free(key);
        return GTK_TABLE(table);
    }
    table = new_table();
    g_hash_table_insert(tables, key, table);
    if (!param->advanced) {
        GtkWidget *frame = gimp_frame_new(param->group);
        gtk_container_add(GTK_CONTAINER(frame), table);
        gtk_box_pack_start(GTK_BOX(first), frame, FALSE, FALSE, 0);
        return GTK_TABLE(table);
    }
    GtkWidget *page = gtk_scrolled_window_new(NULL, NULL), *inner = gtk_vbox_new(FALSE, 0);
    gtk_scrolled_window_set_policy(GTK_SCROLLED_WINDOW(page), GTK_POLICY_NEVER, GTK_POLICY_AUTOMATIC);
    gtk_container_set_border_width(GTK_CONTAINER(inner), 12);
    gtk_box_pack_start(GTK_BOX(inner), table, FALSE, FALSE, 0);
    gtk_scrolled_window_add_with_viewport(GTK_SCROLLED_WINDOW(page), inner);
    gtk_viewport_set_shadow_type(GTK_VIEWPORT(gtk_bin_get_child(GTK_BIN(page))), GTK_SHADOW_NONE);
    gtk_notebook_append_page(GTK_NOTEBOOK(controls->notebook), page, gtk_label_new(param->group));
    return GTK_TABLE(table);
}

static void add_table(struct controls *controls, duct_settings *settings, GHashTable *tables,
                      GtkWidget *first)
{
    const duct_operation *operation = duct_settings_operation(settings);
    for (size_t i = 0; i < operation->param_count; i++) {
        const duct_param *param = &operation->params[i];
        if (!plug_job_fixed(controls->job->variant, param)) {
            struct control *control = &controls->list[controls->count++];
            control->param = param;
            control->settings = settings;
            control->owner = controls;
            add_row(table_of(controls, tables, first, param), control);
        }
    }
}

struct controls *plug_controls_new(struct job *job, plug_changed changed, void *user)
{
    struct controls *controls = g_new0(struct controls, 1);
    GHashTable *tables = g_hash_table_new_full(g_str_hash, g_str_equal, g_free, NULL);
    GtkWidget *first = gtk_vbox_new(FALSE, 12);
    controls->job = job;
    controls->changed = changed;
    controls->user = user;
    controls->list = g_new0(struct control, job->operation->param_count + plug_options.param_count);
    controls->notebook = gtk_notebook_new();
    gtk_container_set_border_width(GTK_CONTAINER(first), 12);
    gtk_notebook_append_page(GTK_NOTEBOOK(controls->notebook), first, gtk_label_new("Main"));
    gtk_notebook_set_scrollable(GTK_NOTEBOOK(controls->notebook), TRUE);
    add_table(controls, job->settings, tables, first);
    add_table(controls, job->options, tables, first);
    g_hash_table_destroy(tables);
    plug_controls_show(controls);
    return controls;
}

void plug_controls_free(struct controls *controls)
{
    for (size_t i = 0; i < controls->count; i++) {
        plug_chooser_free(controls->list[i].chooser);
    }
    g_free(controls->list);
    g_free(controls);
}

GtkWidget *plug_controls_widget(struct controls *controls)
{
    return controls->notebook;
}

static void show_number(struct control *control, const char *text)
{
    bool automatic = strcmp(text, "auto") == 0;
    if (!automatic) {
        gtk_adjustment_set_value(control->number, g_ascii_strtod(text, NULL));
    } else {
        /* Something to start from, where "auto" is taken off. */
        gtk_adjustment_set_value(control->number, CLAMP(10 * control->param->step, control->param->minimum,
                                                        control->param->maximum));
    }
    if (control->automatic != NULL) {
        gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(control->automatic), automatic);
        gtk_widget_set_sensitive(control->widget, !automatic);
    }
}

static void show(struct control *control)
{
    const duct_param *param = control->param;
    const char *text = duct_settings_text(control->settings, param->id);
    switch (param->type) {
    case DUCT_PARAM_BOOL:
        gtk_toggle_button_set_active(GTK_TOGGLE_BUTTON(control->widget), strcmp(text, "true") == 0);
        break;
    case DUCT_PARAM_INT:
    case DUCT_PARAM_REAL:
    case DUCT_PARAM_AUTO:
        show_number(control, text);
        break;
    case DUCT_PARAM_CHOICE:
        for (size_t i = 0; i < param->choice_count; i++) {
            if (strcmp(text, param->choices[i].id) == 0) {
                gtk_combo_box_set_active(GTK_COMBO_BOX(control->widget), (int)i);
            }
        }
        break;
    case DUCT_PARAM_SEED:
    case DUCT_PARAM_STYLE:
    case DUCT_PARAM_STROKES:
        gtk_entry_set_text(GTK_ENTRY(control->widget), text);
        break;
    case DUCT_PARAM_HAND:
        plug_chooser_set(control->chooser, text);
        break;
    }
}

void plug_controls_show(struct controls *controls)
{
    controls->showing = true;
    for (size_t i = 0; i < controls->count; i++) {
        show(&controls->list[i]);
    }
    controls->showing = false;
}
