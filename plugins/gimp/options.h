/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_OPTIONS_H
#define PLUG_OPTIONS_H

#include <ductus/operation.h>

#include <libgimp/gimp.h>

/* What GIMP needs to know beside an operation's own settings: which lines, what becomes of the result, brush
 * and paint. It is a table as an operation has one, so that the same code makes arguments, controls and
 * stored values of both. */
extern const duct_operation plug_options;

/* The ids of the table that code asks for. */
#define OPTION_LINES "lines"
#define OPTION_RESULT "result"
#define OPTION_BRUSH "brush"
#define OPTION_SIZE "size"
#define OPTION_OPACITY "opacity"
#define OPTION_BLEND "layer-mode"
#define OPTION_COLOUR "colour"
#define OPTION_CLIP "clip"
#define OPTION_HIDE "hide"
#define OPTION_TOLERANCE "tolerance"
#define OPTION_INK "ink"
#define OPTION_THRESHOLD "threshold"
#define OPTION_WIDEST "widest-line"
#define OPTION_SHORTEST "shortest-line"

/* Values of the choice `lines`. */
#define LINES_PATH "path"
#define LINES_VISIBLE "visible-paths"
#define LINES_SELECTION "selection"
#define LINES_ART "line-art"

/* Values of the choice `result`. */
#define RESULT_LAYER "layer"
#define RESULT_ONTO "active-layer"
#define RESULT_PATHS "paths"
#define RESULT_BOTH "both"

/* True where the parameter holds a brush; it is text as a hand is. */
bool plug_option_is_brush(const duct_param *param);

bool plug_option_is(const duct_settings *options, const char *id, const char *value);
bool plug_option_bool(const duct_settings *options, const char *id);

/* A number; `otherwise` where it is "auto". */
double plug_option_number(const duct_settings *options, const char *id, double otherwise);

/* GIMP's layer mode for the choice `layer-mode`, and the cairo operator that shows it in previews. */
GimpLayerMode plug_option_mode(const duct_settings *options);
int plug_option_operator(const duct_settings *options);

/* True where the result has pixels, and where it has paths. */
bool plug_option_paints(const duct_settings *options);
bool plug_option_makes_paths(const duct_settings *options);

#endif
