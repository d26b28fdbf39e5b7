/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DIAGRAM_H
#define DUCTUS_DIAGRAM_H

#include <ductus/drawing.h>
#include <ductus/library.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Pictures that explain drawings: strokes coloured by a channel of their pose ("HelpingHand" Fig. 4), the
 * pen's nib and lean along the strokes, and the parts of a library that a restyled stroke was made of (Fig.
 * 6, 15). */

/* What the colour of a stroke shows. */
typedef enum duct_diagram_by {
    DUCT_BY_NOTHING, /* every stroke in its own colour */
    DUCT_BY_PRESSURE,
    DUCT_BY_TILT,    /* how far the pen leans from upright, whichever way; degrees */
    DUCT_BY_TILT_X,  /* degrees */
    DUCT_BY_TILT_Y,  /* degrees */
    DUCT_BY_TWIST,   /* degrees, within half a turn of the mean of all that is shown */
    DUCT_BY_SPEED,   /* drawing pixels a second */
    DUCT_BY_SEGMENTS /* the pieces of the library, each in a colour of its own */
} duct_diagram_by;

typedef enum duct_diagram_palette {
    DUCT_PALETTE_VIOLET_YELLOW, /* lightness rises evenly with the value: reads without colour vision as well
                                 */
    DUCT_PALETTE_BLUE_RED       /* blue = low, red = high, by way of green, as in the paper's Fig. 4 */
} duct_diagram_palette;

/* The segments of a restyled drawing: which runs of its samples came from which places of the library, as a
 * trace of the operation says ("HelpingHand" section 4.2.3: "a few long segments of library strokes"). */
typedef struct duct_segments duct_segments;

/* A run of samples first..last of a stroke, sampled uniformly in arc length, that came from the samples
 * begin..end of one library stroke without a jump between. All are included and count from 0. */
typedef struct duct_segment {
    size_t first, last;
    size_t library_stroke, begin, end;
} duct_segment;

/* Reads the segments from a trace that `restyle` wrote. `pass` is "pose" or "trajectory"; NULL: the last pass
 * that a stroke has. The caller frees them. Errors: DUCT_NOT_FOUND, DUCT_IO, DUCT_LIMIT (more than
 * DUCT_MAX_FILE_BYTES), DUCT_BAD_FORMAT (it is no such trace; the sentence names the line), DUCT_UNSUPPORTED
 * (the run chose no places: it averaged, or took each closest place), DUCT_NO_MEMORY. */
DUCT_API duct_status duct_segments_read(const duct_context *context, const char *path, const char *pass,
                                        duct_segments **segments, duct_error *error);

/* The same from memory; `name` stands for the file's name in sentences. */
DUCT_API duct_status duct_segments_read_memory(const duct_context *context, const char *text, size_t size,
                                               const char *name, const char *pass, duct_segments **segments,
                                               duct_error *error);

/* NULL is allowed. */
DUCT_API void duct_segments_free(duct_segments *segments);

/* The hand that the run was made with, as it was named then. Owned by the segments. */
DUCT_API const char *duct_segments_hand(const duct_segments *segments);

/* The traced strokes, and one stroke's id, number of uniform samples and segments in order. NULL and 0 for a
 * stroke that is not there; a stroke that the operation passed over has no samples and no segments. */
DUCT_API size_t duct_segments_stroke_count(const duct_segments *segments);
DUCT_API const char *duct_segments_stroke_id(const duct_segments *segments, size_t stroke);
DUCT_API const duct_segment *duct_segments_of(const duct_segments *segments, size_t stroke, size_t *count,
                                              size_t *samples);

/* One drawing of a diagram. */
typedef struct duct_diagram_panel {
    const duct_drawing *drawing;
    const char *caption;           /* UTF-8; NULL or "": none */
    const duct_segments *segments; /* for DUCT_BY_SEGMENTS; a stroke that they do not name is grey */
    const duct_library *library;   /* the segments' library, whose used strokes are drawn beside; NULL: not */
} duct_diagram_panel;

typedef struct duct_diagram_options {
    duct_diagram_by by;
    duct_diagram_palette palette;
    double low, high; /* the values at the palette's ends, in the unit of `by`; both 0: all but the outermost
                         hundredths of what the panels hold, the same for all panels */
    bool width_by_pressure; /* lines as wide as the pen was pressed, where that is known */
    bool nibs;    /* along the strokes: an ellipse, as long as the pen is pressed, turned as its barrel */
    bool needles; /* along the strokes: the barrel's shadow, from the tip to where the pen leans */
    double line_width;  /* picture pixels */
    double panel_width; /* picture pixels, 64..8192 */
    int columns;        /* panels in a row; 0: up to four */
    double scale; /* of the finished picture: 2 doubles its pixels, and the sizes above with them; 0.1..16 */
} duct_diagram_options;

/* By pressure, violet to yellow, range found, even lines of 2.5 pixels, panels of 560 pixels, up to four in a
 * row. */
DUCT_API duct_diagram_options duct_diagram_options_default(void);

/* Draws a diagram into an SVG or PNG file, told by its ending; it appears whole or not at all. Strokes that
 * lack the channel are grey. `options` may be NULL. Errors: DUCT_UNSUPPORTED (no drawing has the channel; the
 * ending is another; the library is not the one of the segments), DUCT_BAD_ARGUMENT (no panels, or options
 * out of range), DUCT_LIMIT, DUCT_NOT_FOUND (the folder), DUCT_IO, DUCT_NO_MEMORY, DUCT_CANCELLED. */
DUCT_API duct_status duct_diagram_write(const duct_context *context, const duct_diagram_panel *panels,
                                        size_t count, const duct_diagram_options *options, const char *path,
                                        duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
