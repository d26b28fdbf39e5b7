/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_EXPORT_H
#define DUCTUS_EXPORT_H

/* Everything in these headers is exported from libductus; everything else is hidden. */
#if defined(__GNUC__)
#define DUCT_API __attribute__((visibility("default")))
#define DUCT_PRINTF(text, first) __attribute__((__format__(__printf__, text, first)))
#else
#define DUCT_API
#define DUCT_PRINTF(text, first)
#endif

#endif
