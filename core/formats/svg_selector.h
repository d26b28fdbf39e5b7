/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_SVG_SELECTOR_H
#define DUCTUS_FORMATS_SVG_SELECTOR_H

#include "formats/svg_scan.h"

#include <libxml/tree.h>
#include <stdint.h>

enum { DUCT_CSS_COMPOUNDS = 8 };

/* A CSS selector such as "g.thin > path#a": compounds from left to right. */
typedef struct duct_css_selector {
    duct_slice compound[DUCT_CSS_COMPOUNDS]; /* "path.a.b#c", "*", ".a" */
    bool child[DUCT_CSS_COMPOUNDS];          /* joined to the one before by '>' rather than by a space */
    int count;
    uint32_t specificity; /* ids, classes and types, eight bits each and saturated */
} duct_css_selector;

/* False where the selector has parts that are not supported (attributes, pseudo-classes, siblings) or too
 * many. */
bool duct_css_selector_parse(duct_slice text, duct_css_selector *selector);

bool duct_css_selector_matches(const duct_css_selector *selector, const xmlNode *element);

#endif
