/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The tables, their JSON, and settings that are checked against them. */
#include "testing.h"

#include <ductus/ductus.h>

#include <json-c/json.h>
#include <locale.h>
#include <math.h>

static duct_settings *new_settings(void)
{
    duct_error error;
    const duct_operation *operation;
    duct_settings *settings;
    assert_ok(duct_operation_find("restyle", &operation, &error));
    assert_ok(duct_settings_new(NULL, operation, &settings, &error));
    return settings;
}

static void tables_are_complete(void **state)
{
    (void)state;
    duct_error error;
    for (size_t o = 0; duct_operation_at(o) != NULL; o++) {
        const duct_operation *operation = duct_operation_at(o);
        assert_true(*operation->id && *operation->label && *operation->summary);
        assert_string_equal(operation->presets[0].id, "default");
        assert_int_equal(operation->presets[0].value_count, 0);
        for (size_t i = 0; i < operation->param_count; i++) {
            const duct_param *param = &operation->params[i];
            assert_true(*param->id && *param->label && *param->tooltip && *param->group &&
                        param->unit != NULL);
            assert_true((param->type == DUCT_PARAM_CHOICE) == (param->choice_count > 0));
            if (param->type == DUCT_PARAM_INT || param->type == DUCT_PARAM_REAL ||
                param->type == DUCT_PARAM_AUTO) {
                assert_true(param->minimum < param->maximum && param->step > 0);
            }
            for (size_t k = 0; k < i; k++) {
                assert_string_not_equal(param->id, operation->params[k].id);
            }
        }
        for (size_t p = 0; p < operation->preset_count; p++) {
            duct_settings *settings;
            assert_ok(duct_settings_new(NULL, operation, &settings, &error));
            assert_ok(duct_settings_set(settings, "preset", operation->presets[p].id, &error));
            for (size_t v = 0; v < operation->presets[p].value_count; v++) {
                const duct_preset_value *value = &operation->presets[p].values[v];
                assert_non_null(duct_settings_text(settings, value->param));
                assert_string_equal(duct_settings_text(settings, value->param), value->value);
            }
            duct_settings_free(settings);
        }
    }
}

static void json_says_what_the_tables_say(void **state)
{
    (void)state;
    duct_error error;
    char *text;
    assert_ok(duct_operations_json(NULL, &text, &error));
    struct json_object *root = json_tokener_parse(text), *operations = NULL;
    assert_non_null(root);
    assert_true(json_object_object_get_ex(root, "operations", &operations));
    for (size_t o = 0; duct_operation_at(o) != NULL; o++) {
        const duct_operation *operation = duct_operation_at(o);
        struct json_object *entry = json_object_array_get_idx(operations, o), *value = NULL, *params = NULL;
        assert_true(json_object_object_get_ex(entry, "id", &value));
        assert_string_equal(json_object_get_string(value), operation->id);
        assert_true(json_object_object_get_ex(entry, "parameters", &params));
        assert_int_equal(json_object_array_length(params), operation->param_count);
        static const char *const fields[] = {"id",   "label",   "tooltip", "type",
                                             "unit", "default", "choices", "group"};
        for (size_t i = 0; i < operation->param_count; i++) {
            const duct_param *param = &operation->params[i];
            struct json_object *object = json_object_array_get_idx(params, i);
            for (size_t f = 0; f < sizeof fields / sizeof fields[0]; f++) {
                assert_true(json_object_object_get_ex(object, fields[f], &value));
            }
            json_object_object_get_ex(object, "tooltip", &value);
            assert_string_equal(json_object_get_string(value), param->tooltip);
            json_object_object_get_ex(object, "choices", &value);
            assert_int_equal(json_object_array_length(value), param->choice_count);
            if (param->type == DUCT_PARAM_REAL || param->type == DUCT_PARAM_INT) {
                assert_true(json_object_object_get_ex(object, "range", &value));
                assert_true(json_object_get_double(json_object_array_get_idx(value, 1)) == param->maximum);
                assert_true(json_object_object_get_ex(object, "step", &value));
            }
        }
    }
    json_object_put(root);
    duct_memory_free(NULL, text);
}

static void expect_refusal(const char *param, const char *value, const char *part)
{
    duct_error error = {DUCT_OK, ""};
    duct_settings *settings = new_settings();
    const char *old = duct_settings_text(settings, param);
    char before[64];
    snprintf(before, sizeof before, "%s", old != NULL ? old : "");
    assert_int_equal(duct_settings_set(settings, param, value, &error), DUCT_BAD_SETTING);
    assert_non_null(strstr(error.message, param));
    if (strstr(error.message, part) == NULL) {
        print_error("'%s' lacks '%s'\n", error.message, part);
    }
    assert_non_null(strstr(error.message, part));
    if (old != NULL) {
        assert_string_equal(duct_settings_text(settings, param), before);
    }
    duct_settings_free(settings);
}

static void bad_values_are_refused_in_a_sentence(void **state)
{
    (void)state;
    expect_refusal("amount", "2", "from 0 to 1");
    expect_refusal("amount", "-0.1", "from 0 to 1");
    expect_refusal("amount", "nan", "nan");
    expect_refusal("amount", "inf", "from 0 to 1");
    expect_refusal("amount", "0x1", "0x1");
    expect_refusal("amount", "", "number");
    expect_refusal("amount", "0.5 units", "number");
    expect_refusal("amount", "1e999", "from 0 to 1");
    expect_refusal("neighbours", "2.5", "whole number");
    expect_refusal("neighbours", "0", "from 1 to 100");
    expect_refusal("mode", "Pose", "one-pass, two-pass");
    expect_refusal("coherent", "maybe", "true or false");
    expect_refusal("seed", "-1", "whole number");
    expect_refusal("seed", "9223372036854775808", "whole number");
    expect_refusal("scale", "big", "auto or a number");
    expect_refusal("nonsense", "1", "no parameter");
    expect_refusal("preset", "nonsense", "default, paper");
}

static void values_have_one_canonical_form(void **state)
{
    (void)state;
    static const char *const cases[][3] = {
        {"amount", "0.50", "0.5"},
        {"amount", " 1e-1 ", "0.1"},
        {"coherent", "Yes", "true"},
        {"coherent", "0", "false"},
        {"scale", "auto", "auto"},
        {"scale", "2.0", "2"},
        {"seed", "007", "7"},
        {"neighbours", "5", "5"},
        {"seed", "9223372036854775807", "9223372036854775807"},
        {"hand", "a b.cyn", "a b.cyn"},
    };
    duct_error error;
    duct_settings *settings = new_settings();
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_ok(duct_settings_set(settings, cases[i][0], cases[i][1], &error));
        assert_string_equal(duct_settings_text(settings, cases[i][0]), cases[i][2]);
    }
    duct_settings_free(settings);
}

static void a_preset_resets_all_but_the_hand(void **state)
{
    (void)state;
    duct_error error;
    duct_settings *settings = new_settings();
    assert_ok(duct_settings_set(settings, "hand", "somebody", &error));
    assert_ok(duct_settings_set(settings, "jump-cost", "7", &error));
    assert_ok(duct_settings_set(settings, "preset", "paper", &error));
    assert_string_equal(duct_settings_text(settings, "hand"), "somebody");
    assert_string_equal(duct_settings_text(settings, "jump-cost"), "50");
    assert_string_equal(duct_settings_text(settings, "anchors"), "paper");
    assert_ok(duct_settings_set(settings, "preset", "default", &error));
    assert_string_equal(duct_settings_text(settings, "anchors"), "on");
    duct_settings_free(settings);
}

static void numbers_are_read_alike_in_every_locale(void **state)
{
    (void)state;
    const char *old = setlocale(LC_NUMERIC, "de_DE.UTF-8");
    duct_error error;
    duct_settings *settings = new_settings();
    assert_ok(duct_settings_set(settings, "amount", "0.25", &error));
    assert_string_equal(duct_settings_text(settings, "amount"), "0.25");
    duct_settings_free(settings);
    if (old != NULL) {
        setlocale(LC_NUMERIC, "C");
    }
}

static void an_unknown_operation_lists_those_there_are(void **state)
{
    (void)state;
    duct_error error;
    const duct_operation *operation = NULL;
    assert_int_equal(duct_operation_find("nonsense", &operation, &error), DUCT_NOT_FOUND);
    assert_non_null(strstr(error.message, "restyle"));
    assert_null(operation);
}

static void settings_survive_failing_allocations(void **state)
{
    (void)state;
    duct_error error;
    const duct_operation *operation = duct_operation_at(0);
    duct_status status = DUCT_NO_MEMORY;
    for (long n = 1; status != DUCT_OK; n++) {
        failing_allocator failing;
        failing_init(&failing, n);
        duct_context context = duct_context_default();
        context.allocator = &failing.allocator;
        duct_settings *settings = NULL;
        status = duct_settings_new(&context, operation, &settings, &error);
        if (status == DUCT_OK) {
            status = duct_settings_set(settings, "preset", "paper", &error);
        }
        duct_settings_free(settings);
        assert_true(status == DUCT_OK || status == DUCT_NO_MEMORY);
        assert_int_equal(failing.held, 0);
        assert_true(n < 1000);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tables_are_complete),
        cmocka_unit_test(json_says_what_the_tables_say),
        cmocka_unit_test(bad_values_are_refused_in_a_sentence),
        cmocka_unit_test(values_have_one_canonical_form),
        cmocka_unit_test(a_preset_resets_all_but_the_hand),
        cmocka_unit_test(numbers_are_read_alike_in_every_locale),
        cmocka_unit_test(an_unknown_operation_lists_those_there_are),
        cmocka_unit_test(settings_survive_failing_allocations),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
