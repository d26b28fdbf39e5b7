/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Example pairs out of a drawing. */
#include "style/style.h"

#include "base/error.h"
#include "base/number.h"

#include <math.h>
#include <string.h>

duct_status duct_curve_of_stroke(const duct_allocator *allocator, const duct_stroke *stroke, double factor,
                                 bool pressure, duct_curve *curve, duct_error *error)
{
    size_t size = duct_stroke_size(stroke), count = 0;
    const double *x = duct_stroke_values(stroke, DUCT_X), *y = duct_stroke_values(stroke, DUCT_Y);
    const double *p = pressure ? duct_stroke_values(stroke, DUCT_PRESSURE) : NULL;
    duct_status status =
        duct_curve_init(allocator, size, duct_stroke_closed(stroke) && size > 2, p != NULL, curve, error);
    if (status != DUCT_OK) {
        return status;
    }
    for (size_t i = 0; i < size; i++) {
        curve->x[count] = factor * x[i];
        curve->y[count] = factor * y[i];
        if (p != NULL) {
            curve->extra[count] = p[i];
        }
        count +=
            count == 0 || curve->x[count] != curve->x[count - 1] || curve->y[count] != curve->y[count - 1];
    }
    while (curve->closed && count > 1 && curve->x[count - 1] == curve->x[0] &&
           curve->y[count - 1] == curve->y[0]) {
        count--;
    }
    curve->closed = curve->closed && count > 2;
    curve->count = count > 1 ? count : 0;
    if (curve->count > 0) {
        duct_curve_use_arc_length(curve);
    }
    return DUCT_OK;
}

/* A and A' of one example. */
static duct_status make_pair(const duct_allocator *allocator, const duct_stroke *plain,
                             const duct_stroke *styled, duct_correspondence how, duct_curve_pair *pair,
                             duct_error *error)
{
    memset(pair, 0, sizeof *pair);
    /* Points are counted before any is left out: those of the same number belong together. */
    bool sampled = plain != NULL && duct_stroke_size(plain) == duct_stroke_size(styled);
    duct_status status = duct_curve_of_stroke(allocator, styled, 1, true, &pair->b, error);
    if (status == DUCT_OK && plain != NULL) {
        status = duct_curve_of_stroke(allocator, plain, 1, false, &pair->a, error);
    }
    if (status == DUCT_OK && (pair->b.count == 0 || (plain != NULL && pair->a.count == 0))) {
        const duct_stroke *dot = pair->b.count == 0 ? styled : plain;
        status =
            duct_fail(error, DUCT_UNSUPPORTED,
                      "the example curve '%.60s' has no length; give a line, not a dot", duct_stroke_id(dot));
    }
    if (status == DUCT_OK && plain != NULL) {
        if (!sampled || pair->a.count != pair->b.count) {
            how =
                how == DUCT_CORRESPOND_AUTO || how == DUCT_CORRESPOND_SAMPLES ? DUCT_CORRESPOND_LENGTH : how;
        }
        status = duct_correspond(allocator, how, &pair->a, &pair->b, error);
    }
    if (status != DUCT_OK) {
        duct_curve_done(allocator, &pair->a);
        duct_curve_done(allocator, &pair->b);
    }
    return status;
}

void duct_style_done(duct_style *style)
{
    for (size_t p = 0; p < style->pass_count; p++) {
        for (size_t i = 0; i < style->passes[p].count; i++) {
            duct_curve_done(&style->allocator, &style->passes[p].pairs[i].a);
            duct_curve_done(&style->allocator, &style->passes[p].pairs[i].b);
        }
        duct_release(&style->allocator, style->passes[p].pairs);
    }
    memset(style, 0, sizeof *style);
}

static duct_style fresh(const duct_allocator *allocator, double scale)
{
    duct_style style = {.allocator = *allocator, .scale = scale, .shape_weight = NAN};
    style.rotation = style.join_corners = style.split_corners = -1;
    return style;
}

static duct_status add_pass(duct_style *style, const duct_stroke *const *plain,
                            const duct_stroke *const *styled, size_t count, duct_correspondence how,
                            duct_error *error)
{
    duct_curve_pair *pairs = duct_alloc(&style->allocator, count, sizeof *pairs);
    if (pairs == NULL) {
        return duct_fail_memory(error);
    }
    size_t pass = style->pass_count++;
    style->passes[pass].pairs = pairs;
    style->passes[pass].count = 0;
    duct_status status = DUCT_OK;
    for (size_t i = 0; i < count && status == DUCT_OK; i++) {
        status =
            make_pair(&style->allocator, plain != NULL ? plain[i] : NULL, styled[i], how, &pairs[i], error);
        style->passes[pass].count += status == DUCT_OK;
        double width = duct_stroke_get_style(styled[i]).width;
        style->width = width > style->width ? width : style->width;
    }
    return status;
}

duct_status duct_style_make_of(const duct_allocator *allocator, const duct_stroke *const *plain,
                               const duct_stroke *const *styled, size_t count, duct_correspondence how,
                               double scale, duct_style *style, duct_error *error)
{
    duct_style made = fresh(allocator, scale);
    duct_status status = add_pass(&made, plain, styled, count, how, error);
    if (status != DUCT_OK) {
        duct_style_done(&made);
        return status;
    }
    *style = made;
    return DUCT_OK;
}

/* 0 for "A", 1 for "A'", 2 for "A''" ...; -1 for other names. */
static int pass_named(const char *name)
{
    size_t primes = name[0] == 'A' ? strspn(name + 1, "'") : 0;
    return name[0] == 'A' && name[1 + primes] == '\0' && primes <= DUCT_STYLE_PASSES ? (int)primes : -1;
}

static const char *last_part(const char *group)
{
    const char *slash = strrchr(group, '/');
    return slash != NULL ? slash + 1 : group;
}

static bool same_colour(const duct_stroke *a, const duct_stroke *b)
{
    duct_stroke_style one = duct_stroke_get_style(a), other = duct_stroke_get_style(b);
    return one.red == other.red && one.green == other.green && one.blue == other.blue;
}

/* The pass of each stroke by the rules in turn; false where none of them sorts the drawing. */
static bool sort_strokes(const duct_drawing *drawing, int *passes)
{
    size_t count = duct_drawing_stroke_count(drawing), plain = 0, styled = 0;
    for (int rule = 0; rule < 4; rule++) {
        plain = styled = 0;
        for (size_t i = 0; i < count; i++) {
            const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
            passes[i] = rule == 0   ? pass_named(last_part(duct_stroke_group(stroke)))
                        : rule == 1 ? pass_named(duct_stroke_id(stroke))
                        : rule == 2 ? !same_colour(stroke, duct_drawing_stroke(drawing, 0))
                                    : (int)(i % 2);
            plain += passes[i] == 0;
            styled += passes[i] == 1;
        }
        if (plain > 0 && styled > 0 && (rule < 2 || plain == styled)) {
            return true;
        }
        if (rule < 2 && plain == 0 && styled > 0) {
            return true; /* A' without A */
        }
    }
    passes[0] = 1;
    return count == 1;
}

static duct_status make_passes(const duct_drawing *drawing, const int *passes, const duct_stroke **plain,
                               const duct_stroke **styled, const char *name, duct_correspondence how,
                               duct_style *style, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing), plain_count = 0;
    for (size_t i = 0; i < count; i++) {
        if (passes[i] == 0) {
            plain[plain_count++] = duct_drawing_stroke(drawing, i);
        }
    }
    duct_status status = DUCT_OK;
    for (int pass = 1; pass <= DUCT_STYLE_PASSES && status == DUCT_OK; pass++) {
        size_t styled_count = 0;
        for (size_t i = 0; i < count; i++) {
            if (passes[i] == pass) {
                styled[styled_count++] = duct_drawing_stroke(drawing, i);
            }
        }
        if (styled_count == 0) {
            break;
        }
        if (plain_count > 0 && plain_count != styled_count) {
            return duct_fail(error, DUCT_UNSUPPORTED,
                             "the style '%.80s' has %zu curves A and %zu curves A%.*s; each A needs one",
                             name, plain_count, styled_count, pass, "''''");
        }
        status = add_pass(style, plain_count > 0 ? plain : NULL, styled, styled_count, how, error);
    }
    return status;
}

static int truth(const char *text, const char *yes)
{
    return text == NULL ? -1 : strcmp(text, yes) == 0;
}

duct_status duct_style_make(const duct_allocator *allocator, const duct_drawing *drawing, const char *name,
                            duct_correspondence how, double scale, duct_style *style, duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing);
    if (count == 0) {
        return duct_fail(error, DUCT_UNSUPPORTED, "the style '%.80s' has no curves; draw A and A' into it",
                         name);
    }
    duct_style made = fresh(allocator, scale);
    int *passes = duct_alloc(allocator, count, sizeof *passes);
    const duct_stroke **strokes = duct_alloc(allocator, 2 * count, sizeof *strokes);
    duct_status status;
    if (passes == NULL || strokes == NULL) {
        status = duct_fail_memory(error);
    } else if (!sort_strokes(drawing, passes)) {
        status = duct_fail(error, DUCT_UNSUPPORTED,
                           "it cannot be told which curves of the style '%.80s' are A and which A': put them "
                           "into layers called A and A', give them two colours, or draw them in turns",
                           name);
    } else {
        status = make_passes(drawing, passes, strokes, strokes + count, name, how, &made, error);
    }
    duct_release(allocator, passes);
    duct_release(allocator, strokes);
    if (status != DUCT_OK) {
        duct_style_done(&made);
        return status;
    }
    const char *weight = duct_drawing_annotation(drawing, "shape-weight");
    double number;
    made.shape_weight = weight != NULL && duct_number_parse(weight, &number) && number >= 0 ? number : NAN;
    made.rotation = truth(duct_drawing_annotation(drawing, "invariance"), "rotation");
    made.join_corners = truth(duct_drawing_annotation(drawing, "join-corners"), "true");
    made.split_corners = truth(duct_drawing_annotation(drawing, "split-corners"), "true");
    *style = made;
    return DUCT_OK;
}
