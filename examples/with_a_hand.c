/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A program that uses the installed libductus: with_a_hand OPERATION HAND OUT [IN]
 *
 * It reads a drawing (or makes a spiral), finds an operation, prints its table of parameters, gives it a
 * hand, runs it and writes what came out. Nothing in it knows an operation by name: that is how plug-ins are
 * written as well. */
#include <ductus/ductus.h>

#include <math.h>
#include <stdio.h>

/* A spiral of three turns on a page of 300 x 300 pixels. */
static duct_status make_spiral(const duct_context *context, duct_drawing **drawing, duct_error *error)
{
    enum { SAMPLES = 600 };
    duct_drawing *made = NULL;
    duct_stroke *stroke = NULL;
    duct_status status = duct_drawing_new(context, &made, error);
    if (status == DUCT_OK) {
        duct_drawing_set_page(made, 300, 300);
        status = duct_drawing_add_stroke(made, "spiral", SAMPLES, &stroke, error);
    }
    if (status != DUCT_OK) {
        duct_drawing_free(made);
        return status;
    }
    /* X and Y are always there, so that this cannot fail; adding a channel such as DUCT_PRESSURE can. */
    double *x = duct_stroke_edit(stroke, DUCT_X), *y = duct_stroke_edit(stroke, DUCT_Y);
    for (int i = 0; i < SAMPLES; i++) {
        double turn = 3.0 * i / (SAMPLES - 1);
        x[i] = 150 + 40 * turn * cos(6.2831853 * turn);
        y[i] = 150 + 40 * turn * sin(6.2831853 * turn);
    }
    duct_stroke_style style = duct_stroke_get_style(stroke);
    style.width = 3;
    duct_stroke_set_style(stroke, style);
    *drawing = made;
    return DUCT_OK;
}

static void print_table(const duct_operation *operation)
{
    printf("%s: %s\n", operation->label, operation->summary);
    for (size_t i = 0; i < operation->param_count; i++) {
        const duct_param *param = &operation->params[i];
        printf("  %-16s %s%s%s\n", param->id, param->fallback, *param->unit != '\0' ? " " : "", param->unit);
    }
}

static duct_status choose_settings(const duct_context *context, const duct_operation *operation,
                                   const char *hand, duct_settings **settings, duct_error *error)
{
    duct_status status = duct_settings_new(context, operation, settings, error);
    for (size_t i = 0; i < operation->param_count && status == DUCT_OK; i++) {
        if (operation->params[i].type == DUCT_PARAM_HAND) {
            status = duct_settings_set(*settings, operation->params[i].id, hand, error);
        }
    }
    return status;
}

int main(int count, char **words)
{
    if (count != 4 && count != 5) {
        fprintf(stderr, "usage: with_a_hand OPERATION HAND OUT [IN]\n");
        return 2;
    }
    duct_context context = duct_context_default();
    duct_error error = {DUCT_OK, ""};
    const duct_operation *operation = NULL;
    duct_settings *settings = NULL;
    duct_drawing *input = NULL, *output = NULL;

    duct_status status = count == 5 ? duct_drawing_read(&context, words[4], NULL, &input, &error)
                                    : make_spiral(&context, &input, &error);
    if (status == DUCT_OK) {
        status = duct_operation_find(words[1], &operation, &error);
    }
    if (status == DUCT_OK) {
        print_table(operation);
        status = choose_settings(&context, operation, words[2], &settings, &error);
    }
    if (status == DUCT_OK) {
        status = duct_operation_run(&context, settings, input, NULL, &output, &error);
    }
    if (status == DUCT_OK) {
        status = duct_drawing_write(&context, output, words[3], NULL, &error);
    }
    if (status != DUCT_OK) {
        fprintf(stderr, "with_a_hand: %s\n", error.message);
    }
    duct_drawing_free(output);
    duct_drawing_free(input);
    duct_settings_free(settings);
    return status == DUCT_OK ? 0 : 1;
}
