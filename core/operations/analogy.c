/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operation `analogy`: "Curve analogies" for a whole drawing. */
#include "base/error.h"
#include "base/pool.h"
#include "geometry/resample.h"
#include "operations/analogy_params.h"
#include "operations/analogy_strokes.h"

#include <ductus/random.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

static const duct_choice ways[] = {
    {"auto", "As the style says", "What the style's author found right for it; else on."},
    {"true", "On", "Always."},
    {"false", "Off", "Never."},
};
static const duct_choice split_ways[] = {
    {"auto", "As the style says", "What the style's author found right for it; else off."},
    {"true", "On", "Always."},
    {"false", "Off", "Never."},
};
static const duct_choice end_ways[] = {
    {"free", "Free", "Ends lie where the style puts them."},
    {"soft", "Soft", "Ends are drawn towards their places."},
    {"fixed", "Fixed", "Ends stay where they are."},
};

static const duct_param params[] = {
    {"style", "Style",
     "The style of the new lines: a built-in one, or a file with example curves A and A' in layers of these "
     "names.",
     DUCT_PARAM_STYLE, "", 0, 0, 0, "waves", NULL, 0, "Style", false},
    {"example-from", "Plain example",
     "Instead of a style: the plain curves A of the examples, strokes of this drawing.", DUCT_PARAM_STROKES,
     "", 0, 0, 0, "", NULL, 0, "Style", false},
    {"example-to", "Stylised example",
     "The stylised curves A' of the examples, in the same order. A and A' stay as they are.",
     DUCT_PARAM_STROKES, "", 0, 0, 0, "", NULL, 0, "Style", false},
    {"amount", "Amount", "0 leaves the drawing as it is, 1 is the full effect.", DUCT_PARAM_REAL, "", 0, 1,
     0.05, "1", NULL, 0, "Style", false},
    {"scale", "Scale", "How large the style is drawn: 1 is the size of the examples.", DUCT_PARAM_REAL,
     "times", 0.01, 100, 0.1, "1", NULL, 0, "Style", false},
    {"seed", "Seed", "Which of the possible results; the same seed gives the same drawing.", DUCT_PARAM_SEED,
     "", 0, 0, 1, "0", NULL, 0, "Style", false},

    {"join-corners", "Join corners", "Whether lines that met still meet.", DUCT_PARAM_CHOICE, "", 0, 0, 0,
     "auto", DUCT_ANALOGY_CHOICES(ways), "Places", false},
    {"split-corners", "Split at corners", "Whether each side of a corner becomes a line of its own.",
     DUCT_PARAM_CHOICE, "", 0, 0, 0, "auto", DUCT_ANALOGY_CHOICES(split_ways), "Places", false},
    {"ends", "Ends", "Where lines begin and end.", DUCT_PARAM_CHOICE, "", 0, 0, 0, "free",
     DUCT_ANALOGY_CHOICES(end_ways), "Places", false},
    {"pins", "Pins",
     "Marks (dots or small shapes) through which the line nearest to each is to pass; they stay as they are.",
     DUCT_PARAM_STROKES, "", 0, 0, 0, "", NULL, 0, "Places", true},
    {"pin-weight", "Pin weight", "How firmly pins hold: auto holds exactly, a number is a spring.",
     DUCT_PARAM_AUTO, "", 0.001, 1e6, 1, "auto", NULL, 0, "Places", true},
    {"join-distance", "Join distance", "Ends nearer to each other than this meet.", DUCT_PARAM_REAL, "pixels",
     0, 1000, 0.5, "1.5", NULL, 0, "Places", true},

    {"shape-weight", "Shape weight",
     "How much the shape of the plain curves counts, as 2; with 0 only their sweep; auto follows the style.",
     DUCT_PARAM_AUTO, "", 0, 1000, 0.5, "auto", NULL, 0, "Matching", true},
    DUCT_ANALOGY_MATCHING,
};

static const duct_preset_value shape_values[] = {{"shape-weight", "2"}};
static const duct_preset_value sweep_values[] = {{"shape-weight", "0"}};
static const duct_preset_value paper_values[] = {
    {"end-weight", "0"}, {"foresight", "1"}, {"coherence", "0.5"}, {"spacing", "0.5"}, {"shape-weight", "2"}};
static const duct_preset_value sharp_values[] = {{"tangent-weight", "100000"}};
static const duct_preset_value hand_values[] = {{"shape-weight", "2"}, {"invariance", "translation"}};

static const duct_preset presets[] = {
    {"default", "Default", "What suits the style.", NULL, 0},
    {"sweep", "Sweep only", "Only the course of the lines counts, not their shape.", sweep_values, 1},
    {"shape", "Shape", "Corners become like the examples' corners, curves like their curves.", shape_values,
     1},
    {"upright", "Shape, upright", "The same, and what is level or upright in the examples stays so.",
     hand_values, 2},
    {"sharp", "Sharp corners", "For examples with sharp corners.", sharp_values, 1},
    {"paper", "As in the paper", "The values of the Curve Analogies paper.", paper_values, 5},
};

/* A style, for some of the drawing's strokes. */
typedef struct {
    duct_style style;
    duct_analogy *models[DUCT_STYLE_PASSES];
} styling;

typedef struct {
    const duct_context *context;
    const duct_settings *settings;
    const duct_drawing *input;
    double scale, amount, fit;
    styling *styles;
    size_t style_count;
    size_t *chosen; /* by stroke: the number of its style plus 1; 0: it stays as it is */
    duct_pieces pieces;
    duct_curve *results; /* [piece * DUCT_STYLE_PASSES + pass] */
    duct_analogy_figures *figures;
} work;

static void work_done(work *self)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    for (size_t s = 0; s < self->style_count; s++) {
        for (size_t pass = 0; pass < DUCT_STYLE_PASSES; pass++) {
            duct_analogy_free(self->styles[s].models[pass]);
        }
        duct_style_done(&self->styles[s].style);
    }
    for (size_t i = 0; self->results != NULL && i < self->pieces.count * DUCT_STYLE_PASSES; i++) {
        duct_curve_done(allocator, &self->results[i]);
    }
    duct_release(allocator, self->styles);
    duct_release(allocator, self->chosen);
    duct_release(allocator, self->results);
    duct_release(allocator, self->figures);
    duct_pieces_done(&self->pieces);
}

static duct_status add_style(work *self, duct_style *style, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    styling *grown = duct_realloc(allocator, self->styles, self->style_count + 1, sizeof *grown);
    if (grown == NULL) {
        duct_style_done(style);
        return duct_fail_memory(error);
    }
    self->styles = grown;
    styling *made = &grown[self->style_count++];
    memset(made, 0, sizeof *made);
    made->style = *style;
    return duct_analogy_models(self->context, self->settings, &made->style, true, made->models, error);
}

/* The examples among the drawing's own strokes. */
static duct_status style_of_strokes(work *self, const duct_stroke_list *from, const duct_stroke_list *to,
                                    duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    if (from->count != to->count || to->count == 0) {
        return duct_fail(error, DUCT_BAD_SETTING,
                         "example-from, example-to: %zu plain and %zu stylised example curves; give as many "
                         "of both, in the "
                         "same order",
                         from->count, to->count);
    }
    const duct_stroke **strokes = duct_alloc(allocator, 2 * to->count, sizeof *strokes);
    if (strokes == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < to->count; i++) {
        strokes[i] = duct_drawing_stroke(self->input, from->items[i]);
        strokes[to->count + i] = duct_drawing_stroke(self->input, to->items[i]);
    }
    duct_style style;
    duct_status status = duct_style_make_of(
        allocator, strokes, strokes + to->count, to->count,
        (duct_correspondence)duct_settings_choice(self->settings, "align"), self->scale, &style, error);
    duct_release(allocator, strokes);
    return status == DUCT_OK ? add_style(self, &style, error) : status;
}

static duct_status style_named(work *self, const char *name, duct_error *error)
{
    duct_drawing *drawing;
    duct_style style;
    duct_status status = duct_style_read(self->context, name, &drawing, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = duct_style_make(duct_allocator_of(self->context), drawing, name,
                             (duct_correspondence)duct_settings_choice(self->settings, "align"), self->scale,
                             &style, error);
    duct_drawing_free(drawing);
    return status == DUCT_OK ? add_style(self, &style, error) : status;
}

/* "grass", or "ground=grass; #ff0000=waves": one part of it, `size` bytes. */
static duct_status style_part(work *self, const char *part, size_t size, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    const char *equals = memchr(part, '=', size);
    duct_stroke_list list = {NULL, 0};
    const char *name = equals != NULL ? equals + 1 : part;
    name += strspn(name, " ");
    size_t length = (size_t)(part + size - name);
    while (length > 0 && name[length - 1] == ' ') {
        length--;
    }
    duct_status status =
        duct_stroke_list_read(allocator, self->input, equals != NULL ? part : "*",
                              equals != NULL ? (size_t)(equals - part) : 1, "style", &list, error);
    char *text = status == DUCT_OK ? duct_alloc(allocator, length + 1, 1) : NULL;
    if (status == DUCT_OK && text == NULL) {
        status = duct_fail_memory(error);
    }
    if (status == DUCT_OK) {
        memcpy(text, name, length);
        status = style_named(self, text, error);
    }
    for (size_t i = 0; i < list.count && status == DUCT_OK; i++) {
        self->chosen[list.items[i]] = self->style_count;
    }
    duct_release(allocator, text);
    duct_stroke_list_done(allocator, &list);
    return status;
}

static duct_status read_styles(work *self, duct_error *error)
{
    const char *text = duct_settings_text(self->settings, "style");
    duct_status status = DUCT_OK;
    while (status == DUCT_OK && *text != '\0') {
        size_t size = strcspn(text, ";");
        if (strspn(text, " ") < size) {
            status = style_part(self, text, size, error);
        }
        text += size + (text[size] == ';');
    }
    return status;
}

static duct_status read_list(work *self, const char *param, duct_stroke_list *list, duct_error *error)
{
    const char *text = duct_settings_text(self->settings, param);
    return duct_stroke_list_read(duct_allocator_of(self->context), self->input, text, strlen(text), param,
                                 list, error);
}

/* Which strokes are styled, and how. */
static duct_status choose_styles(work *self, const duct_stroke_list lists[3], duct_error *error)
{
    size_t count = duct_drawing_stroke_count(self->input);
    duct_status status = DUCT_OK;
    if (lists[0].count + lists[1].count > 0) {
        status = style_of_strokes(self, &lists[0], &lists[1], error);
        for (size_t i = 0; i < count; i++) {
            self->chosen[i] = 1;
        }
    } else {
        status = read_styles(self, error);
    }
    for (size_t l = 0; l < 3; l++) {
        for (size_t i = 0; i < lists[l].count; i++) {
            self->chosen[lists[l].items[i]] = 0;
        }
    }
    return status;
}

static bool wanted(size_t choice, int style_says, bool otherwise)
{
    return choice == 0 ? style_says < 0 ? otherwise : style_says == 1 : choice == 1;
}

static duct_status make_pieces(work *self, const duct_stroke_list *pins, duct_error *error)
{
    size_t join = duct_settings_choice(self->settings, "join-corners");
    size_t split = duct_settings_choice(self->settings, "split-corners");
    size_t ends = duct_settings_choice(self->settings, "ends");
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < duct_drawing_stroke_count(self->input) && status == DUCT_OK; i++) {
        if (self->chosen[i] > 0) {
            const duct_style *style = &self->styles[self->chosen[i] - 1].style;
            status = duct_pieces_add(&self->pieces, duct_drawing_stroke(self->input, i), i,
                                     self->chosen[i] - 1, wanted(split, style->split_corners, false),
                                     wanted(join, style->join_corners, true), error);
        }
    }
    if (status == DUCT_OK) {
        status =
            duct_pieces_join(&self->pieces, duct_settings_number(self->settings, "join-distance"), error);
    }
    if (status == DUCT_OK && ends > 0) {
        status = duct_pieces_hold_ends(&self->pieces, ends == 2 ? INFINITY : 1, error);
    }
    double weight = INFINITY;
    duct_settings_auto_number(self->settings, "pin-weight", &weight);
    return status == DUCT_OK ? duct_pieces_pin(&self->pieces, self->input, pins, weight, error) : status;
}

/* The parameters of strokes' pieces that lie on one stroke are told apart by their number. */
static uint64_t identity(const work *self, const duct_piece *piece, size_t pass)
{
    uint64_t id = duct_random_id(duct_stroke_id(duct_drawing_stroke(self->input, piece->stroke)));
    return id ^ duct_random_bits(piece->part, pass, 0, 0);
}

static void scale_curve(duct_curve *curve, double factor)
{
    for (size_t i = 0; i < curve->count; i++) {
        curve->x[i] *= factor;
        curve->y[i] *= factor;
    }
}

/* Between B and B': positions, and pressure from the stroke's own (or an even one). */
static void mix(const duct_piece *piece, double amount, duct_curve *result)
{
    size_t hint = 0;
    for (size_t i = 0; i < result->count && amount < 1; i++) {
        double x, y;
        duct_place place = duct_curve_find(&piece->curve, result->t[i], &hint);
        duct_curve_point(&piece->curve, place, &x, &y);
        result->x[i] = x + amount * (result->x[i] - x);
        result->y[i] = y + amount * (result->y[i] - y);
        if (result->extra != NULL) {
            double own = piece->curve.extra != NULL ? duct_curve_extra(&piece->curve, place) : 0.5;
            result->extra[i] = own + amount * (result->extra[i] - own);
        }
    }
}

static duct_status style_piece(const work *self, const duct_piece *piece, size_t pass, duct_curve *result,
                               duct_analogy_figures *figures, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    const duct_stroke *stroke = duct_drawing_stroke(self->input, piece->stroke);
    duct_curve b;
    duct_status status =
        duct_curve_init(allocator, piece->curve.count, piece->curve.closed, false, &b, error);
    if (status != DUCT_OK) {
        return status;
    }
    memcpy(b.t, piece->curve.t, b.count * sizeof *b.t);
    memcpy(b.x, piece->curve.x, b.count * sizeof *b.x);
    memcpy(b.y, piece->curve.y, b.count * sizeof *b.y);
    scale_curve(&b, 1 / self->scale);
    duct_curve_constraint *constraints = duct_alloc(allocator, piece->constraint_count, sizeof *constraints);
    if (constraints == NULL) {
        duct_curve_done(allocator, &b);
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < piece->constraint_count; i++) {
        constraints[i] = piece->constraints[i];
        constraints[i].x /= self->scale;
        constraints[i].y /= self->scale;
    }
    status = duct_analogy_apply(self->styles[piece->style].models[pass], &b, identity(self, piece, pass),
                                constraints, piece->constraint_count, result, figures, error);
    duct_release(allocator, constraints);
    duct_curve_done(allocator, &b);
    if (status != DUCT_OK) {
        char prefix[128];
        snprintf(prefix, sizeof prefix, "stroke '%.60s'", duct_stroke_id(stroke));
        duct_error_prefix(error, prefix);
        return status;
    }
    scale_curve(result, self->scale);
    mix(piece, self->amount, result);
    return duct_analogy_fit(allocator, result, self->fit, duct_stroke_get_style(stroke).width, error);
}

static duct_status style_one(void *arg, size_t worker, size_t index, duct_error *error)
{
    (void)worker;
    const work *self = arg;
    size_t number = index / DUCT_STYLE_PASSES, pass = index % DUCT_STYLE_PASSES;
    const duct_piece *piece = &self->pieces.items[number];
    return pass < self->styles[piece->style].style.pass_count
               ? style_piece(self, piece, pass, &self->results[index], &self->figures[index], error)
               : DUCT_OK;
}

/* Fills a stroke with a result. Channels that the stroke had follow the curve's parameter. */
static duct_status fill_stroke(const work *self, const duct_piece *piece, const duct_curve *result,
                               duct_stroke *to, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    const duct_stroke *from = duct_drawing_stroke(self->input, piece->stroke);
    size_t size = duct_stroke_size(from);
    double *at = duct_alloc(allocator, size, sizeof *at);
    if (at == NULL) {
        return duct_fail_memory(error);
    }
    duct_arc_lengths(duct_stroke_values(from, DUCT_X), duct_stroke_values(from, DUCT_Y), size, at);
    double length = duct_stroke_length(from);
    duct_status status = duct_stroke_resize(to, result->count, error);
    for (int c = 0; c < DUCT_CHANNEL_COUNT && status == DUCT_OK; c++) {
        const double *own = duct_stroke_values(from, (duct_channel)c);
        const double *made = c == DUCT_X ? result->x : c == DUCT_Y ? result->y : NULL;
        made = c == DUCT_PRESSURE && result->extra != NULL ? result->extra : made;
        if (own == NULL && made == NULL) {
            duct_stroke_drop(to, (duct_channel)c);
            continue;
        }
        double *values = duct_stroke_edit(to, (duct_channel)c);
        if (values == NULL) {
            status = duct_fail_memory(error);
            break;
        }
        size_t hint = 0;
        for (size_t i = 0; i < result->count; i++) {
            double where = piece->from + result->t[i] * (piece->to - piece->from);
            where = where > 1 ? where - 1 : where;
            values[i] = made != NULL ? made[i] : duct_interpolate(at, own, size, where * length, &hint);
        }
    }
    duct_release(allocator, at);
    return status;
}

/* The first result takes the stroke's place; the others follow as strokes of their own. */
static duct_status add_result(const work *self, const duct_piece *piece, const duct_curve *result,
                              size_t number, duct_drawing *output, duct_error *error)
{
    const duct_stroke *from = duct_drawing_stroke(self->input, piece->stroke);
    duct_stroke *to;
    duct_status status;
    if (number == 0) {
        status = duct_drawing_add_copy(output, from, &to, error);
        /* The copy has to know that it is changed. */
        to = status == DUCT_OK ? duct_drawing_edit_stroke(output, duct_drawing_stroke_count(output) - 1)
                               : NULL;
    } else {
        char id[256];
        snprintf(id, sizeof id, "%.200s-%zu", duct_stroke_id(from), number + 1);
        status = duct_drawing_add_stroke(output, id, 0, &to, error);
        if (status == DUCT_OK) {
            duct_stroke_set_style(to, duct_stroke_get_style(from));
            status = duct_stroke_set_group(to, duct_stroke_group(from), error);
        }
    }
    if (status == DUCT_OK) {
        duct_stroke_set_closed(to, result->closed);
        status = fill_stroke(self, piece, result, to, error);
    }
    return status;
}

static duct_status make_output(const work *self, duct_tracer *tracer, duct_drawing *output, duct_error *error)
{
    size_t next = 0;
    bool first = true;
    duct_status status = duct_analogy_trace_head(tracer, self->settings, error);
    for (size_t i = 0; i < duct_drawing_stroke_count(self->input) && status == DUCT_OK; i++) {
        const duct_stroke *stroke = duct_drawing_stroke(self->input, i);
        size_t number = 0;
        for (; next < self->pieces.count && self->pieces.items[next].stroke == i && status == DUCT_OK;
             next++) {
            const duct_piece *piece = &self->pieces.items[next];
            for (size_t pass = 0; pass < self->styles[piece->style].style.pass_count && status == DUCT_OK;
                 pass++, number++) {
                size_t at = next * DUCT_STYLE_PASSES + pass;
                status = add_result(self, piece, &self->results[at], number, output, error);
                if (status == DUCT_OK) {
                    status = duct_analogy_trace_curve(tracer, first, duct_stroke_id(stroke),
                                                      &self->figures[at], error);
                    first = false;
                }
            }
        }
        if (number == 0 && status == DUCT_OK) {
            status = duct_drawing_add_copy(output, stroke, NULL, error);
        }
    }
    return status == DUCT_OK && tracer->trace != NULL ? duct_tracer_write(tracer, "\n  ]\n}\n", 7, error)
                                                      : status;
}

static duct_status run_work(work *self, const duct_stroke_list lists[3], duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    duct_status status = choose_styles(self, lists, error);
    if (status == DUCT_OK) {
        status = make_pieces(self, &lists[2], error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    size_t count = self->pieces.count * DUCT_STYLE_PASSES;
    self->results = duct_alloc(allocator, count, sizeof *self->results);
    self->figures = duct_alloc(allocator, count, sizeof *self->figures);
    if (self->results == NULL || self->figures == NULL) {
        return duct_fail_memory(error);
    }
    return self->amount > 0 ? duct_pool_run(self->context, count, 0, 1, style_one, self, error) : DUCT_OK;
}

static duct_status run_analogy(const duct_context *context, const duct_settings *settings,
                               const duct_drawing *input, duct_tracer *tracer, duct_drawing **output,
                               duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    work self = {.context = context,
                 .settings = settings,
                 .input = input,
                 .scale = duct_settings_number(settings, "scale"),
                 .amount = duct_settings_number(settings, "amount"),
                 .fit = duct_settings_number(settings, "fit")};
    static const char *const names[] = {"example-from", "example-to", "pins"};
    duct_stroke_list lists[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    duct_drawing *made = NULL;
    self.pieces.allocator = allocator;
    self.chosen = duct_alloc(allocator, duct_drawing_stroke_count(input), sizeof *self.chosen);
    duct_status status = self.chosen != NULL ? DUCT_OK : duct_fail_memory(error);
    for (size_t l = 0; l < 3 && status == DUCT_OK; l++) {
        status = read_list(&self, names[l], &lists[l], error);
    }
    if (status == DUCT_OK) {
        status = run_work(&self, lists, error);
    }
    if (status == DUCT_OK) {
        if (self.amount > 0) {
            status = duct_drawing_like(context, input, &made, error);
            status = status == DUCT_OK ? make_output(&self, tracer, made, error) : status;
        } else {
            status = duct_drawing_copy(context, input, &made, error);
        }
    }
    for (size_t l = 0; l < 3; l++) {
        duct_stroke_list_done(allocator, &lists[l]);
    }
    work_done(&self);
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    *output = made;
    return DUCT_OK;
}

const duct_operation_impl duct_operation_analogy = {
    {"analogy", "Curve analogies",
     "Redraw the lines of a drawing in the style of an example, A : A' :: B : B'.", params,
     DUCT_ANALOGY_COUNT(params), presets, DUCT_ANALOGY_COUNT(presets)},
    run_analogy,
};
