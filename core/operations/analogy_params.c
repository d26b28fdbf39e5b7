/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What `analogy` and `synthesize-curve` share. */
#include "operations/analogy_params.h"

#include "base/error.h"
#include "base/json.h"

#include <math.h>

const duct_choice duct_analogy_invariances[3] = {
    {"auto", "As the style says", "What the style's author found right for it."},
    {"rotation", "Rotation", "Pieces of the examples are moved and turned."},
    {"translation", "Translation", "Pieces of the examples are only moved."},
};
const duct_choice duct_analogy_searches[2] = {
    {"fast", "Fast",
     "Compares in full only where a quick estimate leaves it possible that the match is best."},
    {"exact", "Exact", "Compares with every place of the examples: the slow reference."},
};
const duct_choice duct_analogy_alignments[4] = {
    {"auto", "As it fits", "Points of the same number where both have as many; else by length."},
    {"length", "By length", "The same share of each curve's length."},
    {"warp", "By place", "Points that lie near each other, in order (dynamic time warping)."},
    {"samples", "By number", "Points of the same number, where both have as many."},
};

duct_analogy_options duct_analogy_options_from(const duct_settings *settings, const duct_style *style,
                                               bool shape)
{
    duct_analogy_options options = duct_analogy_options_default();
    size_t invariance = duct_settings_choice(settings, "invariance");
    options.rotation = invariance == 0 ? style->rotation != 0 : invariance == 1;
    double weight;
    if (shape && duct_settings_auto_number(settings, "shape-weight", &weight)) {
        options.shape_weight = weight;
    } else if (shape) {
        options.shape_weight = isnan(style->shape_weight) ? 0 : style->shape_weight;
    }
    options.coarse_weight = duct_settings_number(settings, "coarse-weight");
    options.offset_weight = duct_settings_number(settings, "offset-weight");
    options.tangent_weight = duct_settings_number(settings, "tangent-weight");
    options.end_weight = duct_settings_number(settings, "end-weight");
    options.extra_weight = duct_settings_number(settings, "pressure-weight");
    options.foresight = duct_settings_number(settings, "foresight");
    options.neighbourhood = (int)duct_settings_number(settings, "neighbourhood") | 1;
    options.spacing = duct_settings_number(settings, "spacing");
    options.levels = duct_settings_size(settings, "levels");
    options.passes = duct_settings_size(settings, "passes");
    options.coherence = duct_settings_number(settings, "coherence");
    options.randomness = duct_settings_number(settings, "randomness");
    options.exact = duct_settings_choice(settings, "search") == 1;
    options.seed = duct_settings_seed(settings, "seed");
    return options;
}

duct_status duct_analogy_models(const duct_context *context, const duct_settings *settings,
                                const duct_style *style, bool shape, duct_analogy *models[DUCT_STYLE_PASSES],
                                duct_error *error)
{
    duct_analogy_options options = duct_analogy_options_from(settings, style, shape);
    duct_status status = DUCT_OK;
    for (size_t pass = 0; pass < style->pass_count && status == DUCT_OK; pass++) {
        status = duct_analogy_new(duct_allocator_of(context), style->passes[pass].pairs,
                                  style->passes[pass].count, &options, &models[pass], error);
    }
    return status;
}

duct_status duct_analogy_trace_head(duct_tracer *tracer, const duct_settings *settings, duct_error *error)
{
    if (tracer->trace == NULL) {
        return DUCT_OK;
    }
    const duct_operation *operation = duct_settings_operation(settings);
    duct_text text;
    duct_json json;
    duct_text_init(&text, tracer->allocator);
    duct_json_init(&json, &text);
    duct_json_object(&json, NULL);
    duct_json_string(&json, "operation", operation->id);
    duct_json_object(&json, "settings");
    for (size_t i = 0; i < operation->param_count; i++) {
        duct_json_string(&json, operation->params[i].id,
                         duct_settings_text(settings, operation->params[i].id));
    }
    duct_json_close(&json, '}');
    duct_text_add(&text, ",\n  \"strokes\": [\n");
    duct_status status =
        text.failed ? duct_fail_memory(error) : duct_tracer_write(tracer, text.data, text.size, error);
    duct_text_free(&text);
    return status;
}

duct_status duct_analogy_trace_curve(duct_tracer *tracer, bool first, const char *id,
                                     const duct_analogy_figures *figures, duct_error *error)
{
    if (tracer->trace == NULL) {
        return DUCT_OK;
    }
    duct_text text;
    duct_json json;
    duct_text_init(&text, tracer->allocator);
    duct_json_init(&json, &text);
    duct_text_add(&text, first ? "" : ",\n");
    duct_json_row(&json, NULL, '{');
    duct_json_string(&json, "id", id);
    duct_json_integer(&json, "levels", (long long)figures->levels);
    duct_json_integer(&json, "points", (long long)figures->points);
    duct_json_number(&json, "energy", figures->energy);
    duct_json_number(&json, "copied", figures->copied);
    duct_json_close(&json, '}');
    duct_status status =
        text.failed ? duct_fail_memory(error) : duct_tracer_write(tracer, text.data, text.size, error);
    duct_text_free(&text);
    return status;
}

/* The squared distance of point i from the line between two others, pressure being a third dimension. */
static double distance_square(const duct_curve *curve, double width, size_t from, size_t to, size_t i)
{
    double a[3] = {curve->x[from], curve->y[from], 0}, b[3] = {curve->x[to], curve->y[to], 0},
           p[3] = {curve->x[i], curve->y[i], 0};
    if (curve->extra != NULL) {
        a[2] = width * curve->extra[from];
        b[2] = width * curve->extra[to];
        p[2] = width * curve->extra[i];
    }
    double along = 0, length = 0, square = 0;
    for (int d = 0; d < 3; d++) {
        along += (p[d] - a[d]) * (b[d] - a[d]);
        length += (b[d] - a[d]) * (b[d] - a[d]);
    }
    double share = length > 0 ? along / length : 0;
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    for (int d = 0; d < 3; d++) {
        double off = p[d] - a[d] - share * (b[d] - a[d]);
        square += off * off;
    }
    return square;
}

/* Marks the points that stay between two that do (Douglas and Peucker); `stack` has room for all points. */
static void mark(const duct_curve *curve, double tolerance, double width, size_t *stack, bool *stays)
{
    size_t depth = 0, from = 0;
    stack[depth++] = curve->count - 1;
    stays[0] = stays[curve->count - 1] = true;
    while (depth > 0) {
        size_t to = stack[depth - 1], farthest = from;
        double most = tolerance * tolerance;
        for (size_t i = from + 1; i < to; i++) {
            double square = distance_square(curve, width, from, to, i);
            if (square > most) {
                most = square;
                farthest = i;
            }
        }
        if (farthest > from) {
            stays[farthest] = true;
            stack[depth++] = farthest;
        } else {
            from = to;
            depth--;
        }
    }
}

duct_status duct_analogy_fit(const duct_allocator *allocator, duct_curve *curve, double tolerance,
                             double width, duct_error *error)
{
    if (!(tolerance > 0) || curve->count < 3) {
        return DUCT_OK;
    }
    size_t *stack = duct_alloc(allocator, curve->count, sizeof *stack);
    bool *stays = duct_alloc(allocator, curve->count, sizeof *stays);
    if (stack == NULL || stays == NULL) {
        duct_release(allocator, stack);
        duct_release(allocator, stays);
        return duct_fail_memory(error);
    }
    mark(curve, tolerance, width, stack, stays);
    /* A closed curve needs a third point to be one. */
    stays[curve->count / 2] = stays[curve->count / 2] || curve->closed;
    size_t kept = 0;
    for (size_t i = 0; i < curve->count; i++) {
        if (stays[i]) {
            curve->t[kept] = curve->t[i];
            curve->x[kept] = curve->x[i];
            curve->y[kept] = curve->y[i];
            if (curve->extra != NULL) {
                curve->extra[kept] = curve->extra[i];
            }
            kept++;
        }
    }
    curve->count = kept;
    duct_release(allocator, stack);
    duct_release(allocator, stays);
    return DUCT_OK;
}
