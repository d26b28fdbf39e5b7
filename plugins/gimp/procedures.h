/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef PLUG_PROCEDURES_H
#define PLUG_PROCEDURES_H

#include <ductus/operation.h>

#include <libgimp/gimp.h>

/* Each operation is registered several times: for each place in GIMP that it can be called from. */
typedef struct plug_variant {
    const char *suffix;   /* behind the operation's id in the procedure's name */
    const char *label;    /* in menus; %s: the operation's label */
    const char *menus[2]; /* NULL: none */
    const char *blurb;    /* behind the operation's summary */
    const char *lines;    /* the option `lines` where the place decides it; NULL: the user does */
    bool on_vectors;      /* the third argument is a path and not a drawable */
    bool as_text;         /* the settings come as one text, and not one by one */
} plug_variant;

/* Registers all operations in all variants. */
void plug_procedures_install(void);

/* What a procedure's name stands for; false where it is none of ours. */
bool plug_procedure_find(const char *name, const duct_operation **operation, const plug_variant **variant);

/* The procedure's name. */
void plug_procedure_name(const duct_operation *operation, const plug_variant *variant, char *name,
                         size_t size);

enum { PLUG_NAME_SIZE = 128 };

#endif
