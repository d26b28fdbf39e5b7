/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_document.h"

#include "base/error.h"
#include "formats/svg_transform.h"
#include "formats/xml.h"

#include <stdlib.h>
#include <string.h>

static const char svg_namespace[] = "http://www.w3.org/2000/svg";

typedef struct duct_svg_id {
    const char *id;
    xmlNode *node;
} duct_svg_id;

bool duct_svg_is_element(const xmlNode *node)
{
    return node->type == XML_ELEMENT_NODE &&
           (node->ns == NULL || strcmp((const char *)node->ns->href, svg_namespace) == 0);
}

const char *duct_svg_reference(const xmlNode *element)
{
    for (const xmlAttr *attribute = element->properties; attribute != NULL; attribute = attribute->next) {
        if (strcmp((const char *)attribute->name, "href") == 0 && attribute->children != NULL) {
            return (const char *)attribute->children->content;
        }
    }
    return NULL;
}

xmlNode *duct_svg_next_element(xmlNode *element)
{
    xmlNode *node = element;
    do {
        if (node->type == XML_ELEMENT_NODE && node->children != NULL) {
            node = node->children;
            continue;
        }
        while (node->next == NULL) {
            node = node->parent;
            if (node == NULL || node->type != XML_ELEMENT_NODE) {
                return NULL;
            }
        }
        node = node->next;
    } while (node->type != XML_ELEMENT_NODE);
    return node;
}

/* Attributes with references to the document's own entities become plain texts. The parser has bounded each
 * one; all together are bounded here. */
static duct_status make_plain(duct_svg_document *document, duct_error *error)
{
    enum { MOST_EXPANDED = 64 << 20 };
    size_t expanded = 0;
    for (xmlNode *node = document->root; node != NULL; node = duct_svg_next_element(node)) {
        for (xmlAttr *attribute = node->properties; attribute != NULL; attribute = attribute->next) {
            xmlNode *text = attribute->children;
            if (text == NULL || (text->next == NULL && text->type == XML_TEXT_NODE)) {
                continue;
            }
            xmlChar *value = xmlNodeListGetString(document->xml, text, 1);
            xmlNode *plain = xmlNewDocText(document->xml, value != NULL ? value : BAD_CAST "");
            expanded += value != NULL ? strlen((const char *)value) : 0;
            xmlFree(value);
            if (plain == NULL) {
                return duct_fail_memory(error);
            }
            if (expanded > MOST_EXPANDED) {
                xmlFreeNode(plain);
                return duct_fail(error, DUCT_LIMIT, "line %ld: the entities in attributes are too large",
                                 xmlGetLineNo(node));
            }
            xmlFreeNodeList(text);
            plain->parent = (xmlNode *)attribute;
            attribute->children = attribute->last = plain;
        }
    }
    return DUCT_OK;
}

static int compare_ids(const void *left, const void *right)
{
    return strcmp(((const duct_svg_id *)left)->id, ((const duct_svg_id *)right)->id);
}

static duct_status collect_ids(duct_svg_document *document, duct_error *error)
{
    size_t capacity = 0;
    for (xmlNode *node = document->root; node != NULL; node = duct_svg_next_element(node)) {
        const char *id = duct_svg_attribute(node, "id");
        if (id == NULL) {
            continue;
        }
        void *ids = document->ids;
        if (!duct_reserve(document->allocator, &ids, &capacity, document->id_count + 1,
                          sizeof(duct_svg_id))) {
            return duct_fail_memory(error);
        }
        document->ids = ids;
        document->ids[document->id_count++] = (duct_svg_id){id, node};
    }
    if (document->id_count > 1) {
        qsort(document->ids, document->id_count, sizeof(duct_svg_id), compare_ids);
    }
    return DUCT_OK;
}

const xmlNode *duct_svg_document_find(const duct_svg_document *document, duct_slice id)
{
    size_t low = 0, high = document->id_count;
    while (low < high) {
        size_t middle = low + (high - low) / 2;
        const char *other = document->ids[middle].id;
        int order = strncmp(other, id.text, id.size);
        if (order == 0 && other[id.size] == '\0') {
            return document->ids[middle].node;
        }
        if (order < 0) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return NULL;
}

/* A style element's text; it may be in pieces. */
static duct_status add_style(duct_svg_document *document, const xmlNode *style, duct_error *error)
{
    const char *type = duct_svg_attribute(style, "type"), *media = duct_svg_attribute(style, "media");
    if ((type != NULL && *type != '\0' && strcmp(type, "text/css") != 0) ||
        (media != NULL && strstr(media, "print") != NULL)) {
        return DUCT_OK;
    }
    duct_text text;
    duct_text_init(&text, document->allocator);
    for (const xmlNode *part = style->children; part != NULL; part = part->next) {
        bool holds = part->type == XML_TEXT_NODE || part->type == XML_CDATA_SECTION_NODE;
        if (holds && part->content != NULL) {
            duct_text_add(&text, (const char *)part->content);
        }
    }
    duct_status status = text.failed         ? duct_fail_memory(error)
                         : text.data != NULL ? duct_css_sheet_add(document->sheet, text.data, error)
                                             : DUCT_OK;
    duct_text_free(&text);
    return status;
}

static duct_status collect_styles(duct_svg_document *document, duct_error *error)
{
    duct_status status = duct_css_sheet_new(document->allocator, &document->sheet, error);
    for (xmlNode *node = document->root; status == DUCT_OK && node != NULL;
         node = duct_svg_next_element(node)) {
        if (duct_svg_is_element(node) && strcmp((const char *)node->name, "style") == 0) {
            status = add_style(document, node, error);
        }
    }
    return status;
}

/* Width and height of the root element. Where one is missing or relative the view box tells. */
static void measure_page(duct_svg_document *document)
{
    duct_svg_viewport none = {0, 0, 16};
    double box[4], width, height;
    bool has_box = duct_svg_viewbox(duct_svg_attribute(document->root, "viewBox"), box);
    bool has_width = duct_svg_length(duct_slice_of(duct_svg_attribute(document->root, "width")),
                                     DUCT_SVG_HORIZONTAL, &none, &width) &&
                     width > 0;
    bool has_height = duct_svg_length(duct_slice_of(duct_svg_attribute(document->root, "height")),
                                      DUCT_SVG_VERTICAL, &none, &height) &&
                      height > 0;
    if (!has_width && !(has_box && has_height)) {
        width = has_box ? box[2] : 0;
    } else if (!has_width) {
        width = height * box[2] / box[3];
    }
    if (!has_height) {
        height = has_box ? width * box[3] / box[2] : 0;
    }
    bool has_page = width > 0 && height > 0;
    document->width = has_page ? width : 0;
    document->height = has_page ? height : 0;
}

duct_affine duct_svg_root_map(const duct_svg_document *document)
{
    double box[4];
    if (document->width <= 0 || !duct_svg_viewbox(duct_svg_attribute(document->root, "viewBox"), box)) {
        return duct_affine_identity();
    }
    return duct_svg_viewbox_map(box, duct_svg_attribute(document->root, "preserveAspectRatio"),
                                document->width, document->height);
}

duct_status duct_svg_document_open(const duct_allocator *allocator, const char *data, size_t size,
                                   duct_svg_document *document, duct_error *error)
{
    duct_svg_document made = {.allocator = allocator};
    duct_status status = duct_xml_parse(data, size, &made.xml, error);
    if (status != DUCT_OK) {
        return status;
    }
    made.root = xmlDocGetRootElement(made.xml);
    if (!duct_svg_is_element(made.root) || strcmp((const char *)made.root->name, "svg") != 0) {
        status = duct_fail(error, DUCT_BAD_FORMAT, "line %ld: the document is <%s>, not <svg>",
                           xmlGetLineNo(made.root), (const char *)made.root->name);
    }
    if (status == DUCT_OK) {
        status = make_plain(&made, error);
    }
    if (status == DUCT_OK) {
        status = collect_ids(&made, error);
    }
    if (status == DUCT_OK) {
        status = collect_styles(&made, error);
    }
    if (status != DUCT_OK) {
        duct_svg_document_close(&made);
        return status;
    }
    measure_page(&made);
    *document = made;
    return DUCT_OK;
}

void duct_svg_document_close(duct_svg_document *document)
{
    duct_css_sheet_free(document->sheet);
    duct_release(document->allocator, document->ids);
    xmlFreeDoc(document->xml);
    *document = (duct_svg_document){.allocator = document->allocator};
}

const duct_css_sheet *duct_svg_document_sheet(const duct_svg_document *document)
{
    return document->sheet;
}
