/* SPDX-License-Identifier: GPL-3.0-or-later */
#include <ductus/version.h>

const char *duct_version(void)
{
    return DUCT_VERSION;
}
