/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "task.h"

#include <math.h>

duct_settings *plug_settings_copy(const duct_settings *settings)
{
    duct_settings *copy = NULL;
    duct_error error;
    const duct_operation *table = duct_settings_operation(settings);
    if (duct_settings_new(NULL, table, &copy, &error) != DUCT_OK) {
        return NULL;
    }
    for (size_t i = 0; i < table->param_count; i++) {
        const char *id = table->params[i].id;
        duct_settings_set(copy, id, duct_settings_text(settings, id), &error);
    }
    return copy;
}

static bool report(void *user, double fraction)
{
    struct task *task = user;
    g_atomic_int_set(&task->percent, (int)(fraction * 100));
    return g_atomic_int_get(&task->stop) == 0;
}

/* One pixel of the canvas in cairo's order. */
static uint32_t pixel_of(const uint16_t *from, float share)
{
    uint32_t value[4];
    for (size_t k = 0; k < 4; k++) {
        value[k] = (uint32_t)((float)from[k] * share * 255 / 32768 + 0.5F);
    }
    return value[3] << 24 | value[0] << 16 | value[1] << 8 | value[2];
}

static void show_paint(const struct task *task)
{
    unsigned char *data = cairo_image_surface_get_data(task->result);
    const int stride = cairo_image_surface_get_stride(task->result);
    for (int y = 0; y < task->view.height; y++) {
        uint32_t *row = (uint32_t *)(void *)(data + (size_t)y * (size_t)stride);
        for (int x = 0; x < task->view.width; x++) {
            const uint16_t *tile =
                duct_canvas_tile(task->work.canvas, x / DUCT_TILE_SIZE, y / DUCT_TILE_SIZE);
            if (tile != NULL) {
                size_t inside = (size_t)(y % DUCT_TILE_SIZE) * DUCT_TILE_SIZE + (size_t)(x % DUCT_TILE_SIZE);
                size_t at = (size_t)y * (size_t)task->view.width + (size_t)x;
                row[x] = pixel_of(tile + 4 * inside, task->mask != NULL ? task->mask[at] : 1);
            }
        }
    }
}

static void trace(cairo_t *cairo, const duct_stroke *stroke)
{
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    for (size_t i = 0; i < duct_stroke_size(stroke); i++) {
        cairo_line_to(cairo, x[i], y[i]);
    }
    if (duct_stroke_closed(stroke)) {
        cairo_close_path(cairo);
    }
}

/* As GIMP shows paths: dark with a light rim, whatever is below. */
static void show_paths(const struct task *task)
{
    const duct_drawing *drawing = task->work.known != NULL ? task->work.known : task->work.output;
    cairo_t *cairo = cairo_create(task->result);
    cairo_scale(cairo, task->view.scale, task->view.scale);
    cairo_translate(cairo, -task->view.x, -task->view.y);
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        cairo_new_sub_path(cairo);
        trace(cairo, duct_drawing_stroke(drawing, i));
    }
    cairo_identity_matrix(cairo);
    cairo_set_line_width(cairo, 3);
    cairo_set_source_rgba(cairo, 1, 1, 1, 0.7);
    cairo_stroke_preserve(cairo);
    cairo_set_line_width(cairo, 1);
    cairo_set_source_rgb(cairo, 0.1, 0.2, 0.8);
    cairo_stroke(cairo);
    cairo_destroy(cairo);
}

static void show(struct task *task)
{
    task->result = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, task->view.width, task->view.height);
    if (cairo_surface_status(task->result) != CAIRO_STATUS_SUCCESS) {
        return;
    }
    cairo_surface_flush(task->result);
    if (task->work.canvas != NULL) {
        show_paint(task);
    }
    cairo_surface_mark_dirty(task->result);
    if (task->paths) {
        show_paths(task);
    }
    cairo_surface_flush(task->result);
}

static void *run(void *user)
{
    struct task *task = user;
    task->work.context.progress = report;
    task->work.context.progress_user = task;
    task->work.settings = task->settings;
    task->status = DUCT_OK;
    if (!task->found) {
        task->status = plug_lines_find(task->lines, &task->work.context, &task->error);
        task->found = task->status == DUCT_OK;
    }
    if (task->status == DUCT_OK) {
        task->work.input = task->lines->drawing;
        task->status = plug_work_run(&task->work);
        task->error = task->work.error;
    }
    if (task->status == DUCT_OK && task->picture) {
        show(task);
    }
    g_idle_add(task->ended, task);
    return NULL;
}

void plug_task_start(struct task *task)
{
    task->thread = g_thread_new("ductus", run, task);
}

void plug_task_stop(struct task *task)
{
    g_atomic_int_set(&task->stop, 1);
}

void plug_task_wait(struct task *task)
{
    if (task->thread != NULL) {
        g_thread_join(task->thread);
        task->thread = NULL;
        /* Whoever waits needs no telling. */
        g_idle_remove_by_data(task);
    }
}

double plug_task_progress(const struct task *task)
{
    return g_atomic_int_get(&task->percent) / 100.0;
}

void plug_task_free(struct task *task)
{
    plug_work_done(&task->work);
    duct_settings_free(task->settings);
    g_free(task->mask);
    if (task->result != NULL) {
        cairo_surface_destroy(task->result);
    }
    g_free(task);
}
