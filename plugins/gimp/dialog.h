/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_DIALOG_H
#define PLUG_DIALOG_H

#include "result.h"

/* Lets the user set the job's values beside a preview, and does the job. The values are kept for the next
 * time. Errors: DUCT_CANCELLED, and those of the job, which the user has then seen and given up on. */
duct_status plug_dialog_run(struct job *job, struct result *result, duct_error *error);

#endif
