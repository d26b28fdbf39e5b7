/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"

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

/* Cuts a UTF-8 text that was truncated in the middle of a character, and makes it a single printable line. */
static void tidy(char *message)
{
    size_t length = strlen(message);
    for (size_t i = 0; i < length; i++) {
        if ((unsigned char)message[i] < 0x20 || message[i] == 0x7f) {
            message[i] = '?';
        }
    }
    if (length + 1 < DUCT_ERROR_SIZE) {
        return;
    }
    size_t start = length;
    while (start > 0 && ((unsigned char)message[start - 1] & 0xc0) == 0x80) {
        start--;
    }
    if (start > 0 && (unsigned char)message[start - 1] >= 0xc0) {
        message[start - 1] = '\0';
    }
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
