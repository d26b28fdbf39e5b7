/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_JSON_H
#define DUCTUS_BASE_JSON_H

#include "base/text.h"

/* Writing JSON into a text, comma by comma: a call for each value; within an object, `key` names the value
 * and elsewhere is NULL. What is opened has to be closed. Reading JSON is json-c's business. */
typedef struct duct_json {
    duct_text *text;
    int depth;
    bool comma[32];  /* whether the next value at this depth needs a comma before it */
    bool inside[32]; /* whether this depth is an array or object that stays on one line */
} duct_json;

void duct_json_init(duct_json *json, duct_text *text);
void duct_json_object(duct_json *json, const char *key);
void duct_json_array(duct_json *json, const char *key);
/* An array or object written on one line. */
void duct_json_row(duct_json *json, const char *key, char bracket);
void duct_json_close(duct_json *json, char bracket);
void duct_json_string(duct_json *json, const char *key, const char *value);
void duct_json_number(duct_json *json, const char *key, double value);
/* Not finite numbers become null. */
void duct_json_integer(duct_json *json, const char *key, long long value);
void duct_json_bool(duct_json *json, const char *key, bool value);

#endif
