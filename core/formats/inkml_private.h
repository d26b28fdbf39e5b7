/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_INKML_PRIVATE_H
#define DUCTUS_FORMATS_INKML_PRIVATE_H

/* Ink Markup Language (InkML), W3C Recommendation of 20 September 2011. Sections named below are its own. */

#include "base/text.h"

#include <ductus/drawing.h>

#include <libxml/tree.h>
#include <stdbool.h>
#include <stddef.h>

#define DUCT_INKML_NAMESPACE "http://www.w3.org/2003/InkML"
/* What InkML cannot say: stroke ids, closed strokes, the page, exact colours. */
#define DUCT_INKML_OWN_NAMESPACE "urn:ductus:1"

/* Channels of a trace format; children of any one element that describes something; bytes in a path of
 * groups. Beyond these a document is hostile: without the limits its reading could take time that grows with
 * its size's square, and memory that grows far beyond its size. */
enum {
    DUCT_INKML_MOST_CHANNELS = 64,
    DUCT_INKML_MOST_CHILDREN = 1024,
    DUCT_INKML_LONGEST_GROUP = 1 << 16,
    DUCT_INKML_GROUP_BYTES = 1 << 28
};

/* What a channel of a trace means to a stroke: a duct_channel, or one of these. */
enum {
    DUCT_INKML_AZIMUTH = DUCT_CHANNEL_COUNT, /* OA */
    DUCT_INKML_ELEVATION,                    /* OE */
    DUCT_INKML_MEANINGS,
    DUCT_INKML_UNUSED = DUCT_INKML_MEANINGS
};

/* The attribute's text, or NULL. Owned by the document. Foreign namespaces are other attributes. */
const char *duct_inkml_attribute(const xmlNode *node, const char *name);
const char *duct_inkml_own_attribute(const xmlNode *node, const char *name);
/* xml:id, or id as older documents have it, or NULL. */
const char *duct_inkml_id(const xmlNode *node);
/* True for an element of InkML of that name, whether the document names the namespace or none. */
bool duct_inkml_is(const xmlNode *node, const char *name);
/* The first child element of that name among the first DUCT_INKML_MOST_CHILDREN, or NULL. */
xmlNode *duct_inkml_child(const xmlNode *node, const char *name);
/* The text in an element: a pointer into the document, or memory in `*made` that the caller frees with
 * xmlFree(). */
const char *duct_inkml_text(const xmlNode *node, xmlChar **made);
/* The attribute as a finite number; false where there is none. */
bool duct_inkml_number(const xmlNode *node, const char *name, double *number);
/* A sentence that begins with the node's line. */
duct_status duct_inkml_fail(const xmlNode *node, duct_error *error, const char *format, ...)
    DUCT_PRINTF(3, 4);

/* Elements by their id. */
typedef struct {
    const char *id;
    xmlNode *node;
    size_t order;
    long stroke; /* the stroke that this trace belongs to; -1 while there is none */
} duct_inkml_entry;

typedef struct {
    duct_inkml_entry *entries; /* sorted by id, then in the order of the document */
    size_t count, capacity;
} duct_inkml_index;

/* Collects the ids of a document. The caller releases `entries`. False when there is no memory. */
bool duct_inkml_index_make(const duct_allocator *allocator, xmlNode *root, duct_inkml_index *index);
/* The element that a reference such as "#b1" names; NULL where there is none. */
duct_inkml_entry *duct_inkml_index_find(const duct_inkml_index *index, const char *reference);
/* The first element with that id. */
duct_inkml_entry *duct_inkml_index_find_id(const duct_inkml_index *index, const char *id);

/* One channel of a trace format, ready to turn a trace's value into a stroke's: value * factor + offset. */
typedef struct {
    int meaning;
    bool intermittent;
    bool has_default;
    double standard; /* the value where an intermittent channel has none yet */
    double factor, offset;
    bool flipped;    /* X, Y: the axis points the other way, and no declared maximum says where it begins */
    bool dated;      /* T: counts from a timestamp */
    bool open_range; /* pressure without a declared maximum */
} duct_inkml_channel;

typedef struct {
    duct_inkml_channel channels[DUCT_INKML_MOST_CHANNELS];
    size_t count;
    size_t regular; /* how many come first and have to be given with every point */
    bool implicit;  /* the document states none: X and Y, and more values are ignored */
    bool dated;     /* T counts from a timestamp, not from the trace's beginning */
    double rate;    /* samples a second; 0: not known */
    double affine[6];
    bool mapped; /* whether `affine` applies to X and Y, before their factors */
} duct_inkml_format;

/* What is in force for a trace (section 4, 5): the elements that say it. NULL: the standard's defaults. */
typedef struct {
    const xmlNode *format, *source, *transform, *canvas;
    duct_stroke_style style;
    double timestamp; /* seconds since the document's first timestamp */
} duct_inkml_state;

/* The whole document, while it is read. */
typedef struct {
    const duct_allocator *allocator;
    duct_inkml_index index;
    double pixels_per_inch; /* of the drawing */
    double first_timestamp; /* seconds; NAN until one was met */
} duct_inkml_document;

/* Changes `state` by a <context> element, and by those it refers to. */
duct_status duct_inkml_apply_context(duct_inkml_document *document, const xmlNode *context,
                                     duct_inkml_state *state, duct_error *error);
/* The same for the attributes contextRef and brushRef of a trace or trace group. */
duct_status duct_inkml_apply_references(duct_inkml_document *document, const xmlNode *node,
                                        duct_inkml_state *state, duct_error *error);
/* Changes `state` by whatever of <inkSource>, <traceFormat>, <canvas>, <canvasTransform>, <brush> and
 * <timestamp> the node is; does nothing for other elements. */
void duct_inkml_apply_part(duct_inkml_document *document, const xmlNode *node, duct_inkml_state *state);
/* Works out the channels that are in force. */
duct_status duct_inkml_make_format(duct_inkml_document *document, const duct_inkml_state *state,
                                   duct_inkml_format *format, duct_error *error);
/* Drawing pixels in one of a length's unit; 0 where the unit is none of length. */
double duct_inkml_length_unit(const char *unit, double pixels_per_inch);
/* Changes a style by a <brush>. */
void duct_inkml_apply_brush(const duct_inkml_document *document, const xmlNode *brush, int depth,
                            duct_stroke_style *style);

/* The values of a trace, decoded: a column a meaning. */
typedef struct {
    const duct_allocator *allocator;
    double *values; /* DUCT_INKML_MEANINGS a sample; NAN: not known */
    size_t count, capacity;
    double last[DUCT_INKML_MOST_CHANNELS],
        velocity[DUCT_INKML_MOST_CHANNELS]; /* the differences' state at the trace's end */
} duct_inkml_samples;

/* Appends the points in a trace's text (section 3.2.1). The first trace of a stroke is `fresh`: it continues
 * none. */
duct_status duct_inkml_parse_trace(const xmlNode *trace, const duct_inkml_format *format, bool fresh,
                                   duct_inkml_samples *samples, duct_error *error);

duct_status duct_inkml_read(const duct_context *context, const char *data, size_t size, duct_drawing *drawing,
                            duct_error *error);
duct_status duct_inkml_write(const duct_context *context, const duct_drawing *drawing, duct_text *out,
                             duct_error *error);

#endif
