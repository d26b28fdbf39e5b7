/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reading .myb files. libmypaint's own reader prints to stderr and aborts on malformed curves, so the file is
 * read and checked here, into constants that each stroke's engine is set up from. */
#include "brush/brush_private.h"

#include "base/error.h"
#include "base/number.h"

#include <json.h>
#include <math.h>
#include <string.h>

/* Larger numbers have no meaning in any setting, and would make floats overflow inside libmypaint. */
static const double largest = 1e4;

static bool read_number(json_object *object, double *number)
{
    if (!json_object_is_type(object, json_type_double) && !json_object_is_type(object, json_type_int)) {
        return false;
    }
    *number = json_object_get_double(object);
    return fabs(*number) <= largest;
}

static void drop_curves(duct_brush *brush, MyPaintBrushSetting setting)
{
    size_t kept = 0;
    for (size_t i = 0; i < brush->curve_count; i++) {
        if (brush->curves[i].setting != setting) {
            brush->curves[kept++] = brush->curves[i];
        }
    }
    brush->curve_count = kept;
}

static duct_curve *add_curve(duct_brush *brush)
{
    void *memory = brush->curves;
    if (!duct_reserve(brush->allocator, &memory, &brush->curve_capacity, brush->curve_count + 1,
                      sizeof *brush->curves)) {
        return NULL;
    }
    brush->curves = memory;
    duct_curve *curve = &brush->curves[brush->curve_count++];
    memset(curve, 0, sizeof *curve);
    return curve;
}

/* What a setting is where the file does not mention it: libmypaint's defaults, and mixing of light rather
 * than of pigments, as all brushes had that know nothing of the choice. */
static duct_status set_defaults(duct_brush *brush, duct_error *error)
{
    for (int s = 0; s < MYPAINT_BRUSH_SETTINGS_COUNT; s++) {
        brush->base[s] = mypaint_brush_setting_info((MyPaintBrushSetting)s)->def;
    }
    brush->base[MYPAINT_BRUSH_SETTING_PAINT_MODE] = 0;
    duct_curve *curve = add_curve(brush);
    if (curve == NULL) {
        return duct_fail_memory(error);
    }
    curve->setting = MYPAINT_BRUSH_SETTING_OPAQUE_MULTIPLY;
    curve->input = MYPAINT_BRUSH_INPUT_PRESSURE;
    curve->count = 2;
    curve->x[1] = curve->y[1] = 1;
    return DUCT_OK;
}

static duct_status read_curve(duct_brush *brush, MyPaintBrushSetting setting, const char *setting_name,
                              const char *input_name, json_object *points, duct_error *error)
{
    MyPaintBrushInput input = mypaint_brush_input_from_cname(input_name);
    if ((int)input < 0 || input >= MYPAINT_BRUSH_INPUTS_COUNT) {
        return DUCT_OK; /* an input that a newer libmypaint has */
    }
    if (!json_object_is_type(points, json_type_array)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "setting %s: input %s is not a list of points", setting_name,
                         input_name);
    }
    size_t count = json_object_array_length(points);
    if (count == 0) {
        return DUCT_OK;
    }
    if (count < 2 || count > DUCT_CURVE_POINTS) {
        return duct_fail(error, DUCT_BAD_FORMAT, "setting %s: input %s has %zu points; 2 to %d are possible",
                         setting_name, input_name, count, DUCT_CURVE_POINTS);
    }
    duct_curve *curve = add_curve(brush);
    if (curve == NULL) {
        return duct_fail_memory(error);
    }
    curve->setting = setting;
    curve->input = input;
    curve->count = (int)count;
    for (size_t i = 0; i < count; i++) {
        json_object *point = json_object_array_get_idx(points, i);
        double x = 0, y = 0;
        if (!json_object_is_type(point, json_type_array) || json_object_array_length(point) < 2 ||
            !read_number(json_object_array_get_idx(point, 0), &x) ||
            !read_number(json_object_array_get_idx(point, 1), &y) || (i > 0 && (float)x < curve->x[i - 1])) {
            return duct_fail(
                error, DUCT_BAD_FORMAT,
                "setting %s: input %s: point %zu is not a pair of numbers to the right of the one before",
                setting_name, input_name, i + 1);
        }
        curve->x[i] = (float)x;
        curve->y[i] = (float)y;
    }
    return DUCT_OK;
}

/* Settings that decide how much work a stroke is stay within limits; most within those of MyPaint's dialogs.
 */
static float limited(MyPaintBrushSetting setting, double value)
{
    switch (setting) {
    case MYPAINT_BRUSH_SETTING_DABS_PER_BASIC_RADIUS:
    case MYPAINT_BRUSH_SETTING_DABS_PER_ACTUAL_RADIUS:
        return (float)fmin(fmax(value, 0), 40); /* nibs that turn need many */
    case MYPAINT_BRUSH_SETTING_DABS_PER_SECOND:
    case MYPAINT_BRUSH_SETTING_RADIUS_LOGARITHMIC:
    case MYPAINT_BRUSH_SETTING_RADIUS_BY_RANDOM: /* more makes dabs that no canvas holds */
    case MYPAINT_BRUSH_SETTING_SPEED1_GAMMA:
    case MYPAINT_BRUSH_SETTING_SPEED2_GAMMA: {
        const MyPaintBrushSettingInfo *info = mypaint_brush_setting_info(setting);
        return (float)fmin(fmax(value, (double)info->min), (double)info->max);
    }
    default:
        return (float)value;
    }
}

static duct_status read_setting(duct_brush *brush, const char *name, json_object *object, duct_error *error)
{
    MyPaintBrushSetting setting = mypaint_brush_setting_from_cname(name);
    if ((int)setting < 0 || setting >= MYPAINT_BRUSH_SETTINGS_COUNT) {
        return DUCT_OK; /* a setting of another version */
    }
    json_object *value = NULL, *inputs = NULL;
    double base = 0;
    if (!json_object_is_type(object, json_type_object) ||
        !json_object_object_get_ex(object, "base_value", &value) || !read_number(value, &base)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "setting %s: has no base_value that is a number", name);
    }
    brush->base[setting] = limited(setting, base);
    drop_curves(brush, setting);
    if (!json_object_object_get_ex(object, "inputs", &inputs) || inputs == NULL) {
        return DUCT_OK;
    }
    if (!json_object_is_type(inputs, json_type_object)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "setting %s: its inputs are not an object", name);
    }
    json_object_object_foreach(inputs, input, points)
    {
        duct_status status = read_curve(brush, setting, name, input, points, error);
        if (status != DUCT_OK) {
            return status;
        }
    }
    return DUCT_OK;
}

static duct_status read_section(duct_brush *brush, json_object *section, duct_error *error)
{
    duct_tuft *tuft = &brush->tuft;
    *tuft = (duct_tuft){0, 1, 0, 0.6, 0.6, 0.7, 1, 0.5, 40, 0.1};
    brush->grain = (duct_grain){0, 2, 1};
    double bristles = 0, wash = 0, tip = 0;
    const struct {
        const char *name;
        double *value, least, most;
    } numbers[] = {
        {"bristles", &bristles, 0, DUCT_MAX_BRISTLES},
        {"wash", &wash, 0, 1},
        {"ratio", &tuft->ratio, 1, 20},
        {"angle", &tuft->angle, -360, 360},
        {"spread", &tuft->spread, 0, 1},
        {"tilt", &tuft->tilt, 0, 1},
        {"stiffness", &tuft->stiffness, 0, 1},
        {"thickness", &tuft->thickness, 0.1, 4},
        {"dryness", &tuft->dryness, 0, 1},
        {"ink", &tuft->ink, 0, largest},
        {"colour", &tuft->colour, 0, 1},
        {"tip", &tip, 0, 1},
        {"side", &brush->side, 0, 12},
        {"grain", &brush->grain.depth, 0, 8},
        {"grain_size", &brush->grain.size, 0.1, 1000},
        {"cover", &brush->grain.cover, 0, 1},
    };
    if (!json_object_is_type(section, json_type_object)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "the \"ductus\" section is not an object");
    }
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        json_object *object = NULL;
        if (!json_object_object_get_ex(section, numbers[i].name, &object)) {
            continue;
        }
        double value = 0;
        if (!read_number(object, &value) || value < numbers[i].least || value > numbers[i].most) {
            char least[DUCT_NUMBER_SIZE], most[DUCT_NUMBER_SIZE];
            duct_number_print(least, numbers[i].least, 0);
            duct_number_print(most, numbers[i].most, 0);
            return duct_fail(error, DUCT_BAD_FORMAT, "ductus: %s has to be a number from %s to %s",
                             numbers[i].name, least, most);
        }
        *numbers[i].value = value;
    }
    tuft->bristles = (int)bristles;
    brush->tip = tip > 0;
    brush->wash = wash > 0 || brush->tip;
    return DUCT_OK;
}

static duct_status read_root(duct_brush *brush, json_object *root, duct_error *error)
{
    json_object *version = NULL, *settings = NULL, *section = NULL;
    if (!json_object_is_type(root, json_type_object) ||
        !json_object_object_get_ex(root, "version", &version) ||
        !json_object_is_type(version, json_type_int)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "is not a MyPaint brush: it has no version");
    }
    if (json_object_get_int(version) != 3) {
        return duct_fail(error, DUCT_BAD_FORMAT,
                         "is a MyPaint brush of version %d; only version 3 can be read",
                         json_object_get_int(version));
    }
    if (!json_object_object_get_ex(root, "settings", &settings) ||
        !json_object_is_type(settings, json_type_object)) {
        return duct_fail(error, DUCT_BAD_FORMAT, "is a MyPaint brush without settings");
    }
    json_object_object_foreach(settings, name, setting)
    {
        duct_status status = read_setting(brush, name, setting, error);
        if (status != DUCT_OK) {
            return status;
        }
    }
    return json_object_object_get_ex(root, "ductus", &section) ? read_section(brush, section, error)
                                                               : DUCT_OK;
}

duct_status duct_brush_parse(duct_brush *brush, const char *data, duct_error *error)
{
    duct_status status = set_defaults(brush, error);
    if (status != DUCT_OK) {
        return status;
    }
    enum json_tokener_error reason = json_tokener_success;
    json_object *root = json_tokener_parse_verbose(data, &reason);
    if (root == NULL) {
        return duct_fail(error, DUCT_BAD_FORMAT, "is not a MyPaint brush: it is not JSON (%s)",
                         json_tokener_error_desc(reason));
    }
    status = read_root(brush, root, error);
    json_object_put(root);
    return status;
}
