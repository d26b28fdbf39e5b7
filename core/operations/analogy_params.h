/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATIONS_ANALOGY_PARAMS_H
#define DUCTUS_OPERATIONS_ANALOGY_PARAMS_H

/* What `analogy` and `synthesize-curve` share: parameters, presets, and the settings made of them. */

#include "operations/operation_private.h"
#include "operations/tracer.h"
#include "style/style.h"

extern const duct_choice duct_analogy_invariances[3], duct_analogy_searches[2], duct_analogy_alignments[4];

#define DUCT_ANALOGY_COUNT(array) (sizeof(array) / sizeof(array)[0])
#define DUCT_ANALOGY_CHOICES(array) array, DUCT_ANALOGY_COUNT(array)
#define DUCT_ANALOGY_REAL(id, label, tooltip, unit, minimum, maximum, step, fallback, group)              \
    {                                                                                                     \
        id, label, tooltip, DUCT_PARAM_REAL, unit, minimum, maximum, step, fallback, NULL, 0, group, true \
    }
#define DUCT_ANALOGY_CHOICE(id, label, tooltip, fallback, choices, group)                                   \
    {                                                                                                       \
        id, label, tooltip, DUCT_PARAM_CHOICE, "", 0, 0, 0, fallback, DUCT_ANALOGY_CHOICES(choices), group, \
            true                                                                                            \
    }

#define DUCT_ANALOGY_MATCHING                                                                                \
    DUCT_ANALOGY_CHOICE("invariance", "Invariance",                                                          \
                        "Whether a piece of an example may be turned, or only moved, to fit: what is meant " \
                        "for level lines then stays with level lines.",                                      \
                        "auto", duct_analogy_invariances, "Matching"),                                       \
        DUCT_ANALOGY_REAL("offset-weight", "Offset weight",                                                  \
                          "How firmly the new curve keeps the examples' position beside the plain curve.",   \
                          "", 0, 1000, 0.1, "3.8", "Matching"),                                              \
        DUCT_ANALOGY_REAL("tangent-weight", "Tangent weight",                                                \
                          "How much directions count beside positions; 100000 suits sharp corners.", "", 0,  \
                          1e7, 10, "100", "Matching"),                                                       \
        DUCT_ANALOGY_REAL("coarse-weight", "Coarse weight",                                                  \
                          "How much each level of detail follows the coarser one.", "", 0, 1000, 0.1, "2",   \
                          "Matching"),                                                                       \
        DUCT_ANALOGY_REAL("end-weight", "End weight",                                                        \
                          "How much it counts that a curve's ends are made like the examples' ends.", "", 0, \
                          1e6, 10, "100", "Matching"),                                                       \
        DUCT_ANALOGY_REAL("pressure-weight", "Pressure weight",                                              \
                          "How much the examples' pressure counts in matching.", "", 0, 1e6, 10, "100",      \
                          "Matching"),                                                                       \
        DUCT_ANALOGY_REAL(                                                                                   \
            "foresight", "Foresight",                                                                        \
            "How much what lies ahead on the line counts beside what lies behind; 1 is as in the paper.",    \
            "", 0, 1, 0.05, "0.1", "Matching"),                                                              \
        DUCT_ANALOGY_REAL("coherence", "Coherence",                                                          \
                          "How much is preferred to go on copying where the last point came from.", "", 0,   \
                          1000, 0.1, "1", "Matching"),                                                       \
        DUCT_ANALOGY_REAL("randomness", "Randomness",                                                        \
                          "0 always takes the best match; 0.1 chooses among those up to a tenth worse.", "", \
                          0, 10, 0.05, "0.1", "Matching"),                                                   \
        {"neighbourhood",                                                                                    \
         "Neighbourhood",                                                                                    \
         "How many samples of a curve are compared around each point.",                                      \
         DUCT_PARAM_INT,                                                                                     \
         "samples",                                                                                          \
         5,                                                                                                  \
         401,                                                                                                \
         2,                                                                                                  \
         "81",                                                                                               \
         NULL,                                                                                               \
         0,                                                                                                  \
         "Matching",                                                                                         \
         true},                                                                                              \
        DUCT_ANALOGY_REAL("spacing", "Spacing",                                                              \
                          "Distance of the new curve's points, in the examples' size.", "pixels", 0.05, 100, \
                          0.1, "1", "Matching"),                                                             \
        {"levels",                                                                                           \
         "Levels",                                                                                           \
         "How many levels of detail are made one after another; 0: as many as suit the examples.",           \
         DUCT_PARAM_INT,                                                                                     \
         "",                                                                                                 \
         0,                                                                                                  \
         32,                                                                                                 \
         1,                                                                                                  \
         "0",                                                                                                \
         NULL,                                                                                               \
         0,                                                                                                  \
         "Matching",                                                                                         \
         true},                                                                                              \
        {"passes",                                                                                           \
         "Passes",                                                                                           \
         "How often each level is gone over.",                                                               \
         DUCT_PARAM_INT,                                                                                     \
         "",                                                                                                 \
         1,                                                                                                  \
         10,                                                                                                 \
         1,                                                                                                  \
         "1",                                                                                                \
         NULL,                                                                                               \
         0,                                                                                                  \
         "Matching",                                                                                         \
         true},                                                                                              \
        DUCT_ANALOGY_CHOICE("align", "Correspondence",                                                       \
                            "Which points of an example's two curves belong "                                \
                            "together.",                                                                     \
                            "auto", duct_analogy_alignments, "Matching"),                                    \
        DUCT_ANALOGY_CHOICE("search", "Search", "How the best matching place is found.", "fast",             \
                            duct_analogy_searches, "Matching"),                                              \
        DUCT_ANALOGY_REAL("fit", "Fit",                                                                      \
                          "Points of the new curve are left out where it changes by no more than this.",     \
                          "pixels", 0, 100, 0.05, "0.05", "Result")

/* The system's options; what is "auto" follows the style. `shape-weight` is read where `analogy` has it. */
duct_analogy_options duct_analogy_options_from(const duct_settings *settings, const duct_style *style,
                                               bool shape);

/* The models of a style's passes. Errors: duct_analogy_new()'s. */
duct_status duct_analogy_models(const duct_context *context, const duct_settings *settings,
                                const duct_style *style, bool shape, duct_analogy *models[DUCT_STYLE_PASSES],
                                duct_error *error);

/* Begins the trace: operation and settings. The array "strokes" is left open. */
duct_status duct_analogy_trace_head(duct_tracer *tracer, const duct_settings *settings, duct_error *error);

/* Adds what a result is like, as a member of the trace's array. */
duct_status duct_analogy_trace_curve(duct_tracer *tracer, bool first, const char *id,
                                     const duct_analogy_figures *figures, duct_error *error);

/* Leaves out points of a curve that lie within `tolerance` of the line between those that stay; `width` turns
 * pressure into pixels. In place. Errors: DUCT_NO_MEMORY. */
duct_status duct_analogy_fit(const duct_allocator *allocator, duct_curve *curve, double tolerance,
                             double width, duct_error *error);

#endif
