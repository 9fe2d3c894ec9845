/* SPDX-License-Identifier: MIT
 *
 * Error lines. Whatever the parts say (file names and library messages may hold anything), the
 * result is one line that can be shown (printable.h). */
#include "base/error.h"

#include "base/printable.h"

#include <stdarg.h>
#include <stdio.h>

bool error_set(struct error *err, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(err->text, sizeof err->text, format, arguments);
    va_end(arguments);
    printable(err->text);
    return false;
}

bool error_prefix(struct error *err, const char *thing)
{
    struct error reason = *err;
    return error_set(err, "%.255s: %s", thing, reason.text);
}

bool error_no_option(struct error *err, const char *given)
{
    return error_set(err, "%s: no such option here; --help all lists those that there are", given);
}
