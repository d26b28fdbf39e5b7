#include "dialog.h"
#include "run.h"
duct_status plug_dialog_run(struct job *job, struct result *result, duct_error *error)
{
    return plug_run(job, result, error);
}
