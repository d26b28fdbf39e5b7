/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_POOL_H
#define DUCTUS_BASE_POOL_H

#include <ductus/context.h>
#include <ductus/status.h>

/* Work on item `index` by worker `worker` (0 .. duct_pool_workers() - 1), which may use scratch memory of its
 * own. What it makes may depend on the item only. */
typedef duct_status (*duct_pool_task)(void *arg, size_t worker, size_t index, duct_error *error);

/* How many workers duct_pool_run() uses for `count` items. At least 1. */
size_t duct_pool_workers(const duct_context *context, size_t count);

/* Runs the task for items 0..count-1, spread over threads; returns when all have ended. The first failure
 * stops the handing out of items; where several fail, the lowest item's error is returned, so the outcome
 * does not depend on the number of threads. Reports progress from the calling thread, from `begin` to `end`.
 * Errors: the tasks'; DUCT_CANCELLED. Where threads cannot be made, fewer do the work. */
duct_status duct_pool_run(const duct_context *context, size_t count, double begin, double end,
                          duct_pool_task task, void *arg, duct_error *error);

/* Asks, from inside a task that takes long, whether the user has cancelled; on the calling thread it also
 * lets him. A task that gets DUCT_CANCELLED frees what it holds and returns it. Outside a pool: DUCT_OK. */
duct_status duct_pool_check(duct_error *error);

/* Reports progress outside a pool; DUCT_CANCELLED where the user wants to stop. */
duct_status duct_progress_report(const duct_context *context, double fraction, duct_error *error);

#endif
