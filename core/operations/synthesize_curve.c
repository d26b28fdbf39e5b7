/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operation `synthesize-curve`: new curves like an example. */
#include "base/error.h"
#include "base/pool.h"
#include "operations/analogy_params.h"
#include "operations/stroke_list.h"

#include <ductus/random.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static const duct_param params[] = {
    {"style", "Style", "What the new curves are like: a built-in style's curves, or those of a file.",
     DUCT_PARAM_STYLE, "", 0, 0, 0, "loops", NULL, 0, "Style", false},
    {"example", "Example", "Instead of a style: example curves, strokes of this drawing.", DUCT_PARAM_STROKES,
     "", 0, 0, 0, "", NULL, 0, "Style", false},
    {"length", "Length", "Length of a new curve; auto makes it three times as long as the example.",
     DUCT_PARAM_AUTO, "pixels", 1, 100000, 10, "auto", NULL, 0, "Style", false},
    {"through", "Through",
     "A line or marks whose points the new curve passes through in their order, instead of having a length.",
     DUCT_PARAM_STROKES, "", 0, 0, 0, "", NULL, 0, "Style", false},
    {"count", "Count", "How many new curves.", DUCT_PARAM_INT, "", 1, 1000, 1, "1", NULL, 0, "Style", false},
    {"scale", "Scale", "How large the new curves are drawn: 1 is the size of the examples.", DUCT_PARAM_REAL,
     "times", 0.01, 100, 0.1, "1", NULL, 0, "Style", false},
    {"seed", "Seed", "Which of the possible curves; the same seed gives the same ones.", DUCT_PARAM_SEED, "",
     0, 0, 1, "0", NULL, 0, "Style", false},
    DUCT_ANALOGY_MATCHING,
};

static const duct_preset_value sharp_values[] = {{"tangent-weight", "100000"}};
static const duct_preset_value upright_values[] = {{"invariance", "translation"}};
static const duct_preset_value paper_values[] = {
    {"end-weight", "0"}, {"foresight", "1"}, {"coherence", "0.5"}, {"spacing", "0.5"}};

static const duct_preset presets[] = {
    {"default", "Default", "What suits the style.", NULL, 0},
    {"upright", "Upright", "What is level or upright in the example stays so.", upright_values, 1},
    {"sharp", "Sharp corners", "For examples with sharp corners.", sharp_values, 1},
    {"paper", "As in the paper", "The values of the Curve Analogies paper.", paper_values, 4},
};

typedef struct {
    const duct_context *context;
    const duct_settings *settings;
    double scale, length; /* of the new curves, in the examples' pixels */
    duct_style style;
    duct_analogy *models[DUCT_STYLE_PASSES];
    duct_curve guide; /* through points, in the examples' pixels; no points without */
    duct_curve_constraint *points;
    size_t count;
    duct_curve *results; /* by new curve */
    duct_analogy_figures *figures;
} work;

static void work_done(work *self)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    for (size_t i = 0; self->results != NULL && i < self->count; i++) {
        duct_curve_done(allocator, &self->results[i]);
    }
    for (size_t pass = 0; pass < DUCT_STYLE_PASSES; pass++) {
        duct_analogy_free(self->models[pass]);
    }
    duct_style_done(&self->style);
    duct_curve_done(allocator, &self->guide);
    duct_release(allocator, self->points);
    duct_release(allocator, self->results);
    duct_release(allocator, self->figures);
}

static duct_status read_list(const work *self, const duct_drawing *input, const char *param,
                             duct_stroke_list *list, duct_error *error)
{
    const char *text = duct_settings_text(self->settings, param);
    return duct_stroke_list_read(duct_allocator_of(self->context), input, text, strlen(text), param, list,
                                 error);
}

/* Curves are copied from A' alone. */
static void forget_plain(work *self)
{
    for (size_t pass = 0; pass < self->style.pass_count; pass++) {
        for (size_t i = 0; i < self->style.passes[pass].count; i++) {
            duct_curve_pair *pair = &self->style.passes[pass].pairs[i];
            duct_curve_done(&self->style.allocator, &pair->a);
            duct_curve_use_arc_length(&pair->b);
        }
    }
}

static duct_status make_style(work *self, const duct_drawing *input, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    duct_stroke_list list = {NULL, 0};
    duct_status status = read_list(self, input, "example", &list, error);
    if (status == DUCT_OK && list.count > 0) {
        const duct_stroke **strokes = duct_alloc(allocator, list.count, sizeof *strokes);
        status = strokes != NULL ? DUCT_OK : duct_fail_memory(error);
        for (size_t i = 0; i < list.count && strokes != NULL; i++) {
            strokes[i] = duct_drawing_stroke(input, list.items[i]);
        }
        if (status == DUCT_OK) {
            status = duct_style_make_of(allocator, NULL, strokes, list.count, DUCT_CORRESPOND_LENGTH,
                                        self->scale, &self->style, error);
        }
        duct_release(allocator, strokes);
    } else if (status == DUCT_OK) {
        const char *name = duct_settings_text(self->settings, "style");
        duct_drawing *drawing;
        status = duct_style_read(self->context, name, &drawing, error);
        if (status == DUCT_OK) {
            status = duct_style_make(allocator, drawing, name, DUCT_CORRESPOND_LENGTH, self->scale,
                                     &self->style, error);
            duct_drawing_free(drawing);
        }
    }
    duct_stroke_list_done(allocator, &list);
    if (status == DUCT_OK) {
        forget_plain(self);
        status = duct_analogy_models(self->context, self->settings, &self->style, false, self->models, error);
    }
    return status;
}

/* The points of the strokes to pass through: a closed shape is a mark and stands for its centre. */
static void collect_points(const work *self, const duct_drawing *input, const duct_stroke_list *list,
                           duct_curve *points)
{
    points->count = 0;
    for (size_t i = 0; i < list->count; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(input, list->items[i]);
        const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
        size_t size = duct_stroke_size(stroke);
        bool mark = duct_stroke_closed(stroke);
        double sum_x = 0, sum_y = 0;
        for (size_t k = 0; k < size; k++) {
            sum_x += x[k];
            sum_y += y[k];
            if (!mark || k + 1 == size) {
                size_t at = points->count;
                points->x[at] = (mark ? sum_x / (double)size : x[k]) / self->scale;
                points->y[at] = (mark ? sum_y / (double)size : y[k]) / self->scale;
                points->count +=
                    at == 0 || points->x[at] != points->x[at - 1] || points->y[at] != points->y[at - 1];
            }
        }
    }
}

static duct_status make_guide(work *self, const duct_drawing *input, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    duct_stroke_list list = {NULL, 0};
    duct_status status = read_list(self, input, "through", &list, error);
    size_t room = 0;
    for (size_t i = 0; i < list.count; i++) {
        room += duct_stroke_size(duct_drawing_stroke(input, list.items[i]));
    }
    if (status == DUCT_OK && list.count > 0) {
        status = duct_curve_init(allocator, room + 1, false, false, &self->guide, error);
        if (status == DUCT_OK) {
            collect_points(self, input, &list, &self->guide);
            if (self->guide.count < 2) {
                status = duct_fail(error, DUCT_BAD_SETTING,
                                   "through: only one point is there to pass through; give two or more");
            }
        }
        if (status == DUCT_OK) {
            duct_curve_use_arc_length(&self->guide);
            self->points = duct_alloc(allocator, self->guide.count, sizeof *self->points);
            status = self->points != NULL ? DUCT_OK : duct_fail_memory(error);
        }
        for (size_t i = 0; i < self->guide.count && status == DUCT_OK; i++) {
            self->points[i] =
                (duct_curve_constraint){self->guide.t[i], self->guide.x[i], self->guide.y[i], INFINITY};
        }
    }
    duct_stroke_list_done(allocator, &list);
    return status;
}

static double example_length(const duct_style *style)
{
    double longest = 0;
    for (size_t i = 0; i < style->passes[0].count; i++) {
        double length = duct_curve_length(&style->passes[0].pairs[i].b);
        longest = length > longest ? length : longest;
    }
    return longest;
}

static duct_status synthesize_one(void *arg, size_t worker, size_t index, duct_error *error)
{
    (void)worker;
    const work *self = arg;
    const duct_analogy *model = self->models[index % self->style.pass_count];
    duct_curve *result = &self->results[index];
    uint64_t id = duct_random_bits(index, 0, 0, 1);
    duct_status status =
        self->guide.count > 0
            ? duct_analogy_synthesize_through(model, &self->guide, id, self->points, self->guide.count,
                                              result, &self->figures[index], error)
            : duct_analogy_synthesize(model, self->length, id, result, &self->figures[index], error);
    for (size_t i = 0; status == DUCT_OK && i < result->count; i++) {
        result->x[i] *= self->scale;
        result->y[i] *= self->scale;
    }
    return status;
}

/* Free curves go below what is there, one below the other. */
static void place(const work *self, const duct_drawing *input, size_t index, double *down)
{
    const double margin = 20;
    duct_curve *curve = &self->results[index];
    double box[4] = {0, 0, 0, 0}, low = INFINITY, high = -INFINITY, left = INFINITY;
    if (!duct_drawing_bounds(input, box)) {
        box[0] = margin;
    }
    if (index == 0) {
        *down = box[3] + margin;
    }
    for (size_t i = 0; i < curve->count; i++) {
        low = fmin(low, curve->y[i]);
        high = fmax(high, curve->y[i]);
        left = fmin(left, curve->x[i]);
    }
    for (size_t i = 0; i < curve->count; i++) {
        curve->x[i] += box[0] - left;
        curve->y[i] += *down - low;
    }
    *down += high - low + margin;
}

static bool has_id(const duct_drawing *drawing, const char *id)
{
    for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
        if (strcmp(duct_stroke_id(duct_drawing_stroke(drawing, i)), id) == 0) {
            return true;
        }
    }
    return false;
}

static duct_status add_curve(const work *self, const duct_curve *curve, duct_drawing *output, size_t *number,
                             char id[32], duct_error *error)
{
    do {
        snprintf(id, 32, "curve-%zu", ++*number);
    } while (has_id(output, id));
    duct_stroke *stroke;
    duct_status status = duct_drawing_add_stroke(output, id, curve->count, &stroke, error);
    if (status != DUCT_OK) {
        return status;
    }
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    double *p = curve->extra != NULL ? duct_stroke_edit(stroke, DUCT_PRESSURE) : NULL;
    if (curve->extra != NULL && p == NULL) {
        return duct_fail_memory(error);
    }
    memcpy(x, curve->x, curve->count * sizeof *x);
    memcpy(y, curve->y, curve->count * sizeof *y);
    for (size_t i = 0; p != NULL && i < curve->count; i++) {
        p[i] = fmin(1, fmax(0, curve->extra[i]));
    }
    duct_stroke_style ink = {0, 0, 0, 1, (self->style.width > 0 ? self->style.width : 1) * self->scale};
    duct_stroke_set_style(stroke, ink);
    return DUCT_OK;
}

static duct_status make_output(work *self, const duct_drawing *input, duct_tracer *tracer,
                               duct_drawing *output, duct_error *error)
{
    size_t number = 0;
    double down = 0, width = self->style.width > 0 ? self->style.width * self->scale : 1;
    duct_status status = duct_analogy_trace_head(tracer, self->settings, error);
    for (size_t i = 0; i < self->count && status == DUCT_OK; i++) {
        char id[32];
        if (self->guide.count == 0) {
            place(self, input, i, &down);
        }
        status = duct_analogy_fit(duct_allocator_of(self->context), &self->results[i],
                                  duct_settings_number(self->settings, "fit"), width, error);
        if (status == DUCT_OK) {
            status = add_curve(self, &self->results[i], output, &number, id, error);
        }
        if (status == DUCT_OK) {
            status = duct_analogy_trace_curve(tracer, i == 0, id, &self->figures[i], error);
        }
    }
    return status == DUCT_OK && tracer->trace != NULL ? duct_tracer_write(tracer, "\n  ]\n}\n", 7, error)
                                                      : status;
}

static duct_status run_synthesize(const duct_context *context, const duct_settings *settings,
                                  const duct_drawing *input, duct_tracer *tracer, duct_drawing **output,
                                  duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    work self = {.context = context, .settings = settings};
    duct_drawing *made = NULL;
    self.scale = duct_settings_number(settings, "scale");
    self.count = duct_settings_size(settings, "count");
    self.results = duct_alloc(allocator, self.count, sizeof *self.results);
    self.figures = duct_alloc(allocator, self.count, sizeof *self.figures);
    duct_status status = self.results != NULL && self.figures != NULL ? DUCT_OK : duct_fail_memory(error);
    if (status == DUCT_OK) {
        status = make_style(&self, input, error);
    }
    if (status == DUCT_OK) {
        status = make_guide(&self, input, error);
    }
    if (status == DUCT_OK) {
        double length;
        self.length = duct_settings_auto_number(settings, "length", &length)
                          ? length / self.scale
                          : 3 * example_length(&self.style);
        status = duct_pool_run(context, self.count, 0, 1, synthesize_one, &self, error);
    }
    if (status == DUCT_OK) {
        status = duct_drawing_copy(context, input, &made, error);
    }
    if (status == DUCT_OK) {
        status = make_output(&self, input, tracer, made, error);
    }
    work_done(&self);
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    *output = made;
    return DUCT_OK;
}

const duct_operation_impl duct_operation_synthesize_curve = {
    {"synthesize-curve", "New curves like an example", "Add new curves in the style of an example curve.",
     params, DUCT_ANALOGY_COUNT(params), presets, DUCT_ANALOGY_COUNT(presets)},
    run_synthesize,
};
