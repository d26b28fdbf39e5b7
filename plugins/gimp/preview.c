/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "preview.h"

#include "backdrop.h"
#include "brushes.h"
#include "clip.h"
#include "run.h"

#include <math.h>
#include <string.h>

enum { SIDE = 440, PAUSE = 150 /* milliseconds without a change before work begins */ };

static const double zooms[] = {0, 0.125, 0.25, 0.5, 1, 2, 4}; /* 0: the whole image */
static const char *const zoom_names[] = {"Whole image", "12.5%", "25%", "50%", "100%", "200%", "400%"};

struct preview {
    const struct job *job;
    GtkWidget *box, *area, *zoom, *bar;
    int image_width, image_height;
    struct view view;
    struct backdrop *backdrop;
    cairo_surface_t *below, *above; /* the image and the last result */
    struct view above_view;
    double drag_x, drag_y;
    guint timer, clock;

    struct task *task; /* at work; NULL: none */
    bool again;        /* begin anew when it has ended */
    bool taking;       /* pixels are being taken into memory */
    bool closing;

    /* What did not change since the last time. */
    char *lines_key, *output_key, *brush_key;
    struct lines lines;
    bool found;
    duct_drawing *output;
    duct_brush *brush;
};

static void begin(struct preview *preview);

/* Lets the view hold as much of the image as fits. */
static void place_view(struct preview *preview, double centre_x, double centre_y)
{
    GtkAllocation size;
    gtk_widget_get_allocation(preview->area, &size);
    struct view *view = &preview->view;
    view->width = MAX(size.width, 1);
    view->height = MAX(size.height, 1);
    double zoom = zooms[MAX(gtk_combo_box_get_active(GTK_COMBO_BOX(preview->zoom)), 0)];
    if (zoom <= 0) {
        zoom = fmin((double)view->width / preview->image_width, (double)view->height / preview->image_height);
        centre_x = preview->image_width / 2.0;
        centre_y = preview->image_height / 2.0;
    }
    view->scale = zoom;
    view->x = centre_x - view->width / zoom / 2;
    view->y = centre_y - view->height / zoom / 2;
    if (preview->below != NULL) {
        cairo_surface_destroy(preview->below);
        preview->below = NULL;
    }
    gtk_widget_queue_draw(preview->area);
}

static void keep_place(struct preview *preview)
{
    const struct view *view = &preview->view;
    bool placed = view->scale > 0;
    place_view(preview, placed ? view->x + view->width / view->scale / 2 : preview->image_width / 2.0,
               placed ? view->y + view->height / view->scale / 2 : preview->image_height / 2.0);
}

static void say(struct preview *preview, const char *text)
{
    gtk_progress_bar_set_text(GTK_PROGRESS_BAR(preview->bar), text);
    gtk_widget_set_tooltip_text(preview->bar, *text != '\0' ? text : NULL);
}

static void draw_checks(cairo_t *cairo, const struct preview *preview)
{
    const struct view *view = &preview->view;
    cairo_rectangle(cairo, -view->x * view->scale, -view->y * view->scale, preview->image_width * view->scale,
                    preview->image_height * view->scale);
    cairo_clip(cairo);
    cairo_set_source_rgb(cairo, 0.6, 0.6, 0.6);
    cairo_paint(cairo);
    cairo_set_source_rgb(cairo, 0.4, 0.4, 0.4);
    for (int y = 0; y < view->height; y += 8) {
        for (int x = y % 16; x < view->width; x += 16) {
            cairo_rectangle(cairo, x, y, 8, 8);
        }
    }
    cairo_fill(cairo);
}

static void draw_result(cairo_t *cairo, const struct preview *preview)
{
    const struct view *view = &preview->view, *old = &preview->above_view;
    const duct_settings *options = preview->job->options;
    /* While the view moves, the last result moves along. */
    double ratio = view->scale / old->scale;
    cairo_save(cairo);
    cairo_translate(cairo, (old->x - view->x) * view->scale, (old->y - view->y) * view->scale);
    cairo_scale(cairo, ratio, ratio);
    cairo_set_source_surface(cairo, preview->above, 0, 0);
    bool paints = plug_option_paints(options);
    cairo_set_operator(cairo, paints ? (cairo_operator_t)plug_option_operator(options) : CAIRO_OPERATOR_OVER);
    cairo_paint_with_alpha(cairo, paints ? plug_option_number(options, OPTION_OPACITY, 100) / 100 : 1);
    cairo_restore(cairo);
}

static gboolean expose(GtkWidget *area, GdkEventExpose *event, struct preview *preview)
{
    (void)event;
    if (preview->below == NULL) {
        preview->below = plug_backdrop_show(preview->backdrop, &preview->view);
    }
    cairo_t *cairo = gdk_cairo_create(gtk_widget_get_window(area));
    cairo_set_source_rgb(cairo, 0.5, 0.5, 0.5);
    cairo_paint(cairo);
    /* In a group, so that modes blend with the image and not with the window. */
    draw_checks(cairo, preview);
    cairo_push_group(cairo);
    cairo_set_source_surface(cairo, preview->below, 0, 0);
    cairo_paint(cairo);
    if (preview->above != NULL) {
        draw_result(cairo, preview);
    }
    cairo_pop_group_to_source(cairo);
    cairo_paint(cairo);
    cairo_destroy(cairo);
    return TRUE;
}

static char *key_of(const struct job *job, const char *const *ids, const duct_settings *all)
{
    GString *key = g_string_new(NULL);
    for (; *ids != NULL; ids++) {
        g_string_append_printf(key, "%s\n", duct_settings_text(job->options, *ids));
    }
    const duct_operation *table = all != NULL ? duct_settings_operation(all) : NULL;
    for (size_t i = 0; table != NULL && i < table->param_count; i++) {
        g_string_append_printf(key, "%s\n", duct_settings_text(all, table->params[i].id));
    }
    return g_string_free(key, FALSE);
}

/* True where the key is another than before, which is then replaced. */
static bool renew(char **key, char *now)
{
    if (*key != NULL && strcmp(*key, now) == 0) {
        g_free(now);
        return false;
    }
    g_free(*key);
    *key = now;
    return true;
}

static bool go_on(void *user, double fraction)
{
    struct preview *preview = user;
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(preview->bar), fraction);
    while (gtk_events_pending()) {
        gtk_main_iteration();
    }
    return !preview->closing;
}

static void forget_output(struct preview *preview)
{
    duct_drawing_free(preview->output);
    preview->output = NULL;
    g_clear_pointer(&preview->output_key, g_free);
}

static duct_status get_lines(struct preview *preview, duct_error *error)
{
    static const char *const ids[] = {OPTION_LINES,  OPTION_COLOUR,   OPTION_INK, OPTION_THRESHOLD,
                                      OPTION_WIDEST, OPTION_SHORTEST, NULL};
    if (!renew(&preview->lines_key, key_of(preview->job, ids, NULL))) {
        return DUCT_OK;
    }
    plug_lines_close(&preview->lines);
    forget_output(preview);
    preview->found = false;
    preview->taking = true;
    duct_status status = plug_lines_open(preview->job, go_on, preview, &preview->lines, error);
    preview->taking = false;
    if (status != DUCT_OK) {
        g_clear_pointer(&preview->lines_key, g_free);
    }
    return status;
}

static duct_status get_brush(struct preview *preview, duct_error *error)
{
    const char *name = duct_settings_text(preview->job->options, OPTION_BRUSH);
    if (!plug_option_paints(preview->job->options) || !renew(&preview->brush_key, g_strdup(name))) {
        return DUCT_OK;
    }
    duct_brush_free(preview->brush);
    preview->brush = NULL;
    duct_status status = plug_brush_load(name, &preview->brush, error);
    if (status != DUCT_OK) {
        g_clear_pointer(&preview->brush_key, g_free);
    }
    return status;
}

static float *mask_of(const struct preview *preview)
{
    struct clip clip;
    const struct view *view = &preview->view;
    float *mask = NULL;
    plug_clip_init(&clip, preview->job);
    if (clip.count > 0) {
        const GeglRectangle area = {(int)floor(view->x * view->scale), (int)floor(view->y * view->scale),
                                    view->width, view->height};
        size_t size = (size_t)view->width * (size_t)view->height;
        mask = g_new(float, size);
        for (size_t i = 0; i < size; i++) {
            mask[i] = 1;
        }
        plug_clip_apply(&clip, &area, view->scale, mask);
    }
    plug_clip_done(&clip);
    return mask;
}

static void take_results(struct preview *preview, struct task *task)
{
    preview->found = preview->found || task->found;
    if (task->status != DUCT_OK) {
        if (task->status != DUCT_CANCELLED) {
            say(preview, task->error.message);
        }
        return;
    }
    if (task->work.output != NULL) {
        duct_drawing_free(preview->output);
        preview->output = task->work.output;
        task->work.output = NULL;
    }
    if (preview->above != NULL) {
        cairo_surface_destroy(preview->above);
    }
    preview->above = task->result;
    preview->above_view = task->view;
    task->result = NULL;
    say(preview, "");
    gtk_widget_queue_draw(preview->area);
}

static gboolean task_ended(void *user)
{
    struct task *task = user;
    struct preview *preview = task->user;
    plug_task_wait(task);
    preview->task = NULL;
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(preview->bar), 0);
    if (task->status != DUCT_OK) {
        g_clear_pointer(&preview->output_key, g_free);
    }
    take_results(preview, task);
    plug_task_free(task);
    if (preview->again) {
        preview->again = false;
        begin(preview);
    }
    return FALSE;
}

static gboolean show_progress(void *user)
{
    struct preview *preview = user;
    if (preview->task != NULL) {
        gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(preview->bar), plug_task_progress(preview->task));
    }
    return TRUE;
}

static void begin(struct preview *preview)
{
    static const char *const none[] = {NULL};
    const struct job *job = preview->job;
    duct_error error = {DUCT_OK, ""};
    if (preview->view.scale <= 0) {
        return; /* not on the screen yet */
    }
    duct_status status = get_lines(preview, &error);
    if (status == DUCT_OK) {
        status = get_brush(preview, &error);
    }
    if (status != DUCT_OK) {
        say(preview, status == DUCT_CANCELLED ? "" : error.message);
        return;
    }
    struct task *task = g_new0(struct task, 1);
    if (renew(&preview->output_key, key_of(job, none, job->settings))) {
        duct_drawing_free(preview->output);
        preview->output = NULL;
    }
    task->lines = &preview->lines;
    task->found = preview->found;
    task->settings = plug_settings_copy(job->settings);
    task->view = preview->view;
    task->picture = true;
    task->paths = plug_option_makes_paths(job->options);
    task->work.context = duct_context_default();
    task->work.known = preview->output;
    task->work.brush = plug_option_paints(job->options) ? preview->brush : NULL;
    task->work.paint = plug_run_paint_options(job, task->view.scale, task->view.x, task->view.y);
    task->work.width = task->view.width;
    task->work.height = task->view.height;
    task->mask = task->work.brush != NULL ? mask_of(preview) : NULL;
    task->ended = task_ended;
    task->user = preview;
    preview->task = task;
    say(preview, "");
    plug_task_start(task);
}

static gboolean timer_rang(void *user)
{
    struct preview *preview = user;
    if (preview->taking) {
        return TRUE; /* once more, later */
    }
    preview->timer = 0;
    if (preview->task != NULL) {
        preview->again = true;
        plug_task_stop(preview->task);
    } else {
        begin(preview);
    }
    return FALSE;
}

void plug_preview_update(struct preview *preview)
{
    if (preview->timer != 0) {
        g_source_remove(preview->timer);
    }
    preview->timer = g_timeout_add(PAUSE, timer_rang, preview);
    gtk_widget_queue_draw(preview->area); /* mode and opacity show at once */
}

static void stop(struct preview *preview)
{
    if (preview->timer != 0) {
        g_source_remove(preview->timer);
        preview->timer = 0;
    }
    preview->again = false;
    if (preview->task != NULL) {
        struct task *task = preview->task;
        plug_task_stop(task);
        plug_task_wait(task);
        preview->found = preview->found || task->found;
        preview->task = NULL;
        g_clear_pointer(&preview->output_key, g_free);
        plug_task_free(task);
    }
}

void plug_preview_pause(struct preview *preview)
{
    stop(preview);
    gtk_progress_bar_set_fraction(GTK_PROGRESS_BAR(preview->bar), 0);
}

static void zoom_changed(GtkComboBox *combo, struct preview *preview)
{
    (void)combo;
    keep_place(preview);
    plug_preview_update(preview);
}

static void size_changed(GtkWidget *area, GtkAllocation *size, struct preview *preview)
{
    (void)area;
    (void)size;
    keep_place(preview);
    plug_preview_update(preview);
}

static gboolean pressed(GtkWidget *area, GdkEventButton *event, struct preview *preview)
{
    (void)area;
    preview->drag_x = event->x;
    preview->drag_y = event->y;
    return TRUE;
}

static gboolean moved(GtkWidget *area, GdkEventMotion *event, struct preview *preview)
{
    struct view *view = &preview->view;
    (void)area;
    if (gtk_combo_box_get_active(GTK_COMBO_BOX(preview->zoom)) > 0) {
        double x = view->x - (event->x - preview->drag_x) / view->scale;
        double y = view->y - (event->y - preview->drag_y) / view->scale;
        place_view(preview, CLAMP(x + view->width / view->scale / 2, 0, preview->image_width),
                   CLAMP(y + view->height / view->scale / 2, 0, preview->image_height));
        plug_preview_update(preview);
    }
    preview->drag_x = event->x;
    preview->drag_y = event->y;
    return TRUE;
}

static void make_widgets(struct preview *preview)
{
    GtkWidget *row = gtk_hbox_new(FALSE, 6);
    preview->box = gtk_vbox_new(FALSE, 6);
    preview->area = gtk_drawing_area_new();
    preview->zoom = gtk_combo_box_text_new();
    preview->bar = gtk_progress_bar_new();
    gtk_progress_bar_set_ellipsize(GTK_PROGRESS_BAR(preview->bar), PANGO_ELLIPSIZE_END);
    for (size_t i = 0; i < G_N_ELEMENTS(zoom_names); i++) {
        gtk_combo_box_text_append_text(GTK_COMBO_BOX_TEXT(preview->zoom), zoom_names[i]);
    }
    gtk_combo_box_set_active(GTK_COMBO_BOX(preview->zoom), 0);
    gtk_widget_set_size_request(preview->area, SIDE, SIDE);
    gtk_widget_add_events(preview->area, GDK_BUTTON_PRESS_MASK | GDK_BUTTON1_MOTION_MASK);
    gtk_widget_set_tooltip_text(preview->area,
                                "The image with the result over it. Drag to see another part.");
    gtk_box_pack_start(GTK_BOX(preview->box), preview->area, TRUE, TRUE, 0);
    gtk_box_pack_start(GTK_BOX(row), gtk_label_new("Show"), FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(row), preview->zoom, FALSE, FALSE, 0);
    gtk_box_pack_start(GTK_BOX(row), preview->bar, TRUE, TRUE, 0);
    gtk_box_pack_start(GTK_BOX(preview->box), row, FALSE, FALSE, 0);
    g_signal_connect(preview->area, "expose-event", G_CALLBACK(expose), preview);
    g_signal_connect(preview->area, "size-allocate", G_CALLBACK(size_changed), preview);
    g_signal_connect(preview->area, "button-press-event", G_CALLBACK(pressed), preview);
    g_signal_connect(preview->area, "motion-notify-event", G_CALLBACK(moved), preview);
    g_signal_connect(preview->zoom, "changed", G_CALLBACK(zoom_changed), preview);
}

struct preview *plug_preview_new(const struct job *job)
{
    struct preview *preview = g_new0(struct preview, 1);
    preview->job = job;
    preview->image_width = gimp_image_width(job->image);
    preview->image_height = gimp_image_height(job->image);
    preview->backdrop = plug_backdrop_new(job->image);
    make_widgets(preview);
    preview->clock = g_timeout_add(100, show_progress, preview);
    return preview;
}

void plug_preview_free(struct preview *preview)
{
    preview->closing = true;
    stop(preview);
    g_source_remove(preview->clock);
    plug_lines_close(&preview->lines);
    plug_backdrop_free(preview->backdrop);
    duct_drawing_free(preview->output);
    duct_brush_free(preview->brush);
    if (preview->below != NULL) {
        cairo_surface_destroy(preview->below);
    }
    if (preview->above != NULL) {
        cairo_surface_destroy(preview->above);
    }
    g_free(preview->lines_key);
    g_free(preview->output_key);
    g_free(preview->brush_key);
    g_free(preview);
}

GtkWidget *plug_preview_widget(struct preview *preview)
{
    return preview->box;
}
