/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "formats/xml.h"

#include <ductus/drawing.h>

#include <pthread.h>
#include <unistd.h>

static xmlDoc *parse(const char *text)
{
    duct_error error;
    xmlDoc *document = NULL;
    assert_ok(duct_xml_parse(text, strlen(text), &document, &error));
    assert_non_null(document);
    return document;
}

static void refuse(const char *text, size_t size, duct_status expected, const char *part)
{
    duct_error error = {DUCT_OK, ""};
    xmlDoc *document = NULL;
    duct_status status = duct_xml_parse(text, size, &document, &error);
    if (status != expected || strstr(error.message, part) == NULL) {
        fail_msg("status %d, \"%s\" instead of %d, \"...%s...\"", (int)status, error.message, (int)expected,
                 part);
    }
    assert_null(document);
}

static void white_space_and_comments_are_kept(void **state)
{
    (void)state;
    xmlDoc *document = parse("<a> <!-- c --><b/>\n</a>");
    const xmlNode *node = xmlDocGetRootElement(document)->children;
    assert_int_equal(node->type, XML_TEXT_NODE);
    assert_int_equal(node->next->type, XML_COMMENT_NODE);
    xmlFreeDoc(document);
}

static void refuses_malformed_documents_by_line(void **state)
{
    (void)state;
    static const char *const texts[] = {"",          " ",        "no xml",      "<a>", "<a></b>",
                                        "<a b></a>", "<a/><b/>", "<a>\xff</a>", "&x;"};
    for (size_t i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        refuse(texts[i], strlen(texts[i]), DUCT_BAD_FORMAT, "well-formed XML");
    }
    refuse("<a>\n\n<b></c></a>", 15, DUCT_BAD_FORMAT, "line 3: ");
}

static void refuses_deep_nesting(void **state)
{
    (void)state;
    enum { DEPTH = 4000000 }; /* long enough for the parser's own limits to be off */
    char *text = malloc(DEPTH * 3);
    assert_non_null(text);
    for (size_t i = 0; i < DEPTH; i++) {
        memcpy(text + 3 * i, "<g>", 3);
    }
    refuse(text, DEPTH * 3, DUCT_LIMIT, "nested more than 256 deep");
    refuse(text, 3000, DUCT_LIMIT, "nested more than 256 deep");
    /* As deep as is allowed. */
    size_t size = 0;
    for (size_t i = 0; i < DUCT_MAX_GROUP_DEPTH; i++) {
        memcpy(text + size, "<g>", 3);
        size += 3;
    }
    for (size_t i = 0; i < DUCT_MAX_GROUP_DEPTH; i++) {
        memcpy(text + size, "</g>", 4);
        size += 4;
    }
    text[size] = '\0';
    xmlFreeDoc(parse(text));
    free(text);
}

/* The billion laughs: in content, and in an attribute. */
static void refuses_entities_that_expand_without_bound(void **state)
{
    (void)state;
    char declarations[4096] = "<!DOCTYPE a [<!ENTITY e0 'laughter laughter laughter'>";
    for (int i = 1; i < 12; i++) {
        char one[256];
        snprintf(one, sizeof one, "<!ENTITY e%d '&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;&e%d;'>", i,
                 i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1, i - 1);
        strcat(declarations, one);
    }
    strcat(declarations, "]>");
    static const char *const uses[] = {"<a>&e11;</a>", "<a b='&e11;'/>"};
    for (size_t i = 0; i < 2; i++) {
        char text[5000];
        snprintf(text, sizeof text, "%s%s", declarations, uses[i]);
        duct_error error = {DUCT_OK, ""};
        xmlDoc *document = NULL;
        duct_status status = duct_xml_parse(text, strlen(text), &document, &error);
        assert_true(status == DUCT_LIMIT || status == DUCT_BAD_FORMAT);
        assert_null(document);
    }
}

static void small_entities_work(void **state)
{
    (void)state;
    xmlDoc *document = parse("<!DOCTYPE a [<!ENTITY e 'x'>]><a>&e;</a>");
    xmlChar *content = xmlNodeGetContent(xmlDocGetRootElement(document));
    assert_string_equal((char *)content, "x");
    xmlFree(content);
    xmlFreeDoc(document);
}

static void nothing_outside_the_document_is_loaded(void **state)
{
    (void)state;
    char path[] = "/tmp/ductus-xml-XXXXXX";
    int file = mkstemp(path);
    assert_true(file >= 0);
    assert_int_equal(write(file, "secret", 6), 6);
    close(file);
    char text[600];
    snprintf(text, sizeof text, "<!DOCTYPE a [<!ENTITY e SYSTEM 'file://%s'>]><a>&e;</a>", path);
    duct_error error;
    xmlDoc *document = NULL;
    if (duct_xml_parse(text, strlen(text), &document, &error) == DUCT_OK) {
        xmlChar *content = xmlNodeGetContent(xmlDocGetRootElement(document));
        assert_null(content != NULL ? strstr((char *)content, "secret") : NULL);
        xmlFree(content);
        xmlFreeDoc(document);
    }
    unlink(path);
}

static void long_texts_are_read(void **state)
{
    (void)state;
    enum { SIZE = 30 << 20 };
    static const char *const heads[] = {"<?xml version='1.0' encoding='utf-8'?><a>", "<!DOCTYPE a><a>",
                                        "<?xml version='1.0' encoding='UTF-7'?><a>"};
    char *text = malloc(SIZE);
    assert_non_null(text);
    for (size_t i = 0; i < 3; i++) {
        for (size_t k = 0; k < SIZE; k++) {
            text[k] = k % 100 == 99 ? '\n' : '1';
        }
        memcpy(text, heads[i], strlen(heads[i]));
        memcpy(text + SIZE - 4, "</a>", 4);
        duct_error error = {DUCT_OK, ""};
        xmlDoc *document = NULL;
        duct_status status = duct_xml_parse(text, SIZE, &document, &error);
        /* With a document type libxml2's own bounds stay in force, which differ from version to version. */
        assert_true(status == DUCT_OK || i > 0);
        assert_int_equal(status == DUCT_OK, document != NULL);
        xmlFreeDoc(document);
    }
    free(text);
}

static void nothing_is_printed(void **state)
{
    (void)state;
    char path[] = "/tmp/ductus-xml-XXXXXX";
    int file = mkstemp(path), old = dup(2);
    assert_true(file >= 0 && old >= 0);
    fflush(stderr);
    dup2(file, 2);
    xmlDoc *document = NULL;
    duct_xml_parse("<a xml:id='1'><b xml:id='1'/></a>", 33, &document, NULL);
    xmlFreeDoc(document);
    document = NULL;
    duct_xml_parse("<a><b></a>", 10, &document, NULL);
    dup2(old, 2);
    close(old);
    off_t size = lseek(file, 0, SEEK_END);
    close(file);
    unlink(path);
    assert_null(document);
    assert_int_equal(size, 0);
}

static void tells_the_root_element_without_parsing(void **state)
{
    (void)state;
    static const char *const yes[] = {"<ink/>",
                                      "<ink>",
                                      " \n<ink a='b'>",
                                      "<?xml version='1.0'?><!-- <svg> --><ink/>",
                                      "\xef\xbb\xbf<ink>",
                                      "<!DOCTYPE ink [<!ENTITY a '>'> ]><i:ink xmlns:i='x'/>",
                                      "<ink"};
    static const char *const no[] = {"",      "<",     "ink",       "<inkml/>", "<svg/>",
                                     "<!-- ", "<?xml", "<!DOCTYPE", "<x:inks/>"};
    for (size_t i = 0; i < sizeof yes / sizeof yes[0]; i++) {
        assert_true(duct_xml_root_is(yes[i], strlen(yes[i]), "ink"));
    }
    for (size_t i = 0; i < sizeof no / sizeof no[0]; i++) {
        assert_false(duct_xml_root_is(no[i], strlen(no[i]), "ink"));
    }
}

static void *parse_often(void *unused)
{
    (void)unused;
    for (int i = 0; i < 300; i++) {
        xmlDoc *document = NULL;
        if (duct_xml_parse("<a><b xml:id='x'/></a>", 22, &document, NULL) != DUCT_OK ||
            duct_xml_parse("<a><b></a>", 10, &document, NULL) == DUCT_OK) {
            return document;
        }
        xmlFreeDoc(document);
    }
    return NULL;
}

static void several_threads_parse_at_once(void **state)
{
    (void)state;
    pthread_t threads[4];
    for (int i = 0; i < 4; i++) {
        assert_int_equal(pthread_create(&threads[i], NULL, parse_often, NULL), 0);
    }
    for (int i = 0; i < 4; i++) {
        void *result = &result;
        pthread_join(threads[i], &result);
        assert_null(result);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white_space_and_comments_are_kept),
        cmocka_unit_test(refuses_malformed_documents_by_line),
        cmocka_unit_test(refuses_deep_nesting),
        cmocka_unit_test(refuses_entities_that_expand_without_bound),
        cmocka_unit_test(small_entities_work),
        cmocka_unit_test(nothing_outside_the_document_is_loaded),
        cmocka_unit_test(long_texts_are_read),
        cmocka_unit_test(nothing_is_printed),
        cmocka_unit_test(tells_the_root_element_without_parsing),
        cmocka_unit_test(several_threads_parse_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
