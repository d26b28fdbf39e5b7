/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/error.h"
#include "base/pool.h"

#include <stdatomic.h>
#include <time.h>

enum { ITEMS = 5000 };

typedef struct {
    size_t results[ITEMS];
    size_t workers;
    size_t fails_from;
    atomic_size_t done;
} job;

static duct_status square(void *arg, size_t worker, size_t index, duct_error *error)
{
    job *j = arg;
    atomic_fetch_add(&j->done, 1);
    if (worker >= j->workers) {
        return duct_fail(error, DUCT_BAD_ARGUMENT, "worker %zu of %zu", worker, j->workers);
    }
    if (index >= j->fails_from) {
        return duct_fail(error, DUCT_BAD_FORMAT, "item %zu", index);
    }
    j->results[index] += index * index;
    return DUCT_OK;
}

static void results_are_the_same_on_any_number_of_threads(void **state)
{
    (void)state;
    static const int threads[] = {1, 2, 7, 0, 1000};
    for (size_t t = 0; t < 5; t++) {
        duct_error error;
        duct_context context = duct_context_default();
        context.threads = threads[t];
        job *j = calloc(1, sizeof *j);
        assert_non_null(j);
        j->fails_from = ITEMS;
        j->workers = duct_pool_workers(&context, ITEMS);
        assert_ok(duct_pool_run(&context, ITEMS, 0, 1, square, j, &error));
        for (size_t i = 0; i < ITEMS; i++) {
            assert_int_equal(j->results[i], i * i); /* each item once */
        }
        free(j);
    }
}

static void no_items_are_no_work(void **state)
{
    (void)state;
    duct_error error;
    assert_int_equal(duct_pool_workers(NULL, 0), 1);
    assert_ok(duct_pool_run(NULL, 0, 0, 1, square, NULL, &error));
}

static void the_lowest_items_error_wins(void **state)
{
    (void)state;
    static const int threads[] = {1, 2, 7};
    for (int round = 0; round < 30; round++) {
        duct_context context = duct_context_default();
        context.threads = threads[round % 3];
        duct_error error = {DUCT_OK, ""};
        job *j = calloc(1, sizeof *j);
        assert_non_null(j);
        j->fails_from = 100;
        j->workers = 7;
        assert_int_equal(duct_pool_run(&context, ITEMS, 0, 1, square, j, &error), DUCT_BAD_FORMAT);
        assert_string_equal(error.message, "item 100");
        assert_true(atomic_load(&j->done) < ITEMS);
        free(j);
    }
}

static bool refuse(void *user, double fraction)
{
    double *last = user;
    assert_true(fraction >= *last && fraction <= 1);
    *last = fraction;
    return fraction < 0.5;
}

static duct_status wait_a_little(void *arg, size_t worker, size_t index, duct_error *error)
{
    (void)worker;
    (void)index;
    (void)error;
    atomic_fetch_add((atomic_size_t *)arg, 1);
    struct timespec time = {0, 1000000};
    nanosleep(&time, NULL);
    return DUCT_OK;
}

static void cancelling_stops_the_work(void **state)
{
    (void)state;
    double last = 0;
    atomic_size_t done = 0;
    duct_context context = duct_context_default();
    context.threads = 2;
    context.progress = refuse;
    context.progress_user = &last;
    duct_error error = {DUCT_OK, ""};
    assert_int_equal(duct_pool_run(&context, 1000, 0, 1, wait_a_little, &done, &error), DUCT_CANCELLED);
    assert_int_equal(error.status, DUCT_CANCELLED);
    assert_true(atomic_load(&done) < 1000);
    /* Asked before the work begins. */
    last = 0;
    atomic_store(&done, 0);
    assert_int_equal(duct_pool_run(&context, 1000, 0.7, 1, wait_a_little, &done, &error), DUCT_CANCELLED);
    assert_int_equal(atomic_load(&done), 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(results_are_the_same_on_any_number_of_threads),
        cmocka_unit_test(no_items_are_no_work),
        cmocka_unit_test(the_lowest_items_error_wins),
        cmocka_unit_test(cancelling_stops_the_work),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
