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
    atomic_bool stop;
    pthread_mutex_t lock; /* guards the three fields below */
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

static void work(pool *p, size_t worker)
{
    double last_report = worker == 0 ? now() : 0;
    while (!atomic_load(&p->stop)) {
        size_t item = atomic_fetch_add(&p->next, 1);
        if (item >= p->count) {
            break;
        }
        duct_error error = {DUCT_OK, ""};
        duct_status status = p->task(p->arg, worker, item, &error);
        if (status != DUCT_OK) {
            record(p, item, &error, status);
        }
        size_t done = atomic_fetch_add(&p->done, 1) + 1;
        /* Only the calling thread reports, and not more than some twenty times a second. */
        if (worker == 0 && p->context != NULL && p->context->progress != NULL) {
            double time = now();
            if (time - last_report >= 0.05) {
                last_report = time;
                double fraction = p->begin + (p->end - p->begin) * (double)done / (double)p->count;
                status = duct_progress_report(p->context, fraction, &error);
                if (status != DUCT_OK) {
                    record(p, p->count, &error, status);
                }
            }
        }
    }
}

static void *thread_main(void *arg)
{
    worker_arg *worker = arg;
    work(worker->pool, worker->worker);
    return NULL;
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
    size_t workers = duct_pool_workers(context, count);
    pthread_t threads[MOST_WORKERS];
    worker_arg args[MOST_WORKERS];
    size_t started = 1;
    for (; started < workers; started++) {
        args[started] = (worker_arg){&p, started};
        if (pthread_create(&threads[started], NULL, thread_main, &args[started]) != 0) {
            break;
        }
    }
    work(&p, 0);
    for (size_t i = 1; i < started; i++) {
        pthread_join(threads[i], NULL);
    }
    pthread_mutex_destroy(&p.lock);
    if (p.status != DUCT_OK) {
        if (error != NULL) {
            *error = p.error;
        }
        return p.status;
    }
    return duct_progress_report(context, end, error);
}
