/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_ARGUMENTS_H
#define PLUG_ARGUMENTS_H

#include "job.h"

/* The arguments of a procedure, made from the tables: run mode, image, drawable or path, the options, the
 * operation's parameters. Switches and whole numbers are INT32, numbers are FLOAT, all else is STRING:
 * choices by their ids, "auto", seeds (which have more digits than a FLOAT), hands and brushes. The caller
 * frees the array with plug_arguments_free(). */
GimpParamDef *plug_arguments_make(const duct_operation *operation, const plug_variant *variant, int *count);
void plug_arguments_free(GimpParamDef *arguments, int count);

/* Fills a job's image, drawable and path from a call's arguments, and, where the call is not interactive, its
 * settings too. Errors: DUCT_BAD_ARGUMENT (their number is wrong), those of duct_settings_set(). */
duct_status plug_arguments_read(struct job *job, const GimpParam *values, int count, GimpRunMode mode,
                                duct_error *error);

#endif
