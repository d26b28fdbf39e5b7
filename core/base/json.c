/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/json.h"

#include <math.h>
#include <string.h>

void duct_json_init(duct_json *json, duct_text *text)
{
    memset(json, 0, sizeof *json);
    json->text = text;
}

static void begin_value(duct_json *json, const char *key)
{
    int depth = json->depth;
    if (json->comma[depth]) {
        duct_text_add(json->text, json->inside[depth] ? ", " : ",");
    }
    if (depth > 0 && !json->inside[depth]) {
        duct_text_addf(json->text, "\n%*s", 2 * depth, "");
    }
    json->comma[depth] = true;
    if (key != NULL) {
        duct_text_add_json(json->text, key);
        duct_text_add(json->text, ": ");
    }
}

static void open(duct_json *json, const char *key, char bracket, bool inside)
{
    begin_value(json, key);
    duct_text_add_bytes(json->text, &bracket, 1);
    json->depth++;
    json->comma[json->depth] = false;
    json->inside[json->depth] = inside || json->inside[json->depth - 1];
}

void duct_json_object(duct_json *json, const char *key)
{
    open(json, key, '{', false);
}

void duct_json_array(duct_json *json, const char *key)
{
    open(json, key, '[', false);
}

void duct_json_row(duct_json *json, const char *key, char bracket)
{
    open(json, key, bracket, true);
}

void duct_json_close(duct_json *json, char bracket)
{
    bool empty = !json->comma[json->depth];
    bool inside = json->inside[json->depth];
    json->depth--;
    if (!inside && !empty) {
        duct_text_addf(json->text, "\n%*s", 2 * json->depth, "");
    }
    duct_text_add_bytes(json->text, &bracket, 1);
}

void duct_json_string(duct_json *json, const char *key, const char *value)
{
    begin_value(json, key);
    duct_text_add_json(json->text, value);
}

void duct_json_number(duct_json *json, const char *key, double value)
{
    begin_value(json, key);
    if (isfinite(value)) {
        duct_text_add_number(json->text, value, 0);
    } else {
        duct_text_add(json->text, "null");
    }
}

void duct_json_integer(duct_json *json, const char *key, long long value)
{
    begin_value(json, key);
    duct_text_addf(json->text, "%lld", value);
}

void duct_json_bool(duct_json *json, const char *key, bool value)
{
    begin_value(json, key);
    duct_text_add(json->text, value ? "true" : "false");
}
