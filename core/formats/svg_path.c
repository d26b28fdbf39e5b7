/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "formats/svg_path.h"

#include "base/error.h"
#include "base/number.h"
#include "formats/svg_scan.h"
#include "geometry/bezier.h"

#include <math.h>
#include <string.h>

typedef struct {
    const char *s;
    duct_path *path;
    double x, y;             /* the current point */
    double start_x, start_y; /* where the subpath began */
    double control_x, control_y;
    char previous; /* the last command in upper case: tells whether the control point counts */
    bool open;     /* the subpath's move was added */
} reader;

static bool read_number(reader *r, double *number)
{
    const char *end;
    if (!duct_number_scan(r->s, &end, number) || !isfinite(*number)) {
        return false;
    }
    r->s = end;
    return true;
}

/* Numbers separated by optional commas; the first one stands right here. */
static bool read_numbers(reader *r, double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        if (i > 0) {
            duct_skip_comma(&r->s);
        }
        if (!read_number(r, &numbers[i])) {
            return false;
        }
    }
    return true;
}

static bool read_flag(reader *r, bool *flag)
{
    duct_skip_comma(&r->s);
    if (*r->s != '0' && *r->s != '1') {
        return false;
    }
    *flag = *r->s++ == '1';
    return true;
}

static bool read_arc(reader *r, double numbers[5], bool flags[2])
{
    if (!read_numbers(r, numbers, 3) || !read_flag(r, &flags[0]) || !read_flag(r, &flags[1])) {
        return false;
    }
    duct_skip_comma(&r->s);
    return read_numbers(r, numbers + 3, 2);
}

static void begin(reader *r)
{
    if (!r->open) {
        duct_path_move(r->path, r->x, r->y);
        r->start_x = r->x;
        r->start_y = r->y;
        r->open = true;
    }
}

/* How many numbers a command takes each time; -1: no such command. */
static int arguments_of(char command)
{
    static const char *const commands = "MLTHVCSQAZ";
    static const int counts[] = {2, 2, 2, 1, 1, 6, 4, 4, 5, 0};
    const char *found = command != '\0' ? strchr(commands, command) : NULL;
    return found != NULL ? counts[found - commands] : -1;
}

/* Makes relative coordinates absolute. */
static void make_absolute(const reader *r, char command, double *n, int count)
{
    if (command == 'H') {
        n[0] += r->x;
    } else if (command == 'V') {
        n[0] += r->y;
    } else {
        for (int i = command == 'A' ? 3 : 0; i + 1 < count; i += 2) {
            n[i] += r->x;
            n[i + 1] += r->y;
        }
    }
}

static void draw_curve(reader *r, char command, const double *n)
{
    bool cubic = command == 'C' || command == 'S';
    bool smooth = command == 'S' || command == 'T';
    bool follows =
        cubic ? r->previous == 'C' || r->previous == 'S' : r->previous == 'Q' || r->previous == 'T';
    double x1 = smooth ? (follows ? 2 * r->x - r->control_x : r->x) : n[0];
    double y1 = smooth ? (follows ? 2 * r->y - r->control_y : r->y) : n[1];
    const double *rest = smooth ? n : n + 2;
    if (cubic) {
        duct_path_cubic(r->path, x1, y1, rest[0], rest[1], rest[2], rest[3]);
        r->control_x = rest[0];
        r->control_y = rest[1];
        rest += 2;
    } else {
        duct_path_quadratic(r->path, r->x, r->y, x1, y1, rest[0], rest[1]);
        r->control_x = x1;
        r->control_y = y1;
    }
    r->x = rest[0];
    r->y = rest[1];
}

static void draw(reader *r, char command, const double *n, const bool flags[2])
{
    double x = r->x, y = r->y;
    begin(r);
    switch (command) {
    case 'L':
        x = n[0];
        y = n[1];
        duct_path_line(r->path, x, y);
        break;
    case 'H':
        x = n[0];
        duct_path_line(r->path, x, y);
        break;
    case 'V':
        y = n[0];
        duct_path_line(r->path, x, y);
        break;
    case 'A':
        x = n[3];
        y = n[4];
        duct_path_arc(r->path, r->x, r->y, n[0], n[1], n[2], flags[0], flags[1], x, y);
        break;
    default:
        draw_curve(r, command, n);
        return;
    }
    r->x = x;
    r->y = y;
}

static void close_subpath(reader *r)
{
    begin(r);
    duct_path_close(r->path);
    r->open = false;
    r->x = r->start_x;
    r->y = r->start_y;
}

/* One set of a command's arguments. */
static bool read_once(reader *r, char command, bool relative, int count)
{
    double n[6] = {0};
    bool flags[2] = {false, false};
    if (command == 'A' ? !read_arc(r, n, flags) : !read_numbers(r, n, count)) {
        return false;
    }
    if (relative) {
        make_absolute(r, command, n, count);
    }
    for (int i = 0; i < count; i++) {
        if (!isfinite(n[i])) {
            return false;
        }
    }
    if (command == 'M') {
        r->open = false;
        r->x = n[0];
        r->y = n[1];
    } else {
        draw(r, command, n, flags);
    }
    r->previous = command;
    return true;
}

static bool begins_number(char c)
{
    return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
}

static bool read_command(reader *r)
{
    char letter = *r->s;
    bool relative = letter >= 'a' && letter <= 'z';
    char command = relative ? (char)(letter - 'a' + 'A') : letter;
    int count = arguments_of(command);
    if (count < 0 || (r->previous == '\0' && command != 'M')) {
        return false;
    }
    r->s++;
    if (command == 'Z') {
        close_subpath(r);
        r->previous = 'Z';
        return true;
    }
    for (;;) {
        duct_skip_space(&r->s);
        if (!read_once(r, command, relative, count)) {
            return false;
        }
        bool comma = duct_skip_comma(&r->s);
        if (!comma && !begins_number(*r->s)) {
            return true;
        }
        /* Further pairs behind a move are lines. */
        command = command == 'M' ? 'L' : command;
    }
}

void duct_svg_path_data(const char *data, duct_path *path)
{
    reader r = {.s = data, .path = path};
    duct_skip_space(&r.s);
    while (*r.s != '\0' && !path->failed && read_command(&r)) {
        duct_skip_space(&r.s);
    }
}

void duct_svg_points(const char *data, bool closed, duct_path *path)
{
    reader r = {.s = data, .path = path};
    double n[2];
    size_t count = 0;
    duct_skip_space(&r.s);
    while (!path->failed && read_numbers(&r, n, 2)) {
        if (count == 0) {
            duct_path_move(path, n[0], n[1]);
        } else {
            duct_path_line(path, n[0], n[1]);
        }
        count++;
        duct_skip_comma(&r.s);
    }
    if (count > 0 && closed) {
        duct_path_close(path);
    }
}

duct_status duct_path_add_svg(duct_path *path, const char *d, duct_error *error)
{
    duct_svg_path_data(d, path);
    return path->failed ? duct_fail_memory(error) : DUCT_OK;
}
