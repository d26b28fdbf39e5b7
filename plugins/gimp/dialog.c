#include "dialog.h"
#include "run.h"
duct_status plug_dialog_run(job *job, result *result, duct_error *error)
{
    return plug_run(job, result, error);
}
