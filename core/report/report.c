/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report_private.h"

#include "base/error.h"
#include "base/pool.h"
#include "report/correlation.h"
#include "report/patches.h"

#include <ductus/random.h>

#include <math.h>

enum { MOST_LIBRARIES = 1000, LARGEST_RADIUS = 1000, LEAST_PAIRS = 200 };
enum { PURPOSE_FIRST = 1, PURPOSE_SECOND = 2 }; /* of random numbers */

static const duct_channel pose[] = {DUCT_PRESSURE, DUCT_TILT_X, DUCT_TILT_Y, DUCT_TWIST};
enum { POSE_COUNT = sizeof pose / sizeof pose[0] };

duct_report_options duct_report_options_default(void)
{
    return (duct_report_options){.radius = 12, .seed = 0};
}

/* The averages over one kind of pairs. */
typedef struct {
    duct_fisher channels[DUCT_CHANNEL_COUNT];
    duct_fisher together; /* a number a pair: the mean over its channels */
} kind_averages;

/* Those of one entry while it is made. */
typedef struct {
    kind_averages similar, random;
    size_t pairs;
} averages;

typedef struct {
    const duct_context *context;
    const duct_report_options *options;
    duct_patches *patches; /* by library */
    uint32_t *partners;    /* room for the largest library's patches */
    float *distances;
    double step, done; /* of progress: a pairing of two libraries in one direction, and so far */
} analysis;

static void correlate(const duct_patches *from, const duct_patches *to, size_t a, size_t b,
                      kind_averages *result)
{
    duct_fisher own = {0, 0};
    size_t first = from->centres[a] - from->radius, second = to->centres[b] - to->radius;
    for (size_t p = 0; p < POSE_COUNT; p++) {
        duct_channel c = pose[p];
        const double *x = from->library->channels[c], *y = to->library->channels[c];
        double coefficient;
        if (x != NULL && y != NULL &&
            duct_correlate(x + first, y + second, 2 * from->radius + 1, c != DUCT_PRESSURE, &coefficient)) {
            duct_fisher_add(&result->channels[c], coefficient);
            duct_fisher_add(&own, coefficient);
        }
    }
    duct_fisher_add_mean(&result->together, &own);
}

/* A random number below `count`. */
static size_t draw(const duct_report_options *options, size_t count, size_t index, uint64_t purpose)
{
    return (size_t)(duct_random_uniform(options->seed, 0, index, purpose) * (double)count);
}

/* A pair of random patches, of different strokes where both are of one library. */
static void correlate_random(const duct_report_options *options, const duct_patches *from,
                             const duct_patches *to, size_t index, kind_averages *result)
{
    size_t a = draw(options, from->count, index, PURPOSE_FIRST);
    size_t start = from == to ? from->starts[from->strokes[a]] : 0;
    size_t own = from == to ? from->starts[from->strokes[a] + 1] - start : 0;
    if (own == to->count) {
        return;
    }
    size_t b = draw(options, to->count - own, index, PURPOSE_SECOND);
    correlate(from, to, a, own > 0 && b >= start ? b + own : b, result);
}

/* From the patches of one library to those of another or its own. */
static duct_status analyse_direction(analysis *self, const duct_patches *from, const duct_patches *to,
                                     averages *result, duct_error *error)
{
    double begin = self->done;
    self->done += self->step;
    if (from->count == 0 || to->count == 0) {
        return duct_progress_report(self->context, self->done, error);
    }
    duct_status status =
        duct_patches_pair(self->context, from, to, begin, self->done, self->partners, self->distances, error);
    if (status != DUCT_OK) {
        return status;
    }
    double sum = 0;
    size_t count = 0, kept = 0;
    for (size_t i = 0; i < from->count; i++) {
        if (self->partners[i] != DUCT_PATCH_NONE) {
            sum += (double)self->distances[i];
            count++;
        }
    }
    double threshold = count > 0 ? sum / (double)count : 0;
    for (size_t i = 0; i < from->count; i++) {
        if (self->partners[i] != DUCT_PATCH_NONE && (double)self->distances[i] <= threshold) {
            correlate(from, to, i, self->partners[i], &result->similar);
            correlate_random(self->options, from, to, kept++, &result->random);
        }
    }
    result->pairs += kept;
    return DUCT_OK;
}

static void judge(duct_report_entry *entry)
{
    static const char *const within[] = {
        [DUCT_VERDICT_NO_POSE] = "no pose: the recording has neither pressure nor tilt nor rotation; it can "
                                 "lend its trajectory only",
        [DUCT_VERDICT_TOO_SMALL] = "too small to tell: record more strokes of a similar size",
        [DUCT_VERDICT_CONSISTENT] = "consistent: similar shapes are drawn with similar pose",
        [DUCT_VERDICT_MODERATE] = "moderate: similar shapes are often, not always, drawn with similar pose",
        [DUCT_VERDICT_LOOSE] =
            "loose: pose hardly follows the shape; expect restyled strokes to vary at will",
    };
    static const char *const between[] = {
        [DUCT_VERDICT_NO_POSE] = "no pose: they have no pose channel in common",
        [DUCT_VERDICT_TOO_SMALL] = "too small to tell: record more strokes of a similar size",
        [DUCT_VERDICT_CONSISTENT] = "alike: both draw similar shapes with similar pose and may be joined",
        [DUCT_VERDICT_MODERATE] = "related: both agree in part; joined, they blur each other somewhat",
        [DUCT_VERDICT_LOOSE] = "different: each has a pose of its own; keep them apart",
    };
    const duct_correlation *all = &entry->together;
    bool any = false;
    for (size_t p = 0; p < POSE_COUNT; p++) {
        any = any || entry->present[pose[p]];
    }
    if (!any) {
        entry->verdict = DUCT_VERDICT_NO_POSE;
    } else if (all->pairs < LEAST_PAIRS || isnan(all->similar)) {
        entry->verdict = DUCT_VERDICT_TOO_SMALL;
    } else if (all->similar < 0.4 || all->similar - all->random < 0.1) {
        entry->verdict = DUCT_VERDICT_LOOSE;
    } else {
        entry->verdict = all->similar < 0.6 ? DUCT_VERDICT_MODERATE : DUCT_VERDICT_CONSISTENT;
    }
    entry->sentence = (entry->first == entry->second ? within : between)[entry->verdict];
}

static void conclude(duct_report_entry *entry, const duct_patches *first, const duct_patches *second,
                     const averages *result)
{
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        const duct_fisher *similar = &result->similar.channels[c];
        entry->channels[c] = (duct_correlation){
            duct_fisher_mean(similar), duct_fisher_mean(&result->random.channels[c]), similar->count};
    }
    for (size_t p = 0; p < POSE_COUNT; p++) {
        entry->present[pose[p]] =
            first->library->channels[pose[p]] != NULL && second->library->channels[pose[p]] != NULL;
    }
    entry->patches = first == second ? first->count : first->count + second->count;
    entry->together = (duct_correlation){duct_fisher_mean(&result->similar.together),
                                         duct_fisher_mean(&result->random.together), result->pairs};
    judge(entry);
}

static duct_status analyse_all(analysis *self, duct_report *report, duct_error *error)
{
    size_t at = 0;
    for (size_t b = 0; b < report->count; b++) {
        for (size_t a = 0; a <= b; a++) {
            averages result = {.pairs = 0};
            const duct_patches *first = &self->patches[a], *second = &self->patches[b];
            duct_status status = analyse_direction(self, first, second, &result, error);
            if (status == DUCT_OK && a != b) {
                status = analyse_direction(self, second, first, &result, error);
            }
            if (status != DUCT_OK) {
                return status;
            }
            duct_report_entry *entry = &report->entries[at++];
            entry->first = a;
            entry->second = b;
            conclude(entry, first, second, &result);
        }
    }
    return DUCT_OK;
}

/* Makes the patches of all libraries, and room to pair them. */
static duct_status prepare(analysis *self, const duct_library *const *libraries, size_t count,
                           duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(self->context);
    size_t most = 0;
    self->step = 1 / ((double)count * (double)count);
    self->patches = duct_alloc(allocator, count, sizeof *self->patches);
    if (self->patches == NULL) {
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < count; i++) {
        duct_status status = duct_patches_make(allocator, libraries[i], (size_t)self->options->radius,
                                               &self->patches[i], error);
        if (status != DUCT_OK) {
            return status;
        }
        most = self->patches[i].count > most ? self->patches[i].count : most;
    }
    self->partners = duct_alloc(allocator, most, sizeof *self->partners);
    self->distances = duct_alloc(allocator, most, sizeof *self->distances);
    return self->partners != NULL && self->distances != NULL ? DUCT_OK : duct_fail_memory(error);
}

static duct_status new_report(const duct_allocator *allocator, const duct_library *const *libraries,
                              size_t count, duct_report **report, duct_error *error)
{
    duct_report *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->allocator = *allocator;
    made->libraries = duct_alloc(allocator, count, sizeof *made->libraries);
    made->entries = duct_alloc(allocator, count * (count + 1) / 2, sizeof *made->entries);
    bool good = made->libraries != NULL && made->entries != NULL;
    for (size_t i = 0; good && i < count; i++) {
        made->count = i + 1;
        made->libraries[i] =
            (duct_report_library){duct_strdup(allocator, libraries[i]->name), libraries[i]->stroke_count,
                                  libraries[i]->sample_count, libraries[i]->unit};
        good = made->libraries[i].name != NULL;
    }
    if (!good) {
        duct_report_free(made);
        return duct_fail_memory(error);
    }
    *report = made;
    return DUCT_OK;
}

duct_status duct_library_report(const duct_context *context, const duct_library *const *libraries,
                                size_t count, const duct_report_options *options, duct_report **report,
                                duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    const duct_report_options usual = duct_report_options_default();
    analysis self = {.context = context, .options = options != NULL ? options : &usual};
    if (count == 0) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a report needs one library at least");
    }
    if (count > MOST_LIBRARIES) {
        return duct_fail(error, DUCT_LIMIT, "a report can compare %d libraries at most", MOST_LIBRARIES);
    }
    if (self.options->radius < 2 || self.options->radius > LARGEST_RADIUS) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "a patch's radius must be 2 to %d samples, not %d",
                         LARGEST_RADIUS, self.options->radius);
    }
    duct_report *made = NULL;
    duct_status status = new_report(allocator, libraries, count, &made, error);
    if (status == DUCT_OK) {
        status = prepare(&self, libraries, count, error);
    }
    if (status == DUCT_OK) {
        status = analyse_all(&self, made, error);
    }
    for (size_t i = 0; self.patches != NULL && i < count; i++) {
        duct_patches_free(allocator, &self.patches[i]);
    }
    duct_release(allocator, self.patches);
    duct_release(allocator, self.partners);
    duct_release(allocator, self.distances);
    if (status != DUCT_OK) {
        duct_report_free(made);
        return status;
    }
    *report = made;
    return DUCT_OK;
}

void duct_report_free(duct_report *report)
{
    if (report != NULL) {
        const duct_allocator allocator = report->allocator;
        for (size_t i = 0; i < report->count; i++) {
            duct_release(&allocator, report->libraries[i].name);
        }
        duct_release(&allocator, report->libraries);
        duct_release(&allocator, report->entries);
        duct_release(&allocator, report);
    }
}

size_t duct_report_library_count(const duct_report *report)
{
    return report->count;
}

const char *duct_report_library_name(const duct_report *report, size_t library)
{
    return library < report->count ? report->libraries[library].name : NULL;
}

const duct_report_entry *duct_report_between(const duct_report *report, size_t first, size_t second)
{
    size_t a = first < second ? first : second, b = first < second ? second : first;
    return b < report->count ? &report->entries[b * (b + 1) / 2 + a] : NULL;
}

const char *duct_verdict_name(duct_verdict verdict)
{
    static const char *const names[] = {"no-pose", "too-small", "consistent", "moderate", "loose"};
    return (unsigned)verdict < sizeof names / sizeof names[0] ? names[verdict] : "";
}
