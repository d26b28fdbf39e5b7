/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The names that parameters' values can be chosen from. */
#include "operations/operation_private.h"

#include "base/error.h"
#include "base/memory.h"
#include "library/hands.h"
#include "style/style.h"

duct_status duct_param_names(const duct_context *context, const duct_param *param, char ***names,
                             size_t *count, duct_error *error)
{
    const duct_allocator *allocator = duct_allocator_of(context);
    duct_hand *found = NULL;
    size_t found_count = 0;
    duct_status status = DUCT_OK;
    if (param->type == DUCT_PARAM_HAND) {
        status = duct_library_list(context, &found, &found_count, error);
    } else if (param->type == DUCT_PARAM_STYLE) {
        status = duct_style_list(context, &found, &found_count, error);
    }
    if (status != DUCT_OK) {
        return status;
    }
    char **made = duct_alloc(allocator, found_count, sizeof *made);
    if (made == NULL) {
        duct_hands_free(context, found, found_count);
        return duct_fail_memory(error);
    }
    for (size_t i = 0; i < found_count; i++) {
        made[i] = found[i].name;
        found[i].name = NULL;
    }
    duct_hands_free(context, found, found_count);
    *names = made;
    *count = found_count;
    return DUCT_OK;
}
