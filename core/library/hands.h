/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_LIBRARY_HANDS_H
#define DUCTUS_LIBRARY_HANDS_H

#include <ductus/library.h>

/* Lists the files of a kind ("hands", "styles") as duct_library_list() does, which is this for hands: from
 * the folder of that name in the data folder and in the user's. `endings` are separated by spaces. Free with
 * duct_hands_free(). Errors: DUCT_NO_MEMORY. */
duct_status duct_named_list(const duct_context *context, const char *kind, const char *endings,
                            duct_hand **items, size_t *count, duct_error *error);

#endif
