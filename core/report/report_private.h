/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_REPORT_PRIVATE_H
#define DUCTUS_REPORT_PRIVATE_H

#include "base/memory.h"

#include <ductus/report.h>

typedef struct duct_report_library {
    char *name;
    size_t strokes, samples;
    double unit;
} duct_report_library;

struct duct_report {
    duct_allocator allocator;
    size_t count;
    duct_report_library *libraries;
    duct_report_entry *entries; /* [second][first], first <= second: those of row b begin at b (b + 1) / 2 */
};

#endif
