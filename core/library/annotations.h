/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_ANNOTATIONS_H
#define DUCTUS_LIBRARY_ANNOTATIONS_H

/* The annotations by which a library's file says what it is. */
#define DUCT_ANNOTATION_NAME "name"
#define DUCT_ANNOTATION_ARTIST "artist"
#define DUCT_ANNOTATION_LICENCE "licence"
#define DUCT_ANNOTATION_UNIT "ductus-unit"       /* recording pixels a sampling unit */
#define DUCT_ANNOTATION_WEIGHTS "ductus-weights" /* of the strokes: see library/weights.h */

#endif
