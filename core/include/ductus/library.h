/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_H
#define DUCTUS_LIBRARY_H

#include <ductus/drawing.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A stroke library: one person's recorded strokes, resampled uniformly in arc length ("HelpingHand" section
 * 3).
 *
 * In a library, lengths are counted in sampling units: neighbouring samples are one unit apart. The unit's
 * size in the recording's own pixels is stored with it. A library is read-only once made and may be used from
 * several threads at once; features and search indices are made when first asked for and kept with it. */
typedef struct duct_library duct_library;

typedef struct duct_library_options {
    double unit;         /* sampling unit in recording pixels; 0: the median stroke gets 60 samples */
    const char *name;    /* NULL: the recording's */
    const char *artist;  /* NULL: the recording's annotation, if any */
    const char *licence; /* NULL: the recording's annotation, if any */
    /* Takes the influence of the position on the page out of pressure, tilt and twist ("HelpingHand" section
     * 3.2): fits a quadratic polynomial in x and y to each, a recording at a time, subtracts it, and adds the
     * mean back. The paper found no strong effect on results and left it off. */
    bool remove_position;
    /* Enriches the library: each stroke in each of these sizes, within 0.01 and 100, at most 16 of them; a
     * list without 1 leaves the strokes' own size out. None: as recorded. A library of n sizes takes n times
     * as much to search; the paper (section 5) tried half to one and a half and saw no significant gain. */
    const double *scales;
    size_t scale_count;
    /* One for each recording, within 0.001 and 1000; NULL: all 1. In matching, the feature distance of a
     * candidate from a recording is divided by its weight, so that one of weight 2 is taken where it is up to
     * twice as far: restyle's candidates are the nearest by that distance (with PatchMatch, but for those
     * that it misses). Pose while drawing (stream.h) takes no heed of weights. Weights that a recording,
     * being a library itself, brings along are multiplied by it. */
    const double *weights;
} duct_library_options;

/* Makes a library of one or more recordings. Strokes without length are left out. `options` may be NULL.
 * A channel that some of the strokes lack is absent from the library. The caller frees it.
 * Errors: DUCT_UNSUPPORTED (no stroke with a length), DUCT_BAD_ARGUMENT (an option out of range),
 * DUCT_NO_MEMORY, DUCT_LIMIT. */
DUCT_API duct_status duct_library_build(const duct_context *context, const duct_drawing *const *recordings,
                                        size_t count, const duct_library_options *options,
                                        duct_library **library, duct_error *error);

/* Opens a hand by name (see duct_library_list) or by the path of a library, a recording in any readable
 * format, or a folder of them. A file of that name comes before a hand, a hand before a folder, unless the
 * name holds a '/'. The caller frees the library. Errors: DUCT_NOT_FOUND (the sentence lists the hands there
 * are), and those of duct_drawing_read(). */
DUCT_API duct_status duct_library_open(const duct_context *context, const char *name_or_path,
                                       duct_library **library, duct_error *error);

/* Writes the library as InkML, and beside it, as PATH.index, the features and search index, which
 * duct_library_open() takes instead of making them again while it fits the library. Both appear whole or not
 * at all; an index that cannot be written is left out. Errors: DUCT_IO, DUCT_NO_MEMORY. */
DUCT_API duct_status duct_library_save(const duct_context *context, const duct_library *library,
                                       const char *path, duct_error *error);

/* NULL is allowed. */
DUCT_API void duct_library_free(duct_library *library);

DUCT_API const char *duct_library_name(const duct_library *library);
DUCT_API const char *duct_library_artist(const duct_library *library);  /* "" where unknown */
DUCT_API const char *duct_library_licence(const duct_library *library); /* "" where unknown */
DUCT_API size_t duct_library_stroke_count(const duct_library *library);
DUCT_API size_t duct_library_sample_count(const duct_library *library);
DUCT_API size_t duct_library_stroke_samples(const duct_library *library, size_t stroke); /* of one stroke */
DUCT_API double duct_library_weight(const duct_library *library, size_t stroke); /* 0: no such stroke */
DUCT_API double duct_library_unit(const duct_library *library); /* recording pixels a sampling unit */
DUCT_API bool duct_library_has(const duct_library *library, duct_channel channel);

/* The strokes as a drawing in recording pixels. The caller frees it. Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_library_drawing(const duct_context *context, const duct_library *library,
                                          duct_drawing **drawing, duct_error *error);

/* A hand that can be opened by its name. */
typedef struct duct_hand {
    char *name;
    char *path;
    bool builtin; /* ships with Ductus (and is synthetic) rather than lying in the user's folder */
} duct_hand;

/* Lists the hands of the data folder (context->data_folder, or the one installed with the library) and of the
 * user's folder ($XDG_DATA_HOME/ductus/hands, or ~/.local/share/ductus/hands), by name; a user's hand hides a
 * built-in one of the same name. Free with duct_hands_free(). Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_library_list(const duct_context *context, duct_hand **hands, size_t *count,
                                       duct_error *error);
DUCT_API void duct_hands_free(const duct_context *context, duct_hand *hands, size_t count);

#ifdef __cplusplus
}
#endif

#endif
