/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATION_H
#define DUCTUS_OPERATION_H

#include <ductus/drawing.h>
#include <ductus/library.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* An operation takes a drawing and settings and gives a drawing. It is described once, by a constant table of
 * parameters; the command line, the dialogs of every host and the reference pages are made from that table.
 * Host programs and bindings know the tables and no operation by name. */

typedef enum duct_param_type {
    DUCT_PARAM_BOOL,   /* "true" or "false" */
    DUCT_PARAM_INT,    /* a whole number in minimum..maximum */
    DUCT_PARAM_REAL,   /* a finite number in minimum..maximum */
    DUCT_PARAM_CHOICE, /* the id of one of the choices */
    DUCT_PARAM_AUTO,   /* "auto", or a real number as above */
    DUCT_PARAM_SEED,   /* a whole number in 0..2^63-1 */
    DUCT_PARAM_HAND,   /* the name of a hand, or the path of a library or recording */
    DUCT_PARAM_STYLE,  /* the name of a style, or the path of a drawing with example curves; or several, each
                          for some strokes: "STROKES=STYLE; STROKES=STYLE" */
    DUCT_PARAM_STROKES /* strokes of the drawing, for a host those selected: their ids, group names, colours
                          ("#rrggbb") or numbers ("@1" is the first one), separated by commas; "": none */
} duct_param_type;

typedef struct duct_choice {
    const char *id;
    const char *label;
    const char *tooltip;
} duct_choice;

/* One parameter. All text is UTF-8 in static storage. */
typedef struct duct_param {
    const char *id;      /* lower case with hyphens; the command line's option without its dashes */
    const char *label;   /* for dialogs, without colon */
    const char *tooltip; /* one or two sentences */
    duct_param_type type;
    const char *unit;           /* "pixels", "samples", ...; "" for a plain number */
    double minimum, maximum;    /* both included; for numbers only */
    double step;                /* what one press of a spin button changes; for numbers only */
    const char *fallback;       /* the default, written as a user would; "" for a hand: has to be given;
                                   for strokes: none */
    const duct_choice *choices; /* `choice_count` of them; NULL where there are none */
    size_t choice_count;
    const char *group; /* the heading under which dialogs put it */
    bool advanced;     /* dialogs may hide it at first */
} duct_param;

/* A named set of values; parameters that it does not name are at their defaults. */
typedef struct duct_preset_value {
    const char *param;
    const char *value;
} duct_preset_value;

typedef struct duct_preset {
    const char *id;
    const char *label;
    const char *tooltip;
    const duct_preset_value *values;
    size_t value_count;
} duct_preset;

typedef struct duct_operation {
    const char *id;
    const char *label;
    const char *summary; /* one sentence */
    const duct_param *params;
    size_t param_count;
    const duct_preset *presets; /* the first one, "default", is empty */
    size_t preset_count;
} duct_operation;

/* The operations, in a fixed order; NULL when `index` is past the last one. Static storage. */
DUCT_API const duct_operation *duct_operation_at(size_t index);

/* The operation of that id. Errors: DUCT_NOT_FOUND, and the sentence lists those that are. */
DUCT_API duct_status duct_operation_find(const char *id, const duct_operation **operation, duct_error *error);

/* The tables of all operations as JSON, as `ductus ops --json` prints them. Free with duct_memory_free(). */
DUCT_API duct_status duct_operations_json(const duct_context *context, char **text, duct_error *error);

/* The names that a parameter's value can be chosen from, where they are not in the table: hands for
 * DUCT_PARAM_HAND, styles for DUCT_PARAM_STYLE, by name; none for other types. A path is good as well. Free
 * each and the list with duct_memory_free(). Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_param_names(const duct_context *context, const duct_param *param, char ***names,
                                      size_t *count, duct_error *error);

/* Values for one operation's parameters, checked against its table. */
typedef struct duct_settings duct_settings;

/* All parameters at their defaults. The caller frees it. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_settings_new(const duct_context *context, const duct_operation *operation,
                                       duct_settings **settings, duct_error *error);

/* NULL is allowed. */
DUCT_API void duct_settings_free(duct_settings *settings);

DUCT_API const duct_operation *duct_settings_operation(const duct_settings *settings);

/* Sets a parameter from text, as a user would write it (numbers with a decimal point whatever the locale).
 * `param` may be "preset" as well: see duct_settings_preset(). Errors: DUCT_BAD_SETTING with a sentence that
 * names the parameter, the value and what is allowed. */
DUCT_API duct_status duct_settings_set(duct_settings *settings, const char *param, const char *value,
                                       duct_error *error);

/* Sets every parameter to the preset's value, or to its default where the preset has none, except parameters
 * of types DUCT_PARAM_HAND and DUCT_PARAM_STROKES, which stay. Errors: DUCT_BAD_SETTING. */
DUCT_API duct_status duct_settings_preset(duct_settings *settings, const char *preset, duct_error *error);

/* The value as text in its canonical form, or NULL where there is no such parameter. Owned by the settings;
 * valid until the parameter is set again. */
DUCT_API const char *duct_settings_text(const duct_settings *settings, const char *param);

/* Gives an opened library for a parameter of type DUCT_PARAM_HAND, so that a host which runs an operation
 * often opens it once. The library must outlive the settings' runs; NULL goes back to opening by name.
 * Errors: DUCT_BAD_SETTING. */
DUCT_API duct_status duct_settings_library(duct_settings *settings, const char *param,
                                           const duct_library *library, duct_error *error);

/* Takes the trace of a run piece by piece: UTF-8 JSON, `size` bytes. Return false to stop with DUCT_IO. */
typedef bool (*duct_trace)(void *user, const char *text, size_t size);

typedef struct duct_run_options {
    duct_trace trace; /* NULL: no trace. What it holds is described with each operation in docs/. */
    void *trace_user;
} duct_run_options;

/* Runs the operation on `input`, which is not changed. `options` may be NULL. The caller frees `*output`.
 * The same input, settings and seed give the same output on every run and any number of threads.
 * Errors: DUCT_BAD_ARGUMENT (a value in the drawing is not finite), what the operation's parts return,
 * DUCT_CANCELLED. */
DUCT_API duct_status duct_operation_run(const duct_context *context, const duct_settings *settings,
                                        const duct_drawing *input, const duct_run_options *options,
                                        duct_drawing **output, duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
