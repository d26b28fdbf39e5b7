/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/multiresolution.h"

#include "base/error.h"
#include "base/pool.h"

#include <math.h>
#include <string.h>

/* A curve has at least this many segments at the level it starts from. */
static const double fewest_segments = 8;
/* The paper's w_OFFSET for synthesis, against 3.8 for analogies: for the term with the coarser level. */
static const double synthesis_offset = 5;
enum { FIRST_PASSES = 2 };

static void slot_weights(const duct_analogy *analogy, bool coarse, duct_slot_weights weights[DUCT_SLOTS])
{
    const duct_analogy_options *options = &analogy->options;
    size_t s = 0;
    memset(weights, 0, DUCT_SLOTS * sizeof *weights);
    weights[s++] = (duct_slot_weights){1, 1, 0};
    if (analogy->has_a) {
        /* With w_B = 0 the shape of B does not count, but its orientation does. */
        double align = options->shape_weight > 0 ? options->shape_weight : options->coarse_weight;
        weights[s++] = (duct_slot_weights){options->shape_weight, align, options->offset_weight};
    }
    if (coarse) {
        double offset = options->offset_weight * (analogy->has_a ? 1 : synthesis_offset);
        weights[s++] = (duct_slot_weights){options->coarse_weight, options->coarse_weight, offset};
    }
}

static duct_status make_set(const duct_analogy *analogy, size_t level, bool coarse, bool causal,
                            duct_example_set *set, duct_error *error)
{
    duct_level_curves *curves = duct_alloc(&analogy->allocator, analogy->pair_count, sizeof *curves);
    if (curves == NULL) {
        return duct_fail_memory(error);
    }
    size_t slots = 1;
    for (size_t p = 0; p < analogy->pair_count; p++) {
        slots = 0;
        curves[p].slots[slots++] = &analogy->b[p].levels[level];
        if (analogy->has_a) {
            curves[p].slots[slots++] = &analogy->a[p].levels[level];
        }
        if (coarse) {
            curves[p].slots[slots++] = &analogy->b[p].levels[level + 1];
        }
    }
    duct_slot_weights weights[DUCT_SLOTS];
    slot_weights(analogy, coarse, weights);
    duct_status status = duct_example_set_make(
        &analogy->allocator, curves, analogy->pair_count, slots, causal && analogy->has_a ? 1 : 0, weights,
        duct_pyramid_spacing(analogy->options.spacing, level), &analogy->options, set, error);
    duct_release(&analogy->allocator, curves);
    return status;
}

duct_status duct_multiresolution_first_set(const duct_analogy *analogy, size_t level, bool causal,
                                           duct_example_set *set, duct_error *error)
{
    return make_set(analogy, level, false, causal, set, error);
}

duct_status duct_multiresolution_refine_set(const duct_analogy *analogy, size_t level, duct_example_set *set,
                                            duct_error *error)
{
    return make_set(analogy, level, true, false, set, error);
}

size_t duct_multiresolution_start(const duct_analogy *analogy, double length)
{
    size_t level = analogy->levels - 1;
    while (level > 0 && duct_pyramid_spacing(analogy->options.spacing, level) * fewest_segments > length) {
        level--;
    }
    return level;
}

/* One curve on its way down the pyramid. */
typedef struct {
    const duct_analogy *analogy;
    const duct_pyramid *b; /* NULL without B */
    const duct_curve_constraint *constraints;
    size_t constraint_count;
    uint64_t id;
    double reach; /* of spread constraints */
    duct_pin *pins;
    size_t *sources;
    duct_curve curve; /* B' at the level just made */
    double energy;
} descent;

static void descent_done(descent *self)
{
    const duct_allocator *allocator = &self->analogy->allocator;
    duct_release(allocator, self->pins);
    duct_release(allocator, self->sources);
    duct_curve_done(allocator, &self->curve);
}

static duct_status descent_init(const duct_analogy *analogy, const duct_pyramid *b,
                                const duct_curve_constraint *constraints, size_t count, uint64_t id,
                                size_t start, descent *self, duct_error *error)
{
    *self = (descent){
        .analogy = analogy, .b = b, .constraints = constraints, .constraint_count = count, .id = id};
    self->reach = 12 * duct_pyramid_spacing(analogy->options.spacing, start);
    self->pins = duct_alloc(&analogy->allocator, count, sizeof *self->pins);
    return self->pins == NULL ? duct_fail_memory(error) : duct_constraints_check(constraints, count, error);
}

/* Makes room for the sources of a curve. */
static duct_status take_sources(descent *self, size_t count, duct_error *error)
{
    duct_release(&self->analogy->allocator, self->sources);
    self->sources = duct_alloc(&self->analogy->allocator, count, sizeof *self->sources);
    return self->sources != NULL ? DUCT_OK : duct_fail_memory(error);
}

static duct_making making_of(const descent *self, const duct_example_set *set, size_t level, size_t pass)
{
    duct_making making = {.allocator = &self->analogy->allocator,
                          .set = set,
                          .pins = self->pins,
                          .pin_count = self->constraint_count,
                          .id = self->id,
                          .purpose = 64 * level + pass,
                          .sources = self->sources};
    making.others[1] = self->b != NULL ? &self->b->levels[level] : NULL;
    return making;
}

/* Brings the curve to the constraints as far as the level asks for it. */
static void meet_constraints(descent *self, size_t level)
{
    duct_constraints_pin(&self->curve, self->constraints, self->constraint_count, level, self->pins);
    duct_constraints_spread(&self->curve, self->pins, self->constraint_count, self->reach);
}

static duct_status refine(descent *self, const duct_example_set *set, size_t level, const duct_curve *coarse,
                          bool hinted, size_t passes, duct_error *error)
{
    duct_status status = DUCT_OK;
    for (size_t pass = 0; pass < passes && status == DUCT_OK; pass++) {
        duct_making making = making_of(self, set, level, 1 + pass);
        making.settled = coarse != NULL;
        if (coarse != NULL) {
            making.others[set->slots - 1] = coarse;
        }
        status = duct_refine_analogy(&making, hinted || pass > 0, &self->curve, error);
        self->energy = making.energy;
    }
    return status;
}

static double total_length(const duct_analogy *analogy, const duct_pyramid *pyramids, size_t level)
{
    double sum = 0;
    for (size_t p = 0; p < analogy->pair_count; p++) {
        sum += duct_curve_length(&pyramids[p].levels[level]);
    }
    return sum;
}

/* The spacing for a curve at a level. A curve that is much longer than the examples would make it has got
 * entangled, as where A' lies far from A on the inside of a bend; without a limit it would grow at each
 * level.
 */
static double spacing_for(const descent *self, const duct_curve *curve, size_t level, size_t start,
                          double first)
{
    const duct_analogy *analogy = self->analogy;
    const double generous = 2;
    double likely = self->b != NULL ? duct_curve_length(&self->b->levels[level]) /
                                          total_length(analogy, analogy->a, level)
                                    : first / total_length(analogy, analogy->b, start);
    double longest = generous * likely * total_length(analogy, analogy->b, level);
    double spacing = duct_pyramid_spacing(analogy->options.spacing, level), length = duct_curve_length(curve);
    return length > longest ? spacing * length / longest : spacing;
}

/* From the coarsest level, which self->curve holds, to the finest. */
static duct_status descend(descent *self, size_t start, duct_error *error)
{
    const duct_analogy *analogy = self->analogy;
    const duct_allocator *allocator = &analogy->allocator;
    duct_status status = DUCT_OK;
    double first = duct_curve_length(&self->curve);
    for (size_t level = start; level-- > 0 && status == DUCT_OK;) {
        duct_curve coarse = self->curve;
        memset(&self->curve, 0, sizeof self->curve);
        double spacing = spacing_for(self, &coarse, level, start, first);
        status = duct_curve_resample(allocator, &coarse, spacing, 2, &self->curve, error);
        if (status == DUCT_OK) {
            status = take_sources(self, self->curve.count, error);
        }
        if (status == DUCT_OK) {
            meet_constraints(self, level);
            status =
                refine(self, &analogy->refine[level], level, &coarse, false, analogy->options.passes, error);
        }
        duct_curve_done(allocator, &coarse);
    }
    if (status == DUCT_OK) {
        duct_constraints_settle(&self->curve, self->pins, self->constraint_count, self->reach);
    }
    return status;
}

static void figures_of(const descent *self, size_t start, duct_analogy_figures *figures)
{
    size_t runs = 1;
    for (size_t i = 1; i < self->curve.count; i++) {
        size_t last = self->sources[i - 1], now = self->sources[i];
        runs += !(now > last && now - last <= 2);
    }
    *figures = (duct_analogy_figures){self->energy, (double)self->curve.count / (double)runs, start + 1,
                                      self->curve.count};
}

static duct_status finish(descent *self, duct_status status, size_t start, duct_curve *result,
                          duct_analogy_figures *figures)
{
    if (status == DUCT_OK) {
        if (figures != NULL) {
            figures_of(self, start, figures);
        }
        *result = self->curve;
        memset(&self->curve, 0, sizeof self->curve);
    }
    descent_done(self);
    return status;
}

/* SYNTHESIZEANALOGY at the coarsest level, and refinement passes there. */
static duct_status first_analogy(descent *self, size_t level, duct_error *error)
{
    const duct_analogy *analogy = self->analogy;
    const duct_curve *b = &self->b->levels[level];
    duct_example_set causal, full;
    duct_status status =
        duct_curve_init(&analogy->allocator, b->count, b->closed, analogy->extra, &self->curve, error);
    if (status == DUCT_OK) {
        status = take_sources(self, b->count, error);
    }
    if (status == DUCT_OK) {
        status = duct_multiresolution_first_set(analogy, level, true, &causal, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    memcpy(self->curve.t, b->t, b->count * sizeof *b->t);
    memcpy(self->curve.x, b->x, b->count * sizeof *b->x);
    memcpy(self->curve.y, b->y, b->count * sizeof *b->y);
    duct_constraints_pin(&self->curve, self->constraints, self->constraint_count, level, self->pins);
    duct_making making = making_of(self, &causal, level, 0);
    status = duct_synthesize_analogy(&making, &self->curve, error);
    duct_example_set_done(&analogy->allocator, &causal);
    if (status == DUCT_OK) {
        status = duct_multiresolution_first_set(analogy, level, false, &full, error);
    }
    if (status == DUCT_OK) {
        duct_curve made = self->curve;
        memset(&self->curve, 0, sizeof self->curve);
        status = duct_curve_resample(&analogy->allocator, &made,
                                     duct_pyramid_spacing(analogy->options.spacing, level), 2, &self->curve,
                                     error);
        duct_curve_done(&analogy->allocator, &made);
        if (status == DUCT_OK) {
            status = take_sources(self, self->curve.count, error);
        }
        if (status == DUCT_OK) {
            meet_constraints(self, level);
            status = refine(self, &full, level, NULL, false, FIRST_PASSES, error);
        }
        duct_example_set_done(&analogy->allocator, &full);
    }
    return status;
}

duct_status duct_analogy_apply(const duct_analogy *analogy, const duct_curve *b, uint64_t id,
                               const duct_curve_constraint *constraints, size_t count, duct_curve *result,
                               duct_analogy_figures *figures, duct_error *error)
{
    if (!analogy->has_a) {
        return duct_fail(error, DUCT_UNSUPPORTED,
                         "the style has no plain curve A: it is good for new curves only");
    }
    size_t start = duct_multiresolution_start(analogy, duct_curve_length(b));
    duct_pyramid pyramid;
    duct_status status =
        duct_pyramid_make(&analogy->allocator, b, analogy->options.spacing, start + 1, &pyramid, error);
    if (status != DUCT_OK) {
        return status;
    }
    descent self;
    status = descent_init(analogy, &pyramid, constraints, count, id, start, &self, error);
    if (status == DUCT_OK) {
        status = first_analogy(&self, start, error);
    }
    if (status == DUCT_OK) {
        status = descend(&self, start, error);
    }
    status = finish(&self, status, start, result, figures);
    duct_pyramid_done(&analogy->allocator, &pyramid);
    return status;
}

/* The length that a curve of `length` has at a coarse level, if it is like the examples. */
static double coarse_length(const duct_analogy *analogy, double length, size_t level)
{
    double fine = 0, coarse = 0;
    for (size_t p = 0; p < analogy->pair_count; p++) {
        fine += duct_curve_length(&analogy->b[p].levels[0]);
        coarse += duct_curve_length(&analogy->b[p].levels[level]);
    }
    return fine > 0 ? length * coarse / fine : length;
}

/* SYNTHESIZECURVE at the coarsest level, and refinement passes there. */
static duct_status first_curve(descent *self, double length, size_t level, duct_error *error)
{
    const duct_analogy *analogy = self->analogy;
    double spacing = duct_pyramid_spacing(analogy->options.spacing, level);
    double target = coarse_length(analogy, length, level);
    size_t most = (size_t)(4 * target / spacing) + 8;
    duct_example_set set;
    duct_curve rough;
    duct_status status = duct_curve_init(&analogy->allocator, most, false, analogy->extra, &rough, error);
    if (status != DUCT_OK) {
        return status;
    }
    status = take_sources(self, most, error);
    if (status == DUCT_OK) {
        status = duct_multiresolution_first_set(analogy, level, false, &set, error);
    }
    if (status != DUCT_OK) {
        duct_curve_done(&analogy->allocator, &rough);
        return status;
    }
    duct_making making = making_of(self, &set, level, 0);
    status = duct_synthesize_curve(&making, target, most, &rough, error);
    if (status == DUCT_OK) {
        status = duct_curve_resample(&analogy->allocator, &rough, spacing, 2, &self->curve, error);
    }
    if (status == DUCT_OK) {
        status = take_sources(self, self->curve.count, error);
    }
    if (status == DUCT_OK) {
        status = refine(self, &set, level, NULL, false, FIRST_PASSES, error);
    }
    duct_curve_done(&analogy->allocator, &rough);
    duct_example_set_done(&analogy->allocator, &set);
    return status;
}

duct_status duct_analogy_synthesize(const duct_analogy *analogy, double length, uint64_t id,
                                    duct_curve *result, duct_analogy_figures *figures, duct_error *error)
{
    size_t start = duct_multiresolution_start(analogy, length);
    descent self;
    duct_status status = descent_init(analogy, NULL, NULL, 0, id, start, &self, error);
    if (status == DUCT_OK) {
        status = first_curve(&self, length, start, error);
    }
    if (status == DUCT_OK) {
        status = descend(&self, start, error);
    }
    return finish(&self, status, start, result, figures);
}

duct_status duct_analogy_synthesize_through(const duct_analogy *analogy, const duct_curve *guide, uint64_t id,
                                            const duct_curve_constraint *constraints, size_t count,
                                            duct_curve *result, duct_analogy_figures *figures,
                                            duct_error *error)
{
    size_t start = duct_multiresolution_start(analogy, duct_curve_length(guide));
    double spacing = duct_pyramid_spacing(analogy->options.spacing, start);
    duct_example_set set;
    descent self;
    duct_status status = descent_init(analogy, NULL, constraints, count, id, start, &self, error);
    if (status == DUCT_OK) {
        status = duct_curve_resample(&analogy->allocator, guide, spacing, 2, &self.curve, error);
    }
    if (status == DUCT_OK) {
        status = take_sources(&self, self.curve.count, error);
    }
    if (status == DUCT_OK) {
        status = duct_multiresolution_first_set(analogy, start, false, &set, error);
    }
    if (status == DUCT_OK) {
        meet_constraints(&self, start);
        status = refine(&self, &set, start, NULL, false, FIRST_PASSES, error);
        duct_example_set_done(&analogy->allocator, &set);
    }
    if (status == DUCT_OK) {
        status = descend(&self, start, error);
    }
    return finish(&self, status, start, result, figures);
}
