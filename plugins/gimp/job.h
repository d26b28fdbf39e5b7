/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_JOB_H
#define PLUG_JOB_H

#include "options.h"
#include "procedures.h"

/* One call of one of our procedures: what to do, to which image. */
struct job {
    const duct_operation *operation;
    const plug_variant *variant;
    duct_settings *settings; /* the operation's */
    duct_settings *options;  /* our own, of plug_options */
    gint32 image;
    gint32 drawable; /* -1: none */
    gint32 vectors;  /* -1: the active path */
};

/* All values at their defaults, no image. */
duct_status plug_job_init(struct job *job, const duct_operation *operation, const plug_variant *variant,
                          duct_error *error);
void plug_job_done(struct job *job);

/* A parameter's name among those of both tables: its id, with the operation's before it where our own table
 * has that id too. */
void plug_job_name(const duct_operation *operation, const duct_param *param, char *name, size_t size);

/* Sets the value of either table's parameter by that name. */
duct_status plug_job_set(struct job *job, const char *param, const char *value, duct_error *error);

/* Whether the place in GIMP that was called from decides this parameter. */
bool plug_job_fixed(const plug_variant *variant, const duct_param *param);

/* Reads "name=value" pairs, parted by semicolons or line ends, spaces around them ignored; "preset" first, if
 * it is there, is as duct_settings_preset(). On failure some may have been set. */
duct_status plug_job_read_text(struct job *job, const char *text, duct_error *error);

/* All values as such a text, a line each; free with g_free(). */
char *plug_job_write_text(const struct job *job);

#endif
