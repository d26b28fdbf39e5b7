/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_color.h"

#include "base/number.h"

#include <math.h>
#include <string.h>

typedef struct {
    const char *name;
    unsigned rgb;
} named_color;

/* CSS Color Module Level 4, section 6.1. */
static const named_color names[] = {
    {"aliceblue", 0xf0f8ff},
    {"antiquewhite", 0xfaebd7},
    {"aqua", 0x00ffff},
    {"aquamarine", 0x7fffd4},
    {"azure", 0xf0ffff},
    {"beige", 0xf5f5dc},
    {"bisque", 0xffe4c4},
    {"black", 0x000000},
    {"blanchedalmond", 0xffebcd},
    {"blue", 0x0000ff},
    {"blueviolet", 0x8a2be2},
    {"brown", 0xa52a2a},
    {"burlywood", 0xdeb887},
    {"cadetblue", 0x5f9ea0},
    {"chartreuse", 0x7fff00},
    {"chocolate", 0xd2691e},
    {"coral", 0xff7f50},
    {"cornflowerblue", 0x6495ed},
    {"cornsilk", 0xfff8dc},
    {"crimson", 0xdc143c},
    {"cyan", 0x00ffff},
    {"darkblue", 0x00008b},
    {"darkcyan", 0x008b8b},
    {"darkgoldenrod", 0xb8860b},
    {"darkgray", 0xa9a9a9},
    {"darkgreen", 0x006400},
    {"darkgrey", 0xa9a9a9},
    {"darkkhaki", 0xbdb76b},
    {"darkmagenta", 0x8b008b},
    {"darkolivegreen", 0x556b2f},
    {"darkorange", 0xff8c00},
    {"darkorchid", 0x9932cc},
    {"darkred", 0x8b0000},
    {"darksalmon", 0xe9967a},
    {"darkseagreen", 0x8fbc8f},
    {"darkslateblue", 0x483d8b},
    {"darkslategray", 0x2f4f4f},
    {"darkslategrey", 0x2f4f4f},
    {"darkturquoise", 0x00ced1},
    {"darkviolet", 0x9400d3},
    {"deeppink", 0xff1493},
    {"deepskyblue", 0x00bfff},
    {"dimgray", 0x696969},
    {"dimgrey", 0x696969},
    {"dodgerblue", 0x1e90ff},
    {"firebrick", 0xb22222},
    {"floralwhite", 0xfffaf0},
    {"forestgreen", 0x228b22},
    {"fuchsia", 0xff00ff},
    {"gainsboro", 0xdcdcdc},
    {"ghostwhite", 0xf8f8ff},
    {"gold", 0xffd700},
    {"goldenrod", 0xdaa520},
    {"gray", 0x808080},
    {"green", 0x008000},
    {"greenyellow", 0xadff2f},
    {"grey", 0x808080},
    {"honeydew", 0xf0fff0},
    {"hotpink", 0xff69b4},
    {"indianred", 0xcd5c5c},
    {"indigo", 0x4b0082},
    {"ivory", 0xfffff0},
    {"khaki", 0xf0e68c},
    {"lavender", 0xe6e6fa},
    {"lavenderblush", 0xfff0f5},
    {"lawngreen", 0x7cfc00},
    {"lemonchiffon", 0xfffacd},
    {"lightblue", 0xadd8e6},
    {"lightcoral", 0xf08080},
    {"lightcyan", 0xe0ffff},
    {"lightgoldenrodyellow", 0xfafad2},
    {"lightgray", 0xd3d3d3},
    {"lightgreen", 0x90ee90},
    {"lightgrey", 0xd3d3d3},
    {"lightpink", 0xffb6c1},
    {"lightsalmon", 0xffa07a},
    {"lightseagreen", 0x20b2aa},
    {"lightskyblue", 0x87cefa},
    {"lightslategray", 0x778899},
    {"lightslategrey", 0x778899},
    {"lightsteelblue", 0xb0c4de},
    {"lightyellow", 0xffffe0},
    {"lime", 0x00ff00},
    {"limegreen", 0x32cd32},
    {"linen", 0xfaf0e6},
    {"magenta", 0xff00ff},
    {"maroon", 0x800000},
    {"mediumaquamarine", 0x66cdaa},
    {"mediumblue", 0x0000cd},
    {"mediumorchid", 0xba55d3},
    {"mediumpurple", 0x9370db},
    {"mediumseagreen", 0x3cb371},
    {"mediumslateblue", 0x7b68ee},
    {"mediumspringgreen", 0x00fa9a},
    {"mediumturquoise", 0x48d1cc},
    {"mediumvioletred", 0xc71585},
    {"midnightblue", 0x191970},
    {"mintcream", 0xf5fffa},
    {"mistyrose", 0xffe4e1},
    {"moccasin", 0xffe4b5},
    {"navajowhite", 0xffdead},
    {"navy", 0x000080},
    {"oldlace", 0xfdf5e6},
    {"olive", 0x808000},
    {"olivedrab", 0x6b8e23},
    {"orange", 0xffa500},
    {"orangered", 0xff4500},
    {"orchid", 0xda70d6},
    {"palegoldenrod", 0xeee8aa},
    {"palegreen", 0x98fb98},
    {"paleturquoise", 0xafeeee},
    {"palevioletred", 0xdb7093},
    {"papayawhip", 0xffefd5},
    {"peachpuff", 0xffdab9},
    {"peru", 0xcd853f},
    {"pink", 0xffc0cb},
    {"plum", 0xdda0dd},
    {"powderblue", 0xb0e0e6},
    {"purple", 0x800080},
    {"rebeccapurple", 0x663399},
    {"red", 0xff0000},
    {"rosybrown", 0xbc8f8f},
    {"royalblue", 0x4169e1},
    {"saddlebrown", 0x8b4513},
    {"salmon", 0xfa8072},
    {"sandybrown", 0xf4a460},
    {"seagreen", 0x2e8b57},
    {"seashell", 0xfff5ee},
    {"sienna", 0xa0522d},
    {"silver", 0xc0c0c0},
    {"skyblue", 0x87ceeb},
    {"slateblue", 0x6a5acd},
    {"slategray", 0x708090},
    {"slategrey", 0x708090},
    {"snow", 0xfffafa},
    {"springgreen", 0x00ff7f},
    {"steelblue", 0x4682b4},
    {"tan", 0xd2b48c},
    {"teal", 0x008080},
    {"thistle", 0xd8bfd8},
    {"tomato", 0xff6347},
    {"turquoise", 0x40e0d0},
    {"violet", 0xee82ee},
    {"wheat", 0xf5deb3},
    {"white", 0xffffff},
    {"whitesmoke", 0xf5f5f5},
    {"yellow", 0xffff00},
    {"yellowgreen", 0x9acd32},
};

static duct_svg_color color_of_bytes(unsigned red, unsigned green, unsigned blue, unsigned alpha)
{
    return (duct_svg_color){red / 255.0, green / 255.0, blue / 255.0, alpha / 255.0};
}

static int hex_digit(char c)
{
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
}

static bool parse_hex(duct_slice digits, duct_svg_color *color)
{
    unsigned value[8];
    if (digits.size != 3 && digits.size != 4 && digits.size != 6 && digits.size != 8) {
        return false;
    }
    for (size_t i = 0; i < digits.size; i++) {
        int digit = hex_digit(digits.text[i]);
        if (digit < 0) {
            return false;
        }
        value[i] = (unsigned)digit;
    }
    unsigned bytes[4] = {0, 0, 0, 255};
    size_t each = digits.size > 4 ? 2 : 1;
    for (size_t i = 0; i < digits.size / each; i++) {
        bytes[i] = each == 2 ? value[2 * i] * 16 + value[2 * i + 1] : value[i] * 17;
    }
    *color = color_of_bytes(bytes[0], bytes[1], bytes[2], bytes[3]);
    return true;
}

static double clamp(double value)
{
    return fmin(fmax(value, 0), 1);
}

/* A hue in degrees, saturation and lightness 0..1 (CSS Color 4, section 7). */
static duct_svg_color color_of_hsl(double hue, double saturation, double lightness)
{
    double rgb[3];
    static const double offsets[3] = {0, 8, 4};
    hue = fmod(hue, 360);
    hue = hue < 0 ? hue + 360 : hue;
    double a = saturation * fmin(lightness, 1 - lightness);
    for (int i = 0; i < 3; i++) {
        double k = fmod(offsets[i] + hue / 30, 12);
        rgb[i] = lightness - a * fmax(-1, fmin(fmin(k - 3, 9 - k), 1));
    }
    return (duct_svg_color){clamp(rgb[0]), clamp(rgb[1]), clamp(rgb[2]), 1};
}

/* The arguments of rgb() or hsl(): numbers, and whether each is a percentage. */
static int parse_arguments(duct_slice rest, double numbers[4], bool percent[4])
{
    int count = 0;
    while (count < 4 && duct_slice_number(&rest, &numbers[count])) {
        percent[count] = rest.size > 0 && rest.text[0] == '%';
        if (percent[count]) {
            rest.text++;
            rest.size--;
        } else if (duct_slice_begins(rest, "deg")) {
            rest.text += 3;
            rest.size -= 3;
        }
        rest = duct_slice_trim(rest);
        if (rest.size > 0 && (rest.text[0] == ',' || rest.text[0] == '/')) {
            rest.text++;
            rest.size--;
        }
        count++;
    }
    return duct_slice_trim(rest).size > 0 ? -1 : count;
}

static bool parse_function(duct_slice value, duct_svg_color *color)
{
    const char *open = memchr(value.text, '(', value.size);
    if (open == NULL || value.text[value.size - 1] != ')') {
        return false;
    }
    duct_slice name = duct_slice_trim((duct_slice){value.text, (size_t)(open - value.text)});
    duct_slice inside = {open + 1, value.size - (size_t)(open - value.text) - 2};
    double n[4] = {0};
    bool percent[4] = {false};
    int count = parse_arguments(inside, n, percent);
    if (count < 3) {
        return false;
    }
    duct_svg_color made;
    if (duct_slice_is(name, "rgb") || duct_slice_is(name, "rgba")) {
        for (int i = 0; i < 3; i++) {
            n[i] = clamp(n[i] / (percent[i] ? 100 : 255));
        }
        made = (duct_svg_color){n[0], n[1], n[2], 1};
    } else if (duct_slice_is(name, "hsl") || duct_slice_is(name, "hsla")) {
        made = color_of_hsl(n[0], clamp(n[1] / 100), clamp(n[2] / 100));
    } else {
        return false;
    }
    if (count == 4) {
        made.alpha = clamp(percent[3] ? n[3] / 100 : n[3]);
    }
    *color = made;
    return true;
}

bool duct_svg_color_parse(duct_slice value, duct_svg_color current, duct_svg_color *color)
{
    if (value.text == NULL) {
        return false;
    }
    value = duct_slice_trim(value);
    if (value.size == 0) {
        return false;
    }
    if (value.text[0] == '#') {
        return parse_hex((duct_slice){value.text + 1, value.size - 1}, color);
    }
    if (duct_slice_is(value, "currentcolor")) {
        *color = current;
        return true;
    }
    if (duct_slice_is(value, "transparent")) {
        *color = (duct_svg_color){0, 0, 0, 0};
        return true;
    }
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        if (duct_slice_is(value, names[i].name)) {
            unsigned rgb = names[i].rgb;
            *color = color_of_bytes(rgb >> 16, rgb >> 8 & 255, rgb & 255, 255);
            return true;
        }
    }
    return parse_function(value, color);
}
