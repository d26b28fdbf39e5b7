/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_REPORT_H
#define DUCTUS_REPORT_H

#include <ductus/library.h>

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What libraries are good for, told before they are used: how far the pose of a hand follows the shapes that
 * it draws, and how alike the hands of several libraries are ("HelpingHand" section 3.1, Fig. 3).
 *
 * Every run of 2 n + 1 samples of a stroke is a patch. Each patch is paired with the most similar patch of
 * another stroke (or of the other library), and the poses of both are correlated. Where similar shapes are
 * drawn with similar pose, these correlations are far above those of patches that are paired at random.
 *
 * How the paper is read here, where it leaves a choice. Several readings were tried on its recordings; these
 * are the ones that agree with what it reports (similar pairs far above random ones; some writers around
 * 0.5) and with a calculation on them made without this code (similar pairs 0.63 to 0.83, random ones 0.06 to
 * 0.26, one writer's pages with each other 0.66 to 0.71): with all English pages of a writer as one library,
 * the five writers have 0.64 (Neeraj), 0.67, 0.74, 0.78 and 0.84 (Chika) for similar pairs and 0.07 to 0.20
 * for random ones. Single pages spread more: 0.56 to 0.86, and 0.04 to 0.24; Steve's with each other have
 * 0.68 to 0.72, Linjie's 0.52 to 0.68.
 * - Patches are taken at the library's sampling unit, at which the median stroke has about 60 samples (the
 *   paper: "typically between 40 and 80"), not at one pixel of a 2000-pixel page, which gives its recordings
 *   100 to 250.
 * - A patch's features are the unit tangents at its samples, and x- and x+ of section 4.1 at its centre,
 *   whose window d_h is 40 samples, as for matching; a window of n samples or fewer would make them 1 always.
 * - "The mean feature distance over all pairs of patches" is the mean over the pairs of most similar patches.
 *   The mean over all pairs that can be formed is some ten times that and would reject nothing.
 * - Each pair of patches is one vote: the mean of Fisher's z over its channels; `together` is the mean over
 *   the pairs. With a vote for every coefficient, pairs whose tilt happens to change would count for more
 *   than those whose tilt rests, which are the most.
 * - A channel that is constant over either patch has no coefficient, nor has one whose standard deviation
 *   there is within a tablet's last digit: 0.001 of pressure, 0.002 radians. Tilts of these recordings rest
 *   for most patches or creep from one step to the next; what a tablet made up correlates with nothing, and
 *   pulls a writer whose pen hardly turns (Neeraj) down by 0.04.
 * - Coefficients are kept within 0.999, as z has no bound.
 * - Between two libraries both directions count: from the patches of each to the most similar of the other.
 */
typedef struct duct_report duct_report;

typedef struct duct_report_options {
    int radius;    /* n: samples on each side of a patch's centre, 2..1000 */
    uint64_t seed; /* of the random pairs */
} duct_report_options;

/* n = 12, seed 0. */
DUCT_API duct_report_options duct_report_options_default(void);

/* Pearson's r averaged as Fisher's z; a NaN where no pair of patches has a coefficient. */
typedef struct duct_correlation {
    double similar; /* over the pairs of similar patches */
    double random;  /* over as many random pairs */
    size_t pairs;   /* pairs of similar patches that were not rejected; of a single channel: those of them
                       that have a coefficient */
} duct_correlation;

/* In words. The limits on `similar` of `together` are round numbers chosen by the paper's recordings: within
 * a page of handwriting Brenda, Chika and Linjie have 0.65 to 0.86, Neeraj and Steve 0.55 to 0.72; between
 * pages, one writer's have 0.52 to 0.84 and two writers' 0.17 to 0.71. So they overlap, and a verdict on two
 * libraries does not tell whether one person made both. */
typedef enum duct_verdict {
    DUCT_VERDICT_NO_POSE,    /* no pose channel is there, or in both */
    DUCT_VERDICT_TOO_SMALL,  /* fewer than 200 pairs: too few to tell */
    DUCT_VERDICT_CONSISTENT, /* 0.6 and more */
    DUCT_VERDICT_MODERATE,   /* 0.4 to 0.6 */
    DUCT_VERDICT_LOOSE       /* less than 0.4, or less than 0.1 above `random` */
} duct_verdict;

/* One library, or a pair of them. */
typedef struct duct_report_entry {
    size_t first, second; /* the libraries; the same one twice: within that library */
    size_t patches;       /* of both */
    duct_correlation together;
    duct_correlation channels[DUCT_CHANNEL_COUNT]; /* of the pose channels that both have; the rest NaN, 0 */
    bool present[DUCT_CHANNEL_COUNT];              /* which pose channels both have */
    duct_verdict verdict;
    const char *sentence; /* what that means for a user, e.g. "consistent: ..."; static storage */
} duct_report_entry;

/* Analyses the libraries and all pairs of them by exact search; the work grows with the product of their
 * samples. `options` may be NULL. The result depends on the libraries and the options only. The caller frees
 * it. Errors: DUCT_BAD_ARGUMENT (no library, or a radius out of range), DUCT_LIMIT (more than 1000
 * libraries), DUCT_NO_MEMORY, DUCT_CANCELLED. */
DUCT_API duct_status duct_library_report(const duct_context *context, const duct_library *const *libraries,
                                         size_t count, const duct_report_options *options,
                                         duct_report **report, duct_error *error);
DUCT_API void duct_report_free(duct_report *report); /* NULL is allowed */

DUCT_API size_t duct_report_library_count(const duct_report *report);
DUCT_API const char *duct_report_library_name(const duct_report *report, size_t library);

/* What was found between two libraries (in either order) or within one. NULL outside. Owned by the report. */
DUCT_API const duct_report_entry *duct_report_between(const duct_report *report, size_t first, size_t second);

/* The verdict's word, e.g. "consistent". Static storage. */
DUCT_API const char *duct_verdict_name(duct_verdict verdict);

/* The report as JSON: "libraries" and "between", each entry with similar, random, pairs and the same for each
 * of its channels. Free with duct_memory_free(). Errors: DUCT_NO_MEMORY. */
DUCT_API duct_status duct_report_json(const duct_context *context, const duct_report *report, char **text,
                                      duct_error *error);

/* The report as a picture after Fig. 3, .svg or .png: a bar for similar and one for random pairs of each
 * library, and the matrix of `similar` where there are several. The file appears whole or not at all.
 * Errors: DUCT_UNSUPPORTED (another ending), DUCT_LIMIT, DUCT_IO, DUCT_NO_MEMORY. */
DUCT_API duct_status duct_report_draw(const duct_context *context, const duct_report *report,
                                      const char *path, duct_error *error);

#ifdef __cplusplus
}
#endif

#endif
