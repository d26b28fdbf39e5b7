/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_style.h"

#include "formats/svg_document.h"

#include <math.h>
#include <string.h>

duct_svg_style duct_svg_style_initial(void)
{
    duct_svg_color black = {0, 0, 0, 1};
    return (duct_svg_style){.fill = {DUCT_SVG_PAINT_COLOR, black, {NULL, 0}},
                            .stroke = {DUCT_SVG_PAINT_NONE, black, {NULL, 0}},
                            .color = black,
                            .fill_opacity = 1,
                            .stroke_opacity = 1,
                            .opacity = 1,
                            .stroke_width = 1,
                            .font_size = 16,
                            .displayed = true,
                            .visible = true};
}

/* The first stop's colour of a gradient, found through the gradients that it refers to. */
static duct_svg_color gradient_color(const duct_svg_document *document, const xmlNode *server)
{
    enum { MOST_REFERENCES = 16 };
    duct_svg_color color = {0, 0, 0, 1};
    for (int i = 0; server != NULL && i < MOST_REFERENCES; i++) {
        for (const xmlNode *stop = server->children; stop != NULL; stop = stop->next) {
            if (stop->type == XML_ELEMENT_NODE && strcmp((const char *)stop->name, "stop") == 0) {
                duct_css_values values;
                duct_css_resolve(duct_svg_document_sheet(document), stop, &values);
                duct_svg_color_parse(values.value[DUCT_SVG_STOP_COLOR], color, &color);
                return color;
            }
        }
        const char *reference = duct_svg_reference(server);
        server = reference != NULL && reference[0] == '#'
                     ? duct_svg_document_find(document, duct_slice_of(reference + 1))
                     : NULL;
    }
    return color;
}

/* url(#id) with an optional paint behind it, which counts where there is no such element. */
static void compute_server(const duct_svg_document *document, duct_slice value, duct_svg_color current,
                           duct_svg_paint *paint)
{
    const char *close = memchr(value.text, ')', value.size);
    size_t size = close != NULL ? (size_t)(close - value.text) : value.size;
    duct_slice id = duct_slice_trim((duct_slice){value.text + 4, size - 4});
    if (id.size >= 2 && (id.text[0] == '"' || id.text[0] == '\'')) {
        id = (duct_slice){id.text + 1, id.size - 2};
    }
    if (id.size > 0 && id.text[0] == '#') {
        id = (duct_slice){id.text + 1, id.size - 1};
        const xmlNode *server = duct_svg_document_find(document, id);
        if (server != NULL) {
            *paint = (duct_svg_paint){DUCT_SVG_PAINT_SERVER, gradient_color(document, server), value};
            return;
        }
    }
    paint->kind = DUCT_SVG_PAINT_NONE;
    if (close != NULL &&
        duct_svg_color_parse((duct_slice){close + 1, value.size - size - 1}, current, &paint->color)) {
        paint->kind = DUCT_SVG_PAINT_COLOR;
    }
}

/* A malformed value changes nothing: the inherited paint stays. */
static void compute_paint(const duct_svg_document *document, duct_slice value, duct_svg_color current,
                          duct_svg_paint *paint)
{
    duct_svg_color color;
    if (value.text == NULL) {
        return;
    }
    if (duct_slice_is(value, "none") || duct_slice_begins(value, "context-")) {
        paint->kind = DUCT_SVG_PAINT_NONE;
    } else if (duct_slice_begins(value, "url(")) {
        compute_server(document, value, current, paint);
    } else if (duct_svg_color_parse(value, current, &color)) {
        *paint = (duct_svg_paint){DUCT_SVG_PAINT_COLOR, color, {NULL, 0}};
    }
}

duct_svg_style duct_svg_style_compute(const duct_svg_document *document, const duct_svg_style *parent,
                                      const duct_css_values *values, const duct_svg_viewport *viewport)
{
    duct_svg_style style = *parent;
    const duct_slice *value = values->value;
    double number;
    duct_svg_viewport at = *viewport;
    at.font_size = parent->font_size;
    if (duct_svg_length(value[DUCT_SVG_FONT_SIZE], DUCT_SVG_FONT, &at, &number) && number >= 0) {
        style.font_size = number;
    }
    at.font_size = style.font_size;
    duct_svg_color_parse(value[DUCT_SVG_COLOR], parent->color, &style.color);
    compute_paint(document, value[DUCT_SVG_FILL], style.color, &style.fill);
    compute_paint(document, value[DUCT_SVG_STROKE], style.color, &style.stroke);
    duct_svg_opacity(value[DUCT_SVG_FILL_OPACITY], &style.fill_opacity);
    duct_svg_opacity(value[DUCT_SVG_STROKE_OPACITY], &style.stroke_opacity);
    if (duct_svg_opacity(value[DUCT_SVG_OPACITY], &number)) {
        style.opacity = parent->opacity * number;
    }
    if (duct_svg_length(value[DUCT_SVG_STROKE_WIDTH], DUCT_SVG_DIAGONAL, &at, &number) && number >= 0) {
        style.stroke_width = number;
    }
    duct_slice display = value[DUCT_SVG_DISPLAY], visibility = value[DUCT_SVG_VISIBILITY];
    style.displayed = display.text == NULL || !duct_slice_is(display, "none");
    if (visibility.text != NULL && !duct_slice_is(visibility, "inherit")) {
        style.visible = duct_slice_is(visibility, "visible");
    }
    duct_slice effect = value[DUCT_SVG_VECTOR_EFFECT];
    style.non_scaling = effect.text != NULL && duct_slice_is(effect, "non-scaling-stroke");
    return style;
}

static bool marks(const duct_svg_style *style, const duct_svg_paint *paint, double opacity)
{
    bool painted = paint->kind == DUCT_SVG_PAINT_SERVER ||
                   (paint->kind == DUCT_SVG_PAINT_COLOR && paint->color.alpha > 0);
    return style->displayed && style->visible && painted && opacity > 0 && style->opacity > 0;
}

bool duct_svg_style_strokes(const duct_svg_style *style)
{
    return style->stroke_width > 0 && marks(style, &style->stroke, style->stroke_opacity);
}

bool duct_svg_style_fills(const duct_svg_style *style)
{
    return marks(style, &style->fill, style->fill_opacity);
}

static duct_stroke_style style_of(const duct_svg_paint *paint, double opacity, double width)
{
    return (duct_stroke_style){(float)paint->color.red, (float)paint->color.green, (float)paint->color.blue,
                               (float)(opacity * paint->color.alpha), width};
}

duct_stroke_style duct_svg_stroke_style(const duct_svg_style *style, double scale)
{
    double width = style->non_scaling ? style->stroke_width : style->stroke_width * scale;
    return style_of(&style->stroke, style->stroke_opacity * style->opacity, fmin(width, 1e9));
}

duct_stroke_style duct_svg_fill_style(const duct_svg_style *style)
{
    return style_of(&style->fill, style->fill_opacity * style->opacity, 0);
}
