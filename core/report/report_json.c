/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "report/report_private.h"

#include "base/error.h"
#include "base/json.h"

static void add_correlation(duct_json *json, const duct_correlation *correlation)
{
    duct_json_number(json, "similar", correlation->similar);
    duct_json_number(json, "random", correlation->random);
    duct_json_integer(json, "pairs", (long long)correlation->pairs);
}

static void add_entry(duct_json *json, const duct_report_entry *entry)
{
    add_correlation(json, &entry->together);
    duct_json_integer(json, "patches", (long long)entry->patches);
    duct_json_object(json, "channels");
    for (int c = 0; c < DUCT_CHANNEL_COUNT; c++) {
        if (entry->present[c]) {
            duct_json_row(json, duct_channel_name((duct_channel)c), '{');
            add_correlation(json, &entry->channels[c]);
            duct_json_close(json, '}');
        }
    }
    duct_json_close(json, '}');
    duct_json_string(json, "verdict", duct_verdict_name(entry->verdict));
    duct_json_string(json, "sentence", entry->sentence);
}

static void add_libraries(duct_json *json, const duct_report *report)
{
    duct_json_array(json, "libraries");
    for (size_t i = 0; i < report->count; i++) {
        const duct_report_library *library = &report->libraries[i];
        duct_json_object(json, NULL);
        duct_json_string(json, "name", library->name);
        duct_json_integer(json, "strokes", (long long)library->strokes);
        duct_json_integer(json, "samples", (long long)library->samples);
        duct_json_number(json, "unit", library->unit);
        add_entry(json, duct_report_between(report, i, i));
        duct_json_close(json, '}');
    }
    duct_json_close(json, ']');
}

static void add_between(duct_json *json, const duct_report *report)
{
    duct_json_array(json, "between");
    for (size_t a = 0; a < report->count; a++) {
        for (size_t b = a + 1; b < report->count; b++) {
            duct_json_object(json, NULL);
            duct_json_string(json, "first", report->libraries[a].name);
            duct_json_string(json, "second", report->libraries[b].name);
            add_entry(json, duct_report_between(report, a, b));
            duct_json_close(json, '}');
        }
    }
    duct_json_close(json, ']');
}

duct_status duct_report_json(const duct_context *context, const duct_report *report, char **text,
                             duct_error *error)
{
    duct_text out;
    duct_json json;
    duct_text_init(&out, duct_allocator_of(context));
    duct_json_init(&json, &out);
    duct_json_object(&json, NULL);
    add_libraries(&json, report);
    add_between(&json, report);
    duct_json_close(&json, '}');
    duct_text_add(&out, "\n");
    char *made = duct_text_take(&out, NULL);
    if (made == NULL) {
        return duct_fail_memory(error);
    }
    *text = made;
    return DUCT_OK;
}
