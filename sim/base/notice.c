/* SPDX-License-Identifier: MIT */
#include "base/notice.h"

#include "base/error.h"

#include <stdarg.h>
#include <stdio.h>

void notice(const char *format, ...)
{
    char text[ERROR_B];
    struct error line;
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    (void)error_set(&line, "%s", text); /* makes one line of it */
    fprintf(stderr, "limner: note: %s\n", line.text);
}
