/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef DUCTUS_OPERATIONS_REGISTRY_H
#define DUCTUS_OPERATIONS_REGISTRY_H

#include "operations/operation_private.h"

/* The operation behind a public table entry; NULL where the entry is not one of the registry's. */
const duct_operation_impl *duct_operation_impl_of(const duct_operation *operation);

/* The type's name as the JSON tables have it. Static storage. */
const char *duct_param_type_name(duct_param_type type);

#endif
