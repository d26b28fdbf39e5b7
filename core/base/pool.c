/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/pool.h"

#include "base/error.h"

#include <pthread.h>
#include <stdatomic.h>
#include <time.h>
#include <unistd.h>

enum { MOST_WORKERS = 256 };

typedef struct {
    const duct_context *context;
    size_t count;
    double begin, end;
    duct_pool_task task;
    void *arg;
    atomic_size_t next, done;
    atomic_bool stop;      /* hand out no more items */
    atomic_bool cancelled; /* by the user: items under way may end at once */
    double last_report;    /* of the calling thread */
    double last_fraction;
    pthread_mutex_t lock; /* guards the fields below */
    pthread_cond_t ended;
    size_t working; /* threads beside the calling one that still work */
    duct_status status;
    size_t failed_item;
    duct_error error;
} pool;

typedef struct {
    pool *pool;
    size_t worker;
} worker_arg;

size_t duct_pool_workers(const duct_context *context, size_t count)
{
    long threads = context != NULL ? context->threads : 0;
    if (threads <= 0) {
        threads = sysconf(_SC_NPROCESSORS_ONLN);
    }
    size_t workers = threads < 1 ? 1 : (size_t)threads;
    if (workers > MOST_WORKERS) {
        workers = MOST_WORKERS;
    }
    if (workers > count) {
        workers = count;
    }
    return workers < 1 ? 1 : workers;
}

duct_status duct_progress_report(const duct_context *context, double fraction, duct_error *error)
{
    if (context != NULL && context->progress != NULL &&
        !context->progress(context->progress_user, fraction)) {
        return duct_fail(error, DUCT_CANCELLED, "the work was cancelled");
    }
    return DUCT_OK;
}

static void record(pool *p, size_t item, const duct_error *error, duct_status status)
{
    pthread_mutex_lock(&p->lock);
    if (p->status == DUCT_OK || item < p->failed_item) {
        p->status = status;
        p->failed_item = item;
        p->error = *error;
    }
    pthread_mutex_unlock(&p->lock);
    atomic_store(&p->stop, true);
}

static double now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* The pool that this thread works for, for duct_pool_check(); NULL outside a run. It belongs to the run: a
 * nested run puts the outer one back. */
static _Thread_local pool *current_pool;
static _Thread_local bool current_is_caller;

/* Only the calling thread reports, and not more than some twenty times a second. */
static void report(pool *p)
{
    if (p->context == NULL || p->context->progress == NULL || atomic_load(&p->cancelled)) {
        return;
    }
    double time = now();
    if (time - p->last_report < 0.05) {
        return;
    }
    p->last_report = time;
    double share = (double)atomic_load(&p->done) / (double)p->count;
    double fraction = p->begin + (p->end - p->begin) * share;
    /* Items end in any order, but progress never runs backwards. */
    p->last_fraction = fraction > p->last_fraction ? fraction : p->last_fraction;
    duct_error error = {DUCT_OK, ""};
    duct_status status = duct_progress_report(p->context, p->last_fraction, &error);
    if (status != DUCT_OK) {
        atomic_store(&p->cancelled, true);
        record(p, p->count, &error, status);
    }
}

duct_status duct_pool_check(duct_error *error)
{
    if (current_pool == NULL) {
        return DUCT_OK;
    }
    if (current_is_caller) {
        report(current_pool);
    }
    return atomic_load(&current_pool->cancelled) ? duct_fail(error, DUCT_CANCELLED, "the work was cancelled")
                                                 : DUCT_OK;
}

static void work(pool *p, size_t worker)
{
    pool *outer = current_pool;
    bool outer_is_caller = current_is_caller;
    current_pool = p;
    current_is_caller = worker == 0;
    while (!atomic_load(&p->stop)) {
        size_t item = atomic_fetch_add(&p->next, 1);
        if (item >= p->count) {
            break;
        }
        duct_error error = {DUCT_OK, ""};
        duct_status status = p->task(p->arg, worker, item, &error);
        if (status != DUCT_OK && !(status == DUCT_CANCELLED && atomic_load(&p->cancelled))) {
            record(p, item, &error, status);
        }
        atomic_fetch_add(&p->done, 1);
        if (worker == 0) {
            report(p);
        }
    }
    current_pool = outer;
    current_is_caller = outer_is_caller;
}

static void *thread_main(void *arg)
{
    worker_arg *worker = arg;
    pool *p = worker->pool;
    work(p, worker->worker);
    pthread_mutex_lock(&p->lock);
    p->working--;
    pthread_cond_signal(&p->ended);
    pthread_mutex_unlock(&p->lock);
    return NULL;
}

/* Waits for the other threads to end, still listening to the user. */
static void wait_for_others(pool *p)
{
    pthread_mutex_lock(&p->lock);
    while (p->working > 0) {
        struct timespec until;
        clock_gettime(CLOCK_REALTIME, &until);
        until.tv_nsec += 50000000;
        until.tv_sec += until.tv_nsec / 1000000000;
        until.tv_nsec %= 1000000000;
        pthread_cond_timedwait(&p->ended, &p->lock, &until);
        pthread_mutex_unlock(&p->lock);
        report(p);
        pthread_mutex_lock(&p->lock);
    }
    pthread_mutex_unlock(&p->lock);
}

duct_status duct_pool_run(const duct_context *context, size_t count, double begin, double end,
                          duct_pool_task task, void *arg, duct_error *error)
{
    pool p = {.context = context, .count = count, .begin = begin, .end = end, .task = task, .arg = arg};
    duct_status status = duct_progress_report(context, begin, error);
    if (status != DUCT_OK) {
        return status;
    }
    pthread_mutex_init(&p.lock, NULL);
    pthread_cond_init(&p.ended, NULL);
    p.last_report = now();
    p.last_fraction = begin;
    size_t workers = duct_pool_workers(context, count);
    pthread_t threads[MOST_WORKERS];
    worker_arg args[MOST_WORKERS];
    size_t started = 1;
    for (; started < workers; started++) {
        args[started] = (worker_arg){&p, started};
        pthread_mutex_lock(&p.lock);
        p.working++;
        pthread_mutex_unlock(&p.lock);
        if (pthread_create(&threads[started], NULL, thread_main, &args[started]) != 0) {
            pthread_mutex_lock(&p.lock);
            p.working--;
            pthread_mutex_unlock(&p.lock);
            break;
        }
    }
    work(&p, 0);
    wait_for_others(&p);
    for (size_t i = 1; i < started; i++) {
        pthread_join(threads[i], NULL);
    }
    pthread_cond_destroy(&p.ended);
    pthread_mutex_destroy(&p.lock);
    if (p.status != DUCT_OK) {
        if (error != NULL) {
            *error = p.error;
        }
        return p.status;
    }
    return duct_progress_report(context, end, error);
}
