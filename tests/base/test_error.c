/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "base/error.h"

static void fills_status_and_sentence(void **state)
{
    (void)state;
    duct_error error;
    assert_int_equal(duct_fail(&error, DUCT_IO, "line %d: %s", 3, "no"), DUCT_IO);
    assert_int_equal(error.status, DUCT_IO);
    assert_string_equal(error.message, "line 3: no");
    assert_int_equal(duct_fail(NULL, DUCT_LIMIT, "nobody listens"), DUCT_LIMIT);
    assert_int_equal(duct_fail_memory(&error), DUCT_NO_MEMORY);
    assert_true(strlen(error.message) > 0);
}

static void control_characters_become_question_marks(void **state)
{
    (void)state;
    duct_error error;
    duct_fail(&error, DUCT_IO, "%s", "a\nb\x1b[31m\x7f\xc3\xa4");
    assert_string_equal(error.message, "a?b?[31m?\xc3\xa4");
}

/* A sentence that is too long is cut, and never within a UTF-8 character. */
static void long_sentences_are_cut_between_characters(void **state)
{
    (void)state;
    static const char *const characters[] = {"x", "\xc3\xa4", "\xe2\x82\xac", "\xf0\x9f\x98\x80"};
    for (size_t c = 0; c < 4; c++) {
        for (size_t lead = 0; lead < 8; lead++) {
            char text[3000] = "";
            memset(text, 'a', lead);
            text[lead] = '\0';
            for (int i = 0; i < 600; i++) {
                strcat(text, characters[c]);
            }
            duct_error error;
            duct_fail(&error, DUCT_IO, "%s", text);
            size_t length = strlen(error.message);
            assert_true(length < DUCT_ERROR_SIZE && length >= DUCT_ERROR_SIZE - 5);
            assert_int_equal((length - lead) % strlen(characters[c]), 0);
            assert_memory_equal(error.message, text, length);
        }
    }
}

static void prefixes_come_before_and_keep_the_status(void **state)
{
    (void)state;
    duct_error error;
    duct_fail(&error, DUCT_BAD_FORMAT, "line 2: bad");
    duct_error_prefix(&error, "a.svg");
    assert_string_equal(error.message, "a.svg: line 2: bad");
    assert_int_equal(error.status, DUCT_BAD_FORMAT);
    duct_error_prefix(NULL, "a.svg");
    char name[2000];
    memset(name, 'n', sizeof name - 1);
    name[sizeof name - 1] = '\0';
    duct_error_prefix(&error, name);
    assert_true(strlen(error.message) < DUCT_ERROR_SIZE);
    assert_int_equal(error.status, DUCT_BAD_FORMAT);
}

static void every_status_has_a_text(void **state)
{
    (void)state;
    for (int s = DUCT_OK; s <= DUCT_CANCELLED; s++) {
        assert_string_not_equal(duct_status_text((duct_status)s), "unknown status");
    }
    assert_string_equal(duct_status_text((duct_status)99), "unknown status");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fills_status_and_sentence),
        cmocka_unit_test(control_characters_become_question_marks),
        cmocka_unit_test(long_sentences_are_cut_between_characters),
        cmocka_unit_test(prefixes_come_before_and_keep_the_status),
        cmocka_unit_test(every_status_has_a_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
