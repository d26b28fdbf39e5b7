/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "help.h"

#include <libgimp/gimp.h>

/* The page lies beside the program. */
static char *find_page(void)
{
    char *program = g_file_read_link("/proc/self/exe", NULL);
    char *folder = program != NULL ? g_path_get_dirname(program) : g_strdup(".");
    char *page = g_build_filename(folder, "gimp.html", NULL);
    g_free(folder);
    g_free(program);
    return page;
}

void plug_help(const gchar *id, gpointer data)
{
    (void)id;
    (void)data;
    char *page = find_page();
    char *address = g_filename_to_uri(page, NULL, NULL);
    if (address == NULL || !g_file_test(page, G_FILE_TEST_EXISTS)) {
        gimp_message(
            "Ductus: the page about this plug-in is not installed; it is docs/gimp.md in the sources.");
    } else {
        int count = 0;
        GimpParam *values =
            gimp_run_procedure("plug-in-web-browser", &count, GIMP_PDB_STRING, address, GIMP_PDB_END);
        if (count == 0 || values[0].data.d_status != GIMP_PDB_SUCCESS) {
            char *text = g_strdup_printf("Ductus: no browser could be started; the page is %s.", page);
            gimp_message(text);
            g_free(text);
        }
        gimp_destroy_params(values, count);
    }
    g_free(address);
    g_free(page);
}
