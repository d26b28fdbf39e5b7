/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "analogy/basis.h"

#include "base/error.h"

#include <math.h>
#include <string.h>

enum { MOST_DIRECTIONS = 12, SAMPLED = 72 };

struct duct_basis {
    size_t directions, length; /* of the vectors: complex entries */
    double *vectors;           /* [entry][direction] real, then [entry][direction] imaginary */
    float *re, *im;            /* [direction][position]: the examples' projections */
    float *norms, *rests;      /* by position: |a|^2 (negative: lacks samples), |a'| */
};

static size_t row_length(const duct_example_set *set)
{
    size_t length = 0;
    for (size_t s = 0; s < set->slots; s++) {
        length += set->slot[s].cost > 0 ? 2 * (2 * (size_t)set->reach + 1) : 0;
    }
    return length;
}

/* Writes a full neighbourhood's vector; returns |a|^2. */
static double write_row(const duct_example_set *set, const duct_neighbourhood *around, double *re, double *im)
{
    size_t room = 2 * (size_t)set->reach + 1, at = 0;
    double norm = 0;
    for (size_t s = 0; s < set->slots; s++) {
        const duct_neighbourhood *samples = &around[s];
        if (!(set->slot[s].cost > 0)) {
            continue;
        }
        const double *weights = s == 0 ? set->own_weights : set->weights;
        double mean_x = 0, mean_y = 0, mass = s == 0 ? set->own_mass : set->mass;
        for (size_t k = 0; k < room; k++) {
            mean_x += weights[k] * samples->x[k];
            mean_y += weights[k] * samples->y[k];
        }
        mean_x /= mass;
        mean_y /= mass;
        double root = sqrt(set->slot[s].cost), tangent = sqrt(set->options->tangent_weight);
        for (size_t k = 0; k < room; k++, at += 2) {
            double weight = root * sqrt(weights[k]), turned = k > 0 ? weight * tangent : 0;
            re[at] = weight * (samples->x[k] - mean_x);
            im[at] = weight * (samples->y[k] - mean_y);
            re[at + 1] = turned * samples->u[k];
            im[at + 1] = turned * samples->v[k];
            norm += re[at] * re[at] + im[at] * im[at] + re[at + 1] * re[at + 1] + im[at + 1] * im[at + 1];
        }
    }
    return norm;
}

/* Takes what lies along (re, im), of length 1, out of a row; returns what is left, squared. */
static double deflate(const double *re, const double *im, size_t length, double *row_re, double *row_im)
{
    double along_re = 0, along_im = 0, left = 0;
    for (size_t n = 0; n < length; n++) {
        along_re += re[n] * row_re[n] + im[n] * row_im[n];
        along_im += re[n] * row_im[n] - im[n] * row_re[n];
    }
    for (size_t n = 0; n < length; n++) {
        row_re[n] -= along_re * re[n] - along_im * im[n];
        row_im[n] -= along_re * im[n] + along_im * re[n];
        left += row_re[n] * row_re[n] + row_im[n] * row_im[n];
    }
    return left;
}

/* The row that is worst described so far becomes the next direction. */
static void choose_directions(const duct_example_set *set, duct_basis *basis, double *rows, double *lefts)
{
    size_t count = 0, length = basis->length, stride = set->count / SAMPLED + 1;
    double most = 0;
    for (size_t j = 0; j < set->count && count < SAMPLED; j += stride) {
        if (set->full[j]) {
            double *row = rows + count * 2 * length;
            lefts[count] = write_row(set, &set->around[j * set->slots], row, row + length);
            most = lefts[count] > most ? lefts[count] : most;
            count++;
        }
    }
    size_t limit = count < MOST_DIRECTIONS ? count : MOST_DIRECTIONS;
    for (basis->directions = 0; basis->directions < limit; basis->directions++) {
        size_t worst = 0;
        for (size_t i = 1; i < count; i++) {
            worst = lefts[i] > lefts[worst] ? i : worst;
        }
        if (!(lefts[worst] > 1e-9 * most)) {
            return;
        }
        double *chosen = rows + worst * 2 * length, scale = 1 / sqrt(lefts[worst]);
        for (size_t n = 0; n < 2 * length; n++) {
            chosen[n] *= scale;
        }
        for (size_t n = 0; n < length; n++) {
            basis->vectors[n * MOST_DIRECTIONS + basis->directions] = chosen[n];
            basis->vectors[(length + n) * MOST_DIRECTIONS + basis->directions] = chosen[length + n];
        }
        for (size_t i = 0; i < count; i++) {
            if (i != worst) {
                double *row = rows + i * 2 * length;
                lefts[i] = deflate(chosen, chosen + length, length, row, row + length);
            }
        }
        lefts[worst] = 0;
    }
}

/* <V, row> for all directions; returns the length of what is left. */
static double project(const duct_basis *basis, const double *re, const double *im, double norm, double *to)
{
    double *to_re = to, *to_im = to + MOST_DIRECTIONS, kept = 0;
    memset(to, 0, 2 * MOST_DIRECTIONS * sizeof *to);
    for (size_t n = 0; n < basis->length; n++) {
        const double *v_re = basis->vectors + n * MOST_DIRECTIONS;
        const double *v_im = basis->vectors + (basis->length + n) * MOST_DIRECTIONS;
        double x = re[n], y = im[n];
        for (size_t d = 0; d < MOST_DIRECTIONS; d++) {
            to_re[d] += v_re[d] * x + v_im[d] * y;
            to_im[d] += v_re[d] * y - v_im[d] * x;
        }
    }
    for (size_t d = 0; d < basis->directions; d++) {
        kept += to_re[d] * to_re[d] + to_im[d] * to_im[d];
    }
    return norm > kept ? sqrt(norm - kept) : 0;
}

static void project_examples(const duct_example_set *set, duct_basis *basis, double *row)
{
    double place[2 * MOST_DIRECTIONS];
    for (size_t j = 0; j < set->count; j++) {
        if (!set->full[j]) {
            basis->norms[j] = -1;
            continue;
        }
        double norm = write_row(set, &set->around[j * set->slots], row, row + basis->length);
        basis->rests[j] = (float)project(basis, row, row + basis->length, norm, place);
        basis->norms[j] = (float)norm;
        for (size_t d = 0; d < basis->directions; d++) {
            basis->re[d * set->count + j] = (float)place[d];
            basis->im[d * set->count + j] = (float)place[MOST_DIRECTIONS + d];
        }
    }
}

duct_status duct_basis_new(const duct_allocator *allocator, const duct_example_set *set, duct_basis **basis,
                           duct_error *error)
{
    duct_basis *made = duct_alloc(allocator, 1, sizeof *made);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    made->length = row_length(set);
    made->vectors = duct_alloc(allocator, 2 * made->length * MOST_DIRECTIONS, sizeof *made->vectors);
    made->re = duct_alloc(allocator, (2 * MOST_DIRECTIONS + 2) * set->count, sizeof *made->re);
    double *rows = duct_alloc_raw(allocator, SAMPLED * (2 * made->length + 1), sizeof *rows);
    if (made->vectors == NULL || made->re == NULL || rows == NULL) {
        duct_release(allocator, rows);
        duct_basis_free(allocator, made);
        return duct_fail_memory(error);
    }
    made->im = made->re + MOST_DIRECTIONS * set->count;
    made->norms = made->im + MOST_DIRECTIONS * set->count;
    made->rests = made->norms + set->count;
    choose_directions(set, made, rows, rows + SAMPLED * 2 * made->length);
    project_examples(set, made, rows);
    duct_release(allocator, rows);
    *basis = made;
    return DUCT_OK;
}

void duct_basis_free(const duct_allocator *allocator, duct_basis *basis)
{
    if (basis != NULL) {
        duct_release(allocator, basis->vectors);
        duct_release(allocator, basis->re);
        duct_release(allocator, basis);
    }
}

size_t duct_basis_scratch(const duct_example_set *set)
{
    return 2 * row_length(set) + 1 + set->count; /* the query's vector, and two sums of floats a position */
}

void duct_basis_bounds(const duct_example_set *set, const duct_query *query, double *scratch, float *bounds,
                       float *estimates)
{
    const duct_basis *basis = set->basis;
    size_t count = set->count;
    double place[2 * MOST_DIRECTIONS], *im = scratch + basis->length;
    double norm = write_row(set, query->around, scratch, im);
    float rest = (float)project(basis, scratch, im, norm, place), own = (float)norm;
    float *sum_re = (float *)(scratch + 2 * basis->length + 1), *sum_im = sum_re + count;
    memset(sum_re, 0, 2 * count * sizeof *sum_re);
    for (size_t d = 0; d < basis->directions; d++) {
        const float *re = basis->re + d * count, *other = basis->im + d * count;
        float x = (float)place[d], y = (float)place[MOST_DIRECTIONS + d];
        for (size_t j = 0; j < count; j++) {
            sum_re[j] += re[j] * x + other[j] * y;
            sum_im[j] += re[j] * y - other[j] * x;
        }
    }
    bool free = set->options->rotation;
    for (size_t j = 0; j < count; j++) {
        float size = free ? sqrtf(sum_re[j] * sum_re[j] + sum_im[j] * sum_im[j]) : sum_re[j];
        float all = basis->norms[j] + own;
        /* Floats are rounded: a bound must not be above the truth. */
        float bound = all - 2 * (size + basis->rests[j] * rest) - 4e-6f * all;
        bounds[j] = basis->norms[j] < 0 || bound < 0 ? 0 : bound;
        estimates[j] = basis->norms[j] < 0 ? 0 : all - 2 * size;
    }
}
