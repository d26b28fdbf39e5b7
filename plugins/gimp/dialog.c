/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "dialog.h"

#include "controls.h"
#include "help.h"
#include "preview.h"
#include "run.h"
#include "task.h"
#include "values.h"

#include <libgimp/gimpui.h>

#include <string.h>

enum { RESPONSE_RESET = 1 };

struct dialog {
    struct job *job;
    GtkWidget *window, *body, *presets, *bar, *message;
    struct preview *preview;
    struct controls *controls;
    bool setting;
    bool stop; /* the work was cancelled */
};

static bool same(const duct_settings *a, const duct_settings *b)
{
    const duct_operation *table = duct_settings_operation(a);
    for (size_t i = 0; i < table->param_count; i++) {
        const char *id = table->params[i].id;
        if (strcmp(duct_settings_text(a, id), duct_settings_text(b, id)) != 0) {
            return false;
        }
    }
    return true;
}

/* Shows the preset whose values are set, if there is one. */
static void show_preset(struct dialog *dialog)
{
    const duct_operation *operation = dialog->job->operation;
    int found = -1;
    for (size_t i = 0; i < operation->preset_count && found < 0; i++) {
        duct_error error;
        duct_settings *preset = plug_settings_copy(dialog->job->settings);
        if (preset != NULL && duct_settings_preset(preset, operation->presets[i].id, &error) == DUCT_OK &&
            same(preset, dialog->job->settings)) {
            found = (int)i;
        }
        duct_settings_free(preset);
    }
    dialog->setting = true;
    gtk_combo_box_set_active(GTK_COMBO_BOX(dialog->presets), found);
    dialog->setting = false;
}

static void values_changed(void *user)
{
    struct dialog *dialog = user;
    if (!dialog->setting && dialog->presets != NULL) {
        show_preset(dialog);
    }
    plug_preview_update(dialog->preview);
}

static void show_values(struct dialog *dialog)
{
    plug_controls_show(dialog->controls);
    plug_preview_update(dialog->preview);
}

static void preset_changed(GtkComboBox *combo, struct dialog *dialog)
{
    int index = gtk_combo_box_get_active(combo);
    duct_error cannot_fail;
    if (index >= 0 && !dialog->setting) {
        duct_settings_preset(dialog->job->settings, dialog->job->operation->presets[index].id, &cannot_fail);
        dialog->setting = true;
        show_values(dialog);
        dialog->setting = false;
    }
}

/* All values at their defaults; what has to be given, the first there is. */
static void reset(struct dialog *dialog)
{
    duct_error cannot_fail;
    struct job *job = dialog->job;
    duct_settings_preset(job->settings, "default", &cannot_fail);
    for (size_t i = 0; i < job->operation->param_count; i++) {
        const duct_param *param = &job->operation->params[i];
        duct_settings_set(job->settings, param->id, param->fallback, &cannot_fail);
    }
    for (size_t i = 0; i < plug_options.param_count; i++) {
        const duct_param *param = &plug_options.params[i];
        if (!plug_job_fixed(job->variant, param)) {
            duct_settings_set(job->options, param->id, param->fallback, &cannot_fail);
        }
    }
    plug_values_first(job);
    dialog->setting = true;
    show_values(dialog);
    dialog->setting = false;
    if (dialog->presets != NULL) {
        show_preset(dialog);
    }
}

static GtkWidget *make_presets(struct dialog *dialog)
{
    const duct_operation *operation = dialog->job->operation;
    GtkWidget *row = gtk_hbox_new(FALSE, 6);
    dialog->presets = gtk_combo_box_text_new();
    for (size_t i = 0; i < operation->preset_count; i++) {
        gtk_combo_box_text_append_text(GTK_COMBO_BOX_TEXT(dialog->presets), operation->presets[i].label);
    }
    gtk_widget_set_tooltip_text(dialog->presets, "Sets all values of the operation but the hand.");
    gtk_box_pack_start(GTK_BOX(row), gtk_label_new("Preset"), FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(row), dialog->presets, TRUE, TRUE, 0);
    g_signal_connect(dialog->presets, "changed", G_CALLBACK(preset_changed), dialog);
    show_preset(dialog);
    return row;
}

static void make_window(struct dialog *dialog)
{
    const struct job *job = dialog->job;
    dialog->window = gimp_dialog_new(job->operation->label, "ductus", NULL, 0, plug_help, job->operation->id,
                                     "_Reset", RESPONSE_RESET, GTK_STOCK_CANCEL, GTK_RESPONSE_CANCEL,
                                     GTK_STOCK_OK, GTK_RESPONSE_OK, NULL);
    gtk_dialog_set_alternative_button_order(GTK_DIALOG(dialog->window), GTK_RESPONSE_OK, RESPONSE_RESET,
                                            GTK_RESPONSE_CANCEL, -1);
    gtk_dialog_set_default_response(GTK_DIALOG(dialog->window), GTK_RESPONSE_OK);
    gimp_window_set_transient(GTK_WINDOW(dialog->window));
    GtkWidget *content = gtk_dialog_get_content_area(GTK_DIALOG(dialog->window));
    GtkWidget *right = gtk_vbox_new(FALSE, 6);
    dialog->body = gtk_hbox_new(FALSE, 12);
    dialog->bar = gtk_progress_bar_new();
    dialog->message = gtk_label_new("");
    gtk_label_set_line_wrap(GTK_LABEL(dialog->message), TRUE);
    gtk_container_set_border_width(GTK_CONTAINER(dialog->body), 12);
    gtk_box_pack_start(GTK_BOX(dialog->body), plug_preview_widget(dialog->preview), TRUE, TRUE, 0);
    if (job->operation->preset_count > 1) {
        gtk_box_pack_start(GTK_BOX(right), make_presets(dialog), FALSE, FALSE, 0);
    }
    gtk_box_pack_start(GTK_BOX(right), plug_controls_widget(dialog->controls), TRUE, TRUE, 0);
    gtk_box_pack_start(GTK_BOX(dialog->body), right, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(content), dialog->body, TRUE, TRUE, 0);
    gtk_box_pack_start(GTK_BOX(content), dialog->message, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(content), dialog->bar, FALSE, FALSE, 0);
    gtk_widget_show_all(dialog->window);
    /* Return is OK from the beginning. */
    gtk_widget_grab_focus(gtk_dialog_get_widget_for_response(GTK_DIALOG(dialog->window), GTK_RESPONSE_OK));
    gtk_widget_hide(dialog->message);
    gtk_widget_hide(dialog->bar);
}

/* While the work goes on, only Cancel answers. */
static void set_busy(struct dialog *dialog, bool busy)
{
    gtk_widget_set_sensitive(dialog->body, !busy);
    gtk_dialog_set_response_sensitive(GTK_DIALOG(dialog->window), GTK_RESPONSE_OK, !busy);
    gtk_dialog_set_response_sensitive(GTK_DIALOG(dialog->window), RESPONSE_RESET, !busy);
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(dialog->bar), 0);
    if (busy) {
        gtk_widget_show(dialog->bar);
        gtk_widget_hide(dialog->message);
    } else {
        gtk_widget_hide(dialog->bar);
    }
}

static void cancel_work(GtkDialog *window, int response, struct dialog *dialog)
{
    (void)window;
    (void)response;
    dialog->stop = true;
}

/* Closing the window then is no more than cancelling. */
static gboolean keep_window(GtkWidget *window, GdkEvent *event, struct dialog *dialog)
{
    (void)window;
    (void)event;
    dialog->stop = true;
    return TRUE;
}

static bool go_on(void *user, double fraction)
{
    struct dialog *dialog = user;
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(dialog->bar), fraction);
    while (gtk_events_pending()) {
        gtk_main_iteration();
    }
    return !dialog->stop;
}

static gboolean work_ended(void *task)
{
    *(bool *)((struct task *)task)->user = true;
    return FALSE;
}

/* Runs the task to its end while the window answers. */
static void run_task(struct dialog *dialog, struct task *task)
{
    bool ended = false;
    task->ended = work_ended;
    task->user = &ended;
    plug_task_start(task);
    while (!ended) {
        while (gtk_events_pending()) {
            gtk_main_iteration();
        }
        if (dialog->stop) {
            plug_task_stop(task);
        }
        gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(dialog->bar), 0.9 * plug_task_progress(task));
        g_usleep(10000);
    }
    plug_task_wait(task);
}

static bool commit_progress(void *user, double fraction)
{
    return go_on(user, 0.9 + 0.1 * fraction);
}

static duct_status do_work(struct dialog *dialog, struct task *task, struct result *result, duct_error *error)
{
    duct_brush *brush = NULL;
    struct lines lines = {0};
    duct_status status = plug_result_check(dialog->job, error);
    if (status == DUCT_OK) {
        status = plug_run_prepare(dialog->job, &task->work, &brush, error);
    }
    if (status == DUCT_OK) {
        status = plug_lines_open(dialog->job, go_on, dialog, &lines, error);
    }
    if (status == DUCT_OK) {
        task->lines = &lines;
        task->settings = plug_settings_copy(dialog->job->settings);
        run_task(dialog, task);
        status = task->status;
        *error = task->error;
    }
    if (status == DUCT_OK) {
        duct_context context = duct_context_default();
        context.progress = commit_progress;
        context.progress_user = dialog;
        status = plug_result_commit(dialog->job, &context, &task->work, result, error);
    }
    plug_lines_close(&lines);
    duct_brush_free(brush);
    return status;
}

/* The job itself, from the dialog's values. */
static duct_status work(struct dialog *dialog, struct result *result, duct_error *error)
{
    struct task *task = g_new0(struct task, 1);
    dialog->stop = false;
    plug_preview_pause(dialog->preview);
    set_busy(dialog, true);
    gulong handler = g_signal_connect(dialog->window, "response", G_CALLBACK(cancel_work), dialog);
    gulong closing = g_signal_connect(dialog->window, "delete-event", G_CALLBACK(keep_window), dialog);
    duct_status status = do_work(dialog, task, result, error);
    g_signal_handler_disconnect(dialog->window, handler);
    g_signal_handler_disconnect(dialog->window, closing);
    set_busy(dialog, false);
    plug_task_free(task);
    return status;
}

static void tell(struct dialog *dialog, const duct_error *error)
{
    char *text = g_markup_printf_escaped("<b>%s.</b>", error->message);
    gtk_label_set_markup(GTK_LABEL(dialog->message), text);
    gtk_widget_show(dialog->message);
    g_free(text);
    plug_preview_update(dialog->preview);
}

static duct_status converse(struct dialog *dialog, struct result *result, duct_error *error)
{
    for (;;) {
        int response = gtk_dialog_run(GTK_DIALOG(dialog->window));
        if (response == RESPONSE_RESET) {
            reset(dialog);
            continue;
        }
        if (response != GTK_RESPONSE_OK) {
            return DUCT_CANCELLED;
        }
        duct_status status = work(dialog, result, error);
        if (status == DUCT_OK) {
            plug_values_keep(dialog->job);
            return DUCT_OK;
        }
        if (status != DUCT_CANCELLED) {
            tell(dialog, error);
        }
    }
}

duct_status plug_dialog_run(struct job *job, struct result *result, duct_error *error)
{
    struct dialog dialog = {.job = job};
    gimp_ui_init("ductus", TRUE);
    dialog.preview = plug_preview_new(job);
    dialog.controls = plug_controls_new(job, values_changed, &dialog);
    make_window(&dialog);
    plug_preview_update(dialog.preview);
    duct_status status = converse(&dialog, result, error);
    plug_preview_free(dialog.preview);
    gtk_widget_destroy(dialog.window);
    plug_controls_free(dialog.controls);
    return status;
}
