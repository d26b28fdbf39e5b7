/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_FORMATS_XML_H
#define DUCTUS_FORMATS_XML_H

#include <ductus/status.h>

#include <libxml/tree.h>
#include <stdbool.h>
#include <stddef.h>

/* Parses an XML document with network, external entities and external DTDs off, entity expansion bounded, and
 * depth limited to DUCT_MAX_GROUP_DEPTH, so that hostile files (billion laughs, deep nesting) end in a
 * sentence with a line number. White space and comments are kept. The caller frees the document with
 * xmlFreeDoc(). Safe to call from several threads. Errors: DUCT_BAD_FORMAT, DUCT_LIMIT, DUCT_NO_MEMORY. */
duct_status duct_xml_parse(const char *data, size_t size, xmlDoc **document, duct_error *error);

/* True where the text begins as an XML document in an encoding like ASCII whose first element has that name,
 * with any prefix. Nothing is parsed. */
bool duct_xml_root_is(const char *data, size_t size, const char *name);

#endif
