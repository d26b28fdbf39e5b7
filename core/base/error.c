/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"

#include "base/text.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

const char *duct_status_text(duct_status status)
{
    switch (status) {
    case DUCT_OK:
        return "done";
    case DUCT_BAD_ARGUMENT:
        return "bad argument";
    case DUCT_BAD_SETTING:
        return "bad setting";
    case DUCT_NOT_FOUND:
        return "not found";
    case DUCT_IO:
        return "cannot read or write";
    case DUCT_BAD_FORMAT:
        return "bad file content";
    case DUCT_UNSUPPORTED:
        return "not possible";
    case DUCT_LIMIT:
        return "too large";
    case DUCT_NO_MEMORY:
        return "out of memory";
    case DUCT_CANCELLED:
        return "cancelled";
    }
    return "unknown status";
}

/* Makes a message a single printable line of UTF-8, whatever was quoted in it and wherever it was cut. */
static void tidy(char *message)
{
    char continuation[65] = "";
    for (int i = 0; i < 64; i++) {
        continuation[i] = (char)(0x80 + i);
    }
    char *to = message;
    for (const char *from = message; *from != '\0';) {
        size_t size = duct_utf8_character(from);
        bool control = (unsigned char)*from < 0x20 || *from == 0x7f;
        if (size == 0 && (unsigned char)*from >= 0xc2 && from[1 + strspn(from + 1, continuation)] == '\0') {
            break; /* the message was cut within this character */
        }
        if (size == 0 || control) {
            *to++ = '?';
            from++;
        } else {
            memmove(to, from, size);
            to += size;
            from += size;
        }
    }
    *to = '\0';
}

duct_status duct_fail(duct_error *error, duct_status status, const char *format, ...)
{
    if (error != NULL) {
        va_list arguments;
        va_start(arguments, format);
        error->status = status;
        vsnprintf(error->message, sizeof error->message, format, arguments);
        va_end(arguments);
        tidy(error->message);
    }
    return status;
}

duct_status duct_fail_memory(duct_error *error)
{
    return duct_fail(error, DUCT_NO_MEMORY,
                     "there is not enough memory; close other programs or work on a smaller drawing");
}

void duct_error_prefix(duct_error *error, const char *prefix)
{
    if (error == NULL) {
        return;
    }
    char message[DUCT_ERROR_SIZE];
    memcpy(message, error->message, sizeof message);
    int length = snprintf(error->message, sizeof error->message, "%s: ", prefix);
    if (length >= 0 && (size_t)length < sizeof error->message) {
        snprintf(error->message + length, sizeof error->message - (size_t)length, "%s", message);
    }
    tidy(error->message);
}
