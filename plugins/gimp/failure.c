/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "failure.h"

#include <libgimp/gimp.h>

#include <stdarg.h>

duct_status plug_fail(duct_error *error, duct_status status, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    error->status = status;
    g_vsnprintf(error->message, sizeof error->message, format, arguments);
    va_end(arguments);
    return status;
}

duct_status plug_fail_gimp(duct_error *error, const char *what)
{
    const char *said = gimp_get_pdb_error();
    if (said == NULL || *said == '\0') {
        return plug_fail(error, DUCT_UNSUPPORTED, "GIMP could not %s", what);
    }
    return plug_fail(error, DUCT_UNSUPPORTED, "GIMP could not %s: %s", what, said);
}
