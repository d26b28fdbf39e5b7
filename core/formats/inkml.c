/* SPDX-License-Identifier: GPL-3.0-or-later */
/* InkML as a file format, and its elements' and attributes' looks. */
#include "base/error.h"
#include "base/number.h"
#include "formats/format_private.h"
#include "formats/inkml_private.h"
#include "formats/xml.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *find_attribute(const xmlNode *node, const char *name, const char *uri)
{
    for (const xmlAttr *attribute = node->properties; attribute != NULL; attribute = attribute->next) {
        const char *space = attribute->ns != NULL ? (const char *)attribute->ns->href : NULL;
        bool same = uri == NULL ? space == NULL : space != NULL && strcmp(space, uri) == 0;
        if (same && strcmp((const char *)attribute->name, name) == 0) {
            const xmlNode *text = attribute->children;
            bool plain = text != NULL && text->type == XML_TEXT_NODE && text->content != NULL;
            return plain ? (const char *)text->content : "";
        }
    }
    return NULL;
}

const char *duct_inkml_attribute(const xmlNode *node, const char *name)
{
    return find_attribute(node, name, NULL);
}

const char *duct_inkml_own_attribute(const xmlNode *node, const char *name)
{
    return find_attribute(node, name, DUCT_INKML_OWN_NAMESPACE);
}

const char *duct_inkml_id(const xmlNode *node)
{
    const char *id = find_attribute(node, "id", (const char *)XML_XML_NAMESPACE);
    return id != NULL ? id : find_attribute(node, "id", NULL);
}

bool duct_inkml_is(const xmlNode *node, const char *name)
{
    return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0 &&
           (node->ns == NULL || strcmp((const char *)node->ns->href, DUCT_INKML_OWN_NAMESPACE) != 0);
}

xmlNode *duct_inkml_child(const xmlNode *node, const char *name)
{
    int looked = 0;
    for (xmlNode *child = node->children; child != NULL && looked < DUCT_INKML_MOST_CHILDREN;
         child = child->next) {
        looked++;
        if (duct_inkml_is(child, name)) {
            return child;
        }
    }
    return NULL;
}

const char *duct_inkml_text(const xmlNode *node, xmlChar **made)
{
    const xmlNode *child = node->children;
    *made = NULL;
    if (child == NULL) {
        return "";
    }
    if (child->next == NULL && child->type == XML_TEXT_NODE && child->content != NULL) {
        return (const char *)child->content;
    }
    *made = xmlNodeGetContent(node);
    return *made != NULL ? (const char *)*made : "";
}

bool duct_inkml_number(const xmlNode *node, const char *name, double *number)
{
    const char *text = duct_inkml_attribute(node, name);
    return text != NULL && duct_number_parse(text, number);
}

duct_status duct_inkml_fail(const xmlNode *node, duct_error *error, const char *format, ...)
{
    char sentence[DUCT_ERROR_SIZE];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(sentence, sizeof sentence, format, arguments);
    va_end(arguments);
    return duct_fail(error, DUCT_BAD_FORMAT, "line %ld: %s", xmlGetLineNo(node), sentence);
}

static int compare_entries(const void *a, const void *b)
{
    const duct_inkml_entry *left = a, *right = b;
    int order = strcmp(left->id, right->id);
    return order != 0 ? order : (left->order > right->order) - (left->order < right->order);
}

bool duct_inkml_index_make(const duct_allocator *allocator, xmlNode *root, duct_inkml_index *index)
{
    *index = (duct_inkml_index){NULL, 0, 0};
    xmlNode *node = root;
    while (node != NULL) {
        const char *id = node->type == XML_ELEMENT_NODE ? duct_inkml_id(node) : NULL;
        if (id != NULL) {
            void *entries = index->entries;
            if (!duct_reserve(allocator, &entries, &index->capacity, index->count + 1,
                              sizeof(duct_inkml_entry))) {
                return false;
            }
            index->entries = entries;
            index->entries[index->count] = (duct_inkml_entry){id, node, index->count, -1};
            index->count++;
        }
        /* The children of an entity reference belong to its declaration: they are not walked. */
        if (node->type == XML_ELEMENT_NODE && node->children != NULL) {
            node = node->children;
            continue;
        }
        while (node != root && node->next == NULL) {
            node = node->parent;
        }
        node = node == root ? NULL : node->next;
    }
    if (index->count > 0) {
        qsort(index->entries, index->count, sizeof(duct_inkml_entry), compare_entries);
    }
    return true;
}

duct_inkml_entry *duct_inkml_index_find(const duct_inkml_index *index, const char *reference)
{
    return reference != NULL && reference[0] == '#' ? duct_inkml_index_find_id(index, reference + 1) : NULL;
}

duct_inkml_entry *duct_inkml_index_find_id(const duct_inkml_index *index, const char *id)
{
    size_t low = 0, high = index->count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (strcmp(index->entries[middle].id, id) < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    bool found = low < index->count && strcmp(index->entries[low].id, id) == 0;
    return found ? &index->entries[low] : NULL;
}

static bool sniff(const char *data, size_t size)
{
    return duct_xml_root_is(data, size, "ink");
}

static duct_status read(const duct_context *context, const char *data, size_t size,
                        const duct_format_options *options, duct_drawing *drawing, duct_error *error)
{
    (void)options;
    return duct_inkml_read(context, data, size, drawing, error);
}

static duct_status write(const duct_context *context, const duct_drawing *drawing,
                         const duct_format_options *options, duct_text *out, duct_error *error)
{
    (void)options;
    return duct_inkml_write(context, drawing, out, error);
}

const duct_format_impl duct_format_inkml = {
    {"inkml", "Ink Markup Language", "inkml ink", true, true},
    sniff,
    read,
    write,
};
