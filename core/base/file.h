/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_BASE_FILE_H
#define DUCTUS_BASE_FILE_H

#include "base/memory.h"

#include <ductus/status.h>

/* Reads a whole regular file (or pipe) of at most `limit` bytes. `*data` is terminated by a 0 byte that
 * `*size` does not count; the caller releases it. Errors name the file. */
duct_status duct_file_read(const duct_allocator *allocator, const char *path, size_t limit, char **data,
                           size_t *size, duct_error *error);

/* Writes a file whole or not at all: beside its place, then renamed. Keeps the mode of a file that is
 * replaced. A path that is no regular file (such as /dev/null or a pipe) is written to directly. */
duct_status duct_file_write(const duct_allocator *allocator, const char *path, const void *data, size_t size,
                            duct_error *error);

/* The name of a temporary file beside `path`, with the same ending, made so that nobody else has it. The
 * caller releases it. */
duct_status duct_file_beside(const duct_allocator *allocator, const char *path, char **beside,
                             duct_error *error);

/* Puts a file made under the name of duct_file_beside() in its place; removes it on failure. */
duct_status duct_file_commit(const char *beside, const char *path, duct_error *error);

/* True where a file or folder of that name is there. */
bool duct_file_exists(const char *path);
bool duct_file_is_folder(const char *path);

/* The path's last part, without its folders: a pointer into `path`. */
const char *duct_path_name(const char *path);

/* The ending of the name without its dot, or "". "a.tar.gz" gives "gz"; ".name" gives "". */
const char *duct_path_ending(const char *path);

/* True where the ending is `ending`, in upper or lower case. */
bool duct_path_ends(const char *path, const char *ending);

/* folder + "/" + name; the caller releases it; NULL when there is no memory. */
char *duct_path_join(const duct_allocator *allocator, const char *folder, const char *name);

/* The folder that holds hands/ and brushes/: the context's; or $DUCTUS_DATA_FOLDER; or share/ductus found
 * from the place of libductus itself; or the one of the installation. The caller releases it; NULL when there
 * is no memory. */
char *duct_data_folder(const duct_context *context);

/* The folder in which libductus (or the program it is linked into) lies; the caller releases it; NULL when it
 * is not known or there is no memory. */
char *duct_module_folder(const duct_allocator *allocator);

#endif
