/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "diagram/json_walk.h"

#include "base/error.h"

#include <string.h>

duct_status duct_walk_init(duct_json_walk *walk, const char *text, size_t size, duct_error *error)
{
    *walk = (duct_json_walk){text, text, text + size, json_tokener_new_ex(DUCT_WALK_DEPTH), error, DUCT_OK};
    return walk->tokener != NULL ? DUCT_OK : duct_fail_memory(error);
}

void duct_walk_done(duct_json_walk *walk)
{
    if (walk->tokener != NULL) {
        json_tokener_free(walk->tokener);
    }
    walk->tokener = NULL;
}

duct_status duct_walk_fail(duct_json_walk *walk, const char *sentence)
{
    if (walk->status == DUCT_OK) {
        size_t line = 1;
        for (const char *c = walk->text; c < walk->at; c++) {
            line += *c == '\n';
        }
        walk->status = duct_fail(walk->error, DUCT_BAD_FORMAT, "line %zu: %s", line, sentence);
    }
    return walk->status;
}

static bool failed(duct_json_walk *walk, const char *sentence)
{
    duct_walk_fail(walk, sentence);
    return false;
}

static void pass_space(duct_json_walk *walk)
{
    while (walk->at < walk->end && *walk->at != '\0' && strchr(" \t\r\n", *walk->at) != NULL) {
        walk->at++;
    }
}

/* The next character that is no space; 0 at the end. */
static char next_of(duct_json_walk *walk)
{
    pass_space(walk);
    return walk->at < walk->end ? *walk->at : '\0';
}

bool duct_walk_enter(duct_json_walk *walk, char bracket, const char *what)
{
    if (walk->status != DUCT_OK) {
        return false;
    }
    if (next_of(walk) != bracket) {
        char sentence[128];
        size_t used = strlen(what) < 64 ? strlen(what) : 64;
        memcpy(sentence, what, used);
        strcpy(sentence + used, bracket == '{' ? " has to be an object" : " has to be an array");
        return failed(walk, sentence);
    }
    walk->at++;
    return true;
}

static bool pass_string(duct_json_walk *walk)
{
    for (walk->at++; walk->at < walk->end; walk->at++) {
        if (*walk->at == '\\' && walk->at + 1 < walk->end) {
            walk->at++;
        } else if (*walk->at == '"') {
            walk->at++;
            return true;
        }
    }
    return failed(walk, "the file ends within a text");
}

/* The comma before an item, or the bracket behind the last one. */
static bool next_item(duct_json_walk *walk, bool *begun, char closing)
{
    if (walk->status != DUCT_OK) {
        return false;
    }
    char next = next_of(walk);
    if (next == closing) {
        walk->at++;
        return false;
    }
    if (next == '\0' && walk->at >= walk->end) {
        return failed(walk, "the file ends too early");
    }
    if (*begun) {
        if (next != ',') {
            return failed(walk, "a comma is expected");
        }
        walk->at++;
    }
    *begun = true;
    return true;
}

bool duct_walk_element(duct_json_walk *walk, bool *begun)
{
    return next_item(walk, begun, ']');
}

bool duct_walk_member(duct_json_walk *walk, bool *begun, char key[DUCT_WALK_KEY])
{
    if (!next_item(walk, begun, '}')) {
        return false;
    }
    if (next_of(walk) != '"') {
        return failed(walk, "a member's name is expected");
    }
    const char *first = walk->at + 1;
    if (!pass_string(walk)) {
        return false;
    }
    size_t length = (size_t)(walk->at - 1 - first);
    length = length < DUCT_WALK_KEY - 1 ? length : DUCT_WALK_KEY - 1;
    memcpy(key, first, length);
    key[length] = '\0';
    if (next_of(walk) != ':') {
        return failed(walk, "a colon is expected behind a member's name");
    }
    walk->at++;
    return true;
}

static bool pass_scalar(duct_json_walk *walk)
{
    const char *first = walk->at;
    while (walk->at < walk->end && *walk->at != '\0' && strchr(",:]}[{\" \t\r\n", *walk->at) == NULL) {
        walk->at++;
    }
    return walk->at > first ? true : failed(walk, "a value is expected");
}

bool duct_walk_skip(duct_json_walk *walk)
{
    char closing[DUCT_WALK_DEPTH];
    int depth = 0;
    if (walk->status != DUCT_OK) {
        return false;
    }
    do {
        char next = next_of(walk);
        if (next == '{' || next == '[') {
            if (depth == DUCT_WALK_DEPTH) {
                return failed(walk, "there are too many brackets within one another");
            }
            closing[depth++] = next == '{' ? '}' : ']';
            walk->at++;
        } else if (next == '}' || next == ']') {
            if (depth == 0 || closing[--depth] != next) {
                return failed(walk, "a bracket is closed that was not opened");
            }
            walk->at++;
        } else if (next == '"') {
            if (!pass_string(walk)) {
                return false;
            }
        } else if (depth > 0 && (next == ',' || next == ':')) {
            walk->at++;
        } else if (walk->at >= walk->end) {
            return failed(walk, "the file ends too early");
        } else if (!pass_scalar(walk)) {
            return false;
        }
    } while (depth > 0);
    return true;
}

bool duct_walk_value(duct_json_walk *walk, json_object **value)
{
    *value = NULL;
    pass_space(walk);
    const char *first = walk->at;
    if (!duct_walk_skip(walk)) {
        return false;
    }
    size_t size = (size_t)(walk->at - first);
    if (size > DUCT_WALK_VALUE) {
        return failed(walk, "a value is longer than is allowed");
    }
    json_tokener_reset(walk->tokener);
    *value = json_tokener_parse_ex(walk->tokener, first, (int)size);
    enum json_tokener_error reason = json_tokener_get_error(walk->tokener);
    if (reason == json_tokener_continue) {
        /* A number at the end of the text might go on; a space ends it. */
        *value = json_tokener_parse_ex(walk->tokener, " ", 1);
        reason = json_tokener_get_error(walk->tokener);
    }
    if (reason != json_tokener_success) {
        json_object_put(*value);
        *value = NULL;
        return failed(walk, json_tokener_error_desc(reason));
    }
    return true;
}

bool duct_walk_end(duct_json_walk *walk)
{
    if (walk->status == DUCT_OK && (next_of(walk) != '\0' || walk->at < walk->end)) {
        return failed(walk, "something follows behind the end");
    }
    return walk->status == DUCT_OK;
}
