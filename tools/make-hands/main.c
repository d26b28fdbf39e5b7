/* SPDX-License-Identifier: GPL-3.0-or-later */

/* make-hands FOLDER NAME...: writes the built-in hands of those names as FOLDER/NAME.inkml, each with its
 * search index beside it. make-hands --page NAME FILE writes the page as it was recorded, in the format of
 * the file's ending; make-hands --write NAME TEXT FILE writes a line of text; make-hands --list prints the
 * names. */

#include "page.h"

#include <ductus/format.h>
#include <ductus/library.h>

#include <stdio.h>
#include <string.h>

/* The hand's page, or a line of text where `text` is not NULL. */
static duct_status make_page(const duct_context *context, const char *name, const char *text,
                             duct_drawing **page, duct_error *error)
{
    const hand_style *style = hand_style_find(name);
    if (style == NULL) {
        snprintf(error->message, sizeof error->message, "there is no hand \"%s\"; --list prints the names",
                 name);
        return DUCT_NOT_FOUND;
    }
    return text != NULL ? page_write_line(context, style, text, page, error)
                        : page_make(context, style, page, error);
}

/* A library's file says by whom it is; this one also says, for programs, that nobody wrote it. Its strokes
 * stay as they are, so its index goes on fitting. */
static duct_status label_synthetic(const duct_context *context, const char *path, duct_error *error)
{
    duct_drawing *strokes = NULL;
    duct_status status = duct_drawing_read(context, path, NULL, &strokes, error);
    if (status == DUCT_OK) {
        status = duct_drawing_annotate(strokes, "synthetic", "true", error);
    }
    if (status == DUCT_OK) {
        status = duct_drawing_write(context, strokes, path, NULL, error);
    }
    duct_drawing_free(strokes);
    return status;
}

static duct_status make_library(const duct_context *context, const char *folder, const char *name,
                                duct_error *error)
{
    char path[4096];
    if ((size_t)snprintf(path, sizeof path, "%s/%s.inkml", folder, name) >= sizeof path) {
        snprintf(error->message, sizeof error->message, "the path of hand \"%s\" is too long", name);
        return DUCT_BAD_ARGUMENT;
    }
    duct_drawing *page = NULL;
    duct_library *library = NULL;
    duct_status status = make_page(context, name, NULL, &page, error);
    if (status == DUCT_OK) {
        const duct_drawing *pages[] = {page};
        status = duct_library_build(context, pages, 1, NULL, &library, error);
    }
    if (status == DUCT_OK) {
        status = duct_library_save(context, library, path, error);
    }
    if (status == DUCT_OK) {
        status = label_synthetic(context, path, error);
    }
    duct_library_free(library);
    duct_drawing_free(page);
    return status;
}

static duct_status write_page(const duct_context *context, const char *name, const char *text,
                              const char *path, duct_error *error)
{
    duct_drawing *page = NULL;
    duct_status status = make_page(context, name, text, &page, error);
    if (status == DUCT_OK) {
        status = duct_drawing_write(context, page, path, NULL, error);
    }
    duct_drawing_free(page);
    return status;
}

int main(int count, char **words)
{
    const duct_context context = duct_context_default();
    duct_error error = {DUCT_OK, ""};
    duct_status status = DUCT_OK;
    if (count == 2 && strcmp(words[1], "--list") == 0) {
        for (size_t i = 0; i < hand_style_count; i++) {
            puts(hand_styles[i]->name);
        }
    } else if (count == 4 && strcmp(words[1], "--page") == 0) {
        status = write_page(&context, words[2], NULL, words[3], &error);
    } else if (count == 5 && strcmp(words[1], "--write") == 0) {
        status = write_page(&context, words[2], words[3], words[4], &error);
    } else if (count >= 3 && words[1][0] != '-') {
        for (int i = 2; i < count && status == DUCT_OK; i++) {
            status = make_library(&context, words[1], words[i], &error);
        }
    } else {
        fputs("usage: make-hands FOLDER NAME... | --page NAME FILE | --write NAME TEXT FILE | --list\n",
              stderr);
        return 2;
    }
    if (status != DUCT_OK) {
        fprintf(stderr, "make-hands: %s\n",
                error.message[0] != '\0' ? error.message : duct_status_text(status));
        return 1;
    }
    return 0;
}
