/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "operations/stroke_list.h"

#include "base/error.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool is_colour(const duct_stroke *stroke, const char *word)
{
    char colour[16];
    duct_stroke_style style = duct_stroke_get_style(stroke);
    snprintf(colour, sizeof colour, "#%02x%02x%02x", (unsigned)lround(style.red * 255.0) & 255U,
             (unsigned)lround(style.green * 255.0) & 255U, (unsigned)lround(style.blue * 255.0) & 255U);
    char lower[16] = "";
    for (size_t i = 0; i < sizeof lower - 1 && word[i] != '\0'; i++) {
        lower[i] = word[i] >= 'A' && word[i] <= 'F' ? (char)(word[i] - 'A' + 'a') : word[i];
    }
    return strcmp(colour, lower) == 0;
}

static bool is_group(const duct_stroke *stroke, const char *word)
{
    const char *group = duct_stroke_group(stroke);
    if (strcmp(group, word) == 0) {
        return true;
    }
    size_t size = strlen(word);
    for (const char *part = group; (part = strstr(part, word)) != NULL; part++) {
        if ((part == group || part[-1] == '/') && (part[size] == '/' || part[size] == '\0')) {
            return true;
        }
    }
    return false;
}

/* "star", and "star/2", "star/3" ..., the other subpaths of one path. */
static bool is_id(const duct_stroke *stroke, const char *word)
{
    const char *id = duct_stroke_id(stroke);
    size_t size = strlen(word);
    return strncmp(id, word, size) == 0 &&
           (id[size] == '\0' ||
            (id[size] == '/' && strspn(id + size + 1, "0123456789") == strlen(id + size + 1)));
}

static bool fits(const duct_drawing *drawing, size_t i, const char *word, int rule)
{
    const duct_stroke *stroke = duct_drawing_stroke(drawing, i);
    switch (rule) {
    case 0:
        return is_id(stroke, word);
    case 1:
        return word[0] == '@' && strspn(word + 1, "0123456789") == strlen(word + 1) &&
               strtoull(word + 1, NULL, 10) == i + 1;
    case 2:
        return word[0] == '#' && is_colour(stroke, word);
    default:
        return is_group(stroke, word);
    }
}

static void add(duct_stroke_list *list, bool *taken, size_t i)
{
    if (!taken[i]) {
        taken[i] = true;
        list->items[list->count++] = i;
    }
}

static duct_status add_word(const duct_drawing *drawing, const char *word, const char *param,
                            duct_stroke_list *list, bool *taken, duct_error *error)
{
    bool found = strcmp(word, "*") == 0;
    for (size_t i = 0; found && i < duct_drawing_stroke_count(drawing); i++) {
        add(list, taken, i);
    }
    for (int rule = 0; rule < 4 && !found; rule++) {
        for (size_t i = 0; i < duct_drawing_stroke_count(drawing); i++) {
            if (fits(drawing, i, word, rule)) {
                found = true;
                add(list, taken, i);
            }
        }
    }
    return found
               ? DUCT_OK
               : duct_fail(error, DUCT_BAD_SETTING,
                           "%s: the drawing has no stroke, group or colour '%.80s' (@1 is the first stroke)",
                           param, word);
}

duct_status duct_stroke_list_read(const duct_allocator *allocator, const duct_drawing *drawing,
                                  const char *text, size_t size, const char *param, duct_stroke_list *list,
                                  duct_error *error)
{
    size_t count = duct_drawing_stroke_count(drawing);
    duct_stroke_list made = {duct_alloc(allocator, count, sizeof *made.items), 0};
    bool *taken = duct_alloc(allocator, count, sizeof *taken);
    char *words = duct_alloc(allocator, size + 1, 1);
    duct_status status = DUCT_OK;
    if (made.items == NULL || taken == NULL || words == NULL) {
        status = duct_fail_memory(error);
    } else {
        memcpy(words, text, size);
        for (char *word = words; word != NULL && status == DUCT_OK;) {
            char *comma = strchr(word, ','), *next = comma != NULL ? comma + 1 : NULL;
            char *end = comma != NULL ? comma : word + strlen(word);
            word += strspn(word, " \t\n");
            while (end > word && strchr(" \t\n", end[-1]) != NULL) {
                end--;
            }
            *end = '\0';
            status = end > word ? add_word(drawing, word, param, &made, taken, error) : DUCT_OK;
            word = next;
        }
    }
    duct_release(allocator, taken);
    duct_release(allocator, words);
    if (status != DUCT_OK) {
        duct_stroke_list_done(allocator, &made);
        return status;
    }
    *list = made;
    return DUCT_OK;
}

void duct_stroke_list_done(const duct_allocator *allocator, duct_stroke_list *list)
{
    duct_release(allocator, list->items);
    *list = (duct_stroke_list){NULL, 0};
}
