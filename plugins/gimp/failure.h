/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_FAILURE_H
#define PLUG_FAILURE_H

#include <ductus/status.h>

/* Fills `error` with a sentence (what, where, what to do) and returns `status`. */
duct_status plug_fail(duct_error *error, duct_status status, const char *format, ...) DUCT_PRINTF(3, 4);

/* The sentence of libgimp's last error behind ours, for calls to GIMP that failed. */
duct_status plug_fail_gimp(duct_error *error, const char *what);

#endif
