/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_DIAGRAM_JSON_WALK_H
#define DUCTUS_DIAGRAM_JSON_WALK_H

#include <ductus/status.h>

#include <json-c/json.h>
#include <stdbool.h>
#include <stddef.h>

/* Walks through a JSON text and parses only the values that are asked for, each by json-c. A trace of some
 * hundred megabytes, most of which is candidates that nobody looks at, then needs no memory beyond its text.
 * What is passed over is only checked for its brackets and strings. */
typedef struct duct_json_walk {
    const char *text, *at, *end;
    json_tokener *tokener;
    duct_error *error;
    duct_status status; /* not DUCT_OK: the walk has failed and `error` says why */
} duct_json_walk;

enum { DUCT_WALK_KEY = 64, DUCT_WALK_VALUE = 1 << 24, DUCT_WALK_DEPTH = 64 };

/* Errors: DUCT_NO_MEMORY. */
duct_status duct_walk_init(duct_json_walk *walk, const char *text, size_t size, duct_error *error);
void duct_walk_done(duct_json_walk *walk);

/* Fails with DUCT_BAD_FORMAT: "line N: SENTENCE". Keeps an earlier failure. Returns the status. */
duct_status duct_walk_fail(duct_json_walk *walk, const char *sentence);

/* Enters an object ('{') or array ('['); `what` names it in sentences. False on failure. */
bool duct_walk_enter(duct_json_walk *walk, char bracket, const char *what);

/* Goes to the next member of an object, or element of an array: false at its end (which is then behind) or on
 * failure. `*begun` is false before the first one. Of a longer key only the beginning is kept. */
bool duct_walk_member(duct_json_walk *walk, bool *begun, char key[DUCT_WALK_KEY]);
bool duct_walk_element(duct_json_walk *walk, bool *begun);

/* Passes over a value. */
bool duct_walk_skip(duct_json_walk *walk);

/* Parses the value here, of at most DUCT_WALK_VALUE bytes; the caller puts it. False on failure; null gives
 * NULL. */
bool duct_walk_value(duct_json_walk *walk, json_object **value);

/* Nothing but space may follow. */
bool duct_walk_end(duct_json_walk *walk);

#endif
