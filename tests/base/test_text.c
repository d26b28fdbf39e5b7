/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/text.h"

static duct_text make(void)
{
    duct_text text;
    duct_text_init(&text, duct_allocator_of(NULL));
    return text;
}

static void grows_and_stays_terminated(void **state)
{
    (void)state;
    duct_text text = make();
    for (int i = 0; i < 1000; i++) {
        duct_text_addf(&text, "%d,", i);
        assert_int_equal(strlen(text.data), text.size);
    }
    assert_int_equal(text.size, 10 * 2 + 90 * 3 + 900 * 4);
    duct_text_free(&text);
    assert_null(text.data);
}

static void an_empty_text_is_taken_as_an_empty_string(void **state)
{
    (void)state;
    duct_text text = make();
    size_t size = 9;
    char *data = duct_text_take(&text, &size);
    assert_string_equal(data, "");
    assert_int_equal(size, 0);
    duct_release(duct_allocator_of(NULL), data);
}

static void xml_is_escaped_and_what_xml_forbids_is_left_out(void **state)
{
    (void)state;
    static const struct {
        const char *in, *out;
    } cases[] = {
        {"<a & 'b' \"c\">", "&lt;a &amp; &apos;b&apos; &quot;c&quot;&gt;"},
        {"a\x01\x1f\tb\n", "a\tb\n"},
        {"\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80", "\xc3\xa4\xe2\x82\xac\xf0\x9f\x98\x80"},
        {"a\xff\xc3(\xe2\x82", "a("},                        /* no UTF-8 */
        {"\xc0\x80x\xe0\x80\x80\xf0\x80\x80\x80", "x"},      /* overlong */
        {"\xed\xa0\x80x\xef\xbf\xbe\xf4\x90\x80\x80", "x"}}; /* surrogates, U+FFFE, beyond U+10FFFF */
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        duct_text text = make();
        duct_text_add_xml(&text, cases[i].in);
        assert_string_equal(text.data, cases[i].out);
        duct_text_free(&text);
    }
}

static void json_strings_are_escaped(void **state)
{
    (void)state;
    duct_text text = make();
    duct_text_add_json(&text, "a\"b\\c\n\x01");
    assert_string_equal(text.data, "\"a\\\"b\\\\c\\u000a\\u0001\"");
    duct_text_free(&text);
}

static void numbers_use_few_digits(void **state)
{
    (void)state;
    duct_text text = make();
    duct_text_add_number(&text, 0.1, 0);
    duct_text_add(&text, " ");
    duct_text_add_number(&text, 1.0 / 3, 4);
    duct_text_add(&text, " ");
    duct_text_add_fixed(&text, -0.0, 2);
    assert_string_equal(text.data, "0.1 0.3333 0");
    duct_text_free(&text);
}

static void a_failed_allocation_stops_all_and_holds_nothing(void **state)
{
    (void)state;
    for (long n = 1; n < 12; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_text text;
        duct_text_init(&text, &failing.allocator);
        for (int i = 0; i < 1000; i++) {
            duct_text_add(&text, "0123456789");
            duct_text_addf(&text, "%d", i);
        }
        bool failed = text.failed;
        size_t size = 0;
        char *data = duct_text_take(&text, &size);
        assert_int_equal(data == NULL, failed);
        assert_int_equal(failed, failing.calls >= n);
        duct_release(&failing.allocator, data);
        assert_int_equal(failing.held, 0);
    }
}

static void sizes_that_overflow_are_refused(void **state)
{
    (void)state;
    const duct_allocator *allocator = duct_allocator_of(NULL);
    assert_null(duct_alloc(allocator, SIZE_MAX / 4, 8));
    assert_null(duct_realloc(allocator, NULL, SIZE_MAX, 2));
    void *memory = NULL;
    size_t capacity = 0;
    assert_false(duct_reserve(allocator, &memory, &capacity, SIZE_MAX / 2, 16));
    assert_null(memory);
    assert_null(duct_strdup(allocator, NULL));
    duct_release(allocator, NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(grows_and_stays_terminated),
        cmocka_unit_test(an_empty_text_is_taken_as_an_empty_string),
        cmocka_unit_test(xml_is_escaped_and_what_xml_forbids_is_left_out),
        cmocka_unit_test(json_strings_are_escaped),
        cmocka_unit_test(numbers_use_few_digits),
        cmocka_unit_test(a_failed_allocation_stops_all_and_holds_nothing),
        cmocka_unit_test(sizes_that_overflow_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
