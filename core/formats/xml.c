/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/xml.h"

#include "base/error.h"

#include <ductus/drawing.h>

#include <libxml/parser.h>
#include <stdbool.h>
#include <string.h>
#include <strings.h>

enum {
    MOST_ELEMENTS = 1 << 23, /* about eight million, some two gigabytes of tree */
    PLAIN_TEXT_LIMIT = 8 << 20
};

/* What the parser's callbacks count. */
typedef struct {
    startElementNsSAX2Func start;
    endElementNsSAX2Func end;
    size_t depth, elements;
    bool too_deep, too_many;
} guard;

static void guarded_start(void *user, const xmlChar *name, const xmlChar *prefix, const xmlChar *uri,
                          int namespace_count, const xmlChar **namespaces, int attribute_count,
                          int default_count, const xmlChar **attributes)
{
    xmlParserCtxt *parser = user;
    guard *g = parser->_private;
    g->too_deep = g->too_deep || g->depth >= DUCT_MAX_GROUP_DEPTH;
    g->too_many = g->too_many || g->elements >= MOST_ELEMENTS;
    g->depth++;
    g->elements++;
    if (g->too_deep || g->too_many) {
        xmlStopParser(parser);
        return;
    }
    g->start(user, name, prefix, uri, namespace_count, namespaces, attribute_count, default_count,
             attributes);
}

static void guarded_end(void *user, const xmlChar *name, const xmlChar *prefix, const xmlChar *uri)
{
    xmlParserCtxt *parser = user;
    guard *g = parser->_private;
    if (g->too_deep || g->too_many) {
        return;
    }
    g->depth--;
    g->end(user, name, prefix, uri);
}

/* The library prints nothing. Without a handler of its own libxml2 would print what it thinks of xml:id
 * attributes, or call handlers that the host program set for itself. */
static void swallow(void *user, xmlError *reason)
{
    (void)user;
    (void)reason;
}

/* True where the document surely declares no entities: it is plain UTF-8 and has no document type. Only then
 * may XML_PARSE_HUGE be set, which allows texts of more than ten megabytes (a million samples in one trace)
 * but turns off libxml2's own bounds on entity expansion. */
static bool surely_without_entities(const char *data, size_t size)
{
    const char *start = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? data + 3 : data;
    if (strchr("< \t\r\n", *start) == NULL || memchr(data, '\0', size) != NULL ||
        memmem(data, size, "<!DOCTYPE", 9) != NULL) {
        return false;
    }
    if (strncmp(start, "<?xml", 5) != 0) {
        return true;
    }
    const char *end = strstr(start, "?>"), *encoding = strstr(start, "encoding");
    if (end == NULL || encoding == NULL || encoding > end) {
        return end != NULL;
    }
    encoding += strlen("encoding");
    encoding += strspn(encoding, " \t\r\n=\"'");
    return strncasecmp(encoding, "utf-8", 5) == 0;
}

/* Behind a declaration, comment or processing instruction that begins at `at`; NULL where it does not end. */
static const char *skip_markup(const char *at)
{
    if (strncmp(at, "<?", 2) == 0 || strncmp(at, "<!--", 4) == 0) {
        const char *mark = at[1] == '?' ? "?>" : "-->";
        const char *end = strstr(at, mark);
        return end != NULL ? end + strlen(mark) : NULL;
    }
    int depth = 0;
    for (; *at != '\0'; at++) {
        depth += *at == '[';
        depth -= *at == ']';
        if (*at == '>' && depth == 0) {
            return at + 1;
        }
    }
    return NULL;
}

bool duct_xml_root_is(const char *data, size_t size, const char *name)
{
    const char *at = size >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0 ? data + 3 : data;
    for (;;) {
        at += strspn(at, " \t\r\n");
        if (*at != '<') {
            return false;
        }
        if (at[1] != '?' && at[1] != '!') {
            break;
        }
        at = skip_markup(at);
        if (at == NULL) {
            return false;
        }
    }
    at++;
    size_t length = strcspn(at, " \t\r\n/>:");
    if (at[length] == ':') {
        at += length + 1;
        length = strcspn(at, " \t\r\n/>");
    }
    return length == strlen(name) && memcmp(at, name, length) == 0;
}

static duct_status fail_parse(xmlParserCtxt *parser, const guard *g, duct_error *error)
{
    int line = parser->input != NULL ? parser->input->line : 0;
    if (g->too_deep) {
        return duct_fail(error, DUCT_LIMIT, "line %d: elements are nested more than %d deep", line,
                         DUCT_MAX_GROUP_DEPTH);
    }
    if (g->too_many) {
        return duct_fail(error, DUCT_LIMIT, "line %d: there are more than %d elements", line, MOST_ELEMENTS);
    }
    const xmlError *reason = xmlCtxtGetLastError(parser);
    if (reason == NULL || reason->message == NULL) {
        return duct_fail(error, DUCT_BAD_FORMAT, "is no well-formed XML");
    }
    if (reason->code == XML_ERR_NO_MEMORY) {
        return duct_fail_memory(error);
    }
    if (reason->code == XML_ERR_ENTITY_LOOP) {
        return duct_fail(error, DUCT_LIMIT, "line %d: entities expand without bound", reason->line);
    }
    size_t length = strcspn(reason->message, "\n");
    while (length > 0 && (reason->message[length - 1] == ' ' || reason->message[length - 1] == '.')) {
        length--;
    }
    return duct_fail(error, DUCT_BAD_FORMAT, "line %d: is no well-formed XML: %.*s", reason->line,
                     (int)length, reason->message);
}

duct_status duct_xml_parse(const char *data, size_t size, xmlDoc **document, duct_error *error)
{
    if (size > DUCT_MAX_FILE_BYTES) {
        return duct_fail(error, DUCT_LIMIT, "is larger than the limit of %d MiB", DUCT_MAX_FILE_BYTES >> 20);
    }
    xmlInitParser();
    xmlParserCtxt *parser = xmlNewParserCtxt();
    if (parser == NULL) {
        return duct_fail_memory(error);
    }
    guard g = {parser->sax->startElementNs, parser->sax->endElementNs, 0, 0, false, false};
    parser->sax->startElementNs = guarded_start;
    parser->sax->endElementNs = guarded_end;
    parser->sax->serror = swallow;
    parser->_private = &g;
    /* Neither XML_PARSE_NOENT nor XML_PARSE_DTDLOAD: nothing outside the document is ever loaded. */
    int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_BIG_LINES;
    if (size > PLAIN_TEXT_LIMIT && surely_without_entities(data, size)) {
        options |= XML_PARSE_HUGE;
    }
    xmlDoc *made = xmlCtxtReadMemory(parser, data, (int)size, NULL, NULL, options);
    duct_status status = DUCT_OK;
    if (made == NULL || g.too_deep || g.too_many || xmlDocGetRootElement(made) == NULL) {
        status = fail_parse(parser, &g, error);
        xmlFreeDoc(made);
    } else {
        *document = made;
    }
    xmlFreeParserCtxt(parser);
    return status;
}
