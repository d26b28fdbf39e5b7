/* SPDX-License-Identifier: GPL-3.0-or-later */
/* "HelpingHand" section 4.2.3. Deviations: none in the cost; the paper's table of k rows has one state a
 * candidate, which cannot know a segment's length nor a repetition, so here a candidate has 2 L_min states.
 */
#include "helpinghand/sequence.h"

#include "base/error.h"
#include "base/pool.h"
#include "helpinghand/leaves.h"

#include <math.h>
#include <string.h>

duct_transition duct_transition_of(const duct_candidate *from, const duct_candidate *to, bool repeated)
{
    if (from->stroke == to->stroke) {
        if (to->sample == from->sample + 1) {
            return DUCT_TRANSITION_CONSECUTIVE;
        }
        if (to->sample == from->sample && !repeated) {
            return DUCT_TRANSITION_STRETCH;
        }
        if (to->sample == from->sample + 2) {
            return DUCT_TRANSITION_SHRINK;
        }
    }
    return DUCT_TRANSITION_JUMP;
}

static double brief_penalty(const duct_sequence_costs *costs, size_t length)
{
    double missing = costs->brief + (double)costs->shortest - (double)length;
    return length < costs->shortest ? missing * missing : 0;
}

static double start_cost(const duct_sequence_costs *costs, const uint32_t *starts,
                         const duct_candidate *candidate)
{
    return costs->end * (double)(candidate->sample - starts[candidate->stroke]);
}

static double end_cost(const duct_sequence_costs *costs, const uint32_t *starts,
                       const duct_candidate *candidate)
{
    return costs->end * (double)(starts[candidate->stroke + 1] - 1 - candidate->sample);
}

duct_sequence_terms duct_sequence_evaluate(const duct_columns *columns, const uint32_t *starts,
                                           const duct_jump_space *space, const duct_sequence_costs *costs,
                                           const size_t *chosen, duct_sequence_terms *by_sample)
{
    duct_sequence_terms sum = {0, 0, 0, 0, 0};
    bool repeated = false;
    size_t length = 1;
    for (size_t i = 0; i < columns->count; i++) {
        const duct_candidate *here = &columns->items[chosen[i]];
        duct_sequence_terms terms = {(double)here->distance, 0, 0, 0, 0};
        bool last = i + 1 == columns->count, ends = last;
        if (i == 0) {
            terms.end += start_cost(costs, starts, here);
        }
        if (last) {
            terms.end += end_cost(costs, starts, here);
        } else {
            const duct_candidate *next = &columns->items[chosen[i + 1]];
            duct_transition kind = duct_transition_of(here, next, repeated);
            ends = kind == DUCT_TRANSITION_JUMP;
            if (kind == DUCT_TRANSITION_STRETCH) {
                terms.transition = costs->stretch;
            } else if (kind == DUCT_TRANSITION_SHRINK) {
                terms.transition = costs->shrink;
            } else if (kind == DUCT_TRANSITION_JUMP) {
                terms.transition =
                    costs->jump + costs->distance * duct_jump_distance(space, here->sample, next->sample);
            }
            repeated = here->sample == next->sample;
        }
        if (ends) {
            terms.brief = brief_penalty(costs, length);
        }
        length = ends ? 1 : length + 1;
        terms.total = terms.feature + terms.transition + terms.brief + terms.end;
        sum.feature += terms.feature;
        sum.transition += terms.transition;
        sum.brief += terms.brief;
        sum.end += terms.end;
        if (by_sample != NULL) {
            by_sample[i] = terms;
        }
    }
    sum.total = sum.feature + sum.transition + sum.brief + sum.end;
    return sum;
}

/* A state of a candidate: the length of its segment so far, cut at L_min, and whether it repeats the sample
 * before. */
static unsigned state_of(size_t length, bool repeated)
{
    return (unsigned)(2 * (length - 1) + repeated);
}

/* How a state was reached: the candidate of the column before (counted within it) and its state. */
typedef struct {
    uint32_t candidate;
    uint32_t state;
} back;

/* The costs of a column's states. Only the states whose bit is set in the candidate's `alive` have one. */
typedef struct {
    double *costs; /* [candidate][state] */
    uint64_t *alive;
} line;

/* The best way to leave a candidate by a jump. */
typedef struct {
    double cost; /* with the penalty of the segment that ends there; infinite where there is none */
    unsigned state;
} leave;

typedef struct {
    const duct_columns *columns;
    const uint32_t *starts;
    const duct_jump_space *space;
    const duct_sequence_costs *costs;
    size_t states; /* a candidate: 2 L_min, at most 64 */
    size_t widest; /* candidates in the widest column */
    double penalty[DUCT_MOST_SHORTEST + 1];
    duct_leaves leaves; /* of the column before */
} solver;

static size_t column_size(const solver *self, size_t i)
{
    return self->columns->starts[i + 1] - self->columns->starts[i];
}

static const duct_candidate *column(const solver *self, size_t i)
{
    return self->columns->items + self->columns->starts[i];
}

static const uint64_t repeating_states = 0xaaaaaaaaaaaaaaaau;

/* The cheapest of candidate p's given states from which to jump. */
static leave best_leave(const solver *self, const line *from, size_t p, uint64_t states)
{
    leave best = {INFINITY, 0};
    const double *row = from->costs + p * self->states;
    for (uint64_t left = from->alive[p] & states; left != 0; left &= left - 1) {
        unsigned state = (unsigned)__builtin_ctzll(left);
        double cost = row[state] + self->penalty[state / 2 + 1];
        if (cost < best.cost) {
            best = (leave){cost, state};
        }
    }
    return best;
}

static void offer(double *row, back *backs, uint64_t *alive, unsigned state, double cost, size_t p,
                  unsigned from)
{
    uint64_t bit = (uint64_t)1 << state;
    if ((*alive & bit) == 0 || cost < row[state]) {
        *alive |= bit;
        row[state] = cost;
        if (backs != NULL) {
            backs[state] = (back){(uint32_t)p, from};
        }
    }
}

/* Lengthens segments: from candidate p of the column before to one that its library stroke has `delta`
 * samples later. */
static void extend(const solver *self, const line *from, size_t p, uint32_t delta, double *row, back *backs,
                   uint64_t *alive)
{
    double cost = delta == 1 ? 0 : delta == 0 ? self->costs->stretch : self->costs->shrink;
    bool repeats = delta == 0;
    const double *old = from->costs + p * self->states;
    for (uint64_t left = from->alive[p] & (repeats ? ~repeating_states : ~(uint64_t)0); left != 0;
         left &= left - 1) {
        unsigned state = (unsigned)__builtin_ctzll(left);
        size_t length = state / 2 + 1;
        unsigned grown = state_of(length < self->costs->shortest ? length + 1 : length, repeats);
        offer(row, backs, alive, grown, old[state] + cost, p, state);
    }
}

/* Begins a segment at candidate `here`, jumping from whichever candidate of the column before is best, if
 * that costs less than `limit`. */
static void jump(const solver *self, const duct_candidate *before, const duct_candidate *here, double limit,
                 double *row, back *backs, uint64_t *alive)
{
    /* Distances are not negative beyond rounding: most candidates need no look at where one could jump from.
     */
    if (self->leaves.cheapest + self->costs->jump - 1e-9 >= limit) {
        return;
    }
    double best = limit;
    size_t chosen = duct_leaves_best(&self->leaves, self->space, self->costs, before, here, &best);
    if (chosen < self->leaves.count) {
        offer(row, backs, alive, state_of(1, false), best, chosen, self->leaves.states[chosen]);
    }
}

/* A state can never be better than a longer one of its kind that costs no more: it goes. One that may not
 * repeat again is no better than a longer one that may, either, unless repeating costs more than the jump
 * onto the same sample that it is left with. */
static void drop_dominated(const duct_sequence_costs *costs, const double *row, uint64_t *alive)
{
    double best[2] = {INFINITY, INFINITY};
    for (uint64_t left = *alive; left != 0;) {
        unsigned state = 63u - (unsigned)__builtin_clzll(left);
        uint64_t bit = (uint64_t)1 << state;
        left &= ~bit;
        bool repeated = state % 2 == 1;
        double bound = best[repeated];
        if (repeated && costs->stretch <= costs->jump && best[0] < bound) {
            bound = best[0];
        }
        if (row[state] >= bound) {
            *alive &= ~bit;
        } else {
            best[repeated] = row[state];
        }
    }
}

/* The lowest cost among the states that dominate a fresh segment. */
static double cheapest_fresh(const double *row, uint64_t alive)
{
    double cheapest = INFINITY;
    for (uint64_t left = alive & ~repeating_states; left != 0; left &= left - 1) {
        double cost = row[__builtin_ctzll(left)];
        cheapest = cost < cheapest ? cost : cheapest;
    }
    return cheapest;
}

/* Column i from column i - 1. `backs` may be NULL. */
static void step(solver *self, size_t i, const line *from, const line *to, back *backs)
{
    const duct_candidate *before = column(self, i - 1), *here = column(self, i);
    size_t before_count = column_size(self, i - 1), count = column_size(self, i), first = 0;
    duct_leaves_clear(&self->leaves);
    for (size_t p = 0; p < before_count; p++) {
        leave best = best_leave(self, from, p, ~(uint64_t)0);
        duct_leaves_add(&self->leaves, self->space, before[p].sample, best.cost, best.state);
    }
    duct_leaves_finish(&self->leaves, self->costs);
    for (size_t j = 0; j < count; j++) {
        double *row = to->costs + j * self->states;
        back *row_backs = backs != NULL ? backs + j * self->states : NULL;
        uint64_t alive = 0;
        /* Both columns ascend, so the candidates within two samples are found by walking along. */
        while (first < before_count && before[first].sample + 2 < here[j].sample) {
            first++;
        }
        for (size_t p = first; p < before_count && before[p].sample <= here[j].sample; p++) {
            if (before[p].stroke != here[j].stroke) {
                continue;
            }
            uint32_t delta = here[j].sample - before[p].sample;
            extend(self, from, p, delta, row, row_backs, &alive);
            if (delta == 0) {
                /* A second repetition is a jump onto the same sample. */
                leave again = best_leave(self, from, p, repeating_states);
                if (again.cost < INFINITY) {
                    double distance = duct_jump_distance(self->space, here[j].sample, here[j].sample);
                    double total = again.cost + self->costs->jump + self->costs->distance * distance;
                    offer(row, row_backs, &alive, state_of(1, true), total, p, again.state);
                }
            }
        }
        jump(self, before, &here[j], cheapest_fresh(row, alive), row, row_backs, &alive);
        drop_dominated(self->costs, row, &alive);
        for (uint64_t left = alive; left != 0; left &= left - 1) {
            row[__builtin_ctzll(left)] += (double)here[j].distance;
        }
        to->alive[j] = alive;
    }
}

static void first_column(const solver *self, const line *to)
{
    const duct_candidate *here = column(self, 0);
    for (size_t j = 0; j < column_size(self, 0); j++) {
        to->costs[j * self->states + state_of(1, false)] =
            (double)here[j].distance + start_cost(self->costs, self->starts, &here[j]);
        to->alive[j] = 1;
    }
}

static back best_end(const solver *self, const line *from)
{
    size_t last = self->columns->count - 1;
    const duct_candidate *here = column(self, last);
    double best = INFINITY;
    back chosen = {0, 0};
    for (size_t j = 0; j < column_size(self, last); j++) {
        leave end = best_leave(self, from, j, ~(uint64_t)0);
        double total = end.cost + end_cost(self->costs, self->starts, &here[j]);
        if (total < best) {
            best = total;
            chosen = (back){(uint32_t)j, end.state};
        }
    }
    return chosen;
}

static void copy_line(const solver *self, size_t i, const line *from, const line *to)
{
    size_t count = column_size(self, i);
    memcpy(to->costs, from->costs, count * self->states * sizeof *to->costs);
    memcpy(to->alive, from->alive, count * sizeof *to->alive);
}

static line line_at(const line *lines, const solver *self, size_t n)
{
    return (line){lines->costs + n * self->widest * self->states, lines->alive + n * self->widest};
}

/* Walks the whole program with the costs of every `stride`-th column kept, then goes back stride by stride,
 * each time walking it again from its kept column with the ways back remembered. With one stride only, the
 * first walk remembers them at once. */
static duct_status solve(solver *self, size_t stride, const line *kept, const line *pair, back *backs,
                         size_t *chosen, duct_error *error)
{
    enum { CHECK_EVERY = 256 };
    size_t count = self->columns->count, row = self->widest * self->states;
    size_t last_block = (count - 1) / stride;
    line lines[2] = {line_at(pair, self, 0), line_at(pair, self, 1)};
    first_column(self, &lines[0]);
    for (size_t i = 0; i < count; i++) {
        if (i > 0) {
            step(self, i, &lines[(i - 1) % 2], &lines[i % 2], last_block == 0 ? backs + (i - 1) * row : NULL);
        }
        if (i % CHECK_EVERY == 0 && duct_pool_check(error) != DUCT_OK) {
            return DUCT_CANCELLED;
        }
        if (i % stride == 0) {
            line place = line_at(kept, self, i / stride);
            copy_line(self, i, &lines[i % 2], &place);
        }
    }
    back place = best_end(self, &lines[(count - 1) % 2]);
    chosen[count - 1] = self->columns->starts[count - 1] + place.candidate;
    for (size_t block = last_block + 1; block-- > 0;) {
        size_t begin = block * stride, end = begin + stride < count ? begin + stride : count - 1;
        if (duct_pool_check(error) != DUCT_OK) {
            return DUCT_CANCELLED;
        }
        line start = line_at(kept, self, block);
        copy_line(self, begin, &start, &lines[begin % 2]);
        for (size_t i = begin + 1; last_block > 0 && i <= end; i++) {
            step(self, i, &lines[(i - 1) % 2], &lines[i % 2], backs + (i - begin - 1) * row);
        }
        for (size_t i = end; i > begin; i--) {
            place = backs[(i - begin - 1) * row + place.candidate * self->states + place.state];
            chosen[i - 1] = self->columns->starts[i - 1] + place.candidate;
        }
    }
    return DUCT_OK;
}

duct_status duct_sequence_solve(const duct_allocator *allocator, const duct_columns *columns,
                                const uint32_t *starts, const duct_jump_space *space,
                                const duct_sequence_costs *costs, size_t *chosen, duct_error *error)
{
    size_t count = columns->count;
    if (count == 0) {
        return DUCT_OK;
    }
    solver self = {.columns = columns, .starts = starts, .space = space, .costs = costs};
    self.states = 2 * costs->shortest;
    for (size_t i = 0; i < count; i++) {
        self.widest = column_size(&self, i) > self.widest ? column_size(&self, i) : self.widest;
    }
    for (size_t length = 1; length <= costs->shortest; length++) {
        self.penalty[length] = brief_penalty(costs, length);
    }
    /* Up to 512 columns in one go; beyond, a stride of about the root of the length keeps memory low. */
    size_t stride = count <= 512 ? count : (size_t)ceil(sqrt((double)count));
    stride = stride < 512 && count > 512 ? 512 : stride;
    size_t row = self.widest * self.states, blocks = (count - 1) / stride + 1;
    line kept = {duct_alloc_raw(allocator, blocks * row, sizeof(double)),
                 duct_alloc(allocator, blocks * self.widest, sizeof(uint64_t))};
    line pair = {duct_alloc_raw(allocator, 2 * row, sizeof(double)),
                 duct_alloc(allocator, 2 * self.widest, sizeof(uint64_t))};
    back *backs = duct_alloc_raw(allocator, stride * row, sizeof *backs);
    bool left = duct_leaves_make(&self.leaves, allocator, self.widest);
    duct_status status = DUCT_OK;
    if (kept.costs == NULL || kept.alive == NULL || pair.costs == NULL || pair.alive == NULL ||
        backs == NULL || !left) {
        status = duct_fail_memory(error);
    } else {
        status = solve(&self, stride, &kept, &pair, backs, chosen, error);
    }
    duct_release(allocator, kept.costs);
    duct_release(allocator, kept.alive);
    duct_release(allocator, pair.costs);
    duct_release(allocator, pair.alive);
    duct_release(allocator, backs);
    duct_leaves_free(&self.leaves, allocator);
    return status;
}
