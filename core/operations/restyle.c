/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The operation `restyle`: "HelpingHand" for a whole drawing. */
#include "operations/operation_private.h"

#include "base/error.h"
#include "base/pool.h"
#include "helpinghand/helpinghand.h"

#include <math.h>
#include <stdio.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static const duct_choice modes[] = {
    {"pose", "Pose only", "Keep every line where it is; give it the hand's pressure, tilt and twist."},
    {"trajectory", "Trajectory only",
     "Redraw the lines with the hand's shapes; leave pressure, tilt and twist alone."},
    {"one-pass", "Both at once", "Shapes and pose from the same places of the recordings: faster."},
    {"two-pass", "Shapes, then pose",
     "Redraw the lines first, then give the new lines their pose: fits best."},
};
static const duct_choice channel_rules[] = {
    {"auto", "As it fits",
     "A line that stays in place keeps the pose it was recorded with; a redrawn line gets the hand's."},
    {"missing", "Fill missing", "Keep every channel that the drawing has; add those it lacks."},
    {"all", "Replace all", "Replace whatever pose the drawing has by the hand's."},
};
static const duct_choice feature_kinds[] = {
    {"velocities", "Filtered velocities", "Compares the course of the line before and behind each point."},
    {"contexts", "Shape contexts",
     "Compares where the line before and behind each point lies: mixes letters up less, but is noisier."},
};
static const duct_choice searches[] = {
    {"exact", "Exact",
     "Compares with everything that could be near; the fastest for ordinary libraries as well."},
    {"flann", "FLANN", "FLANN's single kd-tree."},
    {"patchmatch", "PatchMatch", "Searches by chance and spreads what it finds along the line: approximate."},
};
static const duct_choice selections[] = {
    {"optimal", "Optimal sequence", "A few long pieces of the recordings that fit together best."},
    {"average", "Weighted average", "The average of similar places: smoother than the hand itself."},
    {"closest", "Closest neighbour",
     "The most similar place for every point by itself: jumpy; for comparison."},
};
static const duct_choice anchor_choices[] = {
    {"on", "On", "The line keeps the drawing's corners and course, and its ends stay in place."},
    {"paper", "As in the paper", "The same, but the ends may swing a little."},
    {"off", "Off", "The hand's movements are strung together: the line drifts away from the drawing."},
};

#define NO_CHOICE NULL, 0
#define CHOICES(array) array, COUNT(array)

static const duct_param params[] = {
    {"hand", "Hand", "Whose hand draws: the name of a hand, or a library or recording.", DUCT_PARAM_HAND, "",
     0, 0, 0, "", NO_CHOICE, "Hand", false},
    {"mode", "Mode", "What the hand changes.", DUCT_PARAM_CHOICE, "", 0, 0, 0, "two-pass", CHOICES(modes),
     "Hand", false},
    {"channels", "Channels", "What happens to pressure, tilt and twist that the drawing already has.",
     DUCT_PARAM_CHOICE, "", 0, 0, 0, "auto", CHOICES(channel_rules), "Hand", false},
    {"amount", "Amount", "0 leaves the drawing as it is, 1 is the full effect.", DUCT_PARAM_REAL, "", 0, 1,
     0.05, "1", NO_CHOICE, "Hand", false},
    {"scale", "Scale",
     "How large the hand's recorded strokes are taken to be in this drawing: 1 is the size they were "
     "recorded at; auto "
     "lets typical strokes of both have the same size.",
     DUCT_PARAM_AUTO, "times", 0.001, 1000, 0.1, "auto", NO_CHOICE, "Hand", false},
    {"refine", "Fine detail",
     "With scale auto: small and intricate lines are compared at a finer scale of their own, so that they "
     "keep their shape.",
     DUCT_PARAM_BOOL, "", 0, 1, 1, "true", NO_CHOICE, "Hand", true},
    {"variation", "Variation",
     "Lets the same shape come out differently each time; 0 always takes the best match.", DUCT_PARAM_REAL,
     "", 0, 10, 0.1, "0", NO_CHOICE, "Hand", false},
    {"seed", "Seed", "Which of the possible variations; the same seed gives the same drawing.",
     DUCT_PARAM_SEED, "", 0, 0, 1, "0", NO_CHOICE, "Hand", false},

    {"select", "Selection", "How a place of the recordings is chosen for each point of a line.",
     DUCT_PARAM_CHOICE, "", 0, 0, 0, "optimal", CHOICES(selections), "Matching", true},
    {"features", "Features", "How the shapes of lines are compared.", DUCT_PARAM_CHOICE, "", 0, 0, 0,
     "velocities", CHOICES(feature_kinds), "Matching", true},
    {"search", "Search", "How similar places are found.", DUCT_PARAM_CHOICE, "", 0, 0, 0, "exact",
     CHOICES(searches), "Matching", true},
    {"neighbours", "Neighbours", "How many similar places are considered for each point's pose.",
     DUCT_PARAM_INT, "", 1, 100, 1, "20", NO_CHOICE, "Matching", true},
    {"coherent", "Coherent", "Also consider the places that follow those considered for the point before.",
     DUCT_PARAM_BOOL, "", 0, 1, 1, "true", NO_CHOICE, "Matching", true},
    {"reach", "Reach", "How far before and behind a point its line is compared.", DUCT_PARAM_REAL, "samples",
     7, 500, 1, "40", NO_CHOICE, "Matching", true},
    {"shape-weight", "Shape weight", "How much shape counts beside the closeness to a line's ends.",
     DUCT_PARAM_REAL, "", 0, 100, 0.05, "0.3", NO_CHOICE, "Matching", true},

    {"stretch-cost", "Stretch cost", "Pose: cost of using a recorded sample twice.", DUCT_PARAM_REAL, "", 0,
     10000, 1, "3", NO_CHOICE, "Pose", true},
    {"shrink-cost", "Shrink cost", "Pose: cost of leaving a recorded sample out.", DUCT_PARAM_REAL, "", 0,
     10000, 1, "3", NO_CHOICE, "Pose", true},
    {"jump-cost", "Jump cost", "Pose: cost of going on at another place of the recordings.", DUCT_PARAM_REAL,
     "", 0, 10000, 1, "50", NO_CHOICE, "Pose", true},
    {"pose-cost", "Pose cost", "Pose: cost of the change of pose at a jump, for each standard deviation.",
     DUCT_PARAM_REAL, "", 0, 10000, 1, "10", NO_CHOICE, "Pose", true},
    {"shortest", "Shortest piece", "Pose: pieces of the recordings shorter than this cost extra.",
     DUCT_PARAM_INT, "samples", 1, 32, 1, "12", NO_CHOICE, "Pose", true},
    {"short-cost", "Short piece cost", "Pose: base of the cost of a short piece, squared with what it lacks.",
     DUCT_PARAM_REAL, "", 0, 10000, 1, "3", NO_CHOICE, "Pose", true},
    {"end-cost", "End cost",
     "Pose: cost of each sample that a line's end is away from a recorded line's end.", DUCT_PARAM_REAL, "",
     0, 10000, 1, "3", NO_CHOICE, "Pose", true},
    {"blend", "Blend", "Pose: samples on each side of a jump that are faded over.", DUCT_PARAM_INT, "samples",
     0, 100, 1, "6", NO_CHOICE, "Pose", true},

    {"trajectory-neighbours", "Neighbours",
     "How many similar places are considered for each point's movement.", DUCT_PARAM_INT, "", 1, 100, 1, "20",
     NO_CHOICE, "Trajectory", true},
    {"trajectory-stretch-cost", "Stretch cost", "Trajectory: cost of using a recorded sample twice.",
     DUCT_PARAM_REAL, "", 0, 10000, 1, "3", NO_CHOICE, "Trajectory", true},
    {"trajectory-shrink-cost", "Shrink cost", "Trajectory: cost of leaving a recorded sample out.",
     DUCT_PARAM_REAL, "", 0, 10000, 1, "3", NO_CHOICE, "Trajectory", true},
    {"trajectory-jump-cost", "Jump cost", "Trajectory: cost of going on at another place of the recordings.",
     DUCT_PARAM_REAL, "", 0, 10000, 1, "50", NO_CHOICE, "Trajectory", true},
    {"direction-cost", "Direction cost", "Trajectory: cost of the change of direction at a jump.",
     DUCT_PARAM_REAL, "", 0, 10000, 1, "10", NO_CHOICE, "Trajectory", true},
    {"trajectory-shortest", "Shortest piece",
     "Trajectory: pieces of the recordings shorter than this cost extra.", DUCT_PARAM_INT, "samples", 1, 32,
     1, "12", NO_CHOICE, "Trajectory", true},
    {"trajectory-short-cost", "Short piece cost",
     "Trajectory: base of the cost of a short piece, squared with what it lacks.", DUCT_PARAM_REAL, "", 0,
     10000, 1, "3", NO_CHOICE, "Trajectory", true},
    {"trajectory-end-cost", "End cost",
     "Trajectory: cost of each sample that a line's end is away from a recorded line's end.", DUCT_PARAM_REAL,
     "", 0, 10000, 1, "3", NO_CHOICE, "Trajectory", true},
    {"trajectory-blend", "Blend", "Trajectory: samples on each side of a jump that are faded over.",
     DUCT_PARAM_INT, "samples", 0, 100, 1, "6", NO_CHOICE, "Trajectory", true},

    {"anchors", "Anchors", "Whether the new line is held to the drawing's ends, corners and course.",
     DUCT_PARAM_CHOICE, "", 0, 0, 0, "on", CHOICES(anchor_choices), "Shape", true},
    {"anchor-gap", "Anchor gap",
     "No two anchors are farther apart than this, so that long straight lines stay straight.", DUCT_PARAM_INT,
     "samples", 2, 1000, 1, "24", NO_CHOICE, "Shape", true},
    {"leeway", "Leeway", "How far the new line may stray from the drawing's.", DUCT_PARAM_REAL, "samples",
     0.1, 1e6, 0.5, "3", NO_CHOICE, "Shape", true},
    {"anchor-weight", "Anchor weight", "How firmly the anchors hold the line.", DUCT_PARAM_REAL, "", 0, 1000,
     0.05, "1", NO_CHOICE, "Shape", true},
    {"curvature-weight", "Curvature weight", "How firmly the line keeps the hand's curvature at the anchors.",
     DUCT_PARAM_REAL, "", 0, 1000, 0.1, "2", NO_CHOICE, "Shape", true},
    {"curvature-reach", "Curvature reach", "How many samples around an anchor keep the hand's curvature.",
     DUCT_PARAM_INT, "samples", 0, 50, 1, "2", NO_CHOICE, "Shape", true},
    {"corner-angle", "Corner angle", "A turn sharper than this is a corner to be kept.", DUCT_PARAM_REAL,
     "degrees", 1, 180, 5, "60", NO_CHOICE, "Shape", true},
    {"vertex-cost", "Vertex cost",
     "How much the drawing's course must deviate from a straight line before another anchor is set.",
     DUCT_PARAM_REAL, "square samples", 0, 1e6, 1, "1", NO_CHOICE, "Shape", true},
};

static const duct_preset_value paper_values[] = {
    {"anchors", "paper"},  {"coherent", "false"}, {"anchor-gap", "1000"}, {"anchor-weight", "0.25"},
    {"vertex-cost", "30"}, {"refine", "false"},   {"channels", "all"}};
static const duct_preset_value faithful_values[] = {{"mode", "pose"}};

static const duct_preset presets[] = {
    {"default", "Default", "What suits most drawings.", NULL, 0},
    {"paper", "As in the paper", "The values and steps of the HelpingHand paper.", paper_values,
     COUNT(paper_values)},
    {"pose-only", "Keep my lines", "Every line stays where it is and gets the hand's pose.", faithful_values,
     COUNT(faithful_values)},
};

static duct_pass_options pass_options(const duct_settings *settings, const char *prefix, const char *distance)
{
    char id[64];
#define PASS(name) (snprintf(id, sizeof id, "%s%s", prefix, name), id)
    duct_pass_options pass;
    pass.neighbours = duct_settings_size(settings, PASS("neighbours"));
    pass.costs.stretch = duct_settings_number(settings, PASS("stretch-cost"));
    pass.costs.shrink = duct_settings_number(settings, PASS("shrink-cost"));
    pass.costs.jump = duct_settings_number(settings, PASS("jump-cost"));
    pass.costs.distance = duct_settings_number(settings, distance);
    pass.costs.shortest = duct_settings_size(settings, PASS("shortest"));
    pass.costs.brief = duct_settings_number(settings, PASS("short-cost"));
    pass.costs.end = duct_settings_number(settings, PASS("end-cost"));
    pass.blend = duct_settings_size(settings, PASS("blend"));
#undef PASS
    return pass;
}

/* The tables' choices, in the order of the enumerations they stand for. */
static duct_helpinghand_options options_from(const duct_settings *settings)
{
    static const duct_search_kind search_kinds[] = {DUCT_SEARCH_EXACT, DUCT_SEARCH_FLANN,
                                                    DUCT_SEARCH_PATCHMATCH};
    static const duct_anchors anchor_kinds[] = {DUCT_ANCHORS_ON, DUCT_ANCHORS_PAPER, DUCT_ANCHORS_OFF};
    duct_helpinghand_options options;
    options.mode = (duct_stylization)duct_settings_choice(settings, "mode");
    options.select = (duct_selection)duct_settings_choice(settings, "select");
    options.features.kind = (duct_feature_kind)duct_settings_choice(settings, "features");
    options.features.reach = duct_settings_number(settings, "reach");
    options.features.weight = duct_settings_number(settings, "shape-weight");
    options.search = search_kinds[duct_settings_choice(settings, "search")];
    options.coherent = duct_settings_bool(settings, "coherent");
    options.pose = pass_options(settings, "", "pose-cost");
    options.trajectory = pass_options(settings, "trajectory-", "direction-cost");
    options.shape.anchors = anchor_kinds[duct_settings_choice(settings, "anchors")];
    options.shape.corner = duct_settings_number(settings, "corner-angle") * M_PI / 180;
    options.shape.vertex_cost = duct_settings_number(settings, "vertex-cost");
    options.shape.leeway = duct_settings_number(settings, "leeway");
    options.shape.longest = duct_settings_size(settings, "anchor-gap");
    options.shape.anchor_weight = duct_settings_number(settings, "anchor-weight");
    options.shape.curvature_weight = duct_settings_number(settings, "curvature-weight");
    options.shape.curvature_reach = duct_settings_size(settings, "curvature-reach");
    size_t rule = duct_settings_choice(settings, "channels");
    options.keep = rule == 1 || (rule == 0 && options.mode == DUCT_STYLIZE_POSE);
    options.amount = duct_settings_number(settings, "amount");
    options.variation = duct_settings_number(settings, "variation");
    options.seed = duct_settings_seed(settings, "seed");
    return options;
}

typedef struct {
    const duct_context *context;
    const duct_helpinghand *hand;
    duct_drawing *drawing;
    duct_tracer *tracer;
} work;

static duct_status stylize_one(void *arg, size_t worker, size_t index, duct_error *error)
{
    (void)worker;
    const work *self = arg;
    duct_stroke *stroke = duct_drawing_edit_stroke(self->drawing, index);
    if (self->tracer->trace == NULL) {
        return duct_helpinghand_stylize(self->hand, stroke, NULL, error);
    }
    duct_text text;
    duct_text_init(&text, self->tracer->allocator);
    duct_status status = duct_helpinghand_stylize(self->hand, stroke, &text, error);
    size_t size = 0;
    char *data = status == DUCT_OK ? duct_text_take(&text, &size) : NULL;
    duct_text_free(&text);
    if (status == DUCT_OK && data == NULL) {
        status = duct_fail_memory(error);
    }
    return status == DUCT_OK ? duct_tracer_stroke(self->tracer, index, data, size, error) : status;
}

/* The trace's head: what is the same for all strokes. */
static duct_status trace_head(duct_tracer *tracer, const duct_settings *settings,
                              const duct_helpinghand *hand, duct_error *error)
{
    duct_text text;
    duct_json json;
    duct_text_init(&text, tracer->allocator);
    duct_json_init(&json, &text);
    duct_json_object(&json, NULL);
    duct_json_string(&json, "operation", "restyle");
    duct_json_object(&json, "settings");
    for (size_t i = 0; i < COUNT(params); i++) {
        duct_json_string(&json, params[i].id, duct_settings_text(settings, params[i].id));
    }
    duct_json_close(&json, '}');
    duct_json_number(&json, "unit", hand->unit);
    duct_json_object(&json, "library");
    duct_json_string(&json, "name", duct_library_name(hand->library));
    duct_json_integer(&json, "strokes", (long long)duct_library_stroke_count(hand->library));
    duct_json_integer(&json, "samples", (long long)duct_library_sample_count(hand->library));
    duct_json_row(&json, "stroke_samples", '[');
    for (size_t s = 0; s < duct_library_stroke_count(hand->library); s++) {
        duct_json_integer(&json, NULL, (long long)duct_library_stroke_samples(hand->library, s));
    }
    duct_json_close(&json, ']');
    duct_json_close(&json, '}');
    duct_text_add(&text, ",\n  \"strokes\": [\n");
    duct_status status =
        text.failed ? duct_fail_memory(error) : duct_tracer_write(tracer, text.data, text.size, error);
    duct_text_free(&text);
    return status;
}

static duct_status stylize_all(work *self, const duct_settings *settings, duct_error *error)
{
    bool traced = self->tracer->trace != NULL;
    /* With amount 0 no stroke may even be touched. */
    size_t count = self->hand->options.amount > 0 ? duct_drawing_stroke_count(self->drawing) : 0;
    duct_status status = DUCT_OK;
    if (traced) {
        status = trace_head(self->tracer, settings, self->hand, error);
        if (status == DUCT_OK) {
            status = duct_tracer_expect(self->tracer, count, error);
        }
    }
    if (status == DUCT_OK) {
        status = duct_pool_run(self->context, count, 0, 1, stylize_one, self, error);
    }
    if (status == DUCT_OK && traced) {
        status = duct_tracer_write(self->tracer, "\n  ]\n}\n", 7, error);
    }
    return status;
}

static duct_status choose_unit(const duct_context *context, const duct_settings *settings,
                               const duct_library *library, const duct_drawing *input, double *unit,
                               duct_error *error)
{
    double scale;
    if (duct_settings_auto_number(settings, "scale", &scale)) {
        *unit = duct_library_unit(library) * scale;
        return DUCT_OK;
    }
    return duct_helpinghand_auto_unit(duct_allocator_of(context), library, input, unit, error);
}

static duct_status run_restyle(const duct_context *context, const duct_settings *settings,
                               const duct_drawing *input, duct_tracer *tracer, duct_drawing **output,
                               duct_error *error)
{
    const duct_library *library;
    duct_library *opened;
    duct_status status = duct_settings_hand(context, settings, "hand", &library, &opened, error);
    if (status != DUCT_OK) {
        return status;
    }
    duct_helpinghand_options options = options_from(settings);
    duct_drawing *drawing = NULL;
    double unit = 0, scale;
    bool refine =
        duct_settings_bool(settings, "refine") && !duct_settings_auto_number(settings, "scale", &scale);
    status = choose_unit(context, settings, library, input, &unit, error);
    if (status == DUCT_OK) {
        status = duct_drawing_copy(context, input, &drawing, error);
    }
    if (status == DUCT_OK && (options.amount > 0 || tracer->trace != NULL)) {
        duct_helpinghand hand;
        status =
            duct_helpinghand_init(duct_allocator_of(context), library, &options, unit, refine, &hand, error);
        if (status == DUCT_OK) {
            work arg = {context, &hand, drawing, tracer};
            status = stylize_all(&arg, settings, error);
            duct_helpinghand_done(&hand);
        }
    }
    duct_library_free(opened);
    if (status != DUCT_OK) {
        duct_drawing_free(drawing);
        return status;
    }
    *output = drawing;
    return DUCT_OK;
}

const duct_operation_impl duct_operation_restyle = {
    {"restyle", "Restyle with a hand", "Redraw the lines of a drawing as a recorded hand would draw them.",
     params, COUNT(params), presets, COUNT(presets)},
    run_restyle,
};
