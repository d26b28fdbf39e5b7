/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finding and reading styles. */
#include "style/style.h"

#include "base/error.h"
#include "base/file.h"
#include "base/text.h"
#include "library/hands.h"

#include <ductus/format.h>

#include <string.h>

duct_status duct_style_list(const duct_context *context, duct_hand **styles, size_t *count, duct_error *error)
{
    return duct_named_list(context, "styles", "inkml svg", styles, count, error);
}

static duct_status fail_name(const duct_context *context, const char *name, const duct_hand *styles,
                             size_t count, duct_error *error)
{
    duct_text names;
    duct_text_init(&names, duct_allocator_of(context));
    for (size_t i = 0; i < count; i++) {
        duct_text_addf(&names, "%s%s", i > 0 ? ", " : "", styles[i].name);
    }
    duct_status status = names.failed ? duct_fail_memory(error)
                                      : duct_fail(error, DUCT_NOT_FOUND,
                                                  "there is no style '%.80s', nor a file of that name; "
                                                  "there are: %s",
                                                  name, count > 0 ? names.data : "none");
    duct_text_free(&names);
    return status;
}

duct_status duct_style_read(const duct_context *context, const char *name, duct_drawing **drawing,
                            duct_error *error)
{
    if (duct_file_exists(name) && !duct_file_is_folder(name)) {
        return duct_drawing_read(context, name, NULL, drawing, error);
    }
    duct_hand *styles;
    size_t count;
    duct_status status = duct_style_list(context, &styles, &count, error);
    if (status != DUCT_OK) {
        return status;
    }
    const char *path = NULL;
    for (size_t i = 0; i < count; i++) {
        path = strcmp(styles[i].name, name) == 0 ? styles[i].path : path;
    }
    status = path != NULL ? duct_drawing_read(context, path, NULL, drawing, error)
                          : fail_name(context, name, styles, count, error);
    duct_hands_free(context, styles, count);
    return status;
}
