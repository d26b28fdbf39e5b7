/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_RESULT_H
#define PLUG_RESULT_H

#include "job.h"
#include "work.h"

/* What a job has added to the image. */
struct result {
    gint32 layer;  /* -1: none */
    GArray *paths; /* gint32; NULL: none */
};

/* Whether the image can take the result, so that a long work does not end with a refusal. Errors:
 * DUCT_UNSUPPORTED with a sentence on what to do. */
duct_status plug_result_check(const struct job *job, duct_error *error);

/* Puts what was worked out into the image, as one step of undo. All that can fail or take long comes first;
 * an image is changed only by what then cannot fail half way. */
duct_status plug_result_commit(const struct job *job, const duct_context *context, const struct work *work,
                               struct result *result, duct_error *error);
void plug_result_done(struct result *result);

#endif
