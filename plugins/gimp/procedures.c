/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "procedures.h"

#include "arguments.h"
#include "options.h"

#include <string.h>

#define PREFIX "plug-in-ductus-"

static const plug_variant variants[] = {
    {"",
     "Stroke path: %s...",
     {"<Image>/Edit", NULL},
     "The lines are a path, all visible paths, the outline of the selection, or line art on a layer.",
     NULL,
     false,
     false},
    {"-path",
     "%s...",
     {"<Vectors>", NULL},
     "The lines are those of the path given.",
     LINES_PATH,
     true,
     false},
    {"-line-art",
     "Line art: %s...",
     {"<Image>/Filters/Artistic", "<Layers>"},
     "The lines are the centre lines of what is drawn on the layer given.",
     LINES_ART,
     false,
     false},
    {"-text",
     NULL,
     {NULL, NULL},
     "The settings are one text, so that a script names only those that it changes.",
     NULL,
     false,
     true},
};

static const GimpParamDef results[] = {
    {GIMP_PDB_LAYER, (gchar *)"layer", (gchar *)"The new layer, or -1 where none was made"},
    {GIMP_PDB_INT32, (gchar *)"num-paths", (gchar *)"The number of new paths"},
    {GIMP_PDB_INT32ARRAY, (gchar *)"paths", (gchar *)"The new paths"},
};

void plug_procedure_name(const duct_operation *operation, const plug_variant *variant, char *name,
                         size_t size)
{
    g_snprintf(name, size, PREFIX "%s%s", operation->id, variant->suffix);
}

static void install(const duct_operation *operation, const plug_variant *variant)
{
    char name[PLUG_NAME_SIZE];
    plug_procedure_name(operation, variant, name, sizeof name);
    char *help = g_strdup_printf("%s %s", operation->summary, variant->blurb);
    char *label = variant->label != NULL ? g_strdup_printf(variant->label, operation->label) : NULL;
    int count = 0;
    GimpParamDef *arguments = plug_arguments_make(operation, variant, &count);
    /* All kinds of images: a palette is no hindrance to paths, and painting says what it needs. */
    gimp_install_procedure(name, operation->summary, help, "Ductus", "GPL-3.0-or-later", "2026", label, "*",
                           GIMP_PLUGIN, count, G_N_ELEMENTS(results), arguments, results);
    for (size_t i = 0; i < G_N_ELEMENTS(variant->menus) && variant->menus[i] != NULL; i++) {
        gimp_plugin_menu_register(name, variant->menus[i]);
    }
    plug_arguments_free(arguments, count);
    g_free(label);
    g_free(help);
}

void plug_procedures_install(void)
{
    const duct_operation *operation;
    for (size_t i = 0; (operation = duct_operation_at(i)) != NULL; i++) {
        for (size_t v = 0; v < G_N_ELEMENTS(variants); v++) {
            install(operation, &variants[v]);
        }
    }
}

bool plug_procedure_find(const char *name, const duct_operation **operation, const plug_variant **variant)
{
    for (size_t i = 0; (*operation = duct_operation_at(i)) != NULL; i++) {
        for (size_t v = 0; v < G_N_ELEMENTS(variants); v++) {
            char known[PLUG_NAME_SIZE];
            *variant = &variants[v];
            plug_procedure_name(*operation, *variant, known, sizeof known);
            if (strcmp(name, known) == 0) {
                return true;
            }
        }
    }
    return false;
}
