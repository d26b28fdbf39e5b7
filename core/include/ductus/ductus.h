/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DUCTUS_H
#define DUCTUS_DUCTUS_H

/* Ductus: drawing with somebody's hand. This header includes all the others; each is the manual of its
 * subject.
 *
 * Rules that hold everywhere:
 * - Opaque structs come from a call that says "the caller frees it" and go through the matching _free call.
 * - `const` inputs are not changed; the caller owns what it was handed.
 * - Calls that can fail return a duct_status and fill an optional duct_error; outputs are untouched on
 * failure.
 * - No global mutable state: any two handles may be used from two threads at once. One handle may be read
 * from several threads at once, and written from one.
 * - Lengths are drawing pixels (1/96 inch unless the page says otherwise), x to the right, y down; angles are
 *   radians; time is in seconds; pressure, opacity and colours are 0..1. */

#include <ductus/context.h>
#include <ductus/diagram.h>
#include <ductus/drawing.h>
#include <ductus/format.h>
#include <ductus/image.h>
#include <ductus/library.h>
#include <ductus/lineart.h>
#include <ductus/operation.h>
#include <ductus/path.h>
#include <ductus/random.h>
#include <ductus/render.h>
#include <ductus/report.h>
#include <ductus/status.h>
#include <ductus/stream.h>
#include <ductus/stroke.h>
#include <ductus/version.h>

#endif
