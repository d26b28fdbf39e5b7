/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "clip.h"

static void add(struct clip *clip, gint32 drawable, bool alpha, bool in_image)
{
    int x = 0, y = 0;
    if (in_image) {
        gimp_drawable_offsets(drawable, &x, &y);
    }
    clip->parts[clip->count].buffer = gimp_drawable_get_buffer(drawable);
    /* babl has no format of alpha alone. */
    clip->parts[clip->count].alpha = alpha;
    clip->parts[clip->count].format = babl_format(alpha ? "YA float" : "Y float");
    clip->parts[clip->count].x = x;
    clip->parts[clip->count].y = y;
    clip->count++;
}

/* The layer that a drawable is, or whose mask it is; -1: none. */
static gint32 layer_of(gint32 drawable)
{
    if (drawable <= 0) {
        return -1;
    }
    if (gimp_item_is_layer_mask(drawable)) {
        return gimp_layer_from_mask(drawable);
    }
    return gimp_item_is_layer(drawable) ? drawable : -1;
}

void plug_clip_init(struct clip *clip, const struct job *job)
{
    clip->count = 0;
    if (!plug_option_bool(job->options, OPTION_CLIP)) {
        return;
    }
    /* As GIMP's own: a stroke along the selection's outline is not cut in half by the selection. */
    if (!plug_option_is(job->options, OPTION_LINES, LINES_SELECTION) &&
        !gimp_selection_is_empty(job->image)) {
        add(clip, gimp_image_get_selection(job->image), false, false);
    }
    /* On the active layer itself GIMP sees to the rest. */
    gint32 layer = layer_of(job->drawable);
    if (layer <= 0 || plug_option_is(job->options, OPTION_RESULT, RESULT_ONTO)) {
        return;
    }
    if (gimp_layer_get_lock_alpha(layer) && gimp_drawable_has_alpha(layer)) {
        add(clip, layer, true, true);
    }
    gint32 mask = gimp_layer_get_mask(layer);
    if (mask > 0 && gimp_layer_get_apply_mask(layer)) {
        add(clip, mask, false, true);
        gimp_drawable_offsets(layer, &clip->parts[clip->count - 1].x, &clip->parts[clip->count - 1].y);
    }
}

void plug_clip_done(struct clip *clip)
{
    for (int i = 0; i < clip->count; i++) {
        g_object_unref(clip->parts[i].buffer);
    }
    clip->count = 0;
}

void plug_clip_apply(const struct clip *clip, const GeglRectangle *area, double scale, float *mask)
{
    size_t count = (size_t)area->width * (size_t)area->height;
    if (clip->count == 0) {
        return;
    }
    float *part = g_new(float, 2 * count);
    for (int i = 0; i < clip->count; i++) {
        GeglRectangle box = *area;
        box.x -= (int)(clip->parts[i].x * scale);
        box.y -= (int)(clip->parts[i].y * scale);
        gegl_buffer_get(clip->parts[i].buffer, &box, scale, clip->parts[i].format, part, GEGL_AUTO_ROWSTRIDE,
                        GEGL_ABYSS_NONE);
        for (size_t k = 0; k < count; k++) {
            float share = clip->parts[i].alpha ? part[2 * k + 1] : part[k];
            mask[k] *= CLAMP(share, 0, 1);
        }
    }
    g_free(part);
}
