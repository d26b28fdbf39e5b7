/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "testing.h"

#include "trace_text.h"

#include <ductus/ductus.h>

static duct_segments *read_good(const char *text, const char *pass)
{
    duct_error error;
    duct_segments *segments = NULL;
    assert_ok(duct_segments_read_memory(NULL, text, strlen(text), "t.json", pass, &segments, &error));
    return segments;
}

/* Reads what must be refused, and gives the sentence. */
static const char *refuse(duct_status wanted, const char *text, size_t size)
{
    static duct_error error;
    error = (duct_error){DUCT_OK, ""};
    duct_segments *segments = (void *)&error;
    assert_int_equal(duct_segments_read_memory(NULL, text, size, "t.json", NULL, &segments, &error), wanted);
    assert_ptr_equal(segments, &error);
    assert_memory_equal(error.message, "t.json: ", 8);
    return error.message;
}

static void expect_segment(const duct_segment *segment, size_t first, size_t last, size_t stroke,
                           size_t begin, size_t end)
{
    assert_int_equal(segment->first, first);
    assert_int_equal(segment->last, last);
    assert_int_equal(segment->library_stroke, stroke);
    assert_int_equal(segment->begin, begin);
    assert_int_equal(segment->end, end);
}

static void runs_without_a_jump_are_segments(void **state)
{
    (void)state;
    size_t count, samples;
    duct_segments *segments = read_good(TRACE, "trajectory");
    assert_string_equal(duct_segments_hand(segments), "somebody");
    assert_int_equal(duct_segments_stroke_count(segments), 3);
    const duct_segment *found = duct_segments_of(segments, 0, &count, &samples);
    assert_int_equal(count, 3);
    assert_int_equal(samples, 5);
    expect_segment(&found[0], 0, 2, 0, 1, 2);
    expect_segment(&found[1], 3, 3, 0, 0, 0);
    expect_segment(&found[2], 4, 4, 1, 3, 3);
    found = duct_segments_of(segments, 1, &count, &samples);
    assert_int_equal(count, 1);
    expect_segment(&found[0], 0, 0, 0, 4, 4);
    assert_string_equal(duct_segments_stroke_id(segments, 1), "b");
    assert_string_equal(duct_segments_stroke_id(segments, 2), "c \"\xc3\xa4");
    assert_null(duct_segments_of(segments, 2, &count, &samples));
    assert_int_equal(samples, 0);
    assert_null(duct_segments_of(segments, 3, &count, &samples));
    assert_null(duct_segments_stroke_id(segments, 3));
    duct_segments_free(segments);
}

static void the_pass_can_be_chosen(void **state)
{
    (void)state;
    size_t count, samples;
    duct_segments *last = read_good(TRACE, NULL), *pose = read_good(TRACE, "pose"),
                  *none = read_good(TRACE, "x");
    const duct_segment *found = duct_segments_of(last, 0, &count, &samples);
    assert_int_equal(count, 1);
    expect_segment(&found[0], 0, 1, 1, 0, 2);
    duct_segments_of(last, 1, &count, &samples);
    assert_int_equal(count, 1);
    duct_segments_of(pose, 1, &count, &samples);
    assert_int_equal(count, 0);
    duct_segments_of(none, 0, &count, &samples);
    assert_int_equal(count, 0);
    duct_segments_free(last);
    duct_segments_free(pose);
    duct_segments_free(none);
    duct_segments_free(NULL);
}

/* A copy of the trace with one piece replaced. */
static char *changed(const char *from, const char *to)
{
    const char *at = strstr(TRACE, from);
    assert_non_null(at);
    size_t head = (size_t)(at - TRACE);
    char *text = malloc(sizeof TRACE + strlen(to));
    memcpy(text, TRACE, head);
    strcpy(text + head, to);
    strcat(text, at + strlen(from));
    return text;
}

static void reject_what_a_trace_cannot_hold(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to, *says;
    } wrong[] = {
        {"[0, 1, 0.5], \"next", "[2, 1, 0.5], \"next", "line 8: \"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "[0, 5, 0.5], \"next", "\"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "[0, -1, 0.5], \"next", "\"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "[0, 1e99, 0.5], \"next", "\"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "[0, 99999999999999999999999, 0.5], \"next", "\"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "[0], \"next", "\"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "null, \"next", "\"chosen\" names a place"},
        {"[0, 1, 0.5], \"next", "[0, [[1]], \"next", "line"},
        {"[5, 4]", "[5, -4]", "whole numbers"},
        {"[5, 4]", "[5, \"4\"]", "whole numbers"},
        {"[5, 4]", "5", "whole numbers"},
        {"[5, 4]", "[5, 4], \"stroke_samples\": [5, 4]", "twice"},
        {"\"library\"", "\"other\"", "no trace of a restyled drawing"},
        {"\"strokes\": [\n", "\"others\": [\n", "no trace of a restyled drawing"},
        {"  ]\n}\n", "  ], \"strokes\": []\n}\n", "no trace of a restyled drawing"},
        {"{\"id\": \"a\"", "{\"id\": 7", "\"id\" has to be a text"},
        {"\"id\": \"b\"", "\"id\": \"b", "line"},
        {"\"somebody\"", "1", "\"hand\" has to be a text"},
        {"\"pass\": \"pose\"", "\"pass\": {}", "\"pass\" has to be a text"},
        {"\"passes\": []", "\"passes\": {}", "\"passes\" has to be an array"},
        {"  ]\n}\n", "  ]\n}\n{}", "something follows"},
        {"\"unit\": 2.5,", "\"unit\": 2.5 ", "a comma is expected"},
        {"\"unit\": 2.5,", "\"unit\"  2.5,", "a colon is expected"},
        {"\"unit\": 2.5,", "unit: 2.5,", "name is expected"},
        {"\"unit\": 2.5,", "\"unit\": ,", "a value is expected"},
        {"\"unit\": 2.5,", "\"unit\": [}],", "not opened"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char *text = changed(wrong[i].from, wrong[i].to);
        const char *sentence = refuse(DUCT_BAD_FORMAT, text, strlen(text));
        if (strstr(sentence, wrong[i].says) == NULL) {
            fail_msg("%zu: %s", i, sentence);
        }
        free(text);
    }
}

static void reject_other_files(void **state)
{
    (void)state;
    static const char *const others[] = {
        "",     " ",      "{}",      "[]",       "null", "{\"strokes\": []}", "<svg/>", "\"", "{\"",
        "{\"a", "{\"a\"", "{\"a\":", "{\"a\":1", "{,}",  "\xff\xfe"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
        refuse(DUCT_BAD_FORMAT, others[i], strlen(others[i]));
    }
    duct_error error = {DUCT_OK, ""};
    duct_segments *segments = NULL;
    assert_int_equal(duct_segments_read(NULL, "/nonexistent/t.json", NULL, &segments, &error),
                     DUCT_NOT_FOUND);
    assert_int_equal(duct_segments_read(NULL, "/", NULL, &segments, &error), DUCT_IO);
    assert_null(segments);
}

static void reject_a_run_that_chose_nothing(void **state)
{
    (void)state;
    char *text = changed("\"chosen\": [0, 4, 0]", "\"candidates\": []");
    assert_non_null(strstr(refuse(DUCT_UNSUPPORTED, text, strlen(text)), "--select optimal"));
    free(text);
}

static void reject_truncation_everywhere(void **state)
{
    (void)state;
    /* In memory of exactly that size, so that reading beyond is found. */
    size_t whole = strlen(TRACE) - 1;
    for (size_t size = 0; size < whole; size++) {
        char *text = malloc(size + 1);
        memcpy(text, TRACE, size);
        refuse(DUCT_BAD_FORMAT, text, size);
        free(text);
    }
}

static void any_byte_changed_is_read_or_refused(void **state)
{
    (void)state;
    static const char bytes[] = {'\0', '"', '{', '}', '[', ']', ',', ':', '9', '-', '\\', (char)0xff, ' '};
    size_t size = strlen(TRACE);
    for (size_t i = 0; i < size; i++) {
        for (size_t b = 0; b < sizeof bytes; b++) {
            char *text = malloc(size);
            memcpy(text, TRACE, size);
            text[i] = bytes[b];
            duct_error error = {DUCT_OK, ""};
            duct_segments *segments = NULL;
            duct_status status = duct_segments_read_memory(NULL, text, size, "t", NULL, &segments, &error);
            assert_true((status == DUCT_OK) == (segments != NULL));
            assert_true(status == DUCT_OK || error.message[0] != '\0');
            duct_segments_free(segments);
            free(text);
        }
    }
}

static void reject_depth_without_end(void **state)
{
    (void)state;
    size_t depth = 1000000;
    char *text = malloc(depth + 8);
    memcpy(text, "{\"a\":", 5);
    memset(text + 5, '[', depth);
    assert_non_null(strstr(refuse(DUCT_BAD_FORMAT, text, depth + 5), "too many brackets"));
    free(text);
}

static void a_million_samples_take_little_time(void **state)
{
    (void)state;
    static const char head[] =
        "{\"library\": {\"stroke_samples\": [1]}, \"strokes\": [{\"passes\": [{\"samples\": [";
    static const char item[] = "{\"chosen\": [0, 0, 0], \"next\": \"jump\"},";
    size_t count = 1000000, size = strlen(head), samples;
    char *text = malloc(size + count * strlen(item) + 32);
    strcpy(text, head);
    for (size_t i = 0; i < count; i++) {
        memcpy(text + size, item, strlen(item));
        size += strlen(item);
    }
    strcpy(text + size - 1, "]}]}]}");
    duct_segments *segments = read_good(text, NULL);
    duct_segments_of(segments, 0, &size, &samples);
    assert_int_equal(samples, count);
    assert_int_equal(size, count);
    duct_segments_free(segments);
    free(text);
}

static void every_failed_allocation_is_survived(void **state)
{
    (void)state;
    bool done = false;
    for (long n = 1; !done; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_segments *segments = NULL;
        duct_status status =
            duct_segments_read_memory(&context, TRACE, strlen(TRACE), "t", NULL, &segments, NULL);
        done = status == DUCT_OK;
        assert_true(done || status == DUCT_NO_MEMORY);
        assert_true(done == (segments != NULL));
        duct_segments_free(segments);
        assert_int_equal(failing.held, 0);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(runs_without_a_jump_are_segments),
        cmocka_unit_test(the_pass_can_be_chosen),
        cmocka_unit_test(reject_what_a_trace_cannot_hold),
        cmocka_unit_test(reject_other_files),
        cmocka_unit_test(reject_a_run_that_chose_nothing),
        cmocka_unit_test(reject_truncation_everywhere),
        cmocka_unit_test(any_byte_changed_is_read_or_refused),
        cmocka_unit_test(reject_depth_without_end),
        cmocka_unit_test(a_million_samples_take_little_time),
        cmocka_unit_test(every_failed_allocation_is_survived),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
