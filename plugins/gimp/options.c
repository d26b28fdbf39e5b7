/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "options.h"

#include <cairo.h>
#include <string.h>

#define COUNT(array) (sizeof(array) / sizeof(array)[0])
#define NO_CHOICE NULL, 0
#define CHOICES(array) array, COUNT(array)

static const duct_choice lines[] = {
    {LINES_PATH, "Active path", "The path that is active in the dialog of paths."},
    {LINES_VISIBLE, "Visible paths", "Every path whose eye is shown in the dialog of paths."},
    {LINES_SELECTION, "Outline of the selection", "The selection's border; the selection does not clip it."},
    {LINES_ART, "Line art of the active layer", "The centre lines of what is drawn or scanned on the layer."},
};
static const duct_choice results[] = {
    {RESULT_LAYER, "New layer", "The strokes are painted on a new layer above the active one."},
    {RESULT_ONTO, "Active layer", "The strokes are painted on the active layer, mask or channel."},
    {RESULT_PATHS, "New paths", "The new lines become paths with few nodes; nothing is painted."},
    {RESULT_BOTH, "New layer and paths", "Both a painted layer and paths."},
};
static const duct_choice colours[] = {
    {"foreground", "Foreground colour", "The colour that GIMP's tools paint with."},
    {"line-art", "Colours of the line art", "Each stroke in the mean colour of the line that it repaints."},
};
static const duct_choice inks[] = {
    {"auto", "Whichever is rarer", "Dark lines on light paper, or light ones on dark."},
    {"dark", "Dark lines", "What is darker than the paper is a line."},
    {"light", "Light lines", "What is lighter than the ground is a line."},
};

/* Layer modes that cairo has too, so that the preview shows what will come out. */
static const struct {
    GimpLayerMode mode;
    cairo_operator_t operator;
} modes[] = {
    {GIMP_LAYER_MODE_NORMAL, CAIRO_OPERATOR_OVER},
    {GIMP_LAYER_MODE_MULTIPLY, CAIRO_OPERATOR_MULTIPLY},
    {GIMP_LAYER_MODE_SCREEN, CAIRO_OPERATOR_SCREEN},
    {GIMP_LAYER_MODE_OVERLAY, CAIRO_OPERATOR_OVERLAY},
    {GIMP_LAYER_MODE_DARKEN_ONLY, CAIRO_OPERATOR_DARKEN},
    {GIMP_LAYER_MODE_LIGHTEN_ONLY, CAIRO_OPERATOR_LIGHTEN},
    {GIMP_LAYER_MODE_DODGE, CAIRO_OPERATOR_COLOR_DODGE},
    {GIMP_LAYER_MODE_BURN, CAIRO_OPERATOR_COLOR_BURN},
    {GIMP_LAYER_MODE_HARDLIGHT, CAIRO_OPERATOR_HARD_LIGHT},
    {GIMP_LAYER_MODE_SOFTLIGHT, CAIRO_OPERATOR_SOFT_LIGHT},
    {GIMP_LAYER_MODE_DIFFERENCE, CAIRO_OPERATOR_DIFFERENCE},
};
static const duct_choice blends[] = {
    {"normal", "Normal", ""},
    {"multiply", "Multiply", ""},
    {"screen", "Screen", ""},
    {"overlay", "Overlay", ""},
    {"darken-only", "Darken only", ""},
    {"lighten-only", "Lighten only", ""},
    {"dodge", "Dodge", ""},
    {"burn", "Burn", ""},
    {"hard-light", "Hard light", ""},
    {"soft-light", "Soft light", ""},
    {"difference", "Difference", ""},
};
_Static_assert(COUNT(blends) == COUNT(modes), "a layer mode for every choice");

static const duct_param params[] = {
    {OPTION_LINES, "Lines", "Which lines the strokes are made from.", DUCT_PARAM_CHOICE, "", 0, 0, 0,
     LINES_PATH, CHOICES(lines), "Lines and paint", false},
    {OPTION_RESULT, "Result", "What the strokes become.", DUCT_PARAM_CHOICE, "", 0, 0, 0, RESULT_LAYER,
     CHOICES(results), "Lines and paint", false},
    {OPTION_BRUSH, "Brush", "The brush that paints: one of Ductus, a MyPaint brush, or a .myb file.",
     DUCT_PARAM_HAND, "", 0, 0, 0, "ink", NO_CHOICE, "Lines and paint", false},
    {OPTION_SIZE, "Size",
     "The brush's full width at middling pressure; auto: the width of the line art's lines, and for paths "
     "the "
     "brush's own.",
     DUCT_PARAM_AUTO, "pixels", 0.1, 2000, 1, "auto", NO_CHOICE, "Lines and paint", false},
    {OPTION_OPACITY, "Opacity", "Of the painted layer.", DUCT_PARAM_REAL, "percent", 0, 100, 5, "100",
     NO_CHOICE, "Lines and paint", false},
    {OPTION_BLEND, "Layer mode", "How the painted layer is laid over what is below it.", DUCT_PARAM_CHOICE,
     "", 0, 0, 0, "normal", CHOICES(blends), "Lines and paint", false},
    {OPTION_COLOUR, "Colour", "The colour of the strokes.", DUCT_PARAM_CHOICE, "", 0, 0, 0, "foreground",
     CHOICES(colours), "Lines and paint", false},
    {OPTION_CLIP, "Stay inside",
     "Paint only inside the selection, and on a new layer also only where the active one could be painted "
     "on: "
     "where its locked alpha and its mask let paint through.",
     DUCT_PARAM_BOOL, "", 0, 1, 1, "true", NO_CHOICE, "Lines and paint", true},
    {OPTION_TOLERANCE, "Path tolerance", "How far new paths may be from the strokes; more means fewer nodes.",
     DUCT_PARAM_REAL, "pixels", 0.01, 100, 0.1, "0.5", NO_CHOICE, "Lines and paint", true},

    {OPTION_HIDE, "Hide the line art", "Makes the layer that was repainted invisible.", DUCT_PARAM_BOOL, "",
     0, 1, 1, "true", NO_CHOICE, "Line art", true},
    {OPTION_INK, "Ink", "What counts as a line.", DUCT_PARAM_CHOICE, "", 0, 0, 0, "auto", CHOICES(inks),
     "Line art", true},
    {OPTION_THRESHOLD, "Threshold",
     "How dark a line has to be, from 0 as the paper to 1 as the darkest ink; auto: told from the picture.",
     DUCT_PARAM_AUTO, "", 0.01, 0.99, 0.05, "auto", NO_CHOICE, "Line art", true},
    {OPTION_WIDEST, "Widest line", "What is wider than this is an area and is left out.", DUCT_PARAM_REAL,
     "pixels", 1, 1000, 5, "100", NO_CHOICE, "Line art", true},
    {OPTION_SHORTEST, "Shortest line", "Specks and hairs shorter than this are left out.", DUCT_PARAM_REAL,
     "pixels", 0, 1000, 1, "4", NO_CHOICE, "Line art", true},
};

static const duct_preset presets[] = {{"default", "Default", "All values at their defaults.", NULL, 0}};

const duct_operation plug_options = {
    "gimp", "GIMP", "What becomes of the strokes in GIMP.", params, COUNT(params), presets, COUNT(presets)};

bool plug_option_is_brush(const duct_param *param)
{
    return param >= params && param < params + COUNT(params) && strcmp(param->id, OPTION_BRUSH) == 0;
}

bool plug_option_is(const duct_settings *options, const char *id, const char *value)
{
    return strcmp(duct_settings_text(options, id), value) == 0;
}

bool plug_option_bool(const duct_settings *options, const char *id)
{
    return plug_option_is(options, id, "true");
}

double plug_option_number(const duct_settings *options, const char *id, double otherwise)
{
    const char *text = duct_settings_text(options, id);
    return strcmp(text, "auto") == 0 ? otherwise : g_ascii_strtod(text, NULL);
}

static size_t blend_index(const duct_settings *options)
{
    for (size_t i = 0; i < COUNT(blends); i++) {
        if (plug_option_is(options, OPTION_BLEND, blends[i].id)) {
            return i;
        }
    }
    return 0;
}

GimpLayerMode plug_option_mode(const duct_settings *options)
{
    return modes[blend_index(options)].mode;
}

int plug_option_operator(const duct_settings *options)
{
    return (int)modes[blend_index(options)].operator;
}

bool plug_option_paints(const duct_settings *options)
{
    return !plug_option_is(options, OPTION_RESULT, RESULT_PATHS);
}

bool plug_option_makes_paths(const duct_settings *options)
{
    return plug_option_is(options, OPTION_RESULT, RESULT_PATHS) ||
           plug_option_is(options, OPTION_RESULT, RESULT_BOTH);
}
