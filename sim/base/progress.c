/* SPDX-License-Identifier: MIT */
#include "base/progress.h"

#include <stdarg.h>
#include <stdbool.h>
#include <stdio.h>
#include <unistd.h>

enum { PERCENT = 100 };

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

/* Whether the bar looks different after this step than after the last one. */
static bool bar_moves(size_t done, size_t all)
{
    return done == 0 || done * PERCENT / all != (done - 1) * PERCENT / all;
}

void progress_bar(size_t done, size_t all, const char *format, ...)
{
    static const char full[] = "====================", empty[] = "                    ";
    enum { WIDTH = sizeof full - 1 };
    va_list arguments;
    if (!all || done > all || !bar_moves(done, all) || !isatty(STDERR_FILENO)) return;
    const int marks = (int)(done * WIDTH / all);
    fprintf(stderr, CLEAR_LINE "[%.*s%.*s] %3zu %% ", marks, full, WIDTH - marks, empty, done * PERCENT / all);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
}

void progress_end(void)
{
    if (isatty(STDERR_FILENO)) fputs(CLEAR_LINE, stderr);
}
