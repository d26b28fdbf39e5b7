/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATION_PRIVATE_H
#define DUCTUS_OPERATION_PRIVATE_H

#include "operations/tracer.h"

#include <ductus/operation.h>

/* One operation: a constant of this type in a file of its own, listed in registry.c and nowhere else. `run`
 * gets settings that fit the table; it must not change `input`; the caller frees `*output`. */
typedef struct duct_operation_impl {
    duct_operation info;
    duct_status (*run)(const duct_context *context, const duct_settings *settings, const duct_drawing *input,
                       duct_tracer *tracer, duct_drawing **output, duct_error *error);
} duct_operation_impl;

extern const duct_operation_impl duct_operation_restyle;
extern const duct_operation_impl duct_operation_analogy;
extern const duct_operation_impl duct_operation_synthesize_curve;

/* Typed access for the operations themselves. The parameter must be in the table and of that type. */
bool duct_settings_bool(const duct_settings *settings, const char *param);
double duct_settings_number(const duct_settings *settings, const char *param);
size_t duct_settings_size(const duct_settings *settings, const char *param);
uint64_t duct_settings_seed(const duct_settings *settings, const char *param);
/* The index of the chosen choice in the table. */
size_t duct_settings_choice(const duct_settings *settings, const char *param);
/* False where the parameter is "auto". */
bool duct_settings_auto_number(const duct_settings *settings, const char *param, double *number);

/* A parameter's hand: the library that was given, or else the one that is opened by its name, which is then
 * the caller's to free (`*opened` is it, or NULL). Errors: DUCT_BAD_SETTING where none was chosen; those of
 * duct_library_open(). */
duct_status duct_settings_hand(const duct_context *context, const duct_settings *settings, const char *param,
                               const duct_library **library, duct_library **opened, duct_error *error);

#endif
