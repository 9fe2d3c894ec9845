/* SPDX-License-Identifier: MIT */
#include "progress.h"

#include <stdarg.h>
#include <stdio.h>
#include <unistd.h>

#define CLEAR_LINE "\r\x1B[K"

void progress(const char *format, ...)
{
    va_list arguments;
    if (!isatty(STDERR_FILENO)) return;
    fputs(CLEAR_LINE, stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
}

void progress_end(void)
{
    if (isatty(STDERR_FILENO)) fputs(CLEAR_LINE, stderr);
}
